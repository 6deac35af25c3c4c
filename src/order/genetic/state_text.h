// Where a run of the genetic algorithm stands, as text that gives it back to the bit: for files and for other processes.
#pragma once

#include <optional>
#include <string>

#include "order/genetic/genetic.h"

namespace clearcut::order {

/// One line, without its end.
std::string text_of_state(const GeneticState& state);

/// Nothing where `text` is no whole state of that many individuals of that many points.
std::optional<GeneticState> state_of_text(const std::string& text, int individuals, int points);

}  // namespace clearcut::order
