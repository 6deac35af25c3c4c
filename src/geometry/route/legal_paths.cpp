#include "geometry/route/legal_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::inline geometry {
namespace {

/// Joints turning by less than this are smooth: the arcs beside them bend, not the joint.
constexpr double kSmoothSine = 1e-6;
/// Above this many corners pairs are not remembered any more.
constexpr std::size_t kMostRemembered = 6000;
/// Above this many pairs of a place and a corner they are not remembered either.
constexpr std::size_t kMostSights = 36'000'000;
/// Tangents about one arc; if the area is too narrow for the tangents they are halved, up to this number.
constexpr int kMostTangents = 512;

/// Bound, with a large safety factor, on the relative rounding error of sums of lengths.
constexpr double kRounding = 1e-12;

/// The result of `ask`, called once.
template <typename Ask>
bool remembered(std::atomic<signed char>& known, Ask&& ask) {
  signed char answer = known.load(std::memory_order_relaxed);
  if (answer == 0) {
    answer = ask() ? 1 : -1;
    known.store(answer, std::memory_order_relaxed);
  }
  return answer > 0;
}

bool ordered(Vec2 a, Vec2 b) {
  return a.x < b.x || (a.x == b.x && a.y <= b.y);
}

}  // namespace

LegalPaths::LegalPaths(const Regions& legal) : area_(legal) {
  for (const auto& region : legal) {
    add_corners(region.outer());
    for (const auto& island : region.islands()) add_corners(island);
  }
  if (corners_.size() <= kMostRemembered) {
    seen_ = std::make_unique<std::atomic<signed char>[]>(corners_.size() * corners_.size());
  }
}

/// The area is on the left of its boundary, so corners and arcs turning right stick out into the area.
void LegalPaths::add_corners(const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Edge& edge = loop[i];
    const Edge& next = loop[i + 1 == loop.size() ? 0 : i + 1];
    if (edge.turn == Turn::kClockwise) add_wrap(edge);
    const Vec2 in = edge.tangent_at(1), out = next.tangent_at(0);
    const bool back = dot(in, out) < 0 && std::abs(cross(in, out)) <= kSmoothSine;
    if (cross(in, out) < -kSmoothSine || back) corners_.push_back(edge.to);
  }
}

/// Adds the intersections of neighbouring tangents of the arc.
void LegalPaths::add_wrap(const Edge& arc) {
  const double sweep = std::abs(arc.sweep()), radius = arc.radius();
  const double step = Radians::of_degrees(kWrapDegrees).radians();
  for (int count = std::max(1, static_cast<int>(std::ceil(sweep / step))); count <= kMostTangents;
       count *= 2) {
    const double reach = radius / base::cos(sweep / count / 2);
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

bool LegalPaths::joined(std::size_t i, std::size_t j) const {
  if (i > j) std::swap(i, j);
  const auto ask = [&] { return area_.holds_line(corners_[i], corners_[j]); };
  return seen_ ? remembered(seen_[i * corners_.size() + j], ask) : ask();
}

std::vector<std::size_t> LegalPaths::corners_within(Vec2 a, Vec2 b, double reach) const {
  std::vector<std::size_t> found;
  const Vec2 middle = lerp(a, b, 0.5);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec2 off = corners_[i] - middle;
    if (std::abs(off.x) > reach / 2 || std::abs(off.y) > reach / 2) continue;
    if (norm(corners_[i] - a) + norm(b - corners_[i]) <= reach) found.push_back(i);
  }
  return found;
}

/// Dijkstra over the corners inside the ellipse of all points whose distances to a and b sum to `reach`; the straight
/// move from a to b is known to be illegal.
std::optional<std::vector<Vec2>> LegalPaths::path_within(const End& a, const End& b, double reach) const {
  const auto corners = corners_within(a.point, b.point, reach);
  const std::size_t count = corners.size();
  constexpr double kFar = std::numeric_limits<double>::infinity();
  // Places 0 .. count - 1 are the corners, `count` is a, count + 1 is b.
  std::vector<Vec2> places;
  places.reserve(count + 2);
  for (const std::size_t i : corners) places.push_back(corners_[i]);
  places.insert(places.end(), {a.point, b.point});
  const auto sees = [&](std::size_t i, std::size_t j) {
    if (i >= count && j >= count) return false;
    if (i < count && j < count) return joined(corners[i], corners[j]);
    return (std::max(i, j) == count ? a : b).sees(corners[std::min(i, j)]);
  };
  std::vector<double> length(count + 2, kFar);
  std::vector<std::size_t> before(count + 2, count);
  std::vector<char> done(count + 2, 0);
  length[count] = 0;
  std::vector<double> left;  // at least so far to b
  left.reserve(count + 2);
  for (const Vec2 p : places) left.push_back(norm(b.point - p));
  for (;;) {
    // Corners farther away than the length of a known path lead to no shorter path.
    const double most = std::min(reach, length[count + 1] * (1 + kRounding));
    std::size_t at = count + 2;
    for (std::size_t i = 0; i < count + 2; ++i) {
      if (!done[i] && length[i] < kFar && (at == count + 2 || length[i] < length[at])) at = i;
    }
    if (at == count + 2) return std::nullopt;
    if (at == count + 1) break;
    done[at] = 1;
    if (length[at] + left[at] > most) continue;
    for (std::size_t j = 0; j < count + 2; ++j) {
      if (done[j]) continue;
      const double on = length[at] + norm(places[j] - places[at]);
      if (on >= length[j] || on + left[j] > most || !sees(at, j)) continue;
      length[j] = on;
      before[j] = at;
    }
  }
  std::vector<Vec2> bends;
  for (std::size_t i = before[count + 1]; i != count; i = before[i]) bends.push_back(places[i]);
  std::reverse(bends.begin(), bends.end());
  return bends;
}

std::optional<std::vector<Vec2>> LegalPaths::bends_between(const End& a, const End& b) const {
  if (area_.holds_line(a.point, b.point)) return std::vector<Vec2>{};
  if (!ordered(a.point, b.point)) {
    auto back = bends_between(b, a);
    if (back) std::reverse(back->begin(), back->end());
    return back;
  }
  for (double reach = 1.5 * distance(a.point, b.point);; reach *= 2) {
    const bool all = corners_within(a.point, b.point, reach).size() == corners_.size();
    auto path = path_within(a, b, all ? std::numeric_limits<double>::infinity() : reach);
    if (path || all) return path;
  }
}

std::optional<std::vector<Vec2>> LegalPaths::bends(Vec2 a, Vec2 b) const {
  const auto end = [&](Vec2 p) {
    return End{p, [this, p](std::size_t corner) { return area_.holds_line(p, corners_[corner]); }};
  };
  return bends_between(end(a), end(b));
}

LegalPaths::Between::Between(const LegalPaths& paths, const std::vector<Vec2>& places)
    : paths_(paths), places_(places) {
  const std::size_t pairs = places.size() * paths.corners_.size();
  if (pairs <= kMostSights) seen_ = std::make_unique<std::atomic<signed char>[]>(pairs);
}

bool LegalPaths::Between::sees(std::size_t place, std::size_t corner) const {
  const auto ask = [&] { return paths_.area_.holds_line(places_[place], paths_.corners_[corner]); };
  return seen_ ? remembered(seen_[place * paths_.corners_.size() + corner], ask) : ask();
}

std::optional<std::vector<Vec2>> LegalPaths::Between::bends(int a, int b) const {
  const auto end = [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    return End{places_[place], [this, place](std::size_t corner) { return sees(place, corner); }};
  };
  return paths_.bends_between(end(a), end(b));
}

}  // namespace clearcut::inline geometry
