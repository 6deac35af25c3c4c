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

}  // namespace clearcut::inline model
