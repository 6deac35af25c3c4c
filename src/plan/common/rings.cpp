#include "plan/common/rings.h"

#include <algorithm>
#include <map>

#include "base/containers.h"
#include "base/error.h"

namespace clearcut::plan {
namespace {

/// mm. Curved pieces of the axis are replaced by chords within this distance.
constexpr double kAxisChord = 0.001;
/// mm. The axis is cut this much above a level, so that a neck exactly twice the level wide separates the axis in the
/// same places as the regions of that level.
constexpr double kLevelMargin = 0.0006;

/// mm. Regions up to this size may be specks of flattening: their distance to the boundary is checked.
constexpr double kSpeck = 0.05;

using Pieces = std::vector<AxisPiece>;

/// The medial axis in pieces, and the numbers of their ends.
class AxisCutter {
 public:
  /// The whole axis in straight pieces; the centre of a round pocket, a single point, is a piece without
  /// length.
  Pieces all_pieces(const Clearance& clearance) {
    Pieces pieces;
    const auto& axis = clearance.axis();
    std::vector<bool> lone(axis.points.size(), true);
    for (std::size_t i = 0; i < axis.edges.size(); ++i) {
      add_curve(axis.edges[i], clearance.axis_curve(static_cast<int>(i), kAxisChord), pieces);
      lone[static_cast<std::size_t>(axis.edges[i].a)] = lone[static_cast<std::size_t>(axis.edges[i].b)] =
          false;
    }
    for (std::size_t i = 0; i < lone.size(); ++i) {
      const int id = static_cast<int>(i);
      if (lone[i]) pieces.push_back({id, id, axis.points[i], axis.points[i]});
    }
    return pieces;
  }

  /// Removes from `pieces` the parts below `level` and returns them; pieces crossing the level are cut in two.
  Pieces split_off_below(Pieces& pieces, double level) {
    Pieces below, above;
    for (const auto& piece : pieces) {
      if (piece.high.clearance < level) {
        below.push_back(piece);
      } else if (piece.low.clearance >= level) {
        above.push_back(piece);
      } else {
        const double t = (level - piece.low.clearance) / (piece.high.clearance - piece.low.clearance);
        const AxisPoint cut{lerp(piece.low.point, piece.high.point, t), level};
        const int id = next_cut_id_--;
        below.push_back({piece.low_id, id, piece.low, cut});
        above.push_back({id, piece.high_id, cut, piece.high});
      }
    }
    pieces = std::move(above);
    return below;
  }

 private:
  void add_curve(const AxisEdge& edge, const std::vector<AxisPoint>& curve, Pieces& pieces) {
    int from = edge.a;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const int to = i + 1 == curve.size() ? edge.b : next_cut_id_--;
      const bool rises = curve[i].clearance >= curve[i - 1].clearance;
      pieces.push_back(rises ? AxisPiece{from, to, curve[i - 1], curve[i]}
                             : AxisPiece{to, from, curve[i], curve[i - 1]});
      from = to;
    }
  }

  int next_cut_id_ = -1;  ///< ends of pieces other than points of the axis have negative numbers
};

class TreeBuilder {
 public:
  TreeBuilder(const Clearance& clearance, const Region& domain, const StepOf& step_of, const Tolerances& tol)
      : clearance_(clearance), domain_(domain), step_of_(step_of), tol_(tol) {}

  std::vector<RingNode> build(double first_level) {
    add_children(-1, first_level, cutter_.all_pieces(clearance_));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double next = nodes_[i].level + step_of_(nodes_[i], inside_[i]);
      nodes_[i].next_level = next;
      Pieces pieces = std::move(inside_[i]);
      nodes_[i].gap = cutter_.split_off_below(pieces, next + kLevelMargin);
      add_children(static_cast<int>(i), next, std::move(pieces));
    }
    return std::move(nodes_);
  }

 private:
  const Regions& at_level(double level) {
    const auto found = insets_.find(level);
    if (found != insets_.end()) return found->second;
    return insets_.emplace(level, safe_inset(clearance_, domain_, level, tol_)).first->second;
  }

  /// The pieces in connected groups. The axis of a connected region is connected, so each group belongs to
  /// one region.
  std::vector<Pieces> groups_of(const Pieces& pieces) {
    int count = 0;
    const auto number_end = [&](int id) {
      int& number = number_of(id);
      if (number < 0) number = count++;
    };
    for (const auto& piece : pieces) {
      number_end(piece.low_id);
      number_end(piece.high_id);
    }
    DisjointSets sets(count);
    for (const auto& piece : pieces) sets.join(number_of(piece.low_id), number_of(piece.high_id));
    std::vector<int> group_of(static_cast<std::size_t>(count), -1);
    std::vector<Pieces> groups;
    for (const auto& piece : pieces) {
      int& group = group_of[static_cast<std::size_t>(sets.find(number_of(piece.low_id)))];
      if (group < 0) {
        group = static_cast<int>(groups.size());
        groups.emplace_back();
      }
      groups[static_cast<std::size_t>(group)].push_back(piece);
    }
    for (const auto& piece : pieces) number_of(piece.low_id) = number_of(piece.high_id) = -1;
    return groups;
  }

