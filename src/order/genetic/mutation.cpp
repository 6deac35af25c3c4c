#include "order/genetic/mutation.h"

#include <algorithm>

#include "order/genetic/names.h"

namespace clearcut::order {

namespace {

using Kind = Rearrangement::Kind;

class TwoPositions final : public Mutation {
 public:
  TwoPositions(const OperatorContext& context, Kind kind) : context_(context), kind_(kind) {}
  Rearrangement choose(const Genome& /*genome*/, Random& random) const override {
    const auto [low, high] = std::minmax({context_.any_position(random), context_.any_position(random)});
    return low == high ? Rearrangement{} : Rearrangement{kind_, low, high};
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
    return {Kind::kReverse, low, high};
  }
  const OperatorContext& context_;
};

const NamedMakers<std::unique_ptr<Mutation> (*)(const OperatorContext&)>& mutation_makers() {
  static const NamedMakers<std::unique_ptr<Mutation> (*)(const OperatorContext&)> all{
      "mutation",
      {{"exchange", exchange_mutation}, {"inversion", inversion_mutation}, {"nearest", nearest_mutation}}};
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
