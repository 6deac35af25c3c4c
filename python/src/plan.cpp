// Plans, checks of any program, tables.
#include "interruptible.h"
#include "moves.h"

namespace clearcut::python {
namespace {

/// A plan or a check with what it rests on.
template <class Result>
struct Checked {
  std::shared_ptr<const Result> result;
  PlanOptions options;
  std::shared_ptr<const StrategyTable> table;  ///< of own strategies, which `options` points to
  std::vector<CertificateFile> inputs;
  std::string program;  ///< text
  std::string name;     ///< of the program
  bool dialect_stated = true;

  Moves moves() const { return Moves(result, options); }
};

struct Plan : Checked<PlanResult> {};
struct Check : Checked<CheckResult> {};

/// The table of all strategies, with what it was written from.
struct Comparison : TextTable {
  std::vector<StrategyRun> runs;
};

/// A list of one figure of every run; None where the strategy cannot plan the part.
template <class Get>
py::list column_of(const Comparison& comparison, Get get) {
  py::list column;
  for (const StrategyRun& run : comparison.runs)
    column.append(run.figures ? py::cast(get(*run.figures)) : py::none());
  return column;
}

/// By column, as pandas.DataFrame() takes it. mm, mm2, seconds, degrees.
py::dict numbers_of(const Comparison& comparison) {
  py::dict out;
  py::list strategies, refusals;
  for (const StrategyRun& run : comparison.runs) {
    strategies.append(run.strategy);
    refusals.append(run.refusal);
  }
  const auto add = [&](const char* name, auto get) { out[name] = column_of(comparison, get); };
  out["strategy"] = strategies;
  add("clean", [](const Figures& of) { return of.clean; });
  add("time_s", [](const Figures& of) { return of.time_s; });
  add("time_naive_s", [](const Figures& of) { return of.time_naive_s; });
  add("feed_mm", [](const Figures& of) { return of.feed_mm; });
  add("rapid_mm", [](const Figures& of) { return of.rapid_mm; });
  add("plunge_mm", [](const Figures& of) { return of.plunge_mm; });
  add("turns", [](const Figures& of) { return of.turns; });
  add("retracts", [](const Figures& of) { return of.retracts; });
  add("uncut_mm2", [](const Figures& of) { return of.uncut_mm2; });
  add("gouge_mm", [](const Figures& of) { return of.gouge_mm; });
  add("max_engagement_deg", [](const Figures& of) { return of.engagement.max_deg; });
  add("mean_engagement_deg", [](const Figures& of) { return of.engagement.mean_deg; });
  out["refusal"] = refusals;
  return out;
}

/// Told to Python, in whose threads nobody may wait for the planner's while the lock is held.
ProgressCallback told(const py::object& progress) {
  if (progress.is_none()) return {};
  return [call = shared(progress)](const Progress& at) {
    const py::gil_scoped_acquire lock;
    (*call)(at.stage == Stage::kPlanning ? "planning" : "certifying", at.done, at.most);
  };
}

/// The further parts of a sheet, each read as a part is without options. Their files become inputs.
void read_nested(AskedOptions& options, std::vector<CertificateFile>& inputs) {
  if (!options.nested.empty()) return;
  options.nested = read_nested_parts(options, {}, {});
  for (const std::string& text : options.copies.with)
    inputs.push_back(certificate_file("part", nested_file(text)->file));
}

py::dict dict_of(const CopiesMade& made) {
  py::dict out;
  out["parts"] = made.parts;
  out["clean_parts"] = made.clean_parts;
  out["turned"] = made.turned;
  out["gap_mm"] = made.gap;
  out["wanted"] = made.wanted;
  out["at_most"] = made.at_most;
  if (made.kinds.empty()) return out;
  py::list kinds, places;
  for (const KindMade& kind : made.kinds) {
    py::dict one;
    one["name"] = kind.name;
    one["parts"] = kind.parts;
    one["clean_parts"] = kind.clean_parts;
    one["turned"] = kind.turned;
    one["wanted"] = kind.wanted;
    kinds.append(one);
  }
  for (const PlaceMade& place : made.places) {
    py::dict one;
    one["name"] = made.kinds[place.kind].name;
    one["at_mm"] = std::pair(place.taken.min.x, place.taken.min.y);
    one["size_mm"] = std::pair(place.taken.width(), place.taken.height());
    one["turned"] = place.turned;
    places.append(one);
  }
  out["kinds"] = kinds;
  out["places"] = places;
  return out;
}

Plan plan(const GivenPart& part, AskedOptions options, const std::vector<OwnStrategy>& strategies,
          const py::object& progress, const py::object& cancel) {
  Plan plan;
  plan.table = table_with(strategies);
  options.strategies = plan.table.get();
  check_options(options);
  plan.inputs = joined(part.inputs, options.files);
  read_nested(options, plan.inputs);
  plan.options = options;
  options.progress = told(progress);
  auto result = interruptible(cancel, [part = part.part, options, table = plan.table](std::stop_token stop) {
    PlanOptions own = options;
    own.cancel = std::move(stop);
    return plan_part(part, own);
  });
  plan.result = std::make_shared<const PlanResult>(std::move(result));
  plan.program = plan.result->program;
  return plan;
}

std::optional<Dialect> dialect_of(const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  const auto dialect = dialect_named(*name);
  if (!dialect) throw InputError("--dialect", "'" + *name + "' is unknown; use one of " + controllers_text());
  return dialect;
}

/// What a check rests on, without its result.
Check asked_check(const std::vector<CertificateFile>& inputs, const std::string& program,
                  const std::string& name, AskedOptions& options, const std::optional<std::string>& dialect) {
  Check check;
  options.strategies = nullptr;
  check_options(options);
  check.inputs = joined(inputs, options.files);
  read_nested(options, check.inputs);
  check.options = options;
  check.program = program;
  check.name = name;
  check.dialect_stated = dialect.has_value();
  return check;
}

Check verify_alone(const std::optional<std::string>& stock, std::optional<double> top,
                   const std::string& program, const std::string& name, AskedOptions options,
                   const std::optional<std::string>& dialect, const py::object& cancel) {
  Check check = asked_check({}, program, name, options, dialect);
  const auto control = dialect_of(dialect);
  const auto block = stock ? std::optional(parse_stock(*stock, top.value_or(0))) : std::nullopt;
  auto result = interruptible(cancel, [block, top, program, name, options, control](std::stop_token stop) {
    PlanOptions own = options;
    own.cancel = std::move(stop);
    return check_program_alone(block, program, name, own, control, top);
  });
  check.result = std::make_shared<const CheckResult>(std::move(result));
  return check;
}

Check verify(const GivenPart& part, const std::string& program, const std::string& name, AskedOptions options,
             const std::optional<std::string>& dialect, const py::object& cancel) {
  Check check = asked_check(part.inputs, program, name, options, dialect);
  const auto control = dialect_of(dialect);
  auto result =
      interruptible(cancel, [part = part.part, program, name, options, control](std::stop_token stop) {
        PlanOptions own = options;
        own.cancel = std::move(stop);
        return check_program(part, program, name, own, control);
      });
  check.result = std::make_shared<const CheckResult>(std::move(result));
  return check;
}

template <class Result>
CertificateBasis basis_of(const Checked<Result>& checked, const std::string& program_name) {
  CertificateBasis basis;
  basis.command = "python";
  basis.inputs = checked.inputs;
  basis.program_name = program_name;
  basis.dialect_stated = checked.dialect_stated;
  return basis;
}

std::string certificate_of(const Plan& plan, const std::string& name) {
  return write_certificate(*plan.result, plan.options, basis_of(plan, name));
}

std::string certificate_of(const Check& check, const std::string& name) {
  return write_certificate(*check.result, check.options, basis_of(check, name.empty() ? check.name : name),
                           check.program);
}

py::object as_dict(const std::string& json) {
  return py::module_::import("json").attr("loads")(json);
}

/// What plans and checks have in common.
template <class Class>
void add_checked(py::class_<Class>& checked) {
  checked
      .def_property_readonly(
          "part",
          [](const Class& self) {
            return GivenPart{self.result->part, self.inputs};
          },
          "As it was prepared: every default filled in, everything noticed in its diagnostics.")
      .def_property_readonly(
          "inputs",
          [](const Class& self) {
            std::vector<std::string> paths;
            for (const CertificateFile& input : self.inputs) paths.push_back(input.name);
            return paths;
          },
          "The files that it rests on; write() replaces none of them.")
      .def_readonly("program", &Class::program, "The text for the controller.")
      .def_property_readonly(
          "copies",
          [](const Class& self) -> py::object {
            if (!self.result->copies) return py::none();
            return dict_of(*self.result->copies);
          },
          "Copies of the part in one program: how many there are, how many are clean; None for one part.")
      .def_property_readonly(
          "findings", [](const Class& self) { return self.result->findings; },
          "Figures and faults of the program, with places.")
      .def_property_readonly(
          "verdict", [](const Class& self) { return verdict_words(self.result->findings); }, doc("Verdict"))
      .def_property_readonly(
          "clean",
          [](const Class& self) {
            return !self.result->findings.without_part &&
                   verdict_of(self.result->findings) == Verdict::kClean;
          },
          "Whether the verdict is CLEAN, which it is not without a part.")
      .def_property_readonly(
          "faults", [](const Class& self) { return self.result->findings.faults; }, doc("Findings::faults"))
      .def_property_readonly("diagnostics",
                             [](const Class& self) { return self.result->part.diagnostics.items(); })
      .def_property_readonly(
          "moves", [](const Class& self) { return self.moves(); },
          "The moves as they were read back from the program.")
      .def(
          "certificate_text",
          [](const Class& self, const std::string& name) { return certificate_of(self, name); },
          py::arg("program_name") = "", doc("write_certificate"))
      .def(
          "certificate",
          [](const Class& self, const std::string& name) { return as_dict(certificate_of(self, name)); },
          py::arg("program_name") = "", "The certificate as a dict; docs/report.md lists every field.")
      .def(
          "table", [](const Class& self) { return write_table(*self.result); }, doc("write_table"))
      .def(
          "picture", [](const Class& self) { return write_picture(*self.result); }, doc("write_picture"));
}

void add_selections(py::module_& module) {
  py::class_<CandidateResult>(module, "CandidateResult", "A strategy that was considered for a workingstep.")
      .def_readonly("strategy", &CandidateResult::strategy)
      .def_readonly("stepover", &CandidateResult::stepover, doc("CandidateResult::stepover"))
      .def_property_readonly("outcome", [](const CandidateResult& one) { return name_of(one.outcome); })
      .def_readonly("time_s", &CandidateResult::time_s, doc("CandidateResult::time_s"))
      .def_readonly("feed_mm", &CandidateResult::feed_mm, doc("CandidateResult::feed_mm"));
  py::class_<StrategySelection>(module, "StrategySelection", doc("StrategySelection"))
      .def_readonly("feature", &StrategySelection::feature)
      .def_readonly("candidates", &StrategySelection::candidates)
      .def_property_readonly("kept", &StrategySelection::kept, doc("StrategySelection::kept"));
}

void add_plan_class(py::module_& module) {
  py::class_<Plan> plans(module, "Plan", "A program that was read back and certified.");
  add_checked(plans);
  plans
      .def_property_readonly(
          "selections", [](const Plan& self) { return self.result->selections; },
          doc("PlanResult::selections"))
      .def(
          "values", [](const Plan& self) { return write_values(self.result->part, self.result->values); },
          doc("write_values"))
      .def(
          "selection_table", [](const Plan& self) { return write_selection_table(*self.result); },
          doc("write_selection_table"))
      .def(
          "page", [](const Plan& self) { return write_page(*self.result, self.options); }, doc("write_page"))
      .def(
          "segments", [](const Plan& self) { return write_segments(*self.result); }, doc("write_segments"))
      .def("__repr__", [](const Plan& self) {
        return "<clearcut.Plan of " + self.result->part.name + ", " +
               name_of(verdict_of(self.result->findings)) + ", " +
               trimmed(self.result->findings.all.time_s, 1) + " s>";
      });
  py::class_<Check> checks(module, "Check", "What a program of whatever origin does to a part.");
  add_checked(checks);
  checks
      .def_property_readonly(
          "dialect", [](const Check& self) { return std::string(name_of(self.result->dialect)); },
          "As which control's program it was read.")
      .def(
          "page", [](const Check& self) { return write_page(*self.result, self.options, self.program); },
          doc("write_page"))
      .def("__repr__", [](const Check& self) {
        return "<clearcut.Check of " + self.name + ", " + verdict_words(self.result->findings) + ">";
      });
}

void add_tables(py::module_& module) {
  py::class_<TextTable>(module, "Table", "A table of words and figures; str() aligns it.")
      .def_readonly("title", &TextTable::title)
      .def_readonly("rows", &TextTable::rows)
      .def_readonly("notes", &TextTable::notes)
      .def_property_readonly("columns",
                             [](const TextTable& table) {
                               std::vector<std::string> names;
                               for (const auto& column : table.columns) names.push_back(column.heading);
                               return names;
                             })
      .def("markdown", &markdown, doc("markdown"))
      .def("__str__", &plain);
  py::class_<Comparison, TextTable>(module, "Comparison", "Every strategy on one part, checked alike.")
      .def("numbers", &numbers_of,
           "The figures by column, for pandas.DataFrame(): lists in the order of the strategies, None where "
           "one cannot plan "
           "the part. mm, mm2, seconds, degrees.")
      .def_property_readonly(
          "fastest_clean",
          [](const Comparison& comparison) -> std::optional<std::string> {
            const auto* best = fastest_clean(comparison.runs);
            return best ? std::optional(best->strategy) : std::nullopt;
          },
          "Name of the fastest strategy that is certified clean; None where none is.");
  module.def(
      "_compare",
      [](const GivenPart& part, AskedOptions options, const std::vector<OwnStrategy>& strategies) {
        const auto table = table_with(strategies);
        options.strategies = table.get();
        check_options(options);
        return interruptible(py::none(), [part = part.part, options, table](std::stop_token stop) {
          PlanOptions own = options;
          own.cancel = std::move(stop);
          auto runs = run_strategies(part, own);
          Comparison comparison{strategy_table(part, own, runs), {}};
          comparison.runs = std::move(runs);
          return comparison;
        });
      },
      py::arg("part"), py::arg("options"), py::arg("strategies"), doc("compare_strategies"));
}

}  // namespace

void add_plan(py::module_& module) {
  add_selections(module);
  add_plan_class(module);
  add_tables(module);
  module.def("_plan", &plan, py::arg("part"), py::arg("options"), py::arg("strategies"), py::arg("progress"),
             py::arg("cancel"), doc("plan_part"));
  module.def("_verify", &verify, py::arg("part"), py::arg("program"), py::arg("name"), py::arg("options"),
             py::arg("dialect"), py::arg("cancel"), doc("check_program"));
  module.def("_verify_alone", &verify_alone, py::arg("stock"), py::arg("top"), py::arg("program"),
             py::arg("name"), py::arg("options"), py::arg("dialect"), py::arg("cancel"),
             doc("check_program_alone"));
  module.def(
      "_explain",
      [](const GivenPart& part, const AskedOptions& options) {
        const ResolvedPlan resolved = resolve_plan(part.part, options);
        return write_values(resolved.part, resolved.values);
      },
      py::arg("part"), py::arg("options"), doc("write_values"));
  module.def(
      "check_witness",
      [](const std::string& program, const std::string& part, const py::bytes& witness, double uncut,
         bool straight, bool partial) {
        const WitnessAnswer answer = check_witness(program, part, witness, uncut, straight, partial);
        if (!answer.accepted) throw InputError("witness", answer.text);
        return answer.text;
      },
      py::arg("program"), py::arg("part"), py::arg("witness"), py::arg("uncut") = 0.01,
      py::arg("straight") = false, py::arg("partial") = false, doc("check_witness"));
  module.def(
      "read_file", [](const std::string& path) { return py::bytes(read_file(path)); }, py::arg("path"),
      doc("read_file"));
  module.def(
      "write_files",
      [](const std::vector<std::pair<std::string, std::string>>& files,
         const std::vector<std::string>& inputs) {
        std::vector<OutputFile> outputs;
        for (const auto& [path, content] : files) outputs.push_back({path, content});
        write_files(outputs, inputs);
      },
      py::arg("files"), py::arg("inputs") = std::vector<std::string>{}, doc("write_files"));
}

}  // namespace clearcut::python
