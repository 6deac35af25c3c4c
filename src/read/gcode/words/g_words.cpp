#include "read/gcode/words/g_words.h"

#include <algorithm>
#include <array>

namespace clearcut::read::gcode {

namespace {

constexpr std::size_t kCodes = 2000;  // up to G199.9

// The drilling cycles, and those motions that are refused when used: threading, probing, boring, back boring.
constexpr int kMotionWords[] = {0,   10,  20,  30,  330, 331, 382, 383, 384, 385, 730,
                                740, 760, 810, 820, 830, 840, 850, 860, 870, 880, 890};
constexpr int kPlaneWords[] = {170, 180, 190};
constexpr int kDistanceWords[] = {900, 910};
constexpr int kCenterWords[] = {901, 911};
constexpr int kFeedModeWords[] = {930, 940, 950};
constexpr int kUnitWords[] = {200, 210};
constexpr int kReturnWords[] = {980, 990};
constexpr int kOffsetWords[] = {540,  541,  1540, 550,  560,  570,  580,  590,  591,  592,  593,
                                1100, 1110, 1120, 1130, 1140, 1150, 1160, 1170, 1180, 1190, 1200,
                                1210, 1220, 1230, 1240, 1250, 1260, 1270, 1280, 1290};
constexpr int kOnceWords[] = {100, 120, 130, 280, 281, 300, 301, 310, 501, 511, 520, 680, 920, 921, 922, 923};
constexpr int kCompensationWords[] = {410, 411, 420, 421};
// Dwell, look-ahead, exact stop, polar and scaling and rotation off, lengths, machine frame (G53, see
// go_home), path control, cycle end, rpm, limit of look-ahead, smoothness.
constexpr int kSilentWords[] = {40,  80,  90,  150, 160, 400, 430, 431,  490, 500,
                                530, 610, 611, 640, 690, 800, 970, 1030, 1870};

template <std::size_t n>
constexpr void enter(std::array<Group, kCodes>& table, const int (&codes)[n], Group group) {
  for (const int code : codes) table[static_cast<std::size_t>(code)] = group;
}

constexpr std::array<Group, kCodes> kGroups = [] {
  std::array<Group, kCodes> table{};
  enter(table, kMotionWords, Group::kMotion);
  enter(table, kPlaneWords, Group::kPlane);
  enter(table, kDistanceWords, Group::kDistance);
  enter(table, kCenterWords, Group::kCenters);
  enter(table, kFeedModeWords, Group::kFeedMode);
  enter(table, kUnitWords, Group::kUnits);
  enter(table, kReturnWords, Group::kReturn);
  enter(table, kOffsetWords, Group::kOffset);
  enter(table, kOnceWords, Group::kOnce);
  enter(table, kCompensationWords, Group::kCompensation);
  enter(table, kSilentWords, Group::kSilent);
  return table;
}();

}  // namespace

Group group_of(int code) {
  const auto index = static_cast<std::size_t>(code);
  return index < kCodes ? kGroups[index] : Group::kUnknown;
}

bool is_modal(Group group) {
  return group != Group::kUnknown && group != Group::kCompensation && group != Group::kSilent;
}

std::string g_word(int code) {
  const std::string whole = "G" + std::to_string(code / 10);
  return code % 10 == 0 ? whole : whole + "." + std::to_string(code % 10);
}

bool has_g(const Block& block, int code) {
  return std::find(block.g.begin(), block.g.end(), code) != block.g.end();
}

int motion_in(const Block& block) {
  int motion = -1;
  for (const int code : block.g) {
    if (group_of(code) == Group::kMotion || (code == 800 && motion < 0)) motion = code;
  }
  return motion;
}

}  // namespace clearcut::read::gcode
