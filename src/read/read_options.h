// What the user may say about a file that does not say it itself.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"

namespace clearcut::read {

/// How an open curve that no other curve closes is treated.
enum class OpenCurves {
  kRefuse,  ///< InputError naming the place: a wall may be missing
  kSkip     ///< left out and reported
};

/// What the outlines of a layer are.
enum class LayerRole { kPocket, kIsland, kHole, kIgnore };

/// What the user says about the layers (DXF) or colours (SVG, "#ff0000") that match a pattern; goes before
/// what their names say. The first matching rule counts.
struct LayerRule {
  std::string pattern;  ///< name, * for anything, any case
  std::optional<LayerRole> role;
  std::optional<double> depth;  ///< mm
  std::optional<double> top;    ///< mm
};

/// The material that a job states, where it differs from the solid's own box. mm.
struct StockRequest {
  std::optional<std::array<double, 2>> x, y;  ///< lowest and highest; absent: the solid with the margin
  double margin = 0;
  std::array<double, 2> z{};  ///< bottom and top
};

/// mm. How far through cuts and through holes go below the solid.
inline constexpr double kBreakthrough = 0.5;

/// What is said about a solid (STEP) alone.
struct SolidOptions {
  std::string up;       ///< which side looks up: +Z, -Z, +X, -X, +Y, -Y or face12; "": as it lies
  double turn_deg = 0;  ///< counter-clockwise about the vertical, after that
  std::string body;     ///< name or number from 1 of the body to make; "all": all as one part
  std::optional<double> breakthrough;  ///< mm, >= 0; absent: kBreakthrough
  std::vector<double>
      drills;  ///< mm; diameters at hand: through holes of theirs go deeper by the drill's point
  std::optional<StockRequest> stock;  ///< absent: the solid's bounding box
};

struct ReadOptions {
  std::optional<std::string> unit;  ///< "mm", "cm", "m", "in", "pt", "px", ...: overrides the file's own
  std::optional<double> depth;      ///< mm, > 0: overrides every depth in the file
  std::optional<double> depth_if_missing;  ///< mm, > 0: assumed, with a warning, where the file says nothing
  std::optional<double> top;               ///< mm: z of the drawing's plane
  std::vector<std::string> layers;  ///< only these layers of a drawing (names or patterns with *); empty: all
  std::vector<LayerRule> layer_rules;
  OpenCurves open_curves = OpenCurves::kRefuse;
  std::optional<bool> find_arcs;  ///< find arcs again in runs of short lines; default: drawings yes, JSON no
  SolidOptions solid;
  Tolerances tol;
};

}  // namespace clearcut::read
