// Order of execution within a block as in RS274/NGC: modes, feed, speed, tool, spindle, coolant, motion,
// stop.
#include "read/gcode/interpreter.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "read/gcode/g_words.h"
#include "read/gcode/marker.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kMostRepeats = 10000;
/// Arcs standing upright (G18, G19) become chords: a Move is an arc in plan only. mm.
constexpr double kUprightChord = 0.0005;

}  // namespace

void Interpreter::refuse(const std::string& what) const {
  throw InputError(builder_.place(line_), what);
}

void Interpreter::execute(const Block& block) {
  line_ = block.line;
  check(block);
  set_modes(block);
  set_feed_and_drive(block);
  move(block);
  stop(block);
}

void Interpreter::check(const Block& block) const {
  std::uint32_t seen = 0;
  for (const int code : block.g) {
    const Group group = group_of(code);
    if (!is_modal(group)) continue;
    const std::uint32_t bit = 1U << static_cast<unsigned>(group);
    if (seen & bit) refuse(g_word(code) + " contradicts another G word of its block; split the block");
    seen |= bit;
  }
  for (const char letter : {'A', 'B', 'C', 'U', 'V', 'W'}) {
    if (block.has(letter) && block.value(letter) != 0) {
      refuse(std::string("axis word ") + letter + "; only the three axes X, Y, Z are read");
    }
  }
}

void Interpreter::set_modes(const Block& block) {
  for (const int code : block.g) set_mode(code, block);
}

void Interpreter::set_mode(int code, const Block& block) {
  switch (code) {
    case 170:
      plane_ = Plane::kXY;
      break;
    case 180:
      plane_ = Plane::kZX;
      break;
    case 190:
      plane_ = Plane::kYZ;
      break;
    case 200:
      unit_ = kMmPerInch;
      break;
    case 210:
      unit_ = 1;
      break;
    case 900:
      absolute_ = true;
      break;
    case 910:
      absolute_ = false;
      break;
    case 901:
      absolute_centers_ = true;
      break;
    case 911:
      absolute_centers_ = false;
      break;
    case 930:
      set_feed_mode(FeedMode::kInverseTime);
      break;
    case 940:
      set_feed_mode(FeedMode::kPerMinute);
      break;
    case 950:
      set_feed_mode(FeedMode::kPerTurn);
      break;
    case 980:
      return_to_old_z_ = true;
      break;
    case 990:
      return_to_old_z_ = false;
      break;
    default:
      set_other(code, block);
  }
}

/// Words that leave the path alone pass; those that would change it in ways not understood are refused.
void Interpreter::set_other(int code, const Block& block) {
  const Group group = group_of(code);
  if (group == Group::kOffset) {
    if (offset_word_ != 0 && offset_word_ != code) {
      builder_.warn(line_, "several work offsets; all are taken as one and the same frame");
    }
    offset_word_ = code;
  } else if (group == Group::kCompensation) {
    refuse(g_word(code) +
           " cutter radius compensation is not read; post the path of the tool's centre (G40)");
  } else if (code == 640 && !block.has('P')) {
    builder_.warn(line_,
                  "G64 without P lets some controls round corners by any amount; the exact path is judged");
  } else if (code == 51) {
    builder_.note(line_, "G5.1 is taken as look-ahead and ignored");
  } else if (group == Group::kUnknown) {
    refuse(g_word(code) + " is not read; post the program without it");
  }
}

/// A feed of one kind means nothing in another.
void Interpreter::set_feed_mode(FeedMode mode) {
  if (mode != feed_mode_) feed_ = 0;
  feed_mode_ = mode;
}

void Interpreter::set_feed_and_drive(const Block& block) {
  if (block.has('F')) {
    if (block.value('F') < 0) refuse("F word below zero; correct it");
    feed_ = feed_mode_ == FeedMode::kInverseTime ? block.value('F') : mm(block.value('F'));
  }
  if (block.has('S') && !has_g(block, 40)) speed_ = std::abs(block.value('S'));
  if (block.has('T')) {
    if (block.value('T') < 0 || block.value('T') > 1e6) refuse("T word with an impossible tool; correct it");
    select_tool(static_cast<int>(block.value('T')));
  }
  for (const int m : block.m) set_drive(m, block);
  const bool turning = spindle_ == 3 || spindle_ == 4;
  builder_.drive.spindle_rpm = turning ? speed_ : 0;
  builder_.drive.clockwise = spindle_ != 4;
}

/// Without a tool so far it is in the spindle already; otherwise it waits for M6 or a pause.
void Interpreter::select_tool(int number) {
  next_tool_ = number;
  if (builder_.drive.tool == 0) builder_.drive.tool = number;
}

void Interpreter::load_tool() {
  builder_.drive.tool = next_tool_;
  builder_.begin_section();
}

void Interpreter::comment(std::string_view text) {
  int tool = 0;
  const Marker marker = read_marker(text, builder_, tool);
  if (marker == Marker::kTool) select_tool(tool);
  if (marker == Marker::kEnd) ended_ = true;
}

