#include "verify/faults/tap_moves.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/text/format.h"
#include "base/units.h"
#include "verify/faults/faults.h"

namespace clearcut::verify {
namespace {

/// Share by which a tap's feed may miss its pitch times the speed.
constexpr double kFeedShare = 0.005;
/// Pitches by which the hole before a tap is narrower than the thread: that of a full thread, and a little more.
constexpr double kCoreInPitches = 1.3;
/// mm. Holes and depths that miss by less are as they should be.
constexpr double kAsMade = 0.05;
/// Places around the wall of a hole that are looked at.
constexpr int kAround = 8;

double rpm_of(const CheckedMove& checked) {
  return checked.control ? checked.control->spindle_rpm : checked.rpm;
}

class TapMove {
 public:
  TapMove(const CheckedProgram& program, std::size_t index, const VerifyOptions& options)
      : program_(program), options_(options), index_(index), checked_(program.moves[index]) {}

  void check(double top_z) {
    check_feed();
    const bool down = checked_.move->z_to < checked_.move->z_from;
    check_turn(down);
    if (down) check_way_out(top_z);
  }
  std::vector<TapDefect> take() { return std::move(defects_); }

 private:
  void check_feed() {
    const double rpm = rpm_of(checked_), wanted = checked_.tool->pitch * rpm;
    const double feed = checked_.move->feed.mm_per_min();
    if (std::abs(feed - wanted) <= kFeedShare * wanted) return;
    defects_.push_back({std::abs(feed - wanted) / std::max(1.0, rpm),
                        "the tap feeds " + trimmed(feed, 2) + " mm/min where its pitch of " +
                            trimmed(checked_.tool->pitch, 4) + " mm at " + trimmed(rpm, 0) +
                            " rpm asks for " + trimmed(wanted, 2)});
  }

  /// Into the hole a tap must turn as its hand asks; out of it the other way, by a spindle word or by its cycle.
  void check_turn(bool down) {
    if (!checked_.control || (!down && turned_by_cycle())) return;
    const bool left = checked_.tool->left_hand;
    const SpindleState into = left ? SpindleState::kCounterClockwise : SpindleState::kClockwise;
    const SpindleState out = left ? SpindleState::kClockwise : SpindleState::kCounterClockwise;
    if (checked_.control->spindle == (down ? into : out)) return;
    defects_.push_back({0, down ? "the spindle does not turn the way that this tap cuts"
                                : "the tap comes out while the spindle still turns as on its way in"});
  }

  bool turned_by_cycle() const {
    const ControlTable* const control = checked_.earlier ? options_.earlier_control : options_.control;
    if (!control) return true;
    const auto first = std::find_if(program_.moves.begin(), program_.moves.end(),
                                    [&](const CheckedMove& one) { return one.earlier == checked_.earlier; });
    const auto index = static_cast<std::size_t>(&checked_ - &*first);
    return std::any_of(control->events.begin(), control->events.end(), [&](const ControlEvent& event) {
      return event.kind == ControlEventKind::kTapTurnsBack && event.before_move == index;
    });
  }

  /// The move after the one down has to be the feed out.
  void check_way_out(double top_z) {
    const auto& moves = program_.moves;
    const bool feeds_out = index_ + 1 < moves.size() && moves[index_ + 1].feeds() &&
                           moves[index_ + 1].move->is_vertical() && moves[index_ + 1].move->z_to >= top_z;
    if (!feeds_out) defects_.push_back({0, "the tap does not come out at its feed right after it went in"});
  }

  const CheckedProgram& program_;
  const VerifyOptions& options_;
  std::size_t index_;
  const CheckedMove& checked_;
  std::vector<TapDefect> defects_;
};

/// Whether something other than a tap has been at p, at height z or below, before the move with that place.
bool is_open(const CheckedProgram& program, std::size_t before, Vec2 p, double z) {
  for (std::size_t i = 0; i < before; ++i) {
    const CheckedMove& checked = program.moves[i];
    if (!checked.feeds() || !checked.tool || checked.tool->kind == ToolKind::kTap || checked.low_z() > z)
      continue;
    if (distance(checked.move->path, p) <= checked.radius()) return true;
  }
  return false;
}

bool is_predrilled(const Part& part, Vec2 center, double core_diameter) {
  return std::any_of(part.predrilled.begin(), part.predrilled.end(), [&](const PredrilledHole& hole) {
    return distance(hole.center, center) <= kAsMade && hole.diameter >= core_diameter - kAsMade;
  });
}

/// Whether a hole as wide as the thread's core reaches down to the tap's tip.
bool has_hole(const Part& part, const CheckedProgram& program, std::size_t index) {
  const CheckedMove& tap = program.moves[index];
  const Vec2 center = tap.move->path.from;
  const double core = tap.tool->diameter - kCoreInPitches * tap.tool->pitch, z = tap.low_z() + kAsMade;
  if (is_predrilled(part, center, core)) return true;
  if (!is_open(program, index, center, z)) return false;
  const double radius = std::max(0.0, core / 2 - kAsMade);
  for (int k = 0; k < kAround; ++k) {
    if (!is_open(program, index, center + direction_of(2 * kPi * k / kAround) * radius, z)) return false;
  }
  return true;
}

}  // namespace

std::vector<TapDefect> defects_of_tap_move(const CheckedProgram& program, std::size_t index, double top_z,
                                           const VerifyOptions& options) {
  TapMove move(program, index, options);
  move.check(top_z);
  return move.take();
}

std::vector<Fault> faults_of_taps_alone(const Part& part, const CheckedProgram& program,
                                        const VerifyOptions& options) {
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < program.moves.size(); ++i) {
    const CheckedMove& checked = program.moves[i];
    const bool taps = checked.feeds() && !checked.is_carried() && checked.tool &&
                      checked.tool->kind == ToolKind::kTap && checked.move->is_vertical() &&
                      checked.low_z() < part.top_z();
    if (!taps) continue;
    std::vector<TapDefect> defects = defects_of_tap_move(program, i, part.top_z(), options);
    if (checked.move->z_to < checked.move->z_from && !has_hole(part, program, i))
      defects.push_back({0, "the tap goes into solid material: no hole as wide as its core was made before"});
    const Place place{checked.move->path.to, checked.move->z_to, checked.move->line};
    for (const TapDefect& defect : defects) {
      faults.push_back(fault_of(part, FaultKind::kTapping, checked, place, defect.size,
                                "T" + std::to_string(checked.tool_number) + ": " + defect.text));
      faults.back().cause = defect.text;
    }
  }
  return faults;
}

}  // namespace clearcut::verify
