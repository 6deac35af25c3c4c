// The part as it should come out: floors at their heights, and the walls between them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/part.h"
#include "verify/part/edge_tree.h"

namespace clearcut::verify {

/// A stretch of wall that stands between two floors: free on the left of `edge` above z_low, solid on its
/// right below z_high. Nothing else bounds where a cutter may be.
struct Wall {
  Edge edge;
  double z_low = 0;   ///< floor at the foot of the wall
  double z_high = 0;  ///< height of what stands behind it
  int feature = -1;   ///< whose outline it is; -1: the edge of the stock
  double top_z = 0;   ///< leaning walls: height at which the wall is at `edge`
  double slope = 0;   ///< tan of the angle it leans; at height z it stands (top_z - z) * slope inside `edge`
  bool flat_from = false;  ///< leaning walls: the side of the stock cuts what leans off square at this end
  bool flat_to = false;

  bool stands_at(double z) const { return z_low <= z && z < z_high; }
  double lean(double z) const { return slope > 0 ? std::max(0.0, top_z - z) * slope : 0.0; }
  /// What leans at height z as it shows at the flat ends: lines from or to the outline, free on their left.
  std::vector<Edge> flat_ends(double z) const;
};

/// Height of the part over the plan: the lowest floor of the features that allow the cutter at a place, else
/// the top; nothing beside the stock. The walls are found by cutting all outlines at each other and asking
/// for the height on both sides of every piece; walls that features share count once, edges between touching
/// pockets vanish.
///
/// Cost    build O(n log n + crossings); a question O(features * log n).
/// Error   walls thinner than 2 * kProbe are not seen. Where a deeper feature cuts into the leaning wall
///         of another, that wall is taken to stand there too.
class FinishedPart {
 public:
  explicit FinishedPart(const Part& part);

  double top_z() const { return top_z_; }
  const std::vector<Wall>& walls() const { return walls_; }
  const EdgeTree& wall_tree() const { return tree_; }
  /// All heights of floors and tops, ascending.
  const std::vector<double>& heights() const { return heights_; }
  /// Greatest lean of any wall at any height, mm.
  double greatest_lean() const { return greatest_lean_; }

  /// How far a wall at height z stands inside its outline for a cutter at p: leaning walls only do so towards
  /// the feature they bound.
  double lean(const Wall& wall, double z, Vec2 p) const {
    return wall.slope > 0 && z < wall.top_z && is_inside(wall.feature, p) ? lean_inside(wall, z, p) : 0.0;
  }
  /// Distance of a path (or place, from == to) from what stands of a wall at height z.
  double apart(const Wall& wall, double z, const Edge& path) const;
  /// Whether p lies within the outline of a feature.
  bool is_inside(int feature, Vec2 p) const;

  double height(Vec2 p) const;
  /// Whether a point at height z is outside the finished part.
  bool is_free(Vec2 p, double z) const { return z >= top_z_ || height(p) <= z; }

  /// mm. How far beside an edge the height is asked for.
  static constexpr double kProbe = 1e-5;

 private:
  struct Shape {
    int feature = -1;  ///< -1: everything beside the stock
    EdgeTree outline;
    Box box;
    double floor = 0;
    double top = 0;
    double slope = 0;
    bool single = true;  ///< one region: its edges have it on the left and not on the right
  };

  void add_feature(const Feature& feature, int index);
  void add_stock(const Stock& stock);
  void find_walls();
  void add_wall(const Edge& piece, const Shape& shape, int index);
  std::vector<double> cuts_of(const Edge& edge, int shape, const EdgeTree& all,
                              const std::vector<int>& owner) const;
  bool holds(const Shape& shape, Vec2 p) const;
  double height_in(const Shape& shape, Vec2 p) const;
  double lean_inside(const Wall& wall, double z, Vec2 p) const;
  void add_leaning_wall(const Edge& piece, const Shape& shape, double left, double right);
  bool is_beside_stock(Vec2 p) const;
  double height_beside(Vec2 p, int own, bool inside_own) const;

  std::vector<Shape> shapes_;
  std::vector<Wall> walls_;
  EdgeTree tree_;
  std::vector<double> heights_;
  double top_z_ = 0;
  double greatest_lean_ = 0;
  std::optional<Box> stock_;
};

}  // namespace clearcut::verify
