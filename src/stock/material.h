// The remaining stock while a program runs, and the engagement of a cutter in it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "geometry/box.h"
#include "model/cutter_profile.h"
#include "model/move.h"
#include "stock/engagement_arcs.h"

namespace clearcut::stock {

/// The directions of the front half of a cutter's circle with material.
struct CutterEngagement {
  AngleSet angles;   ///< radians from the direction of travel, in [-pi/2, pi/2], positive to the left
  double angle = 0;  ///< radians, sum of the widths
  double left = 0;   ///< engaged radians to the left of the direction of travel
  double right = 0;  ///< engaged radians to the right
};

/// The engagement as a number, without directions; cheaper than CutterEngagement.
struct EngagementSize {
  double angle = 0;  ///< radians, sum of the widths
  int parts = 0;     ///< number of separate parts of the front half circle in material
};

/// The engagement as a number and its rate of change as the cutter advances. Exact, except at places where a part
/// just begins, ends or is divided.
struct EngagementTrend {
  EngagementSize size;
  EngagementChange change;
};

/// Angle and direction of the material on the whole circle.
struct CircleTouch {
  double angle = 0;  ///< radians, sum of the widths
  Vec2 toward;       ///< unit vector to the middle of the widest part
};

/// The remaining stock: a block, or unlimited material, minus the volumes swept by cutters so far.
///
/// Exact, without a raster: sweeps are kept as lines and arcs with a radius, and queries intersect circles
/// with their outlines. A cutter with its tip at or below a height removes everything above this height within its
/// radius; a cutter with its own profile removes the width of the profile at this height over its tip.
///
/// Own cutter: queries of engagement and depth take a cutter's circle at its tip. Earlier sweeps of the querying
/// cutter (`own`, its number from add_cutter) count with the same circle, because a cutter of equal shape leaves no
/// additional material between the two circles.
///
/// Cost    add: O(length / radius + 1). A query except in_reach: O(moves within two radii) in programs of any length.
class Material {
 public:
  /// `plan`: outline of the block in plan view; absent: material everywhere. The block extends down from z_top, mm.
  /// `radii`: radii of the cutters in later queries, mm, all > 0; queries with smaller ones are permitted, too.
  Material(std::optional<Box> plan, double z_top, const std::vector<double>& radii);

  /// Number for all cylindrical cutters.
  static constexpr int kCylinder = -1;
  /// Registers a cutter that removes the profile `removes`, with a circle of `circle` mm for queries of engagement;
  /// 0: no such queries. Returns its number, the same for the same cutter.
  int add_cutter(const CutterProfile& removes, double circle);

  /// Removes the volume swept by a cutter of `radius` mm along `move`.
  void add(const Move& move, double radius);
  /// Removes the volume swept along `move` by a cutter registered with add_cutter.
  void add_sweep(const Move& move, int cutter);

  /// Number of added pieces of moves.
  std::size_t sweeps() const { return sweeps_.size(); }
  /// Removes all but the first `sweeps` pieces: the volume of later ones is material again.
  void forget_beyond(std::size_t sweeps);

  /// Whether no material reaches above z at p.
  bool is_removed(Vec2 p, double z, int own = kCylinder) const;
  /// mm; height of the material at p: z_top, or the height of the lowest tip that passed over p, on ramps to 1e-6 mm;
  /// -infinity beside the block.
  double height(Vec2 p, int own = kCylinder) const;

  /// Engagement of a cutter at `center` moving along `direction` (of any length > 0) with its tip at z.
  CutterEngagement engagement(Vec2 center, Vec2 direction, double radius, double z) const;
  /// The engagement at parameter t of `move`, if the cutter has swept the move up to t; nothing of the move
  /// may have been added.
  CutterEngagement engagement(const Move& move, double t, double radius, int own = kCylinder) const;
  /// Only the total angle and the number of parts; cheaper.
  EngagementSize engagement_size(Vec2 center, Vec2 direction, double radius, double z) const;
  EngagementTrend engagement_trend(Vec2 center, Vec2 direction, double radius, double z) const;
  /// The parts of the whole circle in material, as absolute angles in [-pi, pi].
  AngleSet circle_in_material(Vec2 center, double radius, double z) const;
  /// Only the total angle and the direction of the widest part; nothing if the circle touches no material.
  /// Cheaper.
  std::optional<CircleTouch> circle_touch(Vec2 center, double radius, double z) const;

