// Cuts that remove nothing: by strategy, the share of the length cut at the feed that takes no material, on random open and closed
// parts and on parts in files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "base/error.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "support/random/random_parts.h"
#include "support/random/wide_parts.h"

namespace {

using namespace clearcut;

constexpr double kDiameter = 6;  // mm, for random parts and outlines
constexpr const char* kStrategies[] = {"contour", "zigzag", "spiral", "adaptive", "cover", "auto"};
/// Share of the cutter's radius: side of the raster's cells, and distance between places along a cut.
constexpr double kPitch = 0.1;
/// mm. Less depth is rounding.
constexpr double kDepth = 1e-3;

/// Heights of the material over the targets of a part, on a raster.
class Stock {
 public:
  Stock(const Part& part, double pitch) : pitch_(pitch) {
    for (const Feature& feature : part.features) box_.add(box(feature.target));
    columns_ = static_cast<std::size_t>(box_.width() / pitch) + 1;
    rows_ = static_cast<std::size_t>(box_.height() / pitch) + 1;
    top_.assign(columns_ * rows_, kEmpty);
    for (const Feature& feature : part.features)
      for (std::size_t i = 0; i < top_.size(); ++i)
        if (contains(feature.target, center(i))) top_[i] = std::max(top_[i], feature.top_z);
  }

  /// Whether a cutter at p takes any material above z; takes it.
  bool cut(Vec2 p, double radius, double z) {
    bool is_cut = false;
    const auto range = [&](double at, double least, std::size_t count) {
      const double first = (at - radius - least) / pitch_, last = (at + radius - least) / pitch_;
      const auto limit = static_cast<double>(count);
      return std::pair(static_cast<std::size_t>(std::clamp(first, 0.0, limit)),
                       static_cast<std::size_t>(std::clamp(last + 1, 0.0, limit)));
    };
    const auto [c0, c1] = range(p.x, box_.min.x, columns_);
    const auto [r0, r1] = range(p.y, box_.min.y, rows_);
    for (std::size_t r = r0; r < r1; ++r) {
      for (std::size_t c = c0; c < c1; ++c) {
        double& top = top_[r * columns_ + c];
        if (top <= z + kDepth || distance(center(r * columns_ + c), p) > radius) continue;
        top = z;
        is_cut = true;
      }
    }
    return is_cut;
  }

 private:
  static constexpr double kEmpty = -1e300;
  Vec2 center(std::size_t i) const {
    return box_.min +
           Vec2{static_cast<double>(i % columns_) + 0.5, static_cast<double>(i / columns_) + 0.5} * pitch_;
  }

  double pitch_;
  Box box_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<double> top_;
};

struct Sums {
  int parts = 0, wrong = 0;
  double cut_mm = 0, idle_mm = 0, time_s = 0;
};

void measure(const Part& part, const Toolpath& toolpath, Sums& sums) {
  for (const Section& section : toolpath.sections) {
    double radius = kDiameter / 2;
    for (const Tool& tool : part.tools)
      if (tool.number == section.tool_number) radius = tool.radius();
    Stock stock(part, kPitch * radius);
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind)) continue;
      const double whole = move.is_vertical() ? 0 : move.path.length();
      const int steps = 1 + static_cast<int>(whole / (kPitch * radius));
      for (int k = 1; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        const Vec2 p = move.is_vertical() ? move.path.from : move.path.at(t);
        const bool is_cut = stock.cut(p, radius, move.z_from + (move.z_to - move.z_from) * t);
        if (!is_cut) sums.idle_mm += whole / steps;
      }
      sums.cut_mm += whole;
    }
  }
}

void add(const Part& part, const std::string& name, const char* strategy, Sums& sums) {
  PlanOptions options;
  options.strategy = strategy;
  options.threads = 1;
  ++sums.parts;
  try {
    const auto result = pipeline::plan_part(part, options);
    if (!result.findings.faults.empty()) {
      ++sums.wrong;
      fmt::print("{} {}: {}\n", name, strategy, result.findings.faults.front().text);
    }
    measure(result.part, result.toolpath, sums);
    for (const auto& selection : result.selections)
      if (!selection.candidates.empty()) sums.time_s += selection.candidates.front().time_s;
  } catch (const InputError& error) {
    ++sums.wrong;
    fmt::print("{} {}: {}\n", name, strategy, error.what());
  }
}

void print(const std::string& parts, const char* strategy, const Sums& sums) {
  fmt::print("| {} | {} | {} | {} | {:.1f} | {:.1f} | {:.1f} |\n", parts, strategy, sums.parts, sums.wrong,
             sums.cut_mm, 100 * sums.idle_mm / std::max(sums.cut_mm, 1e-9), sums.time_s);
}

bool is_open(const Part& part) {
  return part.features.front().kind == FeatureKind::kOpenPocket;
}

}  // namespace

/// air_cuts_benchmark COUNT [FIRST_SEED [STRATEGY|all [FILE...]]]
int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "air_cuts_benchmark COUNT [FIRST_SEED [STRATEGY|all [FILE...]]]\n");
    return 2;
  }
  const int count = std::atoi(argv[1]);
  const auto first = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  const std::string asked = argc > 3 ? argv[3] : "all";
  fmt::print(
      "| parts | strategy | number | wrong | cut mm | cut of it in the air % | time s "
      "|\n|---|---|---|---|---|---|---|\n");
  int wrong = 0;
  for (const char* strategy : kStrategies) {
    if (asked != "all" && asked != strategy) continue;
    for (const bool wide : {false, true}) {
      Sums open, closed;
      for (int i = 0; i < count; ++i) {
        Random random(first + static_cast<std::uint64_t>(i));
        const Part part =
            wide ? test_support::wide_part(random, kDiameter) : test_support::random_part(random, kDiameter);
        add(part, fmt::format("{} {}", wide ? "wide" : "blobs", first + static_cast<std::uint64_t>(i)),
            strategy, is_open(part) ? open : closed);
      }
      if (count > 0) print(wide ? "wide, open" : "blobs, open", strategy, open);
      if (count > 0) print(wide ? "wide, closed" : "blobs, closed", strategy, closed);
      wrong += open.wrong + closed.wrong;
    }
    for (int i = 4; i < argc; ++i) {
      Sums one;
      ReadOptions options;
      Tool tool;
      tool.diameter = kDiameter;
      Part part = read::read_part(argv[i], options);
      if (part.tools.empty()) part.tools = {tool};
      add(part, argv[i], strategy, one);
      print(argv[i], strategy, one);
      wrong += one.wrong;
    }
  }
  return wrong == 0 ? 0 : 1;
}
