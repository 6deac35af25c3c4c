// G40, G41, G42, G41.1 and G42.1, and G12 and G13 of Haas: a circle milled from its centre.
#pragma once

#include "read/gcode/control/control.h"

namespace clearcut::read::gcode {

/// Keeps a reference to the control.
class CompensationWords {
 public:
  explicit CompensationWords(Control& control) : control_(control) {}

  /// The word in tenths: 400, 410, 411, 420, 421.
  void set(int code, const Block& block);
  /// A D word on its own, which later words refer to.
  void note_number(const Block& block);
  /// Throws where `what` must not happen while the control compensates.
  void refuse_while_on(const std::string& what) const;

 private:
  double radius(int code, const Block& block);

  Control& control_;
};

/// The compensation in mm that the D word `number` selects while `tool` is in the spindle; `word`: its text for messages. Throws
/// InputError where no value of it was stated.
double compensation_of(const CompensationValues& values, ToolpathBuilder& builder, int number, int tool,
                       const std::string& word, int line);

}  // namespace clearcut::read::gcode
