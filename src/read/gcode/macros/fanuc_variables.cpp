#include "read/gcode/macros/fanuc_variables.h"

#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "base/text.h"

namespace clearcut::read::gcode {

namespace {

constexpr int kLastLocal = 33;
constexpr int kFirstCommon = 100, kFirstKept = 500, kLastCommon = 999;
/// Haas has more of them.
constexpr int kFirstOfHaas = 10000, kLastOfHaas = 10999;

bool is_common(int number) {
  return (number >= kFirstCommon && number <= kLastCommon) ||
         (number >= kFirstOfHaas && number <= kLastOfHaas);
}

/// Of each letter from A on; 0: no argument.
constexpr int kVariableOfLetter[26] = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                       0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

/// A modal word of the system, #4001 and on.
struct ModalVariable {
  int number;
  double (*value)(const Control& control);
};
constexpr ModalVariable kModalVariables[] = {
    {4001, [](const Control& of) { return of.motion < 0 ? 0 : of.motion / 10.0; }},
    {4002, [](const Control& of) { return 17.0 + static_cast<int>(of.modes.plane); }},
    {4003, [](const Control& of) { return of.modes.absolute ? 90.0 : 91.0; }},
    {4005, [](const Control& of) { return of.modes.feed_mode == FeedMode::kPerTurn ? 95.0 : 94.0; }},
    {4006, [](const Control& of) { return of.modes.unit == 1 ? 21.0 : 20.0; }},
    {4010, [](const Control& of) { return of.modes.return_to_level ? 98.0 : 99.0; }},
    {4014, [](const Control& of) { return 53.0 + of.frame.system(); }},
    {4109, [](const Control& of) { return of.modes.feed / of.modes.unit; }},
    {4119, [](const Control& of) { return of.modes.speed; }},
    {4120, [](const Control& of) { return static_cast<double>(of.next_tool); }}};

std::string shown_variable(int number) {
  return "#" + std::to_string(number);
}

}  // namespace

MacroValue FanucVariables::numbered(int number) {
  if (number == 0) return {0, true};
  if (number < 0) control_.refuse(shown_variable(number) + " is no variable of the control; correct it");
  const bool is_local = number <= kLastLocal;
  if (!is_local && !is_common(number) && control_.rules.macros == MacroLanguage::kFanuc)
    return of_system(number);
  const Locals& place = is_local ? locals_.back() : common_;
  const auto found = place.find(number);
  if (found != place.end()) return found->second;
  if (is_local && locals_.size() > 1) return {0, true};
  return unstated(number);
}

double FanucVariables::named(const std::string& name) {
  control_.refuse("#<" + name + "> is no variable of the control; named parameters are LinuxCNC's");
}

/// Fanuc has a parameter that decides; as delivered it takes away what is below 0.
double FanucVariables::angle_below_zero(double degrees) {
  if (control_.rules.macros != MacroLanguage::kFanuc) return degrees;
  const bool counts_from_zero = control_.rules.dialect == Dialect::kFanuc;
  control_.condition("atan-range",
                     counts_from_zero
                         ? "ATAN of two sides gives angles from 0 to 360 degrees in the control, "
                           "as it is delivered (parameter 6004.0)"
                         : "ATAN of two sides gives angles from -180 to 180 degrees in the control");
  return counts_from_zero ? degrees + 360 : degrees;
}

MacroValue FanucVariables::unstated(int number) {
  const std::string name = shown_variable(number);
  if (control_.rules.macros == MacroLanguage::kMach) {
    control_.condition("parameter-" + std::to_string(number),
                       name + " is read before the program sets it; it is 0 in the control");
    return {};
  }
  if (number >= kFirstKept)
    control_.refuse(name + " keeps a value in the control that nothing states; set it in the program");
  control_.condition("parameter-" + std::to_string(number),
                     name + " is read before the program sets it; it is vacant in the control");
  return {0, true};
}

std::optional<double> FanucVariables::of_place(int number) {
  const auto in_program = [&](std::size_t axis, double place) {
    return (place - control_.frame.shift(axis)) / control_.modes.unit;
  };
  for (const int first : {5001, 5041}) {
    if (number < first || number >= first + 3) continue;
    const auto axis = static_cast<std::size_t>(number - first);
    return in_program(axis, control_.builder.known(axis, control_.line));
  }
  if (number >= 5061 && number <= 5063 && control_.has_measured) {
    const auto axis = static_cast<std::size_t>(number - 5061);
    control_.condition("measured-value", "what probing sets (" + shown_variable(number) +
                                             ") is taken as the end of the way of its move");
    return in_program(axis, control_.measured[axis].value_or(control_.builder.known(axis, control_.line)));
  }
  if (number >= 5221 && number <= 5323 && (number - 5221) % 20 < 3) {
    const int system = (number - 5221) / 20 + 1;
    const auto axis = static_cast<std::size_t>((number - 5221) % 20);
    if (control_.origin_stated(system, axis))
      return control_.frame.origin(system, axis) / control_.modes.unit;
  }
  return std::nullopt;
}

MacroValue FanucVariables::of_system(int number) {
  for (const ModalVariable& row : kModalVariables)
    if (row.number == number) return {row.value(control_), false};
  if (const auto value = of_place(number)) return {*value, false};
  control_.refuse(shown_variable(number) +
                  " is a value of the control that nothing states; put the number into the program");
}

void FanucVariables::set_system(int number, double value) {
  const std::string name = shown_variable(number);
  switch (number) {
    case 3000:
      control_.refuse("the program stops here with an alarm of its own (#3000 = " + trimmed(value, 0) +
                      "); what it asks for does not hold");
    case 3006:
      control_.builder.add_event(ControlEventKind::kPause, control_.line);
      return;
    case 3001:
    case 3002:
    case 3003:
    case 3004:
      control_.builder.note(control_.line,
                            name + " sets a clock or a switch of the control, which moves nothing");
      return;
    default:
      control_.refuse(name + " is a variable of the system that is not followed; set offsets by G10");
  }
}

void FanucVariables::assign(const Assignment& assignment) {
  const int number = assignment.number;
  if (number <= 0) control_.refuse(shown_variable(number) + " cannot be set; correct its number");
  if (number <= kLastLocal)
    locals_.back()[number] = assignment.value;
  else if (is_common(number) || control_.rules.macros == MacroLanguage::kMach)
    common_[number] = assignment.value;
  else
    set_system(number, assignment.value.number);
}

FanucVariables::Locals arguments_of(const std::vector<ArgumentWord>& words, const std::string& place) {
  constexpr std::string_view kCenters = "IJK";
  const auto count = [&](char letter) {
    return std::count_if(words.begin(), words.end(),
                         [&](const ArgumentWord& one) { return one.letter == letter; });
  };
  const bool in_turns = count('I') > 1 || count('J') > 1 || count('K') > 1;
  FanucVariables::Locals locals;
  int turn = 0;
  std::size_t last = kCenters.size();
  for (const ArgumentWord& word : words) {
    if (std::string_view("GLNOP").find(word.letter) != std::string_view::npos) continue;
    int variable = kVariableOfLetter[word.letter - 'A'];
    const std::size_t center = kCenters.find(word.letter);
    if (in_turns && center != std::string_view::npos) {
      // I J K I J K ...: a letter that does not come behind the one before begins the next three.
      if (last != kCenters.size() && center <= last) ++turn;
      last = center;
      variable = 4 + 3 * turn + static_cast<int>(center);
    }
    if (variable < 1 || variable > kLastLocal)
      throw InputError(place, std::string(1, word.letter) + " is no argument of a macro; correct the call");
    locals[variable] = {word.value, false};
  }
  return locals;
}

}  // namespace clearcut::read::gcode
