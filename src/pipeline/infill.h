// Areas filled by a line of constant width instead of being milled (Tour section 8.4.3): the strategies' passes laid as a bead of an
// extruder or burned by a laser, and the proof that they cover the area.
#pragma once

#include <optional>
#include <string>

#include "base/units.h"
#include "model/part.h"
#include "model/results/laid_findings.h"
#include "options/infill_options.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Plans all areas of the part, whatever their depths, as one layer with a cutter of the line's width, lays what it would cut
/// (links are travelled), writes the program, reads it and checks it. Throws InputError for values that are not above 0, for parts
/// without an area (profiles, engravings and other lines have none), and where no strategy plans it.
///
/// Source  Tour section 8.4.3, steps 4 to 6 of its list.
/// Cost    a plan and a proof of coverage for every strategy and stepover that is tried.
InfillResult plan_infill(const Part& part, const InfillOptions& options);

/// What a program lays over the part's areas. Throws InputError for what is no such program.
LaidFindings check_infill(const Part& part, const std::string& program, const std::string& file_name,
                          const InfillOptions& options);

}  // namespace clearcut::pipeline
