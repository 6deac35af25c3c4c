#include "read/dxf/dxf_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/elementary.h"
#include "base/units.h"
#include "geometry/region.h"
#include "read/common/curve_fit.h"
#include "read/dxf/dxf_spline.h"
#include "read/repair/clean.h"

namespace clearcut::read {
namespace {

constexpr std::array<std::string_view, 7> kCurves{"LINE",   "ARC",        "CIRCLE",  "ELLIPSE",
                                                  "SPLINE", "LWPOLYLINE", "POLYLINE"};

Path mapped(const Path& path, const Affine& map) {
  Path out;
  for (const Edge& edge : path) append_mapped(edge, map, kCurveTolerance, out);
  return out;
}

Path arc_path(const DxfDocument& document, const DxfEntity& entity) {
  const Vec2 center = document.point(entity, 10);
  const double radius = radius_of(document, entity);
  const double start = document.required(entity, 50), end = document.required(entity, 51);
  double sweep = std::fmod(end - start, 360.0);
  if (sweep <= 1e-9) sweep += 360;
  if (radius == 0) return {};
  if (sweep >= 360 - 1e-9) return full_circle(center, radius);
  const Vec2 from = center + direction_of(Radians::of_degrees(start).radians()) * radius;
  const Vec2 to = center + direction_of(Radians::of_degrees(start + sweep).radians()) * radius;
  return {Edge::arc(from, to, center, Turn::kCounterClockwise)};
}

Path ellipse_path(const DxfDocument& document, const DxfEntity& entity, const Affine& map) {
  const Vec2 major = document.point(entity, 11);
  const double ratio = document.required(entity, 40);
  if (!(norm(major) > 0) || !(ratio > 0))
    document.fail(entity.line, "an ellipse without width; correct the file");
  // The minor axis is the extrusion cross the major one: reversed if the extrusion points down.
  const double side = document.number(entity, 230, 1) < 0 ? -1 : 1;
  const double start = document.number(entity, 41, 0), end = document.number(entity, 42, 2 * kPi);
  double sweep = std::fmod(end - start, 2 * kPi);
  if (sweep <= 1e-9) sweep += 2 * kPi;
  Path path;
  append_elliptical({map(document.point(entity, 10)), map.linear(major),
                     map.linear(left_of(major) * (side * ratio)), start, sweep},
                    kCurveTolerance, path);
  return path;
}

/// Vertices with bulges as edges; the last bulge only counts when closed.
Path bulge_path(const std::vector<BulgeVertex>& vertices, bool closed) {
  Path path;
  if (vertices.size() < 2) return path;
  const std::size_t edges = closed ? vertices.size() : vertices.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    const Vec2 from = vertices[i].point, to = vertices[(i + 1) % vertices.size()].point;
    if (from != to) path.push_back(Edge::from_bulge(from, to, vertices[i].bulge));
  }
  return path;
}

std::vector<BulgeVertex> light_vertices(const DxfDocument& document, const DxfEntity& entity) {
  std::vector<BulgeVertex> vertices;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 10) vertices.push_back({{document.number(group), 0}, 0});
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().point.y = document.number(group);
    if (group.code == 42) vertices.back().bulge = document.number(group);
  }
  return vertices;
}

std::vector<BulgeVertex> old_vertices(const DxfDocument& document, std::span<const DxfEntity> entities) {
  constexpr int kSplineFrame = 16;
  std::vector<BulgeVertex> vertices;
  for (const DxfEntity& vertex : entities) {
    if (document.integer(vertex, 70, 0) & kSplineFrame) continue;
    vertices.push_back({document.point(vertex, 10), document.number(vertex, 42, 0)});
  }
  return vertices;
}

constexpr int kFromWidth = 40, kToWidth = 41, kWidth = 43;

/// Where the line begins at a vertex and where it comes to the next one.
struct WidthOfEdge {
  double from = 0, to = 0;
};

/// One for each vertex.
std::vector<WidthOfEdge> light_widths(const DxfDocument& document, const DxfEntity& entity) {
  const double whole = document.number(entity, kWidth, 0);
  std::vector<WidthOfEdge> widths;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 10) widths.push_back({whole, whole});
    if (widths.empty()) continue;
    if (group.code == kFromWidth) widths.back().from = document.number(group);
    if (group.code == kToWidth) widths.back().to = document.number(group);
  }
  return widths;
}

