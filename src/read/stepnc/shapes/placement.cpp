#include "read/stepnc/shapes/placement.h"

#include <cmath>

#include "base/elementary.h"
#include "base/tolerances.h"

namespace clearcut::read::stepnc {

namespace {

Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec3 operator*(Vec3 a, double k) {
  return {a.x * k, a.y * k, a.z * k};
}
double dot3(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 cross3(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double norm3(Vec3 a) {
  return std::sqrt(dot3(a, a));
}

/// Unit vector, exact where `v` is along an axis; `otherwise` where it has no direction.
Vec3 unit3(Vec3 v, Vec3 otherwise) {
  const double length = norm3(v);
  return length > 0 ? Vec3{v.x / length, v.y / length, v.z / length} : otherwise;
}

}  // namespace

Vec3 Frame::point(Vec3 local) const {
  return origin + direction(local);
}
Vec3 Frame::direction(Vec3 local) const {
  return x * local.x + y * local.y + z * local.z;
}

Frame composed(const Frame& outer, const Frame& inner) {
  return {outer.point(inner.origin), outer.direction(inner.x), outer.direction(inner.y),
          outer.direction(inner.z)};
}

Frame inverse(const Frame& frame) {
  Frame result;
  result.x = {frame.x.x, frame.y.x, frame.z.x};
  result.y = {frame.x.y, frame.y.y, frame.z.y};
  result.z = {frame.x.z, frame.y.z, frame.z.z};
  result.origin = result.direction(frame.origin * -1.0);
  return result;
}

bool is_identity(const Frame& frame) {
  const auto near = [](Vec3 a, Vec3 b) { return norm3(a + b * -1.0) < kSameAngleRad; };
  return near(frame.origin, {}) && near(frame.x, {1, 0, 0}) && near(frame.z, {0, 0, 1});
}

Vec3 location_of(const Node& node) {
  if (!node.is("CARTESIAN_POINT")) node.fail("a CARTESIAN_POINT is needed here; correct the reference");
  const std::vector<double> c = node.lengths(1);
  if (c.size() < 2) node.fail("fewer than two coordinates; give x, y, z");
  return {c[0], c[1], c.size() > 2 ? c[2] : 0.0};
}

Vec3 axis_of(const Node& node) {
  if (!node.is("DIRECTION")) node.fail("a DIRECTION is needed here; correct the reference");
  const std::vector<double> c = node.numbers(1);
  if (c.size() < 2) node.fail("fewer than two direction ratios; give x, y, z");
  return {c[0], c[1], c.size() > 2 ? c[2] : 0.0};
}

Frame frame_of(const std::optional<Node>& node) {
  if (!node) return {};
  const bool flat = node->is("AXIS2_PLACEMENT_2D");
  if (!flat && !node->is_any("AXIS2_PLACEMENT_3D", "AXIS1_PLACEMENT"))
    node->fail("an AXIS2_PLACEMENT_3D is needed here; correct the reference");
  Frame frame;
  if (const auto location = node->ref(1)) frame.origin = location_of(*location);
  const auto axis = flat ? std::nullopt : node->ref(2);
  const auto ref_direction = node->ref(flat ? 2 : 3);
  if (axis) frame.z = unit3(axis_of(*axis), {0, 0, 1});
  Vec3 x = ref_direction ? unit3(axis_of(*ref_direction), {1, 0, 0}) : Vec3{1, 0, 0};
  if (norm3(cross3(frame.z, x)) < kSameAngleRad)
    x = std::abs(frame.z.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  frame.x = unit3(x + frame.z * -dot3(x, frame.z), {1, 0, 0});
  frame.y = cross3(frame.z, frame.x);
  return frame;
}

Edge PlanarMap::edge(const Edge& e) const {
  if (!e.is_arc()) return Edge::line(point(e.from), point(e.to));
  const bool ccw = (e.turn == Turn::kCounterClockwise) != mirrored;
  return Edge::arc(point(e.from), point(e.to), point(e.center),
                   ccw ? Turn::kCounterClockwise : Turn::kClockwise);
}

Path PlanarMap::path(const Path& p) const {
  Path result;
  result.reserve(p.size());
  for (const Edge& e : p) result.push_back(edge(e));
  return result;
}

bool is_upright(const Frame& frame) {
  return frame.z.z > 0 && is_planar(frame);
}
bool is_planar(const Frame& frame) {
  return base::hypot(frame.z.x, frame.z.y) < kSameAngleRad;
}

PlanarMap planar_map(const Frame& frame) {
  return {{frame.origin.x, frame.origin.y}, {frame.x.x, frame.x.y}, {frame.y.x, frame.y.y}, frame.z.z < 0};
}

}  // namespace clearcut::read::stepnc
