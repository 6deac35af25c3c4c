#include "order/genetic/operator_context.h"

#include <algorithm>

#include "order/length/neighbours.h"

namespace clearcut::order {

double shared_edges(const Genome& a, const Genome& b, bool closed, double enough) {
  const int n = a.size();
  const int edges = closed ? n : n - 1;
  if (edges <= 0) return 1;
  int shared = 0;
  for (int p = 0; p < edges; ++p) {
    shared += has_edge(b, a.at(p), a.at(p + 1 == n ? 0 : p + 1), closed) ? 1 : 0;
    if (shared > enough * edges) break;
  }
  return static_cast<double>(shared) / edges;
}

namespace {

constexpr int kListed = 24;  // two rings of a grid (Tour 4.3.2)

std::vector<int> legal_of(const Moves& moves, std::span<const int> near, int gene, int count) {
  std::vector<int> legal;
  for (const int other : near) {
    if (static_cast<int>(legal.size()) < count && moves.is_straight(gene, other)) legal.push_back(other);
  }
  const auto kept = static_cast<std::size_t>(std::min<int>(count, static_cast<int>(near.size())));
  return legal.empty() ? std::vector<int>(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept))
                       : legal;
}

}  // namespace

LegalNeighbours::LegalNeighbours(const Moves& moves, int count) : moves_(moves) {
  const Problem& problem = moves.problem();
  const int others = problem.size() - 1;
  all_ = count <= 0 || count >= others;
  const int listed = std::min(all_ ? kListed : count, others);
  if (listed <= 0) {
    lists_.resize(problem.points.size());
    return;
  }
  const int looked_at = moves.has_detours() ? std::min(2 * listed, others) : listed;
  const Neighbours near = nearest_neighbours(problem.points, looked_at);
  for (int v = 0; v < problem.size(); ++v) lists_.push_back(legal_of(moves, near.of(v), v, listed));
}

int LegalNeighbours::pick(int gene, Random& random) const {
  const auto n = static_cast<std::uint64_t>(lists_.size());
  if (n < 2) return -1;
  if (!all_) {
    const auto& list = nearest(gene);
    return list[random.below(list.size())];
  }
  constexpr int kDraws = 8;
  int other = gene;
  for (int draw = 0; draw < kDraws; ++draw) {
    other = static_cast<int>(random.below(n - 1));
    other += other >= gene ? 1 : 0;
    if (moves_.is_straight(gene, other)) break;
  }
  return other;
}

OperatorContext::OperatorContext(const Moves& on, int neighbour_count)
    : moves(on), neighbours(on, neighbour_count) {
  const Problem& problem = on.problem();
  first = problem.start >= 0 ? 1 : 0;
  last = problem.size() - 1 - (problem.end >= 0 ? 1 : 0);
}

}  // namespace clearcut::order
