// Functions of include/clearcut/strategy.h, by calls of the stages.
#include <clearcut/strategy.h>

#include <utility>

#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"

namespace clearcut {

ClearingArea clearing_area(const Layer& layer, const Tolerances& tol) {
  return plan::clearing_area(layer, tol);
}

bool closed_all_round(const Layer& layer) {
  return plan::closed_all_round(layer);
}

Strategy once_per_outline(Strategy plan) {
  return plan::once_per_outline(std::move(plan));
}

}  // namespace clearcut
