// What checks of programs give: findings, figures of single moves, feeds that follow the load, the rest of a stopped program.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/control.h"
#include "model/dialect.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/copies_made.h"
#include "model/results/findings.h"
#include "model/results/margin.h"

namespace clearcut::inline model {

/// A program as the control reads it with D words at one end of the range of wear, and its part with cutters as much off their size.
struct WornCuts {
  Part part;
  Toolpath toolpath;
};

/// Checks any program text against a part. `tools` replace the part's, as in PlanOptions.
struct CheckResult {
  Part part;
  Toolpath toolpath;
  Findings findings;
  Dialect dialect = Dialect::kLinuxCnc;  ///< dialect in which the program was read
  ControlTable control;                  ///< state of the control at each move of `toolpath`
  std::optional<Toolpath> earlier;       ///< earlier cuts
  std::optional<Margin> margin;          ///< absent: not asked
  std::optional<CopiesMade> copies;      ///< absent: one part
  std::vector<WornCuts> worn;  ///< both ends of the range of wear; empty: the control compensates for none
};

struct MoveFigures {
  double time_s = 0;               ///< kinematic, with the waits before the move
  double max_engagement_deg = 0;   ///< 0 without a cut, and for entries
  double mean_engagement_deg = 0;  ///< over the length in contact
  double cutting_mm = 0;           ///< length in contact with material
  double air_mm = 0;               ///< length below the stock's top without contact
};

struct ProgramFeeds {
  std::string program;                        ///< with other F words
  CheckResult before;                         ///< check of the original program
  CheckResult after;                          ///< check of `program`, read back
  int words_before = 0, words_after = 0;      ///< F words
  std::map<int, MmPerMin> reference_feeds{};  ///< meant at the reference, by tool
};

struct ResumedProgram {
  std::string program;
  int line = 0;          ///< of the program as it was, with which it goes on
  int new_lines = 0;     ///< in front of that line
  int passes = 1;        ///< moves that pass the place; the first is taken
  double beside_mm = 0;  ///< how far the place lies beside the path
  Place begin;           ///< where the old text goes on
  int tool = 0;          ///< with which it does
  CheckResult before;    ///< of the program as it was
  CheckResult after;     ///< of `program`, with what was cut before `line` taken away
};

}  // namespace clearcut::inline model
