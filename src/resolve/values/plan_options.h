// Texts of options, and checks of their values.
#pragma once

#include <string>

#include "options/plan_options.h"

namespace clearcut::resolve {

/// The source of a value set in the options.
Source source_of(const PlanOptions& options, const std::string& name);

/// Number of threads given by the options: at least one, and no more than cores.
int thread_count(const PlanOptions& options);

/// "endmill:10[:T3][:flutes=2][:corner=0.5][:max_spindle=12000][:name=ROUGHER][:noplunge]", "tap:M6[:floating]".
/// Throws InputError.
Tool parse_tool(const std::string& text);

/// "X,Y:D": a hole of diameter D at (X, Y), mm. Throws InputError.
PredrilledHole parse_predrilled(const std::string& text);

/// "100,60,20": the block's size, from X 0 and Y 0 and down from `top`; or each of the three as LOW:HIGH,
/// "-5:95,0:60,-20:0". mm, or with units as lengths everywhere. Throws InputError.
Stock parse_stock(const std::string& text, double top = 0);

/// "-10:15,20:40,-20:12": the block of a clamp as ranges of x, y and z, mm or with units. Throws InputError.
KeepOut parse_keep_out(const std::string& text);

/// Adds clamps, and holes that exist before the work begins. Throws InputError.
void add_places(const std::vector<std::string>& keep_outs, const std::vector<std::string>& predrilled,
                PlanOptions& options);

/// Throws InputError at `place` if a holder, or a shank wider than its cutter, is only partly stated.
void check_holder(const Tool& tool, const std::string& place);

/// Throws InputError at `place` if settings of the published solver are given, but the other solver is chosen.
void check(const VisitSolver& solver, const std::string& place);

/// Checks that every option is in its sensible range; throws InputError naming the first option that is not.
void check(const PlanOptions& options);

}  // namespace clearcut::resolve
