// A path of the cutter stated move by move in the input.
#pragma once

#include <optional>
#include <vector>

#include "model/move.h"

namespace clearcut::inline model {

/// Source of a workingstep's toolpath if the input states one.
enum class ToolpathSource { kFile, kOurs };

struct StatedMove {
  Edge path;  ///< in plan; z changes linearly. Vertical moves as those of Move
  double z_from = 0;
  double z_to = 0;
  MoveKind kind = MoveKind::kCut;
  std::optional<MmPerMin> feed = {};  ///< absent: the feed of the operation
  double dwell_s = 0;                 ///< dwell after the move
};

/// If a move does not begin at the end of the previous one, the cutter is retracted between them.
struct StatedPath {
  /// Empty: the path of an earlier workingstep makes this one, too.
  std::vector<StatedMove> moves;
  /// The input requests this path by its strategy: it is used unless the user decides otherwise.
  bool is_explicit = false;
  bool is_used = false;  ///< decided by resolve()
};

}  // namespace clearcut::inline model
