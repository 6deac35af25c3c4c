#include "read/gcode/control/control.h"

#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"

namespace clearcut::read::gcode {

namespace {

constexpr PlaneAxes kPlaneAxes[] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};

}  // namespace

PlaneAxes axes_of(Plane plane) {
  return kPlaneAxes[static_cast<std::size_t>(plane)];
}

Control::Control(ToolpathBuilder& toolpath, const DialectRules& dialect, const ReadControllerOptions& reading)
    : builder(toolpath),
      rules(dialect),
      options(reading),
      frame(reading.places ? std::optional(reading.places->origins) : std::nullopt) {
  modes.return_to_level = !rules.returns_to_r;
  if (!rules.path_words) modes.path.mode = PathMode::kExactPath;
  builder.path_control = modes.path;
  if (!options.hand_tools.empty()) builder.drive.tool = options.hand_tools.front();
  if (!options.places) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    builder.place_at(axis, options.places->start[axis] - frame.machine_zero(axis));
  }
}

void Control::refuse(const std::string& what) const {
  throw InputError(builder.place(line), what);
}

void Control::macro(const std::string& what) const {
  throw MacroError(builder.place(line), what);
}

bool Control::origin_stated(int system, std::size_t axis) const {
  if (system >= 1 && system <= Frame::kSystems && origins_written[static_cast<std::size_t>(system - 1)][axis])
    return true;
  return options.places && system <= options.places->stated_origins;
}

/// The block with X and Y for '@' and '^' of LinuxCNC. What is not said of the two stays as it is; in G91 they count on.
Block Control::without_polar_words(const Block& block) {
  if (!rules.polar_words) refuse("'@' and '^' are LinuxCNC's words for polar coordinates; post X and Y");
  if (modes.plane != Plane::kXY) refuse("'@' and '^' outside the XY plane; use G17");
  if (block.has('X') || block.has('Y')) refuse("X or Y beside '@' or '^'; give one of them");
  const auto at = [&](std::size_t axis) {
    return (builder.known(axis, line) - frame.shift(axis)) / modes.unit;
  };
  const double x = at(0), y = at(1);
  double radius = base::hypot(x, y), angle = base::atan2(y, x) * 180 / kPi;
  if (radius == 0 && (!modes.absolute || !block.polar_angle))
    refuse("'@' without '^', or in G91, from the zero has no angle; give both in G90");
  const bool adds = !modes.absolute;
  if (block.polar_radius) radius = *block.polar_radius + (adds ? radius : 0);
  if (block.polar_angle) angle = *block.polar_angle + (adds ? angle : 0);
  Block plain = block;
  plain.set('X', radius * base::cos(angle * kPi / 180) - (adds ? x : 0));
  plain.set('Y', radius * base::sin(angle * kPi / 180) - (adds ? y : 0));
  return plain;
}

double Control::target_of(std::size_t axis, const Block& block) {
  const double value = mm(block.value("XYZ"[axis]));
  return modes.absolute ? value + frame.shift(axis) : builder.known(axis, line) + value;
}

Target Control::target(const Block& block) {
  Target target;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!block.has("XYZ"[axis])) continue;
    target[axis] = target_of(axis, block);
    if (modes.absolute) zero_is_measured[axis] = false;
  }
  if (target[2] && plan_map.scale_z != 1) {
    if (modes.plane != Plane::kXY)
      refuse(std::string(plan_map.words) + " outside the XY plane are not read; use G17");
    const double from = modes.absolute ? plan_map.fixed_z + frame.shift(2) : builder.known(2, line);
    target[2] = from + plan_map.scale_z * (*target[2] - from);
  }
  if ((plan_map.is_on || polar_mode) && (target[0] || target[1])) map_plan(block, target);
  return target;
}

