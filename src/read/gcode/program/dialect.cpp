#include "read/gcode/program/dialect.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "base/error.h"
#include "model/options/post_options.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

namespace {

// Grbl 1.1: the only words of its groups.
constexpr int kGrblWords[] = {0,   10,  20,  30,  40,  100, 170, 180, 190, 200, 210, 280, 281,
                              300, 301, 382, 383, 384, 385, 400, 431, 490, 530, 540, 550, 560,
                              570, 580, 590, 610, 800, 900, 910, 911, 920, 921, 930, 940};

// grblHAL: "Supported G-Codes" of its README. G50 and G51 scale about the zero, as Mach's do. Splines (G5) and words of
// lathes are left out.
constexpr int kGrblHalWords[] = {0,   10,  20,  30,  40,  100, 170, 180, 190, 200, 210, 280, 281, 300,
                                 301, 382, 383, 384, 385, 400, 430, 431, 432, 490, 500, 510, 530, 540,
                                 550, 560, 570, 580, 590, 591, 592, 593, 610, 730, 800, 810, 820, 830,
                                 850, 860, 890, 900, 910, 911, 920, 921, 922, 923, 930, 940, 980, 990};
constexpr int kGrblHalMiscellaneous[] = {0,   10,  20,  30,  40,  50,  60,  70,  80,  90,  300,
                                         480, 490, 500, 510, 530, 600, 610, 620, 630, 640, 650};

constexpr int kGrblMiscellaneous[] = {0, 10, 20, 30, 40, 50, 70, 80, 90, 300, 560, 990};

// Exact stop once, and the ends of modes that LinuxCNC does not have: it stops there.
constexpr int kMissingOnLinuxCnc[] = {90, 150, 500, 510, 690};

// LinuxCNC, "M-Codes" of its manual.
constexpr int kLinuxCncMiscellaneous[] = {0,   10,  20,  30,  40,  50,  60,  70,  80,  90,  190,
                                          300, 480, 490, 500, 510, 520, 530, 600, 610, 620, 630,
                                          640, 650, 660, 670, 680, 700, 710, 720, 730, 980, 990};
constexpr int kFirstOfUser = 1000, kLastOfUser = 1990;

// M13 and M14 turn the spindle and switch the coolant on where a builder gives them that sense; M48 tests the probe on Marlin.
constexpr int kSpindleAndFlood[] = {130, 140};
constexpr int kMissingOnMarlin[] = {130, 140, 480};

// Words of others that OSP has not, or that do something else there: look-ahead, G12 and G13, scaling, shifts, arcs about centers said
// from the zero, inverse time, return levels.
constexpr int kMissingOnOsp[] = {80,  120, 130, 500, 510, 520, 690, 901,
                                 911, 921, 922, 923, 930, 970, 980, 990};

/// NIST's interpreter and its descendants: LinuxCNC, Mach, PathPilot.
constexpr CompensationRules kOfInterpreter{.entry = EntryRule::kAcrossEntry,
                                           .tangent = 0.05,
                                           .begins_in_plan = true,
                                           .looks_at_all = false,
                                           .exit_takes_height = true,
                                           .most_still = 1000};
constexpr CompensationRules kOfFanuc{
    .outside = OutsideCorner::kLines,
    .outside_needs =
        "the control joins outside corners of a compensated contour by lines and begins by type A, as it "
        "is delivered (parameters 5003 and 19607)"};
constexpr CompensationRules kOfHaas{
    .outside = OutsideCorner::kLines,
    .outside_needs =
        "the control goes round outside corners of a compensated contour as a Fanuc does (setting 58)"};

constexpr std::string_view kCornersAreAnOption =
    "',R' and ',C' are an option of the control (optional chamfering and corner R); it has it";

constexpr DialectRules mach_rules(Dialect dialect, std::string_view name, std::string_view title) {
  DialectRules rules;
  rules.dialect = dialect;
  rules.name = name;
  rules.title = title;
  rules.planner = MotionPlanner::kMach;
  rules.needs_lengths = true;
  rules.macros = MacroLanguage::kMach;
  rules.g.sets = kPlanMaps | kSkipMoves | kDrillCycles | kToolLengths | kFractionalOffsets | kKeptShifts |
                 kExactStopBesidePath | kAbsoluteCenters | kCompensation;
  rules.compensation = kOfInterpreter;
  rules.m.missing = kSpindleAndFlood;
  rules.boring = BoringWords::kManualOut;
  rules.centers_set_up = true;
  rules.has_old_units = true;
  return rules;
}

constexpr DialectRules mach3_rules() {
  DialectRules rules = mach_rules(Dialect::kMach3, "mach3", "Mach3");
  rules.scaling = ScalingWords::kAxes;
  rules.numbered_offsets = 254;
  rules.offset_with_number = 590;
  return rules;
}

constexpr DialectRules mach4_rules() {
  DialectRules rules = mach_rules(Dialect::kMach4, "mach4", "Mach4");
  rules.g.sets |= kOffsetsByNumber;
  rules.numbered_offsets = 248;
  return rules;
}

constexpr DialectRules linuxcnc_rules() {
  DialectRules rules;
  rules.dialect = Dialect::kLinuxCnc;
  rules.name = "linuxcnc";
  rules.title = "LinuxCNC";
  rules.planner = MotionPlanner::kLinuxCnc;
  rules.needs_lengths = true;
  rules.macros = MacroLanguage::kLinuxCnc;
  rules.g.sets = kProbing | kDrillCycles | kToolLengths | kStatedLengths | kFractionalOffsets | kKeptShifts |
                 kExactStopBesidePath | kStoredPlaces | kAbsoluteCenters | kCompensation | kStatedRadii;
  rules.g.missing = kMissingOnLinuxCnc;
  rules.m.only = kLinuxCncMiscellaneous;
  rules.m.user_words = true;
  rules.m.at_others = ", which stops there; its set-up has a REMAP for it that moves nothing";
  rules.stray_words = StrayWords::kLinuxCnc;
  rules.zero_length_is_off = false;
  rules.bounded_blending = true;
  rules.returns_to_r = true;
  rules.cycle_rises_over = true;
  rules.cycle_needs_dwell = true;
  rules.feeds_out_to_clear = true;
  rules.keeps_cycle_words = false;
  rules.rereads_cycle_numbers = true;
  rules.feed_in_unit_before = true;
  rules.feed_mode_drops_feed = true;
  rules.resets_modes = true;
  rules.saves_modes = true;
  rules.states_tool = true;
  rules.polar_words = true;
  rules.compensation = kOfInterpreter;
  return rules;
}

/// PathPilot runs LinuxCNC's interpreter.
constexpr DialectRules tormach_rules() {
  DialectRules rules = linuxcnc_rules();
  rules.dialect = Dialect::kTormach;
  rules.name = "tormach";
  rules.title = "Tormach PathPilot";
  rules.g.sets &= ~static_cast<unsigned>(kProbing);
  rules.g.missing = {};
  rules.m.at_others = ", which stops there; its set-up has a word for it that moves nothing";
  rules.polar_words = false;
  return rules;
}

/// In the order of Dialect.
constexpr std::array kRules{
    linuxcnc_rules(),
    DialectRules{.dialect = Dialect::kGrbl,
                 .name = "grbl",
                 .title = "Grbl",
                 .planner = MotionPlanner::kGrbl,
                 .end = ProgramEnd::kWordOrText,
                 .g = {.only = kGrblWords},
                 .m = {.only = kGrblMiscellaneous,
                       .at_others = ", which stops there; what sends the program leaves it out"},
                 .stray_words = StrayWords::kGrbl,
                 .changer = false,
                 .path_words = false,
                 .radius_beats_center = true,
                 .resets_modes = true,
                 .mist_needs = "M7 is a word of firmware that was built with ENABLE_M7; this one was"},
    DialectRules{
        .dialect = Dialect::kFanuc,
        .name = "fanuc",
        .title = "Fanuc",
        .macros = MacroLanguage::kFanuc,
        .needs_lengths = true,
        .changer_alone = true,
        .g = {kPlanMaps | kSkipMoves | kDrillCycles | kToolLengths | kOffsetsByNumber | kCompensation},
        .stray_words = StrayWords::kCorners,
        .lengths_by_number = true,
        .cycle_goes_over_below_r = true,
        .taps = TapRule::kTiedByM29,
        .taps_peck = true,
        .boring = BoringWords::kFanuc,
        .scaling = ScalingWords::kThousandths,
        .radius_beats_center = true,
        .home_is_top = true,
        .g61_halts = true,
        .no_home_in_cycle = true,
        .adds_to_offsets = true,
        .points_matter = true,
        .dwell_by_x = true,
        .dwell_in_ms = true,
        .count_in_program_number = true,
        .corner_words = true,
        .corner_needs = kCornersAreAnOption,
        .most_calls = 10,
        .numbered_offsets = 300,
        .offset_with_number = 540,
        .mist_needs = "what M7 does is the machine builder's choice; it switches the mist on",
        .compensation = kOfFanuc,
        .radius_number_stays = true},
    DialectRules{.dialect = Dialect::kHaas,
                 .name = "haas",
                 .title = "Haas",
                 .macros = MacroLanguage::kFanuc,
                 .needs_lengths = true,
                 .changer_alone = true,
                 .g = {kPlanMaps | kSkipMoves | kDrillCycles | kToolLengths | kHaasWords | kOffsetsByNumber |
                       kCompensation},
                 .m = {.missing = kSpindleAndFlood},
                 .stray_words = StrayWords::kCorners,
                 .lengths_by_number = true,
                 .cycle_goes_over_below_r = true,
                 .taps = TapRule::kTied,
                 .boring = BoringWords::kHaas,
                 .scaling = ScalingWords::kFactor,
                 .radius_beats_center = true,
                 .home_is_top = true,
                 .g61_halts = true,
                 .resets_modes = true,
                 .points_matter = true,
                 .dwell_in_ms = true,
                 .dwell_with_point_in_s = true,
                 .calls_blocks = true,
                 .corner_words = true,
                 .numbered_offsets = 99,
                 .mist_on = 830,
                 .mist_off = 840,
                 .mist_needs = "M83 is an option of the machine; it has it, for mist",
                 .compensation = kOfHaas,
                 .radius_number_stays = true},
    DialectRules{.dialect = Dialect::kHeidenhain,
                 .name = "heidenhain",
                 .title = "Heidenhain",
                 .language = Language::kKlartext,
                 .changer_alone = true},
    mach3_rules(),
    mach4_rules(),
    DialectRules{.dialect = Dialect::kMarlin,
                 .name = "marlin",
                 .title = "Marlin",
                 .planner = MotionPlanner::kMarlin,
                 .end = ProgramEnd::kText,
                 .speed_may_be_power = true,
                 .names_no_tools = true,
                 .g = {kFractionalOffsets},
                 .m = {.missing = kMissingOnMarlin},
                 .changer = false,
                 .path_words = false,
                 .radius_beats_center = true,
                 .home_is_switches = true,
                 .always_in_xy = true,
                 .always_mm = true,
                 .dwell_in_ms = true,
                 .dwell_by_s = true,
                 .inch_needs = "G20 is a word of firmware that was built with INCH_MODE_SUPPORT; this one "
                               "was, and does not take inches for mm",
                 .pause_says_text = true,
                 .mist_needs = "M7 is a word of firmware that was built with COOLANT_MIST; this one was"},
    DialectRules{.dialect = Dialect::kSiemens,
                 .name = "siemens",
                 .title = "Sinumerik",
                 .language = Language::kSinumerik,
                 .macros = MacroLanguage::kSinumerik,
                 .unit_words = "neither G700 nor G710",
                 .no_path_word = "neither G60 nor a path tolerance (G642 with CTOL)",
                 .blends_freely = "G64 (or G641 without ADIS, G644)",
                 .blends_by_setting = "G642 without CTOL",
                 .needs_lengths = true,
                 .changer_alone = true,
                 .home_is_top = true,
                 .corner_words = true,
                 .corner_feeds_as_next = true,
                 .most_calls = 11,
                 .mist_needs = "what M7 does is the machine builder's choice; it switches the mist on",
                 .radius_of_edge = true},
    // EIA/ISO programs: the words of Fanuc, with synchronous tapping under words of their own.
    DialectRules{.dialect = Dialect::kMazak,
                 .name = "mazak",
                 .title = "Mazak EIA/ISO",
                 .needs_lengths = true,
                 .changer_alone = true,
                 .g = {kDrillCycles | kToolLengths | kOffsetsByNumber | kExactStopBesidePath | kCompensation},
                 .stray_words = StrayWords::kCorners,
                 .lengths_by_number = true,
                 .cycle_goes_over_below_r = true,
                 .boring = BoringWords::kFanuc,
                 .radius_beats_center = true,
                 .home_is_top = true,
                 .g61_halts = true,
                 .no_home_in_cycle = true,
                 .adds_to_offsets = true,
                 .points_matter = true,
                 .dwell_by_x = true,
                 .dwell_in_ms = true,
                 .corner_words = true,
                 .corner_needs = kCornersAreAnOption,
                 .numbered_offsets = 300,
                 .offset_with_number = 540,
                 .mist_needs = "what M7 does is the machine builder's choice; it switches the mist on",
                 .compensation = kOfFanuc,
                 .radius_number_stays = true},
    // PathPilot is built on LinuxCNC's interpreter. Its work offsets by number (G54.1 P) are not read.
    tormach_rules(),
    // OSP-P: its own words are taken apart in control/osp_words.cpp, and the rest is as on other controls. Which way rapids go is a
    // parameter; macros (VC1=, IF, GOTO, CALL) are refused.
    DialectRules{.dialect = Dialect::kOkuma,
                 .name = "okuma",
                 .title = "Okuma OSP",
                 .needs_lengths = true,
                 .changer_alone = true,
                 .g = {.sets = kDrillCycles | kToolLengths, .missing = kMissingOnOsp},
                 .stray_words = StrayWords::kCorners,
                 .lengths_by_number = true,
                 .cycle_goes_over_below_r = true,
                 .g61_halts = true,
                 .points_matter = true,
                 .mist_needs = "what M7 does is the machine builder's choice; it switches the mist on",
                 .osp_words = true,
                 .length_on = "G56",
                 .length_off = "G53"},
    // grblHAL's cycles are those of LinuxCNC, but return to the height before them where nothing is said.
    DialectRules{.dialect = Dialect::kGrblHal,
                 .name = "grblhal",
                 .title = "grblHAL",
                 .planner = MotionPlanner::kGrbl,
                 .end = ProgramEnd::kWordOrText,
                 .g = {.only = kGrblHalWords},
                 .m = {.only = kGrblHalMiscellaneous,
                       .at_others = ", which stops there; what sends the program leaves it out"},
                 .stray_words = StrayWords::kGrblHal,
                 .zero_length_is_off = false,
                 .change_needs = "M6 stops for a change of tools, which $341=4 switches off; $341 is not 4",
                 .states_tool = true,
                 .path_words = false,
                 .cycle_needs_dwell = true,
                 .feeds_out_to_clear = true,
                 .scaling = ScalingWords::kAxes,
                 .keeps_cycle_words = false,
                 .radius_beats_center = true,
                 .resets_modes = true,
                 .mist_needs = "M7 is a word of boards with an output for mist; this one has it"},
};

constexpr bool rows_are_in_order() {
  for (std::size_t k = 0; k < kRules.size(); ++k)
    if (kRules[k].dialect != static_cast<Dialect>(k)) return false;
  return std::equal(kRules.begin(), kRules.end(), std::begin(kControllers), std::end(kControllers),
                    [](const DialectRules& rules, std::string_view name) { return rules.name == name; });
}
static_assert(rows_are_in_order(),
              "each of kControllers has its Dialect and its row here, in the same order; see "
              "docs/adding-a-controller.md");

/// G words from `first` to `last`, in tenths, that a control has only where its row has the set.
struct SpecialWords {
  int first, last;
  GWordSet set;
};
constexpr SpecialWords kSpecialWords[] = {{730, 730, kDrillCycles},
                                          {740, 799, kDrillCycles},
                                          {801, 890, kDrillCycles},
                                          {430, 430, kToolLengths},
                                          {431, 432, kStatedLengths},
                                          {1540, 1540, kHaasWords},
                                          {1870, 1870, kHaasWords},
                                          {1030, 1030, kHaasWords},
                                          {1100, 1290, kHaasWords},
                                          {541, 541, kOffsetsByNumber},
                                          {591, 593, kFractionalOffsets},
                                          {922, 923, kKeptShifts},
                                          {611, 611, kExactStopBesidePath},
                                          {281, 281, kStoredPlaces},
                                          {301, 301, kStoredPlaces},
                                          {901, 901, kAbsoluteCenters},
                                          {160, 160, kPlanMaps},
                                          {680, 680, kPlanMaps},
                                          {501, 501, kPlanMaps},
                                          {511, 511, kPlanMaps},
                                          {310, 310, kSkipMoves},
                                          {382, 385, kProbing},
                                          {410, 410, kCompensation},
                                          {420, 420, kCompensation},
                                          {411, 411, kStatedRadii},
                                          {421, 421, kStatedRadii}};

bool among(std::span<const int> list, int code) {
  return std::find(list.begin(), list.end(), code) != list.end();
}

}  // namespace

