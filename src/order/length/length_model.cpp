#include "order/length/length_model.h"

#include <algorithm>
#include <numeric>

#include "base/elementary.h"
#include "base/error.h"
#include "geometry/box.h"

namespace clearcut::order {

namespace {

/// Position along a Hilbert curve of order 16 over the unit square.
std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y) {
  std::uint32_t index = 0;
  for (std::uint32_t s = 1U << 15; s > 0; s /= 2) {
    const std::uint32_t rx = (x & s) ? 1 : 0, ry = (y & s) ? 1 : 0;
    index += s * s * ((3 * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = s - 1 - (x & (s - 1));
        y = s - 1 - (y & (s - 1));
      }
      std::swap(x, y);
    }
    x &= s - 1;
    y &= s - 1;
  }
  return index;
}

std::vector<int> hilbert_order(const std::vector<Vec2>& points) {
  Box box;
  for (const Vec2 p : points) box.add(p);
  const double extent = std::max({box.width(), box.height(), 1e-300});
  std::vector<std::pair<std::uint32_t, int>> keyed;
  keyed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto cell = [&](double value) { return static_cast<std::uint32_t>(value / extent * 65535.0); };
    keyed.push_back(
        {hilbert_index(cell(points[i].x - box.min.x), cell(points[i].y - box.min.y)), static_cast<int>(i)});
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<int> order;
  order.reserve(points.size());
  for (const auto& k : keyed) order.push_back(k.second);
  return order;
}

}  // namespace

LengthModel::LengthModel(const Problem& problem, int candidates)
    : problem_index_(hilbert_order(problem.points)) {
  size_ = problem.size();
  points_.reserve(problem.points.size() + 1);
  for (const int i : problem_index_) points_.push_back(problem.points[static_cast<std::size_t>(i)]);
  choose_scale(problem);
  if (problem.detour) moves_ = std::make_unique<Moves>(problem);
  build_candidates(candidates);
  if (!problem.closed()) add_extra_node(problem);
}

void LengthModel::choose_scale(const Problem& problem) {
  if (problem.metric == Metric::kRoundedEuc2d) return;
  Box box;
  for (const Vec2 p : points_) box.add(p);
  // Sums of n edges stay below 2^50, so that the sums and twice the sums are exact; detours may be 100 times
  // longer.
  const double longest_sum = std::max(base::hypot(box.width(), box.height()), 1e-100) * (size_ + 1.0);
  scale_ = std::ldexp(1.0, static_cast<int>(std::floor(50 - base::log2(longest_sum))));
}

void LengthModel::build_candidates(int count) {
  if (!moves_) {
    candidates_ = quadrant_neighbours(points_, 2, count);
  } else {
    const Neighbours near = quadrant_neighbours(points_, 4, 2 * count);
    const int kept = std::min(count, near.count());
    std::vector<int> rows;
    for (int v = 0; v < size_; ++v) {
      std::vector<std::pair<Cost, int>> legal;
      for (const int w : near.of(v)) legal.push_back({detour_cost(v, w), w});
      std::sort(legal.begin(), legal.end());
      for (int i = 0; i < kept; ++i) rows.push_back(legal[static_cast<std::size_t>(i)].second);
    }
    candidates_ = Neighbours(std::move(rows), kept);
  }
  candidate_costs_.reserve(static_cast<std::size_t>(size_) * static_cast<std::size_t>(candidates_.count()));
  for (int v = 0; v < size_; ++v) {
    for (const int w : candidates_.of(v)) candidate_costs_.push_back(cost(v, w));
  }
}

