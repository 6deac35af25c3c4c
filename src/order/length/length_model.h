// Length in the form used by the fast searches: a closed tour with integer costs.
//
// - Costs are whole numbers: TSPLIB distances as they are, real distances in units of 2^-k mm, so that sums
// are
//   exact and an exchange without gain is distinguished from one that gains a rounding error.
// - Points are renumbered along a Hilbert curve: neighbours in the plane are neighbours in memory.
// - An open path is a closed tour through one more node at cost 0 from everywhere; a fixed end has a premium for
//   being next to that node, larger than any saving by a shorter path.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "order/length/neighbours.h"
#include "order/moves.h"
#include "order/problem.h"

namespace clearcut::order {

inline constexpr int kCandidates = 8;

class LengthModel {
 public:
  using Cost = std::int64_t;

  /// `candidates` per point, some from each quadrant; with detours the legally nearest of twice as many.
  /// `problem` must outlive the model; precedence is not kept.
  LengthModel(const Problem& problem, int candidates);

  int size() const { return size_; }
  Cost cost(int a, int b) const {
    if (a == extra_ || b == extra_) return extra_cost(a, b);
    const Cost straight = straight_cost(a, b);
    return moves_ ? detour_cost(a, b) : straight;
  }
  /// The cost if below `limit`, else any number of at least `limit`: avoids the search for detours.
  Cost cost_below(int a, int b, Cost limit) const {
    if (a == extra_ || b == extra_) return extra_cost(a, b);
    const Cost straight = straight_cost(a, b);
    return moves_ && straight < limit ? detour_cost(a, b) : straight;
  }
  std::span<const int> candidates(int v) const { return candidates_.of(v); }
  /// Costs of candidates(v), in the same order.
  std::span<const Cost> candidate_costs(int v) const {
    return {
        candidate_costs_.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(candidates_.count()),
        static_cast<std::size_t>(candidates_.count())};
  }
  int candidate_count() const { return candidates_.count(); }
  /// The node representing "outside" in open paths, -1 for closed tours.
  int extra_node() const { return extra_; }
  Vec2 point(int v) const { return points_[static_cast<std::size_t>(v)]; }

  /// `nodes` turned into a valid tour of the model by moving the extra node and the fixed ends together.
  std::vector<int> keeping_ends(std::vector<int> nodes) const;

  Cost tour_cost(std::span<const int> nodes) const;
  /// Length in the problem's unit of a tour cost (premiums taken out).
  double length(Cost cost) const;
  Cost to_cost(double length) const { return static_cast<Cost>(length * scale_ + 0.5); }
  /// Premium contained in every tour with its fixed ends kept.
  Cost premium() const { return premium_per_end_ * fixed_ends_; }
  bool has_premium() const { return fixed_ends_ > 0; }

  /// No two points at least `distance` mm apart cost less than this.
  double cost_bound(double distance) const { return distance * scale_ - 0.5; }
  /// The smallest whole cost not below `value`.
  Cost rounded_up(double value) const { return static_cast<Cost>(std::ceil(value)); }

  Tour to_problem(std::span<const int> nodes) const;
  std::vector<int> from_problem(std::span<const int> tour) const;

 private:
  Cost straight_cost(int a, int b) const {
    const Vec2 p = points_[static_cast<std::size_t>(a)], q = points_[static_cast<std::size_t>(b)];
    const double dx = p.x - q.x, dy = p.y - q.y;
    return static_cast<Cost>(std::sqrt(dx * dx + dy * dy) * scale_ + 0.5);
  }
  Cost extra_cost(int a, int b) const {
    const int other = a == extra_ ? b : a;
    return other == start_ || other == end_ ? -premium_per_end_ : 0;
  }
  Cost detour_cost(int a, int b) const;
  void choose_scale(const Problem& problem);
  void build_candidates(int count);
  void add_extra_node(const Problem& problem);
  /// The fixed ends, then points spread over the whole.
  std::vector<int> extra_candidates(int count) const;

  int size_ = 0;
  int extra_ = -1;
  int start_ = -1, end_ = -1;  // fixed ends as nodes
  int fixed_ends_ = 0;
  Cost premium_per_end_ = 0;
  double scale_ = 1;
  std::vector<Vec2> points_;
  std::vector<int> problem_index_;  // index in the problem by node
  Neighbours candidates_;
  std::vector<Cost> candidate_costs_;
  std::unique_ptr<Moves> moves_;  // null without detours
};

}  // namespace clearcut::order
