#include "order/genetic/operators.h"

#include <algorithm>

#include "order/genetic/operator_context.h"

namespace clearcut::order {

namespace {

const NamedMakers<std::unique_ptr<Crossover> (*)(const OperatorContext&)>& crossover_makers() {
  static const NamedMakers<std::unique_ptr<Crossover> (*)(const OperatorContext&)> all{"crossover",
                                                                                       {{"pmx", pmx},
                                                                                        {"ox", ox},
                                                                                        {"erx", erx},
                                                                                        {"cx", cx},
                                                                                        {"eax", eax},
                                                                                        {"ox1", ox1},
                                                                                        {"ox2", ox2},
                                                                                        {"pos", pos},
                                                                                        {"hx", hx},
                                                                                        {"smx", smx},
                                                                                        {"mpx", mpx},
                                                                                        {"vr", vr},
                                                                                        {"ap", ap},
                                                                                        {"aer", aer},
                                                                                        {"scx", scx},
                                                                                        {"upmx", upmx}}};
  return all;
}

}  // namespace

const std::vector<std::string>& crossover_names() {
  static const std::vector<std::string> names = crossover_makers().names();
  return names;
}

std::unique_ptr<Crossover> crossover_named(const std::string& name, const OperatorContext& context) {
  return crossover_makers().at(name)(context);
}

namespace {

using Kind = Rearrangement::Kind;

class TwoPositions final : public Mutation {
 public:
  TwoPositions(const OperatorContext& context, Kind kind) : context_(context), kind_(kind) {}
  Rearrangement choose(const Genome& /*genome*/, Random& random) const override {
    const auto [low, high] = std::minmax({context_.any_position(random), context_.any_position(random)});
    return low == high ? Rearrangement{} : Rearrangement{kind_, low, high, {}};
  }

 private:
  const OperatorContext& context_;
  Kind kind_;
};

class Nearest final : public Mutation {
 public:
  explicit Nearest(const OperatorContext& context) : context_(context) {}
  Rearrangement choose(const Genome& genome, Random& random) const override {
    const int p = context_.any_position(random);
    const bool at_begin = p == 0 && !context_.closed();
    const int before = at_begin ? genome.at(0) : genome.at(p == 0 ? genome.size() - 1 : p - 1);
    const int neighbour = context_.neighbours.pick(before, random);
    if (neighbour < 0) return {};
    const int q = genome.place(neighbour);
    if (at_begin) return reversal(0, q - 1);
    return q > p || p == 0 ? reversal(p, q) : reversal(q + 1, p - 1);
  }

 private:
  /// No rearrangement if a fixed end would move or the genes are already adjacent.
  Rearrangement reversal(int low, int high) const {
    if (low >= high || low < context_.first || high > context_.last) return {};
    return {Kind::kReverse, low, high, {}};
  }
  const OperatorContext& context_;
};

/// A random stretch in another order.
class OfStretch : public Mutation {
 public:
  explicit OfStretch(const OperatorContext& context) : context_(context) {}
  Rearrangement choose(const Genome& genome, Random& random) const final {
    const auto [low, high] = std::minmax({context_.any_position(random), context_.any_position(random)});
    if (low == high) return {};
    return rearranged(genome, low, high, random);
  }

 protected:
  /// Genes of the positions low..high as they are.
  static Rearrangement as_it_is(const Genome& genome, int low, int high) {
    return {Kind::kGenes, low, high, Tour(genome.genes().begin() + low, genome.genes().begin() + high + 1)};
  }
  virtual Rearrangement rearranged(const Genome& genome, int low, int high, Random& random) const = 0;
  const OperatorContext& context() const { return context_; }

 private:
  const OperatorContext& context_;
};

/// DM, ISM, IVM: the end of a stretch moves to its beginning.
class Displacement final : public OfStretch {
 public:
  enum class What { kStretch, kOneGene, kReversedStretch };
  Displacement(const OperatorContext& context, What what) : OfStretch(context), what_(what) {}

