// The finished part: floors at their heights, and the walls between them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/part.h"
#include "verify/part/edge_tree.h"

namespace clearcut::verify {

/// A piece of wall between two floors: left of `edge` it is free above z_low, right of it solid below z_high.
/// Nothing else bounds where a cutter may be.
struct Wall {
  Edge edge;
  double z_low = 0;   ///< height of the floor at its foot
  double z_high = 0;  ///< height of what stands behind it
  int feature = -1;   ///< whose outline it is; -1: the edge of the stock
  double top_z = 0;   ///< of walls with draft: height at which the wall is at `edge`
  double slope = 0;   ///< tangent of the draft; at height z the wall is (top_z - z) * slope inside `edge`
  /// Of walls with draft: at this end the side of the stock cuts the wall off square.
  bool flat_from = false;
  bool flat_to = false;

  bool stands_at(double z) const { return z_low <= z && z < z_high; }
  double draft_offset(double z) const { return slope > 0 ? std::max(0.0, top_z - z) * slope : 0.0; }
  /// The ends of the wall at height z where the stock's side cuts it off: lines from or to the outline, free
  /// on their left.
  std::vector<Edge> flat_ends(double z) const;
};

/// Which features are taken as cut.
struct CutFeatures {
  bool threads = false;  ///< external threads, as their own mills may; all others must leave the boss whole
  std::optional<int> only_draft = {};  ///< of the features with draft only this one
  /// Those of T-slots whose roof is at this height or higher, mm, with all that stands over them.
  std::optional<double> undercuts_up_to = {};
};

/// Height of the part over the plan view: the lowest floor of the features that allow the cutter at a place,
/// else the top; nothing beside the stock. Walls are found by cutting all outlines at each other and
/// computing the height on both sides of every piece. Walls that features share count once; edges between
/// touching pockets vanish.
///
/// Cost    build O(n log n + crossings); a query O(features * log n).
///         What is no thicker than kFilm between two features is no wall.
/// Error   Of walls that crossings cut off, pieces shorter than 10 nm are not found.
///         Where another feature cuts into a wall with draft, that wall is taken to stand there, too; see FinishedParts.
class FinishedPart {
 public:
  explicit FinishedPart(const Part& part, const CutFeatures& cut = {});

  double top_z() const { return top_z_; }
  const std::vector<Wall>& walls() const { return walls_; }
  const EdgeTree& wall_tree() const { return tree_; }
  /// Outlines of features beside the stock, where nothing stands: what an allowance leaves on a wall it leaves on these, too, as
  /// far as it reaches into the stock.
  const std::vector<Wall>& outlines_beyond() const { return beyond_; }
  /// All heights of floors and tops, ascending.
  const std::vector<double>& heights() const { return heights_; }
  /// mm; the greatest distance of a wall with draft from its outline, at any height.
  double greatest_draft_offset() const { return greatest_draft_offset_; }

  /// mm; how far a wall at height z stands inside its outline for a cutter at p. Walls with draft do so only
  /// towards the feature that they bound.
  double draft_offset(const Wall& wall, double z, Vec2 p) const {
    return wall.slope > 0 && z < wall.top_z && is_inside(wall.feature, p) ? draft_offset_inside(wall, z, p)
                                                                          : 0.0;
  }
  /// mm; distance from a path (or point, from == to) to a wall at height z.
  double apart(const Wall& wall, double z, const Edge& path) const;
  /// Whether p lies within the outline of a feature.
  bool is_inside(int feature, Vec2 p) const;

  double height(Vec2 p) const;
  /// Whether p lies in a film at height z: what two features that all but touch leave standing, which counts as free.
  bool is_film(Vec2 p, double z) const;
  /// Whether a point at height z is outside the finished part.
  bool is_free(Vec2 p, double z) const { return z >= top_z_ || height(p) <= z; }

  /// mm by which p lies within what some one feature clears at height z, or beside the stock; below 0 where none does: as far as p is at
  /// least from anything cleared. Changes by no more than p moves. Exact also where features cut into walls with draft.
  double cleared_by(Vec2 p, double z) const;

  /// mm. Places that are nearer to an outline than this lie on it.
  static constexpr double kProbe = 1e-5;

 private:
  struct Shape {
    int feature = -1;  ///< -1: everything beside the stock
    EdgeTree outline;
    Box box;
    double floor = 0;
    double top = 0;
    double slope = 0;
    EdgeTree drafted;    ///< the edges whose walls have draft, if some have none
    bool single = true;  ///< whether it is one region: its edges then have it on their left only
  };

  void add_feature(const Feature& feature, int index);
  void add_stock(const Stock& stock);
  void find_walls();
  void add_wall(const Edge& piece, const Shape& shape, int index);
  std::vector<double> cuts_of(const Edge& edge, int shape, const EdgeTree& all,
                              const std::vector<int>& owner) const;
  /// Whether the wall at a piece of the shape's outline has draft.
  static bool is_drafted_at(const Shape& shape, const Edge& piece);
  bool holds(const Shape& shape, Vec2 p) const;
  double height_in(const Shape& shape, Vec2 p) const;
  double cleared_in(const Shape& shape, Vec2 p, double z) const;
  double draft_offset_inside(const Wall& wall, double z, Vec2 p) const;
  void add_drafted_wall(const Edge& piece, const Shape& shape, double left, double right);
  bool is_beside_stock(Vec2 p) const;
  double height_beside(Vec2 p, int own, bool inside_own) const;

  std::vector<Shape> shapes_;
  std::vector<Wall> walls_, beyond_, films_;
  EdgeTree tree_, film_tree_;
  std::vector<double> heights_;
  double top_z_ = 0;
  double greatest_draft_offset_ = 0;
  std::optional<Box> stock_;
};

}  // namespace clearcut::verify
