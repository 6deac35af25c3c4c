#include <algorithm>
#include <string>

#include "base/elementary.h"
#include "base/text.h"
#include "base/units.h"
#include "verify/faults/faults.h"

namespace clearcut::verify {
namespace {

/// Greatest cut per tooth, as a share of the diameter and in mm.
constexpr double kThickestShare = 0.1, kThickest = 4;
/// mm. Below this diameter thick chips are not reported: engraving needles are stated with the width of their tip,
/// and break for other reasons.
constexpr double kThickestOfNeedles = 0.05;
/// mm, cut per tooth. Thinner cuts are a small share of the radius to which an edge can be ground, so that the edge rubs.
constexpr double kThinnest = 3e-4;
/// m/min.
constexpr double kFastestEdge = 7500;
/// No spindle with a tool turns faster.
constexpr double kFastestSpindle = 400'000;
/// Greatest S word of controls that use it for a power.
constexpr double kFullPower = 255;

double teeth_of(const Tool& tool) {
  return std::max(1, tool.teeth);
}

/// Share of the feed per tooth that is the thickest part of the chip: less if the cutter is engaged by less than a
/// quarter turn, as on links from pass to pass that touch material left by a pass.
double thickest_part(const CheckedMove& checked) {
  const double angle = checked.load.max_deg;
  return angle > 0 && angle < 90 ? base::sin(angle * kPi / 180) : 1;
}

/// The worst move of one kind.
struct Worst {
  const CheckedMove* move = nullptr;
  double times = 1;  ///< ratio of its value to the bound, or of the bound to its value

  void take(const CheckedMove& other, double ratio) {
    if (ratio > times) *this = {&other, ratio};
  }
};

/// Factors on a stated feed or speed; values beyond were probably not intended.
constexpr double kBeyondStated = 1.5, kBelowStated = 0.5;

std::string driven(const CheckedMove& checked) {
  return trimmed(checked.move->feed.mm_per_min(), 3) + " mm/min at " +
         trimmed(checked.control->spindle_rpm, 0) + " rpm";
}

class CuttingData {
 public:
  explicit CuttingData(const VerifyOptions& options) : options_(options) {}

  void add(const CheckedMove& checked) {
    add_stated(checked);
    if (checked.tool->kind == ToolKind::kTap) return;
    const Tool& tool = *checked.tool;
    const double rpm = checked.control->spindle_rpm, width = 2 * widest_radius(tool);
    const double chip = checked.move->feed.mm_per_min() / (rpm * teeth_of(tool));
    thick_.take(checked, chip * thickest_part(checked) / thickest(width));
    // Vertical moves are slow for other reasons.
    if (!checked.move->is_vertical() && chip > 0) thin_.take(checked, kThinnest / chip);
    fast_.take(checked, std::max(edge_speed(width, rpm) / kFastestEdge, rpm / kFastestSpindle));
  }

  std::vector<Condition> conditions() const {
    std::vector<Condition> all;
    if (thick_.move)
      all.push_back(chip_load(*thick_.move, "more than any cutter of its width bears"));
    else if (thin_.move)
      all.push_back(chip_load(*thin_.move, "which rubs and does not cut"));
    if (fast_.move) all.push_back(cutting_speed(*fast_.move));
    if (over_feed_.move) all.push_back(stated_feed(*over_feed_.move));
    if (other_speed_.move) all.push_back(stated_speed(*other_speed_.move));
    return all;
  }

 private:
  void add_stated(const CheckedMove& checked) {
    const auto found = options_.stated.find(checked.tool->number);
    if (found == options_.stated.end()) return;
    const StatedDrive& stated = found->second;
    const double rpm = checked.control->spindle_rpm;
    if (stated.most_feed > 0 && checked.tool->kind != ToolKind::kTap)
      over_feed_.take(checked, checked.move->feed.mm_per_min() * thickest_part(checked) /
                                   (kBeyondStated * stated.most_feed));
    if (stated.most_rpm > 0) other_speed_.take(checked, rpm / (kBeyondStated * stated.most_rpm));
    if (stated.least_rpm > 0) other_speed_.take(checked, kBelowStated * stated.least_rpm / rpm);
  }

  Condition stated_feed(const CheckedMove& checked) const {
    const int number = checked.tool->number;
    return {"stated-feed",
            "T" + std::to_string(number) + " cuts at " + trimmed(checked.move->feed.mm_per_min(), 1) +
                " mm/min where " + trimmed(options_.stated.at(number).most_feed, 1) +
                " is stated for it; the program's feed is meant",
            checked.move->line};
  }

  Condition stated_speed(const CheckedMove& checked) const {
    const int number = checked.tool->number;
    const StatedDrive& stated = options_.stated.at(number);
    const double rpm = checked.control->spindle_rpm;
    return {"stated-speed",
            "T" + std::to_string(number) + " turns at " + trimmed(rpm, 0) + " rpm where " +
                trimmed(rpm > stated.most_rpm ? stated.most_rpm : stated.least_rpm, 0) +
                " is stated for it; the program's speed is meant",
            checked.move->line};
  }

  static double thickest(double width) {
    return std::clamp(kThickestShare * width, kThickestOfNeedles, kThickest);
  }
  static double edge_speed(double width, double rpm) { return kPi * width * rpm / 1000; }

  static Condition chip_load(const CheckedMove& checked, const std::string& what) {
    const Tool& tool = *checked.tool;
    const double teeth = teeth_of(tool);
    const double chip = checked.move->feed.mm_per_min() / (checked.control->spindle_rpm * teeth);
    return {"chip-load",
            "T" + std::to_string(tool.number) + " takes " + trimmed(chip, chip < 0.01 ? 6 : 3) +
                " mm with each of its " + trimmed(teeth, 0) + " teeth (" + driven(checked) + "), " + what +
                "; feed and speed are meant so",
            checked.move->line};
  }

  static Condition cutting_speed(const CheckedMove& checked) {
    const Tool& tool = *checked.tool;
    const double rpm = checked.control->spindle_rpm;
    return {"cutting-speed",
            "the edges of T" + std::to_string(tool.number) + " run at " +
                trimmed(edge_speed(2 * widest_radius(tool), rpm), 0) + " m/min at " + trimmed(rpm, 0) +
                " rpm, faster than edges run in any material; the spindle is meant to turn so fast",
            checked.move->line};
  }

  const VerifyOptions& options_;
  Worst thick_, thin_, fast_, over_feed_, other_speed_;
};

bool says_turns(const CheckedMove& checked, bool speed_may_be_power) {
  if (!checked.control || checked.control->spindle == SpindleState::kOff) return false;
  const double rpm = checked.control->spindle_rpm;
  return rpm > (speed_may_be_power ? kFullPower : 0);
}

}  // namespace

std::vector<Condition> doubtful_cutting_data(const CheckedProgram& program, const VerifyOptions& options) {
  CuttingData data(options);
  for (const CheckedMove& checked : program.moves) {
    if (checked.earlier || checked.is_carried() || !checked.tool || checked.tool->diameter <= 0) continue;
    if (!says_turns(checked, options.speed_may_be_power)) continue;
    if (checked.works()) data.add(checked);
  }
  return data.conditions();
}

}  // namespace clearcut::verify
