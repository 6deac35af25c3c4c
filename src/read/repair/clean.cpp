#include "read/repair/clean.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "read/repair/repair.h"

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

namespace {

/// Runs with a smaller bow are straight, mm.
constexpr double kStraight = 2 * kArcVertexTolerance;
/// One arc sweeps at most this, radians: its three defining points stay well apart.
constexpr double kWidestArc = 1.9 * kPi;

/// The lines of a loop from a place on, replaced by arcs if possible.
class Finder {
 public:
  explicit Finder(const Loop& loop) : loop_(loop) {}

  Loop run() {
    if (auto whole = circle()) return *whole;
    rotate_to_longest();
    Loop out;
    for (std::size_t i = 0; i < loop_.size();) {
      const std::size_t count = longest_run(i);
      if (count >= kFewestChords) {
        out.push_back(*arc(i, count));
        i += count;
      } else {
        out.push_back(loop_[i++]);
      }
    }
    return out;
  }

 private:
  /// The loop begins with its longest edge, so that no arc is cut in two by its start.
  void rotate_to_longest() {
    std::rotate(loop_.begin(),
                std::max_element(loop_.begin(), loop_.end(),
                                 [](const Edge& a, const Edge& b) { return a.length() < b.length(); }),
                loop_.end());
  }

  /// Number of lines from `first` on replaceable by one arc: by doubling while possible, then bisection.
  std::size_t longest_run(std::size_t first) const {
    std::size_t good = 0, bad = loop_.size() - first + 1;
    for (std::size_t count = kFewestChords; count < bad; count *= 2) {
      if (!arc(first, count)) {
        bad = count;
        break;
      }
      good = count;
    }
    if (good == 0) return 0;
    while (bad - good > 1) {
      const std::size_t middle = (good + bad) / 2;
      (arc(first, middle) ? good : bad) = middle;
    }
    return good;
  }

  /// The arc in place of `count` lines from `first`, if it fits them.
  std::optional<Edge> arc(std::size_t first, std::size_t count) const {
    const Vec2 from = loop_[first].from, to = loop_[first + count - 1].to;
    if (from == to) return std::nullopt;
    const Edge candidate = arc_through(from, loop_[first + count / 2].from, to);
    if (!candidate.is_arc() || std::abs(candidate.sweep()) > kWidestArc) return std::nullopt;
    if (distance(candidate.at(0.5), lerp(from, to, 0.5)) < kStraight) return std::nullopt;
    return lies_on(candidate, first, count) ? std::optional(candidate) : std::nullopt;
  }

  bool lies_on(const Edge& arc, std::size_t first, std::size_t count) const {
    const double radius = arc.radius(), turn = arc.turn == Turn::kCounterClockwise ? 1 : -1;
    double sweep = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      const Edge& line = loop_[i];
      if (line.is_arc()) return false;
      const Vec2 u = line.from - arc.center, v = line.to - arc.center;
      if (std::abs(norm(v) - radius) > kArcVertexTolerance) return false;
      if (std::abs(norm((u + v) / 2.0) - radius) > kArcChordTolerance) return false;
      const double step = turn * base::atan2(cross(u, v), dot(u, v));
      if (!(step > 0)) return false;
      sweep += step;
    }
    return sweep < 2 * kPi + 1e-6;
  }

  /// The circle if the whole loop is on one.
  std::optional<Loop> circle() const {
    const std::size_t n = loop_.size();
    if (n < kFewestChords) return std::nullopt;
    const Edge whole = arc_through(loop_[0].from, loop_[n / 3].from, loop_[2 * n / 3].from);
    if (!whole.is_arc() || !lies_on(whole, 0, n)) return std::nullopt;
    const Path found = full_circle(whole.center, whole.radius());
    return whole.turn == Turn::kCounterClockwise ? found : reversed(found);
  }

  Loop loop_;
};

}  // namespace

void find_arcs(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics) {
  std::size_t lines = 0, arcs = 0;
  for (RawLoop& raw : loops) {
    Loop found = Finder(raw.loop).run();
    if (found.size() == raw.loop.size()) continue;
    const auto is_arc = [](const Edge& edge) { return edge.is_arc(); };
    const auto count = [&](const Loop& loop) {
      return static_cast<std::size_t>(std::count_if(loop.begin(), loop.end(), is_arc));
    };
    const std::size_t new_arcs = count(found) - count(raw.loop);
    arcs += new_arcs;
    lines += raw.loop.size() - (found.size() - new_arcs);
    raw.loop = std::move(found);
  }
  if (arcs == 0) return;
  diagnostics.repair(options.where, std::to_string(lines) + " short lines became " + std::to_string(arcs) +
                                        " arcs, none moved by more than " + short_number(kArcChordTolerance) +
                                        " mm");
}

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
