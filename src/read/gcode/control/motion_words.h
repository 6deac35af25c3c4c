// Motion in the work's frame: lines and arcs.
#pragma once

#include "read/gcode/control/control.h"
#include "read/gcode/motion/arc.h"

namespace clearcut::read::gcode {

/// Keeps a reference to the control.
class MotionWords {
 public:
  explicit MotionWords(Control& control) : control_(control) {}

  /// Executes the motion of a block, whatever kind it is.
  void move(const Block& block);

 private:
  void check_words_said(const Block& block);
  void check_compensation() const;
  void straight(const Block& block, bool rapid);
  void rigid_tap(const Block& block);
  void measure(const Block& block);
  void arc(const Block& block);
  void plan_arc(const Block& block, const ArcShape& shape, double along);
  void upright_arc(const ArcShape& shape, double along);
  ArcShape arc_shape(const Block& block, Vec2 from, Vec2 to);

  Control& control_;
};

}  // namespace clearcut::read::gcode
