#include <algorithm>
#include <array>

#include "order/genetic/crossover.h"
#include "order/genetic/crossover/unused_genes.h"

namespace clearcut::order {

namespace {

class Erx final : public Crossover {
 public:
  explicit Erx(const OperatorContext& context) : context_(context) {}

  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) override {
    unused_.fill(first.genes());
    genes_.clear();
    for (int p = 0; p < context_.first; ++p) add(first.at(p));
    const int end = context_.last + 1 < first.size() ? first.at(context_.last + 1) : -1;
    if (end >= 0) unused_.take(end);
    while (static_cast<int>(genes_.size()) <= context_.last) {
      add(genes_.empty() ? unused_.any(random) : next(first, second, random));
    }
    if (end >= 0) genes_.push_back(end);
    child.assign(genes_);
  }

 private:
  void add(int gene) {
    genes_.push_back(gene);
    unused_.take(gene);
  }
  int next(const Genome& first, const Genome& second, Random& random) const {
    std::array<int, 4> edges{}, legal{};
    std::uint64_t edge_count = 0, legal_count = 0;
    const int gene = genes_.back();
    for (const Genome* parent : {&first, &second}) {
      for (const int step : {-1, 1}) {
        const int other = neighbour(*parent, gene, step);
        if (other < 0 || !unused_.has(other)) continue;
        edges[edge_count++] = other;
        if (context_.moves.is_straight(gene, other)) legal[legal_count++] = other;
      }
    }
    if (legal_count > 0) return legal[random.below(legal_count)];
    return edge_count > 0 ? edges[random.below(edge_count)] : unused_.any(random);
  }
  int neighbour(const Genome& genome, int gene, int step) const {
    const int p = genome.place(gene) + step;
    if (p >= 0 && p < genome.size()) return genome.at(p);
    return context_.closed() ? genome.at(p < 0 ? genome.size() - 1 : 0) : -1;
  }

  const OperatorContext& context_;
  UnusedGenes unused_;
  Tour genes_;
};

}  // namespace

std::vector<int> genetic_edges(const Genome& first, const Genome& second, int gene) {
  std::vector<int> edges;
  for (const Genome* parent : {&first, &second})
    for (const int step : {parent->size() - 1, 1})
      edges.push_back(parent->at((parent->place(gene) + step) % parent->size()));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::unique_ptr<Crossover> erx(const OperatorContext& context) {
  return std::make_unique<Erx>(context);
}

}  // namespace clearcut::order
