#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "verify/faults/faults.h"
#include "verify/faults/threads.h"

namespace clearcut::verify {
namespace {

/// mm. A tool descending farther off is on another axis.
constexpr double kOnAxis = 0.01;
/// mm. Diameters and pitches differing by less are equal.
constexpr double kSameSize = 0.005;

class HoleCheck {
 public:
  HoleCheck(const Feature& feature, const CheckedProgram& program, const VerifyOptions& options)
      : feature_(feature), hole_(*feature.hole), program_(program), options_(options) {
    for (std::size_t i = 0; i < program.moves.size(); ++i) {
      const CheckedMove& checked = program.moves[i];
      if (!checked.tool || checked.low_z() >= feature.top_z || !checked.counts_below(feature.top_z)) continue;
      const Move& move = *checked.move;
      if (checked.feeds() && move.is_vertical() && distance(move.path.from, hole_.center) <= kOnAxis)
        upright_.push_back(i);
      const bool mills = checked.tool->kind == ToolKind::kThreadMill;
      if (!mills || !is_at_work(checked)) continue;
      mills_.push_back(&checked);
      is_milled_ = is_milled_ || checked.feeds();
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
  /// Whether a thread mill is near enough to the axis to work on this thread, and not on another one about the same
  /// axis: the thread of a hole in the boss, with its mill inside the core, or the thread around the boss of the
  /// hole, with its mill outside the wall.
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
    }
    if (std::isinf(lowest)) return add_missing("no tap " + hole_.thread->name + " comes down on its axis");
    if (lowest > feature_.floor_z + options_.tol.uncut)
      add(FaultKind::kUncut, lowest - feature_.floor_z, lowest, 0,
          "the tap goes down to z " + trimmed(lowest, 3) + " only, and has to reach z " +
              trimmed(feature_.floor_z, 3) + " for a full thread to z " + trimmed(hole_.full_z, 3));
  }

  void check_thread() {
    if (!is_milled_)
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
  std::vector<std::size_t> upright_;       ///< feed moves on the axis
  std::vector<const CheckedMove*> mills_;  ///< moves of thread mills about the axis, including rapids
  bool is_milled_ = false;                 ///< one of them feeds
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
