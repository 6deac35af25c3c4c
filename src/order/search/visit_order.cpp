#include "order/search/visit_order.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/error.h"

namespace clearcut::order {
namespace {

constexpr double kNotReached = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostExact = 9;
/// Greatest size of the table of sets and ways; beyond it even few visits are only improved.
constexpr std::size_t kMostEntries = 60000;
/// Rounds of improvement; each tries every stretch in every place.
constexpr int kRounds = 4;
/// Up to this many visits the ways are chosen anew for every tried order.
constexpr std::size_t kMostWithWays = 24;
/// With more visits than this the first order is kept.
constexpr std::size_t kMostImproved = 1000;
constexpr std::size_t kLongestMoved = 3;
/// Smaller savings count as rounding.
constexpr double kGain = 1e-9;
/// Up to this many ways all costs between them are stored.
constexpr std::size_t kMostKnown = 512;
/// From the end of each visit, this many nearest beginnings are considered.
constexpr std::ptrdiff_t kMostNear = 24;

using Order = std::vector<std::size_t>;
using States = std::vector<std::size_t>;

/// All costs, each computed once. States are the ways of all visits in one row.
class Costs {
 public:
  explicit Costs(const VisitQuestion& question) : question_(question) {
    for (std::size_t visit = 0; visit < question.visits.size(); ++visit) {
      first_.push_back(steps_.size());
      CLEARCUT_ASSERT(!question.visits[visit].ways.empty());
      for (std::size_t way = 0; way < question.visits[visit].ways.size(); ++way)
        steps_.push_back({visit, way});
    }
    first_.push_back(steps_.size());
    near_.resize(steps_.size());
    if (states() <= kMostKnown) known_.assign(states() * states(), -1);
  }

  std::size_t visits() const { return question_.visits.size(); }
  std::size_t states() const { return steps_.size(); }
  std::size_t first(std::size_t visit) const { return first_[visit]; }
  std::size_t ways(std::size_t visit) const { return first_[visit + 1] - first_[visit]; }
  const VisitStep& step(std::size_t state) const { return steps_[state]; }
  double own(std::size_t state) const { return way(state).own; }

  double travel(std::size_t from, std::size_t to) {
    if (known_.empty()) return asked(from, to);
    double& known = known_[from * states() + to];
    if (known < 0) known = asked(from, to);
    return known;
  }

 private:
  struct Near {
    std::size_t state = 0;
    double away = 0;
    double cost = -1;  ///< not computed yet
  };

  double asked(std::size_t from, std::size_t to) {
    if (near_[from].empty()) find_near(from);
    for (auto& near : near_[from]) {
      if (near.state != to) continue;
      if (near.cost < 0) near.cost = question_.travel(steps_[from], steps_[to]);
      return near.cost;
    }
    return question_.far_travel(steps_[from], steps_[to]);
  }

  const VisitWay& way(std::size_t state) const {
    return question_.visits[steps_[state].visit].ways[steps_[state].way];
  }

  /// The states of other visits with beginnings nearest to the end of this one.
  void find_near(std::size_t from) {
    all_.clear();
    for (std::size_t s = 0; s < states(); ++s) {
      if (steps_[s].visit != steps_[from].visit)
        all_.push_back({s, norm_squared(way(s).begin - way(from).end), -1});
    }
    const auto kept = std::min(kMostNear, std::ssize(all_));
    if (kept < std::ssize(all_)) {
      std::nth_element(all_.begin(), all_.begin() + kept, all_.end(), [](const Near& a, const Near& b) {
        return a.away != b.away ? a.away < b.away : a.state < b.state;
      });
    }
    near_[from].assign(all_.begin(),
                       all_.begin() + kept);  // no room beyond: there are as many lists as states
  }

  const VisitQuestion& question_;
  std::vector<VisitStep> steps_;
  std::vector<std::size_t> first_;
  std::vector<std::vector<Near>> near_;
  std::vector<Near> all_;      ///< neighbours of the current state
  std::vector<double> known_;  ///< from each state to each; below 0: not computed yet
};

/// Visits required before and after each visit.
class VisitPrecedence {
 public:
  explicit VisitPrecedence(const VisitQuestion& question)
      : before_(question.visits.size()), after_(question.visits.size()) {
    for (const auto& [first, second] : question.precedence) add(first, second);
    for (std::size_t v = 1; question.fixed_first && v < before_.size(); ++v) add(0, v);
  }

  const Order& before(std::size_t visit) const { return before_[visit]; }
  const Order& after(std::size_t visit) const { return after_[visit]; }
  bool has(std::size_t first, std::size_t second) const {
    return std::find(after_[first].begin(), after_[first].end(), second) != after_[first].end();
  }

 private:
  void add(std::size_t first, std::size_t second) {
    after_[first].push_back(second);
    before_[second].push_back(first);
  }

