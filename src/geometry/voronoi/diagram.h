// The segment Voronoi diagram of a region in flat arrays, its vertices corrected to the exact elements: the builder
// sees only sites on a grid and arcs as tangents.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "geometry/voronoi/sites.h"

namespace clearcut::inline geometry::voronoi {

/// `i` >= 0.
constexpr std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// A place of the diagram and its clearance.
struct Node {
  Vec2 point;
  double clearance = 0;
};

/// Half-edges come in pairs (2k, 2k + 1) of opposite directions: edge k. Half-edge h starts at node
/// origin[h] (-1: at infinity), has the cell cell[h] on its left, and next[h] runs on around that cell.
struct Diagram {
  Sites sites;
  std::vector<Node> nodes;
  std::vector<char> inside;  ///< per node: whether it is in the material to cut, away from the boundary
  std::vector<int> origin, next, cell;
  std::vector<int> critical;    ///< per edge: node of smallest or largest clearance strictly inside it, or -1
  std::vector<int> cell_start;  ///< per cell: one half-edge around it, -1 for degenerate cells
  std::vector<int> cell_element;  ///< per cell: its element; for doubled walls, the element on the left side
  std::vector<int> cell_back;     ///< per cell: element on the right side of a doubled wall, or -1
  std::vector<int> cell_segment;  ///< per cell: its segment, -1 for points
  /// Elements at nodes that are unequally far from their elements or nearer to another one, and elements that cross:
  /// if the set is empty, the topology is that of the exact boundary. (The topology of lines is always exact except
  /// for the rounding.)
  std::set<int> doubtful;
  double largest = 0;  ///< largest clearance inside

  int edge_count() const { return static_cast<int>(origin.size() / 2); }
  static int twin(int half_edge) { return half_edge ^ 1; }
  /// Element bounding the material in a cell near p.
  int element_near(int cell_index, Vec2 p) const;
  const Element& element(int i) const { return sites.elements[static_cast<std::size_t>(i)]; }
};

Diagram make_diagram(Sites sites, const Region& region);

/// Moves each inside node to the place equally far from its elements, by damped least squares, and sets its
/// clearance. If this fails, the elements of the node are added to diagram.doubtful.
void correct_nodes(Diagram& diagram);

}  // namespace clearcut::inline geometry::voronoi
