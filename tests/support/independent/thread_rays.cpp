#include "support/independent/thread_rays.h"

#include <algorithm>
#include <cmath>

namespace clearcut::test_support {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr std::size_t kRays = 36;
/// mm. Steps along a way, and what they and rounded words may make of a radius.
constexpr double kStep = 0.05, kSlack = 0.05;
/// Of a turn, about which a tooth may lie beside the helix of the others.
constexpr double kOffHelix = 0.05;

}  // namespace

ThreadRays::ThreadRays(const MadeThread& thread) : thread_(thread), rays_(kRays) {}

void ThreadRays::cut(const MadeCutter& mill, const BodyWay& way) {
  const double length = std::hypot(way.x1 - way.x0, way.y1 - way.y0, way.z1 - way.z0);
  const double radius = mill.body.diameter / 2;
  const double near = std::max(thread_.crest, thread_.root) + radius + length;
  if (std::hypot(way.x0 - thread_.x, way.y0 - thread_.y) > near) return;
  const int steps = 1 + static_cast<int>(length / kStep);
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double z = std::lerp(way.z0, way.z1, t);
    if (z > thread_.top + thread_.pitch) continue;
    touch(mill, std::lerp(way.x0, way.x1, t) - thread_.x, std::lerp(way.y0, way.y1, t) - thread_.y, z);
  }
}

/// The tooth of each row, where it reaches farthest past the crest of the thread: on the ray through the mill's axis.
void ThreadRays::touch(const MadeCutter& mill, double x, double y, double z) {
  const double apart = std::hypot(x, y), radius = mill.body.diameter / 2, turns = std::atan2(y, x) / kTurn;
  if (apart - radius > std::max(thread_.crest, thread_.root)) return;
  const double reached = thread_.is_inner() ? apart + radius : apart - radius;
  const int rows = mill.length > 0 ? static_cast<int>(mill.length / mill.pitch + 0.001) : 1;
  const auto ray = static_cast<std::size_t>(std::lround((turns + 1) * kRays)) % kRays;
  for (int row = 0; row < rows; ++row) {
    const Touch touch{z + row * mill.pitch, reached, turns};
    const bool is_within =
        touch.z > thread_.bottom - 2 * thread_.pitch && touch.z < thread_.top + thread_.pitch;
    if (is_within && beyond_crest(touch) > 0) rays_[ray].push_back(touch);
  }
}

double ThreadRays::beyond_crest(const Touch& touch) const {
  return thread_.is_inner() ? touch.radius - thread_.crest : thread_.crest - touch.radius;
}

/// Turns of the thread's helix to there from z = 0 on the first ray.
double ThreadRays::helix_turns(const Touch& touch) const {
  return touch.z / thread_.pitch - thread_.hand * touch.turns;
}

/// All teeth in the wall lie on one helix.
std::string ThreadRays::off_helix() const {
  double x = 0, y = 0;
  for (const std::vector<Touch>& ray : rays_) {
    for (const Touch& touch : ray) {
      if (beyond_crest(touch) < kSlack) continue;
      x += std::cos(kTurn * helix_turns(touch));
      y += std::sin(kTurn * helix_turns(touch));
    }
  }
  const double middle = std::atan2(y, x) / kTurn;
  for (const std::vector<Touch>& ray : rays_) {
    for (const Touch& touch : ray) {
      const double off = std::remainder(helix_turns(touch) - middle, 1.0);
      if (beyond_crest(touch) > kSlack && std::abs(off) > kOffHelix)
        return "thread: a tooth beside the helix at z " + std::to_string(touch.z);
    }
  }
  return "";
}

/// Within each pitch of the thread's height a tooth has come to the root.
std::string ThreadRays::not_cut(const std::vector<Touch>& ray) const {
  std::vector<double> full{thread_.bottom - thread_.pitch / 4};
  const double depth = std::abs(thread_.root - thread_.crest);
  for (const Touch& touch : ray)
    if (beyond_crest(touch) > depth - kSlack) full.push_back(touch.z);
  full.push_back(thread_.top + thread_.pitch / 4);
  std::sort(full.begin(), full.end());
  for (std::size_t i = 1; i < full.size(); ++i) {
    if (full[i] - full[i - 1] > 1.3 * thread_.pitch)
      return "thread: no groove between z " + std::to_string(full[i - 1]) + " and " + std::to_string(full[i]);
  }
  return "";
}

std::string ThreadRays::wrong() const {
  const double depth = std::abs(thread_.root - thread_.crest);
  for (const std::vector<Touch>& ray : rays_) {
    for (const Touch& touch : ray)
      if (beyond_crest(touch) > depth + kSlack)
        return "thread: beyond its root by " + std::to_string(beyond_crest(touch) - depth);
    const std::string missing = not_cut(ray);
    if (!missing.empty()) return missing;
  }
  return off_helix();
}

}  // namespace clearcut::test_support