std::vector<WidthOfEdge> old_widths(const DxfDocument& document, const DxfEntity& entity,
                                    std::span<const DxfEntity> vertices) {
  const double from = document.number(entity, kFromWidth, 0), to = document.number(entity, kToWidth, from);
  std::vector<WidthOfEdge> widths;
  for (const DxfEntity& vertex : vertices)
    widths.push_back({document.number(vertex, kFromWidth, from), document.number(vertex, kToWidth, to)});
  return widths;
}

/// Nothing for meshes.
std::optional<Path> polyline_path(const DxfDocument& document, const DxfEntity& entity,
                                  std::span<const DxfEntity> old, bool& closed) {
  constexpr int kClosed = 1, kMeshes = 16 | 64;
  const bool is_old = entity.type == "POLYLINE";
  const int flags = document.integer(entity, 70, 0);
  if (is_old && (flags & kMeshes)) return std::nullopt;
  closed = flags & kClosed;
  return bulge_path(is_old ? old_vertices(document, old) : light_vertices(document, entity), closed);
}

}  // namespace

double radius_of(const DxfDocument& document, const DxfEntity& entity) {
  const double radius = document.required(entity, 40);
  if (!(radius >= 0)) document.fail(entity.line, "a radius below 0; correct the file");
  return radius;
}

DxfWidth width_of(const DxfDocument& document, const DxfEntity& entity, std::span<const DxfEntity> vertices) {
  constexpr int kClosed = 1;
  std::vector<WidthOfEdge> widths;
  if (entity.type == "LWPOLYLINE") widths = light_widths(document, entity);
  if (entity.type == "POLYLINE") widths = old_widths(document, entity, vertices);
  if (widths.size() > 1 && !(document.integer(entity, 70, 0) & kClosed)) widths.pop_back();
  DxfWidth width;
  for (const WidthOfEdge& edge : widths) width.widest = std::max({width.widest, edge.from, edge.to});
  const auto is_widest = [&](const WidthOfEdge& edge) {
    return edge.from == width.widest && edge.to == width.widest;
  };
  if (std::all_of(widths.begin(), widths.end(), is_widest)) width.constant = width.widest;
  return width;
}

bool is_curve(std::string_view dxf_type) {
  return std::find(kCurves.begin(), kCurves.end(), dxf_type) != kCurves.end();
}

std::optional<Affine> entity_map(const DxfDocument& document, const DxfEntity& entity) {
  // LINE, ELLIPSE and SPLINE are written in the coordinates of the drawing with any extrusion. The extrusion of an
  // ellipse gives its plane.
  if (entity.type == "LINE" || entity.type == "SPLINE") return Affine{};
  const double x = document.number(entity, 210, 0), y = document.number(entity, 220, 0);
  const double z = document.number(entity, 230, 1);
  if (std::abs(x) + std::abs(y) > 1e-6 * std::abs(z)) return std::nullopt;
  if (entity.type == "ELLIPSE") return Affine{};
  return z < 0 ? Affine::scaling(-1, 1) : Affine{};
}

Path light_polyline(const DxfDocument& document, const DxfEntity& entity, bool closed, const Affine& map) {
  return mapped(bulge_path(light_vertices(document, entity), closed), map);
}

std::optional<RawCurve> curve_of(const DxfDocument& document, const DxfEntity& entity,
                                 std::span<const DxfEntity> vertices, const Affine& map) {
  const auto own = entity_map(document, entity);
  if (!own) return std::nullopt;
  RawCurve curve;
  curve.source = std::string(entity.type) + " at line " + std::to_string(entity.line);
  if (entity.type == "LINE") {
    curve.edges = mapped({Edge::line(document.point(entity, 10), document.point(entity, 11))}, map);
  } else if (entity.type == "CIRCLE") {
    const double radius = radius_of(document, entity);
    if (radius > 0) curve.edges = mapped(full_circle(document.point(entity, 10), radius), map * *own);
    curve.closed = true;
  } else if (entity.type == "ARC") {
    curve.edges = mapped(arc_path(document, entity), map * *own);
  } else if (entity.type == "ELLIPSE") {
    curve.edges = ellipse_path(document, entity, map);
  } else {
    const auto path = entity.type == "SPLINE" ? spline_path(document, entity, map)
                                              : polyline_path(document, entity, vertices, curve.closed);
    if (!path) return std::nullopt;
    curve.edges = entity.type == "SPLINE" ? *path : mapped(*path, map * *own);
  }
  return curve;
}

