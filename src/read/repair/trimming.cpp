#include "read/repair/trimming.h"

#include <optional>

#include "base/tolerances.h"
#include "read/repair/mends.h"

namespace clearcut::read {
namespace {

/// mm. Slivers thinner than this are rounding: they stay.
constexpr double kRounding = 1e-7;

struct Trim {
  Vec2 at;
  double thickness = 0;
};

/// The meeting of `a` and the following `b` away from their joints.
std::optional<Trim> second_meeting(const Edge& a, const Edge& b) {
  if (!a.is_arc() && !b.is_arc()) return std::nullopt;
  for (const Vec2 place : intersections(a, b)) {
    if (distance(place, a.to) <= kSamePlaceMm || distance(place, a.from) <= kSamePlaceMm ||
        distance(place, b.to) <= kSamePlaceMm) {
      continue;
    }
    const Edge cut_a = a.part(nearest(a, place).t, 1), cut_b = b.part(0, nearest(b, place).t);
    const double thickness = std::max(distance(b, cut_a.at(0.5)), distance(a, cut_b.at(0.5)));
    if (thickness > kRounding) return Trim{place, thickness};
  }
  return std::nullopt;
}

}  // namespace

void trim_joints(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics) {
  Mends trims("neighbours that cross near their joint were joined at the crossing: a sliver");
  for (RawLoop& raw : loops) {
    Loop& loop = raw.loop;
    for (std::size_t i = 0; loop.size() > 2 && i < loop.size(); ++i) {
      Edge& edge = loop[i];
      Edge& next = loop[(i + 1) % loop.size()];
      const auto trim = second_meeting(edge, next);
      if (!trim || trim->thickness > options.tol.join_gap) continue;
      trims.add(trim->at, trim->thickness);
      edge.to = next.from = trim->at;
    }
  }
  trims.report(options.where, diagnostics);
}

}  // namespace clearcut::read
