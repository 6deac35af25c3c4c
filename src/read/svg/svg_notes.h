// Items of a drawing left out, or read differently than drawn.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "read/drawing/drawing.h"
#include "read/drawing/not_as_drawn.h"

namespace clearcut::read {

/// Counted while the elements are read.
struct SvgNotes {
  LeftOut not_read, hidden, not_chosen, ignored;
  LeftOut shapes_not_read;  ///< unknown elements that may draw shapes to be cut
  LeftOut texts_not_read;
  LeftOut letters_not_so;  ///< texts by their unsupported property
  LeftOut not_applied;     ///< elements by the property hiding part of them
  int clipped = 0;         ///< shapes with a hidden part, which is left out
  int clipped_lines = 0;   ///< lines with a possibly hidden part, read whole
  int stroke_only = 0;
  int dashed = 0;
  int fixed_strokes = 0;
  int marked = 0;
  int even_odd_strokes = 0;
  int odd_points = 0;

  void report(Diagnostics& diagnostics, const std::string& file) const;
};

}  // namespace clearcut::read
