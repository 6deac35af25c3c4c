#include "order/length/length_search.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <tuple>

#include "base/containers.h"
#include "base/elementary.h"
#include "base/parallel.h"
#include "order/length/neighbours.h"
#include "order/length/population.h"

namespace clearcut::order {

namespace {

/// Paths under construction: up to two links a node, and the path of each node.
class Fragments {
 public:
  explicit Fragments(int n) : link_(static_cast<std::size_t>(n), {-1, -1}), joined_(n), paths_(n) {}
  int paths() const { return paths_; }
  bool is_end(int v) const { return link_[v][1] < 0; }
  bool can_join(int a, int b) { return is_end(a) && is_end(b) && find(a) != find(b); }
  void join(int a, int b) {
    add_link(a, b);
    add_link(b, a);
    joined_.join(a, b);
    --paths_;
  }
  int find(int v) { return joined_.find(v); }
  std::vector<int> ends() const {
    std::vector<int> result;
    for (std::size_t v = 0; v < link_.size(); ++v) {
      if (is_end(static_cast<int>(v))) result.push_back(static_cast<int>(v));
    }
    return result;
  }
  /// The single remaining path.
  std::vector<int> path() const {
    int v = 0;
    while (!is_end(v)) ++v;
    std::vector<int> nodes;
    for (int previous = -1; v >= 0;) {
      nodes.push_back(v);
      const int next = link_[v][0] != previous ? link_[v][0] : link_[v][1];
      previous = v;
      v = next;
    }
    return nodes;
  }

