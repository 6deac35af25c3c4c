#include "order/search/solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/parallel.h"
#include "order/bounds/bounds.h"
#include "order/lattice.h"
#include "order/length/length_search.h"
#include "order/search/exchange_search.h"

namespace clearcut::order {

namespace {

int bound_iterations(int n) {
  return n < 2000 ? 200 : n < 20000 ? 100 : n < 200000 ? 30 : 10;
}

struct Part {
  double value = 0;
  std::string basis;
};

/// Bounds of turns and angle valid for the class of tours to which the bound is compared.
struct TurnBounds {
  int turns = 0;
  double angle = 0;
  std::string basis;
};

TurnBounds turn_bounds(const std::optional<Lattice>& lattice, const Problem& problem, bool unit_steps) {
  const bool closed = problem.closed();
  if (!lattice) return {closed ? 2 : 0, closed ? 360.0 : 0.0, "none for turns"};
  if (unit_steps) {
    const int strips = lattice_turns_bound(*lattice, closed);
    const int runs = lattice->full() ? 0 : run_cover_bound(*lattice, closed);
    const int turns = std::max(strips, runs);
    return {turns, std::max(90.0 * turns, closed ? 360.0 : 0.0),
            runs > strips ? "run cover, unit steps" : "strip cover, unit steps"};
  }
  const Moves moves(problem);
  const int lines = line_cover_bound(*lattice, closed, [&](int a, int b) { return moves.is_straight(a, b); });
  // Runs share their common end points, if no path bends elsewhere.
  const int runs = moves.has_detours() ? 0 : lattice_turns_bound_any_moves(*lattice, closed);
  return {std::max(lines, runs), closed ? 360.0 : 0.0, "line cover"};
}

Bound combine(const Objective::Linear& linear, const Part& length, const TurnBounds& turns) {
  Bound bound;
  bound.value = linear.constant + linear.length * length.value + linear.turns * turns.turns +
                linear.angle * turns.angle;
  if (linear.length > 0) bound.basis = length.basis;
  if (linear.turns > 0 || linear.angle > 0) bound.basis += (bound.basis.empty() ? "" : "; ") + turns.basis;
  if (!linear.exact) bound.basis += (bound.basis.empty() ? "" : "; ") + std::string("0 for the rest");
  return bound;
}

/// Everything the bound needs once per problem.
class Bounds {
 public:
  Bounds(const Problem& problem, const Objective& objective)
      : problem_(problem), linear_(objective.linear()), lattice_(Lattice::recognise(problem.points)) {
    if (lattice_ && problem.metric == Metric::kEuclidean) {
      length_ = {lattice_length_bound(*lattice_, problem.closed()), "lattice steps"};
    }
  }
  const std::optional<Lattice>& lattice() const { return lattice_; }
  /// The 1-tree bound, if length matters and `nodes` does not already reach the lattice's bound.
  void find_length(const LengthModel& model, std::span<const int> nodes, const StopWatch& watch) {
    if (linear_.length == 0 || model.length(model.tour_cost(nodes)) <= length_.value * (1 + kSameValue))
      return;
    const double tree = held_karp_bound(model, nodes, bound_iterations(problem_.size()), watch);
    if (tree > length_.value) length_ = {tree, "1-tree"};
  }
  /// The unit-step bound, unless a tour with other steps undercuts it.
  Bound below(double objective_value) const {
    for (const bool unit_steps : {true, false}) {
      const Bound bound = combine(linear_, length_, turn_bounds_of(unit_steps));
      if (bound.value <= objective_value * (1 + kSameValue) + kSameValue) return bound;
    }
    return combine(linear_, length_, turn_bounds_of(false));
  }

