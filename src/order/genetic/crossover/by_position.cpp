// Crossovers of the path representation that Tour 3.6.2 (b.2) lists besides those of 4.3.3, by the rules of [larranaga1999].
#include <algorithm>
#include <numeric>

#include "order/genetic/operators.h"

namespace clearcut::order {

namespace {

/// Rearranges the genes between fixed ends, which both parents have in the same places.
class OfFreeGenes : public Crossover {
 public:
  explicit OfFreeGenes(const OperatorContext& context) : context_(context) {}

  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) final {
    genes_ = first.genes();
    const auto begin = genes_.begin() + context_.first, end = genes_.begin() + context_.last + 1;
    first_.assign(begin, end);
    second_.assign(second.genes().begin() + context_.first, second.genes().begin() + context_.last + 1);
    taken_.assign(genes_.size(), 0);
    child_.clear();
    mix(random);
    std::copy(child_.begin(), child_.end(), begin);
    child.assign(genes_);
  }

 protected:
  /// Fills child_ from first_ and second_; taken_ is 0 for all genes.
  virtual void mix(Random& random) = 0;

  std::size_t count() const { return first_.size(); }
  std::size_t any(Random& random) const { return random.below(count()); }
  bool is_taken(int gene) const { return taken_[static_cast<std::size_t>(gene)] != 0; }
  void take(int gene) { taken_[static_cast<std::size_t>(gene)] = 1; }
  /// Two positions, the lower one first.
  std::pair<std::size_t, std::size_t> stretch(Random& random) const {
    const std::size_t a = any(random), b = any(random);
    return {std::min(a, b), std::max(a, b)};
  }
  /// Genes of `from` that are not taken, in its order, into the places of child_ that hold -1, from position `begin` on and around.
  void fill_gaps(const Tour& from, std::size_t begin) {
    std::size_t to = begin;
    for (std::size_t i = 0; i < count(); ++i) {
      const int gene = from[(begin + i) % count()];
      if (is_taken(gene)) continue;
      while (child_[to % count()] >= 0) ++to;
      child_[to % count()] = gene;
    }
  }

  Tour first_, second_, child_;

 private:
  const OperatorContext& context_;
  Tour genes_;
  std::vector<char> taken_;
};

/// OX1.
class OrderFromTheCut final : public OfFreeGenes {
  using OfFreeGenes::OfFreeGenes;
  void mix(Random& random) override {
    const auto [low, high] = stretch(random);
    child_.assign(count(), -1);
    for (std::size_t p = low; p <= high; ++p) take(child_[p] = second_[p]);
    fill_gaps(first_, (high + 1) % count());
  }
};

/// OX2.
class OrderBased final : public OfFreeGenes {
  using OfFreeGenes::OfFreeGenes;
  void mix(Random& random) override {
    chosen_.clear();
    for (const int gene : second_)
      if (random.below(2) == 1) take(gene), chosen_.push_back(gene);
    std::size_t next = 0;
    for (const int gene : first_) child_.push_back(is_taken(gene) ? chosen_[next++] : gene);
  }
  Tour chosen_;
};

/// POS.
class PositionBased final : public OfFreeGenes {
  using OfFreeGenes::OfFreeGenes;
  void mix(Random& random) override {
    child_.assign(count(), -1);
    for (std::size_t p = 0; p < count(); ++p)
      if (random.below(2) == 1) take(child_[p] = second_[p]);
    fill_gaps(first_, 0);
  }
};

/// MPX.
class MaximalPreservative final : public OfFreeGenes {
  using OfFreeGenes::OfFreeGenes;
  void mix(Random& random) override {
    constexpr std::size_t kShortest = 10;
    const std::size_t longest = std::max<std::size_t>(1, count() / 2),
                      shortest = std::min(kShortest, longest);
    const std::size_t length = shortest + random.below(longest - shortest + 1);
    const std::size_t begin = random.below(count() - length + 1);
    for (std::size_t i = 0; i < length; ++i) {
      child_.push_back(second_[begin + i]);
      take(child_.back());
    }
    for (const int gene : first_)
      if (!is_taken(gene)) child_.push_back(gene);
  }
};

/// VR, of two parents: both have to agree.
class Voting final : public OfFreeGenes {
  using OfFreeGenes::OfFreeGenes;
  void mix(Random& random) override {
    child_.assign(count(), -1);
    rest_.clear();
    for (std::size_t p = 0; p < count(); ++p) {
      if (first_[p] == second_[p])
        take(child_[p] = first_[p]);
      else
        rest_.push_back(first_[p]);
    }
    for (std::size_t i = rest_.size(); i > 1; --i) std::swap(rest_[i - 1], rest_[random.below(i)]);
    std::size_t next = 0;
    for (int& gene : child_)
      if (gene < 0) gene = rest_[next++];
  }
  Tour rest_;
};

/// AP.
class Alternating final : public OfFreeGenes {
  using OfFreeGenes::OfFreeGenes;
  void mix(Random& random) override {
    const bool begins_with_second = random.below(2) == 1;
    const Tour& a = begins_with_second ? second_ : first_;
    const Tour& b = begins_with_second ? first_ : second_;
    for (std::size_t p = 0; p < count(); ++p) add(a[p]), add(b[p]);
  }
  void add(int gene) {
    if (is_taken(gene)) return;
    child_.push_back(gene);
    take(gene);
  }
};

/// UPMX.
class UniformPartiallyMapped final : public Crossover {
 public:
  explicit UniformPartiallyMapped(const OperatorContext& context) : context_(context) {}
  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) override {
    constexpr int kShare = 3;  // a third of the positions
    child = first;
    for (int i = 0; i < 1 + context_.free_count() / kShare; ++i) {
      const int p = context_.any_position(random);
      if (child.at(p) != second.at(p)) child.swap(p, child.place(second.at(p)));
    }
  }

