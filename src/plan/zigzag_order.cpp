#include "plan/zigzag_order.h"

#include <algorithm>
#include <array>
#include <limits>

namespace clearcut {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostExact = 9;
/// Rounds of improvement; each looks at every stretch in every place.
constexpr int kRounds = 4;
/// Beyond this many cells the nearest-first order stays.
constexpr std::size_t kMostImproved = 60;

/// Ways are looked for to so many beginnings of cells near the end of each.
constexpr std::ptrdiff_t kMostNear = 24;

using Order = std::vector<std::size_t>;

/// All costs, asked for once.
class Costs {
 public:
  Costs(const std::vector<ZigzagCell>& cells, const OrderQuestion& question)
      : question_(question), count_(cells.size()) {
    for (std::size_t cell = 0; cell < count_; ++cell) {
      for (int variant = 0; variant < kCellVariants; ++variant) {
        const auto lines = cut_lines(cells[cell], variant);
        begin_.push_back(lines.front().left);
        end_.push_back(lines.back().right);
        own_.push_back(question.own({cell, variant}));
      }
    }
    near_.resize(begin_.size());
  }

  std::size_t cells() const { return count_; }
  double own(std::size_t state) const { return own_[state]; }
  /// States are cell * kCellVariants + variant.
  double travel(std::size_t from, std::size_t to) {
    if (near_[from].empty()) find_near(from);
    for (auto& near : near_[from]) {
      if (near.state != to) continue;
      if (near.cost < 0) near.cost = question_.travel(end_[from], begin_[to]);
      return near.cost;
    }
    return question_.far_travel(end_[from], begin_[to]);
  }

 private:
  struct Near {
    std::size_t state = 0;
    double away = 0;
    double cost = -1;  ///< not asked for yet
  };

  /// The states of other cells that begin nearest to where this one ends.
  void find_near(std::size_t from) {
    auto& near = near_[from];
    for (std::size_t s = 0; s < begin_.size(); ++s) {
      if (s / kCellVariants != from / kCellVariants)
        near.push_back({s, norm_squared(begin_[s] - end_[from]), -1});
    }
    if (near.size() <= static_cast<std::size_t>(kMostNear)) return;
    std::nth_element(near.begin(), near.begin() + kMostNear, near.end(), [](const Near& a, const Near& b) {
      return a.away != b.away ? a.away < b.away : a.state < b.state;
    });
    near.resize(static_cast<std::size_t>(kMostNear));
  }