/// X and Y of a block under G16, G68 or G51.1.
void Control::map_plan(const Block& block, Target& target) {
  if (modes.plane != Plane::kXY)
    refuse(std::string(plan_map.words) + " outside the XY plane are not read; use G17");
  const Vec2 shift{frame.shift(0), frame.shift(1)};
  const Vec2 stands{builder.known(0, line), builder.known(1, line)};
  Vec2 place = plan_map.placed_back(stands - shift);
  if (polar_mode) {
    if (!modes.absolute) refuse("G16 in G91 is not read; post X and Y");
    if (block.has('X')) polar_place[0] = mm(block.value('X'));
    if (block.has('Y')) polar_place[1] = block.value('Y');
    if (!polar_place[0] || !polar_place[1])
      refuse("G16 before both its radius X and its angle Y are said; add the other");
    const double angle = *polar_place[1] * kPi / 180;
    place = Vec2{base::cos(angle), base::sin(angle)} * *polar_place[0];
  } else {
    for (const std::size_t axis : {0U, 1U}) {
      if (!block.has("XY"[axis])) continue;
      double& value = axis == 0 ? place.x : place.y;
      value = mm(block.value("XY"[axis])) + (modes.absolute ? 0 : value);
    }
  }
  const Vec2 to = plan_map.placed(place) + shift;
  target[0] = to.x;
  target[1] = to.y;
}

MmPerMin Control::feed_for(double length, const Block& block) const {
  if (modes.feed_mode == FeedMode::kPerTurn) return MmPerMin::of(modes.feed * modes.speed);
  if (modes.feed_mode == FeedMode::kPerMinute) return MmPerMin::of(modes.feed);
  if (!block.has('F')) refuse("feed move under G93 without its own F word; add it");
  return MmPerMin::of(modes.feed * length);
}

void Control::before_feed() {
  check_length();
  note_tool_in_spindle();
  if (spindle_may_stand)
    condition("g80-spindle", "the spindle still turns after the G80 above, which may have stopped it");
  spindle_may_stand = false;
  const PathMode mode = modes.path.mode;
  if (mode == PathMode::kUnstated) {
    condition("blending", std::string(rules.no_path_word) +
                              " is stated; the control keeps to the path, whatever bound it was left with");
  } else if (mode == PathMode::kContinuous) {
    condition("blending", std::string(rules.blends_freely) +
                              " states no bound; the control rounds corners by nothing that matters");
  } else if (mode == PathMode::kSmoothness) {
    condition("blending", std::string(rules.blends_by_setting) +
                              " takes the bound from a setting; the control rounds corners within it");
  }
}

void Control::check_length() {
  const ToolLength& length = modes.length;
  const int tool = builder.drive.tool;
  const bool numbered = length.kind == LengthKind::kNumbered || length.kind == LengthKind::kOfTool;
  const std::string h = std::to_string(length.h);
  if (numbered && length.h != tool && tool != 0 && !(length.kind == LengthKind::kOfTool && length.h == 0)) {
    condition("tool-length-h" + h, "length H" + h + " is that of tool T" + std::to_string(tool));
  }
  const bool off = length.kind == LengthKind::kOff || length.kind == LengthKind::kUnstated;
  if (off && length_used) {
    condition("tool-length-off", "cuts without the tool's length (G49) after a length was in force");
  }
}

/// A T word alone makes no changer move. Where a program has no M6 at all hands put its tool in before the start.
void Control::note_tool_in_spindle() {
  if (rules.changer && tool_said && !tool_put_in && builder.drive.tool != 0 && in_spindle_since == 0)
    in_spindle_since = line;
}

void Control::put_tool_in() {
  if (in_spindle_since > 0)
    builder.condition("tool-in-spindle", in_spindle_since,
                      "T" + std::to_string(builder.drive.tool) +
                          " is in the spindle; the program selects it and has no M6 before it cuts");
  tool_put_in = true;
}

void Control::turn_spindle(int m) {
  modes.spindle = m;
  builder.set_spindle(m, line);
}

}  // namespace clearcut::read::gcode
