#include "plan/contour/skeleton/polish.h"

#include <algorithm>

#include "geometry/spatial/cell_grid.h"
#include "plan/common/cover.h"

namespace clearcut::plan::contour {
namespace {

/// mm. A place counts as cleared by a vertex if it is this much nearer than the radius; places on the margin of being
/// cleared by other edges are left to the exact search.
constexpr double kWithin = 1e-6;

/// Drops vertices of one path after the other, each from its first vertex to its last.
class Polish {
 public:
  Polish(Bands& paths, const TightenJob& job, double radius) : paths_(paths), job_(job), radius_(radius) {}

  void run() {
    EdgesInUse state(2 * job_.radius);
    for (const auto& edge : paths_.fixed) state.add(edge);
    std::vector<std::uint32_t> first_edges;
    paths_.for_paths([&](const std::vector<int>& path) {
      first_edges.push_back(static_cast<std::uint32_t>(state.edges.size()));
      for (std::size_t i = 1; i < path.size(); ++i)
        state.add(Edge::line(paths_.point(path[i - 1]), paths_.point(path[i])));
    });
    std::size_t next_path = 0;
    paths_.for_paths([&](std::vector<int>& path) { polish(path, first_edges[next_path++], state); });
    paths_.list();
  }

 private:
  /// All edges while vertices are dropped, flags of the edges in use, and an index of their places.
  struct EdgesInUse {
    explicit EdgesInUse(double cell) : index(cell) {}
    std::vector<Edge> edges;
    std::vector<char> used;
    BoxIndex index;

    std::uint32_t add(const Edge& edge) {
      const auto number = static_cast<std::uint32_t>(edges.size());
      edges.push_back(edge);
      used.push_back(edge.from == edge.to ? 0 : 1);
      index.add(edge.from == edge.to ? Box{edge.from, edge.to} : edge.box(), number);
      return number;
    }
  };

  /// `edge`: the number of the path's first edge; the others follow it.
  void polish(std::vector<int>& path, std::uint32_t edge, EdgesInUse& state) const {
    std::vector<int> kept;
    std::uint32_t arriving = edge;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const std::uint32_t leaving = edge + static_cast<std::uint32_t>(i);
      if (i > 0 && i + 1 < path.size() && may_drop(arriving, leaving, state)) {
        state.used[arriving] = state.used[leaving] = 0;
        arriving = state.add(Edge::line(paths_.point(kept.back()), paths_.point(path[i + 1])));
      } else {
        kept.push_back(path[i]);
        arriving = leaving;
      }
    }
    path = std::move(kept);
  }

  /// Whether one straight edge in place of two successive ones clears everything cleared by them.
  bool may_drop(std::uint32_t arriving, std::uint32_t leaving, const EdgesInUse& state) const {
    const Edge first = state.edges[arriving], second = state.edges[leaving];
    if (first.from == first.to || second.from == second.to) return true;
    if (distance(first.from, second.to) < 1e-6 || !job_.legal->holds_line(first.from, second.to))
      return false;
    Box both = first.box();
    both.add(second.box());
    const Box near = both.grown(2 * radius_);
    std::vector<Edge> edges{Edge::line(first.from, second.to)};
    for (const std::uint32_t i : state.index.near(near)) {
      if (state.used[i] && i != arriving && i != leaving && near.overlaps(state.edges[i].box())) {
        edges.push_back(state.edges[i]);
      }
    }
    if (uncovers_outer_side(first, second, edges)) return false;
    const auto was_cut = [&](Vec2 q) {
      return (distance(first, q) <= radius_ || distance(second, q) <= radius_) && job_.matters(q);
    };
    return !Cover(edges, radius_).has_hole(both.grown(radius_), was_cut);
  }

  /// Whether the place cleared by the vertex between two edges that is farthest from the replacing line is left by
  /// all of `edges`: decides most vertices, and is cheaper than a search for all holes.
  bool uncovers_outer_side(const Edge& first, const Edge& second, const std::vector<Edge>& edges) const {
    const Vec2 along = second.to - first.from, to_vertex = first.to - first.from;
    const double side = cross(along, to_vertex);
    const Vec2 outwards = left_of(unit(along)) * (side < 0 ? -1.0 : 1.0);
    const Vec2 place = first.to + outwards * (radius_ - kWithin);
    const double reach = radius_ + kWithin;
    return job_.matters(place) && std::none_of(edges.begin(), edges.end(), [&](const Edge& edge) {
             return norm_squared(place - nearest_point(edge, place)) <= reach * reach;
           });
  }

  Bands& paths_;
  const TightenJob& job_;
  double radius_;
};

}  // namespace

void drop_needless_vertices(Bands& paths, const TightenJob& job, double radius) {
  Polish(paths, job, radius).run();
}

}  // namespace clearcut::plan::contour
