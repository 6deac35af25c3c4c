#include "support/random/random_regions.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/units.h"

namespace clearcut::test_support {
namespace {

using Case = RandomRegion;
using Family = RandomFamily;

// --- shapes ---

std::vector<Vec2> star_points(Random& random, int n, double low, double high) {
  std::vector<Vec2> points;
  const double turn = random.between(0, 2 * kPi);
  for (int i = 0; i < n; ++i) {
    const double angle = turn + 2 * kPi * (i + random.between(-0.35, 0.35)) / n;
    points.push_back(direction_of(angle) * random.between(low, high));
  }
  return points;
}

Loop moved(const Loop& loop, double turn, Vec2 by) {
  Loop out;
  for (const Edge& e : loop) {
    const auto move = [&](Vec2 p) { return rotated(p, turn) + by; };
    Edge edge{move(e.from), move(e.to), e.is_arc() ? move(e.center) : Vec2{}, e.turn};
    if (!out.empty()) edge.from = out.back().to;
    out.push_back(edge);
  }
  out.back().to = out.front().from;
  return out;
}

Loop circle(Vec2 c, double r) {
  const BulgeVertex vertices[] = {{c - Vec2{r, 0}, 1}, {c + Vec2{r, 0}, 1}};
  return loop_from_bulges(vertices);
}

Loop rectangle(Vec2 a, Vec2 b) {
  const Vec2 points[] = {a, {b.x, a.y}, b, {a.x, b.y}};
  return loop_from_points(points);
}

/// Corners of a polygon rounded by tangent arcs where they fit.
Loop filleted(const std::vector<Vec2>& p, double radius, double noise, Random& random) {
  std::vector<BulgeVertex> vertices;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 before = p[(i + p.size() - 1) % p.size()], here = p[i], after = p[(i + 1) % p.size()];
    const Vec2 in = unit(here - before), out = unit(after - here);
    const double turn = std::atan2(cross(in, out), dot(in, out));
    const double setback = radius * std::tan(std::abs(turn) / 2);
    const bool fits = 2.05 * setback < std::min(norm(here - before), norm(after - here));
    if (!fits || std::abs(turn) < 0.05) {
      vertices.push_back({here, 0});
      continue;
    }
    const auto shake = [&] { return Vec2{random.between(-noise, noise), random.between(-noise, noise)}; };
    vertices.push_back({here - in * setback + shake(), std::tan(turn / 4)});
    vertices.push_back({here + out * setback + shake(), 0});
  }
  return loop_from_bulges(vertices);
}

/// Free of crossings and of gaps under 0.02 mm, corners between 8 and 352 degrees.
bool is_clean(const std::vector<Loop>& loops) {
  std::vector<std::pair<const Edge*, const Edge*>> edges;  // with the edge after it
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) edges.emplace_back(&loop[i], &loop[(i + 1) % loop.size()]);
  }
  for (const auto& [edge, after] : edges) {
    const Vec2 a = -edge->tangent_at(1), b = after->tangent_at(0);
    if (std::abs(std::atan2(cross(a, b), dot(a, b))) < 8 * kPi / 180) return false;
    if (edge->length() < 1e-9) return false;
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge &a = *edges[i].first, &b = *edges[j].first;
      const int shared = (a.to == b.from ? 1 : 0) + (b.to == a.from ? 1 : 0);
      if (shared == 0 && distance(a, b) < 0.02) return false;
      if (shared > 0 && static_cast<int>(intersections(a, b).size()) > shared) return false;
    }
  }
  return true;
}

/// Outer loop with those of the islands that fit.
Region with_islands(Loop outer, const std::vector<Loop>& islands) {
  std::vector<Loop> all{outer};
  for (const Loop& island : islands) {
    all.push_back(island);
    const bool apart = std::none_of(all.begin() + 1, all.end() - 1, [&](const Loop& other) {
      return contains(other, island.front().from) || contains(island, other.front().from);
    });
    if (!apart || !contains(outer, island.front().from) || !is_clean(all)) all.pop_back();
  }
  return Region::from_valid_loops(outer, {all.begin() + 1, all.end()});
}

