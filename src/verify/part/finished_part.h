// The finished part: floors at their heights, and the walls between them, without thin slivers of material between
// two nearly touching features, too thin to count as material.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "model/part.h"
#include "verify/part/edge_tree.h"

namespace clearcut::verify {

/// A piece of wall between two floors: the area left of `edge` is free above z_low, the area right of it solid below
/// z_high. Only walls bound the area permitted to a cutter.
struct Wall {
  Edge edge;
  double z_low = 0;   ///< height of the floor at its foot
  double z_high = 0;  ///< height of the material behind it
  int feature = -1;   ///< feature of the outline; -1: the edge of the stock
  double top_z = 0;   ///< for walls with draft: height at which the wall is at `edge`
  double slope = 0;   ///< tangent of the draft; at height z the wall is (top_z - z) * slope inside `edge`
  double fillet =
      0;  ///< mm; radius of the hollow fillet to be left at its foot, tangent to the wall and to the floor
  /// For walls with draft: at this end the side of the stock cuts the wall off square.
  bool flat_from = false;
  bool flat_to = false;

  bool stands_at(double z) const { return z_low <= z && z < z_high; }
  /// Cosine and sine of the angle by which the wall leans.
  double cos_of_draft() const { return 1 / std::sqrt(1 + slope * slope); }
  double sin_of_draft() const { return slope * cos_of_draft(); }
  /// mm; an arc of this radius that touches the wall and the floor has its centre this far from the foot, and touches the wall this high.
  double center_of_touching(double radius) const { return radius * (1 - sin_of_draft()) / cos_of_draft(); }
  double height_of_touching(double radius) const { return radius * (1 - sin_of_draft()); }
  double draft_offset(double z) const { return slope > 0 ? std::max(0.0, top_z - z) * slope : 0.0; }
  /// The ends of the wall at height z at which the stock's side cuts the wall off: lines from or to the outline, free
  /// on their left.
  std::vector<Edge> flat_ends(double z) const;
};

/// Selection of the features treated as cut.
struct CutFeatures {
  bool threads = false;  ///< external threads, as their own mills may; all others must leave the boss whole
  std::optional<int> only_draft = {};  ///< only this one of the features with draft is cut
  /// T-slots with a roof at this height or higher, mm, together with all material over them.
  std::optional<double> undercuts_up_to = {};
};

/// Height of the part over the plan view: the lowest floor of the features permitting the cutter at a place,
/// else the top; nothing beside the stock. Walls are found by cutting all outlines at each other and
/// computing the height on both sides of every piece. Walls that features share count once; edges between
/// touching pockets vanish.
///
/// Cost    build O(n log n + crossings); a query O(features * log n).
///         Material no thicker than kThinSliver between two features is no wall.
/// Error   Of walls cut off by crossings, pieces shorter than 10 nm are not found. A wall with draft cut into by
///         another feature is treated as whole; see FinishedParts.
class FinishedPart {
 public:
  explicit FinishedPart(const Part& part, const CutFeatures& cut = {});

  double top_z() const { return top_z_; }
  const std::vector<Wall>& walls() const { return walls_; }
  const EdgeTree& wall_tree() const { return tree_; }
  /// mm; the greatest radius of a fillet at the foot of a wall; 0: there is none.
  double greatest_fillet() const { return greatest_fillet_; }
  /// Outlines of features beside the stock, without material: an allowance applies to these like to walls, as far as
  /// it extends into the stock.
  const std::vector<Wall>& outlines_beyond() const { return beyond_; }
  /// All heights of floors and tops, ascending.
  const std::vector<double>& heights() const { return heights_; }
  /// mm; the greatest distance of a wall with draft from its outline, at any height.
  double greatest_draft_offset() const { return greatest_draft_offset_; }

