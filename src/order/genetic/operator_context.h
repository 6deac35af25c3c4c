// An individual's genes, the points in visiting order (Tour 3.8). Data shared by all operators of a run, the points'
// legal neighbours and the changeable positions, and the operators by name: one list serves the command line, its
// messages and the studies.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "order/moves.h"
#include "order/problem.h"

namespace clearcut::order {

/// Positions first..last change places in pairs (reverse), only first and last do (swap), or they hold `genes`, which are those that
/// they held in another order.
struct Rearrangement {
  enum class Kind { kNone, kSwap, kReverse, kGenes };
  Kind kind = Kind::kNone;
  int first = 0;  ///< positions, first < last
  int last = 0;
  Tour genes = {};  ///< of kGenes
};

/// A permutation that also stores the position of each gene.
class Genome {
 public:
  Genome() = default;
  explicit Genome(Tour genes) { assign(std::move(genes)); }

  int size() const { return static_cast<int>(genes_.size()); }
  int at(int position) const { return genes_[static_cast<std::size_t>(position)]; }
  int place(int gene) const { return places_[static_cast<std::size_t>(gene)]; }
  const Tour& genes() const { return genes_; }

  /// `genes` must be a permutation of 0..n-1.
  void assign(Tour genes) {
    genes_ = std::move(genes);
    places_.resize(genes_.size());
    for (int p = 0; p < size(); ++p) places_[static_cast<std::size_t>(at(p))] = p;
  }
  void swap(int p, int q) {
    std::swap(genes_[static_cast<std::size_t>(p)], genes_[static_cast<std::size_t>(q)]);
    places_[static_cast<std::size_t>(at(p))] = p;
    places_[static_cast<std::size_t>(at(q))] = q;
  }
  void apply(const Rearrangement& change) {
    if (change.kind == Rearrangement::Kind::kSwap) swap(change.first, change.last);
    if (change.kind == Rearrangement::Kind::kReverse) {
      for (int p = change.first, q = change.last; p < q; ++p, --q) swap(p, q);
    }
    if (change.kind == Rearrangement::Kind::kGenes) {
      for (int p = change.first; p <= change.last; ++p)
        put(p, change.genes[static_cast<std::size_t>(p - change.first)]);
    }
  }

 private:
  void put(int position, int gene) {
    genes_[static_cast<std::size_t>(position)] = gene;
    places_[static_cast<std::size_t>(gene)] = position;
  }
  Tour genes_;
  std::vector<int> places_;
};

/// Whether a and b follow each other, in either direction.
inline bool has_edge(const Genome& genome, int a, int b, bool closed) {
  const int distance = std::abs(genome.place(a) - genome.place(b));
  return distance == 1 || (closed && distance == genome.size() - 1);
}

/// Share of the edges of `a` also in `b`, 0..1; stops counting above `enough`. O(n).
double shared_edges(const Genome& a, const Genome& b, bool closed, double enough = 1);

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

template <class Maker>
struct NamedMakers {
  std::string kind;
  std::vector<std::pair<std::string, Maker>> entries;

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : entries) all.push_back(entry.first);
    return all;
  }
  /// Throws InputError, listing the names.
  const Maker& at(const std::string& name) const {
    std::string known;
    for (const auto& entry : entries) {
      if (entry.first == name) return entry.second;
      known += (known.empty() ? "" : ", ") + entry.first;
    }
    throw InputError(kind, "'" + name + "' is unknown; use one of " + known);
  }
};

}  // namespace clearcut::order