Loop clean_or(const std::function<Loop()>& make) {
  for (;;) {
    Loop loop = make();
    if (is_clean({loop})) return loop;
  }
}

// --- generators ---

Case polygon(Random& random) {
  const Loop loop = clean_or(
      [&] { return loop_from_points(star_points(random, 3 + static_cast<int>(random.below(12)), 3, 30)); });
  return {Region::from_valid_loops(loop, {}), {}};
}

Case bulged(Random& random) {
  const Loop loop = clean_or([&] {
    std::vector<BulgeVertex> vertices;
    for (const Vec2 p : star_points(random, 2 + static_cast<int>(random.below(8)), 5, 30)) {
      vertices.push_back({p, random.below(3) == 0 ? 0.0 : random.between(-0.8, 0.8)});
    }
    return loop_from_bulges(vertices);
  });
  return {Region::from_valid_loops(loop, {}), {}};
}

Case fillets(Random& random) {
  const double r = random.between(0.5, 6);
  const double noises[] = {0, 0, 1e-9, 1e-6, 1e-4, 6e-3};
  const double noise = noises[random.below(6)];
  const Loop loop = clean_or([&] {
    return filleted(star_points(random, 3 + static_cast<int>(random.below(6)), 12, 30), r, noise, random);
  });
  return {Region::from_valid_loops(loop, {}), {r, r + 1e-6, r - 1e-6, r - 1e-3, r + 1e-3, r * 0.5}};
}

Case islands(Random& random) {
  const Loop outer = clean_or([&] {
    const auto points = star_points(random, 4 + static_cast<int>(random.below(6)), 20, 30);
    return random.below(2) == 0 ? loop_from_points(points) : filleted(points, 4, 0, random);
  });
  std::vector<Loop> loops;
  const int count = 1 + static_cast<int>(random.below(4));
  for (int i = 0; i < count; ++i) {
    const Vec2 c{random.between(-20, 20), random.between(-20, 20)};
    if (random.below(2) == 0) {
      loops.push_back(circle(c, random.between(0.1, 6)));
    } else {
      loops.push_back(
          moved(loop_from_points(star_points(random, 3 + static_cast<int>(random.below(4)), 1, 6)), 0, c));
    }
  }
  return {with_islands(outer, loops), {}};
}

Case neck(Random& random) {
  const double d = random.between(0.5, 4);
  const double offsets[] = {0, 1e-6, -1e-6, 1e-3, -1e-3, 3e-4, -3e-4, 0.1, -0.1};
  const double h = d + offsets[random.below(9)] / 2;
  const double l = random.between(0.5, 10);
  const bool round = random.below(3) == 0;
  std::vector<BulgeVertex> v{{{l, -h}, 0},      {{l, -9}, 0},       {{l + 15, -9}, 0}, {{l + 15, 9}, 0},
                             {{l, 9}, 0},       {{l, h}, 0},        {{-l, h}, 0},      {{-l, 9}, 0},
                             {{-l - 15, 9}, 0}, {{-l - 15, -9}, 0}, {{-l, -9}, 0},     {{-l, -h}, 0}};
  // Walls of the neck may bow inwards: then it is narrowest in its middle.
  if (round) v[5].bulge = v[11].bulge = random.between(-0.1, -0.001);
  const Loop loop =
      moved(loop_from_bulges(v), random.between(0, 6), {random.between(-50, 50), random.between(-50, 50)});
  return {Region::from_valid_loops(loop, {}), {d, d * 0.5, d + 1e-3, d - 1e-3}};
}

Case acute(Random& random) {
  const double angle = random.between(8, 30) * kPi / 180, length = random.between(10, 40);
  const Vec2 points[] = {{0, 0}, {length, 0}, direction_of(angle) * length * random.between(0.5, 1)};
  const Loop loop = moved(loop_from_points(points), random.between(0, 6), {3, 4});
  return {Region::from_valid_loops(loop, {}), {}};
}

