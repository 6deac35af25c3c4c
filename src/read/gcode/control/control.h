// What a word-address control holds while it runs a program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "read/gcode/motion/builder.h"
#include "read/gcode/motion/cycle.h"
#include "read/gcode/motion/frame.h"
#include "read/gcode/program/dialect.h"
#include "read/gcode/program/program.h"
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

/// G68, G51 and G51.1: what a control makes of the places of a program. In the XY plane p becomes fixed + (xx xy; yx yy)(p - fixed).
struct PlanMap {
  bool is_on = false;
  int made_by = 0;     ///< G word in tenths
  bool flips = false;  ///< arcs turn the other way
  double xx = 1, xy = 0, yx = 0, yy = 1;
  double scale = 1;                                    ///< of lengths in plan; 0 where the two axes differ
  Vec2 fixed;                                          ///< mm, as the program counts
  double scale_z = 1, fixed_z = 0;                     ///< the same of heights
  std::string_view words = "G16, G68, G51 and G51.1";  ///< that make it, for messages

  Vec2 turned(Vec2 v) const { return {xx * v.x + xy * v.y, yx * v.x + yy * v.y}; }
  Vec2 turned_back(Vec2 v) const {
    const double area = xx * yy - xy * yx;
    return {(yy * v.x - xy * v.y) / area, (xx * v.y - yx * v.x) / area};
  }
  Vec2 placed(Vec2 p) const { return fixed + turned(p - fixed); }
  Vec2 placed_back(Vec2 p) const { return fixed + turned_back(p - fixed); }
};

/// The state that blocks read and change, and what several kinds of words need of it.
struct Control {
  /// Keeps references to all three.
  Control(ToolpathBuilder& toolpath, const DialectRules& dialect, const ReadControllerOptions& reading);

  double mm(double value) const { return value * modes.unit; }
  [[noreturn]] void refuse(const std::string& what) const;
  /// At a word that only a reader of macros understands.
  [[noreturn]] void macro(const std::string& what) const;
  /// Whether the G word makes holes on this control.
  bool is_cycle(int code) const { return is_drill_cycle(code) || is_boring_cycle(rules, code); }
  /// Whether the program or a machine file says where a work offset lies.
  bool origin_stated(int system, std::size_t axis) const;
  void condition(const std::string& name, const std::string& what) { builder.condition(name, line, what); }

  /// mm in the work's frame; where the axis word of a block sends the cutter.
  double target_of(std::size_t axis, const Block& block);
  Target target(const Block& block);
  /// The block with X and Y for '@' and '^', which it keeps.
  Block without_polar_words(const Block& block);
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
  bool adds_length = false;  ///< G43.2 was met behind the word of the length in force
  bool length_used = false;  ///< a tool length was in force
  bool units_said = false, distance_said = false, plane_said = false, centers_said = false;
  bool return_said = false;
  int radius_number = -1;                       ///< the last D word where it stays; -1: none
  std::optional<OutsideCorner> outside_corner;  ///< that a word chose (G450, G451)
  PlanMap plan_map;
  bool polar_mode = false;  ///< G16: X is a distance from the zero, Y an angle
  Target polar_place;       ///< said last in it
  Target measured;          ///< ends of the ways that a probe was moved last; places in the work's frame
  bool has_measured = false;
  std::array<bool, 3> zero_is_measured{};  ///< a probe was moved, and no place was stated since
  std::array<std::array<bool, 3>, Frame::kSystems> origins_written{};  ///< by G10 L2
  bool tied_by_m29 = false;            ///< the feed of the tapping cycles that follow is tied to the spindle
  std::optional<double> return_level;  ///< mm, as the program counts: G71 Z of OSP
  bool spindle_may_stand = false;      ///< G80 of OSP came while it turned
  bool moved = false;
  bool ended = false;
  bool depends_on_dialect = false;

 private:
  void map_plan(const Block& block, Target& target);
  void check_length();
  void note_tool_in_spindle();
};

}  // namespace clearcut::read::gcode
