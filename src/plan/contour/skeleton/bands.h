// The flexible paths of a skeleton as elastic bands, and the points holding them: the data of tightening.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/contour/skeleton/skeleton.h"

namespace clearcut::plan::contour {

/// Distance between the vertices of bands, as a share of the tool radius.
constexpr double kBandSpacing = 0.6;

/// A straight piece between two successive vertices of a flexible path; indices of points.
struct Band {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// A point to be cleared. It keeps the nearest band within the cutter's reach.
struct Witness {
  Vec2 p;
  bool moving = false;  ///< the witness is kept in the middle between the bands on both sides
  double near = 1e300;  ///< mm; distance to the nearest band at its last computation
  double when = 0;      ///< mm; value of Bands::moved at that time
};

/// A skeleton whose flexible paths are being shortened.
struct Bands {
  Skeleton skeleton;
  std::vector<Edge> fixed;  ///< the edges of the unchanged rings
  std::vector<Band> bands;  ///< the pieces of all flexible paths, one path after the other
  std::vector<Witness> witnesses;
  double moved = 0;  ///< mm; no band has moved farther than this since the beginning

  Vec2& at(std::uint32_t i) { return skeleton.points[i].at; }
  Vec2 at(std::uint32_t i) const { return skeleton.points[i].at; }
  Vec2 point(int i) const { return skeleton.points[static_cast<std::size_t>(i)].at; }
  bool on_ring(std::uint32_t i) const { return skeleton.points[i].ring >= 0; }

  /// Calls f(path) for every flexible path, in the order in which `bands` lists their pieces.
  template <typename F>
  void for_paths(F&& f) {
    for (auto& leg : skeleton.legs) {
      f(leg.path_in);
      for (auto& path : leg.detours) f(path);
    }
  }

  /// Lists the pieces of all paths, as they are now, in `bands`.
  void list() {
    bands.clear();
    for_paths([&](const std::vector<int>& path) {
      for (std::size_t i = 1; i < path.size(); ++i) {
        bands.push_back({static_cast<std::uint32_t>(path[i - 1]), static_cast<std::uint32_t>(path[i])});
      }
    });
  }
};

}  // namespace clearcut::plan::contour
