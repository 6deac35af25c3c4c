// Order of pieces of work (areas, cells, passes), and the way of doing each.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::order {

/// One way of doing a piece of work: its start, its end, and its own cost.
struct VisitWay {
  Vec2 begin;
  Vec2 end;
  double own = 0;
};

/// A piece of work; it has at least one way.
struct Visit {
  std::vector<VisitWay> ways;
};

/// The next piece and the way of doing it.
struct VisitStep {
  std::size_t visit = 0;
  std::size_t way = 0;
  friend bool operator==(const VisitStep&, const VisitStep&) = default;
};

struct VisitQuestion {
  std::vector<Visit> visits;
  /// Cost of going from the end of one to the beginning of the next. Any unit.
  std::function<double(const VisitStep& from, const VisitStep& to)> travel;
  /// The same, no less and quicker to ask: for places far apart.
  std::function<double(const VisitStep& from, const VisitStep& to)> far_travel;
  std::vector<std::pair<std::size_t, std::size_t>> precedence{};  ///< first comes before second; no circles
  bool fixed_first = false;                                       ///< visit 0 comes first
  bool ordered_before = false;  ///< the listed order is valid, and kept unless another is cheaper
};

/// All visits once, cheap in sum, precedence kept.
///
/// Method  Up to nine visits: proven best, by dynamic programming over sets [held1962]. More: nearest first, or as
///         listed, then stretches of up to three are moved to better places and longer ones reversed while this saves
///         cost. For each order the ways are chosen best by dynamic programming along it; beyond 60 visits they are
///         chosen between rounds.
/// Cost    O(2^n n^2) up to nine visits, O(n^3) a round up to 60, O(n^2) a round up to 1000; longer lists keep the
///         order found. `travel` is called O(n) times, for the nearest places.
std::vector<VisitStep> order_visits(const VisitQuestion& question);

}  // namespace clearcut::order
