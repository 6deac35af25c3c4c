#include "order/objective.h"

namespace clearcut::order {

namespace {

class Turns final : public Objective {
 public:
  std::string name() const override { return "turns"; }
  std::string unit() const override { return "turns"; }
  double edge(const Moves& moves, int a, int b) const override { return moves.inner_turns(a, b); }
  double corner(const Moves& moves, int a, int b, int c) const override {
    return moves.turns_at(a, b, c) ? 1 : 0;
  }
  Linear linear() const override { return {.turns = 1}; }
};

}  // namespace

ObjectivePtr turns_objective() {
  return std::make_shared<Turns>();
}

}  // namespace clearcut::order
