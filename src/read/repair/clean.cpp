#include "read/repair/clean.h"

#include <cmath>

#include "base/error.h"
#include "base/tolerances.h"
#include "read/repair/mends.h"

namespace clearcut::read {
namespace {

/// Greatest difference of equal radii: the rounding of parts after reading is finer. mm.
constexpr double kSameRadii = 1e-8;

bool is_sane(Vec2 p) {
  return std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate;
}

/// The center moved to the perpendicular bisector of the chord, to make both radii equal.
Edge recentered(const Edge& arc) {
  const Vec2 chord = arc.to - arc.from;
  const Vec2 normal = unit(left_of(chord));
  const Vec2 middle = lerp(arc.from, arc.to, 0.5);
  return Edge::arc(arc.from, arc.to, middle + normal * dot(arc.center - middle, normal), arc.turn);
}

double flatness(const Edge& arc) {
  return distance(arc.at(0.5), lerp(arc.from, arc.to, 0.5));
}

struct Cleaning {
  const RepairOptions& options;
  Mends tiny{"an edge too short to mill was merged into its neighbours"};
  Mends radii{"an arc was given one center: its radii differed by a hair"};
};

/// One edge with agreeing radii; a full circle becomes two halves.
void append_consistent(const Edge& edge, const std::string& source, Cleaning& cleaning, Path& out) {
  if (!edge.is_arc()) return out.push_back(edge);
  const double r1 = distance(edge.from, edge.center), r2 = distance(edge.to, edge.center);
  if (edge.from == edge.to) {
    if (r1 <= kTinyEdge) return out.push_back(Edge::line(edge.from, edge.to));
    const Vec2 opposite = edge.center * 2 - edge.from;
    out.push_back(Edge::arc(edge.from, opposite, edge.center, edge.turn));
    out.push_back(Edge::arc(opposite, edge.to, edge.center, edge.turn));
    return;
  }
  const double off = std::abs(r1 - r2);
  if (off > cleaning.options.tol.join_gap) {
    throw InputError(cleaning.options.where, "the arc at " + place_text(edge.from) + " (" + source +
                                                 ") has radii " + short_number(r1) + " and " +
                                                 short_number(r2) + " mm at its ends; correct its center");
  }
  if (off > kSamePlaceMm) cleaning.radii.add(edge.from, off);
  const Edge mended = off > kSameRadii ? recentered(edge) : edge;
  out.push_back(flatness(mended) <= kSamePlaceMm ? Edge::line(edge.from, edge.to) : mended);
}

/// The path without edges below kTinyEdge. Vertices are unchanged: the next edge starts at the last
/// one kept, so a long run of tiny edges is followed by chords of about kTinyEdge.
Path without_tiny(const Path& path, Mends& tiny) {
  Path kept;
  kept.reserve(path.size());
  Vec2 at = path.front().from;
  for (const Edge& edge : path) {
    if (edge.length() < kTinyEdge) {
      if (edge.from != edge.to) tiny.add(edge.from, edge.length());
      if (distance(at, edge.to) < kTinyEdge) continue;
      kept.push_back(Edge::line(at, edge.to));
    } else if (distance(at, edge.to) < kTinyEdge && !edge.is_arc()) {
      continue;
    } else {
      kept.push_back(with_ends(edge, at, edge.to));
    }
    at = edge.to;
  }
  return kept;
}

}  // namespace

Edge arc_through(Vec2 from, Vec2 through, Vec2 to) {
  const Vec2 a = through - from, b = to - from;
  const double twice_area = cross(a, b);
  const double longest = std::max({norm(a), norm(b), norm(to - through)});
  if (longest == 0 || std::abs(twice_area) <= kSamePlaceMm * longest) return Edge::line(from, to);
  const Vec2 center = from + Vec2{b.y * norm_squared(a) - a.y * norm_squared(b),
                                  a.x * norm_squared(b) - b.x * norm_squared(a)} /
                                 (2 * twice_area);
  const Edge arc = Edge::arc(from, to, center, twice_area < 0 ? Turn::kClockwise : Turn::kCounterClockwise);
  return from == to ? arc : recentered(arc);
}

Edge with_ends(const Edge& edge, Vec2 from, Vec2 to) {
  if (edge.from == from && edge.to == to) return edge;
  if (!edge.is_arc()) return Edge::line(from, to);
  return arc_through(from, edge.at(0.5), to);
}

Loop without_tiny_edges(const Loop& loop) {
  Mends tiny{""};
  Loop kept = without_tiny(loop, tiny);
  if (kept.empty() || kept.back().to == kept.front().from) return kept;
  kept.back() = with_ends(kept.back(), kept.back().from, kept.front().from);
  return kept;
}

Path full_circle(Vec2 center, double radius) {
  const Vec2 right{center.x + radius, center.y}, left{center.x - radius, center.y};
  return {Edge::arc(right, left, center, Turn::kCounterClockwise),
          Edge::arc(left, right, center, Turn::kCounterClockwise)};
}

void check_numbers(const RawCurve& curve, const std::string& where) {
  for (const Edge& edge : curve.edges) {
    const bool finite = std::isfinite(edge.center.x) && std::isfinite(edge.center.y);
    if (finite && is_sane(edge.from) && is_sane(edge.to)) {
      if (!edge.is_arc() || edge.from == edge.to) continue;
      const Box box = edge.box();
      if (is_sane(box.min) && is_sane(box.max)) continue;
    }
    throw InputError(where, "a coordinate in " + curve.source +
                                " is not a number or lies beyond 1000 m; correct it, or check the unit");
  }
}

std::vector<RawCurve> clean(std::vector<RawCurve> curves, const RepairOptions& options,
                            Diagnostics& diagnostics) {
  Cleaning cleaning{options};
  std::vector<RawCurve> cleaned;
  cleaned.reserve(curves.size());
  for (RawCurve& curve : curves) {
    check_numbers(curve, options.where);
    if (curve.edges.empty()) continue;
    Path consistent;
    consistent.reserve(curve.edges.size());
    for (const Edge& edge : curve.edges) append_consistent(edge, curve.source, cleaning, consistent);
    curve.edges = without_tiny(consistent, cleaning.tiny);
    if (!curve.edges.empty()) cleaned.push_back(std::move(curve));
  }
  cleaning.tiny.report(options.where, diagnostics);
  cleaning.radii.report(options.where, diagnostics);
  return cleaned;
}

}  // namespace clearcut::read
