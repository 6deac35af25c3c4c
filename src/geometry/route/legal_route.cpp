#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/units.h"
#include "base/work_budget.h"
#include "geometry/contours/boolean.h"
#include "geometry/route/legal_paths.h"

namespace clearcut::inline geometry {
namespace {

/// mm. Pieces shorter than this are rounding.
constexpr double kNoLength = 1e-7;
/// Radians. Along an arc, the path may be left at places this far apart.
constexpr double kArcPiece = kPi / 18;
/// Paths with more vertices than this are shortened in one pass over windows of so many.
constexpr std::size_t kWindow = 120;
/// Straight lines whose check costs as much as one step of work.
constexpr std::uint64_t kLinesPerStep = 8;

void append(Path& path, const Edge& edge) {
  if (edge.is_arc() ? edge.length() > kNoLength : distance(edge.from, edge.to) > kNoLength)
    path.push_back(edge);
}

/// Arcs in pieces, so that a path can be left at places along the arc.
Path in_pieces(const Path& path) {
  Path pieces;
  for (const auto& edge : path) {
    const int count = edge.is_arc() ? static_cast<int>(std::ceil(std::abs(edge.sweep()) / kArcPiece)) : 1;
    for (int i = 0; i < count; ++i) {
      pieces.push_back(
          count == 1 ? edge : edge.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
    }
  }
  return pieces;
}

/// The edges of `loop` from a place on one edge to a place on another, in the loop's sense.
Path along(const Loop& loop, std::size_t edge_from, Vec2 from, std::size_t edge_to, Vec2 to) {
  Path path;
  const double t_from = nearest(loop[edge_from], from).t, t_to = nearest(loop[edge_to], to).t;
  const auto piece = [&](const Edge& edge, double t0, double t1) {
    if ((t1 - t0) * edge.length() > kNoLength) append(path, edge.part(t0, t1));
  };
  if (edge_from == edge_to && t_from <= t_to) {
    piece(loop[edge_from], t_from, t_to);
    return path;
  }
  piece(loop[edge_from], t_from, 1);
  for (std::size_t i = (edge_from + 1) % loop.size(); i != edge_to; i = (i + 1) % loop.size())
    append(path, loop[i]);
  piece(loop[edge_to], 0, t_to);
  return path;
}

}  // namespace

LegalRoutes::LegalRoutes(const Regions& regions, const LegalArea& area)
    : area_(area), loops_(loops_of(regions)) {
  for (const auto& loop : loops_) {
    boxes_.emplace_back();
    for (const auto& edge : loop) boxes_.back().push_back(edge.box());
  }
}

std::vector<LegalRoutes::Crossing> LegalRoutes::crossings(Vec2 a, Vec2 b) const {
  const Edge path = Edge::line(a, b);
  const Box where = path.box().grown(LegalArea::kSlack);
  std::vector<Crossing> found;
  for (std::size_t loop = 0; loop < loops_.size(); ++loop) {
    for (std::size_t edge = 0; edge < loops_[loop].size(); ++edge) {
      if (!boxes_[loop][edge].overlaps(where)) continue;
      for (const Vec2 p : intersections(path, loops_[loop][edge])) {
        found.push_back({dot(p - a, b - a) / norm_squared(b - a), p, loop, edge});
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const Crossing& p, const Crossing& q) {
    return p.t != q.t ? p.t < q.t : p.loop != q.loop ? p.loop < q.loop : p.edge < q.edge;
  });
  return found;
}

std::optional<Path> LegalRoutes::between(Vec2 a, Vec2 b) const {
  if (distance(a, b) <= kNoLength) return Path{};
  if (area_.holds_line(a, b)) return Path{Edge::line(a, b)};
  const auto all = crossings(a, b);
  Path path;
  Vec2 at = a;
  // Leaves the straight path at its crossing out of the area and follows that boundary to the straight path's last
  // crossing with it.
  for (std::size_t i = 0; i < all.size();) {
    const double t_next = i + 1 < all.size() ? all[i + 1].t : 1.0;
    const bool goes_on = (t_next - all[i].t) * distance(a, b) < LegalArea::kSlack ||
                         area_.holds(lerp(a, b, (all[i].t + t_next) / 2));
    if (goes_on) {
      ++i;
      continue;
    }
    std::size_t last = all.size() - 1;
    while (last > i && all[last].loop != all[i].loop) --last;
    if (last == i) return std::nullopt;
    append(path, Edge::line(at, all[i].point));
    for (const auto& edge : around(all[i], all[last])) path.push_back(edge);
    at = all[last].point;
    i = last;
    if (last + 1 == all.size()) break;
    ++i;
    // The stretch from this crossing to the next is inside: the path has just entered the area.
  }
  append(path, Edge::line(at, b));
  return taut(a, path);
}

Path LegalRoutes::around(const Crossing& out, const Crossing& in) const {
  const Loop& loop = loops_[out.loop];
  const Path forwards = along(loop, out.edge, out.point, in.edge, in.point);
  const Path backwards = along(loop, in.edge, in.point, out.edge, out.point);
  return length(forwards) <= length(backwards) ? forwards : reversed(backwards);
}

/// Greedily replaces stretches of the path by straight legal ones, the longest first from each place.
Path LegalRoutes::taut(Vec2 a, const Path& path) const {
  const Path pieces = in_pieces(path);
  Path short_path;
  std::uint64_t tried = 0;
  Vec2 at = a;
  for (std::size_t i = 0; i < pieces.size();) {
    std::size_t far = std::min(pieces.size() - 1, i + kWindow);
    while (far > i && !area_.holds_line(at, pieces[far].to)) --far, ++tried;
    Edge edge = pieces[i];
    if (far > i || !edge.is_arc() || area_.holds_line(at, edge.to)) edge = Edge::line(at, pieces[far].to);
    edge.from = at;
    append(short_path, edge);
    if (!short_path.empty()) at = short_path.back().to;
    i = far + 1;
  }
  WorkBudget::spend(1 + tried / kLinesPerStep);
  return short_path;
}

}  // namespace clearcut::inline geometry
