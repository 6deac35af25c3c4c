// State of a run of the genetic algorithm as text, exact to the bit: for files and for other processes.
#pragma once

#include <optional>
#include <string>

#include "order/genetic/genetic.h"

namespace clearcut::order {

/// One line, without its end.
std::string text_of_state(const GeneticState& state);

/// Nothing if `text` is no complete state with these numbers of individuals and points.
std::optional<GeneticState> state_of_text(const std::string& text, int individuals, int points);

}  // namespace clearcut::order
