// What the texts print, where a user chooses it instead of ours, as keywords.
#include "option_attributes.h"

namespace clearcut::python {
namespace {

void add_choice(OptionsClass& options, const char* name, const char* text, const char* published,
                const char* ours, std::optional<bool> PublishedChoices::*choice,
                bool (*is_published)(const std::string&, const std::string&)) {
  add_optional(
      options, name, text, [choice](auto& o) -> auto& { return o.published.*choice; },
      [is_published](const py::handle& value, const std::string& option) {
        return is_published(value.cast<std::string>(), "--" + option);
      },
      [published, ours](bool is) { return is ? published : ours; });
}

template <class Value>
void add_setting(OptionsClass& options, const char* name, const char* text,
                 std::optional<Value> PublishedSolver::*setting) {
  options.def_property(
      name,
      [setting](const AskedOptions& o) {
        return o.published.solver ? o.published.solver->published.*setting : std::optional<Value>();
      },
      [setting](AskedOptions& o, std::optional<Value> value) {
        if (!o.published.solver && value) o.published.solver.emplace();
        if (o.published.solver) o.published.solver->published.*setting = std::move(value);
      },
      text);
}

/// None, "modern" or "published"; its settings stay what they are.
void set_solver(AskedOptions& o, const std::optional<std::string>& name) {
  if (!name) return o.published.solver.reset();
  const bool is_published = is_published_solver(*name, "--solver");
  if (!o.published.solver) o.published.solver.emplace();
  o.published.solver->is_published = is_published;
}

}  // namespace

void add_published_options(OptionsClass& options) {
  add_choice(options, "passage", "From contour to contour: bisector (of a corner) or shortest.", "bisector",
             "shortest", &PublishedChoices::bisector_passages, is_bisector_passage);
  add_choice(options, "reflex", "Contours at reflex corners: corner or round.", "corner", "round",
             &PublishedChoices::sharp_reflex, is_reflex_corner);
  add_choice(options, "grid",
             "Of the strategy tour: ours, or published (Tour eq. 4.8; some material may stay uncut).",
             "published", "ours", &PublishedChoices::published_grid, is_published_grid);
  options.def_property(
      "solver",
      [](const AskedOptions& o) -> std::optional<std::string> {
        if (!o.published.solver) return std::nullopt;
        return o.published.solver->is_published ? "published" : "modern";
      },
      &set_solver, "Orders visits: modern, or published (the genetic algorithm of the Tour text).");
  add_setting(options, "generations", doc("PublishedSolver::generations"), &PublishedSolver::generations);
  add_setting(options, "population", "Individuals of the published solver.", &PublishedSolver::population);
  add_setting(options, "selection",
              "Of the published solver: random, rank, roulette, tournament or truncation.",
              &PublishedSolver::selection);
  add_setting(options, "crossover",
              "Of the published solver: pmx, ox, erx, cx, eax, or one of those that docs/tour.md lists.",
              &PublishedSolver::crossover);
  add_setting(options, "mutation", "Of the published solver: exchange, inversion or nearest.",
              &PublishedSolver::mutation);
  add_setting(options, "crossover_rate", "Of the published solver: chance of two parents.",
              &PublishedSolver::crossover_rate);
  add_setting(options, "mutation_rate", "Of the published solver: chance of a mutation.",
              &PublishedSolver::mutation_rate);
  add_setting(options, "most_shared", doc("PublishedSolver::most_shared"), &PublishedSolver::most_shared);
}

}  // namespace clearcut::python
