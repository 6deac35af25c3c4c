// The sequences of tools of several kinds of parts as one sequence with few changes of tools.
#pragma once

#include <cstddef>
#include <vector>

namespace clearcut::pipeline {

/// One stay of a tool in the spindle.
struct SharedRun {
  int tool = 0;
  struct Share {
    std::size_t kind = 0;
    std::size_t run = 0;  ///< which one of the kind's own sequence
  };
  std::vector<Share> shares;  ///< of the kinds that the tool works on meanwhile, in their order
};

/// A common supersequence of the sequences of all kinds: each kind's own order of tools is kept. `tools`: for each kind the numbers of
/// its tools in the order of its work, none twice in a row. Each run comes as late as that sequence lets it: what cuts a part out comes last.
///
/// Bound   The shortest there is as long as no more than kMostStates states are reached with one number of changes (always with two
///         kinds of fewer runs than that); of more states those that are furthest are followed.
/// Cost    O(runs * kMostStates * kinds) at most.
std::vector<SharedRun> merged_runs(const std::vector<std::vector<int>>& tools);

inline constexpr std::size_t kMostStates = 4096;

}  // namespace clearcut::pipeline
