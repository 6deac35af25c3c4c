#include <algorithm>

#include "order/genetic/crossover.h"

namespace clearcut::order {

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

}  // namespace clearcut::order
