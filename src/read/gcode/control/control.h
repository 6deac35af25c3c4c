// What a word-address control holds while it runs a program.
#pragma once

#include <optional>
#include <string>

#include "read/gcode/dialect.h"
#include "read/gcode/gcode.h"
#include "read/gcode/motion/builder.h"
#include "read/gcode/motion/cycle.h"
#include "read/gcode/motion/frame.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

enum class FeedMode : unsigned char { kPerMinute, kPerTurn, kInverseTime };
enum class Plane : unsigned char { kXY, kZX, kYZ };

/// Axis indices of a plane (first, second) and of the axis across it.
struct PlaneAxes {
  std::size_t first, second, across;
};
PlaneAxes axes_of(Plane plane);

/// What M70 keeps and M72 brings back.
struct Modes {
  double unit = 1;  ///< mm
  bool absolute = true;
  bool absolute_centers = false;
  bool return_to_level = true;  ///< G98
  Plane plane = Plane::kXY;
  FeedMode feed_mode = FeedMode::kPerMinute;
  double feed = 0;  ///< mm/min or mm per turn
  double speed = 0;
  int spindle = 5;  ///< 3, 4 or 5 as in M3, M4, M5
  Coolant coolant = Coolant::kOff;
  int system = 1;  ///< work offset in use: 1 is G54
  ToolLength length;
  PathControl path;
};

/// The state that blocks read and change, and what several kinds of words need of it.
struct Control {
  /// Keeps references to all three.
  Control(ToolpathBuilder& toolpath, const DialectRules& dialect, const ReadControllerOptions& reading);

  double mm(double value) const { return value * modes.unit; }
  [[noreturn]] void refuse(const std::string& what) const;
  void condition(const std::string& name, const std::string& what) { builder.condition(name, line, what); }

  /// mm in the work's frame; where the axis word of a block sends the cutter.
  double target_of(std::size_t axis, const Block& block);
  Target target(const Block& block);
  /// Of a feed move of `length` mm.
  MmPerMin feed_for(double length, const Block& block) const;
  /// What the control may do to a cut that follows, by its path control and its tool's length, becomes a condition.
  void before_feed();
  void turn_spindle(int m);
  /// At an M6.
  void put_tool_in();

  ToolpathBuilder& builder;
  const DialectRules& rules;
  const ReadControllerOptions& options;
  Frame frame;
  Modes modes;
  std::optional<Target> references[2];  ///< stored by G28.1 and G30.1; places in the work's frame
  int line = 0;
  int motion = -1;  ///< G word in tenths; -1 none yet
  CycleWords cycle;
  int next_tool = 0;
  bool tool_said = false;    ///< a T word was seen
  bool changer = false;      ///< an M6 was seen: pauses no longer change tools
  bool tool_put_in = false;  ///< an M6 or a pause was seen
  int in_spindle_since = 0;  ///< line of the first cut with a tool that was selected and not put in; 0: none
  int last_length = 0;       ///< the last H word, 0 before any
  bool length_used = false;  ///< a tool length was in force
  bool units_said = false, distance_said = false, plane_said = false, centers_said = false;
  bool return_said = false;
  bool tied_by_m29 = false;  ///< the feed of the tapping cycles that follow is tied to the spindle
  bool moved = false;
  bool ended = false;
  bool depends_on_dialect = false;

 private:
  void check_length();
  void note_tool_in_spindle();
};

}  // namespace clearcut::read::gcode
