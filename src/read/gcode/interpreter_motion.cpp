// Motion in the work's frame: lines, arcs, drilling cycles.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text/format.h"
#include "read/gcode/interpreter.h"
#include "read/gcode/words/g_words.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kMostRepeats = 10000;
/// Arcs standing upright (G18, G19) become chords: a Move is an arc in plan only. mm.
constexpr double kUprightChord = 0.0005;
constexpr PlaneAxes kPlaneAxes[] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};

}  // namespace

PlaneAxes axes_of(Plane plane) {
  return kPlaneAxes[static_cast<std::size_t>(plane)];
}

void Interpreter::move(const Block& block) {
  const int said = motion_in(block);
  if (said >= 0) motion_ = said;
  const bool cycle = is_drill_cycle(motion_);
  if (!cycle) cycle_ = {};
  if (move_specially(block)) return;
  const bool arc_words = block.has('I') || block.has('J') || block.has('K') || block.has('R');
  const bool arc_motion = motion_ == 20 || motion_ == 30;
  if (!block.has_axis() && !(arc_motion && arc_words)) return;
  if (motion_ < 0) {
    condition("motion-mode", "axis words come before any motion word; the control begins with rapids (G0)");
    motion_ = 0;
  }
  check_words_said(block);
  moved_ = true;
  if (motion_ != 0) before_feed();
  if (motion_ == 0 || motion_ == 10) return straight(block, motion_ == 0);
  if (arc_motion) return arc(block);
  if (cycle) return canned_cycle(block);
  if (motion_ == 800) refuse("axis words after G80 without a motion word; add G0 or G1");
  refuse(g_word(motion_) + " is not read; post the program without it");
}

/// What the program leaves to the state in which the control was left.
void Interpreter::check_words_said(const Block& block) {
  if (!units_said_ && !rules_.always_mm) {
    condition("units", "the program states neither G20 nor G21; the control is in mm");
  }
  if (!distance_said_ && !rules_.resets_modes) {
    condition("g90", "the program states neither G90 nor G91 before it moves; the control is in G90");
  }
  const bool plane_matters = motion_ != 0 && motion_ != 10;
  if (!plane_said_ && !rules_.resets_modes && plane_matters && rules_.dialect != Dialect::kMarlin) {
    condition("g17", "the program states no plane before its arcs or cycles; the control is in G17");
  }
  if (!rules_.points_matter) return;
  for (const char letter : {'X', 'Y', 'Z', 'I', 'J', 'K', 'R', 'Q'}) {
    if (block.has(letter) && block.is_whole(letter) && block.value(letter) != 0) {
      condition("decimal-point",
                std::string(1, letter) +
                    " has no decimal point; the control takes whole numbers as mm or inches, not as "
                    "increments");
    }
  }
}

void Interpreter::before_feed() {
  check_length();
  const PathMode mode = modes_.path.mode;
  if (mode == PathMode::kUnstated) {
    condition("blending",
              "neither G61 nor a path tolerance is stated; the control keeps to the path, whatever bound it "
              "was left "
              "with");
  } else if (mode == PathMode::kContinuous) {
    condition("blending",
              "G64 without P states no bound; the control rounds corners by nothing that matters");
  } else if (mode == PathMode::kSmoothness) {
    condition("blending",
              "G187 without E takes the bound from a setting; the control rounds corners within it");
  }
}

void Interpreter::check_length() {
  const ToolLength& length = modes_.length;
  const int tool = builder_.drive.tool;
  const bool numbered = length.kind == LengthKind::kNumbered || length.kind == LengthKind::kOfTool;
  const std::string h = std::to_string(length.h);
  if (numbered && length.h != tool && tool != 0 && !(length.kind == LengthKind::kOfTool && length.h == 0)) {
    condition("tool-length-h" + h, "length H" + h + " is that of tool T" + std::to_string(tool));
  }
  const bool off = length.kind == LengthKind::kOff || length.kind == LengthKind::kUnstated;
  if (off && length_used_) {
    condition("tool-length-off", "cuts without the tool's length (G49) after a length was in force");
  }
}

double Interpreter::target_of(std::size_t axis, const Block& block) {
  const double value = mm(block.value("XYZ"[axis]));
  return modes_.absolute ? value + frame_.shift(axis) : builder_.known(axis, line_) + value;
}

Target Interpreter::target(const Block& block) {
  Target target;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block.has("XYZ"[axis])) target[axis] = target_of(axis, block);
  }
  return target;
}

