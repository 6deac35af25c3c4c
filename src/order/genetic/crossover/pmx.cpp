#include <algorithm>

#include "order/genetic/crossover.h"

namespace clearcut::order {

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
