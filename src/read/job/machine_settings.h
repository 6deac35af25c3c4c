// A machine from the settings of its own control: a Grbl `$$` dump, a LinuxCNC .ini, a Marlin M503.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/machine.h"

namespace clearcut::read {

/// A machine, and the line of its file where each of its values is said; keys are written as options are ("max-spindle").
struct MachineSettings {
  Machine machine;
  std::vector<std::pair<std::string, int>> lines;
};

/// Nothing where the text is of none of these kinds. What the settings say of other things than speeds, accelerations, corners
/// and the spindle is not used: the travel ($130 to $132, MIN_LIMIT, MAX_LIMIT) counts from the machine's zero, and where the work
/// lies is not known.
///
/// Throws  InputError "file:line: ..." for a value that is no number, is missing or makes no sense.
std::optional<MachineSettings> read_machine_settings(std::string_view text, const std::string& file_name);

/// Limits of the axes and, for what plans with one value, those of the slower of X and Y.
void set_axis_speeds(Machine& machine, const AxisValues& mm_per_min);
void set_axis_accelerations(Machine& machine, const AxisValues& mm_per_s2);

}  // namespace clearcut::read
