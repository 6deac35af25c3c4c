#include "verify/faults/holes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text/format.h"
#include "verify/faults/thread_helix.h"

namespace clearcut::verify {
namespace {

/// mm. A tool that comes down farther off is on another axis.
constexpr double kOnAxis = 0.01;
/// Share by which a tap's feed may miss its pitch times the speed.
constexpr double kFeedShare = 0.005;
/// mm. Diameters and pitches that differ by less are the same.
constexpr double kSameSize = 0.005;

class HoleCheck {
 public:
  HoleCheck(const Feature& feature, const CheckedProgram& program, const VerifyOptions& options)
      : feature_(feature), hole_(*feature.hole), program_(program), options_(options) {
    for (std::size_t i = 0; i < program.moves.size(); ++i) {
      const CheckedMove& checked = program.moves[i];
      if (!checked.feeds() || !checked.tool || checked.low_z() >= feature.top_z) continue;
      if (!checked.counts_below(feature.top_z)) continue;
      const Move& move = *checked.move;
      if (move.is_vertical() && distance(move.path.from, hole_.center) <= kOnAxis) upright_.push_back(i);
      const bool mills = checked.tool->kind == ToolKind::kThreadMill;
      if (mills && is_at_work(checked)) mills_.push_back(&checked);
    }
  }

  std::vector<Fault> check() {
    if (hole_.kind == HoleKind::kTapped) {
      check_tap();
    } else if (hole_.kind == HoleKind::kThreadMilled) {
      check_thread();
    } else if (hole_.kind == HoleKind::kSpotted || hole_.kind == HoleKind::kCountersunk) {
      check_cone();
    } else {
      check_point();
    }
    return std::move(faults_);
  }

 private:
  /// Whether a thread mill is near enough to the axis to work on the thread, and not on another about the same axis: in a hole in the
  /// boss, whose mill stays within the core, or about the boss that the hole is in, whose mill stays beyond the wall.
  bool is_at_work(const CheckedMove& mill) const {
    const double apart = distance(mill.move->path.from, hole_.center);
    if (hole_.external)
      return apart < hole_.diameter / 2 + mill.tool->diameter &&
             apart + mill.radius() > root_diameter(*hole_.thread) / 2;
    return apart < hole_.diameter && apart - mill.radius() < hole_.diameter / 2;
  }
  const CheckedMove& at(std::size_t i) const { return program_.moves[i]; }

  void add(FaultKind kind, double size, double z, int line, const std::string& text) {
    faults_.push_back({kind,
                       feature_.name,
                       {hole_.center, z, line},
                       size,
                       feature_.name + ": " + text + ", at x " + trimmed(hole_.center.x, 3) + " y " +
                           trimmed(hole_.center.y, 3) + (line > 0 ? ", line " + std::to_string(line) : "") +
                           "."});
  }

  void add_missing(const std::string& text) {
    add(FaultKind::kNothingCut, feature_.top_z - feature_.floor_z, feature_.floor_z, 0, text);
  }

  /// A drill leaves a cone at the end of its hole. Tools with flat ends are checked by the proof of coverage.
  void check_point() {
    double full = std::numeric_limits<double>::infinity();
    int line = 0;
    bool drilled = false;
    for (const std::size_t i : upright_) {
      const Tool& tool = *at(i).tool;
      if (2 * tool.radius() < hole_.diameter - 2 * options_.tol.uncut) continue;
      drilled = drilled || tool.kind == ToolKind::kDrill;
      const double down = at(i).low_z() + point_length(tool);
      if (down < full) full = down, line = at(i).move->line;
    }
    if (!drilled || full <= hole_.full_z + options_.tol.uncut) return;
    add(FaultKind::kUncut, full - hole_.full_z, full, line,
        "the drill has its full width down to z " + trimmed(full, 3) + " only, and shall to z " +
            trimmed(hole_.full_z, 3));
  }

  void check_cone() {
    double widest = -1, tip = 0;
    int line = 0;
    for (const std::size_t i : upright_) {
      if (!is_conical(*at(i).tool)) continue;
      const double width = 2 * radius_at(*at(i).tool, feature_.top_z - at(i).low_z());
      if (width > widest) widest = width, line = at(i).move->line, tip = at(i).low_z();
    }
    if (widest < 0) return add_missing("no cone comes down on its axis");
    const double left = (hole_.diameter - widest) / 2;
    if (left > options_.tol.uncut)
      add(FaultKind::kUncut, left, tip, line,
          "the cone is " + trimmed(widest, 3) + " mm wide at the top, and shall be " +
              trimmed(hole_.diameter, 3));
  }

  bool is_the_tap(const Tool& tool) const {
    return tool.kind == ToolKind::kTap && std::abs(tool.diameter - hole_.thread->diameter) < kSameSize &&
           std::abs(tool.pitch - hole_.thread->pitch) < kSameSize &&
           tool.left_hand == hole_.thread->left_hand;
  }

