#include "order/objective.h"

namespace clearcut::order {

namespace {

class WholePath final : public PathValue {
 public:
  WholePath(const Objective& objective, const Moves& moves) : objective_(objective), moves_(moves) {}
  double of(std::span<const int> tour) override { return objective_.path(moves_, tour); }

 private:
  const Objective& objective_;
  const Moves& moves_;
};

}  // namespace

std::unique_ptr<PathValue> Objective::path_value(const Moves& moves) const {
  return std::make_unique<WholePath>(*this, moves);
}

Evaluator::Evaluator(const Objective& objective, const Moves& moves)
    : objective_(objective),
      moves_(moves),
      path_(objective.path_dependent() ? objective.path_value(moves) : nullptr) {}

double Evaluator::operator()(std::span<const int> tour) {
  double value = objective_.constant() + (path_ ? path_->of(tour) : 0);
  each_edge(moves_.problem(), tour, [&](int a, int b) { value += objective_.edge(moves_, a, b); });
  each_corner(moves_.problem(), tour,
              [&](int a, int b, int c) { value += objective_.corner(moves_, a, b, c); });
  return value;
}

double evaluate(const Objective& objective, const Moves& moves, std::span<const int> tour) {
  return Evaluator(objective, moves)(tour);
}

TourFigures figures(const Moves& moves, std::span<const int> tour) {
  TourFigures result;
  each_edge(moves.problem(), tour, [&](int a, int b) {
    const MoveShape shape = moves.shape(a, b);
    result.length += shape.length;
    result.turns += shape.inner_turns;
    result.angle_deg += shape.inner_angle;
  });
  each_corner(moves.problem(), tour, [&](int a, int b, int c) {
    result.turns += moves.turns_at(a, b, c) ? 1 : 0;
    result.angle_deg += moves.angle_at(a, b, c);
  });
  return result;
}

}  // namespace clearcut::order
