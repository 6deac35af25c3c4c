// What a correct inset is, on thousands of random regions:
//   1. every loop closes bitwise, outer loops turn left, islands right, arcs' ends lie on their circle;
//   2. every point of its boundary lies d +- 1 um from the boundary of the region, and inside it;
//   3. a point of the region farther than d + 1 um from its boundary belongs to the inset, one nearer than d
//   - 1 um
//      does not. Random points, points beside the result, and local maxima of the clearance found by climbing
//      with exact distances (which share nothing with the Voronoi diagram) are asked;
//   4. the area agrees with a polygon offsetter on finely cut arcs.
// It cannot see crossings of the result with itself thinner than 2 um, other than by area.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <polyclipping/clipper.hpp>

#include "base/debug_sink.h"
#include "base/random.h"
#include "base/units.h"
#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "support/data.h"

namespace clearcut {
namespace {

constexpr double kPromise = 1e-3;  // mm
const Tolerances kTol;

struct Case {
  Region region;
  std::vector<double> levels;
};

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

using Generator = Case (*)(Random&);
struct Family {
  const char* name;
  Generator make;
  int share;  ///< of every hundred
};
constexpr Family kFamilies[] = {{"polygon", polygon, 10}, {"bulged", bulged, 16}, {"fillets", fillets, 18},
                                {"islands", islands, 14}, {"neck", neck, 10},     {"acute", acute, 5},
                                {"crumbs", crumbs, 7},    {"comb", comb, 5},      {"ring", ring, 7},
                                {"touching", touching, 8}};

// --- checks ---

double inside_distance(const Region& region, Vec2 p) {
  const double d = region.boundary_distance(p);
  return region.contains(p) ? d : -d;
}

/// A local maximum of the clearance near p, by a shrinking pattern search on exact distances.
Vec2 climb(const Region& region, Vec2 p) {
  double here = inside_distance(region, p);
  for (double step = 2; step > 1e-5;) {
    Vec2 best = p;
    for (int i = 0; i < 6; ++i) {
      const Vec2 q = p + direction_of(i * kPi / 3 + step) * step;
      const double there = inside_distance(region, q);
      if (there > here) {
        here = there;
        best = q;
      }
    }
    if (best == p) step *= 0.5;
    p = best;
  }
  return p;
}

class Checker {
 public:
  Checker(const Region& region, double d, const Regions& result, Random& random)
      : region_(region), d_(d), result_(result), random_(random) {}

  /// Empty when all is well.
  std::string fault() {
    for (const Region& r : result_) {
      check_loop(r.outer(), 1);
      for (const Loop& island : r.islands()) check_loop(island, -1);
    }
    const Box box = region_.box();
    for (int i = 0; i < 12; ++i)
      check_point({random_.between(box.min.x, box.max.x), random_.between(box.min.y, box.max.y)});
    return fault_;
  }

  void check_point(Vec2 p) {
    const double c = inside_distance(region_, p);
    if (c > d_ + kPromise && !contains(result_, p)) fail("missing", p, c);
    if (c < d_ - kPromise && contains(result_, p)) fail("too much", p, c);
  }
  const std::string& found() const { return fault_; }

 private:
  void check_loop(const Loop& loop, double sign) {
    if (signed_area(loop) * sign <= 0) fail("orientation", loop.front().from, signed_area(loop));
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Edge& e = loop[i];
      if (e.to != loop[(i + 1) % loop.size()].from) fail("open", e.to, 0);
      if (e.is_arc() && std::abs(norm(e.from - e.center) - norm(e.to - e.center)) > 1e-8)
        fail("arc", e.from, 0);
      for (const double t : {0.0, 0.13, 0.31, 0.5, 0.69, 0.87}) check_boundary_point(e, t);
    }
  }

  void check_boundary_point(const Edge& e, double t) {
    const Vec2 p = e.at(t);
    const double c = inside_distance(region_, p);
    worst = std::max(worst, std::abs(c - d_));
    if (!(std::abs(c - d_) <= kPromise)) fail("distance", p, c);
    // Beside the result: in and out must be told apart where the clearance says which is which.
    if (t != 0.5) return;
    const Vec2 n = left_of(e.tangent_at(t)) * (3 * kPromise);
    check_point(p + n);
    check_point(p - n);
  }

  void fail(const char* what, Vec2 p, double value) {
    if (!fault_.empty()) return;
    char text[200];
    std::snprintf(text, sizeof text, "%s at (%.9g, %.9g): %.9g for %.9g", what, p.x, p.y, value, d_);
    fault_ = text;
  }

  const Region& region_;
  double d_;
  const Regions& result_;
  Random& random_;
  std::string fault_;

