// <text> and <tspan> as outlines of their letters.
#pragma once

#include <string>
#include <vector>

#include "read/drawing/drawing.h"
#include "read/lettering/lettering.h"
#include "read/svg/svg_shapes.h"
#include "read/svg/svg_style.h"

namespace clearcut::read {

/// Letters of one element.
struct SvgTextRun {
  SvgStyle style;
  TextLoops loops;
};

struct SvgText {
  std::vector<SvgTextRun> runs;
  LeftOut left_out;     ///< unread elements within
  LeftOut not_applied;  ///< unsupported properties
  std::string problem;  ///< "" or the unsupported value
};

/// The letters of `text` with its style; `map` is user units to mm. Lists of x, y, dx, dy and rotate are applied
/// letter by letter. Source: SVG 1.1, chapter 10; white space collapsed as in CSS.
SvgText read_svg_text(const pugi::xml_node& text, const SvgStyle& style, const SvgStyleSheet& sheet,
                      const SvgViewSize& view, const Affine& map, Lettering& lettering);

}  // namespace clearcut::read
