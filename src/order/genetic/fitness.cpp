#include "order/genetic/fitness.h"

#include <algorithm>
#include <array>

namespace clearcut::order {

Fitness::Fitness(const Moves& moves, const Objective& objective)
    : moves_(moves),
      objective_(objective),
      closed_(moves.problem().closed()),
      size_(moves.problem().size()),
      edge_stamps_(static_cast<std::size_t>(size_), 0),
      corner_stamps_(static_cast<std::size_t>(size_), 0) {}

int Fitness::wrapped(int position) const {
  return position < 0 ? position + size_ : position >= size_ ? position - size_ : position;
}

template <std::size_t N>
std::span<const int> Fitness::distinct(std::array<int, N>& positions, std::size_t count) const {
  const auto end = positions.begin() + static_cast<std::ptrdiff_t>(count);
  if (closed_) std::for_each(positions.begin(), end, [&](int& p) { p = wrapped(p); });
  std::sort(positions.begin(), end);
  return {positions.begin(), std::unique(positions.begin(), end)};
}

template <class At>
double Fitness::edge_at(int i, At at) const {
  return objective_.edge(moves_, at(i), at(wrapped(i + 1)));
}

template <class At>
double Fitness::corner_at(int i, At at) const {
  return objective_.corner(moves_, at(wrapped(i - 1)), at(i), at(wrapped(i + 1)));
}

void Fitness::complete(Individual& individual) const {
  individual.value = individual.local + objective_.constant();
  if (objective_.path_dependent()) individual.value += objective_.path(moves_, individual.genome.genes());
}

void Fitness::evaluate(Individual& individual) const {
  const Problem& problem = moves_.problem();
  const Tour& genes = individual.genome.genes();
  individual.local = 0;
  each_edge(problem, genes, [&](int a, int b) { individual.local += objective_.edge(moves_, a, b); });
  each_corner(problem, genes,
              [&](int a, int b, int c) { individual.local += objective_.corner(moves_, a, b, c); });
  complete(individual);
}

void Fitness::touch(int position) {
  for (const int edge : {position - 1, position}) {
    const int i = closed_ ? wrapped(edge) : edge;
    if (!is_edge(i) || edge_stamps_[static_cast<std::size_t>(i)] == stamp_) continue;
    edge_stamps_[static_cast<std::size_t>(i)] = stamp_;
    edges_.push_back(i);
  }
  for (const int corner : {position - 1, position, position + 1}) {
    const int i = closed_ ? wrapped(corner) : corner;
    if (!is_corner(i) || corner_stamps_[static_cast<std::size_t>(i)] == stamp_) continue;
    corner_stamps_[static_cast<std::size_t>(i)] = stamp_;
    corners_.push_back(i);
  }
}

double Fitness::local_after(const Individual& before, const Genome& after) {
  ++stamp_;
  edges_.clear();
  corners_.clear();
  for (int p = 0; p < size_; ++p) {
    if (before.genome.at(p) != after.at(p)) touch(p);
  }
  const auto old_at = [&](int p) { return before.genome.at(p); };
  const auto new_at = [&](int p) { return after.at(p); };
  double local = before.local;
  for (const int i : edges_) local += edge_at(i, new_at) - edge_at(i, old_at);
  for (const int i : corners_) local += corner_at(i, new_at) - corner_at(i, old_at);
  return local;
}

double Fitness::change_of_genes(const Genome& genome, const Rearrangement& r) const {
  const auto old_at = [&](int p) { return genome.at(p); };
  const auto new_at = [&](int p) {
    return p >= r.first && p <= r.last ? r.genes[static_cast<std::size_t>(p - r.first)] : genome.at(p);
  };
  // Around a closed tour the last edge and the outer corners may be the first ones again.
  const int edges = std::min(r.last - r.first + 2, size_), corners = std::min(r.last - r.first + 3, size_);
  double sum = 0;
  for (int k = 0; k < edges; ++k) {
    const int i = closed_ ? wrapped(r.first - 1 + k) : r.first - 1 + k;
    if (is_edge(i)) sum += edge_at(i, new_at) - edge_at(i, old_at);
  }
  for (int k = 0; k < corners; ++k) {
    const int i = closed_ ? wrapped(r.first - 1 + k) : r.first - 1 + k;
    if (is_corner(i)) sum += corner_at(i, new_at) - corner_at(i, old_at);
  }
  return sum;
}

double Fitness::change(const Genome& genome, const Rearrangement& r) const {
  using Kind = Rearrangement::Kind;
  if (r.kind == Kind::kNone) return 0;
  if (r.kind == Kind::kGenes) return change_of_genes(genome, r);
  const bool swaps = r.kind == Kind::kSwap;
  const auto old_at = [&](int p) { return genome.at(p); };
  const auto new_at = [&](int p) {
    if (swaps) return genome.at(p == r.first ? r.last : p == r.last ? r.first : p);
    return genome.at(p >= r.first && p <= r.last ? r.first + r.last - p : p);
  };
  // A reversed stretch keeps the edges and corners inside it.
  std::array<int, 4> edges{r.first - 1, r.last, r.first, r.last - 1};
  std::array<int, 6> corners{r.first - 1, r.first, r.last, r.last + 1, r.first + 1, r.last - 1};
  double sum = 0;
  for (const int i : distinct(edges, swaps ? 4 : 2)) {
    if (is_edge(i)) sum += edge_at(i, new_at) - edge_at(i, old_at);
  }
  for (const int i : distinct(corners, swaps ? 6 : 4)) {
    if (is_corner(i)) sum += corner_at(i, new_at) - corner_at(i, old_at);
  }
  return sum;
}

}  // namespace clearcut::order
