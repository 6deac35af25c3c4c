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

const std::string* ControlTable::calls_at(std::size_t index) const {
  const auto after =
      std::upper_bound(calls.begin(), calls.end(), index,
                       [](std::size_t move, const CallSpan& span) { return move < span.first_move; });
  if (after == calls.begin() || std::prev(after)->calls < 0) return nullptr;
  return &call_texts[static_cast<std::size_t>(std::prev(after)->calls)];
}

double ControlTable::doubt_at(std::size_t index) const {
  const auto found = std::lower_bound(arcs.begin(), arcs.end(), index,
                                      [](const ArcDoubt& arc, std::size_t move) { return arc.move < move; });
  return found != arcs.end() && found->move == index ? found->apart_mm : 0;
}

}  // namespace clearcut::inline model