namespace {

constexpr std::array<std::string_view, 3> kFills{"HATCH", "SOLID", "TRACE"};

/// Codes of a HATCH.
constexpr int kPathCount = 91, kPath = 92, kEdge = 72, kSources = 97, kStyle = 75, kSeeds = 98;

using GroupSpan = std::span<const DxfGroup>;

DxfEntity part_of(const DxfEntity& whole, GroupSpan groups) {
  DxfEntity part{whole.type, groups.empty() ? whole.line : groups.front().line, {}};
  part.groups.assign(groups.begin(), groups.end());
  return part;
}

/// The groups from each one with `code` to the next, or to the end.
std::vector<GroupSpan> parts_from(GroupSpan groups, int code) {
  std::vector<GroupSpan> parts;
  const auto begins = [&](const DxfGroup& group) { return group.code == code; };
  for (auto from = std::find_if(groups.begin(), groups.end(), begins); from != groups.end();) {
    const auto to = std::find_if(from + 1, groups.end(), begins);
    parts.emplace_back(from, to);
    from = to;
  }
  return parts;
}

/// The groups before the first of `codes`.
GroupSpan before(GroupSpan groups, std::initializer_list<int> codes) {
  const auto end = std::find_if(groups.begin(), groups.end(), [&](const DxfGroup& group) {
    return std::find(codes.begin(), codes.end(), group.code) != codes.end();
  });
  return {groups.begin(), end};
}

/// Whether most of `inner` is within `outer`: boundaries of a hatch may touch.
bool lies_in(const Path& inner, const Path& outer) {
  const Box in = box(inner), out = box(outer);
  if (!out.contains(in.min) || !out.contains(in.max)) return false;
  const auto within = std::count_if(inner.begin(), inner.end(), [&](const Edge& edge) {
    int turns = 0;
    for (const Edge& other : outer) turns += winding(other, edge.at(0.5));
    return turns != 0;
  });
  return 2 * static_cast<std::size_t>(within) > inner.size();
}

/// The boundaries without those ignored by a hatch: those within others in style 2 (ignore), those within two others
/// in style 1 (outer).
std::vector<Path> heeded(std::vector<Path> paths, int style) {
  if (style != 1 && style != 2) return paths;
  std::vector<Path> kept;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    int around = 0;
    for (std::size_t k = 0; k < paths.size() && around + style <= 2; ++k)
      if (k != i && lies_in(paths[i], paths[k])) ++around;
    if (around + style <= 2) kept.push_back(paths[i]);
  }
  return kept;
}

/// Reads the boundary paths of one HATCH.
class HatchReader {
 public:
  HatchReader(const DxfDocument& document, const DxfEntity& hatch, const Affine& map)
      : document_(document), hatch_(hatch), map_(map) {}

  /// Closed paths in mm relevant for its style; empty if there are fewer than counted in the file.
  std::vector<Path> paths() const {
    const GroupSpan all(hatch_.groups);
    const auto count =
        std::find_if(all.begin(), all.end(), [](const auto& g) { return g.code == kPathCount; });
    if (count == all.end()) return {};
    const auto parts = parts_from(before({count, all.end()}, {kStyle, kSeeds}), kPath);
    if (parts.size() != static_cast<std::size_t>(std::max(0, document_.integer(hatch_, kPathCount, 0))))
      return {};
    std::vector<Path> paths;
    for (const GroupSpan& part : parts) {
      Path path = path_of(part);
      if (path.empty()) return {};
      paths.push_back(std::move(path));
    }
    return heeded(std::move(paths), document_.integer(hatch_, kStyle, 0));
  }

 private:
  Path path_of(GroupSpan groups) const {
    constexpr int kPolyline = 2;
    const DxfEntity whole = part_of(hatch_, before(groups, {kSources}));
    if (document_.integer(whole, kPath, 0) & kPolyline) return light_polyline(document_, whole, true, map_);
    std::vector<Path> pieces;
    for (const GroupSpan& edge : parts_from(groups, kEdge)) {
      Path piece = edge_of(part_of(hatch_, edge));
      if (!piece.empty()) pieces.push_back(std::move(piece));
    }
    return joined(std::move(pieces));
  }

