// Objective by which the order of a grid or the choice among plans is judged, and the settings of the Tour text's genetic algorithm, if the
// user requests it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace clearcut::inline model {

enum class ObjectiveKind {
  kLength,
  kTurns,
  kAngle,
  kTime,
  kEngagement,
  kEngagementInverse,
  kEngagementExact,
  kForce,   ///< N, the greatest
  kEnergy,  ///< J at the cutter
  kWear,    ///< share of a cutter's life
  kClimb    ///< share of the cutting length that is not climb milling
};
/// "length", "turns", "angle", "time", "engagement", "engagement-inverse", "engagement-exact", "force", "energy",
/// "wear", "climb".
const char* name_of(ObjectiveKind kind);

/// Whether the quantity is measured on a certified program: the load of the cutter. No order of points has it.
bool is_load(ObjectiveKind kind);
/// Whether the quantity follows only from a known material of the work.
bool needs_material(ObjectiveKind kind);

struct ObjectiveTerm {
  ObjectiveKind kind = ObjectiveKind::kTime;
  double weight = 1;
};

/// A weighted sum of terms; a single term without weight is that quantity itself.
struct Objective {
  std::vector<ObjectiveTerm> terms{ObjectiveTerm{}};
  bool weighted = false;

  /// Whether plans are compared by figures of their certificates, instead of points ordered by a search.
  bool asks_load() const;
};

/// "turns", or weights: "1:length,20:turns" or "length=1,turns=20". Throws InputError at `place`, listing the names.
Objective parse_objective(const std::string& text, const std::string& place);

/// The Tour text's genetic algorithm; absent values are as published.
struct PublishedSolver {
  std::optional<long long> generations;  ///< at most; absent: until 1000 bring no gain (4.3.3)
  std::optional<int> population;
  std::optional<std::string> selection, crossover, mutation;  ///< names of operators
  std::optional<double> crossover_rate, mutation_rate;
  /// Greatest share of common edges of two individuals before they count as too similar.
  std::optional<double> most_shared;

  /// Values set in `other` take precedence.
  void merge(const PublishedSolver& other) {
    const auto take = [](auto& own, const auto& theirs) {
      if (theirs) own = theirs;
    };
    take(generations, other.generations);
    take(population, other.population);
    take(selection, other.selection);
    take(crossover, other.crossover);
    take(mutation, other.mutation);
    take(crossover_rate, other.crossover_rate);
    take(mutation_rate, other.mutation_rate);
    take(most_shared, other.most_shared);
  }

  bool is_set() const {
    return generations || population || selection || crossover || mutation || crossover_rate ||
           mutation_rate || most_shared;
  }
};

/// Solver that orders the visits of a grid.
struct VisitSolver {
  bool is_published = false;  ///< else Clearcut's own
  PublishedSolver published;
};

/// A user's choices between the published method and Clearcut's own. Absent: no choice.
struct PublishedChoices {
  std::optional<bool> bisector_passages;  ///< for contour methods (CPO-kappa eq. 3)
  std::optional<bool> sharp_reflex;       ///< for contour methods that cut only contours (CPO-kappa eq. 2)
  std::optional<bool> published_grid;     ///< for the strategy tour: Tour eq. 4.8, without additional passes
  std::optional<VisitSolver> solver;      ///< solver for the strategy tour and for elements

  /// Those of `other` go before these.
  void merge(const PublishedChoices& other) {
    if (other.bisector_passages) bisector_passages = other.bisector_passages;
    if (other.sharp_reflex) sharp_reflex = other.sharp_reflex;
    if (other.published_grid) published_grid = other.published_grid;
    if (other.solver) solver = other.solver;
  }
};

/// Choices by step_key().
using StepChoices = std::map<std::string, PublishedChoices>;

}  // namespace clearcut::inline model