MmPerMin Interpreter::feed_for(double length, const Block& block) const {
  if (modes_.feed_mode == FeedMode::kPerTurn) return MmPerMin::of(modes_.feed * modes_.speed);
  if (modes_.feed_mode == FeedMode::kPerMinute) return MmPerMin::of(modes_.feed);
  if (!block.has('F')) refuse("feed move under G93 without its own F word; add it");
  return MmPerMin::of(modes_.feed * length);
}

void Interpreter::straight(const Block& block, bool rapid) {
  const Target to = target(block);
  if (rapid) return builder_.rapid(to, line_);
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (to[axis]) squared += std::pow(*to[axis] - builder_.position()[axis].value_or(*to[axis]), 2);
  }
  builder_.feed(to, feed_for(std::sqrt(squared), block), line_);
}

void Interpreter::arc(const Block& block) {
  const PlaneAxes axes = axes_of(modes_.plane);
  std::array<double, 3> from{}, to{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    from[axis] = builder_.known(axis, line_);
    to[axis] = block.has("XYZ"[axis]) ? target_of(axis, block) : from[axis];
    if (!(std::abs(to[axis]) <= 1e6)) refuse("coordinate beyond any machine; check the number and the units");
  }
  const ArcShape shape =
      arc_shape(block, {from[axes.first], from[axes.second]}, {to[axes.first], to[axes.second]});
  if (modes_.plane == Plane::kXY) {
    plan_arc(block, shape, to[2]);
  } else {
    upright_arc(shape, to[axes.across]);
  }
}

ArcShape Interpreter::arc_shape(const Block& block, Vec2 from, Vec2 to) {
  const Turn turn = motion_ == 20 ? Turn::kClockwise : Turn::kCounterClockwise;
  const PlaneAxes axes = axes_of(modes_.plane);
  const RadiusRule rule =
      modes_.unit == 1 ? RadiusRule{} : RadiusRule{0.0005 * kMmPerInch, 0.05 * kMmPerInch};
  const char first = "IJK"[axes.first], second = "IJK"[axes.second];
  const bool center = block.has(first) || block.has(second);
  if (block.has('R') && center) {
    depends_on_dialect_ = true;
    if (!rules_.radius_beats_center) refuse("arc with R and with its centre; give one of them");
  }
  if (block.has('R')) return arc_of_radius(from, to, mm(block.value('R')), turn, rule, builder_.place(line_));
  if (!center) refuse(std::string("arc without ") + first + ", " + second + " or R; give its centre");
  if (rules_.centers_set_up && !centers_said_) {
    condition("arc-centres",
              "the program states neither G90.1 nor G91.1; I, J, K count from the arc's start");
  }
  const auto center_of = [&](char letter, std::size_t axis, double start) {
    if (!block.has(letter)) return start;
    return mm(block.value(letter)) + (modes_.absolute_centers ? frame_.shift(axis) : start);
  };
  const double turns = block.has('P') ? block.value('P') : 1;
  if (!(turns >= 1 && turns <= kMostRepeats) || turns != std::floor(turns))
    refuse("P word is no number of turns; correct it");
  const Vec2 middle{center_of(first, axes.first, from.x), center_of(second, axes.second, from.y)};
  return arc_about(from, to, middle, turn, static_cast<int>(turns), rule, builder_.place(line_));
}

void Interpreter::plan_arc(const Block& block, const ArcShape& shape, double z_to) {
  const std::vector<Edge> edges = arc_edges(shape);
  const double z_from = builder_.known(2, line_);
  const double round = shape.sweep * distance(shape.from, shape.center);
  const double apart = std::abs(distance(shape.from, shape.center) - distance(shape.to, shape.center));
  const MmPerMin feed = feed_for(std::hypot(round, z_to - z_from), block);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const double t = static_cast<double>(k + 1) / static_cast<double>(edges.size());
    builder_.arc(edges[k], std::lerp(z_from, z_to, t), feed, line_, apart);
  }
}

void Interpreter::upright_arc(const ArcShape& shape, double along) {
  const PlaneAxes axes = axes_of(modes_.plane);
  if (modes_.feed_mode == FeedMode::kInverseTime) refuse("arcs outside the XY plane under G93 are not read");
  builder_.note(line_, "arcs outside the XY plane are taken as chords within 0.5 um");
  const double across = builder_.known(axes.across, line_);
  const std::vector<Edge> edges = arc_edges(shape);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    std::vector<Vec2> points;
    append_flattened(edges[k], kUprightChord, points);
    for (std::size_t n = 0; n < points.size(); ++n) {
      const double t =
          (static_cast<double>(k) + static_cast<double>(n + 1) / static_cast<double>(points.size())) /
          static_cast<double>(edges.size());
      Target to;
      to[axes.first] = points[n].x;
      to[axes.second] = points[n].y;
      to[axes.across] = std::lerp(across, along, t);
      builder_.feed(to, feed_for(0, {}), line_);
    }
  }
}

