// Options for writing a program for its controller, the work offset, and the end position after all cuts.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/vec2.h"
#include "model/dialect.h"

namespace clearcut::inline model {

struct EndPosition {
  enum class Kind : unsigned char {
    kUsual,  ///< as the control is used: Z to its home on Fanuc and Haas, the safe height on others
    kHome,   ///< Z to its home, then X and Y
    kPlace,  ///< `place` at the safe height, then as usual
    kStay    ///< the safe height over the last cut
  };
  Kind kind = Kind::kUsual;
  Vec2 place{};  ///< kPlace: mm, from the program's zero
  friend bool operator==(const EndPosition&, const EndPosition&) = default;
};

/// "home", "none", or "X,Y" in mm; nothing for other texts.
std::optional<EndPosition> end_position_named(std::string_view text);
/// "home", "none", "10,20"; "" for the usual one.
std::string name_of(const EndPosition& end);

struct WorkOffset {
  int code = 540;  ///< G word in tenths
  int number = 0;  ///< P word, with G15 H word, from 1; 0: the word has none
  friend bool operator==(const WorkOffset&, const WorkOffset&) = default;
};

/// Codes of Sinumerik's settable offsets beyond G54 to G57: G505 to G599.
inline constexpr int kFirstSettable = 5050, kLastSettable = 5990;

/// Code of Okuma's offsets, G15 H.
inline constexpr int kOkumaOffset = 150;

/// Words in a program: "G55", "G59.1", "G54.1 P12", "G15 H2".
std::string words_of(const WorkOffset& offset);
/// Name of the condition that this offset is at the work's zero: "g55", "g59.1", "g54.1-p12", "g15-h2".
std::string condition_of(const WorkOffset& offset);

/// G54 to G59.3, G505 to G599, G54.1 P, G59 P, G154 P and G15 H, in any case, with or without blanks; nothing for other
/// texts.
std::optional<WorkOffset> work_offset_named(std::string_view text);
/// For messages: the words of all known offsets.
inline constexpr std::string_view kKnownWorkOffsets =
    "G54 to G59, G59.1 to G59.3, G54.1 P1 to P300, G154 P1 to P99, G59 P7 to P254, G505 to G599, "
    "G15 H1 to H200";

/// Paths of the tool's centre that the control shifts by what a D word holds, 0 with a new tool.
struct WearCompensation {
  std::vector<int> workingsteps;  ///< whose passes are shifted
  double range = 0;               ///< mm that D may hold either way

  bool shifts(int workingstep) const {
    return std::find(workingsteps.begin(), workingsteps.end(), workingstep) != workingsteps.end();
  }
};

struct PostOptions {
  std::string dialect = "linuxcnc";  ///< one of kControllers
  bool inch = false;
  std::string program_name;         ///< "1234" or "O1234" gives Fanuc and Haas their program number
  std::vector<std::string> header;  ///< comment lines: part, stock, tools, times, certificate summary
  std::optional<int> decimals;      ///< 1 to 6; default per dialect and unit
  bool arcs = true;                 ///< false: lines only, within tol.chord
  bool tool_changer = true;         ///< false: a pause (M0) instead of M6
  bool length_offset = true;        ///< false: no G43
  bool exact_stop = false;          ///< G61 instead of blending, if the control supports G61
  /// mm; the most by which the program may let the control round corners (G64 P, G187 E, cycle 32, CTOL); absent: half
  /// of the gouge tolerance.
  std::optional<double> corner_tolerance;
  /// mm; the same of each section of the toolpath, as it was proven. Empty: `corner_tolerance` for all.
  std::vector<double> corner_tolerances;
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

  /// mm; rounding of corners that never costs more than half of the gouge tolerance.
  double least_corner_tolerance() const {
    return std::min(tol.gouge / 2, corner_tolerance.value_or(tol.gouge / 2));
  }
  /// mm; rounding of corners in section number `index` of the toolpath.
  double corner_tolerance_of(std::size_t index) const {
    if (index < corner_tolerances.size()) return corner_tolerances[index];
    return corner_tolerance.value_or(tol.gouge / 2);
  }
};

}  // namespace clearcut::inline model
