#include "order/length/length_search.h"

#include <algorithm>
#include <numeric>

#include "base/elementary.h"
#include "base/parallel.h"
#include "order/length/chained_search.h"
#include "order/length/population.h"
#include "order/length/start_tours.h"

namespace clearcut::order {

namespace {

using Cost = LengthModel::Cost;

constexpr int kSmallestPopulation = 12;
constexpr double kStartNoise = 0.5;
constexpr double kShareOfStarts = 0.3;  // share of the time; breeding takes about 2.5 times as long
/// Above this many points one exchange on the whole array is too slow to start from a greedy tour.
constexpr int kLargestWholeDescent = 150000;
constexpr int kWindow = 10000;

struct Plan {
  int population = 0;  ///< 0: chained search
  long long kicks = 0;
};

/// Seconds of one core per tour in a population: measured on the reference instances, see docs/tour.md.
double seconds_per_individual(int n) {
  return 0.019 * base::pow(n / 2392.0, 1.75);
}

/// Rough starts keep more edges to choose from, good ones save generations on large instances; on a few points
/// all starts are alike and kicks cost nothing. Measured on the reference instances.
long long kicks_for(int n) {
  if (n < 100) return n;
  return n < 1500 ? 0 : static_cast<long long>(n * std::min(0.1, n * 1e-5));
}

Plan plan_for(int n, double seconds) {
  Plan plan;
  const double affordable = 0.3 * std::min(seconds, 1e6) / seconds_per_individual(n);
  const int largest = n < 500 ? 150 : 300;
  plan.population = static_cast<int>(std::min<double>(affordable, largest));
  if (plan.population < kSmallestPopulation) plan.population = 0;
  plan.kicks = kicks_for(n);
  return plan;
}

/// The best tour so far, shared by parallel searches; reports on the calling thread only.
class Best {
 public:
  Best(const LengthModel& model, const LengthSearchOptions& options) : model_(model), options_(options) {}
  void offer(const std::vector<int>& nodes, Cost cost) {
    if (!nodes_.empty() && cost >= cost_) return;
    nodes_ = nodes;
    cost_ = cost;
    if (options_.improved) options_.improved(model_.to_problem(nodes_), model_.length(cost_));
  }
  bool enough() const { return !nodes_.empty() && model_.length(cost_) <= options_.enough; }
  Cost cost() const { return cost_; }
  const std::vector<int>& nodes() const { return nodes_; }

