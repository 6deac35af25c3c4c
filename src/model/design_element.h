// Parts described by design elements on a grid of squares: lines, arcs, rectangular pockets, holes, slots.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "model/part.h"

namespace clearcut::inline model {

enum class ElementKind { kLine, kArc, kRectangle, kHole, kSlot };
/// "line", "arc", "rectangle", "hole", "slot": as in job files.
const char* name_of(ElementKind kind);

enum class Corner { kLowerLeft, kLowerRight, kUpperLeft, kUpperRight };

/// One element with its own tool and cutting data. Lengths in mm. The kind decides the meaning of the members:
///   line       the groove from `from` to `to` over all, as wide as the tool
///   arc        the same along the arc of `radius` in the sense of rotation `direction`, at most half a turn
///   rectangle  `length` along x, `width` along y, `from` is its `base` corner
///   hole       about `from`, `width` across
///   slot       between the centres of its round ends `from` and `to`, `width` across
struct DesignElement {
  std::string id;
  std::string source;  ///< "file:line"
  ElementKind kind = ElementKind::kRectangle;
  Vec2 from;
  Vec2 to;
  double radius = 0;
  Turn direction = Turn::kCounterClockwise;
  double length = 0;
  double width = 0;
  Corner base = Corner::kLowerLeft;
  int tool = 1;  ///< T word
  double depth = 0;
  std::optional<double> stepdown;
  CuttingData cutting;
};

/// The corner of a rectangle with the smallest x and y, whichever corner is its base.
Vec2 lower_left(const DesignElement& rectangle);

/// Treatment of the middle row of a rectangle if the edges moved inwards meet there.
enum class MiddleRow {
  kKeep,   ///< the middle row counts once: d3 >= 0
  kStrict  ///< as the paper's text says: d3 > 1, so the middle row is dropped
};

/// A whole job: stock, grid, tools and elements; element numbers are 1 + their place in `elements`.
struct ElementJob {
  std::string name;
  std::string source_file;
  Stock stock;
  double resolution = 1;  ///< side of a square, mm
  MiddleRow middle_row = MiddleRow::kKeep;
  std::vector<Tool> tools;
  std::vector<DesignElement> elements;
};

/// The tool named by an element, or null.
const Tool* tool_of(const ElementJob& job, const DesignElement& element);

/// A square of the grid by its column and row.
struct Square {
  int column = 0;
  int row = 0;
  friend auto operator<=>(const Square&, const Square&) = default;
};

/// Squares of `cell` mm with centres at whole multiples of `cell` from `origin`: the paper's workMat.
struct SquareGrid {
  Vec2 origin;
  double cell = 1;
  int columns = 0;
  int rows = 0;

  Square nearest(Vec2 p) const;
  Vec2 center(Square s) const { return origin + Vec2{s.column * cell, s.row * cell}; }
  bool holds(Square s) const { return s.column >= 0 && s.row >= 0 && s.column < columns && s.row < rows; }
};
/// The grid of a job: from the lower left corner of the stock to its upper right one.
SquareGrid grid_of(const ElementJob& job);

/// One line of the decision maker's table.
struct GridPoint {
  int element = 0;  ///< element number, from 1
  int tool = 0;     ///< T word
  Square square;
  Vec2 at;               ///< position of the tool's centre for this square, mm
  bool reduced = false;  ///< kept by the reduction: the tool must visit this square
  int visit = -1;        ///< place in the order of visits of the whole job, from 1; -1 if not visited
};

/// The decision maker: all points of all elements, element by element, in the order of interpolation.
struct PointTable {
  SquareGrid grid;
  std::vector<GridPoint> points;
};
std::size_t count_reduced(const PointTable& table);

}  // namespace clearcut::inline model
