// Common machines, with values stated by their makers and controls, and machines from the settings of their own
// control: a Grbl `$$` dump, a LinuxCNC .ini, a Marlin M503.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/library.h"
#include "model/machine.h"

namespace clearcut::read {

/// A machine, and the line in its file of each value; keys are written like options ("max-spindle").
struct MachineSettings {
  Machine machine;
  std::vector<std::pair<std::string, int>> lines;
};

/// Nothing if the text is of none of these kinds. Settings other than speeds, accelerations, corners and the spindle
/// are not used: the travel ($130 to $132, MIN_LIMIT, MAX_LIMIT) counts from the machine's zero, and the place of the
/// work is not known.
///
/// Throws  InputError "file:line: ..." for a non-numeric, missing or implausible value.
std::optional<MachineSettings> read_machine_settings(std::string_view text, const std::string& file_name);

/// Limits of the axes and, for planners with one value, those of the slower of X and Y.
void set_axis_speeds(Machine& machine, const AxisValues& mm_per_min);
void set_axis_accelerations(Machine& machine, const AxisValues& mm_per_s2);

/// In the order of their names.
const std::vector<LibraryMachine>& machine_library();

/// The machine of this name; unpublished values are those of the default machine.
std::optional<Machine> library_machine(std::string_view name);

}  // namespace clearcut::read
