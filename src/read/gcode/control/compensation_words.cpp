#include "read/gcode/control/compensation_words.h"

#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kGreatestNumber = 999;
/// radians; LinuxCNC's interpreter compares sweeps by a length, 0.0254 mm or 0.001 inches, in the program's unit (interp_queue.cc).
constexpr double kMoreSweepInMm = 0.0254, kMoreSweepInInches = 0.001;

}  // namespace

double compensation_of(const CompensationValues& values, ToolpathBuilder& builder, int number, int tool,
                       const std::string& word, int line) {
  const std::string name = "T" + std::to_string(tool);
  const std::string key =
      word == "the tool table" ? "t" + std::to_string(tool) : "d" + std::to_string(number);
  if (values.wear) {
    if (!values.is_stated || number != tool)
      builder.condition(
          "compensation-" + key, line,
          word + " holds what " + name + " is off its size by, 0 with a new tool, and not its radius");
    return *values.wear;
  }
  const auto found = values.radii.find(number);
  if (found == values.radii.end() && !values.only_radius)
    throw InputError(builder.place(line), "cutter compensation by the radius of " + word + ", and no tool T" +
                                              std::to_string(number) +
                                              " is given; add it by --tool, or state it in the job");
  const double radius = found == values.radii.end() ? *values.only_radius : found->second;
  if (!values.is_stated || number != tool)
    builder.condition("compensation-" + key, line,
                      word + " holds the radius of the tool, " + trimmed(radius, 4) +
                          " mm; where the program follows the tool's centre, say --compensation wear");
  return radius;
}

void CompensationWords::refuse_while_on(const std::string& what) const {
  if (control_.builder.compensates())
    control_.refuse(what + " while cutter compensation is on; end it by G40 before");
}

void CompensationWords::note_number(const Block& block) {
  if (!block.has('D') || !control_.rules.radius_number_stays) return;
  const double number = block.value('D');
  if (number != std::floor(number) || number < 0 || number > kGreatestNumber)
    control_.refuse("D word with an impossible number; correct it");
  if (static_cast<int>(number) != control_.radius_number) refuse_while_on("another D word");
  control_.radius_number = static_cast<int>(number);
}

/// mm; below zero the tool runs on the other side.
double CompensationWords::radius(int code, const Block& block) {
  const std::string word = g_word(code);
  if (code == 411 || code == 421) {
    if (!block.has('D')) control_.refuse(word + " without its D word; add the tool's diameter");
    return control_.mm(block.value('D')) / 2;
  }
  const int tool = control_.builder.drive.tool;
  int number = tool;
  bool is_said = false;
  if (control_.rules.radius_number_stays) {
    if (control_.radius_number < 0)
      control_.refuse(word + " without a D word, so that nothing says which radius it takes; add it");
    number = control_.radius_number;
    is_said = true;
    if (number == 0) return 0;
  } else if (block.has('D') && !control_.rules.radius_of_edge) {
    const double said = block.value('D');
    if (said != std::floor(said) || said < 0 || said > 1e6)
      control_.refuse(word + " asks for a D word that is a whole number; correct it");
    is_said = said > 0;
    if (is_said) number = static_cast<int>(said);
  }
  return compensation_of(control_.options.compensation, control_.builder, number, tool,
                         is_said ? "D" + std::to_string(number) : "the tool table", control_.line);
}

void CompensationWords::set(int code, const Block& block) {
  ToolpathBuilder& builder = control_.builder;
  if (code == 400) return builder.end_compensation();
  const std::string word = g_word(code);
  if (control_.modes.plane != Plane::kXY)
    control_.refuse(word + " outside the XY plane is not read; use G17");
  const bool turned = control_.plan_map.is_on && control_.plan_map.flips;
  double radius = this->radius(code, block);
  const bool is_left = ((code / 10 == 41) != turned) != (radius < 0);
  const auto side = is_left ? CompensationSide::kLeft : CompensationSide::kRight;
  radius = std::abs(radius);
  if (builder.compensates()) {
    if (control_.rules.compensation.begins_in_plan || !builder.compensates_as(side, radius))
      control_.refuse(word + " while cutter compensation is on already; end it by G40 before");
    return;
  }
  CompensationRules rules = control_.rules.compensation;
  if (rules.begins_in_plan) rules.more_sweep = control_.modes.unit == 1 ? kMoreSweepInMm : kMoreSweepInInches;
  if (control_.outside_corner) rules.outside = *control_.outside_corner;
  builder.begin_compensation(rules, side, radius);
}

}  // namespace clearcut::read::gcode
