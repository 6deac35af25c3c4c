// Each mistake is reported once: faults with one cause become one, and consequences of a mistake are not listed
// beside it.
#pragma once

#include <vector>

#include "model/part.h"
#include "model/results/findings.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// During the search for faults: the cause of faults due to a stock lacking material of the part. A wrong blank is
/// one mistake, for any number of features.
inline constexpr const char* kWrongStock = "stock that lacks material";

/// Faults of one kind and cause become one, the worst of them, with the number of the others in its sentence. A
/// program 25.4 times as large or as small as the work has a fault of the kind kUnits, the cause of all faults due to
/// the wrong size. An unknown tool is the cause of the faults about material that its work does not count as having
/// cut. The sentence of a fault states the number of faults caused by it. Afterwards Fault::cause of the caused
/// faults names the kind of their cause, and is "" for all others.
void fold_causes(const Part& part, const CheckedProgram& program, const VerifyOptions& options,
                 std::vector<Fault>& faults);

}  // namespace clearcut::verify
