// What is to be made, Part with its features, tools and operations, and the files that describe it.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clearcut/geometry.h"
#include "model/dialect.h"
#include "model/library.h"
#include "model/machine.h"
#include "model/part.h"
#include "model/setup_place.h"
#include "model/tool.h"
#include "options/job_file.h"
#include "options/read_options.h"

namespace clearcut {

// Parts: STEP-NC, STEP solids, DXF, SVG, outlines, jobs.

/// .p21 .stp .step .stpnc .238 (STEP-NC or a solid, by its schema), .dxf, .svg, .json (outline), .edges
/// (lengths and angles), .toml (job); files of other names by their first bytes. See docs/input.md.
Part read_part(const std::filesystem::path& file, const ReadOptions& options);

/// The part of one set-up (from 1) of such a program, in the axes of this set-up with the workpiece's origin as zero.
/// `place`: transform from the coordinates of the workpiece. Throws as read_part(), and if the set-up does not exist.
Part read_part_of_setup(const std::filesystem::path& file, int number, const ReadOptions& options,
                        SetupPlace& place);

/// The same as read_part() for text already read; `file_name` gives the extension and the name in messages. Other
/// files named in job files are searched beside `file_name`.
Part read_part_text(std::string_view text, const std::string& file_name, const ReadOptions& options);

/// Meaning of "pocket", "PROFILE_D6", ... for outlines: their role, and a depth if stated. Throws InputError at
/// `place` for words without a role.
LayerRule rule_named(const std::string& kind, const std::string& place);

/// "KIND:SELECTION", as in "profile:outer", "drill_d6:HOLES", "inside:2,5". Throws InputError at `place`.
LayerRule rule_of_option(const std::string& text, const std::string& place);

/// The number of set-ups of a STEP-NC program if there are several; 0 for all other files, and for unreadable ones.
int setups_of_program(const std::filesystem::path& file);

// Jobs: a part with its stock, tools, machine and wishes.

/// Whether the name is that of a project file.
bool is_project_name(const std::string& path);

/// A commented job for `part`, read from `part_file`: valid without changes, with every key and its default; `stated`
/// options are written as keys, so that a plan of the job equals the plan with those options.
std::string job_text(const Part& part, const std::string& part_file, const StatedOptions& stated = {});

/// "corner", "centre", or "X,Y,Z" in mm or with units. Throws InputError at `place`.
ZeroPoint parse_zero_point(const std::string& text, const std::string& place = "--origin");

/// The part of a job: its file read, stock and tools set, operations chosen. All of job.plan is in the operations
/// afterwards, with their places as sources; machine, output and the planner's values are left to the caller. `over`:
/// options with precedence over the job's own (command line). Throws as read_part and read_tool_library, and if a
/// tool number or a feature name has no match.
Part part_of_job(const JobFile& job, const ReadOptions& over);

/// The same; afterwards `sources` contains the sources of all values stated by the job or its tool library,
/// `published` the job's choices of published methods.
Part part_of_job(const JobFile& job, const ReadOptions& over, StepSources& sources, StepChoices& published);

/// The part of one set-up (from 1) of a job, as from part_of_job, with the zero requested by the set-up. `place`:
/// transform from the coordinates of the block to those of the set-up, for all set-ups of the job alike. The block is
/// that of the first set-up; in later ones it is turned as stated. Throws InputError as part_of_job, and if the block
/// of a later set-up has another size.
Part part_of_setup(const JobFile& job, int number, const ReadOptions& over, SetupPlace& place,
                   StepSources& sources, StepChoices& published);
JobFile read_job(const std::filesystem::path& file);

/// Throws  InputError "file:line: ..." for bad TOML, unknown keys (with the nearest known one) and
///         impossible values.
JobFile read_job_text(std::string_view text, const std::string& file_name);

/// Throws InputError where it is none, names an option that is none, or a part that it does not hold.
ProjectFile read_project(const std::string& path);

/// The job's own tools, then the used ones of its library: the tools of its part, in their order.
std::vector<LibraryTool> tools_of_job(const JobFile& job);

/// Subtracts `zero` from all places of the part: outlines, depths, stock, clamps, holes, the height of rapids.
Part with_zero_at(Part part, const std::array<double, 3>& zero);

/// The zero in the coordinates of the part, mm: the corner with the lowest x and y, or the middle, at the top of its
/// block; of its outlines if no block is stated.
std::array<double, 3> zero_of(const Part& part, const ZeroPoint& zero);

/// The workplans of an AP238 file with what they are made of, in order, one line an element; nothing where it is none.
std::vector<std::string> ap238_lines(std::string_view text, const std::string& file_name);

// Tools and machines.

/// Fills unstated values with the usual ones of one of machine_kinds(): speeds, power, greatest feed, permitted
/// force, and chip load. docs/feeds.md lists them.
void fill_machine_kind(Machine& machine, const std::string& kind);

/// The machine of this name; unpublished values are those of the default machine.
std::optional<Machine> library_machine(std::string_view name);

/// "router", "industrial-router", "mill".
std::vector<std::string> machine_kinds();

/// In the order of their names.
const std::vector<LibraryMachine>& machine_library();

/// The places of the keys of a machine file.
Sources machine_sources(const std::filesystem::path& file);

/// The tool's preset of this name (* for anything, any case), or its first; null if it has none.
const CuttingPreset* preset_of(const LibraryTool& tool, const std::string& name);

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

/// FreeCAD .fctb (one tool) and .fctl (a library, its tools beside it or in ../Bit), LinuxCNC .tbl, Fusion
/// .json, and our .toml ([[tool]]; see docs/input.md), by extension.
ToolLibrary read_tool_library(const std::filesystem::path& file, const ToolOptions& options);

/// The same for text already read. A .fctl has its tools searched beside `file_name`.
ToolLibrary read_tool_library_text(std::string_view text, const std::string& file_name,
                                   const ToolOptions& options);

// Parts as text again.

/// One pocket for every region of every feature, in order of the workplan, with kind, tops, depths and
/// slopes, and the stock. Tools and operations have no place in this format. Numbers are written so that they read
/// back equal (bulges lose at most the last digits). mm.
std::string write_outline_json(const Part& part);

/// ISO 14649-10/-11 entities in an ISO 10303-21 file: project, workplan in order, set-up with security plane and stock block, features,
/// tools, cutting data. Numbers read back to the same double. A feature of several regions becomes several features.
/// Throws InputError if a number is not finite, a workingstep has no tool, or a feature is a line to follow.
std::string write_stepnc(const Part& part);

/// The same with the toolpath of every workingstep: EXPLICIT_STRATEGY and a TOOLPATH_LIST, usable by readers
/// unchanged. The workingsteps are in the order of `toolpath`, followed by those it does not cut; a feature of
/// several regions is a compound. `toolpath`: planned for `part`, with workingsteps named by its sections; taken
/// before printing, so that printing it again gives the same digits.
std::string write_stepnc(const Part& part, const Toolpath& toolpath);

/// Options for the file, in the form used by readers. Throws InputError at "--op" for unknown operations.
ReadOptions read_options_of(const InputOptions& input);

/// The values filled by a kind, by the names of their sources.
const std::vector<std::string>& limits_of_kinds();

/// Gives a number to each tool without one. Throws InputError if two tools have the same number.
void number_tools(std::vector<Tool>& tools);

/// A control as options name it: "linuxcnc", "grbl" and so on; nothing for other names.
std::optional<Dialect> dialect_named(std::string_view name);
std::string_view name_of(Dialect dialect);

}  // namespace clearcut
