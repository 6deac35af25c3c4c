// Random set-ups with clamps and a holder: the programs are driven through columns of the block and of the clamps, which share nothing
// with planning or verification but the program's text.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "support/independent/plain_gcode.h"
#include "support/plans.h"
#include "support/random/first_seed.h"
#include "support/random/random_parts.h"

namespace clearcut::test_support {
namespace {

constexpr double kCell = 0.5;               // mm; width of a column
constexpr double kChord = 0.002;            // mm; arcs as chords
constexpr double kSideways = 0.02;          // mm; rims of rapids that may rub
constexpr double kHeight = 0.005;           // mm; likewise of heights
constexpr double kSameWork = 0.98;          // of the feed; less of it leaves work beside clamps undone
constexpr double kWidth = 90, kDepth = 60;  // mm; of the block, whose top is at 0

/// A cylinder about the tool's axis, by its heights over the tip, mm.
struct Cylinder {
  double low, high, radius;
};
struct Clamp {
  double x0, y0, x1, y1, top;  // it begins under the block
};
struct Bench {
  double diameter, length, shank, stickout, holder;
  std::vector<Clamp> clamps;
  std::string pockets, strategy;
  std::string tool() const {
    const auto mm = [](double value) { return std::to_string(value); };
    return "endmill:" + mm(diameter) + ":length=" + mm(length) + ":shank=" + mm(shank) +
           ":stickout=" + mm(stickout) + ":holder=" + mm(holder);
  }
  std::array<Cylinder, 3> bodies() const {
    return {{{0, length, diameter / 2}, {length, stickout, shank / 2}, {stickout, 1e9, holder / 2}}};
  }
};

/// The times on a way from 0 to 1 during which its axis is within `radius` of a place; none if low > high.
struct During {
  double low = 1, high = 0;
  bool any() const { return low <= high; }
};
During near(const TipWay& way, double x, double y, double radius) {
  const double dx = way.x1 - way.x0, dy = way.y1 - way.y0, px = way.x0 - x, py = way.y0 - y;
  const double a = dx * dx + dy * dy, b = px * dx + py * dy, c = px * px + py * py - radius * radius;
  if (a < 1e-18) return c < 0 ? During{0, 1} : During{};
  const double root = b * b - a * c;
  if (root <= 0) return {};
  const double s = std::sqrt(root);
  return {std::max(0.0, (-b - s) / a), std::min(1.0, (-b + s) / a)};
}
double lowest(const TipWay& way, During when) {
  const double rise = way.z1 - way.z0;
  return way.z0 + std::min(rise * when.low, rise * when.high);
}

/// mm; how deep the tool comes into each kind of thing, 0 where it does not.
struct Crossings {
  double clamp = 0;     // cutter, shank or holder
  double material = 0;  // shank or holder
  double rapid = 0;     // the cutter at the rapid
};

/// Heights of what is left of the block, driven through move by move.
class Columns {
 public:
  explicit Columns(const Bench& bench) : bench_(bench) {
    for (int i = 0; i < kColumns * kRows; ++i) heights_.push_back(0);
  }
  void drive(const TipWay& way) {
    for (const Clamp& clamp : bench_.clamps) meet(way, clamp);
    const auto bodies = bench_.bodies();
    if (way.rapid) {
      visit(way, bodies[0].radius - kSideways, [&](double& height, During when) {
        found_.rapid = std::max(found_.rapid, height - kHeight - lowest(way, when));
      });
    } else {
      visit(way, bodies[0].radius,
            [&](double& height, During when) { height = std::min(height, lowest(way, when)); });
    }
    for (const Cylinder& body : {bodies[1], bodies[2]})
      visit(way, body.radius - kSideways, [&](double& height, During when) {
        found_.material = std::max(found_.material, height - kHeight - lowest(way, when) - body.low);
      });
  }
  Crossings found() const {
    Crossings out = found_;
    for (double* depth : {&out.clamp, &out.material, &out.rapid}) *depth = std::max(0.0, *depth);
    return out;
  }

