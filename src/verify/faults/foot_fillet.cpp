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

double distance_from(const Edge& path, const Edge& wall) {
  return path.from == path.to ? distance(wall, path.from) : distance(path, wall);
}

/// The point of the path nearest to the wall, by alternate projections: good enough for messages.
Vec2 nearest_place(const Edge& path, const Edge& wall) {
  if (path.from == path.to) return path.from;
  Vec2 place = path.at(0.5);
  for (int i = 0; i < kProjections; ++i) place = nearest_point(path, nearest_point(wall, place));
  return place;
}

/// mm; depth below the fillet's surface of a cutter `apart` mm from the wall with its tip `above` mm over the floor; 0 or less: none.
double depth_in_fillet(const CutterProfile& cutter, double fillet, double apart, double above) {
  const double narrower = fillet - cutter.round;
  // A cutter that is nearer than its radius cuts the wall itself, or is over the material behind it.
  const double across = std::max(apart - cutter.flat - fillet, -narrower),
               up = std::max(0.0, above) - narrower;
  if (across >= 0 || up >= 0) return 0;
  return base::hypot(across, up) - narrower;
}

class FilletCheck {
 public:
  FilletCheck(const FinishedPart& part, const CutterProfile& cutter) : part_(part), cutter_(cutter) {}

  std::optional<Gouge> check(const Edge& path, double z_from, double z_to) {
    const double half = path.from == path.to ? 0 : path.length() / 2;
    const Vec2 middle = path.from == path.to ? path.from : path.at(0.5);
    part_.wall_tree().within(middle, half + cutter_.flat + part_.greatest_fillet(), [&](int i) {
      const Wall& wall = part_.walls()[static_cast<std::size_t>(i)];
      if (wall.fillet > 0) against(wall, path, z_from, z_to);
    });
    return worst_;
  }

 private:
  void against(const Wall& wall, const Edge& path, double z_from, double z_to) {
    const double low = std::min(z_from, z_to), high = std::max(z_from, z_to);
    if (low >= wall.z_high) return;
    const double apart = distance_from(path, wall.edge);
    const double depth = depth_in_fillet(cutter_, wall.fillet, apart, low - wall.z_low);
    if (depth <= 0 || (worst_ && depth <= worst_->depth)) return;
    const double least = depth_in_fillet(cutter_, wall.fillet, apart, high - wall.z_low);
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