void Interpreter::set_drive(int m, const Block& block) {
  switch (m) {
    case 30:
    case 40:
    case 50:
      spindle_ = m / 10;
      return;
    case 130:  // spindle and coolant in one
      spindle_ = 3;
      builder_.drive.coolant = true;
      return;
    case 60:
      changer_ = true;
      return load_tool();
    case 70:
    case 80:
    case 880:
      builder_.drive.coolant = true;
      return;
    case 90:
    case 890:
      builder_.drive.coolant = false;
      return;
    case 0:
    case 10:  // a pause is where tools are changed by hand
      if (!changer_ && next_tool_ != builder_.drive.tool) load_tool();
      return;
    case 960:
    case 970:
    case 980:
      if (m == 980 && !block.has('P')) return;
      refuse("subprogram calls are not read; post the program without them");
    case 20:
    case 300:
    case 990:
    case 480:
    case 490:
    case 1170:
    case 1180:
      return;
    default:
      builder_.note(line_, "M" + std::to_string(m / 10) + " is ignored");
  }
}

void Interpreter::move(const Block& block) {
  const int said = motion_in(block);
  if (said >= 0) motion_ = said;
  if (move_specially(block)) return;
  const bool cycle = is_drill_cycle(motion_);
  if (!cycle) cycle_ = {};
  const bool arc_words = block.has('I') || block.has('J') || block.has('K') || block.has('R');
  const bool arc_motion = motion_ == 20 || motion_ == 30;
  if (!block.has_axis() && !(arc_motion && arc_words)) return;
  if (motion_ < 0) {
    builder_.warn(line_, "axis words before any motion word; taken as rapid (G0)");
    motion_ = 0;
  }
  if (motion_ == 0 || motion_ == 10) return straight(block, motion_ == 0);
  if (arc_motion) return arc(block);
  if (cycle) return canned_cycle(block);
  if (motion_ == 800) refuse("axis words after G80 without a motion word; add G0 or G1");
  refuse(g_word(motion_) + " is not read; post the program without it");
}

/// Words that use X, Y, Z for something else than motion in the work's frame.
bool Interpreter::move_specially(const Block& block) {
  if (has_g(block, 280) || has_g(block, 300) || has_g(block, 530)) {
    go_home(block);
    return true;
  }
  if (has_g(block, 100)) {
    builder_.warn(line_,
                  "G10 settings are not applied; the program is judged in the frame of its work offset");
    return true;
  }
  if (has_g(block, 920) || has_g(block, 520)) {
    shift(block);
    return true;
  }
  if (has_g(block, 921) || has_g(block, 922)) shift_ = {};
  if (has_g(block, 923)) refuse("G92.3 restores an offset from outside the program; post without it");
  if (has_g(block, 40)) return true;
  return false;
}

/// Machine places are unknown here: those with Z lift the tool straight up, those without stay where they
/// are.
void Interpreter::go_home(const Block& block) {
  const bool machine_frame = has_g(block, 530);
  const bool all = !machine_frame && !block.has_axis();
  if (!machine_frame && block.has_axis()) builder_.rapid(target(block), line_);
  if (all || block.has('Z')) builder_.lift_home(line_);
  builder_.note(
      line_, "moves in the machine's own frame (G28, G30, G53) are taken as straight up to Z 100 or higher");
}

/// G92 renames the place where the tool is; G52 moves the origin. Neither moves the tool.
void Interpreter::shift(const Block& block) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = "XYZ"[axis];
    if (!block.has(letter)) continue;
    const double value = mm(block.value(letter));
    if (has_g(block, 520)) {
      shift_[axis] = value;
    } else if (builder_.position()[axis]) {
      shift_[axis] = *builder_.position()[axis] - value;
    } else {
      builder_.place_at(axis, value + shift_[axis]);
    }
  }
}

double Interpreter::target_of(std::size_t axis, const Block& block) {
  const double value = mm(block.value("XYZ"[axis]));
  return absolute_ ? value + shift_[axis] : builder_.known(axis, line_) + value;
}

Target Interpreter::target(const Block& block) {
  Target target;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block.has("XYZ"[axis])) target[axis] = target_of(axis, block);
  }
  return target;
}

MmPerMin Interpreter::feed_for(double length, const Block& block) const {
  if (feed_mode_ == FeedMode::kPerTurn) return MmPerMin::of(feed_ * speed_);
  if (feed_mode_ == FeedMode::kPerMinute) return MmPerMin::of(feed_);
  if (!block.has('F')) refuse("feed move under G93 without its own F word; add it");
  return MmPerMin::of(feed_ * length);
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

namespace {

/// Axis indices of a plane (first, second) and of the axis across it.
struct PlaneAxes {
  std::size_t first, second, across;
};
constexpr PlaneAxes kPlaneAxes[] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};

}  // namespace