/// The words stay in force for the following blocks of the cycle; on some controls for other cycles, too.
void Interpreter::set_cycle_words(const Block& block) {
  const std::size_t across = axes_of(modes_.plane).across;
  if (cycle_.code == 0) {
    cycle_ = {};
    cycle_.level = builder_.known(across, line_) - frame_.shift(across);
  } else if (cycle_.code != motion_) {
    depends_on_dialect_ = true;
    if (!rules_.keeps_cycle_words) cycle_.z = cycle_.r = cycle_.peck = std::nullopt;
  }
  cycle_.code = motion_;
  const char bottom = "XYZ"[across];
  if (block.has(bottom)) cycle_.z = mm(block.value(bottom));
  if (block.has('R')) cycle_.r = mm(block.value('R'));
  if (block.has('Q')) cycle_.peck = mm(block.value('Q'));
  if (block.has('P')) cycle_.dwell = block.value('P') * (rules_.dwell_in_ms ? 0.001 : 1);
  if (!cycle_.z || !cycle_.r) refuse("drilling cycle without its Z or R word; give both");
}

/// In G91, R counts from a height before the cycle and Z from R.
void Interpreter::set_cycle_heights(Hole& hole) {
  const double shift = frame_.shift(hole.across);
  const double level = cycle_.level + shift;
  hole.r = *cycle_.r + (modes_.absolute ? shift : level);
  hole.bottom = *cycle_.z + (modes_.absolute ? shift : hole.r);
  hole.clear = modes_.return_to_level ? std::max(level, hole.r) : hole.r;
  if (!modes_.absolute) depends_on_dialect_ = true;
  if (hole.r < hole.bottom) refuse("drilling cycle whose R lies below its Z; correct it");
  if (return_said_ || std::max(level, hole.r) == hole.r) return;
  depends_on_dialect_ = true;
  condition(modes_.return_to_level ? "g98" : "g99",
            std::string("the program states neither G98 nor G99; the control is in ") +
                (modes_.return_to_level ? "G98 and returns to the height before the cycle"
                                        : "G99 and returns to R"));
}

double Interpreter::repeats(const Block& block) const {
  const double count = block.has('L') ? block.value('L') : block.has('K') ? block.value('K') : 1;
  if (!(count >= 0 && count <= kMostRepeats))
    refuse("L word with an impossible number of repeats; correct it");
  return count;
}

void Interpreter::canned_cycle(const Block& block) {
  set_cycle_words(block);
  const PlaneAxes axes = axes_of(modes_.plane);
  if (modes_.plane != Plane::kXY) {
    depends_on_dialect_ = true;
    if (motion_ == 840 || motion_ == 740)
      refuse(g_word(motion_) + " outside the XY plane mixes the axes up on LinuxCNC; use G17");
  }
  for (const std::size_t axis : {0U, 1U, 2U}) builder_.known(axis, line_);
  Hole hole;
  hole.code = motion_;
  hole.across = axes.across;
  hole.peck = cycle_.peck.value_or(0);
  hole.gap = modes_.unit == 1 ? 0.254 : 0.01 * kMmPerInch;
  hole.dwell = cycle_.dwell;
  hole.feeds_out_to_clear = rules_.feeds_out_to_clear;
  set_cycle_heights(hole);
  if (hole.feeds_out_to_clear != (hole.clear == hole.r) &&
      (motion_ == 740 || motion_ == 840 || motion_ == 890)) {
    depends_on_dialect_ = true;
  }
  for (int n = static_cast<int>(repeats(block)); n > 0; --n) {
    go_over_hole(block, hole);
    drill(builder_, hole, feed_for(1, block), line_);
  }
}

/// LinuxCNC goes up only where the cycles began below R, and takes the rest of the way up with the way over.
void Interpreter::go_over_hole(const Block& block, const Hole& hole) {
  const PlaneAxes axes = axes_of(modes_.plane);
  Target over, down;
  down[axes.across] = hole.r;
  const double at = *builder_.position()[axes.across];
  if (rules_.cycle_rises_over ? cycle_.level + frame_.shift(axes.across) < hole.r : at < hole.r)
    builder_.rapid(down, line_);
  for (const std::size_t axis : {axes.first, axes.second}) {
    if (block.has("XYZ"[axis])) over[axis] = target_of(axis, block);
  }
  const double now = *builder_.position()[axes.across];
  if (rules_.cycle_rises_over && now <= hole.r) over[axes.across] = hole.clear;
  builder_.rapid(over, line_);
  builder_.rapid(down, line_);
}

}  // namespace clearcut::read::gcode
