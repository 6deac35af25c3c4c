#include "read/gcode/control/control.h"

#include <cmath>

#include "base/error.h"

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

double Control::target_of(std::size_t axis, const Block& block) {
  const double value = mm(block.value("XYZ"[axis]));
  return modes.absolute ? value + frame.shift(axis) : builder.known(axis, line) + value;
}

Target Control::target(const Block& block) {
  Target target;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block.has("XYZ"[axis])) target[axis] = target_of(axis, block);
  }
  return target;
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