 private:
  void add_link(int a, int b) { (link_[a][0] < 0 ? link_[a][0] : link_[a][1]) = b; }
  std::vector<std::array<int, 2>> link_;
  DisjointSets joined_;
  int paths_;
};

struct Edge {
  LengthModel::Cost cost;
  int a, b;
  friend bool operator<(const Edge& x, const Edge& y) {
    return std::tie(x.cost, x.a, x.b) < std::tie(y.cost, y.a, y.b);
  }
};

void join_in_order(std::vector<Edge>& edges, Fragments& fragments) {
  std::sort(edges.begin(), edges.end());
  for (const Edge& e : edges) {
    if (fragments.can_join(e.a, e.b)) fragments.join(e.a, e.b);
  }
}

constexpr int kGreedyCandidates = 6;

std::vector<Edge> candidate_edges(const LengthModel& model, double noise, Random& random) {
  std::vector<Edge> edges;
  for (int v = 0; v < model.size(); ++v) {
    if (v == model.extra_node()) continue;
    const auto candidates = model.candidates(v);
    const auto costs = model.candidate_costs(v);
    int taken = 0;
    for (std::size_t i = 0; i < candidates.size() && taken < kGreedyCandidates; ++i) {
      const int w = candidates[i];
      if (w == model.extra_node()) continue;
      ++taken;
      const auto back = model.candidates(w);
      if (w < v && std::find(back.begin(), back.end(), v) != back.end()) continue;
      const double factor = noise > 0 ? 1 + noise * random.unit() : 1;
      edges.push_back({static_cast<LengthModel::Cost>(static_cast<double>(costs[i]) * factor), v, w});
    }
  }
  return edges;
}

/// Joins each path's ends to the nearest ends of other paths; at least halves the number of paths.
void join_nearest_ends(const LengthModel& model, Fragments& fragments) {
  std::vector<int> ends = fragments.ends();
  std::erase(ends, model.extra_node());
  std::vector<Vec2> points;
  for (const int v : ends) points.push_back(model.point(v));
  const KdTree tree(points);
  const double infinity = std::numeric_limits<double>::infinity();
  const Box everywhere{{-infinity, -infinity}, {infinity, infinity}};
  std::vector<Edge> edges;
  std::vector<KdTree::Found> found;
  for (const int v : ends) {
    const int own = fragments.find(v);
    tree.nearest(
        model.point(v), 5, everywhere, [&](int i) { return fragments.find(ends[i]) != own; }, found);
    for (const auto& f : found) edges.push_back({model.cost(v, ends[f.second]), v, ends[f.second]});
  }
  join_in_order(edges, fragments);
}

}  // namespace

std::vector<int> greedy_tour(const LengthModel& model, double noise, Random& random) {
  Fragments fragments(model.size());
  const int extra = model.extra_node();
  int paths_wanted = 1;
  if (extra >= 0) {
    // Fixed ends hang on the extra node; without fixed ends it stays separate until the end.
    for (const int v : model.candidates(extra)) {
      if (model.cost(extra, v) < 0 && fragments.can_join(extra, v)) fragments.join(extra, v);
    }
    if (fragments.paths() == model.size()) paths_wanted = 2;
  }
  std::vector<Edge> edges = candidate_edges(model, noise, random);
  join_in_order(edges, fragments);
  edges = {};
  while (fragments.paths() > paths_wanted) join_nearest_ends(model, fragments);
  std::vector<int> tour = fragments.path();
  if (paths_wanted == 2) tour.push_back(extra);
  return tour;
}

namespace {
constexpr int kLongestSegment = 50;
constexpr int kKicksBetweenChecks = 64;
constexpr int kLargestFree = 150000;    // points; above, one exchange on the whole array is too slow
constexpr int kLongestRewrite = 50000;  // then
}  // namespace

ChainedSearch::ChainedSearch(const LengthModel& model, std::vector<int> start, KOptBreadth breadth,
                             std::uint64_t seed)
    : model_(model),
      search_(model, std::move(start), breadth),
      random_(seed),
      cost_(model.tour_cost(nodes())) {
  if (model.size() > kLargestFree) search_.rewrite_at_most(kLongestRewrite);
}

void ChainedSearch::descend(const StopWatch& watch) {
  for (const int v : std::vector<int>(nodes())) search_.touch(v);
  search_.tour().forget_changes(true);
  cost_ -= search_.improve(&watch);
  search_.tour().forget_changes(false);
  search_.tour().commit();
}

/// Double bridge on three neighbouring segments A B C -> C B A, each 1 to 50 nodes long.
ChainedSearch::Cost ChainedSearch::kick() {
  ArrayTour& tour = search_.tour();
  const int n = tour.size();
  const int longest = std::min(kLongestSegment, (n - 2) / 3);
  const int before = static_cast<int>(random_.below(static_cast<std::uint64_t>(n)));
  std::array<int, 4> last;  // of "before", A, B, C: offsets from `before`
  last[0] = 0;
  for (int i = 1; i < 4; ++i)
    last[i] = last[i - 1] + 1 + static_cast<int>(random_.below(static_cast<std::uint64_t>(longest)));
  const auto node = [&](int offset) {
    return tour.at(before + offset < n ? before + offset : before + offset - n);
  };
  segments_.clear();
  for (int i = 3; i > 0; --i) {
    for (int offset = last[i - 1] + 1; offset <= last[i]; ++offset) segments_.push_back(node(offset));
  }
  const std::array<int, 8> ends{node(0),       node(1),           node(last[1]), node(last[1] + 1),
                                node(last[2]), node(last[2] + 1), node(last[3]), node(last[3] + 1)};
  const auto cost = [&](int a, int b) { return model_.cost(ends[a], ends[b]); };
  const Cost change =
      cost(0, 5) + cost(6, 3) + cost(4, 1) + cost(2, 7) - cost(0, 1) - cost(2, 3) - cost(4, 5) - cost(6, 7);
  tour.rewrite(before + 1 == n ? 0 : before + 1, segments_);
  for (const int v : ends) search_.touch(v);
  return change;
}

void ChainedSearch::run(long long kicks, const StopWatch& watch) {
  if (nodes().size() < 8) return;
  for (long long i = 0; i < kicks; ++i) {
    if (i % kKicksBetweenChecks == 0 && watch.over()) return;
    const Cost after = cost_ + kick() - search_.improve();
    if (after <= cost_) {
      cost_ = after;
      search_.tour().commit();
    } else {
      search_.tour().undo();
    }
  }
}

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

/// One pass over all windows, some at a time in parallel; `after_batch` is called after each batch.
template <typename AfterBatch>
void improve_all_windows(const Problem& problem, Tour& tour, bool kicked, Random& random,
                         const StopWatch& watch, AfterBatch after_batch) {
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
    after_batch(tour);
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
