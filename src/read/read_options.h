// What the user may say about a file that does not say it itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"

namespace clearcut {

/// How an open curve that no other curve closes is treated.
enum class OpenCurves {
  kRefuse,  ///< InputError naming the place: a wall may be missing
  kSkip     ///< left out and reported
};

struct ReadOptions {
  std::optional<std::string> unit;  ///< "mm", "cm", "m", "in", "pt", "px", ...: overrides the file's own
  std::optional<double> depth;      ///< mm, > 0: overrides the depths of a drawing
  std::optional<double> top;        ///< mm: z of the drawing's plane
  std::vector<std::string> layers;  ///< only these layers of a drawing (names or patterns with *); empty: all
  OpenCurves open_curves = OpenCurves::kRefuse;
  std::optional<bool> find_arcs;  ///< find arcs again in runs of short lines; default: drawings yes, JSON no
  Tolerances tol;
};

}  // namespace clearcut