 private:
  const TurnBounds& turn_bounds_of(bool unit_steps) const {
    static const TurnBounds kNotAsked;
    if (linear_.turns == 0 && linear_.angle == 0) return kNotAsked;
    auto& known = turns_[unit_steps ? 1 : 0];
    if (!known) known = turn_bounds(lattice_, problem_, unit_steps);
    return *known;
  }
  const Problem& problem_;
  Objective::Linear linear_;
  std::optional<Lattice> lattice_;
  Part length_{0, "none for length"};
  mutable std::optional<TurnBounds> turns_[2];
};

/// Keeps the best tour and reports improvements.
class Keeper {
 public:
  Keeper(const Problem& problem, const SolveOptions& options, const StopWatch& watch)
      : problem_(problem), options_(options), watch_(watch) {}
  /// Better, or as good and shorter.
  void offer(const Tour& tour, double value) {
    const double rounding = kSameValue * std::abs(value_);
    if (!tour_.empty() && value > value_ + rounding) return;
    const double length = tour_length(problem_, tour);
    if (!tour_.empty() && value > value_ - rounding && length >= length_ * (1 - kSameValue)) return;
    tour_ = tour;
    value_ = value;
    length_ = length;
    if (options_.progress) options_.progress({tour_, value_, watch_.seconds()});
  }
  const Tour& tour() const { return tour_; }
  double value() const { return value_; }

 private:
  const Problem& problem_;
  const SolveOptions& options_;
  const StopWatch& watch_;
  Tour tour_;
  double value_ = 0, length_ = 0;
};

/// Value at which the search may stop: the bound, or the requested gap.
double enough_value(const Bound& bound, const StopRule& stop) {
  return std::max(bound.value * (1 + stop.gap), bound.value + std::abs(bound.value) * kSameValue);
}

/// A share of the remaining time. Plans use the whole time, so that they do not depend on the clock.
StopRule remaining(const StopRule& stop, const StopWatch& watch, double share) {
  StopRule rest = stop;
  rest.effort = stop.planned_seconds();
  rest.seconds = std::max(0.0, (stop.seconds - watch.seconds()) * share);
  return rest;
}

/// What all steps of one search work with. References are kept.
struct SolveRun {
  const Problem& problem;
  const Objective& objective;
  const SolveOptions& options;
  const StopWatch& watch;
  const Moves& moves;
  Evaluator& value_of;  ///< the objective's value of a tour
  Bounds& bounds;
  Keeper& keeper;

