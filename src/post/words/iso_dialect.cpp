#include "post/words/iso_dialect.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

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
               .subprograms = SubprogramForm::kOWords,
               .end = "M2"},
    // 32-bit numbers; M6 and G43 are errors, M1 does nothing; no wait of its own for the spindle.
    IsoDialect{.name = "grbl",
               .line_length = 79,
               .packed_length = 50,
               .exact_stop = {},
               .changer = false,
               .spindle_wait = 2,
               .radius = RadiusWord::kNone,
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
               .dogleg_rapids = true,
               .subprograms = SubprogramForm::kPrograms},
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
               .dogleg_rapids = true,
               .subprograms = SubprogramForm::kBlocks},
    IsoDialect{.name = "mach3",
               .extension = ".tap",
               .numbered_offsets = {{{590, 7, 254}}},
               .path_control = PathControl::kExactStop,
               .length_offset = LengthOffset::kNumbered,
               .spindle_wait = 2,
               .tapping = Tapping::kFloating,
               .cycles = CycleForm::kWords,
               .subprograms = SubprogramForm::kPrograms},
    IsoDialect{.name = "mach4",
               .extension = ".tap",
               .numbered_offsets = {{{541, 1, 248}}},
               .path_control = PathControl::kExactStop,
               .length_offset = LengthOffset::kNumbered,
               .spindle_wait = 2,
               .tapping = Tapping::kFloating,
               .cycles = CycleForm::kWords,
               .subprograms = SubprogramForm::kPrograms},
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
               .radius = RadiusWord::kNone,
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
               .cycles = CycleForm::kCalls,
               .radius = RadiusWord::kOfEdge,
               .subprograms = SubprogramForm::kRepeats},
    // Mazak's EIA/ISO: rigid tapping is a word of its own there (G84.2), which is not written; the magazine is called ahead.
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
               .modal_cycles = true,
               .subprograms = SubprogramForm::kOWords},
    // Okuma's OSP: G20 and G21 confirm the unit that is set; G54 to G59 are lengths of tools there. Its cycles return to a level
    // of their own (G71, M53) and G80 may stop the spindle, so that holes are moves.
    IsoDialect{.name = "okuma",
               .extension = ".min",
               .mm_decimals = 3,
               .inch_decimals = 4,
               .always_point = true,
               .tape = true,
               .program_digits = 4,
               .safe_start = "G17 G40 G80 G90 G94",
               .first_offset = {kOkumaOffset, 1},
               .numbered_offsets = {{{kOkumaOffset, 1, 200}}},
               .path_control = PathControl::kExactStop,
               .exact_stop_halts = true,
               .length_offset = LengthOffset::kNumbered,
               .length_word = "G56",
               .home = HomeForm::kHomePosition,
               .dwell = DwellForm::kFSeconds,
               .radius = RadiusWord::kUnwritten,
               .entered_at_tools = true,
               .numbers_tools = true,
               .preselects = true,
               .dogleg_rapids = true,
               .end = "M2",
               .largest_radius = 1000},
    // grblHAL: Grbl's numbers, with M6, cycles and more work offsets. G43 needs a build with a table of tools, and the change of a tool
    // by hand measures its length: none is written.
    IsoDialect{.name = "grblhal",
               .line_length = 255,
               .named_in_header = true,
               .fractional_offsets = true,
               .exact_stop = {},
               .spindle_wait = 2,
               .cycles = CycleForm::kWords,
               .radius = RadiusWord::kNone,
               .modal_cycles = true,
               .largest_radius = 1000},
};

/// Klartext has a writer of its own.
constexpr bool has_every_controller() {
  return std::all_of(std::begin(kControllers), std::end(kControllers), [](std::string_view name) {
    return name == "heidenhain" || std::any_of(kDialects.begin(), kDialects.end(),
                                               [&](const IsoDialect& row) { return row.name == name; });
  });
}
static_assert(has_every_controller(),
              "each of kControllers has its row here; see docs/adding-a-controller.md");

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

