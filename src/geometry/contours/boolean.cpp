// Booleans by polyclipping. Arcs are flattened, clipped, and found again: the source arc of every piece of the result
// is known, because the ends of the piece are flattened points of that arc or are on its chords.
#include "geometry/contours/boolean.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <polyclipping/clipper.hpp>
#include <unordered_map>
#include <unordered_set>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "geometry/contours/nesting.h"
#include "geometry/spatial/box_tree.h"

namespace clearcut::inline geometry {
namespace {

using ClipperLib::IntPoint;

constexpr double kGridPerMm = 1e6;  // 1 nm
/// mm. Ends of an arc whose distances from its centre differ by no more are on its circle, as the grid rounds them.
constexpr double kOnCircle = 2e-6;

IntPoint to_grid(Vec2 p) {
  return {static_cast<ClipperLib::cInt>(std::llround(p.x * kGridPerMm)),
          static_cast<ClipperLib::cInt>(std::llround(p.y * kGridPerMm))};
}

Vec2 from_grid(IntPoint p) {
  return {static_cast<double>(p.X) / kGridPerMm, static_cast<double>(p.Y) / kGridPerMm};
}

struct GridHash {
  std::size_t operator()(const std::pair<std::int64_t, std::int64_t>& p) const {
    return std::hash<std::int64_t>()(p.first * 0x9e3779b97f4a7c15LL ^ p.second);
  }
};

using PointSet = std::unordered_set<std::pair<std::int64_t, std::int64_t>, GridHash>;

/// A point of the input: its exact place, and the source edges through this point.
struct SourcePoint {
  Vec2 point;
  std::vector<int> edges;
};

/// All input edges, and the exact places of the flattened points.
class Sources {
 public:
  explicit Sources(const Tolerances& tol) : tol_(tol) {}

  ClipperLib::Path flatten(const Loop& loop) {
    ClipperLib::Path path;
    for (const auto& edge : loop) {
      const int id = static_cast<int>(edges_.size());
      edges_.push_back(edge);
      std::vector<Vec2> points{edge.from};
      append_flattened(edge, tol_.chord, points);
      for (const auto p : points) flattened_.push_back({p, id});
      for (std::size_t i = 0; i + 1 < points.size(); ++i) path.push_back(to_grid(points[i]));
    }
    return path;
  }

  /// Must be called with the clipped contours before any question about their points: only the input's points that
  /// occur there are filed, since the input may have many more.
  void look_up(const ClipperLib::Paths& clipped) {
    PointSet wanted;
    for (const auto& path : clipped)
      for (const auto& p : path) wanted.insert({p.X, p.Y});
    for (const auto& [p, id] : flattened_)
      if (const IntPoint key = to_grid(p); wanted.count({key.X, key.Y}) > 0) remember(p, id);
  }

  Vec2 exact(IntPoint p) const {
    const auto found = points_.find({p.X, p.Y});
    return found == points_.end() ? from_grid(p) : found->second.point;
  }

  bool is_source_point(IntPoint p) const { return points_.count({p.X, p.Y}) > 0; }

  /// The input edge of which the chord from p to q is a part; -1 if none is found.
  int edge_of(IntPoint p, IntPoint q) const {
    bool known = false;
    for (const auto& end : {p, q}) {
      const auto found = points_.find({end.X, end.Y});
      if (found == points_.end()) continue;
      known = true;
      for (const int id : found->second.edges) {
        if (carries(id, p, q)) return id;
      }
    }
    return known ? -1 : arc_carrying(p, q);
  }

  const Edge& edge(int id) const { return edges_[static_cast<std::size_t>(id)]; }

  /// Whether the arc `after` continues the arc `before` at p: both are on one circle, and p is no end of both.
  /// Boundaries that coincide are flattened at different points and alternate in the result.
  bool goes_on(int before, int after, IntPoint p) const {
    if (before < 0 || after < 0) return false;
    if (before == after) return true;
    const Edge &a = edge(before), &b = edge(after);
    if (distance(a.center, b.center) > tol_.chord || std::abs(a.radius() - b.radius()) > tol_.chord)
      return false;
    return !(is_end(a, p) && is_end(b, p));
  }

 private:
  static bool is_end(const Edge& edge, IntPoint p) {
    return to_grid(edge.from) == p || to_grid(edge.to) == p;
  }

