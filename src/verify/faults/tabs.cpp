#include "verify/faults/tabs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text/format.h"

namespace clearcut::verify {
namespace {

/// Number of points tested on a sloping move, besides the nearest one.
constexpr int kPlaces = 64;

/// The lowest tip of a cutter while it covered a place.
struct Lowest {
  double z = std::numeric_limits<double>::infinity();
  int line = 0;
};

void lower(const CheckedMove& checked, Vec2 at, Lowest& lowest) {
  const Move& move = *checked.move;
  if (checked.radius() <= 0 || checked.low_z() >= lowest.z) return;
  const auto sample = [&](double t) {
    const Vec2 center = move.is_vertical() ? move.path.from : move.path.at(t);
    if (distance(center, at) >= checked.radius()) return;
    const double z = move.is_vertical() ? checked.low_z() : move.z_from + (move.z_to - move.z_from) * t;
    if (z < lowest.z) lowest = {z, move.line};
  };
  if (move.is_vertical()) return sample(0);
  if (!move.path.box().grown(checked.radius()).contains(at)) return;
  sample(nearest(move.path, at).t);
  if (checked.is_flat()) return;
  for (int i = 0; i <= kPlaces; ++i) sample(static_cast<double>(i) / kPlaces);
}

std::string place_of(const Tab& tab, int line) {
  std::string text = " at x " + trimmed(tab.center.x, 3) + " y " + trimmed(tab.center.y, 3);
  if (line > 0) text += ", line " + std::to_string(line);
  return text + ".";
}

}  // namespace

std::vector<Fault> faults_of_tabs(const Part& part, const CheckedProgram& program, const Tolerances& tol) {
  std::vector<Fault> faults;
  for (const Feature& feature : part.features) {
    if (!feature.profile) continue;
    for (const Tab& tab : feature.profile->tabs) {
      Lowest lowest;
      for (const CheckedMove& checked : program.moves) lower(checked, tab.center, lowest);
      if (std::abs(lowest.z - tab.top_z) <= tol.uncut) continue;
      const double under = tab.bottom_z + feature.profile->beyond;
      const double asked = tab.top_z - under, height = std::min(lowest.z, feature.top_z + asked) - under;
      const bool missing = height <= tol.uncut;
      const std::string what = missing ? "the tab is cut away"
                               : std::isinf(lowest.z)
                                   ? "nothing is cut over the tab"
                                   : "the tab stands " + trimmed(height, 3) + " mm high where " +
                                         trimmed(asked, 3) + " mm is asked";
      faults.push_back({missing ? FaultKind::kMissingTab : FaultKind::kTabHeight,
                        feature.name,
                        {tab.center, std::isinf(lowest.z) ? tab.top_z : lowest.z, lowest.line},
                        std::abs(asked - height),
                        feature.name + ": " + what + place_of(tab, lowest.line)});
    }
  }
  return faults;
}

}  // namespace clearcut::verify