void LengthModel::add_extra_node(const Problem& problem) {
  for (int v = 0; v < size_; ++v) {
    if (problem_index_[v] == problem.start) start_ = v;
    if (problem_index_[v] == problem.end) end_ = v;
  }
  fixed_ends_ = (start_ >= 0 ? 1 : 0) + (end_ >= 0 ? 1 : 0);
  Cost longest = 1;
  for (const Cost c : candidate_costs_) longest = std::max(longest, c);
  Box box;
  for (const Vec2 p : points_) box.add(p);
  longest = std::max(longest, to_cost(base::hypot(box.width(), box.height())));
  premium_per_end_ = fixed_ends_ == 0 ? 0 : longest * (size_ + 1);
  extra_ = size_++;
  points_.push_back({});

  // The extra node comes first in every list: it is the nearest node of all.
  const int old_count = candidates_.count(), count = old_count + 1;
  std::vector<int> rows;
  std::vector<Cost> costs;
  for (int v = 0; v < extra_; ++v) {
    rows.push_back(extra_);
    costs.push_back(cost(v, extra_));
    for (int i = 0; i < old_count; ++i) {
      rows.push_back(candidates_.of(v)[static_cast<std::size_t>(i)]);
      costs.push_back(candidate_costs_[static_cast<std::size_t>(v) * static_cast<std::size_t>(old_count) +
                                       static_cast<std::size_t>(i)]);
    }
  }
  const std::vector<int> ends = extra_candidates(count);
  for (const int v : ends) {
    rows.push_back(v);
    costs.push_back(cost(extra_, v));
  }
  candidates_ = Neighbours(std::move(rows), count);
  candidate_costs_ = std::move(costs);
}

std::vector<int> LengthModel::extra_candidates(int count) const {
  std::vector<int> ends;
  for (const int fixed : {start_, end_}) {
    if (fixed >= 0 && static_cast<int>(ends.size()) < count) ends.push_back(fixed);
  }
  for (int i = 0; i < count && static_cast<int>(ends.size()) < count; ++i) {
    const int v = static_cast<int>(static_cast<long long>(i) * extra_ / count);
    if (v != start_ && v != end_) ends.push_back(v);
  }
  while (static_cast<int>(ends.size()) < count) ends.push_back(ends.front());
  return ends;
}

LengthModel::Cost LengthModel::detour_cost(int a, int b) const {
  return to_cost(moves_->length(problem_index_[static_cast<std::size_t>(a)],
                                problem_index_[static_cast<std::size_t>(b)]));
}

LengthModel::Cost LengthModel::tour_cost(std::span<const int> nodes) const {
  Cost sum = nodes.size() > 1 ? cost(nodes.back(), nodes.front()) : 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) sum += cost(nodes[i - 1], nodes[i]);
  return sum;
}

double LengthModel::length(Cost cost) const {
  return static_cast<double>(cost + premium()) / scale_;
}

std::vector<int> LengthModel::keeping_ends(std::vector<int> nodes) const {
  if (extra_ < 0) return nodes;
  std::erase_if(nodes, [&](int v) { return v == extra_ || v == start_ || v == end_; });
  if (start_ >= 0) nodes.insert(nodes.begin(), start_);
  if (end_ >= 0) nodes.push_back(end_);
  nodes.push_back(extra_);
  return nodes;
}

Tour LengthModel::to_problem(std::span<const int> nodes) const {
  std::vector<int> turned(nodes.begin(), nodes.end());
  if (extra_ >= 0) {
    std::rotate(turned.begin(), std::find(turned.begin(), turned.end(), extra_), turned.end());
    turned.erase(turned.begin());
    const bool backwards = !turned.empty() && ((start_ >= 0 && turned.front() != start_) ||
                                               (end_ >= 0 && turned.back() != end_));
    if (backwards) std::reverse(turned.begin(), turned.end());
  }
  Tour tour;
  tour.reserve(turned.size());
  for (const int v : turned) tour.push_back(problem_index_[static_cast<std::size_t>(v)]);
  return tour;
}

std::vector<int> LengthModel::from_problem(std::span<const int> tour) const {
  std::vector<int> node_of(problem_index_.size());
  for (std::size_t v = 0; v < problem_index_.size(); ++v)
    node_of[static_cast<std::size_t>(problem_index_[v])] = static_cast<int>(v);
  std::vector<int> nodes;
  nodes.reserve(tour.size() + 1);
  if (extra_ >= 0) nodes.push_back(extra_);
  for (const int v : tour) nodes.push_back(node_of[static_cast<std::size_t>(v)]);
  return nodes;
}

}  // namespace clearcut::order
