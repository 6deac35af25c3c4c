#include <array>

#include "order/genetic/crossover.h"

namespace clearcut::order {

namespace {

/// Genes not yet used, drawn and taken out in O(1).
class Unused {
 public:
  void fill(const Tour& genes) {
    genes_ = genes;
    places_.resize(genes.size());
    for (std::size_t i = 0; i < genes.size(); ++i)
      places_[static_cast<std::size_t>(genes[i])] = static_cast<int>(i);
  }
  bool has(int gene) const { return places_[static_cast<std::size_t>(gene)] >= 0; }
  int any(Random& random) const { return genes_[random.below(genes_.size())]; }
  void take(int gene) {
    const auto place = static_cast<std::size_t>(places_[static_cast<std::size_t>(gene)]);
    genes_[place] = genes_.back();
    places_[static_cast<std::size_t>(genes_[place])] = static_cast<int>(place);
    places_[static_cast<std::size_t>(gene)] = -1;
    genes_.pop_back();
  }

 private:
  Tour genes_;
  std::vector<int> places_;
};

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
  Unused unused_;
  Tour genes_;
};

}  // namespace

std::unique_ptr<Crossover> erx(const OperatorContext& context) {
  return std::make_unique<Erx>(context);
}

}  // namespace clearcut::order
