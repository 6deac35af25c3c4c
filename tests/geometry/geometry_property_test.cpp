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
#include <polyclipping/clipper.hpp>

#include "base/random.h"
#include "base/units.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "support/random/random_regions.h"
#include "support/shapes.h"

namespace clearcut {
namespace {

using test_support::family_of;
using test_support::RandomFamily;
using test_support::RandomRegion;

constexpr double kPromise = 1e-3;  // mm
const Tolerances kTol;

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

std::vector<double> levels_of(const RandomRegion& c, double largest, Random& random) {
  std::vector<double> levels{random.between(0.001, largest), largest * (1 - random.between(0, 0.01))};
  if (!c.levels.empty()) levels.push_back(c.levels[random.below(c.levels.size())]);
  std::sort(levels.begin(), levels.end());
  return levels;
}

/// Axis points lie as far from the boundary as they say, no climbed peak is higher than the largest
/// clearance, fit lines keep to the distance they promise.
std::string check_axis(const RandomRegion& c, const Clearance& clearance, const std::vector<Vec2>& peaks,
                       double d) {
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
std::string check_case(const std::string& name, const RandomRegion& c, int seed, Random& random) {
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
    if (!fault.empty()) return name + ": " + fault;
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
    const RandomFamily& family = family_of(seed);
    if (only != nullptr && family.name + ("-" + std::to_string(seed)) != only &&
        std::string(only) != family.name)
      continue;
    const RandomRegion c = family.make(random);
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

/// The fishhead's pockets have corner arcs of the cutter's radius, with noise of some um.
TEST(GeometryProperty, InsetsOfTheShapes) {
  const auto shapes = test_support::all_shapes();
  for (const auto& shape : shapes) {
    const Part part = test_support::part_of(shape);
    const Region& region = part.features.at(0).target.at(0);
    for (int seed = 0; seed < 5; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      EXPECT_EQ(check_case(shape.name, {region, {5, 5, 4.99, 5.01, 2}}, seed, random), "");
    }
    const double largest = Clearance(region, kTol).max();
    EXPECT_EQ(inset(region, 5, kTol).empty(), largest <= 5) << shape.name;
  }
  EXPECT_GT(shapes.size(), 10u);
}

}  // namespace
}  // namespace clearcut
