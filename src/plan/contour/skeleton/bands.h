// The paths of a skeleton as rubber bands, and what holds them. Used by the planner alone.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/contour/skeleton/skeleton.h"

namespace clearcut::plan::contour {

/// Spacing of the vertices of bands, as a share of the radius.
constexpr double kBandSpacing = 0.6;

/// A straight piece between neighbouring vertices of a flexible path.
struct Band {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// A place that has to be cut: it holds the band that is nearest to it.
struct Witness {
  Vec2 p;
  bool moving = false;  ///< keeps to the middle between the bands on both sides of it
  double near =
      1e300;  ///< distance of the nearest band when last looked at, and how far bands had moved by then
  double when = 0;
};

struct Bands {
  Skeleton skeleton;
  std::vector<Edge> fixed;  ///< the skeleton's rings
  std::vector<Band> bands;  ///< of all flexible paths, one path after the other
  std::vector<Witness> witnesses;
  double moved = 0;  ///< mm; no band has moved farther since the beginning

  Vec2& at(std::uint32_t i) { return skeleton.points[i].at; }
  Vec2 at(std::uint32_t i) const { return skeleton.points[i].at; }
  Vec2 point(int i) const { return skeleton.points[static_cast<std::size_t>(i)].at; }
  bool on_ring(std::uint32_t i) const { return skeleton.points[i].ring >= 0; }

  /// Calls f(path) for every flexible path, in the order of `bands`.
  template <typename F>
  void for_paths(F&& f) {
    for (auto& leg : skeleton.legs) {
      f(leg.path_in);
      for (auto& path : leg.detours) f(path);
    }
  }

  /// Sets `bands` to the pieces of the paths as they are now.
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
