// A way of the cutter that the input states move by move.
#pragma once

#include <optional>
#include <vector>

#include "model/move.h"

namespace clearcut::inline model {

/// Whose toolpaths a workingstep is cut by where its input states one.
enum class ToolpathSource { kFile, kOurs };

struct StatedMove {
  Edge path;  ///< in plan; z goes linearly. Vertical moves as those of Move
  double z_from = 0;
  double z_to = 0;
  MoveKind kind = MoveKind::kCut;
  std::optional<MmPerMin> feed = {};  ///< absent: that of the operation
  double dwell_s = 0;                 ///< the cutter stands for so long after it
};

/// Where a move does not begin at the end of the one before, the cutter is lifted between them.
struct StatedPath {
  /// Empty: the path of an earlier workingstep makes this one, too.
  std::vector<StatedMove> moves;
  bool is_explicit =
      false;             ///< the input asks for it by its strategy: it is used unless somebody says otherwise
  bool is_used = false;  ///< decided by resolve()
};

}  // namespace clearcut::inline model
