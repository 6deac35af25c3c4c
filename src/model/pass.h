// What a strategy returns: passes of one layer, not yet ordered or linked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/region.h"
#include "model/move.h"

namespace clearcut::inline model {

/// A curve of the tool's centre at one depth.
struct Pass {
  Path path;
  bool closed = false;     ///< path is a loop: it may start anywhere on it
  int parent = -1;         ///< index of the pass around it, nearer to the wall; -1: none
  std::vector<int> after;  ///< indices of passes that have to be cut before it, whatever surrounds what
  int component = 0;       ///< passes of one connected legal area share a component
  double offset = 0;       ///< mm from the wall; of offset contours
  /// Among the passes that may be cut first, the one with the greatest value begins, unless a start was asked
  /// for. For offset contours it is the offset, so that cutting begins where there is most room.
  double start_priority = 0;
  bool reversible = true;  ///< may be cut in either direction (e.g. medial-axis spurs)
  /// What each edge of `path` does, kCut or kLink (through cleared material, at the link feed). Empty: all cut.
  std::vector<MoveKind> kinds;
  /// The path begins by circling this point once: a helix about it may lead down to the path's start.
  std::optional<Vec2> entry_center;
  /// Whether the cutter may come straight to its start at depth, from another pass or from beside the stock, cutting what
  /// is in between. If not it is entered from above, or begins where nothing stands.
  bool may_cut_to_start = true;
  /// Whether nothing stands any more where it begins: straight down at the plunge feed is as good as any entry.
  bool starts_clear = false;
};

/// A line in space that the tip of a shaped cutter follows. Its pieces join end to start.
struct Track {
  struct Piece {
    Edge path;
    double z_from = 0;
    double z_to = 0;
  };
  std::vector<Piece> pieces;
  bool closed = false;  ///< may begin with any of its pieces
};

/// All passes of one layer of one feature with what linking needs to know.
struct LayerPasses {
  double z_top = 0;             ///< where material begins
  double z = 0;                 ///< depth of the passes
  Regions legal;                ///< where the tool's centre may be at this depth
  std::vector<Path> fit_lines;  ///< where it just fits (zero-width parts of the legal area)
  Regions target;               ///< material to remove in this layer, plan view
  double residual = 0;  ///< mm; uncut residuals up to this far from what was cut may stay between passes
  std::vector<Pass> passes;
  /// Up to where walls stand above z_top, no farther away than those of the layer; absent: nothing stands there.
  std::optional<double> wall_top;
  bool outside_in = false;    ///< rings come before those they surround
  std::optional<Vec2> start;  ///< where cutting should begin, or as near as the first pass comes
  std::string strategy;       ///< which strategy ran
};

}  // namespace clearcut::inline model