  void remember(Vec2 p, int id) {
    const auto key = to_grid(p);
    auto& source = points_.try_emplace({key.X, key.Y}, SourcePoint{p, {}}).first->second;
    if (std::find(source.edges.begin(), source.edges.end(), id) == source.edges.end())
      source.edges.push_back(id);
  }

  /// Whether p, q and the middle between them are on the edge within the error of its flattening.
  bool carries(int id, IntPoint p, IntPoint q) const {
    const auto& edge = edges_[static_cast<std::size_t>(id)];
    const Vec2 a = from_grid(p), b = from_grid(q);
    if (!edge.is_arc()) return false;
    if (!edge.box().grown(slack()).contains(a)) return false;
    return distance(edge, a) <= slack() && distance(edge, b) <= slack() &&
           distance(edge, (a + b) / 2.0) <= slack();
  }

  /// The arc of a chord that was cut at both ends, as happens if thousands of strokes cross; -1 if there is none.
  int arc_carrying(IntPoint p, IntPoint q) const {
    if (!arcs_) {
      arcs_.emplace();
      arcs_->build(static_cast<std::uint32_t>(edges_.size()),
                   [&](std::uint32_t i) { return edges_[i].is_arc() ? edges_[i].box() : Box{}; });
    }
    int found = -1;
    arcs_->descend(
        [&, at = from_grid(p)](const Box& box) { return found < 0 && box.grown(slack()).contains(at); },
        [&](std::uint32_t i) {
          if (found < 0 && carries(static_cast<int>(i), p, q)) found = static_cast<int>(i);
        });
    return found;
  }

  /// mm. Greatest distance of flattened points from their arc.
  double slack() const { return 2 * tol_.chord + 4 / kGridPerMm; }

  Tolerances tol_;
  std::vector<Edge> edges_;
  std::vector<std::pair<Vec2, int>> flattened_;  ///< points of the input, each with its edge
  mutable std::optional<BoxTree> arcs_;          ///< made when first asked
  std::unordered_map<std::pair<std::int64_t, std::int64_t>, SourcePoint, GridHash> points_;
};

/// Radians. Circles stay in two pieces.
constexpr double kMostSweep = 6;

/// A run of chords of one circle, or a single straight edge (first < 0).
struct Piece {
  IntPoint from;
  IntPoint to;
  int first = -1;    ///< source arc of its first chord
  int last = -1;     ///< and of its last
  double sweep = 0;  ///< radians, > 0 counter-clockwise
};

Piece piece_of(IntPoint p, IntPoint q, const Sources& sources) {
  const int arc = sources.edge_of(p, q);
  if (arc < 0) return {p, q};
  const Vec2 center = sources.edge(arc).center, a = from_grid(p) - center, b = from_grid(q) - center;
  return {p, q, arc, arc, base::atan2(cross(a, b), dot(a, b))};
}

/// Whether the piece took the next one in.
bool takes_in(Piece& piece, const Piece& next, const Sources& sources) {
  const double sweep = piece.sweep + next.sweep;
  if (!sources.goes_on(piece.last, next.first, next.from) || std::abs(sweep) > kMostSweep) return false;
  piece = {piece.from, next.to, piece.first, next.last, sweep};
  return true;
}

std::vector<Piece> pieces_of(const ClipperLib::Path& path, const Sources& sources) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Piece next = piece_of(path[i], path[(i + 1) % path.size()], sources);
    if (pieces.empty() || !takes_in(pieces.back(), next, sources)) pieces.push_back(next);
  }
  if (pieces.size() > 2 && takes_in(pieces.back(), pieces.front(), sources)) {
    pieces.front() = pieces.back();
    pieces.pop_back();
  }
  return pieces;
}

/// The line through a straight piece or the whole source arc, for solving exact corners.
Edge carrier(const Piece& piece, int arc, const Sources& sources) {
  if (arc >= 0) return sources.edge(arc);
  const Vec2 a = from_grid(piece.from), b = from_grid(piece.to);
  const Vec2 reach = unit(b - a) * 0.01;
  return Edge::line(a - reach, b + reach);
}

/// The corner between two pieces. New corners at arcs are solved on the true curves: chords displace them by
/// tol.chord.
Vec2 corner(const Piece& before, const Piece& after, const Sources& sources, const Tolerances& tol) {
  const Vec2 rough = sources.exact(after.from);
  if (sources.is_source_point(after.from) || (before.last < 0 && after.first < 0)) return rough;
  Vec2 best = rough;
  double nearest_yet = 100 * tol.chord;
  for (const auto p :
       intersections(carrier(before, before.last, sources), carrier(after, after.first, sources))) {
    if (distance(p, rough) < nearest_yet) {
      nearest_yet = distance(p, rough);
      best = p;
    }
  }
  return best;
}