  const OrderQuestion& question_;
  std::size_t count_;
  std::vector<Vec2> begin_;
  std::vector<Vec2> end_;
  std::vector<double> own_;
  std::vector<std::vector<Near>> near_;
};

CellVisit visit_of(std::size_t state) {
  return {state / kCellVariants, static_cast<int>(state % kCellVariants)};
}

/// Held and Karp's dynamic programme over sets of cells.
std::vector<CellVisit> exact_order(Costs& costs) {
  const std::size_t n = costs.cells(), states = n * kCellVariants, sets = std::size_t{1} << n;
  std::vector<double> best(sets * states, kInfinity);
  std::vector<std::size_t> came_from(sets * states, states);
  for (std::size_t s = 0; s < states; ++s)
    best[(std::size_t{1} << (s / kCellVariants)) * states + s] = costs.own(s);
  for (std::size_t set = 1; set < sets; ++set) {
    for (std::size_t s = 0; s < states; ++s) {
      const double so_far = best[set * states + s];
      if (so_far == kInfinity) continue;
      for (std::size_t next = 0; next < states; ++next) {
        const std::size_t bit = std::size_t{1} << (next / kCellVariants);
        if (set & bit) continue;
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
  std::vector<CellVisit> order;
  while (at < states) {
    order.push_back(visit_of(at));
    const std::size_t before = came_from[set * states + at];
    set &= ~(std::size_t{1} << (at / kCellVariants));
    at = before;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

struct Variants {
  double cost = 0;
  std::vector<std::size_t> states;
};

/// The best ways of cutting for a given order of cells.
Variants best_variants(const Order& order, Costs& costs) {
  std::vector<std::array<double, kCellVariants>> cost(order.size());
  std::vector<std::array<int, kCellVariants>> from(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (int v = 0; v < kCellVariants; ++v) {
      const std::size_t state = order[i] * kCellVariants + static_cast<std::size_t>(v);
      double best = i == 0 ? 0 : kInfinity;
      for (int u = 0; i > 0 && u < kCellVariants; ++u) {
        const double c = cost[i - 1][static_cast<std::size_t>(u)] +
                         costs.travel(order[i - 1] * kCellVariants + static_cast<std::size_t>(u), state);
        if (c >= best) continue;
        best = c;
        from[i][static_cast<std::size_t>(v)] = u;
      }
      cost[i][static_cast<std::size_t>(v)] = best + costs.own(state);
    }
  }
  const auto last = std::min_element(cost.back().begin(), cost.back().end());
  Variants result{*last, {}};
  int v = static_cast<int>(last - cost.back().begin());
  for (std::size_t i = order.size(); i-- > 0;) {
    result.states.push_back(order[i] * kCellVariants + static_cast<std::size_t>(v));
    v = from[i][static_cast<std::size_t>(v)];
  }
  std::reverse(result.states.begin(), result.states.end());
  return result;
}

Order nearest_first(Costs& costs) {
  std::vector<bool> done(costs.cells(), false);
  Order order{0};
  done[0] = true;
  std::size_t at = 0;
  while (order.size() < costs.cells()) {
    std::size_t best = 0;
    double best_cost = kInfinity;
    for (std::size_t s = 0; s < costs.cells() * kCellVariants; ++s) {
      if (done[s / kCellVariants]) continue;
      const double cost = costs.travel(at, s);
      if (cost >= best_cost) continue;
      best_cost = cost;
      best = s;
    }
    order.push_back(best / kCellVariants);
    done[best / kCellVariants] = true;
    at = best;
  }
  return order;
}

/// The order with a stretch taken out and put in elsewhere.
Order moved(const Order& order, std::size_t from, std::size_t count, std::size_t to) {
  Order rest(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(from));
  rest.insert(rest.end(), order.begin() + static_cast<std::ptrdiff_t>(from + count), order.end());
  rest.insert(rest.begin() + static_cast<std::ptrdiff_t>(to),
              order.begin() + static_cast<std::ptrdiff_t>(from),
              order.begin() + static_cast<std::ptrdiff_t>(from + count));
  return rest;
}

std::vector<CellVisit> improved_order(Costs& costs) {
  Order order = nearest_first(costs);
  Variants best = best_variants(order, costs);
  const std::size_t n = order.size();
  bool better = n <= kMostImproved;
  for (int round = 0; better && round < kRounds; ++round) {
    better = false;
    for (std::size_t count = 1; count <= 3; ++count) {
      for (std::size_t from = 0; from + count <= n; ++from) {
        for (std::size_t to = 0; to + count <= n; ++to) {
          if (to == from) continue;
          Order candidate = moved(order, from, count, to);
          Variants variants = best_variants(candidate, costs);
          if (variants.cost >= best.cost - 1e-9) continue;
          order = std::move(candidate);
          best = std::move(variants);
          better = true;
        }
      }
    }
  }
  std::vector<CellVisit> visits;
  for (const std::size_t state : best.states) visits.push_back(visit_of(state));
  return visits;
}

}  // namespace

std::vector<ZigzagLine> cut_lines(const ZigzagCell& cell, int variant) {
  auto lines = cell.lines;
  if (variant & 1) std::reverse(lines.begin(), lines.end());
  bool leftwards = (variant & 2) != 0;
  for (auto& line : lines) {
    if (leftwards) std::swap(line.left, line.right);
    leftwards = !leftwards;
  }
  return lines;
}

std::vector<CellVisit> order_cells(const std::vector<ZigzagCell>& cells, const OrderQuestion& question) {
  if (cells.empty()) return {};
  Costs costs(cells, question);
  return cells.size() <= kMostExact ? exact_order(costs) : improved_order(costs);
}

}  // namespace clearcut