  std::vector<Order> before_;
  std::vector<Order> after_;
};

std::vector<VisitStep> steps_of(const States& states, const Costs& costs) {
  std::vector<VisitStep> steps;
  for (const std::size_t state : states) steps.push_back(costs.step(state));
  return steps;
}

/// Held and Karp's dynamic programme over sets of visits.
States exact_order(Costs& costs, const VisitPrecedence& precedence) {
  const std::size_t n = costs.visits(), states = costs.states(), sets = std::size_t{1} << n;
  std::vector<std::size_t> needed(n, 0);
  for (std::size_t v = 0; v < n; ++v) {
    for (const std::size_t b : precedence.before(v)) needed[v] |= std::size_t{1} << b;
  }
  std::vector<double> best(sets * states, kNotReached);
  std::vector<std::size_t> came_from(sets * states, states);
  for (std::size_t s = 0; s < states; ++s) {
    const std::size_t visit = costs.step(s).visit;
    if (needed[visit] == 0) best[(std::size_t{1} << visit) * states + s] = costs.own(s);
  }
  for (std::size_t set = 1; set < sets; ++set) {
    for (std::size_t s = 0; s < states; ++s) {
      const double so_far = best[set * states + s];
      if (so_far == kNotReached) continue;
      for (std::size_t next = 0; next < states; ++next) {
        const std::size_t visit = costs.step(next).visit, bit = std::size_t{1} << visit;
        if ((set & bit) || (needed[visit] & ~set)) continue;
        const double cost = so_far + costs.travel(s, next) + costs.own(next);
        double& known = best[(set | bit) * states + next];
        if (cost >= known) continue;
        known = cost;
        came_from[(set | bit) * states + next] = s;
      }
    }
  }
  std::size_t set = sets - 1, at = 0;
  for (std::size_t s = 1; s < states; ++s) {
    if (best[set * states + s] < best[set * states + at]) at = s;
  }
  States order;
  while (at < states) {
    order.push_back(at);
    const std::size_t before = came_from[set * states + at];
    set &= ~(std::size_t{1} << costs.step(at).visit);
    at = before;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

struct Choice {
  double cost = kNotReached;
  States states;
};

/// The best ways for a given order of visits.
Choice best_ways(const Order& order, Costs& costs) {
  std::vector<double> cost(costs.states(), kNotReached);
  std::vector<std::size_t> from(costs.states(), costs.states());
  const auto each_way = [&](std::size_t visit, const auto& work) {
    for (std::size_t s = costs.first(visit); s < costs.first(visit) + costs.ways(visit); ++s) work(s);
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    each_way(order[i], [&](std::size_t s) {
      double best = i == 0 ? 0 : kNotReached;
      if (i > 0) {
        each_way(order[i - 1], [&](std::size_t u) {
          const double c = cost[u] + costs.travel(u, s);
          if (c >= best) return;
          best = c;
          from[s] = u;
        });
      }
      cost[s] = best + costs.own(s);
    });
  }
  Choice result;
  std::size_t at = costs.states();
  each_way(order.back(), [&](std::size_t s) {
    if (cost[s] >= result.cost) return;
    result.cost = cost[s];
    at = s;
  });
  for (std::size_t i = order.size(); i-- > 0; at = from[at]) result.states.push_back(at);
  std::reverse(result.states.begin(), result.states.end());
  return result;
}

Order nearest_first(Costs& costs, const VisitPrecedence& precedence) {
  const std::size_t n = costs.visits();
  std::vector<std::size_t> waiting(n);
  for (std::size_t v = 0; v < n; ++v) waiting[v] = precedence.before(v).size();
  std::vector<bool> done(n, false);
  Order order;
  std::size_t at = 0;
  const auto take = [&](std::size_t state) {
    const std::size_t visit = costs.step(state).visit;
    done[visit] = true;
    for (const std::size_t later : precedence.after(visit)) --waiting[later];
    order.push_back(visit);
    at = state;
  };
  const auto first =
      static_cast<std::size_t>(std::find(waiting.begin(), waiting.end(), 0u) - waiting.begin());
  CLEARCUT_ASSERT(first < n);
  take(costs.first(first));
  while (order.size() < n) {
    std::size_t best = 0;
    double best_cost = kNotReached;
    for (std::size_t s = 0; s < costs.states(); ++s) {
      const std::size_t visit = costs.step(s).visit;
      if (done[visit] || waiting[visit] > 0) continue;
      const double cost = costs.travel(at, s);
      if (cost >= best_cost) continue;
      best_cost = cost;
      best = s;
    }
    CLEARCUT_ASSERT(best_cost < kNotReached);
    take(best);
  }
  return order;
}

/// The order with `count` visits from place `from` on put before place `to` of the rest.
Order moved(const Order& order, std::size_t from, std::size_t count, std::size_t to) {
  const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  Order rest(order.begin(), at(from));
  rest.insert(rest.end(), at(from + count), order.end());
  rest.insert(rest.begin() + static_cast<std::ptrdiff_t>(to), at(from), at(from + count));
  return rest;
}

/// Searches better orders near the current one. Places are those of visits in the order.
class Improver {
 public:
  Improver(Costs& costs, const VisitPrecedence& precedence, Order order)
      : costs_(costs), precedence_(precedence), order_(std::move(order)), best_(best_ways(order_, costs)) {}

  States improved() {
    const bool ways = order_.size() <= kMostWithWays;
    bool better = order_.size() <= kMostImproved;
    for (int round = 0; better && round < kRounds; ++round) {
      better = false;
      place_visits();
      for (std::size_t count = 1; count <= kLongestMoved; ++count) better |= move_stretches(count, ways);
      if (ways) better |= turn_stretches();
      if (!ways) best_ = best_ways(order_, costs_);
    }
    return best_.states;
  }

 private:
  bool move_stretches(std::size_t count, bool ways) {
    bool better = false;
    for (std::size_t from = 0; from + count <= order_.size(); ++from) {
      const auto [least, most] = places_for(from, count);
      for (std::size_t to = least; to <= most; ++to) {
        if (to == from || !(ways ? try_order(moved(order_, from, count, to)) : try_shift(from, count, to)))
          continue;
        better = true;
        break;  // another stretch is at this place now
      }
    }
    return better;
  }

  bool turn_stretches() {
    bool better = false;
    for (std::size_t from = 0; from + 1 < order_.size(); ++from) {
      for (std::size_t end = from + 2; end <= order_.size() && may_follow_all(from, end - 1); ++end) {
        Order turned = order_;
        std::reverse(turned.begin() + static_cast<std::ptrdiff_t>(from),
                     turned.begin() + static_cast<std::ptrdiff_t>(end));
        if (!try_order(std::move(turned))) continue;
        better = true;
        break;
      }
    }
    return better;
  }

  /// Whether the visit at `last` need not come after any visit between `from` and itself.
  bool may_follow_all(std::size_t from, std::size_t last) const {
    for (std::size_t i = from; i < last; ++i) {
      if (precedence_.has(order_[i], order_[last])) return false;
    }
    return true;
  }

  /// Places in the rest to which the stretch may be moved: after all its predecessors, before all its successors.
  std::pair<std::size_t, std::size_t> places_for(std::size_t from, std::size_t count) const {
    std::size_t least = 0, most = order_.size() - count;
    for (std::size_t i = from; i < from + count; ++i) {
      for (const std::size_t v : precedence_.before(order_[i])) {
        if (place_[v] < from) least = std::max(least, place_[v] + 1);
      }
      for (const std::size_t v : precedence_.after(order_[i])) {
        if (place_[v] >= from + count) most = std::min(most, place_[v] - count);
      }
    }
    return {least, most};
  }

  bool try_order(Order order) {
    Choice choice = best_ways(order, costs_);
    if (choice.cost >= best_.cost - kGain) return false;
    order_ = std::move(order);
    best_ = std::move(choice);
    place_visits();
    return true;
  }

  /// The same for a moved stretch, with unchanged ways.
  bool try_shift(std::size_t from, std::size_t count, std::size_t to) {
    States& states = best_.states;
    const std::size_t end = from + count, before = to > from ? to + count - 1 : to - 1,
                      after = to > from ? to + count : to;
    const double gap = gap_cost(from - 1, end), old = gap_cost(from - 1, from) + gap_cost(end - 1, end);
    const double place = gap_cost(before, from) + gap_cost(end - 1, after) - gap_cost(before, after);
    if (gap + place >= old - kGain) return false;
    states = moved(states, from, count, to);
    order_ = moved(order_, from, count, to);
    best_.cost += gap + place - old;
    place_visits();
    return true;
  }

  /// From one place to another, nothing before the first and after the last.
  double gap_cost(std::size_t from, std::size_t to) {
    if (from >= order_.size() || to >= order_.size()) return 0;  // -1 wraps round
    return costs_.travel(best_.states[from], best_.states[to]);
  }

  void place_visits() {
    place_.resize(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) place_[order_[i]] = i;
  }

  Costs& costs_;
  const VisitPrecedence& precedence_;
  Order order_;
  Choice best_;
  std::vector<std::size_t> place_;
};

bool few_enough(const Costs& costs) {
  const std::size_t n = costs.visits();
  return n <= kMostExact && (std::size_t{1} << n) * costs.states() <= kMostEntries;
}

}  // namespace

std::vector<VisitStep> order_visits(const VisitQuestion& question) {
  if (question.visits.empty()) return {};
  Costs costs(question);
  const VisitPrecedence precedence(question);
  if (few_enough(costs)) return steps_of(exact_order(costs, precedence), costs);
  Order order(costs.visits());
  std::iota(order.begin(), order.end(), 0u);
  if (!question.ordered_before) order = nearest_first(costs, precedence);
  return steps_of(Improver(costs, precedence, std::move(order)).improved(), costs);
}

}  // namespace clearcut::order