/// Vertices on lines, on them but for rounding noise, and very near others.
Case crumbs(Random& random) {
  std::vector<Vec2> points;
  const Loop base = clean_or([&] { return loop_from_points(star_points(random, 5, 10, 30)); });
  for (const Edge& e : base) {
    points.push_back(e.from);
    const double noises[] = {0, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3};
    const int count = static_cast<int>(random.below(4));
    for (int i = 1; i <= count; ++i) {
      points.push_back(e.at(i / (count + 1.0)) +
                       left_of(e.tangent_at(0)) * (noises[random.below(6)] * random.between(-1, 1)));
    }
    if (random.below(2) == 0) points.push_back(e.to - e.tangent_at(1) * noises[1 + random.below(5)]);
  }
  return {Region::from_valid_loops(loop_from_points(points), {}), {}};
}

Case comb(Random& random) {
  const double pitch = random.between(1.5, 5), tooth = pitch * random.between(0.2, 0.8);
  std::vector<Vec2> points{{0, 0}};
  const int teeth = 2 + static_cast<int>(random.below(6));
  points.push_back({teeth * pitch, 0});
  for (int i = teeth - 1; i >= 0; --i) {
    points.push_back({i * pitch + tooth, 5});
    points.push_back({i * pitch + tooth, 15});
    points.push_back({i * pitch, 15});
    points.push_back({i * pitch, 5});
  }
  points.push_back({0, 5.0});
  const Loop loop = moved(loop_from_points(points), random.between(0, 6), {0, 0});
  return {Region::from_valid_loops(loop, {}), {tooth / 2, tooth / 2 - 1e-3, tooth / 2 + 1e-3, tooth / 4}};
}

Case ring(Random& random) {
  const double inner = random.between(1, 10), width = random.between(0.5, 8);
  const double shifts[] = {0, 0, 1e-6, 1e-4, 1e-3, 0.05, 0.4};
  const double shift = width * shifts[random.below(7)];
  const Vec2 c = direction_of(random.between(0, 6)) * shift;
  const double half = width / 2;
  return {Region::from_valid_loops(circle({0, 0}, inner + width), {circle(c, inner)}),
          {half, half - 1e-3, half + 1e-3, half - 1e-5, half * 0.5, half * 0.9, half + shift / 4}};
}

/// Islands that touch a wall or each other in a vertex or tangentially.
Case touching(Random& random) {
  const Loop outer = rectangle({0, 0}, {40, 30});
  const double r = random.between(1, 5), x = random.between(8, 20);
  const Vec2 apex{x, 0};
  const Vec2 spike[] = {
      apex, {x + random.between(2, 6), random.between(3, 6)}, {x - 4, random.between(3, 9)}};
  std::vector<Loop> loops;
  switch (random.below(4)) {
    case 0:
      loops = {circle({x, r}, r)};  // tangent to the wall
      break;
    case 1:
      loops = {loop_from_points(spike)};  // a vertex on the wall
      break;
    case 2:
      loops = {circle({12, 15}, r), circle({12 + 2 * r, 15}, r)};
      break;
    default: {
      const Vec2 other[] = {{30, 20}, {26, 24}, spike[1]};
      loops = {loop_from_points(spike), loop_from_points(other)};
    }
  }
  const double turn = random.below(2) == 0 ? 0 : random.between(0, 6);
  Loop turned = moved(outer, turn, {});
  for (Loop& loop : loops) loop = moved(loop, turn, {});
  return {Region::from_valid_loops(turned, loops), {r, 2 * r}};
}

constexpr Family kFamilies[] = {{"polygon", polygon, 10}, {"bulged", bulged, 16}, {"fillets", fillets, 18},
                                {"islands", islands, 14}, {"neck", neck, 10},     {"acute", acute, 5},
                                {"crumbs", crumbs, 7},    {"comb", comb, 5},      {"ring", ring, 7},
                                {"touching", touching, 8}};

}  // namespace

const RandomFamily& family_of(int i) {
  int share = i * 37 % 100;
  for (const RandomFamily& family : kFamilies) {
    if (share < family.share) return family;
    share -= family.share;
  }
  return kFamilies[0];
}

}  // namespace clearcut::test_support
