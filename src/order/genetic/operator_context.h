// Data shared by all operators of a run: the points' legal neighbours and the changeable positions.
#pragma once

#include <vector>

#include "base/random.h"
#include "order/genetic/genome.h"
#include "order/moves.h"

namespace clearcut::order {

/// "The nearest N points to the gene, excluding any points that would result in an illegal edge"
/// (Tour 4.3.2). A point without legal near moves keeps its nearest neighbours, at the cost of the detour.
class LegalNeighbours {
 public:
  /// `count` per point; 0 or more than the number of points: all other points, without use of memory.
  LegalNeighbours(const Moves& moves, int count);

  /// Any of them, with equal chances; -1 when there is only one point.
  int pick(int gene, Random& random) const;
  /// Nearest first. When the neighbours are all points: only the nearest 24.
  const std::vector<int>& nearest(int gene) const { return lists_[static_cast<std::size_t>(gene)]; }

 private:
  const Moves& moves_;
  bool all_;
  std::vector<std::vector<int>> lists_;
};

struct OperatorContext {
  const Moves& moves;
  LegalNeighbours neighbours;
  int first = 0;  ///< changeable positions: first..last; fixed ends are outside
  int last = 0;

  OperatorContext(const Moves& on, int neighbour_count);
  bool closed() const { return moves.problem().closed(); }
  int free_count() const { return last - first + 1; }
  int any_position(Random& random) const {
    return first + static_cast<int>(random.below(static_cast<std::uint64_t>(free_count())));
  }
};

}  // namespace clearcut::order