  /// The value at which the search may stop, by the bound below the best tour so far.
  double enough() const { return enough_value(bounds.below(keeper.value()), options.stop); }
};

/// Tours with their values.
using ValuedTours = std::vector<std::pair<double, Tour>>;

/// Offers the lattice's sweeps, in both directions; true when one of them is proven good enough.
bool sweep(const SolveRun& run, ValuedTours& valued) {
  if (!run.bounds.lattice()) return false;
  for (Tour tour : sweeps(*run.bounds.lattice(), run.problem.closed())) {
    for (int direction = 0; direction < 2; ++direction) {
      if (is_valid(run.problem, tour)) {
        valued.push_back({run.value_of(tour), tour});
        run.keeper.offer(tour, valued.back().first);
      }
      std::reverse(tour.begin(), tour.end());
    }
  }
  return !run.keeper.tour().empty() && run.keeper.value() <= run.enough();
}

void solve_length(const SolveRun& run, Solution& solution) {
  const StopRule& stop = run.options.stop;
  const LengthModel model(run.problem, kCandidates);
  const std::vector<int> first = first_tour(model, run.watch);
  run.keeper.offer(model.to_problem(first), model.length(model.tour_cost(first)));
  run.bounds.find_length(model, first, StopWatch(remaining(stop, run.watch, 0.2)));
  LengthSearchOptions search;
  search.stop = remaining(stop, run.watch, 1);
  search.seed = run.options.seed;
  search.enough = run.enough();
  search.improved = [&](const Tour& tour, double length) { run.keeper.offer(tour, length); };
  const LengthSearchResult result = search_length(run.problem, model, first, search);
  solution.rounds = result.rounds;
  solution.method = result.method;
}

/// A valid order made of nearest next points whose predecessors are done. O(n^2).
Tour nearest_allowed(const Problem& problem, const Moves& moves) {
  const int n = problem.size();
  std::vector<int> waiting(problem.points.size(), 0);
  for (const Precedence& p : problem.precedence) ++waiting[p.after];
  std::vector<char> done(problem.points.size(), 0);
  Tour tour;
  for (int step = 0; step < n; ++step) {
    int best = -1;
    double best_length = 0;
    for (int v = 0; v < n; ++v) {
      if (done[v] || waiting[v] > 0 || (v == problem.end && step + 1 < n)) continue;
      if (step == 0 && problem.start >= 0 && v != problem.start) continue;
      const double length = tour.empty() ? 0 : moves.length(tour.back(), v);
      if (best < 0 || length < best_length) {
        best = v;
        best_length = length;
      }
    }
    done[best] = 1;
    tour.push_back(best);
    for (const Precedence& p : problem.precedence) waiting[p.after] -= p.before == best ? 1 : 0;
  }
  return tour;
}

void sort_best_first(ValuedTours& valued) {
  std::stable_sort(valued.begin(), valued.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
}

/// Adds a short tour, or one obeying precedence, and sorts: best first.
void add_starts(const SolveRun& run, ValuedTours& valued) {
  const Problem& problem = run.problem;
  const LengthModel model(problem, kCandidates);
  const std::vector<int> first = first_tour(model, run.watch);
  run.bounds.find_length(model, first, StopWatch(remaining(run.options.stop, run.watch, 0.2)));
  std::vector<Tour> tours{model.to_problem(first)};
  if (!problem.precedence.empty()) tours = {nearest_allowed(problem, run.moves), topological_order(problem)};
  for (Tour& tour : tours) {
    if (is_valid(problem, tour)) valued.push_back({run.value_of(tour), std::move(tour)});
  }
  sort_best_first(valued);
}

/// Among tours of equal turns or angle the shorter one: length with a weight so small that it never outweighs a turn.
ObjectivePtr with_tie_break(const Objective& objective, const TourFigures& start) {
  const auto borrowed = ObjectivePtr(std::shared_ptr<void>(), &objective);
  if (objective.linear().length > 0 || start.length <= 0) return borrowed;
  return weighted_sum({{1.0, borrowed}, {1e-4 / start.length, length_objective()}});
}

constexpr int kIslands = 4;  // fixed, for any number of threads

/// Independent parallel searches.
class Islands {
 public:
  /// Each search begins at one of the first of `seeds`; objective and neighbours must outlive it.
  Islands(const Moves& moves, const Objective& objective, const Neighbours& neighbours,
          const ValuedTours& seeds, const SolveOptions& options) {
    Random random(options.seed);
    for (int i = 0; i < kIslands; ++i) {
      const Tour& start = seeds[static_cast<std::size_t>(i) % seeds.size()].second;
      islands_.emplace_back(moves, objective, neighbours, start, random.next());
    }
    const double effort = std::min(1.0, 2 * options.stop.planned_seconds());
    kicks_ = std::max(20, static_cast<int>(1000 * effort) / (1 + moves.problem().size() / 100));
  }
  void run_round(double enough, const StopWatch& watch) {
    parallel_for(0, kIslands, [&](int i) {
      if (!descended_) islands_[i].descend(watch);
      islands_[i].run(kicks_, enough, watch);
    });
    descended_ = true;
  }
  std::vector<Tour> tours() const {
    std::vector<Tour> tours;
    for (const ExchangeSearch& island : islands_) tours.push_back(island.tour());
    return tours;
  }
  double least() const {
    double value = std::numeric_limits<double>::infinity();
    for (const ExchangeSearch& island : islands_) value = std::min(value, island.value());
    return value;
  }

 private:
  std::vector<ExchangeSearch> islands_;
  long long kicks_ = 0;
  bool descended_ = false;
};

/// An objective without its part depending on the whole path.
class LocalPart final : public Objective {
 public:
  explicit LocalPart(const Objective& whole) : whole_(whole) {}
  std::string name() const override { return whole_.name(); }
  std::string unit() const override { return whole_.unit(); }
  double edge(const Moves& moves, int a, int b) const override { return whole_.edge(moves, a, b); }
  double corner(const Moves& moves, int a, int b, int c) const override {
    return whole_.corner(moves, a, b, c);
  }
  Linear linear() const override { return whole_.linear(); }

 private:
  const Objective& whole_;
};

/// Evaluating the whole path is costly: if edges and corners count as well, tours good in these are found first.
void add_local_starts(const SolveRun& run, const Neighbours& neighbours, ValuedTours& valued) {
  constexpr int kRounds = 25, kPatience = 10;
  const StopRule& stop = run.options.stop;
  const Objective::Linear linear = run.objective.linear();
  const bool has_local = linear.length > 0 || linear.turns > 0 || linear.angle > 0;
  if (!run.objective.path_dependent() || !has_local) return;
  const LocalPart local(run.objective);
  ValuedTours seeds;
  for (const auto& [value, tour] : valued) seeds.push_back({evaluate(local, run.moves, tour), tour});
  sort_best_first(seeds);
  const double enough = enough_value(run.bounds.below(seeds.front().first), stop);
  Islands islands(run.moves, local, neighbours, seeds, run.options);
  const StopWatch share(remaining(stop, run.watch, 0.3));
  const auto offer = [&](Tour tour) {
    if (is_valid(run.problem, tour)) valued.push_back({run.value_of(tour), std::move(tour)});
  };
  double least = seeds.front().first;
  for (int round = 0, idle = 0; round < kRounds && idle < kPatience && least > enough && !share.over();
       ++round) {
    islands.run_round(enough, share);
    idle = islands.least() < least ? 0 : idle + 1;
    least = std::min(least, islands.least());
    for (Tour& tour : islands.tours()) {
      offer({tour.rbegin(), tour.rend()});
      offer(std::move(tour));
    }
  }
  sort_best_first(valued);
  valued.erase(std::unique(valued.begin(), valued.end(),
                           [](const auto& a, const auto& b) { return a.second == b.second; }),
               valued.end());
}

/// Tours with few turns are found starting from short tours: judged only by turns or angles, nearly every exchange
/// makes no difference. Here a turn counts as much as a short run of steps. Absent if length counts anyway.
ObjectivePtr guide(const Objective& objective, const Moves& moves, double length) {
  constexpr double kStepsOfTurn = 7, kDegreesOfTurn = 90;
  const Objective::Linear linear = objective.linear();
  const double turn = linear.turns + kDegreesOfTurn * linear.angle;
  if (linear.length > 0 || turn <= 0 || length <= 0 || objective.path_dependent()) return nullptr;
  const double step = length / moves.problem().size();
  const auto borrowed = ObjectivePtr(std::shared_ptr<void>(), &objective);
  return weighted_sum({{1.0, borrowed}, {turn / (kStepsOfTurn * step), length_objective()}});
}

/// Ends of a search by islands.
struct IslandLimits {
  double enough = 0;          ///< value of the islands' own objective at which a round ends early
  double proven = 0;          ///< value of the kept tour at which the search ends
  long long most_rounds = 0;  ///< greatest number of rounds
  const StopWatch& watch;
};

/// Islands, compared after each round; the rounds made.
long long run_islands(const SolveRun& run, Islands& islands, const IslandLimits& limits) {
  constexpr int kPatience = 25;
  Keeper& keeper = run.keeper;
  long long rounds = 0;
  for (int idle = 0; rounds < limits.most_rounds && idle < kPatience && !limits.watch.over() &&
                     keeper.value() > limits.proven;
       ++rounds) {
    const double before = keeper.value(), least = islands.least();
    islands.run_round(limits.enough, limits.watch);
    for (const Tour& tour : islands.tours()) keeper.offer(tour, run.value_of(tour));
    idle = keeper.value() < before || islands.least() < least ? 0 : idle + 1;
  }
  return rounds;
}

void solve_general(const SolveRun& run, ValuedTours seeds, Solution& solution) {
  const Problem& problem = run.problem;
  const StopRule& stop = run.options.stop;
  const Neighbours neighbours = nearest_neighbours(problem.points, std::min(problem.neighbour_count, 12));
  add_starts(run, seeds);
  for (const auto& [value, tour] : seeds) run.keeper.offer(tour, value);
  add_local_starts(run, neighbours, seeds);
  for (const auto& [value, tour] : seeds) run.keeper.offer(tour, value);
  const double proven = run.enough();
  const auto kept_figures = [&] { return figures(run.moves, run.keeper.tour()); };
  if (const ObjectivePtr guiding = guide(run.objective, run.moves, kept_figures().length)) {
    constexpr double kNever = -std::numeric_limits<double>::infinity();
    Islands islands(run.moves, *guiding, neighbours, seeds, run.options);
    const StopWatch share(remaining(stop, run.watch, 0.5));
    solution.rounds = run_islands(run, islands, {kNever, proven, (stop.rounds + 1) / 2, share});
    for (Tour& tour : islands.tours()) seeds.push_back({run.value_of(tour), std::move(tour)});
    sort_best_first(seeds);
  }
  const ObjectivePtr sharpened = with_tie_break(run.objective, kept_figures());
  Islands islands(run.moves, *sharpened, neighbours, seeds, run.options);
  solution.rounds += run_islands(run, islands, {proven, proven, stop.rounds - solution.rounds, run.watch});
  solution.method = "exchanges, " + std::to_string(kIslands) + " islands";
}

}  // namespace

void set_result(Solution& solution, const Moves& moves, const Tour& tour, double objective,
                const Bound& bound) {
  solution.tour = tour;
  solution.objective = objective;
  const TourFigures f = figures(moves, tour);
  solution.length = f.length;
  solution.turns = f.turns;
  solution.angle_deg = f.angle_deg;
  solution.bound = std::min(bound.value, objective);
  solution.bound_basis = bound.basis;
  const double difference = objective - solution.bound;
  const bool equal = difference <= kSameValue * std::abs(objective);
  solution.gap = equal                ? 0
                 : solution.bound > 0 ? difference / solution.bound
                                      : std::numeric_limits<double>::infinity();
}

Solution solve(const Problem& problem, const Objective& objective, const SolveOptions& options) {
  check(problem);
  const StopWatch watch(options.stop);
  const Moves moves(problem);
  Solution solution;
  solution.seed = options.seed;
  Keeper keeper(problem, options, watch);
  Bound bound;
  on_threads(options.threads, [&] {
    if (const auto exact = solve_exact(moves, objective)) {
      keeper.offer(canonical(problem, exact->tour), exact->value);
      bound = {exact->value, "exact"};
      solution.method = "exact";
      return;
    }
    Bounds bounds(problem, objective);
    ValuedTours seeds;
    Evaluator value_of(objective, moves);
    const SolveRun run{problem, objective, options, watch, moves, value_of, bounds, keeper};
    if (sweep(run, seeds)) {
      solution.method = "sweep";
    } else if (objective.is_length() && problem.precedence.empty()) {
      solve_length(run, solution);
    } else {
      solve_general(run, std::move(seeds), solution);
    }
    bound = bounds.below(keeper.value());
  });
  set_result(solution, moves, keeper.tour(), keeper.value(), bound);
  solution.seconds = watch.seconds();
  return solution;
}

Bound lower_bound(const Problem& problem, const Objective& objective, const Tour& tour,
                  const StopWatch& watch) {
  const Moves moves(problem);
  Bounds bounds(problem, objective);
  const LengthModel model(problem, kCandidates);
  bounds.find_length(model, model.from_problem(tour), watch);
  return bounds.below(evaluate(objective, moves, tour));
}

}  // namespace clearcut::order
