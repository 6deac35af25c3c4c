// One mistake is told once: faults with one cause become one, and what follows from a mistake is left out beside it.
#pragma once

#include <vector>

#include "model/part.h"
#include "model/results/findings.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// While faults are looked for: the cause of those of a stock that lacks material of the part. A wrong blank is one mistake, whatever
/// features it meets.
inline constexpr const char* kWrongStock = "stock that lacks material";

/// Faults of one kind and cause become one, the worst of them, whose sentence counts the others. A program that is 25.4 times as large or
/// as small as what is to be cut has a fault of the kind kUnits, from which all follow that the wrong size makes. Where a tool is not
/// known, what its work counts as not having cut follows from that. The sentence of a fault says how many follow from it. Afterwards
/// Fault::cause of those that follow names the kind that they follow from, and is "" for all others.
void fold_causes(const Part& part, const CheckedProgram& program, const VerifyOptions& options,
                 std::vector<Fault>& faults);

}  // namespace clearcut::verify
