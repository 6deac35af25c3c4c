#include "link/cleared.h"

#include <algorithm>
#include <cmath>

#include "base/tolerances.h"
#include "base/units.h"

namespace clearcut::link {
namespace {

/// Share of the radius: distance between two places of the cutter's rim that are looked at.
constexpr double kApart = 0.25;
/// mm. The rim that is looked at lies this far within the cutter, for rounding.
constexpr double kWithin = 0.001;
/// Radii. Longer straight moves are kept in pieces, so that the boxes of oblique ones are small.
constexpr double kPiece = 8;
/// Number of places looked at round the end of a path.
constexpr int kRound = 16;
/// Of the places along a path, every so many are looked at before those between them.
constexpr int kStride = 8;

}  // namespace

Cleared::Cleared(const Work& work, const LinkOptions& options)
    : work_(work), options_(options), swept_near_(4 * options.tool_radius) {
  for (std::size_t i = 0; i < work.layer_count(); ++i) wanted_ = wanted_ || may_stand(i);
}

bool Cleared::may_stand(std::size_t layer) const {
  return layer > 0 && work_.layer(layer).reaches_beside();
}

void Cleared::add(const MoveList& moves) {
  if (!wanted_) return;
  const double reach = options_.tool_radius;
  const auto keep = [&](const Edge& path, double z) {
    swept_near_.add(path.box().grown(reach), static_cast<std::uint32_t>(swept_.size()));
    swept_.push_back({path, z});
  };
  for (; moves_added_ < moves.all().size(); ++moves_added_) {
    const Move& move = moves.all()[moves_added_];
    if (is_rapid(move.kind)) continue;
    const double z = move.is_vertical() ? move.z_to : std::max(move.z_from, move.z_to);
    const int pieces = 1 + static_cast<int>(move.path.length() / (kPiece * reach));
    if (move.path.is_arc() || pieces == 1) {
      keep(move.path, z);
      continue;
    }
    for (int k = 0; k < pieces; ++k)
      keep(move.path.part(static_cast<double>(k) / pieces, (k + 1.0) / pieces), z);
  }
}

bool Cleared::is_clear(std::size_t layer, const Edge& path) const {
  if (!may_stand(layer)) return true;
  const double rim = options_.tool_radius - kWithin;
  for (int k = 0; k < kRound; ++k) {
    const Vec2 out = direction_of(2 * kPi * k / kRound) * rim;
    if (!holds(layer, path.to + out) || !holds(layer, path.from + out)) return false;
  }
  if (path.from == path.to) return true;
  const int steps = 1 + static_cast<int>(path.length() / (kApart * options_.tool_radius));
  // Every kStride-th place first: most paths that meet material do so over many places.
  for (int first = 0; first < kStride; ++first) {
    for (int k = first; k <= steps; k += kStride) {
      const double t = static_cast<double>(k) / steps;
      const Vec2 p = path.at(t), side = left_of(path.tangent_at(t)) * rim;
      if (!holds(layer, p + side) || !holds(layer, p - side)) return false;
    }
  }
  return true;
}

/// Whether nothing stands at p above the top of the layer.
bool Cleared::holds(std::size_t layer, Vec2 p) const {
  if (options_.stock && !options_.stock->contains(p)) return true;
  if (work_.layer(layer - 1).target_area().contains(p)) return true;
  const double top = work_.layer(layer).layer().z_top + kSamePlaceMm;
  const auto near = swept_near_.at(p);
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t i) {
    return swept_[i].z <= top && distance(nearest(swept_[i].path, p).point, p) <= options_.tool_radius;
  });
}

}  // namespace clearcut::link
