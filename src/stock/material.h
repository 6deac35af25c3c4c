// The remaining stock while a program runs, and the engagement of a cutter in it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/box.h"
#include "model/move.h"
#include "stock/angle_set.h"
#include "stock/engagement_arcs.h"

namespace clearcut::stock {

/// Which directions of the front half of a cutter's circle are in material.
struct CutterEngagement {
  AngleSet angles;   ///< radians from the direction of travel, in [-pi/2, pi/2], > 0 on the left
  double angle = 0;  ///< radians, sum of the widths
  double left = 0;   ///< radians of it on the left of the direction of travel
  double right = 0;  ///< and on the right
};

/// The engagement as a number, without directions: cheaper than CutterEngagement.
struct EngagementSize {
  double angle = 0;  ///< radians, sum of the widths
  int parts = 0;     ///< separate parts of the front half circle in material
};

/// The engagement as a number, and its rate of change as the cutter goes on. Exact, except at places where a part begins, ends
/// or is split just there.
struct EngagementTrend {
  EngagementSize size;
  EngagementChange change;
};

/// How much of a circle is in material, and where.
struct CircleTouch {
  double angle = 0;  ///< radians, sum of the widths
  Vec2 toward;       ///< unit, the middle of the widest part
};

/// The remaining stock: a block, or material without end, minus the volumes that flat-ended cutters have swept so far.
///
/// Exact: sweeps are kept as lines and arcs with a radius, questions are answered by intersecting circles
/// with their outlines; there is no raster. A cutter whose tip passes at or below z removes everything above.
///
/// Cost    add: O(length / radius + 1); a question: O(moves within two radii), whatever the program's length.
class Material {
 public:
  /// `plan` is the block's outline in plan view; absent: the material has no end sideways. Material reaches down from z_top. `radii` are those of
  /// the cutters that will be asked about (any smaller radius may be asked about too), mm, all > 0.
  Material(std::optional<Box> plan, double z_top, const std::vector<double>& radii);

  /// Takes away what a cutter of `radius` mm sweeps along `move`.
  void add(const Move& move, double radius);

  /// How many pieces of moves were added so far; and back to an earlier number: what later pieces swept is material again.
  std::size_t sweeps() const { return sweeps_.size(); }
  void forget_beyond(std::size_t sweeps);

  /// Whether no material reaches above z at p.
  bool is_removed(Vec2 p, double z) const;
  /// Height of the material at p: z_top, or the lowest tip that passed over p; -infinity beside the block. On
  /// ramps to 1e-6 mm.
  double height(Vec2 p) const;

  /// The front half circle of a cutter at `center` that moves along `direction` (any length > 0) with its tip
  /// at z.
  CutterEngagement engagement(Vec2 center, Vec2 direction, double radius, double z) const;
  /// The same at parameter t of `move`, for a cutter that has swept the move up to t (and nothing of it is
  /// added yet).
  CutterEngagement engagement(const Move& move, double t, double radius) const;
  /// Only the total angle and the number of parts: cheaper.
  EngagementSize engagement_size(Vec2 center, Vec2 direction, double radius, double z) const;
  EngagementTrend engagement_trend(Vec2 center, Vec2 direction, double radius, double z) const;
  /// The parts of the whole circle in material, as absolute angles in [-pi, pi].
  AngleSet circle_in_material(Vec2 center, double radius, double z) const;
  /// Only their total angle and the direction of the widest; absent where the circle touches nothing. Cheaper.
  std::optional<CircleTouch> circle_touch(Vec2 center, double radius, double z) const;

  /// A place within `radius` of `path` where material reaches above z; none where there is none. Finds every piece that holds
  /// a square 0.02 mm wide, and most others.
  ///
  /// Cost    O((sweeps near + length of their outlines / 0.02 mm) log).
  std::optional<Vec2> in_reach(const Edge& path, double radius, double z) const;

  double z_top() const { return z_top_; }
  const std::optional<Box>& plan() const { return plan_; }

 private:
  struct Sweep {
    Edge path;  ///< a point when from == to; arcs below a third of a turn
    Swept shape;
    double z_from = 0;
    double z_to = 0;
    double z_low = 0;
    double z_high = 0;
  };
  /// A sweep in a cell's list, with a disc around it: most are turned away by that.
  struct Entry {
    double z_low;
    Vec2 middle;
    double reach;
    int sweep;
  };
  /// Square cells, each with all sweeps that a circle of up to `reach` around any of its points may touch.
  struct Grid {
    explicit Grid(double largest) : reach(largest), cell(largest * 0.7) {}
    struct Cell {
      int x, y;
      std::vector<Entry> entries;
    };
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    double reach;
    double cell;  ///< mm
    std::vector<Cell> cells;
    /// Which cell is where: a hash table of 2^(64 - shift) places.
    std::vector<std::uint32_t> table = std::vector<std::uint32_t>(64, kNone);
    int shift = 58;

    int place(double v) const;
    std::size_t slot_of(int x, int y) const;
    const std::vector<Entry>* at(Vec2 p) const;
    std::vector<Entry>& list(int x, int y);
    void grow();
    void insert(const Sweep& sweep, const Entry& entry);
    void remove(const Sweep& sweep, int index);
    template <typename F>
    void for_lists(const Swept& swept, const Edge& path, F&& f);
  };

  void add_piece(const Edge& path, double z_from, double z_to, double radius);
  const Grid& grid_for(double radius) const;
  static Sweep make_sweep(const Edge& path, double z_from, double z_to, double radius);
  static std::optional<Sweep> below(const Sweep& sweep, double z);
  static void join(Sweep& last, Sweep& next);
  void remove_everything(EngagementArcs& arcs, Vec2 center, double radius, double z) const;
  void remove_outside(EngagementArcs& arcs, Vec2 center, double radius) const;

  std::optional<Box> plan_;
  double z_top_;
  std::vector<Grid> grids_;  ///< ascending reach
  std::vector<Sweep> sweeps_;
};

}  // namespace clearcut::stock
