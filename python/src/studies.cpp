// The published studies and tables.
#include <clearcut/studies.h>

#include "interruptible.h"

namespace clearcut::python {
namespace {

struct Study {
  studies::GeneticStudy study;
  studies::GeneticStudyOptions options;
  std::vector<studies::StudyRow> rows;
};

Study study(const std::string& name, std::optional<int> runs, std::optional<long long> generations,
            std::optional<int> side, const std::string& objective, int islands, long long migrate_every,
            int migrants, std::uint64_t seed, int threads, const std::string& csv,
            const py::object& progress) {
  Study out;
  out.options.runs = runs;
  out.options.generations = generations;
  out.options.side = side;
  out.options.objective = objective;
  out.options.islands = {islands, migrate_every, migrants};
  out.options.seed = seed;
  out.options.threads = threads;
  out.study = studies::genetic_study(name, out.options);
  out.rows = interruptible(py::none(), [study = out.study, given = out.options, csv,
                                        call = shared(progress)](std::stop_token cancel) {
    studies::GeneticStudyOptions options = given;
    options.cancel = std::move(cancel);
    options.progress = [&call](int done, int total, const auto&) {
      const py::gil_scoped_acquire lock;
      if (!call->is_none()) (*call)(done, total);
    };
    return studies::run_genetic_study(study, options, csv);
  });
  return out;
}

template <class Value>
py::array_t<Value> column(const Study& self, Value studies::StudyRow::*of) {
  py::array_t<Value> array(static_cast<py::ssize_t>(self.rows.size()));
  Value* to = array.mutable_data();
  for (const auto& row : self.rows) *to++ = row.*of;
  return array;
}

/// The rows as columns by their names.
py::dict columns(const Study& self) {
  py::dict out;
  std::vector<std::string> names;
  for (const auto& row : self.rows)
    names.push_back(self.study.levels[static_cast<std::size_t>(row.level)].name);
  out["level"] = names;
  out["run"] = column(self, &studies::StudyRow::run);
  out["generation"] = column(self, &studies::StudyRow::generation);
  out["best"] = column(self, &studies::StudyRow::best);
  out["mean"] = column(self, &studies::StudyRow::mean);
  out["worst"] = column(self, &studies::StudyRow::worst);
  out["fitness"] = column(self, &studies::StudyRow::fitness);
  return out;
}

/// With how many cells agree as its last note.
TextTable reproduce(const std::string& name) {
  studies::Reproduction made = studies::reproducible_table(name).make();
  made.table.notes.push_back(made.summary());
  return made.table;
}

std::vector<std::string> reproducible_tables() {
  std::vector<std::string> names;
  for (const auto& table : studies::reproducible_tables()) names.push_back(table.name);
  return names;
}

}  // namespace

void add_studies(py::module_& module) {
  py::class_<Study>(module, "Study", "Runs of a Monte-Carlo study of the published genetic algorithm.")
      .def("columns", &columns, "The rows as columns: level, run, generation, best, mean, worst, fitness.")
      .def(
          "table", [](const Study& self) { return studies::study_table(self.study, self.rows); },
          doc("study_table"))
      .def(
          "csv", [](const Study& self) { return studies::study_csv(self.study, self.options, self.rows); },
          "The rows as the command writes them; study(csv=...) goes on from there.")
      .def(
          "picture", [](const Study& self) { return studies::study_svg(self.study, self.rows); },
          doc("study_svg"));
  module.def("study", &study, py::arg("name"), py::kw_only(), py::arg("runs") = py::none(),
             py::arg("generations") = py::none(), py::arg("side") = py::none(),
             py::arg("objective") = "length", py::arg("islands") = 1, py::arg("migrate_every") = 100,
             py::arg("migrants") = 1, py::arg("seed") = 1, py::arg("threads") = 0, py::arg("csv") = "",
             py::arg("progress") = py::none(), doc("run_genetic_study"));
  module.def("study_names", &studies::genetic_study_names, "The studies there are.");
  module.def("reproduce", &reproduce, py::arg("table"), py::call_guard<py::gil_scoped_release>(),
             "A published table beside our figures.");
  module.def("reproducible_tables", &reproducible_tables, "The tables that reproduce() takes.");
}

}  // namespace clearcut::python
