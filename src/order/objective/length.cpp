#include "order/objective.h"

namespace clearcut::order {

namespace {

class Length final : public Objective {
 public:
  std::string name() const override { return "length"; }
  std::string unit() const override { return "mm"; }
  double edge(const Moves& moves, int a, int b) const override { return moves.length(a, b); }
  Linear linear() const override { return {.length = 1}; }
};

}  // namespace

ObjectivePtr length_objective() {
  return std::make_shared<Length>();
}

}  // namespace clearcut::order
