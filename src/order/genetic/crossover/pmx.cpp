#include <algorithm>

#include "order/genetic/crossover.h"

namespace clearcut::order {

namespace {

class Pmx final : public Crossover {
 public:
  explicit Pmx(const Ground& ground) : ground_(ground) {}

  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) override {
    const auto [low, high] = std::minmax({ground_.any_position(random), ground_.any_position(random)});
    child = first;
    for (int p = low; p <= high; ++p) {
      if (child.at(p) != second.at(p)) child.swap(p, child.place(second.at(p)));
    }
  }

 private:
  const Ground& ground_;
};

}  // namespace

std::unique_ptr<Crossover> pmx(const Ground& ground) {
  return std::make_unique<Pmx>(ground);
}

}  // namespace clearcut::order