 private:
  const LengthModel& model_;
  const LengthSearchOptions& options_;
  std::vector<int> nodes_;
  Cost cost_ = 0;
};

std::vector<int> start_tour(const LengthModel& model, std::uint64_t seed, long long kicks,
                            const StopWatch& watch) {
  Random random(seed);
  ChainedSearch search(model, greedy_tour(model, kStartNoise, random), default_breadth(), random.next());
  search.descend(watch);
  search.run(kicks, watch);
  return search.nodes();
}

/// Fewer tours than planned if the available time does not suffice for the plan.
std::vector<std::vector<int>> start_tours(const LengthModel& model, const Plan& plan, std::uint64_t seed,
                                          const StopWatch& watch) {
  std::vector<std::vector<int>> tours(static_cast<std::size_t>(plan.population));
  std::vector<std::uint64_t> seeds;
  Random random(seed);
  for (int i = 0; i < plan.population; ++i) seeds.push_back(random.next());
  parallel_for(0, plan.population, [&](int i) {
    if (!watch.over()) tours[i] = start_tour(model, seeds[i], plan.kicks, watch);
  });
  std::erase_if(tours, [](const auto& t) { return t.empty(); });
  return tours;
}

/// Ends when the start tours of a population have used their share of the remaining time: populations with more tours
/// could not finish, and an unfinished population is far worse than a smaller one.
StopWatch start_watch(const StopRule& stop, const StopWatch& watch) {
  StopRule starts = stop;
  starts.seconds = std::max(0.0, stop.seconds - watch.seconds()) * kShareOfStarts;
  return StopWatch(starts);
}

long long search_by_populations(const LengthModel& model, const Plan& plan,
                                const LengthSearchOptions& options, const StopWatch& watch, Best& best) {
  constexpr int kPatience = 3;
  Random random(options.seed);
  long long round = 0;
  bool found_again = false;  // a second, independent population reached the same best length
  for (int idle = 0;
       round < options.stop.rounds && idle < kPatience && !found_again && !watch.over() && !best.enough();
       ++round) {
    const Cost before = best.cost();
    std::vector<std::vector<int>> tours =
        start_tours(model, plan, random.next(), start_watch(options.stop, watch));
    for (const auto& nodes : tours) best.offer(nodes, model.tour_cost(nodes));
    if (static_cast<int>(tours.size()) < kSmallestPopulation) break;
    Population population(model, std::move(tours), {.children = 30, .seed = random.next()});
    population.evolve(watch, [&](const std::vector<int>& nodes, Cost cost) {
      best.offer(nodes, cost);
      return !best.enough();
    });
    found_again = round > 0 && population.best_cost() == before;
    idle = round > 0 && best.cost() >= before ? idle + 1 : 0;
  }
  return round;
}

/// A stretch of a tour: the positions [first, first + count).
struct TourWindow {
  int first = 0, count = 0;
  long long kicks = 0;     ///< number of kicks by which it is improved
  std::uint64_t seed = 0;  ///< of the random numbers for them
};

/// The points of the window as a path with fixed ends; improved by kicks.
std::vector<int> improve_window(const Problem& problem, std::span<const int> tour, const TourWindow& window,
                                const StopWatch& watch) {
  const int n = static_cast<int>(tour.size()), count = window.count;
  std::vector<int> members;
  Problem part;
  part.metric = problem.metric;
  part.shape = Shape::kOpenPath;
  for (int i = 0; i < count; ++i) {
    members.push_back(tour[(window.first + i) % n]);
    part.points.push_back(problem.points[members.back()]);
  }
  part.start = 0;
  part.end = count - 1;
  if (problem.detour) {
    part.detour = [&](int a, int b) { return problem.detour(members[a], members[b]); };
  }
  const LengthModel model(part, kCandidates);
  Tour in_place(static_cast<std::size_t>(count));
  std::iota(in_place.begin(), in_place.end(), 0);
  ChainedSearch search(model, model.from_problem(in_place), default_breadth(), window.seed);
  search.descend(watch);
  search.run(window.kicks, watch);
  std::vector<int> result;
  for (const int i : model.to_problem(search.nodes())) result.push_back(members[i]);
  return result;
}

/// Windows side by side from a random offset; no window shares a point with another.
std::vector<int> window_borders(const Problem& problem, Random& random) {
  const int n = problem.size();
  const int windows = std::max(1, (n + kWindow / 2) / kWindow);
  const int shift = problem.closed() ? 0 : static_cast<int>(random.below(kWindow));
  std::vector<int> begins{0};
  for (int i = 1; i < windows; ++i)
    begins.push_back(static_cast<int>(static_cast<long long>(n) * i / windows) - shift / 2);
  begins.push_back(n);
  return begins;
}

/// One pass over all windows, some at a time in parallel; `told` is called after each batch.
template <typename Told>
void improve_all_windows(const Problem& problem, Tour& tour, bool kicked, Random& random,
                         const StopWatch& watch, Told told) {
  constexpr int kAtATime = 16;
  const int n = static_cast<int>(tour.size());
  const std::vector<int> begins = window_borders(problem, random);
  const int offset = problem.closed() ? static_cast<int>(random.below(static_cast<std::uint64_t>(n))) : 0;
  const int windows = static_cast<int>(begins.size()) - 1;
  std::vector<std::uint64_t> seeds;
  for (int i = 0; i < windows; ++i) seeds.push_back(random.next());
  for (int some = 0; some < windows && !watch.over(); some += kAtATime) {
    parallel_for(some, std::min(some + kAtATime, windows), [&](int i) {
      const int count = begins[i + 1] - begins[i];
      if (watch.over() || count < 8) return;
      const int first = (offset + begins[i]) % n;
      const std::vector<int> part =
          improve_window(problem, tour, {first, count, kicked ? count : 0, seeds[i]}, watch);
      for (int j = 0; j < count; ++j) tour[(first + j) % n] = part[j];
    });
    told(tour);
  }
}

long long search_by_windows(const Problem& problem, const LengthModel& model,
                            const LengthSearchOptions& options, const StopWatch& watch, Best& best) {
  Random random(options.seed);
  long long round = 0;
  for (; round < options.stop.rounds && !watch.over() && !best.enough(); ++round) {
    Tour tour = model.to_problem(best.nodes());
    improve_all_windows(problem, tour, round > 0, random, watch, [&](const Tour& now) {
      const std::vector<int> nodes = model.from_problem(now);
      best.offer(nodes, model.tour_cost(nodes));
    });
    if (round % 4 != 0) continue;
    // Parts across the windows' borders are improved on the whole tour.
    ChainedSearch whole(model, best.nodes(), default_breadth(), random.next());
    whole.descend(watch);
    best.offer(whole.nodes(), whole.cost());
  }
  return round;
}

}  // namespace

std::vector<int> first_tour(const LengthModel& model, const StopWatch& watch) {
  Random random(0);
  if (model.size() > kLargestWholeDescent) {
    std::vector<int> along_curve(static_cast<std::size_t>(model.size()));
    std::iota(along_curve.begin(), along_curve.end(), 0);
    return model.keeping_ends(std::move(along_curve));
  }
  ChainedSearch search(model, greedy_tour(model, 0, random), default_breadth(), 0);
  search.descend(watch);
  return search.nodes();
}

LengthSearchResult search_length(const Problem& problem, const LengthModel& model, std::vector<int> first,
                                 const LengthSearchOptions& options) {
  const StopWatch watch(options.stop);
  Best best(model, options);
  best.offer(first, model.tour_cost(first));
  LengthSearchResult result;
  const Plan plan = plan_for(problem.size(), options.stop.planned_seconds());
  if (plan.population > 0) {
    result.rounds = search_by_populations(model, plan, options, watch, best);
    result.method = "edge assembly, population " + std::to_string(plan.population);
  }
  const bool is_too_slow = plan.population > 0 && result.rounds == 0 && !best.enough();
  if (plan.population == 0 || is_too_slow) {
    result.rounds = search_by_windows(problem, model, options, watch, best);
    result.method = "chained local search, windows of " + std::to_string(kWindow);
  }
  result.tour = model.to_problem(best.nodes());
  result.length = model.length(best.cost());
  return result;
}

}  // namespace clearcut::order
