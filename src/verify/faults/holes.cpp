#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "base/text.h"
#include "base/tolerances.h"
#include "verify/faults/faults.h"
#include "verify/faults/threads.h"

namespace clearcut::verify {
namespace {

/// mm. A tool descending farther off is on another axis.
constexpr double kOnAxis = 0.01;
/// mm. Diameters and pitches differing by less are equal.
constexpr double kSameSize = 0.005;
/// mm. A drill of a hole's size differs from it by no more: docs/holes.md, near sizes.
constexpr double kNearSize = 0.05 + kSameSize;
/// mm. Pecks of rounded words differ by less from the stated ones.
constexpr double kPeckSlack = 0.01;
/// mm. A wider mouth is no matter to a reamed or bored wall.
constexpr double kMouth = 0.5;
/// mm. Rising by less breaks no chip.
constexpr double kLeastRise = 0.01;

class HoleCheck {
 public:
  HoleCheck(const Part& part, const Feature& feature, const CheckedProgram& program,
            const VerifyOptions& options)
      : part_(part), feature_(feature), hole_(*feature.hole), program_(program), options_(options) {
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
      check_finish();
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

  bool has_own_width(const Tool& tool) const { return std::abs(tool.diameter - hole_.diameter) < kSameSize; }

  /// A reamed or bored hole is more than its width and depth: a hole that a mill or a drill has made to size is neither.
  void check_finish() {
    const bool is_reamed = hole_.kind == HoleKind::kReamed;
    const ToolKind kind = is_reamed ? ToolKind::kReamer : ToolKind::kBoringBar;
    const auto is_the_tool = [&](const Tool& tool) { return tool.kind == kind && has_own_width(tool); };
    // Without a boring bar of its width a hole is only milled.
    if (!is_reamed &&
        (hole_.kind != HoleKind::kBored || std::none_of(part_.tools.begin(), part_.tools.end(), is_the_tool)))
      return;
    const std::string name = std::string("a ") + (is_reamed ? "reamer" : "boring bar") + " of " +
                             trimmed(hole_.diameter, 3) + " mm";
    double lowest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : upright_) {
      if (is_the_tool(*at(i).tool)) lowest = std::min(lowest, at(i).low_z());
    }
    if (std::isinf(lowest))
      return add_missing("the hole is to be finished by " + name + ", and none comes down on its axis");
    if (lowest > hole_.full_z + options_.tol.uncut)
      add(FaultKind::kUncut, lowest - hole_.full_z, lowest, 0,
          name + " goes down to z " + trimmed(lowest, 3) + " only, and shall to z " +
              trimmed(hole_.full_z, 3));
    check_left_for_tool(kind, hole_.diameter - 2 * options_.tol.uncut, feature_.top_z - kMouth,
                        name + " would find nothing to cut");
  }

  /// Level arcs of one cone about the axis, at one height and distance.
  struct Orbit {
    const Tool* cone;
    double tip, radius;
    double turned = 0;  ///< radians
    int line = 0;

    bool is_closed() const { return turned > 2 * kPi - kSameAngleRad; }
    bool takes(const CheckedMove& checked) const {
      return cone == checked.tool && std::abs(tip - checked.low_z()) < kSameSize &&
             std::abs(radius - checked.move->path.radius()) < kSameSize;
    }
  };

  std::vector<Orbit> orbits_of_cones() const {
    std::vector<Orbit> orbits;
    for (const CheckedMove& checked : program_.moves) {
      if (!checked.tool || !is_conical(*checked.tool) || !checked.feeds() || !checked.is_flat()) continue;
      const Edge& path = checked.move->path;
      if (!path.is_arc() || distance(path.center, hole_.center) > kOnAxis ||
          !checked.counts_below(feature_.top_z))
        continue;
      auto orbit =
          std::find_if(orbits.begin(), orbits.end(), [&](const Orbit& one) { return one.takes(checked); });
      if (orbit == orbits.end())
        orbit = orbits.insert(orbits.end(),
                              {checked.tool, checked.low_z(), path.radius(), 0, checked.move->line});
      orbit->turned += std::abs(path.sweep());
    }
    return orbits;
  }

