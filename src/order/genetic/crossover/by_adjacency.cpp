// Crossovers of the adjacency representation that Tour 3.6.2 (b.3) lists: the child is built move by move.
#include <algorithm>
#include <array>

#include "order/genetic/crossover/unused_genes.h"
#include "order/genetic/operators.h"

namespace clearcut::order {

namespace {

/// What follows a gene in a parent; -1: nothing.
int follower(const Genome& parent, int gene, bool closed) {
  const int p = parent.place(gene) + 1;
  if (p < parent.size()) return parent.at(p);
  return closed ? parent.at(0) : -1;
}

/// Begins at any gene (at a fixed end where there is one); where the next gene is used up, any other.
class MoveByMove : public Crossover {
 public:
  explicit MoveByMove(const OperatorContext& context) : context_(context) {}

  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) final {
    unused_.fill(first.genes());
    genes_.clear();
    begin(random);
    for (int p = 0; p < context_.first; ++p) add(first.at(p));
    const int end = context_.last + 1 < first.size() ? first.at(context_.last + 1) : -1;
    if (end >= 0) unused_.take(end);
    while (static_cast<int>(genes_.size()) <= context_.last) {
      const int gene = genes_.empty() ? -1 : next(first, second, random);
      add(gene >= 0 ? gene : unused_.any(random));
    }
    if (end >= 0) genes_.push_back(end);
    child.assign(genes_);
  }

 protected:
  virtual void begin(Random& /*random*/) {}
  /// An unused gene, or -1.
  virtual int next(const Genome& first, const Genome& second, Random& random) = 0;

  int last() const { return genes_.back(); }
  /// What follows the last gene in a parent, where it is not used.
  int unused_follower(const Genome& parent) const {
    const int gene = follower(parent, last(), context_.closed());
    return gene >= 0 && unused_.has(gene) ? gene : -1;
  }
  const OperatorContext& context() const { return context_; }

 private:
  void add(int gene) {
    genes_.push_back(gene);
    unused_.take(gene);
  }
  const OperatorContext& context_;
  UnusedGenes unused_;
  Tour genes_;
};

/// HX, HC: the shorter of the two moves that the parents make from here.
class Shorter final : public MoveByMove {
  using MoveByMove::MoveByMove;
  int next(const Genome& first, const Genome& second, Random& /*random*/) override {
    const int a = unused_follower(first), b = unused_follower(second);
    if (a < 0 || b < 0) return a < 0 ? b : a;
    return context().moves.length(last(), a) <= context().moves.length(last(), b) ? a : b;
  }
};

/// AER: moves of the first and the second parent in turn.
class InTurn final : public MoveByMove {
  using MoveByMove::MoveByMove;
  void begin(Random& random) override { is_first_ = random.below(2) == 1; }
  int next(const Genome& first, const Genome& second, Random& /*random*/) override {
    is_first_ = !is_first_;
    return unused_follower(is_first_ ? first : second);
  }
  bool is_first_ = true;
};

/// SCX: a random number of moves of one parent, then of the other.
class Chunks final : public MoveByMove {
  using MoveByMove::MoveByMove;
  void begin(Random& random) override {
    is_first_ = random.below(2) == 1;
    left_ = 0;
  }
  int next(const Genome& first, const Genome& second, Random& random) override {
    if (left_ == 0) {
      is_first_ = !is_first_;
      left_ = 1 + random.below(static_cast<std::uint64_t>(first.size()) / 2 + 1);
    }
    --left_;
    return unused_follower(is_first_ ? first : second);
  }
  bool is_first_ = true;
  std::uint64_t left_ = 0;
};

}  // namespace

std::unique_ptr<Crossover> hx(const OperatorContext& context) {
  return std::make_unique<Shorter>(context);
}
std::unique_ptr<Crossover> aer(const OperatorContext& context) {
  return std::make_unique<InTurn>(context);
}
std::unique_ptr<Crossover> scx(const OperatorContext& context) {
  return std::make_unique<Chunks>(context);
}

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
