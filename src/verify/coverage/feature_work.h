// The required cuts of a program in each feature, and the proof of their completion; the part of an outline in the
// stock: there is no material to cut outside.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "geometry/region.h"
#include "verify/coverage/coverage.h"
#include "verify/part/finished_parts.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// The part of `target` in the stock; the whole target if no stock is given, or if no part of the target is beyond
/// the edge. Boundaries of the result may run to and fro along the stock's edge; this changes neither areas nor
/// winding numbers.
///
/// Method  Every point beyond the stock moves to the nearest one on its edge: a boundary then winds around each point
/// within
///         as often as before. O(edges), exact up to rounding.
Regions within_stock(const Regions& target, const std::optional<Box>& stock);

/// Coverage of a feature down to one height.
struct LevelCoverage {
  double z = 0;
  bool any_cut = false;  ///< some feed move reaches this height there
  Coverage coverage;
  const Tool* tool = nullptr;  ///< tool of the layer
};

/// One feature of the workplan, with the finest requirement of all its operations.
struct FeatureWork {
  int feature = 0;
  int last_workingstep = 0;
  double smallest_radius = 0;  ///< mm; radius of its smallest cutter
  double smallest_flat = 0;    ///< mm; radius of the smallest cutter's flat end
  bool ends_in_point = false;  ///< the smallest cutter has no flat end
  double greatest_radius = 0;
  const Tool* on_walls = nullptr;  ///< the smallest cutter of those that leave the least stock on walls
  double allowance_side = 0;
  double allowance_floor = 0;
  std::optional<double> scallop;  ///< mm; greatest step allowed on walls with draft, square to the wall
  /// For walls with draft on which layers by themselves would leave too much: whether no more is left at any height
  /// nevertheless, because moves between the layers cut the walls.
  bool is_cut_between_layers = false;
  LevelCoverage floor;  ///< down to the floor plus its allowance
  /// End of the lowest feed move in the feature, only if none reaches the floor.
  std::optional<Place> deepest;
  /// Coverage down to each layer above the floor, for the steps with the least stock on walls. Filled for walls with
  /// draft, where each layer has its own outline, and otherwise only if material is left on the floor: a cutter
  /// reaching the floor has cleared the material above. With draft, without uncleared layers that the permitted scallop does not need.
  std::vector<LevelCoverage> layers;
};

/// Scallops left by layers on the feature's walls, square to the wall, from the shape of the cutters, whose ends run
/// along the outline at their height; only for walls with draft, after the check of the work. `asked_mm` is that of
/// tol if no operation states one.
std::optional<Scallop> scallop_of(const Feature& feature, const FeatureWork& work, const Tolerances& tol);

/// The features' works, in the order of their first workingsteps.
std::vector<FeatureWork> works_of(const Part& part);

/// Checks all features on up to options.threads threads, together with `beside`, independent tasks for the
/// same threads. The result does not depend on the number of threads.
void check_works(const Part& part, const FinishedParts& finished, const CheckedProgram& program,
                 const VerifyOptions& options, std::vector<FeatureWork>& works,
                 std::vector<std::function<void()>> beside);

/// The coverage of a work's floor if each move may be up to `off` mm off its path, in any direction: material left
/// for certain and possibly. Keeps references to its sources.
using FloorCheck = std::function<LevelCoverage(const FeatureWork& work, double off)>;
FloorCheck floor_check(const Part& part, const FinishedParts& finished, const CheckedProgram& program,
                       const VerifyOptions& options);

}  // namespace clearcut::verify