std::vector<std::string_view> coolant_words(Coolant held, Coolant wanted, const MistWords& mist) {
  std::vector<std::string_view> words;
  bool flood = has_flood(held), fog = has_mist(held);
  if (fog && !has_mist(wanted) && !mist.off.empty()) {
    words.push_back(mist.off);
    fog = false;
  }
  if ((flood && !has_flood(wanted)) || (fog && !has_mist(wanted))) {
    words.push_back("M9");
    flood = false;
    fog = fog && !mist.off.empty();
  }
  if (has_flood(wanted) && !flood) words.push_back("M8");
  if (has_mist(wanted) && !fog) words.push_back(mist.on);
  return words;
}

namespace {

bool has_plain_offsets(const IsoDialect& dialect) {
  return dialect.safe_start.find("G54") != std::string_view::npos;
}

}  // namespace

bool has_work_offset(const IsoDialect& dialect, const WorkOffset& offset) {
  if (offset.number == 0) {
    if (!has_plain_offsets(dialect)) return false;
    if (offset.code >= kFirstSettable) return dialect.settable_offsets;
    return offset.code % 10 == 0 ? offset.code <= dialect.last_offset : dialect.fractional_offsets;
  }
  const auto& numbered = dialect.numbered_offsets;
  return std::any_of(numbered.begin(), numbered.end(), [&](const NumberedOffsets& one) {
    return one.code == offset.code && one.first <= offset.number && offset.number <= one.last;
  });
}

std::string work_offsets_of(const IsoDialect& dialect) {
  std::string text;
  const auto add = [&](const std::string& first, const std::string& last) {
    text.append(text.empty() ? "" : ", ").append(first).append(" to ").append(last);
  };
  if (has_plain_offsets(dialect)) add("G54", words_of({dialect.last_offset, 0}));
  if (dialect.fractional_offsets) add("G59.1", "G59.3");
  if (dialect.settable_offsets) add(words_of({kFirstSettable, 0}), words_of({kLastSettable, 0}));
  for (const NumberedOffsets& one : dialect.numbered_offsets) {
    if (one.last == 0) continue;
    const std::string last = words_of({one.code, one.last});
    add(words_of({one.code, one.first}), last.substr(last.find(' ') + 1));
  }
  return text;
}

std::vector<std::string> mode_blocks(const IsoDialect& dialect, const WorkOffset& asked) {
  const WorkOffset offset = asked == WorkOffset{} ? dialect.first_offset : asked;
  const std::string_view first = "G54 ";
  std::string words(dialect.safe_start);
  const bool numbered = offset.number > 0;
  if (const std::size_t at = words.find(first); at != std::string::npos)
    words.replace(at, first.size(), numbered ? "" : words_of(offset) + " ");
  if (!numbered) return {words};
  return {words, words_of(offset)};
}

std::vector<std::string> later_mode_blocks(const IsoDialect& dialect, const WorkOffset& offset) {
  const std::string_view no_length = "G49 ";
  std::vector<std::string> blocks = mode_blocks(dialect, offset);
  if (const std::size_t at = blocks.front().find(no_length); at != std::string::npos)
    blocks.front().erase(at, no_length.size());
  return blocks;
}

std::vector<std::string> home_blocks(const IsoDialect& dialect) {
  const std::string zero = dialect.always_point ? "0." : "0";
  if (dialect.home == HomeForm::kSuppressed) return {"SUPA G0 Z0 D0", "SUPA G0 X0 Y0 D0"};
  if (dialect.home == HomeForm::kHomePosition) return {"G30 P1"};
  if (dialect.home == HomeForm::kMachineZero) return {"G53 G0 Z" + zero, "G53 G0 X" + zero + " Y" + zero};
  return {"G91 G28 Z" + zero, "G28 X" + zero + " Y" + zero, "G90"};
}

}  // namespace clearcut::post