  /// The number assigned by groups_of to an end of pieces; -1 between its calls.
  int& number_of(int id) {
    const auto place = static_cast<std::size_t>(id >= 0 ? 2 * id : -2 * id - 1);
    if (place >= numbers_.size()) numbers_.resize(2 * place + 1, -1);
    return numbers_[place];
  }

  void add_children(int parent, double level, Pieces pieces) {
    if (parent < 0) cutter_.split_off_below(pieces, level + kLevelMargin);
    auto groups = groups_of(pieces);
    const auto& regions = at_level(level);
    std::map<std::size_t, int> node_of_region;
    for (auto& group : groups) {
      const std::size_t region = region_of(group, regions);
      if (region == regions.size()) {
        keep_in_gap(parent, group);
        continue;
      }
      const auto [it, added] = node_of_region.emplace(region, static_cast<int>(nodes_.size()));
      if (added) add_node(parent, level, regions[region]);
      auto& inside = inside_[static_cast<std::size_t>(it->second)];
      inside.insert(inside.end(), group.begin(), group.end());
    }
    for (std::size_t i = 0; i < regions.size(); ++i) {
      // A region so small that the axis inside is below the margin.
      if (node_of_region.count(i) == 0 && belongs_to(regions[i], parent)) add_node(parent, level, regions[i]);
    }
  }

  bool belongs_to(const Region& region, int parent) const {
    if (parent < 0) return true;
    const auto& contour = nodes_[static_cast<std::size_t>(parent)].contour;
    const Vec2 p = region.outer().front().from;
    return contour.box().contains(p) && contour.contains(p);
  }

  /// Keeps pieces above the level for which rounding left no region: their parent must clear them.
  void keep_in_gap(int parent, const Pieces& group) {
    if (parent < 0) return;  // these are lines on which the cutter just fits, see Clearance::fit_lines
    auto& gap = nodes_[static_cast<std::size_t>(parent)].gap;
    gap.insert(gap.end(), group.begin(), group.end());
  }

  void add_node(int parent, double level, const Region& contour) {
    if (parent >= 0)
      nodes_[static_cast<std::size_t>(parent)].children.push_back(static_cast<int>(nodes_.size()));
    const int depth = parent < 0 ? 0 : nodes_[static_cast<std::size_t>(parent)].depth + 1;
    nodes_.push_back({contour, level, level, parent, depth, {}, {}});
    inside_.emplace_back();
  }

  /// The region that contains the group's point of greatest clearance, or is within 1 um of this point; else
  /// regions.size().
  static std::size_t region_of(const Pieces& group, const Regions& regions) {
    const auto deepest = std::max_element(group.begin(), group.end(), [](const auto& a, const auto& b) {
      return a.high.clearance < b.high.clearance;
    });
    std::size_t best = regions.size();
    double best_distance = 1e-3;
    for (std::size_t i = 0; i < regions.size(); ++i) {
      if (!regions[i].box().grown(best_distance).contains(deepest->high.point)) continue;
      if (regions[i].contains(deepest->high.point)) return i;
      const double distance = regions[i].boundary_distance(deepest->high.point);
      if (distance < best_distance) {
        best_distance = distance;
        best = i;
      }
    }
    return best;
  }

  const Clearance& clearance_;
  const Region& domain_;
  const StepOf& step_of_;
  const Tolerances& tol_;
  std::vector<RingNode> nodes_;
  std::vector<Pieces> inside_;  ///< per node: the axis inside its contour, until its children are made
  std::map<double, Regions> insets_;
  AxisCutter cutter_;
  std::vector<int> numbers_;  ///< see number_of
};

}  // namespace

std::vector<AxisPiece> axis_below(const Clearance& clearance, double level) {
  AxisCutter cutter;
  Pieces pieces = cutter.all_pieces(clearance);
  return cutter.split_off_below(pieces, level + kLevelMargin);
}

Regions safe_inset(const Clearance& clearance, const Region& domain, double d, const Tolerances& tol) {
  Regions regions = clearance.inset(d);
  std::erase_if(regions, [&](const Region& region) {
    const Box box = region.box();
    if (std::max(box.width(), box.height()) > kSpeck) return false;
    return domain.boundary_distance(region.outer().front().from) < d - tol.gouge;
  });
  return regions;
}

std::vector<RingNode> ring_tree(const Clearance& clearance, const Region& domain, double first_level,
                                const StepOf& step_of, const Tolerances& tol) {
  return TreeBuilder(clearance, domain, step_of, tol).build(first_level);
}

}  // namespace clearcut::plan