 public:
  double worst = 0;
};

void draw(DebugSink& sink, const Region& region, const char* color) {
  for (const Edge& e : region.edges()) {
    if (e.is_arc()) {
      sink.arc(e.from.x, e.from.y, e.to.x, e.to.y, e.center.x, e.center.y, e.turn == Turn::kCounterClockwise,
               color);
    } else {
      sink.line(e.from.x, e.from.y, e.to.x, e.to.y, color);
    }
  }
}

void leave_picture(const std::string& name, const Region& region, const Regions& result) {
  SvgFrames frames(std::filesystem::path(CLEARCUT_BINARY_DIR) / "debug", name);
  frames.frame("inset");
  draw(frames, region, "black");
  for (const Region& r : result) draw(frames, r, "red");
}

ClipperLib::Path to_clipper(const Loop& loop) {
  ClipperLib::Path path;
  for (const Vec2 p : flattened(loop, 1e-4))
    path.push_back({std::llround(p.x * 1e6), std::llround(p.y * 1e6)});
  return path;
}

double peer_area(const Region& region, double d) {
  ClipperLib::ClipperOffset offset(2, 1e6 * 1e-4);
  offset.AddPath(to_clipper(region.outer()), ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  for (const Loop& island : region.islands()) {
    offset.AddPath(to_clipper(island), ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  }
  ClipperLib::Paths out;
  offset.Execute(out, -d * 1e6);
  double sum = 0;
  for (const auto& path : out) sum += ClipperLib::Area(path) * 1e-12;
  return sum;
}

double perimeter(const Regions& regions) {
  double sum = 0;
  for (const Region& r : regions) {
    for (const Edge& e : r.edges()) sum += e.length();
  }
  return sum;
}

const Family& family_of(int i) {
  int share = i * 37 % 100;
  for (const Family& family : kFamilies) {
    if (share < family.share) return family;
    share -= family.share;
  }
  return kFamilies[0];
}

std::vector<double> levels_of(const Case& c, double largest, Random& random) {
  std::vector<double> levels{random.between(0.001, largest), largest * (1 - random.between(0, 0.01))};
  if (!c.levels.empty()) levels.push_back(c.levels[random.below(c.levels.size())]);
  std::sort(levels.begin(), levels.end());
  return levels;
}

/// Axis points lie as far from the boundary as they say, no climbed peak is higher than the largest
/// clearance, fit lines keep to the distance they promise.
std::string check_axis(const Case& c, const Clearance& clearance, const std::vector<Vec2>& peaks, double d) {
  char text[200] = "";
  const auto complain = [&](const char* what, Vec2 p, double is, double should) {
    std::snprintf(text, sizeof text, "%s at (%.9g, %.9g): %.9g for %.9g", what, p.x, p.y, is, should);
  };
  for (const AxisPoint& p : clearance.axis().points) {
    const double is = std::max(0.0, inside_distance(c.region, p.point));
    if (std::abs(is - p.clearance) > kPromise) complain("axis", p.point, p.clearance, is);
  }
  for (const AxisEdge& e : clearance.axis().edges) {
    if (e.a == e.b) complain("axis edge", {}, e.a, e.b);
  }
  for (const Vec2 p : peaks) {
    const double is = inside_distance(c.region, p);
    if (is > clearance.max() + kPromise) complain("largest", p, clearance.max(), is);
  }
  for (const Path& path : clearance.fit_lines(d)) {
    for (const Edge& e : path) {
      for (const double t : {0.0, 0.2, 0.5, 1.0}) {
        const double is = inside_distance(c.region, e.at(t));
        if (std::abs(is - d) > kTol.fit + kPromise / 2) complain("fit line", e.at(t), is, d);
      }
    }
  }
  return text;
}

/// One region at a few levels; what is wrong with it, or nothing.
std::string check_case(const std::string& name, const Case& c, int seed, Random& random) {
  const Clearance clearance(c.region, kTol);
  const auto levels = levels_of(c, clearance.max(), random);
  const auto results = clearance.insets(levels);
  std::vector<Vec2> peaks;
  const Box box = c.region.box();
  for (int i = 0; i < 2; ++i) {
    peaks.push_back(
        climb(c.region, {random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y)}));
  }
  const std::string axis_fault = check_axis(c, clearance, peaks, levels[random.below(levels.size())]);
  if (!axis_fault.empty()) return name + ": " + axis_fault;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    Checker checker(c.region, levels[i], results[i], random);
    std::string fault = checker.fault();
    for (const Vec2 p : peaks) checker.check_point(p);
    if (fault.empty()) fault = checker.found();
    if (fault.empty() && seed % 50 == 0) {
      const double ours = area(results[i]), peers = peer_area(c.region, levels[i]);
      // Chords and rounding of the peer, and our promise, along the whole boundary.
      if (std::abs(ours - peers) > 5e-4 * perimeter(results[i]) + 1e-4) {
        fault = "area " + std::to_string(ours) + ", peer's " + std::to_string(peers);
      }
    }
    if (!fault.empty()) {
      leave_picture(name, c.region, results[i]);
      return name + ": " + fault;
    }
  }
  return {};
}

int case_count() {
  const char* set = std::getenv("CLEARCUT_CASES");
  return set != nullptr ? std::atoi(set) : 10000;
}

TEST(GeometryProperty, InsetsOfRandomRegions) {
  int faults = 0;
  const char* only = std::getenv("CLEARCUT_FAMILY");
  for (int seed = 0; seed < case_count() && faults < 20; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Family& family = family_of(seed);
    if (only != nullptr && family.name + ("-" + std::to_string(seed)) != only &&
        std::string(only) != family.name)
      continue;
    const Case c = family.make(random);
    std::string fault;
    try {
      fault = check_case(std::string(family.name) + "-" + std::to_string(seed), c, seed, random);
    } catch (const std::exception& e) {
      fault = std::string(family.name) + "-" + std::to_string(seed) + ": " + e.what();
    }
    if (fault.empty()) continue;
    ADD_FAILURE() << fault;
    ++faults;
  }
}

/// Union, difference and intersection of two random regions: asked at random points and beside the result.
std::string check_boolean(const Region& a, const Region& b, Random& random) {
  const Regions both = unite({a}, {b}, kTol), common = intersect({a}, {b}, kTol),
                rest = subtract({a}, {b}, kTol);
  std::vector<Vec2> points;
  const Box box = clearcut::box({a, b});
  for (int i = 0; i < 30; ++i) {
    points.push_back({random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y)});
  }
  for (const Regions* result : {&both, &common, &rest}) {
    for (const Region& r : *result) {
      for (const Edge& e : r.edges()) {
        const Vec2 p = e.at(0.37), n = left_of(e.tangent_at(0.37)) * (2 * kPromise);
        if (std::min(a.boundary_distance(p), b.boundary_distance(p)) > 4 * kTol.chord) return "off the walls";
        points.push_back(p + n);
        points.push_back(p - n);
      }
    }
  }
  for (const Vec2 p : points) {
    if (std::min(a.boundary_distance(p), b.boundary_distance(p)) < kPromise) continue;
    const bool in_a = a.contains(p), in_b = b.contains(p);
    if (contains(both, p) != (in_a || in_b)) return "union";
    if (contains(common, p) != (in_a && in_b)) return "intersection";
    if (contains(rest, p) != (in_a && !in_b)) return "difference";
  }
  const double balance = area(both) + area(common) - a.area() - b.area();
  return std::abs(balance) > 0.05 ? "areas" : "";
}