void Interpreter::arc(const Block& block) {
  const PlaneAxes axes = kPlaneAxes[static_cast<int>(plane_)];
  std::array<double, 3> from{}, to{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    from[axis] = builder_.known(axis, line_);
    to[axis] = block.has("XYZ"[axis]) ? target_of(axis, block) : from[axis];
    if (!(std::abs(to[axis]) <= 1e6)) refuse("coordinate beyond any machine; check the number and the units");
  }
  const ArcShape shape =
      arc_shape(block, {from[axes.first], from[axes.second]}, {to[axes.first], to[axes.second]});
  if (plane_ == Plane::kXY) {
    plan_arc(block, shape, to[2]);
  } else {
    upright_arc(shape, to[axes.across]);
  }
}

ArcShape Interpreter::arc_shape(const Block& block, Vec2 from, Vec2 to) const {
  const Turn turn = motion_ == 20 ? Turn::kClockwise : Turn::kCounterClockwise;
  const PlaneAxes axes = kPlaneAxes[static_cast<int>(plane_)];
  const RadiusRule rule = unit_ == 1 ? RadiusRule{} : RadiusRule{0.0005 * kMmPerInch, 0.05 * kMmPerInch};
  if (block.has('R')) return arc_of_radius(from, to, mm(block.value('R')), turn, rule, builder_.place(line_));
  const char first = "IJK"[axes.first], second = "IJK"[axes.second];
  if (!block.has(first) && !block.has(second)) {
    refuse(std::string("arc without ") + first + ", " + second + " or R; give its centre");
  }
  const auto center_of = [&](char letter, std::size_t axis, double start) {
    if (!block.has(letter)) return start;
    return mm(block.value(letter)) + (absolute_centers_ ? shift_[axis] : start);
  };
  const double turns = block.has('P') ? block.value('P') : 1;
  if (!(turns >= 1 && turns <= kMostRepeats) || turns != std::floor(turns))
    refuse("P word is no number of turns; correct it");
  const Vec2 center{center_of(first, axes.first, from.x), center_of(second, axes.second, from.y)};
  return arc_about(from, to, center, turn, static_cast<int>(turns), rule, builder_.place(line_));
}

void Interpreter::plan_arc(const Block& block, const ArcShape& shape, double z_to) {
  const std::vector<Edge> edges = arc_edges(shape);
  const double z_from = builder_.known(2, line_);
  const double round = shape.sweep * distance(shape.from, shape.center);
  const MmPerMin feed = feed_for(std::hypot(round, z_to - z_from), block);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const double t = static_cast<double>(k + 1) / static_cast<double>(edges.size());
    builder_.arc(edges[k], std::lerp(z_from, z_to, t), feed, line_);
  }
}

void Interpreter::upright_arc(const ArcShape& shape, double along) {
  const PlaneAxes axes = kPlaneAxes[static_cast<int>(plane_)];
  if (feed_mode_ == FeedMode::kInverseTime) refuse("arcs outside the XY plane under G93 are not read");
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

/// Z, R and Q stay in force for the cycle's following blocks. In G91, R counts from the height before the
/// cycle and Z from R.
void Interpreter::set_cycle_words(const Block& block) {
  const bool fresh = cycle_.code == 0;
  if (fresh) cycle_old_z_ = builder_.known(2, line_);
  cycle_.code = motion_;
  if (block.has('R'))
    cycle_.r = absolute_ ? mm(block.value('R')) + shift_[2] : cycle_old_z_ + mm(block.value('R'));
  if (block.has('Z')) {
    if (!absolute_ && !cycle_.r) refuse("drilling cycle without its Z or R word; give both");
    cycle_.z = mm(block.value('Z')) + (absolute_ ? shift_[2] : *cycle_.r);
  }
  if (block.has('Q')) cycle_.peck = mm(block.value('Q'));
}

void Interpreter::canned_cycle(const Block& block) {
  set_cycle_words(block);
  const double repeats = block.has('L') ? block.value('L') : block.has('K') ? block.value('K') : 1;
  if (!(repeats >= 0 && repeats <= kMostRepeats))
    refuse("L word with an impossible number of repeats; correct it");
  for (int n = 0; n < static_cast<int>(repeats); ++n) {
    Target to;
    for (const std::size_t axis : {0U, 1U}) {
      if (block.has("XYZ"[axis])) to[axis] = target_of(axis, block);
    }
    if (cycle_.r && builder_.known(2, line_) < *cycle_.r)
      builder_.rapid({std::nullopt, std::nullopt, cycle_.r}, line_);
    builder_.rapid(to, line_);
    const double r = cycle_.r.value_or(cycle_old_z_);
    drill(builder_, cycle_, return_to_old_z_ ? std::max(cycle_old_z_, r) : r, feed_for(1, block), line_);
  }
}

void Interpreter::stop(const Block& block) {
  for (const int m : block.m) {
    if (m == 20 || m == 300 || m == 990) ended_ = true;
  }
}

}  // namespace clearcut::read::gcode
