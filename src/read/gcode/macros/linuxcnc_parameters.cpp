#include "read/gcode/macros/linuxcnc_parameters.h"

#include <algorithm>

#include "base/text.h"

namespace clearcut::read::gcode {

namespace {

constexpr int kLastFree = 5000;  ///< parameters beyond are the interpreter's
constexpr int kLast = 5601;

/// A name in which the interpreter says what it holds.
struct StateName {
  std::string_view name;
  double (*value)(Control& control);
};

double flag(bool value) {
  return value ? 1 : 0;
}

constexpr StateName kStateNames[] = {
    {"_x", [](Control& of) { return place_in_program(of, 0); }},
    {"_y", [](Control& of) { return place_in_program(of, 1); }},
    {"_z", [](Control& of) { return place_in_program(of, 2); }},
    {"_a", [](Control&) { return 0.0; }},
    {"_b", [](Control&) { return 0.0; }},
    {"_c", [](Control&) { return 0.0; }},
    {"_u", [](Control&) { return 0.0; }},
    {"_v", [](Control&) { return 0.0; }},
    {"_w", [](Control&) { return 0.0; }},
    {"_metric", [](Control& of) { return flag(of.modes.unit == 1); }},
    {"_imperial", [](Control& of) { return flag(of.modes.unit != 1); }},
    {"_absolute", [](Control& of) { return flag(of.modes.absolute); }},
    {"_incremental", [](Control& of) { return flag(!of.modes.absolute); }},
    {"_ijk_absolute_mode", [](Control& of) { return flag(of.modes.absolute_centers); }},
    {"_inverse_time", [](Control& of) { return flag(of.modes.feed_mode == FeedMode::kInverseTime); }},
    {"_units_per_minute", [](Control& of) { return flag(of.modes.feed_mode == FeedMode::kPerMinute); }},
    {"_units_per_rev", [](Control& of) { return flag(of.modes.feed_mode == FeedMode::kPerTurn); }},
    {"_plane", [](Control& of) { return 170 + 10.0 * static_cast<int>(of.modes.plane); }},
    {"_motion_mode", [](Control& of) { return static_cast<double>(of.motion); }},
    {"_retract_r_plane", [](Control& of) { return flag(!of.modes.return_to_level); }},
    {"_retract_old_z", [](Control& of) { return flag(of.modes.return_to_level); }},
    {"_coord_system",
     [](Control& of) {
       const int system = of.frame.system();
       return system <= 6 ? 530.0 + 10 * system : 584.0 + system;
     }},
    {"_spindle_on", [](Control& of) { return flag(of.modes.spindle != 5); }},
    {"_spindle_cw", [](Control& of) { return flag(of.modes.spindle == 3); }},
    {"_mist", [](Control& of) { return flag(has_mist(of.modes.coolant)); }},
    {"_flood", [](Control& of) { return flag(has_flood(of.modes.coolant)); }},
    {"_feed", [](Control& of) { return length_in_program(of, of.modes.feed); }},
    {"_rpm", [](Control& of) { return of.modes.speed; }},
    {"_current_tool", [](Control& of) { return static_cast<double>(of.builder.drive.tool); }},
    {"_selected_tool", [](Control& of) { return static_cast<double>(of.next_tool); }},
    {"_ccomp", [](Control&) { return 400.0; }},
    {"_line", [](Control& of) { return static_cast<double>(of.line); }},
    // What runs the program is a machine and no preview.
    {"_task", [](Control&) { return 1.0; }},
    {"_remap_level", [](Control&) { return 0.0; }},
    {"_lathe_diameter_mode", [](Control&) { return 0.0; }},
    {"_lathe_radius_mode", [](Control&) { return 1.0; }},
};

const StateName* state_name(const std::string& name) {
  const auto* const row = std::find_if(std::begin(kStateNames), std::end(kStateNames),
                                       [&](const StateName& one) { return one.name == name; });
  return row == std::end(kStateNames) ? nullptr : row;
}

/// X, Y, Z of where a probe met the work, and whether it did.
bool is_of_probe(int number) {
  return (number >= 5061 && number <= 5063) || number == 5070;
}

bool is_global(const std::string& name) {
  return name[0] == '_';
}

}  // namespace

double length_in_program(const Control& control, double mm) {
  return mm / control.modes.unit;
}

double place_in_program(Control& control, std::size_t axis) {
  return length_in_program(control, control.builder.known(axis, control.line) - control.frame.shift(axis));
}

MacroValue LinuxCncParameters::numbered(int number) {
  if (number < 1 || number > kLast)
    control_.refuse("#" + std::to_string(number) + " is no parameter of the control; it has #1 to #" +
                    std::to_string(kLast));
  return {stated(number), false};
}

double LinuxCncParameters::stated(int number) {
  if (number <= LocalParameters::kNumbered) {
    const LocalParameters& locals = locals_.back();
    const auto found = locals.numbered.find(number);
    if (found != locals.numbered.end()) return found->second;
    return locals.all_stated ? 0 : unstated(number);
  }
  if (is_of_probe(number) && control_.has_measured) return *of_state(number);
  const auto found = numbered_.find(number);
  if (found != numbered_.end()) return found->second;
  if (number <= kLastFree) return unstated(number);
  if (const auto value = of_state(number)) return *value;
  control_.refuse("#" + std::to_string(number) +
                  " is a value of the control that nothing states; put the number into the program");
}

/// LinuxCNC keeps what an earlier program has left; it has 0 where none has.
double LinuxCncParameters::unstated(int number) {
  const std::string name = "#" + std::to_string(number);
  control_.condition("parameter-" + std::to_string(number),
                     name + " is read before the program sets it; it is 0 in the control");
  return 0;
}

std::optional<double> LinuxCncParameters::of_state(int number) {
  const Frame& frame = control_.frame;
  if (number >= 5061 && number <= 5063)
    if (control_.measured[static_cast<std::size_t>(number - 5061)]) {
      control_.condition("measured-value", "what probing sets (#" + std::to_string(number) +
                                               ") is taken as the end of the way of its move");
      const auto axis = static_cast<std::size_t>(number - 5061);
      return length_in_program(control_, *control_.measured[axis] - frame.shift(axis));
    }
  if (number == 5070 && control_.has_measured) return 1;
  if (number == 5220) return frame.system();
  if (number >= 5221 && number <= 5383 && (number - 5221) % 20 < 3) {
    const int system = (number - 5221) / 20 + 1;
    const auto axis = static_cast<std::size_t>((number - 5221) % 20);
    if (control_.origin_stated(system, axis)) return length_in_program(control_, frame.origin(system, axis));
  }
  if (number == 5400) return control_.builder.drive.tool;
  if (number >= 5420 && number <= 5422)
    return place_in_program(control_, static_cast<std::size_t>(number - 5420));
  if (number >= 5423 && number <= 5428) return 0;
  return std::nullopt;
}

std::optional<double> LinuxCncParameters::of_names(const std::string& name) const {
  if (name == "_value" && has_returned_) return returned_.value_or(0);
  if (name == "_value_returned") return flag(returned_.has_value());
  if (name == "_call_level") return level;
  if (const StateName* const row = state_name(name)) return row->value(control_);
  const auto& named = is_global(name) ? named_ : locals_.back().named;
  const auto found = named.find(name);
  return found == named.end() ? std::nullopt : std::optional(found->second);
}

double LinuxCncParameters::named(const std::string& name) {
  const auto value = of_names(name);
  if (value) return *value;
  if (name.rfind("_ini[", 0) == 0 || name.rfind("_hal[", 0) == 0)
    control_.refuse("#<" + name +
                    "> asks the set-up of the machine, which is not known here; put the number in");
  control_.refuse("#<" + name +
                  "> is read before anything sets it, at which the control stops; set it before");
}

bool LinuxCncParameters::exists(const std::string& name) const {
  return of_names(name).has_value();
}

void LinuxCncParameters::assign(const Assignment& assignment) {
  const double value = assignment.value.number;
  if (!assignment.name.empty()) {
    if (state_name(assignment.name)) control_.refuse("#<" + assignment.name + "> cannot be set; rename it");
    (is_global(assignment.name) ? named_ : locals_.back().named)[assignment.name] = value;
    return;
  }
  const int number = assignment.number;
  if (number < 1 || number > kLast)
    control_.refuse("#" + std::to_string(number) + " is no parameter of the control; it has #1 to #" +
                    std::to_string(kLast));
  if (number > kLastFree && number != 5599 && !is_of_probe(number))
    control_.refuse("#" + std::to_string(number) +
                    " is the control's own; set offsets by G10 and G92, not by their parameters");
  (number <= LocalParameters::kNumbered ? locals_.back().numbered : numbered_)[number] = value;
}

void LinuxCncParameters::set_returned(std::optional<double> value) {
  returned_ = value;
  has_returned_ = true;
}

}  // namespace clearcut::read::gcode