  /// A point within `radius` mm of `path` with material above z; nothing if there is none. Finds every piece of
  /// material that contains a square 0.02 mm wide, and most others; slivers no thicker than `sliver` mm between
  /// cleared areas do not count.
  ///
  /// Cost    O((sweeps near + length of their outlines / 0.02 mm) log); for long paths, or paths wider than the
  ///         announced cutters, O(all sweeps) for their boxes as well.
  std::optional<Vec2> in_reach(const Edge& path, double radius, double z, int own = kCylinder,
                               double sliver = 0) const;
  /// The same for a cutter of any profile with its tip at z: a point with material inside the cutter. Finds every
  /// piece of material that contains a square 0.04 mm wide.
  std::optional<Vec2> in_reach(const Edge& path, const CutterProfile& cutter, double z,
                               double sliver = 0) const;

  double z_top() const { return z_top_; }
  const std::optional<Box>& plan() const { return plan_; }

 private:
  struct Sweep {
    Edge path;  ///< a point if from == to; arcs turn by less than a third of a turn
    Swept shape;
    double z_from = 0;
    double z_to = 0;
    double z_low = 0;
    double z_high = 0;
    int cutter = kCylinder;
  };
  /// A cutter with a profile of its own.
  struct Cutter {
    CutterProfile removes;
    double circle;  ///< mm; circle for queries of engagement
  };
  /// The disc around a sweep, to rule most sweeps out quickly. Kept outside of the cells' lists: a sweep is in twenty
  /// and more of them, and the lists take most of the memory.
  struct Disc {
    double z_low;
    Vec2 middle;
    double reach;
  };
  /// Indices of sweeps, ascending.
  using List = std::vector<std::uint32_t>;
  /// Square cells, each with the sweeps touched by circles of up to `reach` mm around any of its points.
  struct Grid {
    explicit Grid(double largest) : reach(largest), cell(largest * 0.7) {}
    /// Cells by eight times eight, because queries and sweeps follow each other at small distances.
    static constexpr int kTileBits = 3;
    struct Tile {
      int x, y;
      std::array<List, std::size_t{1} << (2 * kTileBits)> cells;
    };
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    double reach;
    double cell;  ///< mm, side of a cell
    std::deque<Tile> tiles;
    /// Hash table of 2^(64 - shift) slots: the index of each tile.
    std::vector<std::uint32_t> table = std::vector<std::uint32_t>(64, kNone);
    int shift = 58;

    int place(double v) const;
    std::size_t slot_of(int tile_x, int tile_y) const;
    static std::size_t within_tile(int x, int y);
    const List* at(int x, int y) const;
    const List* at(Vec2 p) const { return at(place(p.x), place(p.y)); }
    List& list(int x, int y);
    void grow();
    void insert(const Sweep& sweep, std::uint32_t index);
    void remove(const Sweep& sweep, std::uint32_t index);
    template <typename F>
    void for_lists(const Swept& swept, const Edge& path, F&& f);
  };

  List sweeps_about(const Edge& path, double radius) const;
  friend class ProfileSearch;
  std::optional<Vec2> in_reach_of_profile(const Edge& path, const CutterProfile& cutter, double z,
                                          double sliver = 0) const;
  void add_pieces(const Move& move, double radius, int cutter);
  void add_piece(const Edge& path, double z_from, double z_to, double radius, int cutter);
  double radius_over(const Cutter& cutter, double above, bool is_own) const;
  template <typename F>
  void for_parts_at(const Sweep& sweep, double z, int own, F&& f) const;
  CutterProfile profile_of(const Sweep& sweep) const;
  double surface_over(const Sweep& sweep, Vec2 p, double apart, double aside, double below) const;
  double height_of_cylinder(const Sweep& sweep, Vec2 p) const;
  double height_of(const Sweep& sweep, Vec2 p, int own, double below) const;
  const Grid& grid_for(double radius) const;
  static Sweep make_sweep(const Edge& path, double z_from, double z_to, double radius);
  static std::optional<Sweep> below(const Sweep& sweep, double z);
  static void join(Sweep& last, Sweep& next);
  void remove_everything(EngagementArcs& arcs, Vec2 center, double radius, double z,
                         int own = kCylinder) const;
  void remove_outside(EngagementArcs& arcs, Vec2 center, double radius) const;

  std::optional<Box> plan_;
  double z_top_;
  std::vector<Grid> grids_;  ///< grids by ascending reach
  std::vector<Sweep> sweeps_;
  std::vector<Disc> discs_;  ///< discs around the sweeps
  std::vector<Cutter> cutters_;
};

}  // namespace clearcut::stock
