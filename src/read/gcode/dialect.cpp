#include "read/gcode/dialect.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "read/gcode/words/g_words.h"

namespace clearcut::read::gcode {

namespace {

constexpr std::array<std::string_view, 8> kNames{"linuxcnc",   "grbl",  "fanuc", "haas",
                                                 "heidenhain", "mach3", "mach4", "marlin"};

/// In the order of the names.
constexpr std::array<MotionPlanner, 8> kPlannersOfDialects{
    MotionPlanner::kLinuxCnc,    MotionPlanner::kGrbl,        MotionPlanner::kJerkLimited,
    MotionPlanner::kJerkLimited, MotionPlanner::kJerkLimited, MotionPlanner::kMach,
    MotionPlanner::kMach,        MotionPlanner::kMarlin};

}  // namespace

MotionPlanner planner_of(Dialect dialect) {
  return kPlannersOfDialects[static_cast<std::size_t>(dialect)];
}

std::string_view name_of(Dialect dialect) {
  return kNames[static_cast<std::size_t>(dialect)];
}

std::optional<Dialect> dialect_named(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Dialect>(found - kNames.begin());
}

namespace {

constexpr DialectRules mach_rules(Dialect dialect) {
  return {.dialect = dialect,
          .centers_set_up = true,
          .has_old_units = true,
          .numbered_offsets = dialect == Dialect::kMach3 ? 254 : 248};
}

constexpr std::array kRules{
    DialectRules{.dialect = Dialect::kLinuxCnc,
                 .returns_to_r = true,
                 .cycle_rises_over = true,
                 .feeds_out_to_clear = true,
                 .keeps_cycle_words = false,
                 .rereads_cycle_numbers = true,
                 .resets_modes = true,
                 .saves_modes = true},
    DialectRules{.dialect = Dialect::kGrbl,
                 .cycles = false,
                 .changer = false,
                 .path_words = false,
                 .radius_beats_center = true,
                 .resets_modes = true,
                 .mist_needs = "M7 is a word of firmware that was built with ENABLE_M7; this one was"},
    DialectRules{.dialect = Dialect::kFanuc,
                 .lengths_by_number = true,
                 .taps = TapRule::kTiedByM29,
                 .radius_beats_center = true,
                 .home_is_top = true,
                 .points_matter = true,
                 .dwell_by_x = true,
                 .dwell_in_ms = true,
                 .numbered_offsets = 300,
                 .mist_needs = "what M7 does is the machine builder's choice; it switches the mist on"},
    DialectRules{.dialect = Dialect::kHaas,
                 .lengths_by_number = true,
                 .taps = TapRule::kTied,
                 .radius_beats_center = true,
                 .home_is_top = true,
                 .resets_modes = true,
                 .points_matter = true,
                 .dwell_in_ms = true,
                 .numbered_offsets = 99,
                 .mist_on = 830,
                 .mist_off = 840,
                 .mist_needs = "M83 is an option of the machine; it has it, for mist"},
    mach_rules(Dialect::kMach3),
    mach_rules(Dialect::kMach4),
    DialectRules{.dialect = Dialect::kMarlin,
                 .cycles = false,
                 .tool_lengths = false,
                 .changer = false,
                 .path_words = false,
                 .radius_beats_center = true,
                 .always_mm = true,
                 .dwell_in_ms = true,
                 .dwell_by_s = true,
                 .inch_needs = "G20 is a word of firmware that was built with INCH_MODE_SUPPORT; this one "
                               "was, and does not take inches for mm",
                 .pause_says_text = true,
                 .mist_needs = "M7 is a word of firmware that was built with COOLANT_MIST; this one was"},
};

// Grbl 1.1: the only words of its groups.
constexpr int kGrblWords[] = {0,   10,  20,  30,  40,  100, 170, 180, 190, 200, 210, 280, 281,
                              300, 301, 382, 383, 384, 385, 400, 431, 490, 530, 540, 550, 560,
                              570, 580, 590, 610, 800, 900, 910, 911, 920, 921, 930, 940};

constexpr int kGrblMiscellaneous[] = {0, 10, 20, 30, 40, 50, 70, 80, 90, 300, 560, 990};

// LinuxCNC, "M-Codes" of its manual; those from M100 to M199 are programs of the user's.
constexpr int kLinuxCncMiscellaneous[] = {0,   10,  20,  30,  40,  50,  60,  70,  80,  90,  190,
                                          300, 480, 490, 500, 510, 520, 530, 600, 610, 620, 630,
                                          640, 650, 660, 670, 680, 700, 710, 720, 730, 980, 990};
constexpr int kSpindleAndFlood = 130, kSpindleBackAndFlood = 140, kMarlinProbeTest = 480;
constexpr int kFirstOfUser = 1000, kLastOfUser = 1990;

bool among(const auto& list, int code) {
  return std::find(std::begin(list), std::end(list), code) != std::end(list);
}

}  // namespace

const DialectRules& rules_of(Dialect dialect) {
  for (const DialectRules& rules : kRules) {
    if (rules.dialect == dialect) return rules;
  }
  return kRules.front();
}

std::vector<Dialect> word_address_dialects() {
  std::vector<Dialect> dialects;
  for (const DialectRules& rules : kRules) dialects.push_back(rules.dialect);
  return dialects;
}

bool knows_g(const DialectRules& rules, int code) {
  const Dialect dialect = rules.dialect;
  if (dialect == Dialect::kGrbl) return among(kGrblWords, code);
  const bool fanuc_like = dialect == Dialect::kFanuc || dialect == Dialect::kHaas;
  const bool mach = dialect == Dialect::kMach3 || dialect == Dialect::kMach4;
  if (code == 730 || (code >= 740 && code <= 890 && code != 800)) return rules.cycles;
  if (code == 430) return rules.tool_lengths;
  if (code == 431) return dialect == Dialect::kLinuxCnc;
  if (code == 1540 || code == 1870 || (code >= 1100 && code <= 1290)) return dialect == Dialect::kHaas;
  if (code == 541) return fanuc_like || dialect == Dialect::kMach4;
  if (code == 591 || code == 592 || code == 593) return !fanuc_like;
  if (code == 921 || code == 922 || code == 923) return dialect == Dialect::kLinuxCnc || mach || code == 921;
  if (code == 611) return dialect == Dialect::kLinuxCnc || mach;
  if (code == 281 || code == 301) return dialect == Dialect::kLinuxCnc;
  if (code == 901) return dialect == Dialect::kLinuxCnc || mach;
  return true;
}

bool knows_m(const DialectRules& rules, int code) {
  switch (rules.dialect) {
    case Dialect::kGrbl:
      return among(kGrblMiscellaneous, code);
    case Dialect::kLinuxCnc:
      return among(kLinuxCncMiscellaneous, code) || (code >= kFirstOfUser && code <= kLastOfUser);
    case Dialect::kMarlin:
      return code != kSpindleAndFlood && code != kSpindleBackAndFlood && code != kMarlinProbeTest;
    case Dialect::kFanuc:
      return true;
    default:
      return code != kSpindleAndFlood && code != kSpindleBackAndFlood;
  }
}

}  // namespace clearcut::read::gcode
