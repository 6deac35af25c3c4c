#include "verify/engagement/entry_watch.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace clearcut::verify {
namespace {

/// Degrees. A path that goes down less is a pass that sinks: at half a degree it is more than a hundred times as long as it gets deep.
constexpr double kEntryAngle = 0.5;
/// mm down for each mm of advance, 0.17 degrees: on the first turn, because an entry takes one whole turn for the thinnest layer, too.
constexpr double kLeastEntrySlope = 3e-3;
/// Share of a stated angle, for rounding of coordinates.
constexpr double kAngleRounding = 0.02;
/// Degrees. Helices that are half in the air go down no steeper than this.
constexpr double kAngleInAir = 5;
/// mm. A level move this near to the descent before it lies on it.
constexpr double kOverDescent = 0.01;
/// mm; rounding of heights.
constexpr double kHeightRounding = 2e-3;

}  // namespace

StatedEntry stated_entry(const Part& part, const Tool* tool) {
  StatedEntry stated;
  for (const Workingstep& step : part.workplan) {
    const auto index = static_cast<std::size_t>(step.operation.tool);
    if (!tool || step.operation.tool < 0 || index >= part.tools.size() ||
        part.tools[index].number != tool->number)
      continue;
    if (step.operation.entry_angle)
      stated.slope = std::min(stated.slope, base::tan(step.operation.entry_angle->radians()));
    stated.size = std::max(stated.size, step.operation.entry_size.value_or(0));
  }
  return stated;
}

void EntryWatch::end() {
  state_ = State::kOutside;
  begins_ = false;
  descent_.clear();
}

void EntryWatch::follow(const CheckedMove& checked, const StatedEntry& stated) {
  const Move& move = *checked.move;
  begins_ = false;
  if (!checked.feeds() || move.z_to > move.z_from || move.is_vertical()) return end();
  if (move.z_to < move.z_from) return go_down(checked, stated);
  if (state_ == State::kOutside || !is_over_descent(move)) return end();
  state_ = State::kRound;
}

void EntryWatch::go_down(const CheckedMove& checked, const StatedEntry& stated) {
  if (state_ != State::kDescent) {
    end();
    begins_ = true;
    base_ = checked.move->z_from;
    slope_ = length_ = 0;
    turn_ = 2 * kPi * std::max(checked.radius(), stated.size);
  }
  const double slope = checked.slope(), usual = base::tan(kEntryAngle * kPi / 180);
  const bool steep = slope >= (1 - kAngleRounding) * std::min(usual, stated.slope);
  if (!steep && (slope < kLeastEntrySlope || length_ > turn_)) return end();
  state_ = State::kDescent;
  descent_.push_back(checked.move);
  slope_ = std::max(slope_, slope);
  length_ += checked.move->path.length();
}

bool EntryWatch::is_over_descent(const Move& move) const {
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Vec2 p = move.path.at(t);
    if (std::none_of(descent_.begin(), descent_.end(),
                     [&](const Move* ramp) { return distance(ramp->path, p) < kOverDescent; }))
      return false;
  }
  return true;
}

double EntryWatch::others_from(double z) const {
  if (state_ == State::kOutside) return z;
  const double own = state_ == State::kRound ? std::min(base_, z + turn_ * slope_) : base_;
  return std::max(z, own) + kHeightRounding;
}

void EntryWatch::meets_nothing_at(double z) {
  if (state_ != State::kDescent) return;
  // On one side of a helix may be air, for half a turn.
  base_ = std::min(base_, z + turn_ / 2 * std::min(slope_, base::tan(kAngleInAir * kPi / 180)));
}

}  // namespace clearcut::verify
