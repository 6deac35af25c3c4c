// What of a drawing was left out, or is read otherwise than it is drawn.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "read/drawing/drawing.h"
#include "read/drawing/not_as_drawn.h"

namespace clearcut::read {

/// Counted while the elements are read.
struct SvgNotes {
  LeftOut not_read, hidden, not_chosen, ignored;
  LeftOut
      shapes_not_read;  ///< elements that may draw something to be cut, and that this reader does not know
  LeftOut texts_not_read;
  LeftOut letters_not_so;  ///< texts by the property that is not applied
  LeftOut not_applied;     ///< elements by the property that hides part of them
  int clipped = 0;         ///< shapes of which a part is hidden and left out
  int clipped_lines = 0;   ///< lines of which a part may be hidden, read whole
  int stroke_only = 0;
  int dashed = 0;
  int fixed_strokes = 0;
  int marked = 0;
  int even_odd_strokes = 0;
  int odd_points = 0;

  void report(Diagnostics& diagnostics, const std::string& file) const;
};

}  // namespace clearcut::read
