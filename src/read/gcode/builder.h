// Collects the machine's motion as a toolpath: joins moves, guesses their kind, cuts the program into
// sections.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>

#include "base/diagnostics.h"
#include "model/move.h"

namespace clearcut::read::gcode {

/// Values of X, Y, Z; absent where not given. mm, in the frame of the work offset.
using Target = std::array<std::optional<double>, 3>;

/// What drives the tool; a change between two feed moves begins a new section.
struct Drive {
  int tool = 0;
  double spindle_rpm = 0;  ///< 0 while stopped
  bool clockwise = true;
  bool coolant = false;
  friend bool operator==(const Drive&, const Drive&) = default;
};

/// Where the program starts is unknown: a coordinate is known once it has been given, and the first move
/// begins at its own coordinates.
class ToolpathBuilder {
 public:
  /// home_z: mm, height of places above the work that the program does not state: the start, machine home.
  ToolpathBuilder(std::string file_name, double home_z, Diagnostics& diagnostics);

  Drive drive;

  /// An operation comment: the next move begins a new section.
  void begin_section(std::string label, int workingstep);
  /// A tool change.
  void begin_section();

  void rapid(const Target& target, int line);
  void feed(const Target& target, MmPerMin feed, int line);
  /// Along `path` (which starts at the known position) to height z_to.
  void arc(const Edge& path, double z_to, MmPerMin feed, int line);
  /// Straight up to where the machine's own zero is taken to be.
  void lift_home(int line);

  const Target& position() const { return at_; }
  /// Coordinate of `axis`, taken as 0 with a warning where the program has not said it.
  double known(std::size_t axis, int line);
  void place_at(std::size_t axis, double value) { at_[axis] = value; }

  Toolpath take() { return std::move(toolpath_); }
  /// Adds `what` once, with the line where it was first seen.
  void note(int line, const std::string& what);
  void warn(int line, const std::string& what);
  std::string place(int line) const { return file_name_ + ":" + std::to_string(line); }

 private:
  void straight(const Target& target, bool rapid, MmPerMin feed, int line);
  void append(const Move& move);
  Section& section_for(const Move& move);
  void check_size(int line);

  std::string file_name_;
  double home_z_;
  Diagnostics& diagnostics_;
  std::set<std::string> said_;
  Toolpath toolpath_;
  Target at_;
  double highest_;
  std::string label_;
  int workingstep_ = -1;
  bool new_section_ = true;
  bool section_cuts_ = false;
  long long moves_ = 0;
};

}  // namespace clearcut::read::gcode