/// For an arc whose ends are off its circle (on a chord of the circle or at a point of another outline): an arc
/// through both ends about a centre as near as possible to the old one; a line if the bow of the arc is smaller than
/// that error.
Edge through_ends(Edge arc) {
  const double off = norm(arc.from - arc.center) - norm(arc.to - arc.center);
  if (std::abs(off) <= kOnCircle) return arc;
  const Vec2 chord = arc.to - arc.from;
  const double sagitta = norm_squared(chord) / (8 * arc.radius());
  if (sagitta <= std::abs(off)) return Edge::line(arc.from, arc.to);
  const Vec2 middle = lerp(arc.from, arc.to, 0.5);
  arc.center = arc.center - chord * (dot(arc.center - middle, chord) / norm_squared(chord));
  return arc;
}

Edge joined(Vec2 from, Vec2 to, const Piece& piece, const Sources& sources) {
  if (piece.first < 0) return Edge::line(from, to);
  const Turn turn = piece.sweep > 0 ? Turn::kCounterClockwise : Turn::kClockwise;
  const Edge arc = Edge::arc(from, to, sources.edge(piece.first).center, turn);
  // Nearly coincident ends may be in reverse order: then the arc would become nearly a full circle.
  return std::abs(arc.sweep()) > std::abs(piece.sweep) + kPi ? Edge::line(from, to) : through_ends(arc);
}

Loop loop_of(const ClipperLib::Path& path, const Sources& sources, const Tolerances& tol) {
  const auto pieces = pieces_of(path, sources);
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    corners.push_back(corner(pieces[(i + pieces.size() - 1) % pieces.size()], pieces[i], sources, tol));
  }
  Loop loop;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vec2 from = corners[i], to = corners[(i + 1) % corners.size()];
    if (from != to) loop.push_back(joined(from, to, pieces[i], sources));
  }
  return loop;
}

/// Whether the loop is a sliver caused only by flattening: twice the area over the perimeter is about its thickness.
bool is_sliver(const Loop& loop, const Tolerances& tol) {
  return loop.size() < 2 || 2 * std::abs(signed_area(loop)) <= 2 * tol.chord * length(loop);
}

void append_region(const NestedContour& nested, const Sources& sources, const Tolerances& tol, Regions& out) {
  Loop outer = loop_of(nested.contour, sources, tol);
  if (is_sliver(outer, tol)) return;
  std::vector<Loop> islands;
  for (const ClipperLib::Path& hole : nested.holes) {
    Loop island = loop_of(hole, sources, tol);
    if (!is_sliver(island, tol)) islands.push_back(std::move(island));
  }
  out.push_back(Region::from_valid_loops(std::move(outer), std::move(islands)));
}

void add_regions(const Regions& regions, ClipperLib::PolyType type, Sources& sources,
                 ClipperLib::Clipper& clipper) {
  for (const auto& region : regions) {
    clipper.AddPath(sources.flatten(region.outer()), type, true);
    for (const auto& island : region.islands()) clipper.AddPath(sources.flatten(island), type, true);
  }
}

/// Whether a contour passes one of its points twice.
bool touches_itself(const ClipperLib::Paths& contours) {
  PointSet seen;
  return std::any_of(contours.begin(), contours.end(), [&](const ClipperLib::Path& contour) {
    seen.clear();
    return std::any_of(contour.begin(), contour.end(), [&](const IntPoint& p) {
      return !seen.insert({p.X, p.Y}).second;
    });
  });
}

/// Contours that touch themselves lose the spikes that stay between walls that two regions share, and are split there. Polyclipping has an option for this split (StrictlySimple), but
/// its cost is that of all points for every touch, and boundaries running along each other over long stretches become
/// many contours that share edges. Polyclipping could nest contours, too (PolyTree), but at the cost of all points
/// for every place where two contours share an edge.
Regions executed(ClipperLib::Clipper& clipper, ClipperLib::ClipType operation, ClipperLib::PolyFillType fill,
                 Sources& sources, const Tolerances& tol) {
  ClipperLib::Paths contours;
  // Execute returns false if there was no input; loops without area are no input to polyclipping.
  if (!clipper.Execute(operation, contours, fill, fill)) return {};
  std::erase_if(contours, [](const ClipperLib::Path& contour) { return contour.size() < 3; });
  bool touching = touches_itself(contours);
  if (touching) {
    ClipperLib::CleanPolygons(contours, kGridRounding);
    std::erase_if(contours, [](const ClipperLib::Path& contour) { return contour.size() < 3; });
    touching = touches_itself(contours);
  }
  sources.look_up(contours);
  Regions regions;
  for (const NestedContour& nested : touching ? split_contours(contours) : nested_contours(contours))
    append_region(nested, sources, tol, regions);
  return regions;
}

