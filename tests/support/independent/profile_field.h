// A second opinion on the remaining stock: a field of heights that cutters lower by their true profiles. Shares no code with the
// product, and says of everything both what is certain and what is possible within its cells.
#pragma once

#include <limits>
#include <map>
#include <vector>

namespace clearcut::test_support {

/// A body of revolution: how it ends decides the height of its surface over its tip. mm, degrees.
struct TurnedBody {
  enum class End { kFlat, kRounded, kCone, kDisc } end = End::kFlat;
  double diameter = 0;  ///< of the widest
  double round = 0;     ///< kRounded: radius at the corner; half the diameter: a ball
  double angle = 0;     ///< kCone: between opposite flanks
  double tip = 0;       ///< kCone: diameter of the flat at its tip
  bool removes = true;  ///< tools that cut threads leave material within
  double height = 0;    ///< kDisc: of the disc
  double neck = 0;      ///< kDisc: diameter of what carries it

  /// Of a cone: mm up for each mm outwards.
  double steepness() const;
  /// Height of the surface over the tip at this distance from the axis; infinite beyond. `steep`: its steepness.
  double surface(double distance, double steep) const;
};

/// A straight way of the tip, or no way at all where it stands.
struct BodyWay {
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
};

class ProfileField {
 public:
  /// A block from (x0, y0) to (x1, y1) with its top at 0 and nothing below `bottom`.
  ProfileField(double x0, double y0, double x1, double y1, double cell,
               double bottom = -std::numeric_limits<double>::infinity());

  void cut(const TurnedBody& body, const BodyWay& way);

  struct Hit {
    double certain = 0;   ///< mm that material stands in the body over a whole cell; 0: perhaps none
    double possible = 0;  ///< mm at the most
  };
  Hit hit(const TurnedBody& body, const BodyWay& way) const;

  /// Height of what stands for certain all over the cell at a place, and of what may stand there at the most.
  double certain_at(double x, double y) const;
  double possible_at(double x, double y) const;
  double cell() const { return cell_; }

  /// mm of what stands for certain all over the cell at a place between two heights.
  double standing_at(double x, double y, double low, double high) const;

  /// A range of heights.
  struct Gap {
    double low = 0, high = 0;
  };
  /// What discs have certainly undercut in the cell at a place.
  std::vector<Gap> undercut_at(double x, double y) const;

 private:
  struct Cell {
    double certain = 0, possible = 0;
  };
  template <typename Matters, typename Visit>
  void along(const TurnedBody& body, const BodyWay& way, Matters matters, Visit visit) const;
  template <typename Visit>
  void near(const BodyWay& way, double reach, Visit visit) const;
  std::size_t index_of(double x, double y) const;
  double standing(std::size_t cell, double low, double high) const;

  double x0_, y0_, bottom_, cell_, half_;  ///< half_: of a cell's diagonal
  int columns_, rows_;
  std::vector<Cell> cells_;
  std::map<std::size_t, std::vector<Gap>> perhaps_undercut_, undercut_;  ///< by cell; gaps lie apart
};

}  // namespace clearcut::test_support