  /// A cone comes down on the axis, or it goes round about it.
  void check_cone() {
    double widest = -1, tip = 0;
    int line = 0;
    for (const std::size_t i : upright_) {
      if (!is_conical(*at(i).tool)) continue;
      const double width = 2 * radius_at(*at(i).tool, feature_.top_z - at(i).low_z());
      if (width > widest) widest = width, line = at(i).move->line, tip = at(i).low_z();
    }
    for (const Orbit& orbit : orbits_of_cones()) {
      if (!orbit.is_closed()) continue;
      const double width = 2 * (orbit.radius + radius_at(*orbit.cone, feature_.top_z - orbit.tip));
      if (width > widest) widest = width, line = orbit.line, tip = orbit.tip;
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

  /// Whether another feature than the hole before this one opens the place below the top: what is cut there is its own.
  bool is_open_beside(double widest) const {
    const Box axis{hole_.center, hole_.center}, narrow = axis.grown(widest / 2);
    return std::any_of(part_.features.begin(), part_.features.end(), [&](const Feature& other) {
      if (&other == &feature_ || other.floor_z >= feature_.top_z - options_.tol.uncut) return false;
      const Box there = box(other.target);
      const bool is_before = narrow.contains(there.min) && narrow.contains(there.max);
      return !is_before && there.overlaps(axis.grown(hole_.diameter / 2));
    });
  }

  /// mm; width to which a cutter opens the hole below z on this move, 0 where it comes no nearer than the finished wall.
  double opened_by(const CheckedMove& checked, double z) const {
    if (checked.low_z() >= z) return 0;
    const double radius = radius_at(*checked.tool, z - checked.low_z());
    const Edge& path = checked.move->path;
    const bool stands = path.from == path.to;
    const double nearest = stands ? distance(path.from, hole_.center) : distance(path, hole_.center);
    if (nearest >= hole_.diameter / 2 + radius) return 0;
    const double farthest = std::max(distance(path.from, hole_.center), distance(path.to, hole_.center));
    return 2 * std::min(farthest + radius, hole_.diameter / 2);
  }

  /// A thread, a reamed or a bored wall is made by its own tool of what stands there: others must not have opened the hole beyond
  /// `widest`. What widens its mouth, down to `below`, is no matter.
  void check_left_for_tool(ToolKind own, double widest, double below, const std::string& what) {
    if (is_open_beside(widest + 2 * options_.tol.gouge)) return;
    for (const CheckedMove& checked : program_.moves) {
      if (!checked.tool || checked.tool->kind == own || !checked.counts_below(feature_.top_z)) continue;
      const double opened = opened_by(checked, below);
      if (opened <= widest + 2 * options_.tol.gouge) continue;
      add(hole_.thread ? FaultKind::kThread : FaultKind::kNothingCut, (opened - widest) / 2, checked.low_z(),
          checked.move->line,
          "T" + std::to_string(checked.tool_number) + " opens it to " + trimmed(opened, 3) + " mm, and " +
              what);
      return;
    }
  }

  void check_left_for_thread(ToolKind own) {
    const Thread& thread = *hole_.thread;
    const double widest = minor_diameter(thread) + minor_tolerance(thread);
    check_left_for_tool(own, widest, feature_.top_z - thread.pitch,
                        thread.name + " needs a hole of at most " + trimmed(widest, 3));
  }

  void check_tap() {
    check_left_for_thread(ToolKind::kTap);
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
    if (!hole_.external) check_left_for_thread(ToolKind::kThreadMill);
    for (const ThreadDefect& defect : defects_of_thread(feature_, mills_)) {
      const FaultKind kind = defect.kind == ThreadDefect::Kind::kNothing   ? FaultKind::kNothingCut
                             : defect.kind == ThreadDefect::Kind::kShallow ? FaultKind::kUncut
                             : defect.kind == ThreadDefect::Kind::kNarrow  ? FaultKind::kUncut
                                                                           : FaultKind::kThread;
      add(kind, defect.size, hole_.full_z, defect.line,
          "the thread " + hole_.thread->name + " " + defect.text);
    }
  }

  const Part& part_;
  const Feature& feature_;
  const HoleForm& hole_;
  const CheckedProgram& program_;
  const VerifyOptions& options_;
  std::vector<std::size_t> upright_;       ///< feed moves on the axis
  std::vector<const CheckedMove*> mills_;  ///< moves of thread mills about the axis, including rapids
  bool is_milled_ = false;                 ///< one of them feeds
  std::vector<Fault> faults_;
};

/// The descents of one drill in one hole.
class Pecks {
 public:
  Pecks(const HoleForm& hole, double top_z) : hole_(hole), top_z_(top_z), begun_(top_z), deepest_(top_z) {}

  /// Whether the drill has gone deeper at once than its peck after this move along the axis.
  bool are_exceeded_by(const CheckedMove& checked) {
    const double from = checked.move->z_from, to = checked.move->z_to;
    // Chips that fill the flutes are cleared outside the hole only.
    const bool ends_the_peck = hole_.chip_break ? to > from + kLeastRise : to >= top_z_ - kLeastRise;
    if (to > from && ends_the_peck) begun_ = deepest_;
    if (to < from && checked.feeds()) deepest_ = std::min(deepest_, to);
    return taken() > *hole_.peck + kPeckSlack;
  }
  double taken() const { return begun_ - deepest_; }

 private:
  const HoleForm& hole_;
  double top_z_;
  double begun_;    ///< z at which the present peck met material
  double deepest_;  ///< z of the bottom so far
};

std::optional<Condition> longer_peck(const Feature& feature, const CheckedProgram& program) {
  const HoleForm& hole = *feature.hole;
  std::map<int, Pecks> by_tool;
  for (const CheckedMove& checked : program.moves) {
    if (!checked.tool || checked.tool->kind != ToolKind::kDrill || checked.is_carried()) continue;
    if (!checked.move->is_vertical() || distance(checked.move->path.from, hole.center) > kOnAxis) continue;
    if (std::abs(checked.tool->diameter - hole.diameter) > kNearSize) continue;
    Pecks& pecks = by_tool.try_emplace(checked.tool_number, hole, feature.top_z).first->second;
    if (!pecks.are_exceeded_by(checked)) continue;
    return Condition{"stated-peck",
                     feature.name + ": T" + std::to_string(checked.tool_number) + " drills " +
                         trimmed(pecks.taken(), 3) + " mm at once where pecks of " + trimmed(*hole.peck, 3) +
                         " mm" + (hole.chip_break ? "" : ", with a full retract each time,") +
                         " are stated; the program's pecks are meant",
                     checked.move->line};
  }
  return std::nullopt;
}

/// What the tool of a workingstep is asked to do on the axis of a round hole, besides the shape of the hole.
struct HoleWish {
  const Feature* feature = nullptr;
  int tool_number = 0;
  Vec2 center;
  double peck = 0;     ///< mm; 0: in one go
  double dwell_s = 0;  ///< at the lowest point
};

/// One wish for each tool on each axis: of several workingsteps the one that asks for least.
std::vector<HoleWish> wishes_of(const Part& part) {
  std::vector<HoleWish> wishes;
  for (const Workingstep& step : part.workplan) {
    const Feature& feature = feature_of(part, step);
    const Tool& tool = tool_of(part, step);
    if (feature.kind != FeatureKind::kRoundHole || !makes_holes(tool)) continue;
    HoleWish wish{&feature, tool.number, box(feature.target).center()};
    // Where the input states the moves it states the pecks, and chips are broken below the top.
    const bool is_told_otherwise =
        step.stated_path || (feature.hole && (feature.hole->peck || feature.hole->chip_break));
    if (tool.kind == ToolKind::kDrill && !is_told_otherwise) wish.peck = step.operation.stepdown.value_or(0);
    if (step.operation.hole_feeds) wish.dwell_s = step.operation.hole_feeds->dwell_s;
    const auto same = std::find_if(wishes.begin(), wishes.end(), [&](const HoleWish& other) {
      return other.tool_number == wish.tool_number && distance(other.center, wish.center) <= kOnAxis;
    });
    if (same == wishes.end()) {
      wishes.push_back(wish);
      continue;
    }
    same->peck = same->peck > 0 && wish.peck > 0 ? std::max(same->peck, wish.peck) : 0;
    same->dwell_s = std::min(same->dwell_s, wish.dwell_s);
  }
  return wishes;
}

bool is_on_axis(const CheckedMove& checked, const HoleWish& wish) {
  return checked.tool_number == wish.tool_number && !checked.is_carried() && checked.move->is_vertical() &&
         distance(checked.move->path.from, wish.center) <= kOnAxis;
}

std::optional<Condition> peck_beyond(const HoleWish& wish, const CheckedProgram& program) {
  HoleForm hole;
  hole.peck = wish.peck;
  Pecks pecks(hole, wish.feature->top_z);
  for (const CheckedMove& checked : program.moves) {
    if (!is_on_axis(checked, wish) || !pecks.are_exceeded_by(checked)) continue;
    return Condition{"stated-peck",
                     wish.feature->name + ": T" + std::to_string(wish.tool_number) + " drills " +
                         trimmed(pecks.taken(), 3) + " mm at once where pecks of " + trimmed(wish.peck, 3) +
                         " mm, with a full retract each time, are stated; the program's pecks are meant",
                     checked.move->line};
  }
  return std::nullopt;
}

/// s. Dwells are written in hundredths.
constexpr double kDwellSlack = 0.011;

std::optional<Condition> dwell_missing(const HoleWish& wish, const CheckedProgram& program) {
  double lowest = std::numeric_limits<double>::infinity(), waits_s = 0;
  int line = 0;
  for (std::size_t i = 0; i < program.moves.size(); ++i) {
    const CheckedMove& checked = program.moves[i];
    if (!checked.control) return std::nullopt;  // nothing is known of its waits
    if (!is_on_axis(checked, wish) || !checked.feeds() || checked.move->z_to >= checked.move->z_from)
      continue;
    const double waits = i + 1 < program.moves.size() ? program.moves[i + 1].waits_s : 0;
    if (checked.move->z_to > lowest + kLeastRise) continue;
    waits_s = checked.move->z_to < lowest - kLeastRise ? waits : std::max(waits_s, waits);
    lowest = std::min(lowest, checked.move->z_to);
    line = checked.move->line;
  }
  if (std::isinf(lowest) || waits_s >= wish.dwell_s - kDwellSlack) return std::nullopt;
  return Condition{"stated-dwell",
                   wish.feature->name + ": T" + std::to_string(wish.tool_number) + " waits " +
                       trimmed(waits_s, 2) + " s at the bottom where " + trimmed(wish.dwell_s, 2) +
                       " s are stated; the program's dwell is meant",
                   line};
}

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
    for (Fault& fault : HoleCheck(part, part.features[i], program, options).check())
      faults.push_back(std::move(fault));
  }
  return faults;
}

std::optional<Condition> stated_pecks_exceeded(const Part& part, const CheckedProgram& program) {
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    const Feature& feature = part.features[i];
    if (!feature.hole || !feature.hole->peck || feature.hole->kind != HoleKind::kDrilled) continue;
    if (!is_worked(part, static_cast<int>(i))) continue;
    if (auto found = longer_peck(feature, program)) return found;
  }
  for (const HoleWish& wish : wishes_of(part)) {
    if (wish.peck <= 0) continue;
    if (auto found = peck_beyond(wish, program)) return found;
  }
  return std::nullopt;
}

std::optional<Condition> stated_dwell_missing(const Part& part, const CheckedProgram& program) {
  for (const HoleWish& wish : wishes_of(part)) {
    if (wish.dwell_s <= 0) continue;
    if (auto found = dwell_missing(wish, program)) return found;
  }
  return std::nullopt;
}

}  // namespace clearcut::verify