Regions combined(const Regions& a, const Regions& b, ClipperLib::ClipType operation, const Tolerances& tol) {
  Sources sources(tol);
  ClipperLib::Clipper clipper;
  add_regions(a, ClipperLib::ptSubject, sources, clipper);
  add_regions(b, ClipperLib::ptClip, sources, clipper);
  return executed(clipper, operation, ClipperLib::pftNonZero, sources, tol);
}

Regions resolved(std::span<const Loop> loops, ClipperLib::PolyFillType fill, const Tolerances& tol) {
  Sources sources(tol);
  ClipperLib::Clipper clipper;
  for (const auto& loop : loops) clipper.AddPath(sources.flatten(loop), ClipperLib::ptSubject, true);
  return executed(clipper, ClipperLib::ctUnion, fill, sources, tol);
}

/// Unites the paths by halves: most paths inside others are removed before the remaining ones are united together.
void add_united(std::span<const ClipperLib::Path> paths, ClipperLib::Clipper& clipper) {
  constexpr std::size_t kAtOnce = 256;
  if (paths.size() <= kAtOnce) {
    for (const ClipperLib::Path& path : paths) clipper.AddPath(path, ClipperLib::ptSubject, true);
    return;
  }
  for (const auto half : {paths.first(paths.size() / 2), paths.subspan(paths.size() / 2)}) {
    ClipperLib::Clipper own;
    ClipperLib::Paths united;
    add_united(half, own);
    own.Execute(ClipperLib::ctUnion, united, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    clipper.AddPaths(united, ClipperLib::ptSubject, true);
  }
}

/// Twice the area over the perimeter is about the thickness.
bool is_thin(const ClipperLib::Path& path, const Tolerances& tol) {
  double around = 0;
  for (std::size_t i = 0; i < path.size(); ++i)
    around += distance(from_grid(path[i]), from_grid(path[(i + 1) % path.size()]));
  const double covered = std::abs(ClipperLib::Area(path)) / (kGridPerMm * kGridPerMm);
  return 2 * covered <= 2 * tol.chord * around;
}

}  // namespace

Regions unite_all(const Regions& regions, const Tolerances& tol) {
  Sources sources(tol);
  ClipperLib::Clipper flat, nested;
  add_regions(regions, ClipperLib::ptSubject, sources, flat);
  ClipperLib::Paths paths;
  if (!flat.Execute(ClipperLib::ctUnion, paths, ClipperLib::pftNonZero, ClipperLib::pftNonZero)) return {};
  for (const ClipperLib::Path& path : paths)
    if (!is_thin(path, tol)) nested.AddPath(path, ClipperLib::ptSubject, true);
  return executed(nested, ClipperLib::ctUnion, ClipperLib::pftNonZero, sources, tol);
}

Regions unite_loops(std::span<const Loop> loops, const Tolerances& tol) {
  Sources sources(tol);
  ClipperLib::Paths paths;
  for (const Loop& loop : loops) paths.push_back(sources.flatten(loop));
  ClipperLib::Clipper clipper;
  add_united(paths, clipper);
  return executed(clipper, ClipperLib::ctUnion, ClipperLib::pftNonZero, sources, tol);
}

Regions unite(const Regions& a, const Regions& b, const Tolerances& tol) {
  return combined(a, b, ClipperLib::ctUnion, tol);
}

Regions subtract(const Regions& a, const Regions& b, const Tolerances& tol) {
  return combined(a, b, ClipperLib::ctDifference, tol);
}

Regions intersect(const Regions& a, const Regions& b, const Tolerances& tol) {
  return combined(a, b, ClipperLib::ctIntersection, tol);
}

Regions resolve_even_odd(std::span<const Loop> loops, const Tolerances& tol) {
  return resolved(loops, ClipperLib::pftEvenOdd, tol);
}

Regions resolve_nonzero(std::span<const Loop> loops, const Tolerances& tol) {
  return resolved(loops, ClipperLib::pftNonZero, tol);
}

}  // namespace clearcut::inline geometry
