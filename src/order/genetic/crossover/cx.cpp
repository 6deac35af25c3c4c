#include "order/genetic/crossover.h"

namespace clearcut::order {

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

}  // namespace clearcut::order