  /// The pieces one after the other, each reversed if needed to begin at the end of the previous one.
  static Path joined(std::vector<Path> pieces) {
    Path path;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      Path& piece = pieces[i];
      const Path& other = i > 0 ? path : pieces[std::min(i + 1, pieces.size() - 1)];
      const auto gap = [&](Vec2 p) {
        return i > 0 ? distance(p, other.back().to)
                     : std::min(distance(p, other.front().from), distance(p, other.back().to));
      };
      const bool ends_nearer = gap(piece.back().to) < gap(piece.front().from);
      if (pieces.size() > 1 && ends_nearer == (i > 0)) piece = reversed(piece);
      path.insert(path.end(), piece.begin(), piece.end());
    }
    return path;
  }

  Path edge_of(const DxfEntity& edge) const {
    enum { kLine = 1, kCircular = 2, kElliptical = 3, kSpline = 4 };
    switch (document_.integer(edge, kEdge, 0)) {
      case kLine:
        return line(document_.point(edge, 10), document_.point(edge, 11));
      case kCircular:
        return elliptical(edge, {radius_of(document_, edge), 0}, 1);
      case kElliptical:
        return elliptical(edge, document_.point(edge, 11), document_.required(edge, 40));
      case kSpline:
        return spline_by_poles(document_, edge, {.degree = 94, .weight = 42}, map_).value_or(Path{});
      default:
        document_.fail(edge.line, "a boundary of a HATCH is no line, arc, ellipse or spline; explode it");
    }
  }

  Path line(Vec2 from, Vec2 to) const {
    Path path;
    if (from != to) append_mapped(Edge::line(from, to), map_, kCurveTolerance, path);
    return path;
  }

  /// Clockwise ends are written as if the arc were mirrored.
  Path elliptical(const DxfEntity& edge, Vec2 major, double ratio) const {
    if (norm(major) == 0 || !(ratio > 0)) return {};
    const double side = document_.integer(edge, 73, 1) != 0 ? 1 : -1;
    const double from = document_.required(edge, 50), to = document_.required(edge, 51);
    double turn = std::fmod(to - from, 360.0);
    if (turn <= 1e-9) turn += 360;
    const double start = parameter(from, ratio);
    const double sweep = turn >= 360 - 1e-9 ? 2 * kPi : positive(parameter(from + turn, ratio) - start);
    Path path;
    append_elliptical({map_(document_.point(edge, 10)), map_.linear(major),
                       map_.linear(left_of(major) * (ratio * side)), start, sweep},
                      kCurveTolerance, path);
    return path;
  }

  /// Parameter of an ellipse, from the angle (degrees) at which its point is seen from the centre.
  static double parameter(double degrees, double ratio) {
    const double angle = Radians::of_degrees(degrees).radians();
    return base::atan2(base::sin(angle) / ratio, base::cos(angle));
  }
  static double positive(double angle) { return angle > 0 ? angle : angle + 2 * kPi; }

  const DxfDocument& document_;
  const DxfEntity& hatch_;
  const Affine map_;
};

/// The third and the fourth corner are written in reverse order; a triangle has the third twice.
Path corners_path(const DxfDocument& document, const DxfEntity& entity, const Affine& map) {
  std::vector<Vec2> corners;
  for (const int x : {10, 11, 13, 12}) {
    if (!entity.find(x)) continue;
    const Vec2 corner = map(document.point(entity, x));
    if (corners.empty() || corner != corners.back()) corners.push_back(corner);
  }
  Path path;
  if (corners.size() < 3) return path;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i] != corners[(i + 1) % corners.size()])
      path.push_back(Edge::line(corners[i], corners[(i + 1) % corners.size()]));
  return path;
}

}  // namespace

bool is_fill(std::string_view dxf_type) {
  return std::find(kFills.begin(), kFills.end(), dxf_type) != kFills.end();
}

std::optional<std::vector<RawCurve>> boundaries_of(const DxfDocument& document, const DxfEntity& entity,
                                                   const Affine& map) {
  const auto own = entity_map(document, entity);
  if (!own) return std::nullopt;
  std::vector<Path> paths;
  if (entity.type == "HATCH") {
    paths = HatchReader(document, entity, map * *own).paths();
  } else if (Path path = corners_path(document, entity, map * *own); !path.empty()) {
    paths.push_back(std::move(path));
  }
  if (paths.empty()) return std::nullopt;
  std::vector<RawCurve> curves;
  for (Path& path : paths)
    curves.push_back(
        {std::move(path), true, std::string(entity.type) + " at line " + std::to_string(entity.line)});
  return curves;
}

}  // namespace clearcut::read
