#include "read/repair/edge_index.h"

#include <algorithm>
#include <boost/function_output_iterator.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <limits>

namespace clearcut::read {
namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::d2::point_xy<double>;
using TreeBox = bg::model::box<TreePoint>;
using TreeItem = std::pair<TreeBox, EdgeId>;

TreeBox tree_box(const Box& box) {
  return {{box.min.x, box.min.y}, {box.max.x, box.max.y}};
}

}  // namespace

struct EdgeIndex::Tree {
  bg::index::rtree<TreeItem, bg::index::linear<16>> items;
};

EdgeIndex::EdgeIndex(const std::vector<Loop>& loops, double longest_box)
    : loops_(&loops), longest_box_(longest_box), tree_(std::make_unique<Tree>()) {
  std::vector<TreeItem> items;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t e = 0; e < loops[l].size(); ++e) {
      const EdgeId id{static_cast<int>(l), static_cast<int>(e)};
      for (const Box& box : boxes(id)) items.emplace_back(tree_box(box), id);
    }
  }
  tree_->items = decltype(tree_->items)(items);  // packed: built from all items at once
}

std::vector<Box> EdgeIndex::boxes(EdgeId id) const {
  const Edge& whole = edge(id);
  const double pieces = std::ceil(whole.length() / longest_box_);
  if (!(pieces > 1)) return {whole.box()};
  std::vector<Box> out;
  for (int i = 0; i < static_cast<int>(pieces); ++i)
    out.push_back(whole.part(i / pieces, (i + 1) / pieces).box());
  return out;
}

EdgeIndex::~EdgeIndex() = default;
EdgeIndex::EdgeIndex(EdgeIndex&&) noexcept = default;

void EdgeIndex::visit(const Box& box, const std::function<bool(EdgeId)>& visit) const {
  for (auto found = tree_->items.qbegin(bg::index::intersects(tree_box(box))); found != tree_->items.qend();
       ++found) {
    if (!visit(found->second)) return;
  }
}

std::vector<int> EdgeIndex::loops_around(Vec2 p) const {
  // Only edges level with p and not wholly to its left count in the winding about p.
  const Box ray{p, {std::numeric_limits<double>::max(), p.y}};
  std::vector<EdgeId> level;
  visit(ray, [&](EdgeId id) {
    level.push_back(id);
    return true;
  });
  std::sort(level.begin(), level.end());
  level.erase(std::unique(level.begin(), level.end()), level.end());
  std::vector<int> around;
  for (std::size_t i = 0; i < level.size();) {
    const int loop = level[i].loop;
    int turns = 0;
    for (; i < level.size() && level[i].loop == loop; ++i) turns += winding(edge(level[i]), p);
    if (turns != 0) around.push_back(loop);
  }
  return around;
}

}  // namespace clearcut::read
