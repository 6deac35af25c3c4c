// Drilling cycles: their words, heights and ways over.
#pragma once

#include "read/gcode/control/control.h"

namespace clearcut::read::gcode {

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
