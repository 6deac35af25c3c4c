// What the tables of a control hold of tools' radii, as far as it was said.
#pragma once

#include <map>
#include <optional>

namespace clearcut::read::gcode {

struct CompensationValues {
  std::map<int, double> radii;        ///< mm, by the number of the tool
  std::optional<double> only_radius;  ///< mm, of the one tool there is, whatever number it is called by
  std::optional<double> wear;         ///< mm; programs follow the tool's centre, and every D word holds this
  bool is_stated = false;             ///< somebody said which of the two it is
};

}  // namespace clearcut::read::gcode
