// Options for writing a program for its controller.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "base/units.h"
#include "model/options/end_position.h"
#include "model/options/work_offset.h"

namespace clearcut::inline model {

/// Paths of the tool's centre that the control shifts by what a D word holds, 0 with a new tool.
struct WearCompensation {
  std::vector<int> workingsteps;  ///< whose passes are shifted
  double range = 0;               ///< mm that D may hold either way
};

struct PostOptions {
  std::string dialect = "linuxcnc";  ///< linuxcnc grbl fanuc haas heidenhain mach3 mach4 marlin
  bool inch = false;
  std::string program_name;         ///< "1234" or "O1234" gives Fanuc and Haas their program number
  std::vector<std::string> header;  ///< comment lines: part, stock, tools, times, certificate summary
  std::optional<int> decimals;      ///< 1 to 6; default per dialect and unit
  bool arcs = true;                 ///< false: lines only, within tol.chord
  bool tool_changer = true;         ///< false: a pause (M0) instead of M6
  bool length_offset = true;        ///< false: no G43
  bool exact_stop = false;          ///< G61 instead of blending, if the control supports G61
  /// If the control states no bound: no G61; the control rounds corners by its own setting.
  bool continuous = false;
  std::optional<int> program_number;  ///< number of the O word, with precedence over one in program_name
  int programs_before = 0;            ///< number of earlier programs of the same job, added to the O word
  WorkOffset work_offset;             ///< work offset of the part's zero
  EndPosition end;
  std::optional<WearCompensation> wear;
  /// Of each section of the toolpath: sections of one number above 0 make the same moves at other places, which are written once, as a
  /// subprogram; 0: the section is written where it stands. Empty: all are.
  std::vector<int> subprograms;
  bool block_numbers = false;           ///< N words, in tens
  bool optional_stop = false;           ///< M1 before every tool but the first
  std::optional<Seconds> spindle_wait;  ///< wait after the spindle starts; default per dialect
  MmPerMin rapid = MmPerMin::of(3000);  ///< for controls whose G0 takes an F word (Marlin)
  Tolerances tol;
};

}  // namespace clearcut::inline model
