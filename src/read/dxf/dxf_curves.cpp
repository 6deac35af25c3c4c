#include "read/dxf/dxf_curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"
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

}  // namespace clearcut::read