  void check_tap() {
    double lowest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : upright_) {
      const CheckedMove& checked = at(i);
      if (checked.tool->kind != ToolKind::kTap) continue;
      if (!is_the_tap(*checked.tool)) {
        add(FaultKind::kTapping, 0, checked.low_z(), checked.move->line,
            "T" + std::to_string(checked.tool_number) + " is no tap " + hole_.thread->name);
        continue;
      }
      lowest = std::min(lowest, checked.low_z());
      check_feed(checked);
      const bool down = checked.move->z_to < checked.move->z_from;
      check_turn(checked, down);
      if (down) check_way_out(i);
    }
    if (std::isinf(lowest)) return add_missing("no tap " + hole_.thread->name + " comes down on its axis");
    if (lowest > feature_.floor_z + options_.tol.uncut)
      add(FaultKind::kUncut, lowest - feature_.floor_z, lowest, 0,
          "the tap goes down to z " + trimmed(lowest, 3) + " only, and has to reach z " +
              trimmed(feature_.floor_z, 3) + " for a full thread to z " + trimmed(hole_.full_z, 3));
  }

  static double rpm_of(const CheckedMove& checked) {
    return checked.control ? checked.control->spindle_rpm : checked.rpm;
  }

  void check_feed(const CheckedMove& checked) {
    const double wanted = checked.tool->pitch * rpm_of(checked), feed = checked.move->feed.mm_per_min();
    if (std::abs(feed - wanted) <= kFeedShare * wanted) return;
    add(FaultKind::kTapping, std::abs(feed - wanted) / std::max(1.0, rpm_of(checked)), checked.move->z_to,
        checked.move->line,
        "the tap feeds " + trimmed(feed, 2) + " mm/min where its pitch of " +
            trimmed(checked.tool->pitch, 4) + " mm at " + trimmed(rpm_of(checked), 0) + " rpm asks for " +
            trimmed(wanted, 2));
  }

  /// Into the hole a tap must turn as its hand asks; out of it the other way, by a spindle word or by its cycle.
  void check_turn(const CheckedMove& checked, bool down) {
    if (!checked.control || (!down && turned_by_cycle(checked))) return;
    const SpindleState into =
        hole_.thread->left_hand ? SpindleState::kCounterClockwise : SpindleState::kClockwise;
    const SpindleState out =
        hole_.thread->left_hand ? SpindleState::kClockwise : SpindleState::kCounterClockwise;
    if (checked.control->spindle == (down ? into : out)) return;
    add(FaultKind::kTapping, 0, checked.move->z_to, checked.move->line,
        down ? "the spindle does not turn the way that this tap cuts"
             : "the tap comes out while the spindle still turns as on its way in");
  }

  bool turned_by_cycle(const CheckedMove& checked) const {
    if (!options_.control) return true;
    const auto own = std::find_if(program_.moves.begin(), program_.moves.end(),
                                  [](const CheckedMove& one) { return !one.earlier; });
    const auto index = static_cast<std::size_t>(&checked - &*own);
    return std::any_of(options_.control->events.begin(), options_.control->events.end(),
                       [&](const ControlEvent& event) {
                         return event.kind == ControlEventKind::kTapTurnsBack && event.before_move == index;
                       });
  }

  /// The move after the one down has to be the feed out.
  void check_way_out(std::size_t down) {
    const bool feeds_out = down + 1 < program_.moves.size() && at(down + 1).feeds() &&
                           at(down + 1).move->is_vertical() && at(down + 1).move->z_to >= feature_.top_z;
    if (feeds_out) return;
    add(FaultKind::kTapping, 0, at(down).move->z_to, at(down).move->line,
        "the tap does not come out at its feed right after it went in");
  }

  void check_thread() {
    if (mills_.empty())
      return add_missing(hole_.external ? "no thread mill works about it" : "no thread mill works in it");
    for (const ThreadDefect& defect : defects_of_thread(feature_, mills_)) {
      const FaultKind kind = defect.kind == ThreadDefect::Kind::kNothing   ? FaultKind::kNothingCut
                             : defect.kind == ThreadDefect::Kind::kShallow ? FaultKind::kUncut
                             : defect.kind == ThreadDefect::Kind::kNarrow  ? FaultKind::kUncut
                                                                           : FaultKind::kThread;
      add(kind, defect.size, hole_.full_z, defect.line,
          "the thread " + hole_.thread->name + " " + defect.text);
    }
  }

  const Feature& feature_;
  const HoleForm& hole_;
  const CheckedProgram& program_;
  const VerifyOptions& options_;
  std::vector<std::size_t> upright_;  ///< feed moves on the axis
  std::vector<const CheckedMove*> mills_;
  std::vector<Fault> faults_;
};

bool is_worked(const Part& part, int feature) {
  return std::any_of(part.workplan.begin(), part.workplan.end(),
                     [&](const Workingstep& step) { return step.feature == feature; });
}

}  // namespace

std::vector<Fault> faults_of_holes(const Part& part, const CheckedProgram& program,
                                   const VerifyOptions& options) {
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    if (!part.features[i].hole || !is_worked(part, static_cast<int>(i))) continue;
    for (Fault& fault : HoleCheck(part.features[i], program, options).check())
      faults.push_back(std::move(fault));
  }
  return faults;
}

}  // namespace clearcut::verify
