// Distance between passes.
#pragma once

#include <string>

namespace clearcut::inline model {

/// The requested stepover, as text: "0.4" (fraction of the diameter), "3.5mm", "lom", ...; "" leaves it to the
/// strategy. Each strategy reads its own rules, see parse_step_rule.
struct Stepover {
  std::string text;
  bool is_given() const { return !text.empty(); }
};

}  // namespace clearcut::inline model
