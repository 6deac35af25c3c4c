#include "verify/faults/foot_fillet.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace clearcut::verify {
namespace {

/// mm. Error of the depth of a cut into a fillet on a sloping move.
constexpr double kFilletError = 1e-5;
/// mm. Pieces of sloping moves are not halved any further.
constexpr double kShortestPiece = 1e-4;
constexpr int kProjections = 12;

/// The point of the path nearest to the wall, by alternate projections: good enough for messages.
Vec2 nearest_place(const Edge& path, const Edge& wall) {
  if (path.from == path.to) return path.from;
  Vec2 place = path.at(0.5);
  for (int i = 0; i < kProjections; ++i) place = nearest_point(path, nearest_point(wall, place));
  return place;
}

/// Whether the path runs behind the wall, as beside the other side of a thin one.
bool is_behind(const Wall& wall, const Edge& path) {
  const Vec2 place = nearest_place(path, wall.edge);
  const auto foot = nearest(wall.edge, place);
  return cross(wall.edge.tangent_at(foot.t), place - foot.point) < 0;
}

/// mm; depth below the surface of the fillet of `wall` of a cutter `apart` mm from the wall's foot with its tip `above` mm over the floor;
/// 0 or less: none.
double depth_in_fillet(const CutterProfile& cutter, const Wall& wall, double apart, double above) {
  const double narrower = wall.fillet - cutter.round;
  const double sine = wall.sin_of_draft(), cosine = wall.cos_of_draft();
  const double over = std::max(0.0, above);
  // A cutter that is nearer than this cuts the wall itself, or is over the material behind it.
  const double nearest = (cutter.round - (over + cutter.round) * sine) / cosine;
  const double across = std::max(apart - cutter.flat, nearest) - wall.center_of_touching(wall.fillet);
  const double up = over - narrower;
  // Beyond the normals through the ends of the fillet the corner touches the floor or the wall first.
  const bool is_within = across < 0 && up * cosine < across * sine;
  return is_within && narrower > 0 ? base::hypot(across, up) - narrower : 0;
}

class FilletCheck {
 public:
  FilletCheck(const FinishedPart& part, const CutterProfile& cutter) : part_(part), cutter_(cutter) {}

  std::optional<Gouge> check(const Edge& path, double z_from, double z_to) {
    const double half = path.from == path.to ? 0 : path.length() / 2;
    const Vec2 middle = path.from == path.to ? path.from : path.at(0.5);
    part_.wall_tree().within(
        middle, half + cutter_.flat + part_.greatest_fillet() + part_.greatest_draft_offset(), [&](int i) {
          const Wall& wall = part_.walls()[static_cast<std::size_t>(i)];
          if (wall.fillet > 0) against(wall, path, z_from, z_to);
        });
    return worst_;
  }

 private:
  void against(const Wall& wall, const Edge& path, double z_from, double z_to) {
    const double low = std::min(z_from, z_to), high = std::max(z_from, z_to);
    if (low >= wall.z_high) return;
    const double apart = part_.apart(wall, wall.z_low, path);
    const double depth = depth_in_fillet(cutter_, wall, apart, low - wall.z_low);
    if (depth <= 0 || (worst_ && depth <= worst_->depth)) return;
    const double least = depth_in_fillet(cutter_, wall, apart, high - wall.z_low);
    if (is_behind(wall, path)) return;
    if (depth - least > kFilletError && path.from != path.to && path.length() > kShortestPiece) {
      const double z = (z_from + z_to) / 2;
      against(wall, path.part(0, 0.5), z_from, z);
      against(wall, path.part(0.5, 1), z, z_to);
      return;
    }
    worst_ = Gouge{depth, nearest_place(path, wall.edge), low, false, wall.feature};
  }

  const FinishedPart& part_;
  CutterProfile cutter_;
  std::optional<Gouge> worst_;
};

}  // namespace

std::optional<Gouge> fillet_gouge_of(const FinishedPart& part, const Move& move,
                                     const CutterProfile& cutter) {
  if (part.greatest_fillet() <= 0) return std::nullopt;
  FilletCheck check(part, cutter);
  return check.check(move.is_vertical() ? Edge::line(move.path.from, move.path.from) : move.path, move.z_from,
                     move.z_to);
}

}  // namespace clearcut::verify