 private:
  Rearrangement rearranged(const Genome& genome, int low, int high, Random& random) const override {
    Rearrangement change = as_it_is(genome, low, high);
    Tour& genes = change.genes;
    const auto moved = what_ == What::kOneGene
                           ? std::ptrdiff_t{1}
                           : static_cast<std::ptrdiff_t>(1 + random.below(genes.size() - 1));
    // Which of the two parts is called the moved one matters where it is reversed or one gene alone.
    if (random.below(2) == 0) {
      std::rotate(genes.begin(), genes.end() - moved, genes.end());
      if (what_ == What::kReversedStretch) std::reverse(genes.begin(), genes.begin() + moved);
    } else {
      std::rotate(genes.begin(), genes.begin() + moved, genes.end());
      if (what_ == What::kReversedStretch) std::reverse(genes.end() - moved, genes.end());
    }
    return change;
  }
  What what_;
};

/// SM.
class Scramble final : public OfStretch {
  using OfStretch::OfStretch;
  Rearrangement rearranged(const Genome& genome, int low, int high, Random& random) const override {
    Rearrangement change = as_it_is(genome, low, high);
    for (std::size_t i = change.genes.size(); i > 1; --i)
      std::swap(change.genes[i - 1], change.genes[random.below(i)]);
    return change;
  }
};

/// PSM.
class PartialShuffle final : public OfStretch {
  using OfStretch::OfStretch;
  Rearrangement rearranged(const Genome& genome, int low, int high, Random& random) const override {
    constexpr std::uint64_t kOneIn = 4;
    Rearrangement change = as_it_is(genome, low, high);
    for (int& gene : change.genes)
      if (random.below(kOneIn) == 0) std::swap(gene, change.genes[random.below(change.genes.size())]);
    return change;
  }
};

/// Centre inversion: what lies on either side of a random place is reversed.
class CentreInversion final : public OfStretch {
  using OfStretch::OfStretch;
  Rearrangement rearranged(const Genome& genome, int /*low*/, int high, Random& /*random*/) const override {
    Rearrangement change = as_it_is(genome, context().first, context().last);
    const auto middle = change.genes.begin() + (high - context().first);
    std::reverse(change.genes.begin(), middle);
    std::reverse(middle, change.genes.end());
    return change;
  }
};

/// Throas, thrors: three genes change places in a ring.
class ThreeGenes final : public OfStretch {
 public:
  ThreeGenes(const OperatorContext& context, bool are_successive)
      : OfStretch(context), are_successive_(are_successive) {}

 private:
  Rearrangement rearranged(const Genome& genome, int low, int high, Random& random) const override {
    if (are_successive_) high = low + 2;
    if (high > context().last || high - low < 2) return {};
    Rearrangement change = as_it_is(genome, low, high);
    const std::size_t between = 1 + random.below(change.genes.size() - 2);
    std::swap(change.genes[between], change.genes.back());
    std::swap(change.genes.front(), change.genes[between]);
    return change;
  }
  bool are_successive_;
};

/// Sengoku's: a random gene is joined to one of those of its near neighbours that are nearer than the gene after it.
class ShorterMove final : public Mutation {
 public:
  explicit ShorterMove(const OperatorContext& context) : context_(context) {}
  Rearrangement choose(const Genome& genome, Random& random) const override {
    const int p = context_.any_position(random);
    if (p >= context_.last) return {};
    const double present = context_.moves.length(genome.at(p), genome.at(p + 1));
    const auto& near = context_.neighbours.nearest(genome.at(p));
    std::size_t nearer = 0;
    while (nearer < near.size() && context_.moves.length(genome.at(p), near[nearer]) < present) ++nearer;
    if (nearer == 0) return {};
    const int q = genome.place(near[random.below(nearer)]);
    const int low = q > p ? p + 1 : q + 1, high = q > p ? q : p;
    if (low >= high || low < context_.first || high > context_.last) return {};
    return {Kind::kReverse, low, high, {}};
  }

 private:
  const OperatorContext& context_;
};

template <class Made, auto... how>
std::unique_ptr<Mutation> made(const OperatorContext& context) {
  return std::make_unique<Made>(context, how...);
}

const NamedMakers<std::unique_ptr<Mutation> (*)(const OperatorContext&)>& mutation_makers() {
  static const NamedMakers<std::unique_ptr<Mutation> (*)(const OperatorContext&)> all{
      "mutation",
      {{"exchange", exchange_mutation},
       {"inversion", inversion_mutation},
       {"nearest", nearest_mutation},
       {"displacement", made<Displacement, Displacement::What::kStretch>},
       {"insertion", made<Displacement, Displacement::What::kOneGene>},
       {"inverted-displacement", made<Displacement, Displacement::What::kReversedStretch>},
       {"scramble", made<Scramble>},
       {"partial-shuffle", made<PartialShuffle>},
       {"centre-inversion", made<CentreInversion>},
       {"three-successive", made<ThreeGenes, true>},
       {"three-random", made<ThreeGenes, false>},
       {"shorter", made<ShorterMove>}}};
  return all;
}

}  // namespace

std::unique_ptr<Mutation> exchange_mutation(const OperatorContext& context) {
  return std::make_unique<TwoPositions>(context, Kind::kSwap);
}
std::unique_ptr<Mutation> inversion_mutation(const OperatorContext& context) {
  return std::make_unique<TwoPositions>(context, Kind::kReverse);
}
std::unique_ptr<Mutation> nearest_mutation(const OperatorContext& context) {
  return std::make_unique<Nearest>(context);
}

const std::vector<std::string>& mutation_names() {
  static const std::vector<std::string> names = mutation_makers().names();
  return names;
}

std::unique_ptr<Mutation> mutation_named(const std::string& name, const OperatorContext& context) {
  return mutation_makers().at(name)(context);
}

}  // namespace clearcut::order
