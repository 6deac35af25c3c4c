#include "plan/legal_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace clearcut {
namespace {

/// Joints that turn by less are smooth: the arcs beside them bend, not the joint.
constexpr double kSmoothSine = 1e-6;
/// Above this many corners pairs are not remembered any more.
constexpr std::size_t kMostRemembered = 6000;
/// Tangents about one arc; where the area is too narrow for them they are halved up to here.
constexpr int kMostTangents = 512;

bool ordered(Vec2 a, Vec2 b) {
  return a.x < b.x || (a.x == b.x && a.y <= b.y);
}

}  // namespace

LegalWays::LegalWays(const Regions& legal) : area_(legal) {
  for (const auto& region : legal) {
    add_corners(region.outer());
    for (const auto& island : region.islands()) add_corners(island);
  }
  if (corners_.size() <= kMostRemembered) {
    seen_ = std::make_unique<std::atomic<signed char>[]>(corners_.size() * corners_.size());
  }
}

/// The area lies on the left of its boundary, so what turns right sticks out into it.
void LegalWays::add_corners(const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Edge& edge = loop[i];
    const Edge& next = loop[i + 1 == loop.size() ? 0 : i + 1];
    if (edge.turn == Turn::kClockwise) add_wrap(edge);
    const Vec2 in = edge.tangent_at(1), out = next.tangent_at(0);
    const bool back = dot(in, out) < 0 && std::abs(cross(in, out)) <= kSmoothSine;
    if (cross(in, out) < -kSmoothSine || back) corners_.push_back(edge.to);
  }
}

/// Where neighbouring tangents of the arc meet.
void LegalWays::add_wrap(const Edge& arc) {
  const double sweep = std::abs(arc.sweep()), radius = arc.radius();
  const double step = Radians::of_degrees(kWrapDegrees).radians();
  for (int count = std::max(1, static_cast<int>(std::ceil(sweep / step))); count <= kMostTangents;
       count *= 2) {
    const double reach = radius / std::cos(sweep / count / 2);
    std::vector<Vec2> wrap;
    for (int i = 0; i < count; ++i) {
      wrap.push_back(arc.center + unit(arc.at((i + 0.5) / count) - arc.center) * reach);
    }
    if (count < kMostTangents &&
        !std::all_of(wrap.begin(), wrap.end(), [&](Vec2 p) { return area_.holds(p); }))
      continue;
    std::copy_if(wrap.begin(), wrap.end(), std::back_inserter(corners_),
                 [&](Vec2 p) { return area_.holds(p); });
    return;
  }
}

bool LegalWays::joined(std::size_t i, std::size_t j) const {
  if (i > j) std::swap(i, j);
  if (!seen_) return area_.holds_line(corners_[i], corners_[j]);
  auto& seen = seen_[i * corners_.size() + j];
  signed char answer = seen.load(std::memory_order_relaxed);
  if (answer == 0) {
    answer = area_.holds_line(corners_[i], corners_[j]) ? 1 : -1;
    seen.store(answer, std::memory_order_relaxed);
  }
  return answer > 0;
}

std::vector<std::size_t> LegalWays::corners_within(Vec2 a, Vec2 b, double reach) const {
  std::vector<std::size_t> found;
  const Vec2 middle = lerp(a, b, 0.5);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec2 off = corners_[i] - middle;
    if (std::abs(off.x) > reach / 2 || std::abs(off.y) > reach / 2) continue;
    if (distance(a, corners_[i]) + distance(corners_[i], b) <= reach) found.push_back(i);
  }
  return found;
}

/// Dijkstra over the corners inside the ellipse of all points whose way to a and b sums to `reach`.
std::optional<std::vector<Vec2>> LegalWays::way_within(Vec2 a, Vec2 b, double reach) const {
  const auto corners = corners_within(a, b, reach);
  const std::size_t count = corners.size();
  constexpr double kFar = std::numeric_limits<double>::infinity();
  // Places 0 .. count - 1 are the corners, `count` is a, count + 1 is b.
  const auto place = [&](std::size_t i) { return i < count ? corners_[corners[i]] : i == count ? a : b; };
  const auto sees = [&](std::size_t i, std::size_t j) {
    if (i < count && j < count) return joined(corners[i], corners[j]);
    return area_.holds_line(place(i), place(j));
  };
  std::vector<double> length(count + 2, kFar);
  std::vector<std::size_t> before(count + 2, count);
  std::vector<char> done(count + 2, 0);
  length[count] = 0;
  for (;;) {
    std::size_t at = count + 2;
    for (std::size_t i = 0; i < count + 2; ++i) {
      if (!done[i] && length[i] < kFar && (at == count + 2 || length[i] < length[at])) at = i;
    }
    if (at == count + 2) return std::nullopt;
    if (at == count + 1) break;
    done[at] = 1;
    for (std::size_t j = 0; j < count + 2; ++j) {
      const double on = length[at] + distance(place(at), place(j));
      if (done[j] || on >= length[j] || on + distance(place(j), b) > reach || !sees(at, j)) continue;
      length[j] = on;
      before[j] = at;
    }
  }
  std::vector<Vec2> bends;
  for (std::size_t i = before[count + 1]; i != count; i = before[i]) bends.push_back(place(i));
  std::reverse(bends.begin(), bends.end());
  return bends;
}

std::optional<std::vector<Vec2>> LegalWays::bends(Vec2 a, Vec2 b) const {
  if (area_.holds_line(a, b)) return std::vector<Vec2>{};
  if (!ordered(a, b)) {
    auto back = bends(b, a);
    if (back) std::reverse(back->begin(), back->end());
    return back;
  }
  for (double reach = 1.5 * distance(a, b);; reach *= 2) {
    const bool all = corners_within(a, b, reach).size() == corners_.size();
    auto way = way_within(a, b, all ? std::numeric_limits<double>::infinity() : reach);
    if (way || all) return way;
  }
}

}  // namespace clearcut
