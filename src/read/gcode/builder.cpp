#include "read/gcode/builder.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/format.h"

namespace clearcut::read::gcode {

namespace {

/// mm; beyond any machine.
constexpr double kLargestCoordinate = 1e6;
/// Cycles, turns and repeats may write at most this many moves beyond a few for each line.
constexpr long long kMostExpandedMoves = 1'000'000;
constexpr long long kMovesPerLine = 8;

MoveKind guessed_kind(const Move& move, bool rapid) {
  if (rapid) return MoveKind::kRapid;
  if (move.is_vertical()) return move.z_to < move.z_from ? MoveKind::kPlunge : MoveKind::kRetract;
  return move.z_to < move.z_from ? MoveKind::kRamp : MoveKind::kCut;
}

}  // namespace

ToolpathBuilder::ToolpathBuilder(std::string file_name, double home_z, Diagnostics& diagnostics)
    : file_name_(std::move(file_name)), home_z_(home_z), diagnostics_(diagnostics), highest_(home_z) {}

void ToolpathBuilder::begin_section(std::string label, int workingstep) {
  label_ = std::move(label);
  workingstep_ = workingstep;
  new_section_ = true;
}

/// A section that has not cut yet takes the new tool.
void ToolpathBuilder::begin_section() {
  new_section_ = new_section_ || section_cuts_;
}

void ToolpathBuilder::rapid(const Target& target, int line) {
  straight(target, true, {}, line);
}

void ToolpathBuilder::feed(const Target& target, MmPerMin feed, int line) {
  straight(target, false, feed, line);
}

void ToolpathBuilder::arc(const Edge& path, double z_to, MmPerMin feed, int line) {
  Move move{path, known(2, line), z_to, MoveKind::kCut, feed, line};
  move.kind = guessed_kind(move, false);
  append(move);
  at_ = {path.to.x, path.to.y, z_to};
}

void ToolpathBuilder::lift_home(int line) {
  rapid({std::nullopt, std::nullopt, std::max(highest_, at_[2].value_or(home_z_))}, line);
}

double ToolpathBuilder::known(std::size_t axis, int line) {
  if (!at_[axis]) {
    warn(line, std::string("cuts or counts from a place the program has not stated; ") + "XYZ"[axis] +
                   " is taken as " + (axis == 2 ? trimmed(home_z_, 3) + " mm" : "0"));
    at_[axis] = axis == 2 ? home_z_ : 0;
  }
  return *at_[axis];
}

void ToolpathBuilder::straight(const Target& target, bool rapid, MmPerMin feed, int line) {
  for (const auto& value : target) {
    if (value && !(std::abs(*value) <= kLargestCoordinate)) {
      throw InputError(place(line), "coordinate beyond any machine; check the number and the units");
    }
  }
  Target from = at_;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!from[axis]) from[axis] = target[axis];
  }
  if (!from[2] && target[2]) from[2] = std::max(home_z_, *target[2]);
  at_ = from;
  const bool placed = from[0] && from[1];
  const bool moves_in_plan =
      placed && ((target[0] && target[0] != from[0]) || (target[1] && target[1] != from[1]));
  if (!rapid || moves_in_plan) {
    for (std::size_t axis = 0; axis < 3; ++axis) known(axis, line);
    from = at_;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (target[axis]) at_[axis] = target[axis];
  }
  if (at_[2]) highest_ = std::max(highest_, *at_[2]);
  if (!from[0] || !from[1] || !from[2]) return;
  Move move{
      Edge::line({*from[0], *from[1]}, {*at_[0], *at_[1]}), *from[2], *at_[2], MoveKind::kCut, feed, line};
  if (move.is_vertical() && move.z_from == move.z_to) return;
  move.kind = guessed_kind(move, rapid);
  append(move);
}

void ToolpathBuilder::append(const Move& move) {
  check_size(move.line);
  section_for(move).moves.push_back(move);
}

/// The tool, spindle and coolant of a section are those of its first feed move.
Section& ToolpathBuilder::section_for(const Move& move) {
  const bool cuts = !is_rapid(move.kind);
  auto& sections = toolpath_.sections;
  if (!new_section_ && cuts && section_cuts_) {
    const Section& now = sections.back();
    new_section_ = Drive{now.tool_number, now.spindle_rpm, now.spindle_clockwise, now.coolant} != drive;
  }
  if (new_section_) {
    sections.push_back({.label = label_, .workingstep = workingstep_, .moves = {}});
    new_section_ = section_cuts_ = false;
  }
  Section& section = sections.back();
  if (!section_cuts_) {
    section.tool_number = drive.tool;
    section.spindle_rpm = drive.spindle_rpm;
    section.spindle_clockwise = drive.clockwise;
    section.coolant = drive.coolant;
    section_cuts_ = cuts;
  }
  return section;
}

void ToolpathBuilder::check_size(int line) {
  if (++moves_ > kMostExpandedMoves + kMovesPerLine * line) {
    throw InputError(place(line), "cycles and repeats expand to over a million moves; shorten the program");
  }
}

void ToolpathBuilder::note(int line, const std::string& what) {
  if (said_.insert(what).second) diagnostics_.note(place(line), what);
}

void ToolpathBuilder::warn(int line, const std::string& what) {
  if (said_.insert(what).second) diagnostics_.warn(place(line), what);
}

}  // namespace clearcut::read::gcode
