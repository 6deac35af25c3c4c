// Areas filled by a line of constant width, as a bead of an extruder or by a laser: planned, written, and proven from the text.
#pragma once

#include <string>

#include "clearcut/plan.h"
#include "model/results/certificate_basis.h"
#include "model/results/laid_findings.h"
#include "options/infill_options.h"

namespace clearcut {

/// What a program lays over the part's areas. Throws InputError for what is no such program.
LaidFindings check_infill(const Part& part, const std::string& program, const std::string& file_name,
                          const InfillOptions& options);

/// Plans all areas of the part, whatever their depths, as one layer with a cutter of the line's width, lays what it would cut
/// (links are travelled), writes the program, reads it and checks it. Throws InputError for values that are not above 0, for parts
/// without an area (profiles, engravings and other lines have none), and where no strategy plans it.
InfillResult plan_infill(const Part& part, const InfillOptions& options);

/// Shape   JSON; docs/howto-infill.md lists its fields.
/// Units   in the names of the fields; numbers rounded to 1e-6.
std::string laid_certificate(const LaidFindings& findings, const LaidCertificateInfo& info);

/// The same for people: some lines, the last "verdict: CLEAN" or "verdict: FAULTY".
std::string laid_table(const LaidFindings& findings);

}  // namespace clearcut
