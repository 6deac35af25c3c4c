// Machine files: abilities of the machine.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/machine.h"
#include "model/options/origin.h"
#include "read/common/data_value.h"

namespace clearcut::read {

/// A file, or a name of machine_library(). Files are settings of a control (machine_library.h), or TOML with name,
/// rapid (mm/min), acceleration (mm/s2), each one number or [x, y, z], junction_deviation (mm), planner (grbl,
/// linuxcnc, marlin, mach, jerk-limited), jerk (mm/s3), speed_jump ([x, y, z], mm/s), arc_tolerance (mm), max_spindle
/// and min_spindle (rpm), spindle_power (W), spindle_torque (Nm), kind (one of machine_kinds()), cutting_force (N,
/// sideways), program_number (O word), max_feed (mm/min), spindle_wait (s), tool_change (s), path_tolerance (mm),
/// holding (means of holding loose parts: only its source counts), travel = {x = [low, high], y = ..., z = ...} (mm)
/// and places = {start, g28, g30, g54 ... g59 = [x, y, z]} (mm, the machine's own); all may be left out. Throws
/// InputError "file:line: ...".
Machine read_machine(const std::filesystem::path& file);
Machine read_machine_text(std::string_view text, const std::string& file_name);
/// "router", "industrial-router", "mill".
std::vector<std::string> machine_kinds();
/// Fills unstated values with the usual ones of one of machine_kinds(): speeds, power, greatest feed, permitted
/// force, and chip load. docs/feeds.md lists them.
void fill_machine_kind(Machine& machine, const std::string& kind);
/// The values filled by a kind, by the names of their sources.
const std::vector<std::string>& limits_of_kinds();
/// The same keys as a table of a job. `base` gives absent values.
Machine machine_of_section(DataSection section, Machine base);

/// Every key of a table, written as options are ("max-spindle"), with its place "file:line".
Sources key_sources(const DataValue& table, const std::string& file_name, Origin origin);
/// The places of the keys of a machine; the place of its name is also the source of "machine".
Sources machine_sources_of(const DataValue& table, const std::string& file_name, Origin origin);
/// The places of the keys of a machine file.
Sources machine_sources(const std::filesystem::path& file);

}  // namespace clearcut::read
