#include "order/genetic/crossover.h"

namespace clearcut::order {

namespace {

class Cx final : public Crossover {
 public:
  explicit Cx(const Ground& ground) : ground_(ground) {}

  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) override {
    genes_ = first.genes();
    const int begin = ground_.any_position(random);
    int p = begin;
    do {
      genes_[static_cast<std::size_t>(p)] = second.at(p);
      p = first.place(second.at(p));
    } while (p != begin);
    child.assign(genes_);
  }

 private:
  const Ground& ground_;
  Tour genes_;
};

}  // namespace

std::unique_ptr<Crossover> cx(const Ground& ground) {
  return std::make_unique<Cx>(ground);
}

}  // namespace clearcut::order