TEST(GeometryProperty, BooleansOfRandomRegions) {
  int faults = 0;
  for (int seed = 0; seed < case_count() / 20 && faults < 20; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 1000000);
    const Region a = family_of(seed).make(random).region, b = family_of(seed + 7).make(random).region;
    const std::string fault = check_boolean(a, b, random);
    if (fault.empty()) continue;
    ADD_FAILURE() << family_of(seed).name << " and " << family_of(seed + 7).name << ", seed " << seed << ": "
                  << fault;
    ++faults;
  }
}

Region read_shape(const std::filesystem::path& file) {
  std::ifstream in(file);
  const auto json = nlohmann::json::parse(in);
  const auto loop_of = [](const nlohmann::json& vertices) {
    std::vector<BulgeVertex> bulges;
    for (const auto& v : vertices) {
      bulges.push_back({{v[0].get<double>(), v[1].get<double>()}, v.size() > 2 ? v[2].get<double>() : 0.0});
    }
    return loop_from_bulges(bulges);
  };
  std::vector<Loop> islands;
  for (const auto& island : json["islands"]) islands.push_back(loop_of(island));
  return Region::from_valid_loops(loop_of(json["outer"]), islands);
}

/// The fishhead's pockets have corner arcs of the cutter's radius, with noise of some um.
TEST(GeometryProperty, InsetsOfTheSharedShapes) {
  CLEARCUT_SKIP_WITHOUT_DATA();
  int shapes = 0;
  for (const auto& file : std::filesystem::directory_iterator(*test_support::data_folder() / "shapes")) {
    if (file.path().extension() != ".json") continue;
    ++shapes;
    const Region region = read_shape(file.path());
    for (int seed = 0; seed < 5; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      EXPECT_EQ(check_case(file.path().stem().string(), {region, {5, 5, 4.99, 5.01, 2}}, seed, random), "");
    }
    const double largest = Clearance(region, kTol).max();
    EXPECT_EQ(inset(region, 5, kTol).empty(), largest <= 5) << file.path();
  }
  EXPECT_GT(shapes, 10);
}

}  // namespace
}  // namespace clearcut
