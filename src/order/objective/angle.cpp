#include "order/objective.h"

namespace clearcut::order {

namespace {

class Angle final : public Objective {
 public:
  std::string name() const override { return "angle"; }
  std::string unit() const override { return "deg"; }
  double edge(const Moves& moves, int a, int b) const override { return moves.inner_angle(a, b); }
  double corner(const Moves& moves, int a, int b, int c) const override { return moves.angle_at(a, b, c); }
  Linear linear() const override { return {.angle = 1}; }
};

}  // namespace

ObjectivePtr angle_objective() {
  return std::make_shared<Angle>();
}

}  // namespace clearcut::order