 private:
  const OperatorContext& context_;
};

/// Sorted match crossover (SMX): exchanges stretches that run through the same places between the same ends, the shorter for the longer.
class SortedMatch final : public Crossover {
 public:
  explicit SortedMatch(const OperatorContext& context) : context_(context) {}
  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) override {
    constexpr int kBegins = 20;  // stretches are looked for from so many places
    child = first;
    for (int i = 0; i < kBegins; ++i)
      if (exchange_from(context_.any_position(random), first, second, child)) return;
  }

 private:
  /// The shortest stretch from `begin` on that the second parent runs through between the same ends; the shorter order of the two.
  bool exchange_from(int begin, const Genome& first, const Genome& second, Genome& child) const {
    int low = second.place(first.at(begin)), high = low;
    for (int end = begin + 1; end <= context_.last; ++end) {
      const int place = second.place(first.at(end));
      low = std::min(low, place), high = std::max(high, place);
      if (high - low != end - begin || end - begin < 3) continue;
      const bool runs_forward = second.at(low) == first.at(begin) && second.at(high) == first.at(end);
      const bool runs_backward = second.at(high) == first.at(begin) && second.at(low) == first.at(end);
      if (!runs_forward && !runs_backward) continue;
      Tour genes = first.genes();
      for (int p = begin; p <= end; ++p)
        genes[static_cast<std::size_t>(p)] = second.at(runs_forward ? low + p - begin : high - (p - begin));
      if (length(genes, begin, end) < length(first.genes(), begin, end)) child.assign(std::move(genes));
      return true;
    }
    return false;
  }
  double length(const Tour& genes, int begin, int end) const {
    double sum = 0;
    for (int p = begin; p < end; ++p)
      sum +=
          context_.moves.length(genes[static_cast<std::size_t>(p)], genes[static_cast<std::size_t>(p) + 1]);
    return sum;
  }
  const OperatorContext& context_;
};

}  // namespace

std::unique_ptr<Crossover> ox1(const OperatorContext& context) {
  return std::make_unique<OrderFromTheCut>(context);
}
std::unique_ptr<Crossover> ox2(const OperatorContext& context) {
  return std::make_unique<OrderBased>(context);
}
std::unique_ptr<Crossover> pos(const OperatorContext& context) {
  return std::make_unique<PositionBased>(context);
}
std::unique_ptr<Crossover> mpx(const OperatorContext& context) {
  return std::make_unique<MaximalPreservative>(context);
}
std::unique_ptr<Crossover> vr(const OperatorContext& context) {
  return std::make_unique<Voting>(context);
}
std::unique_ptr<Crossover> ap(const OperatorContext& context) {
  return std::make_unique<Alternating>(context);
}
std::unique_ptr<Crossover> upmx(const OperatorContext& context) {
  return std::make_unique<UniformPartiallyMapped>(context);
}
std::unique_ptr<Crossover> smx(const OperatorContext& context) {
  return std::make_unique<SortedMatch>(context);
}

namespace {

class Cx final : public Crossover {
 public:
  explicit Cx(const OperatorContext& context) : context_(context) {}

  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) override {
    genes_ = first.genes();
    const int begin = context_.any_position(random);
    int p = begin;
    do {
      genes_[static_cast<std::size_t>(p)] = second.at(p);
      p = first.place(second.at(p));
    } while (p != begin);
    child.assign(genes_);
  }

 private:
  const OperatorContext& context_;
  Tour genes_;
};

}  // namespace

std::unique_ptr<Crossover> cx(const OperatorContext& context) {
  return std::make_unique<Cx>(context);
}

namespace {

class Ox final : public Crossover {
 public:
  explicit Ox(const OperatorContext& context) : context_(context) {}

  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) override {
    const auto [low, high] = std::minmax({context_.any_position(random), context_.any_position(random)});
    genes_ = first.genes();
    int to = 0;
    for (int from = 0; from < first.size(); ++from) {
      const int place = second.place(first.at(from));
      if (place >= low && place <= high) continue;  // will be taken from the second parent
      if (to == low) to = high + 1;
      genes_[static_cast<std::size_t>(to++)] = first.at(from);
    }
    for (int p = low; p <= high; ++p) genes_[static_cast<std::size_t>(p)] = second.at(p);
    child.assign(genes_);
  }

 private:
  const OperatorContext& context_;
  Tour genes_;
};

}  // namespace

std::unique_ptr<Crossover> ox(const OperatorContext& context) {
  return std::make_unique<Ox>(context);
}

namespace {

class Pmx final : public Crossover {
 public:
  explicit Pmx(const OperatorContext& context) : context_(context) {}

  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) override {
    const auto [low, high] = std::minmax({context_.any_position(random), context_.any_position(random)});
    map_stretch(first, second, low, high, child);
  }

 private:
  const OperatorContext& context_;
};

}  // namespace

void map_stretch(const Genome& first, const Genome& second, int low, int high, Genome& child) {
  child = first;
  for (int p = low; p <= high; ++p) {
    if (child.at(p) != second.at(p)) child.swap(p, child.place(second.at(p)));
  }
}

std::unique_ptr<Crossover> pmx(const OperatorContext& context) {
  return std::make_unique<Pmx>(context);
}

}  // namespace clearcut::order
