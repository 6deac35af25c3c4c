// The modal state of a word-address control, and what each block does to it.
#pragma once

#include <string>

#include "read/gcode/arc.h"
#include "read/gcode/block.h"
#include "read/gcode/builder.h"
#include "read/gcode/cycle.h"

namespace clearcut::read::gcode {

class Interpreter {
 public:
  explicit Interpreter(ToolpathBuilder& builder) : builder_(builder) {}

  /// Throws InputError for words no control takes together and for words that cannot be understood.
  void execute(const Block& block);
  /// Own comments open sections and name tools; others say nothing.
  void comment(std::string_view text);
  /// An end word was seen; what follows is not part of the program.
  bool ended() const { return ended_; }

 private:
  enum class FeedMode { kPerMinute, kPerTurn, kInverseTime };
  enum class Plane { kXY, kZX, kYZ };

  void check(const Block& block) const;
  void set_modes(const Block& block);
  void set_mode(int code, const Block& block);
  void set_feed_mode(FeedMode mode);
  void set_other(int code, const Block& block);
  void set_feed_and_drive(const Block& block);
  void set_drive(int m, const Block& block);
  void select_tool(int number);
  void load_tool();
  void move(const Block& block);
  bool move_specially(const Block& block);
  void go_home(const Block& block);
  void shift(const Block& block);
  void straight(const Block& block, bool rapid);
  void arc(const Block& block);
  void plan_arc(const Block& block, const ArcShape& shape, double along);
  void upright_arc(const ArcShape& shape, double along);
  ArcShape arc_shape(const Block& block, Vec2 from, Vec2 to) const;
  void canned_cycle(const Block& block);
  void set_cycle_words(const Block& block);
  void stop(const Block& block);

  double mm(double value) const { return value * unit_; }
  double target_of(std::size_t axis, const Block& block);
  Target target(const Block& block);
  MmPerMin feed_for(double length, const Block& block) const;
  [[noreturn]] void refuse(const std::string& what) const;

  ToolpathBuilder& builder_;
  int line_ = 0;
  double unit_ = 1;  ///< mm
  bool absolute_ = true;
  bool absolute_centers_ = false;
  bool return_to_old_z_ = true;  ///< G98
  Plane plane_ = Plane::kXY;
  FeedMode feed_mode_ = FeedMode::kPerMinute;
  int motion_ = -1;   ///< G word in tenths; -1 none yet
  double feed_ = 0;   ///< mm/min or mm per turn
  double speed_ = 0;  ///< S word, rpm
  int spindle_ = 0;   ///< 3, 4 or 5 as in M3, M4, M5; 0 never said
  int next_tool_ = 0;
  bool changer_ = false;           ///< an M6 was seen: pauses no longer change tools
  int offset_word_ = 0;            ///< work offset in use, tenths
  std::array<double, 3> shift_{};  ///< G92 and G52, mm
  DrillCycle cycle_;
  double cycle_old_z_ = 0;
  bool ended_ = false;
};

}  // namespace clearcut::read::gcode