 private:
  static constexpr int kColumns = static_cast<int>(kWidth / kCell), kRows = static_cast<int>(kDepth / kCell);
  template <typename Do>
  void visit(const TipWay& way, double radius, const Do& act) {
    if (std::min(way.z0, way.z1) > 0 && radius <= bench_.diameter / 2) return;
    const auto cell = [](double at, int most) {
      return std::clamp(static_cast<int>(std::floor(at / kCell)), 0, most - 1);
    };
    const int x0 = cell(std::min(way.x0, way.x1) - radius, kColumns),
              x1 = cell(std::max(way.x0, way.x1) + radius, kColumns),
              y0 = cell(std::min(way.y0, way.y1) - radius, kRows),
              y1 = cell(std::max(way.y0, way.y1) + radius, kRows);
    for (int i = x0; i <= x1; ++i)
      for (int k = y0; k <= y1; ++k)
        if (const During when = near(way, (i + 0.5) * kCell, (k + 0.5) * kCell, radius); when.any())
          act(heights_[static_cast<std::size_t>(i * kRows + k)], when);
  }
  /// Columns of a clamp, its edges among them.
  void meet(const TipWay& way, const Clamp& clamp) {
    if (std::min(way.z0, way.z1) >= clamp.top) return;
    const int nx = 1 + static_cast<int>((clamp.x1 - clamp.x0) / kCell),
              ny = 1 + static_cast<int>((clamp.y1 - clamp.y0) / kCell);
    for (int i = 0; i <= nx; ++i)
      for (int k = 0; k <= ny; ++k) {
        const double x = clamp.x0 + (clamp.x1 - clamp.x0) * i / nx,
                     y = clamp.y0 + (clamp.y1 - clamp.y0) * k / ny;
        for (const Cylinder& body : bench_.bodies()) {
          const During when = near(way, x, y, body.radius - 0.001);
          if (when.any())
            found_.clamp = std::max(found_.clamp, clamp.top - kHeight - lowest(way, when) - body.low);
        }
      }
  }
  const Bench& bench_;
  std::vector<double> heights_;
  Crossings found_;
};

std::string rectangle(double x0, double y0, double x1, double y1) {
  const auto corner = [](double x, double y) {
    return "[" + std::to_string(x) + "," + std::to_string(y) + "]";
  };
  return "[" + corner(x0, y0) + "," + corner(x1, y0) + "," + corner(x1, y1) + "," + corner(x0, y1) + "]";
}

/// One to four clamps that reach over the block's edges, a holder, one to three pockets.
Bench random_bench(std::uint64_t seed) {
  Random random(seed);
  Bench out;
  out.diameter = 4 + static_cast<double>(random.below(5));
  out.length = random.between(8, 16);
  out.shank = std::max(out.diameter, random.between(4, 10));
  out.stickout = out.length + random.between(2, 20);
  out.holder = random.between(16, 45);
  out.strategy = std::array{"contour", "zigzag", "adaptive", "spiral"}[seed % 4];
  for (auto clamps = 1 + random.below(4); clamps > 0; --clamps) {
    const double over = random.between(2, 12), wide = random.between(6, 20), top = random.between(1, 25);
    const double x = random.between(0, kWidth - 20), y = random.between(0, kDepth - 20);
    switch (random.below(4)) {
      case 0:
        out.clamps.push_back({x, -15, x + wide, over, top});
        break;
      case 1:
        out.clamps.push_back({x, kDepth - over, x + wide, kDepth + 15, top});
        break;
      case 2:
        out.clamps.push_back({-15, y, over, y + wide, top});
        break;
      default:
        out.clamps.push_back({kWidth - over, y, kWidth + 15, y + wide, top});
    }
  }
  const auto pockets = 1 + random.below(3);
  for (std::uint64_t i = 0; i < pockets; ++i) {
    const double x0 = 4 + 28 * static_cast<double>(i) + random.between(0, 6), y0 = random.between(4, 20);
    const double x1 = x0 + random.between(12, 18), y1 = y0 + random.between(14, 32);
    out.pockets += (i == 0 ? "" : ", ") + std::string(R"({"name": "p)") + std::to_string(i) +
                   R"(", "depth": )" + std::to_string(random.between(1, out.length - 0.5)) +
                   R"(, "outer": )" + rectangle(x0, y0, x1, y1) + "}";
  }
  return out;
}

PlanResult planned(const Bench& bench, bool clamped) {
  const std::string part =
      R"({"name": "clamped", "units": "mm", "stock": {"x": [0, 90], "y": [0, 60], "z": [-20, 0]}, "pockets": [)" +
      bench.pockets + "]}";
  PlanOptions options = plan_options_with({bench.tool()});
  options.strategy = bench.strategy;
  if (clamped)
    for (const Clamp& clamp : bench.clamps)
      options.keep_outs.push_back({{{clamp.x0, clamp.y0}, {clamp.x1, clamp.y1}}, -20, clamp.top});
  return pipeline::plan_part(read::read_part_text(part, "clamped.json", {}), options);
}

TEST(ClampedSetups, AreNotCrossed) {
  const int count = random_count(3);
  int checked = 0, refused = 0, faulty = 0, told = 0, less = 0;
  std::vector<double> shares;
  for (std::uint64_t seed = static_cast<std::uint64_t>(first_seed()); checked < count; ++seed) {
    const Bench bench = random_bench(seed);
    PlanResult result;
    try {
      result = planned(bench, true);
    } catch (const InputError& error) {
      ++refused;  // work under a clamp
      continue;
    }
    ++checked;
    Columns columns(bench);
    for (const TipWay& way : ways_of(result.program, kChord)) columns.drive(way);
    const Crossings found = columns.found();
    const bool crosses = found.clamp > 0 || found.material > 0 || found.rapid > 0;
    if (verdict_of(result.findings) == Verdict::kFaulty) {
      ++faulty;
      told += crosses;
      continue;
    }
    EXPECT_FALSE(crosses) << "set-up " << seed << ": clamp " << found.clamp << " material " << found.material
                          << " rapid " << found.rapid << " " << bench.tool() << " " << bench.strategy;
    const Figures without = planned(bench, false).findings.all, with = result.findings.all;
    if (with.feed_mm < kSameWork * without.feed_mm) {
      ++less;
    } else {
      shares.push_back(with.time_s / without.time_s);
    }
  }
  std::sort(shares.begin(), shares.end());
  const double mean = std::accumulate(shares.begin(), shares.end(), 0.0) / std::max<double>(1, shares.size());
  std::cout << checked << " set-ups checked, " << faulty << " of them faulty by their own verdict (" << told
            << " cross), " << refused << " more refused; " << less
            << " leave work beside clamps undone; of the others time against the path without clamps: mean "
            << mean << ", median " << (shares.empty() ? 0 : shares[shares.size() / 2]) << ", most "
            << (shares.empty() ? 0 : shares.back()) << "\n";
  EXPECT_LT(faulty, std::max(2, count / 2));
}

/// The columns must find what is wrong: the path of the same pockets planned without the clamps.
TEST(ClampedSetups, PathsThatKnowNoClampsCrossThem) {
  Bench bench = random_bench(1);
  bench.clamps = {{0, 0, 90, 60, 25}};
  Columns columns(bench);
  for (const TipWay& way : ways_of(planned(bench, false).program, kChord)) columns.drive(way);
  EXPECT_GT(columns.found().clamp, 5);
}

}  // namespace
}  // namespace clearcut::test_support
