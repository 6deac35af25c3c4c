// Turns measurements into faults, each with a sentence. No part of the tool may enter clamps and other obstacles
// beside the work. Feeds and speeds may not be beyond any cutter's limits in any material. Holes have their required
// shapes, by the moves of their tools, and the state of the control meanwhile. Each mistake is reported once: faults
// with one cause become one, and consequences of a mistake are not listed beside it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/control.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "verify/coverage/feature_work.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// A fault of one move; its sentence names the place and the workingstep.
Fault fault_of(const Part& part, FaultKind kind, const CheckedMove& checked, const Place& place, double size,
               const std::string& what);

/// Faults of single moves: gouges, rapids in material, plunges, too deep passes, travel, missing
/// feeds and tools, and wrong states of the control. Successive moves with the same fault give one fault, at
/// the worst of them.
std::vector<Fault> faults_of_moves(const Part& part, const CheckedProgram& program,
                                   const VerifyOptions& options);

/// Conditions from moves: actions left to the operator, and implausible feeds and speeds.
std::vector<Condition> conditions_of_moves(const CheckedProgram& program, const VerifyOptions& options);

/// For walls with draft, the level with the most material left; the floor otherwise.
const LevelCoverage& worst_level(const FeatureWork& work);

/// Whether the layers leave more on a wall with draft than permitted.
bool leaves_steps(const FeatureWork& work, const Scallop& scallop, const Tolerances& tol);

/// Material left in a feature, a wholly uncut feature, or too high steps on a wall with draft.
std::vector<Fault> faults_of_work(const Feature& feature, const FeatureWork& work, const Tolerances& tol);

/// Sorts by severity, then by size.
void sort_worst_first(std::vector<Fault>& faults);

/// ", which a stickout of 12.5 mm clears": of a holder whose tool goes down to `lowest`, mm, over something that ends at `top`.
std::string stickout_that_clears(double top, double lowest);

/// The first of the part's keep-outs entered by the cutter, its shank or its holder, feeding or at the rapid; the
/// fault's size is the depth of intrusion, seen from above, mm.
/// `lowest`: lowest height of the tip of this tool in the whole program, mm.
std::optional<Fault> keep_out_fault(const Part& part, const CheckedMove& checked, double lowest);

/// During the search for faults: the cause of faults due to a stock that lacks material of the part or ends above the
/// cuts. A wrong blank is one mistake, for any number of features.
inline constexpr const char* kWrongStock = "wrong stock";

/// Faults of one kind and cause become one, the worst of them, with the number of the others in its sentence. A
/// program 25.4 times as large or as small as the work has a fault of the kind kUnits, the cause of all faults due to
/// the wrong size. An unknown tool is the cause of the faults about material that its work does not count as having
/// cut. If no rapid would touch a smaller stock, of which the program cuts most of what it cuts of the stated one, the
/// stock is the cause of the faults of rapids. The sentence of a fault states the number of faults caused by it. Afterwards Fault::cause of the caused
/// faults names the kind of their cause, and is "" for all others.
void fold_causes(const Part& part, const CheckedProgram& program, const VerifyOptions& options,
                 std::vector<Fault>& faults);

/// At most one of each: `chip-load`, if a tooth takes more than any tooth can, or so little that it only rubs;
/// `cutting-speed`, if an edge runs faster than any usual speed. Each names the worst cutting move. For taps, whose
/// feed follows their pitch, only the stated speed is checked. `stated-feed` and `stated-speed` if a tool runs at
/// more than 1.5 times the stated value (options.stated), or at less than half of the stated speed. With
/// options.speed_may_be_power an S word up to 255 is not taken as a spindle speed.
///
/// Source  of the bounds: docs/verification.md, "Feeds and speeds".
std::vector<Condition> doubtful_cutting_data(const CheckedProgram& program, const VerifyOptions& options);

/// Checks every hole requiring more than a cylinder:
///
/// Drilled      The full diameter reaches down to the hole's depth; the drill's point does not count.
/// Spots, countersinks  The cone is wide enough at the top.
/// Taps         Place, size, hand and depth of the tap, feed = pitch * speed, and reversal for the retract.
/// Threads      See threads.h.
///
/// Cuts too deep or too wide are gouges (see shaped_cutter.h). Cost O(holes * moves near them).
std::vector<Fault> faults_of_holes(const Part& part, const CheckedProgram& program,
                                   const VerifyOptions& options);

/// `stated-peck` if a drill goes deeper at once than the pecks that are stated for its hole or operation, at the first
/// such place.
std::optional<Condition> stated_pecks_exceeded(const Part& part, const CheckedProgram& program);

/// `stated-dwell` if a tool waits less at the bottom of a hole than its operation states, at the first such hole.
std::optional<Condition> stated_dwell_missing(const Part& part, const CheckedProgram& program);

}  // namespace clearcut::verify
