#include "read/gcode/control/circle_words.h"

#include <array>

#include "base/text/format.h"
#include "read/gcode/control/compensation_words.h"
#include "read/gcode/words/g_words.h"

namespace clearcut::read::gcode {

namespace {

/// mm; what the D word takes off the circle.
double radius_of_tool(Control& control) {
  const int number = control.radius_number;
  if (number <= 0) return 0;
  return compensation_of(control.options.compensation, control.builder, number, control.builder.drive.tool,
                         "D" + std::to_string(number), control.line);
}

void refuse_what_is_not_read(Control& control, const Block& block, const std::string& word) {
  if ((control.rules.g.sets & kHaasWords) == 0)
    control.refuse(word + " is not read; post the program without it");
  if (block.has('K') || block.has('Q') || block.has('L'))
    control.refuse(word + " with K, Q or L is not read; post its circles one by one");
  if (block.has('X') || block.has('Y'))
    control.refuse(word + " with X or Y is not read; move to the centre in a block before");
  if (control.modes.plane != Plane::kXY || control.plan_map.is_on)
    control.refuse(word + " outside the XY plane, under G68 or G51.1 is not read");
  CompensationWords(control).refuse_while_on(word);
}

}  // namespace

bool mill_circle(Control& control, const Block& block) {
  const bool clockwise = has_g(block, 120);
  if (!clockwise && !has_g(block, 130)) return false;
  const std::string word = clockwise ? "G12" : "G13";
  refuse_what_is_not_read(control, block, word);
  if (!block.has('I') || block.value('I') <= 0)
    control.refuse(word + " without its I word; add the radius of the circle");
  const double tool = radius_of_tool(control), radius = control.mm(block.value('I')) - tool;
  if (radius <= 0)
    control.refuse(word + " with a circle that is not larger than the tool, whose radius is " +
                   trimmed(tool, 4) + " mm; the control stops");
  control.moved = true;
  control.before_feed();
  ToolpathBuilder& builder = control.builder;
  const int line = control.line;
  const Vec2 center{builder.known(0, line), builder.known(1, line)};
  if (block.has('Z')) {
    Target down;
    down[2] = control.target_of(2, block);
    builder.feed(down, control.feed_for(0, block), line);
  }
  const double z = builder.known(2, line);
  const Vec2 right = center + Vec2{radius, 0}, left = center - Vec2{radius, 0},
             middle = center + Vec2{radius / 2, 0};
  const Turn turn = clockwise ? Turn::kClockwise : Turn::kCounterClockwise;
  const std::array<Edge, 4> way{Edge::arc(center, right, middle, turn), Edge::arc(right, left, center, turn),
                                Edge::arc(left, right, center, turn), Edge::arc(right, center, middle, turn)};
  for (const Edge& edge : way) builder.arc(edge, z, control.feed_for(edge.length(), block), line);
  return true;
}

}  // namespace clearcut::read::gcode
