// The modal state of a word-address control, and what each block does to it.
#pragma once

#include <optional>
#include <string>

#include "read/gcode/dialect.h"
#include "read/gcode/gcode.h"
#include "read/gcode/motion/arc.h"
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
  bool coolant = false;
  int system = 1;  ///< work offset in use: 1 is G54
  ToolLength length;
  PathControl path;
};

class Interpreter {
 public:
  Interpreter(ToolpathBuilder& builder, const DialectRules& rules, const ReadControllerOptions& options);

  /// Throws InputError for words no control takes together and for words that cannot be understood.
  void execute(const Block& block);
  /// An end word was seen; what follows is not part of the program.
  bool ended() const { return ended_; }
  /// Something was read that other controls read otherwise.
  bool depends_on_dialect() const { return depends_on_dialect_; }

 private:
  // interpreter.cpp
  void check(const Block& block) const;
  void set_modes(const Block& block);
  void set_mode(int code, const Block& block);
  void set_feed_mode(FeedMode mode);
  void set_other(int code, const Block& block);
  void use_units(double unit);
  void set_path(int code, const Block& block);
  void save_or_restore(int m);
  void set_feed_and_drive(const Block& block, double feed_unit);
  void set_drive(int m, const Block& block);
  void set_spindle(int m);
  void select_tool(const Block& block);
  void load_tool();
  void pause();
  void end(int m);
  void dwell(const Block& block);

  // interpreter_motion.cpp
  void move(const Block& block);
  void check_words_said(const Block& block);
  void before_feed();
  void check_length();
  void straight(const Block& block, bool rapid);
  void arc(const Block& block);
  void plan_arc(const Block& block, const ArcShape& shape, double along);
  void upright_arc(const ArcShape& shape, double along);
  ArcShape arc_shape(const Block& block, Vec2 from, Vec2 to);
  void canned_cycle(const Block& block);
  void set_cycle_words(const Block& block);
  void set_cycle_heights(Hole& hole);
  void go_over_hole(const Block& block, const Hole& hole);
  double repeats(const Block& block) const;
  double target_of(std::size_t axis, const Block& block);
  Target target(const Block& block);
  MmPerMin feed_for(double length, const Block& block) const;

  // interpreter_places.cpp
  bool move_specially(const Block& block);
  void go_home(const Block& block, bool first);
  Target stated_way(const Block& block);
  void go_to_reference(const Block& block, const std::array<double, 3>& reference);
  void go_to_unknown(const Block& block, const std::string& name, bool all, bool harmless);
  void store_reference(bool first);
  void machine_frame(const Block& block);
  void set_offset_table(const Block& block);
  void shift(const Block& block);
  void clear_shift(int code);
  void use_system(int code, const Block& block);
  void set_length(int code, const Block& block);

  double mm(double value) const { return value * modes_.unit; }
  [[noreturn]] void refuse(const std::string& what) const;
  void condition(const std::string& name, const std::string& what) { builder_.condition(name, line_, what); }

  ToolpathBuilder& builder_;
  const DialectRules& rules_;
  const ReadControllerOptions& options_;
  Frame frame_;
  Modes modes_;
  std::optional<Modes> saved_;
  int line_ = 0;
  int motion_ = -1;  ///< G word in tenths; -1 none yet
  int next_tool_ = 0;
  std::size_t hand_tool_ = 0;
  bool tool_said_ = false;    ///< a T word was seen
  bool changer_ = false;      ///< an M6 was seen: pauses no longer change tools
  bool length_used_ = false;  ///< a tool length was in force
  bool units_said_ = false, distance_said_ = false, plane_said_ = false, centers_said_ = false;
  bool return_said_ = false;
  bool moved_ = false;
  std::optional<Target> references_[2];  ///< stored by G28.1 and G30.1; places in the work's frame
  CycleWords cycle_;
  bool ended_ = false;
  bool depends_on_dialect_ = false;
};

}  // namespace clearcut::read::gcode
