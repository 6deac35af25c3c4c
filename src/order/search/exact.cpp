#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "order/search/solve.h"

namespace clearcut::order {

namespace {

constexpr double kNoOrder = std::numeric_limits<double>::infinity();

bool has_corners(const Objective& objective) {
  const Objective::Linear l = objective.linear();
  return !l.exact || l.turns > 0 || l.angle > 0;
}

/// Dynamic program over (visited set, last but one, last). Without corners the last but one is left out.
class SubsetProgram {
 public:
  SubsetProgram(const Moves& moves, const Objective& objective)
      : problem_(moves.problem()), n_(problem_.size()), width_(has_corners(objective) ? n_ : 1) {
    edge_.resize(static_cast<std::size_t>(n_ * n_));
    corner_.assign(static_cast<std::size_t>(width_ > 1 ? n_ * n_ * n_ : 0), 0.0);
    before_.assign(static_cast<std::size_t>(n_), 0U);
    for (int a = 0; a < n_; ++a) {
      for (int b = 0; b < n_; ++b) {
        if (a != b) edge_[a * n_ + b] = objective.edge(moves, a, b);
        for (int c = 0; c < n_ && width_ > 1; ++c) {
          if (a != b && b != c && a != c) corner_[(a * n_ + b) * n_ + c] = objective.corner(moves, a, b, c);
        }
      }
    }
    for (const Precedence& p : problem_.precedence) before_[p.after] |= 1U << p.before;
  }

  /// Best open path.
  ExactResult best_path() {
    reset(-1, -1);
    for (int v = 0; v < n_; ++v) {
      const bool may_begin = problem_.start < 0 ? v != problem_.end || n_ == 1 : v == problem_.start;
      if (may_begin && before_[v] == 0) value_[state(1U << v, v, v)] = 0;
    }
    for (unsigned visited = 1; visited < (1U << n_); ++visited) extend(visited);
    return trace_back();
  }

  /// Best closed tour beginning with `first` and, unless -1, `second`.
  ExactResult best_tour(int first, int second) {
    reset(first, second);
    unsigned begin = 1U << first;
    if (second >= 0) begin |= 1U << second;
    if (second < 0) value_[state(begin, first, first)] = 0;
    if (second >= 0) value_[state(begin, first, second)] = edge_[first * n_ + second];
    for (unsigned visited = begin; visited < (1U << n_); ++visited) {
      if ((visited & begin) == begin) extend(visited);
    }
    return trace_back();
  }

 private:
  void reset(int first, int second) {
    value_.assign((std::size_t{1} << n_) * static_cast<std::size_t>(width_ * n_), kNoOrder);
    first_ = first;
    second_ = second;
  }
  std::size_t state(unsigned visited, int previous, int last) const {
    const int p = width_ > 1 ? previous : 0;
    return (static_cast<std::size_t>(visited) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(p)) *
               static_cast<std::size_t>(n_) +
           static_cast<std::size_t>(last);
  }
  double corner(int a, int b, int c) const {
    return width_ > 1 && a != b && b != c && a != c ? corner_[(a * n_ + b) * n_ + c] : 0;
  }

  void extend(unsigned visited) {
    for (int previous = 0; previous < width_; ++previous) {
      for (int last = 0; last < n_; ++last) {
        const double value = value_[state(visited, previous, last)];
        if (value == kNoOrder) continue;
        for (int next = 0; next < n_; ++next) {
          const unsigned with = visited | 1U << next;
          if (with == visited || (before_[next] & ~visited) != 0) continue;
          if (next == problem_.end && with != (1U << n_) - 1) continue;
          double& best = value_[state(with, last, next)];
          best = std::min(best, value + edge_[last * n_ + next] + corner(previous, last, next));
        }
      }
    }
  }

  double closing(int previous, int last) const {
    if (!problem_.closed()) return problem_.end >= 0 && last != problem_.end ? kNoOrder : 0;
    if (n_ < 2) return 0;
    const double back = edge_[last * n_ + first_] + corner(previous, last, first_);
    return back + (second_ >= 0 ? corner(last, first_, second_) : 0);
  }

  ExactResult trace_back() const {
    unsigned visited = (1U << n_) - 1;
    ExactResult result{{}, kNoOrder};
    int last = -1, previous = -1;
    for (int p = 0; p < width_; ++p) {
      for (int l = 0; l < n_; ++l) {
        const double value = value_[state(visited, p, l)] + closing(p, l);
        if (value < result.value) {
          result.value = value;
          last = l;
          previous = p;
        }
      }
    }
    while (last >= 0) {
      result.tour.push_back(last);
      std::tie(visited, previous, last) = predecessor(visited, previous, last);
    }
    std::reverse(result.tour.begin(), result.tour.end());
    return result;
  }

  /// The predecessor state that gave the value of this one; last = -1 at the beginning.
  std::tuple<unsigned, int, int> predecessor(unsigned visited, int previous, int last) const {
    const unsigned without = visited & ~(1U << last);
    if (without == 0) return {0U, -1, -1};
    if (second_ >= 0 && without == (1U << first_)) return {without, first_, first_};
    const double value = value_[state(visited, previous, last)];
    double best = kNoOrder;
    std::tuple<unsigned, int, int> result{0U, -1, -1};
    for (int p = 0; p < width_; ++p) {
      for (int l = 0; l < n_; ++l) {
        if ((without >> l & 1U) == 0 || (width_ > 1 && l != previous)) continue;
        const double candidate = value_[state(without, p, l)] + edge_[l * n_ + last] + corner(p, l, last);
        if (std::abs(candidate - value) < best) {
          best = std::abs(candidate - value);
          result = {without, p, l};
        }
      }
    }
    return result;
  }

  const Problem& problem_;
  int n_, width_;
  int first_ = 0, second_ = -1;
  std::vector<double> edge_, corner_, value_;
  std::vector<unsigned> before_;
};

ExactResult by_subsets(const Moves& moves, const Objective& objective) {
  const Problem& problem = moves.problem();
  SubsetProgram program(moves, objective);
  ExactResult best{{}, kNoOrder};
  if (!problem.closed()) {
    best = program.best_path();
  } else if (!has_corners(objective) || problem.size() < 3) {
    best = program.best_tour(0, -1);
  } else {
    for (int second = 1; second < problem.size(); ++second) {
      ExactResult result = program.best_tour(0, second);
      if (result.value < best.value) best = std::move(result);
    }
  }
  best.value += objective.constant();
  return best;
}

ExactResult by_enumeration(const Moves& moves, const Objective& objective) {
  const Problem& problem = moves.problem();
  Tour tour(problem.points.size());
  std::iota(tour.begin(), tour.end(), 0);
  ExactResult best{{}, kNoOrder};
  do {
    if (!is_valid(problem, tour)) continue;
    const double value = evaluate(objective, moves, tour);
    if (value < best.value) best = {tour, value};
  } while (std::next_permutation(tour.begin(), tour.end()));
  return best;
}

}  // namespace

int exact_limit(const Problem& problem, const Objective& objective) {
  if (objective.path_dependent()) return 8;
  if (!has_corners(objective)) return 14;
  return problem.closed() ? 10 : 12;
}

std::optional<ExactResult> solve_exact(const Moves& moves, const Objective& objective) {
  if (moves.problem().size() > exact_limit(moves.problem(), objective)) return std::nullopt;
  return objective.path_dependent() ? by_enumeration(moves, objective) : by_subsets(moves, objective);
}

}  // namespace clearcut::order
