#include "model/control.h"

#include <algorithm>
#include <iterator>

namespace clearcut::inline model {

const ControlState* ControlTable::at(std::size_t index) const {
  const auto after =
      std::upper_bound(spans.begin(), spans.end(), index,
                       [](std::size_t move, const ControlSpan& span) { return move < span.first_move; });
  return after == spans.begin() ? nullptr : &std::prev(after)->state;
}

double ControlTable::doubt_at(std::size_t index) const {
  const auto found = std::lower_bound(arcs.begin(), arcs.end(), index,
                                      [](const ArcDoubt& arc, std::size_t move) { return arc.move < move; });
  return found != arcs.end() && found->move == index ? found->apart_mm : 0;
}

}  // namespace clearcut::inline model
