#include <algorithm>
#include <optional>

#include "plan/spiral/turn.h"

namespace clearcut::plan::spiral {
namespace {

/// Indices of the islands of `outside` within `island`, an island of the node next inside.
std::vector<std::size_t> islands_within(const Loop& island, const Region& outside) {
  const Box where = box(island);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < outside.islands().size(); ++i) {
    const Vec2 p = outside.islands()[i].front().from;
    if (where.contains(p) && contains(island, p)) found.push_back(i);
  }
  return found;
}

class ChainBuilder {
 public:
  explicit ChainBuilder(const std::vector<RingNode>& nodes) : nodes_(nodes), island_chains_(nodes.size()) {}

  SpiralChains build() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      result_.chain_of_node.push_back(put(nodes_[i].contour.outer(), chain_before_outer(i), holder(i)));
      for (const auto& island : nodes_[i].contour.islands()) {
        // The chain of an island is beside the chain of the outer loop, not inside it.
        island_chains_[i].push_back(put(island, chain_before_island(i, island), holder(i)));
      }
    }
    return std::move(result_);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// Index of the chain of the outer loop of the node around; -1 for the outermost.
  int holder(std::size_t node) const {
    const int parent = nodes_[node].parent;
    return parent < 0 ? -1 : result_.chain_of_node[index(parent)];
  }

  std::optional<int> chain_before_outer(std::size_t node) const {
    const int parent = nodes_[node].parent;
    if (parent < 0 || nodes_[index(parent)].children.size() != 1) return std::nullopt;
    return result_.chain_of_node[index(parent)];
  }

  std::optional<int> chain_before_island(std::size_t node, const Loop& island) const {
    const int parent = nodes_[node].parent;
    if (parent < 0) return std::nullopt;
    const auto within = islands_within(island, nodes_[index(parent)].contour);
    if (within.size() != 1) return std::nullopt;
    return island_chains_[index(parent)][within.front()];
  }

  int put(const Loop& loop, std::optional<int> before, int around) {
    const int chain = before.value_or(static_cast<int>(result_.chains.size()));
    if (!before) result_.chains.push_back({{}, around});
    result_.chains[index(chain)].loops.push_back(loop);
    return chain;
  }

  const std::vector<RingNode>& nodes_;
  SpiralChains result_;
  std::vector<std::vector<int>> island_chains_;
};

}  // namespace

SpiralChains spiral_chains(const std::vector<RingNode>& nodes) {
  return ChainBuilder(nodes).build();
}

}  // namespace clearcut::plan::spiral
