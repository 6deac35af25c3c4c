#include "post/words/iso_dialect.h"

#include <array>

namespace clearcut::post {

namespace {

constexpr std::array kDialects{
    IsoDialect{.name = "linuxcnc",
               .extension = ".ngc",
               .line_length = 255,
               .fractional_offsets = true,
               .path_control = PathControl::kTolerance,
               .length_offset = LengthOffset::kPlain,
               .tapping = Tapping::kRigidByG33_1,
               .cycles = CycleForm::kWords,
               .end = "M2"},
    // 32-bit numbers; M6 and G43 are errors, M1 does nothing; no wait of its own for the spindle.
    IsoDialect{.name = "grbl",
               .line_length = 79,
               .packed_length = 50,
               .exact_stop = {},
               .changer = false,
               .spindle_wait = 2,
               .optional_stop = false,
               .largest_radius = 1000},
    IsoDialect{.name = "fanuc",
               .mm_decimals = 3,
               .inch_decimals = 4,
               .always_point = true,
               .tape = true,
               .program_digits = 4,
               .safe_start = "G17 G40 G49 G54 G80 G90 G94",
               .numbered_offsets = {{{541, 1, 300}}},
               .path_control = PathControl::kExactStop,
               .exact_stop_halts = true,
               .length_offset = LengthOffset::kWithApproach,
               .home = HomeForm::kReference,
               .dwell = DwellForm::kXSeconds,
               .tapping = Tapping::kRigidByM29,
               .cycles = CycleForm::kWords,
               .entered_at_tools = true,
               .modal_cycles = true,
               .numbers_tools = true,
               .preselects = true,
               .table_forward = true,
               .dogleg_rapids = true},
    IsoDialect{.name = "haas",
               .mm_decimals = 3,
               .inch_decimals = 4,
               .always_point = true,
               .tape = true,
               .program_digits = 5,
               .safe_start = "G17 G40 G49 G54 G80 G90 G94",
               .numbered_offsets = {{{1540, 1, 99}, {541, 1, 99}}},
               .path_control = PathControl::kCornerRounding,
               .exact_stop_halts = true,
               .length_offset = LengthOffset::kWithApproach,
               .home = HomeForm::kMachineZero,
               .mist = {"M83", "M84"},
               .tapping = Tapping::kRigid,
               .cycles = CycleForm::kWords,
               .entered_at_tools = true,
               .modal_cycles = true,
               .numbers_tools = true,
               .preselects = true,
               .table_forward = true,
               .dogleg_rapids = true},
    IsoDialect{.name = "mach3",
               .extension = ".tap",
               .numbered_offsets = {{{590, 7, 254}}},
               .path_control = PathControl::kExactStop,
               .length_offset = LengthOffset::kNumbered,
               .spindle_wait = 2,
               .tapping = Tapping::kFloating,
               .cycles = CycleForm::kWords},
    IsoDialect{.name = "mach4",
               .extension = ".tap",
               .numbered_offsets = {{{541, 1, 248}}},
               .path_control = PathControl::kExactStop,
               .length_offset = LengthOffset::kNumbered,
               .spindle_wait = 2,
               .tapping = Tapping::kFloating,
               .cycles = CycleForm::kWords},
    // G21 and G17 only exist in some builds; M1 stops like M0; N words need checksums; M30 would delete a file on the
    // card.
    IsoDialect{.name = "marlin",
               .extension = ".gcode",
               .comments = CommentForm::kSemicolon,
               .metric = "",
               .safe_start = "G90",
               .exact_stop = {},
               .changer = false,
               .tool_word = false,
               .pause_says_tool = true,
               .home = HomeForm::kSwitches,
               .dwell = DwellForm::kSSeconds,
               .spindle_wait = 2,
               .rapid_feed = true,
               .repeats_motion = true,
               .optional_stop = false,
               .block_numbers = false,
               .end = "",
               .largest_radius = 1000},
    // Sinumerik 840D: G58 and G59 shift axes there; G0 is straight as the control is delivered; D1 holds from M6 on.
    IsoDialect{.name = "siemens",
               .extension = ".mpf",
               .mm_decimals = 3,
               .inch_decimals = 4,
               .comments = CommentForm::kSemicolon,
               .metric = "G710",
               .inches = "G700",
               .safe_start = "G17 G40 G54 G90 G94",
               .last_offset = 570,
               .settable_offsets = true,
               .path_control = PathControl::kContour,
               .exact_stop = "G60",
               .exact_stop_halts = true,
               .length_offset = LengthOffset::kEdge,
               .home = HomeForm::kSuppressed,
               .dwell = DwellForm::kFSeconds,
               .tapping = Tapping::kRigid,
               .cycles = CycleForm::kCalls},
    // Mazak's EIA/ISO: rigid tapping has a separate word there (G84.2), which is not written; the magazine is called
    // ahead.
    IsoDialect{.name = "mazak",
               .extension = ".eia",
               .mm_decimals = 3,
               .inch_decimals = 4,
               .always_point = true,
               .tape = true,
               .program_digits = 4,
               .safe_start = "G17 G40 G49 G54 G80 G90 G94",
               .numbered_offsets = {{{541, 1, 300}}},
               .path_control = PathControl::kExactStop,
               .exact_stop_halts = true,
               .length_offset = LengthOffset::kWithApproach,
               .home = HomeForm::kReference,
               .dwell = DwellForm::kXSeconds,
               .tapping = Tapping::kFloating,
               .cycles = CycleForm::kWords,
               .entered_at_tools = true,
               .modal_cycles = true,
               .numbers_tools = true,
               .preselects = true,
               .table_forward = true,
               .dogleg_rapids = true},
    // Tormach's PathPilot, on LinuxCNC's interpreter: lengths by number, taps in a floating holder.
    IsoDialect{.name = "tormach",
               .line_length = 255,
               .fractional_offsets = true,
               .path_control = PathControl::kTolerance,
               .length_offset = LengthOffset::kNumbered,
               .tapping = Tapping::kFloating,
               .cycles = CycleForm::kWords,
               .modal_cycles = true},
};

}  // namespace

const IsoDialect* iso_dialect_named(std::string_view name) {
  for (const IsoDialect& dialect : kDialects) {
    if (dialect.name == name) return &dialect;
  }
  return nullptr;
}

std::vector<std::string> iso_dialect_names() {
  std::vector<std::string> names;
  names.reserve(kDialects.size() + 1);
  for (const IsoDialect& dialect : kDialects) names.emplace_back(dialect.name);
  return names;
}

}  // namespace clearcut::post
