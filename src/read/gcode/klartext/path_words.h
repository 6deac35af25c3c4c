// The words of Klartext's path blocks.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/edge.h"
#include "read/gcode/motion/builder.h"

namespace clearcut::read::gcode {

/// What the words of a path block say. mm and degrees.
struct PathWords {
  Target absolute;
  Target incremental;
  std::optional<double> polar_angle, polar_step, polar_radius, radius, feed;
  std::optional<Turn> turn;
  /// R0, RL, RR: compensation ends or begins.
  enum class Radius : unsigned char { kNone, kLeft, kRight };
  std::optional<Radius> compensation;
  bool rapid = false;
  bool feed_of_tool = false;  ///< FAUTO: the feed that TOOL CALL states
  bool machine_frame = false;
  std::optional<double> retract;  ///< M140: mm up along the tool; infinite: to the end of the travel
  std::vector<int> m;
};

struct KlartextScale {
  double unit = 1;    ///< mm in the program's unit
  double longer = 0;  ///< mm, added to every absolute height (DL)
};

/// The words of a path block after the first. Throws InputError at the line for one that is not understood.
PathWords path_words(const std::vector<std::string>& words, const KlartextScale& scale,
                     const ToolpathBuilder& builder, int line);

/// A plain number with or without a sign. Throws InputError at the line for anything else.
double number_in(std::string_view text, const ToolpathBuilder& builder, int line);

}  // namespace clearcut::read::gcode
