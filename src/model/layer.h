// Input of every strategy, one layer of one feature with its cutter, and its result: passes, not yet ordered or
// linked.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "geometry/box.h"
#include "geometry/region.h"
#include "model/move.h"
#include "model/part.h"

namespace clearcut::inline model {

/// A curve of the tool's centre at one depth.
struct Pass {
  Path path;
  bool closed = false;     ///< path is a loop: cutting may start anywhere on it
  int parent = -1;         ///< index of the enclosing pass, which is nearer to the wall; -1: none
  std::vector<int> after;  ///< indices of passes to be cut before this one, regardless of `parent`
  int component = 0;       ///< passes of one connected legal area share a component
  double offset = 0;       ///< mm; distance of offset contours from the wall
  /// Among the passes that may be cut first, the one with the greatest value begins, unless a start was asked
  /// for. For offset contours the value is the offset, so that cutting begins at the place with most room.
  double start_priority = 0;
  bool reversible = true;  ///< may be cut in either direction (e.g. medial-axis spurs)
  /// Kind of each edge of `path`, kCut or kLink (through cleared material, at the link feed). Empty: all cut.
  std::vector<MoveKind> kinds;
  /// The path begins by circling this point once: a helix about this point may lead down to the path's start.
  std::optional<Vec2> entry_center;
  /// Whether the cutter may move straight to the start at depth, from another pass or from beside the stock, cutting
  /// the material in between. If not, the pass is entered from above, or begins in a place without material.
  bool may_cut_to_start = true;
  /// Whether the start is already cleared: a vertical move at the plunge feed is as good as any other entry.
  bool starts_clear = false;
};

/// A path in space of the tip of a shaped cutter. Its pieces join end to start.
struct Track {
  struct Piece {
    Edge path;
    double z_from = 0;
    double z_to = 0;
  };
  std::vector<Piece> pieces;
  bool closed = false;  ///< may begin with any of its pieces
};

/// All passes of one layer of one feature with the data needed for linking.
struct LayerPasses {
  double z_top = 0;             ///< height of the top of the material
  double z = 0;                 ///< depth of the passes
  Regions legal;                ///< legal area of the tool's centre at this depth
  std::vector<Path> fit_lines;  ///< lines on which the tool just fits (zero-width parts of the legal area)
  Regions target;               ///< material to remove in this layer, plan view
  /// mm; uncut residuals up to this distance from cleared areas may stay between passes.
  double residual = 0;
  std::vector<Pass> passes;
  std::optional<double> cleared_beyond;  ///< mm, as of Layer
  std::optional<double> cleared_to;      ///< mm, as of Layer
  /// Height of the top of walls above z_top that are no farther away than the layer's walls; absent: there are none.
  std::optional<double> wall_top;
  bool outside_in = false;    ///< rings come before the rings inside them
  std::optional<Vec2> start;  ///< point at which cutting should begin, or the nearest one of the first pass
  std::string strategy;       ///< name of the strategy that ran
  std::vector<Remark> remarks;
};

struct Layer {
  double z_top = 0;        ///< height of the top of the material
  double z = 0;            ///< height of the cutter's tip
  Regions target;          ///< material to remove, plan view at z
  Regions allowed;         ///< area in which the cutter may be at z; its boundary is the true walls
  double tool_radius = 0;  ///< radius of the flat part of the cutter's end, mm
  double wall_stock = 0;   ///< stock to leave on walls and the round of the cutter's corners, mm
  /// mm; part of wall_stock due to the corner rounding of the cutter: above the rounding its side cuts.
  double rounded = 0;
  /// mm; part of wall_stock needed only for rounding in the program: exact fits need not keep this part.
  double reserve = 0;
  std::optional<Box> stock;  ///< plan view of the stock; no material outside. Absent: unlimited material
  /// Holes at least as deep as the layer, through which the cutter can go down.
  std::vector<PredrilledHole> holes;
  double lift = 10;  ///< mm from the tip up to the height of rapids across, mean of the feature's layers
  /// Rapids of later cuts descend here: not even a residual far thinner than tol.uncut may stay.
  bool bare = false;
  /// The target is what earlier steps have left: beyond it, nothing stands where the cutter may be.
  bool rest = false;
  /// mm; earlier steps have cleared everything that the cutter touches this far or farther from the passes along the walls.
  /// Absent: not known.
  std::optional<double> cleared_beyond;
  /// mm beside the passes to which earlier steps have cut: absent where they have cleared all beyond. A slot ends there.
  std::optional<double> cleared_to;
  /// mm; earlier steps have cut a slot that leaves the cutter so much room beside the passes of a profile.
  double room_beside = 0;
};

/// A strategy as its callers see it.
using Strategy = std::function<LayerPasses(const Layer&)>;

}  // namespace clearcut::inline model
