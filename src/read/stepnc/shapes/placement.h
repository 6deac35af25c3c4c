// Axis placements of ISO 10303-42, in space and as seen in plan.
#pragma once

#include <optional>

#include "geometry/edge.h"
#include "read/stepnc/file/node.h"

namespace clearcut::read::stepnc {

struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend constexpr bool operator==(Vec3, Vec3) = default;
};

/// The point or direction as seen from above.
inline Vec2 in_plan(Vec3 p) {
  return {p.x, p.y};
}

/// A right-handed frame; the default is the identity.
struct Frame {
  Vec3 origin;
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};

  Vec3 point(Vec3 local) const;
  Vec3 direction(Vec3 local) const;
};

/// First `inner`, then `outer`: the frame `inner` is given in, itself placed by `outer`.
Frame composed(const Frame& outer, const Frame& inner);
Frame inverse(const Frame& frame);
bool is_identity(const Frame& frame);

/// CARTESIAN_POINT: two coordinates or more; those after the third are not used.
Vec3 location_of(const Node& node);
/// DIRECTION, not normalised.
Vec3 axis_of(const Node& node);
/// AXIS2_PLACEMENT_3D (or AXIS1, 2D); nothing gives the identity, missing axes their defaults.
Frame frame_of(const std::optional<Node>& node);

/// A frame whose local Z is +Z or -Z, as a map of the plane.
struct PlanarMap {
  Vec2 origin;
  Vec2 x{1, 0};
  Vec2 y{0, 1};
  bool mirrored = false;

  Vec2 point(Vec2 p) const { return origin + x * p.x + y * p.y; }
  Vec2 direction(Vec2 d) const { return x * d.x + y * d.y; }
  Edge edge(const Edge& e) const;
  Path path(const Path& p) const;
};
bool is_upright(const Frame& frame);  ///< local Z is +Z
bool is_planar(const Frame& frame);   ///< local Z is +Z or -Z
PlanarMap planar_map(const Frame& frame);

}  // namespace clearcut::read::stepnc
