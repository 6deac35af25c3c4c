// Motion in the work's frame: lines and arcs, and drilling cycles with their words, heights and ways over.
#pragma once

#include "read/gcode/control/control.h"
#include "read/gcode/motion/arc.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

/// Keeps a reference to the control.
class MotionWords {
 public:
  explicit MotionWords(Control& control) : control_(control) {}

  /// Executes the motion of a block, whatever kind it is.
  void move(const Block& block);

 private:
  void check_corner(const Block& block);
  void round_corner(const CornerWord& said);
  [[noreturn]] void refuse_idle_corner() const;
  void check_words_said(const Block& block);
  void check_compensation() const;
  [[noreturn]] void refuse_motion() const;
  void refuse_unequal_scales() const;
  void straight(const Block& block, bool rapid);
  void rigid_tap(const Block& block);
  void measure(const Block& block);
  void arc(const Block& block);
  void plan_arc(const Block& block, const ArcShape& shape, double along);
  void upright_arc(const ArcShape& shape, double along);
  ArcShape arc_shape(const Block& block, Vec2 from, Vec2 to);

  Control& control_;
};

/// Keeps a reference to the control.
class CannedCycles {
 public:
  explicit CannedCycles(Control& control) : control_(control) {}

  /// The holes of one block, in the cycle that is in force.
  void execute(const Block& block);

 private:
  Block counted_on(Block block);
  void check_dwell(const Block& block) const;
  void set_cycle_words(const Block& block);
  void set_cycle_heights(Hole& hole);
  void go_over_hole(const Block& block, const Hole& hole);
  double repeats(const Block& block) const;

  Control& control_;
};

}  // namespace clearcut::read::gcode