  /// mm; distance of a wall at height z inside its outline for a cutter at p. It is non-zero only for walls with
  /// draft, towards their own feature.
  double draft_offset(const Wall& wall, double z, Vec2 p) const {
    return wall.slope > 0 && z < wall.top_z && is_inside(wall.feature, p) ? draft_offset_inside(wall, z, p)
                                                                          : 0.0;
  }
  /// mm; distance from a path (or point, from == to) to a wall at height z.
  double apart(const Wall& wall, double z, const Edge& path) const;
  /// Whether p is within the outline of a feature.
  bool is_inside(int feature, Vec2 p) const;

  double height(Vec2 p) const;
  /// Whether p is in a thin sliver at height z: the material between two nearly touching features, which counts as
  /// free.
  bool is_sliver(Vec2 p, double z) const;
  /// Whether a point at height z is outside the finished part.
  bool is_free(Vec2 p, double z) const { return z >= top_z_ || height(p) <= z; }

  /// mm; depth of p inside the volume cleared by a single feature at height z, or beside the stock; negative outside
  /// of all: a lower bound of the distance from cleared places. Changes by no more than the displacement of p. Exact
  /// also for features that cut into walls with draft.
  double cleared_by(Vec2 p, double z) const;

  /// mm. Places nearer to an outline than this are on it.
  static constexpr double kProbe = 1e-5;

 private:
  struct Shape {
    int feature = -1;  ///< -1: everything beside the stock
    EdgeTree outline;
    Box box;
    double floor = 0;
    double top = 0;
    double slope = 0;
    double fillet = 0;   ///< radius to be left between the floor and the walls
    EdgeTree drafted;    ///< the edges whose walls have draft, if some have none
    bool single = true;  ///< whether it is one region: it is then only on the left of its edges
  };

  void add_feature(const Feature& feature, int index);
  void add_stock(const Stock& stock);
  void find_walls();
  void add_walls();
  void add_wall(const Edge& piece, const Shape& shape, int index);
  std::vector<double> cuts_of(const Edge& edge, int shape, const EdgeTree& all,
                              const std::vector<int>& owner) const;
  /// Whether the wall at a piece of the shape's outline has draft.
  static bool is_drafted_at(const Shape& shape, const Edge& piece);
  bool holds(const Shape& shape, Vec2 p) const;
  double height_in(const Shape& shape, Vec2 p) const;
  double cleared_in(const Shape& shape, Vec2 p, double z) const;
  double draft_offset_inside(const Wall& wall, double z, Vec2 p) const;
  void add_drafted_wall(const Edge& piece, int index, double left, double right);
  bool is_beside_stock(Vec2 p) const;
  double height_beside(Vec2 p, int own, bool inside_own) const;
  double fillet_at(const Wall& wall, Vec2 p, int own) const;

  std::vector<Shape> shapes_;
  std::vector<Wall> walls_, beyond_, slivers_;
  EdgeTree tree_, sliver_tree_;
  std::vector<double> heights_;
  double top_z_ = 0;
  double greatest_draft_offset_ = 0;
  double greatest_fillet_ = 0;
  std::optional<Box> stock_;
};

/// mm. Thickness up to which material counts as a thin sliver: the depth of a gouge that is no fault.
inline constexpr double kThinSliver = 0.001;

struct Slivers {
  std::vector<Wall> walls;    ///< walls without the thin slivers, divided at the ends of slivers
  std::vector<Wall> slivers;  ///< the pieces of walls with a thin sliver behind them, from z_low up
};

/// Separates walls from thin slivers. A line drawn twice, as the edge of two pockets, often differs by some
/// hundredths or tenths of a um, with alternating sides.
///
/// Cost    O(n log n) if no two walls are so near; else with the walls near each.
/// Error   Walls of one and the same feature have no slivers between them, nor have walls with draft.
Slivers parted(const std::vector<Wall>& walls);

/// The edges of walls, under their numbers.
EdgeTree tree_of(const std::vector<Wall>& walls);

}  // namespace clearcut::verify