const DialectRules& rules_of(Dialect dialect) {
  return kRules[static_cast<std::size_t>(dialect)];
}

MotionPlanner planner_of(Dialect dialect) {
  return rules_of(dialect).planner;
}

std::string_view name_of(Dialect dialect) {
  return rules_of(dialect).name;
}

std::optional<Dialect> dialect_named(std::string_view name) {
  for (const DialectRules& rules : kRules)
    if (rules.name == name) return rules.dialect;
  return std::nullopt;
}

Dialect dialect_of(Language language) {
  const auto* const found = std::find_if(
      kRules.begin(), kRules.end(), [&](const DialectRules& rules) { return rules.language == language; });
  CLEARCUT_ASSERT(found != kRules.end());
  return found->dialect;
}

std::vector<Dialect> word_address_dialects() {
  std::vector<Dialect> dialects;
  for (const DialectRules& rules : kRules)
    if (rules.language == Language::kWordAddress) dialects.push_back(rules.dialect);
  return dialects;
}

bool knows_g(const DialectRules& rules, int code) {
  if (!rules.g.only.empty()) return among(rules.g.only, code);
  if (among(rules.g.missing, code)) return false;
  for (const SpecialWords& words : kSpecialWords)
    if (words.first <= code && code <= words.last) return (rules.g.sets & words.set) != 0;
  return true;
}

bool is_boring_cycle(const DialectRules& rules, int code) {
  switch (code) {
    case 760:
      return rules.boring == BoringWords::kFanuc || rules.boring == BoringWords::kHaas;
    case 870:
      return rules.boring == BoringWords::kHaas;
    case 880:
      return rules.boring != BoringWords::kNone;
    default:
      return false;
  }
}

bool bores_from_below(const DialectRules& rules, int code) {
  return (code == 770 && rules.boring == BoringWords::kHaas) ||
         (code == 870 && (rules.boring == BoringWords::kFanuc || rules.boring == BoringWords::kManualOut));
}

bool knows_m(const DialectRules& rules, int code) {
  if (rules.m.only.empty()) return !among(rules.m.missing, code);
  return among(rules.m.only, code) || (rules.m.user_words && is_user_word(code));
}

bool is_user_word(int code) {
  return code >= kFirstOfUser && code <= kLastOfUser;
}

}  // namespace clearcut::read::gcode
