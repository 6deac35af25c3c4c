// Writes a toolpath as a program for one controller.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/control.h"
#include "model/move.h"
#include "model/options/post_options.h"
#include "model/part.h"

namespace clearcut::post {

/// Names accepted as PostOptions::dialect.
const std::vector<std::string>& post_dialects();
/// Customary ending of a program's file name: ".ngc", ".nc", ".h", ".tap", ".gcode".
std::string file_extension_of(const std::string& dialect);

/// The default number in the O word of a program with this name; nothing if the control has no O word.
std::optional<int> program_number_of(const std::string& dialect, const std::string& program_name);

/// Words of the work offset that programs of the control have where this one is asked for: "G54", "G15 H1".
std::string work_offset_words(const std::string& dialect, const WorkOffset& offset);

/// Whether programs of the control say the places of holes alike behind one cycle.
bool repeats_cycles(const std::string& dialect);

/// Whether PostOptions::subprograms are written for the control: it has subprograms that stand in the program itself.
bool has_subprograms(const std::string& dialect);

/// Digits after the decimal point of lengths: those requested, else the controller's resolution.
int decimals_of(const PostOptions& options);
/// Largest distance in plan between a toolpath and the program written for it, mm: rounding to the printed
/// decimals. Arcs replaced by lines add tol.chord.
double rounding_of(const PostOptions& options);
/// The same only for straight lines: no arc's radius is rounded.
double rounding_of_lines(const PostOptions& options);
/// The same for heights, mm: half a step.
double rounding_of_heights(const PostOptions& options);

/// Permitted deviation of the control from the path: the least that programs with these options state.
clearcut::PathControl path_control_of(const PostOptions& options);

/// The program's text: LF line ends, ASCII. Same input, same bytes.
///
/// Shape   one OPERATION comment per section; sections are joined over the safe height.
/// Error   rounding_of(options); arcs are checked after rounding, from the previous printed point.
/// Throws  InputError for an unknown dialect, a number not finite or beyond 1 km, a feed move without feed.
/// Cost    linear.
std::string write_program(const Toolpath& toolpath, const Part& part, const PostOptions& options);

}  // namespace clearcut::post
