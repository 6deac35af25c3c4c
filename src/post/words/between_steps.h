// Program text between cuts: stops, messages, dwells at the floors of holes, and the height for free travel.
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::post {

/// The stops of workingsteps, each before the first section of its step.
class Stops {
 public:
  explicit Stops(const Part& part) : part_(part) {}

  /// Stops before `section`, with those of earlier workingsteps without cuts; none the second time.
  std::vector<ProgramStop> before(const Section& section);

 private:
  const Part& part_;
  std::set<int> said_;
};

/// Whether the program halts at any of them: the tool is lifted and the spindle stands before.
bool halts(const std::vector<ProgramStop>& stops);
/// "STOP: TURN THE CLAMP", "OPTIONAL STOP", "MESSAGE: ...".
std::string stop_comment(const ProgramStop& stop);

/// Successive moves of a section, with the dwell after them.
struct MoveRun {
  std::vector<Move> moves;
  double dwell_s = 0;
};
/// The moves of the section, divided at dwells.
std::vector<MoveRun> runs_of(const Section& section);

/// Kind of cutting of a section, for a control's levels of smoothness.
enum class CutLevel { kRoughing = 1, kMedium = 2, kFinishing = 3 };
/// Roughing leaves stock, or a finishing step follows on the same feature.
CutLevel level_of(const Section& section, const Part& part);

/// Tools in the order of the program's changes.
std::vector<int> tool_changes_of(const Toolpath& toolpath);

/// For each section the subprogram that makes its moves, counted from 1 as they are first called; 0: the section is written where it stands.
/// Subprograms are those of `same_moves` (PostOptions::subprograms) that two or more sections share; `may_be` says whether one of these sections
/// can be written as such.
std::vector<int> shared_subprograms(const std::vector<int>& same_moves,
                                    const std::function<bool(std::size_t)>& may_be);

/// s; dwell at the floor of the section's hole; 0 for most.
double dwell_of(const Section& section, const Part& part);
/// Whether the move ends at the lowest place of the section, from above.
bool ends_at_floor(const Move& move, const Section& section);

/// Height for free travel of the tool: the highest z of the toolpath, and no lower than part.safe_z(). mm.
double safe_height(const Toolpath& toolpath, const Part& part);

}  // namespace clearcut::post
