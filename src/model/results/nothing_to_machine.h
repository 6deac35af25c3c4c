// Thrown where no workingstep is left that can be machined.
#pragma once

#include <string>
#include <utility>

#include "base/diagnostics.h"
#include "base/error.h"

namespace clearcut::inline model {

/// What remains of a part after its impossible workingsteps is nothing. Of several set-ups the others can still be planned.
class NothingToMachine : public InputError {
 public:
  /// `said`: what is known of the part, each workingstep as not machined.
  NothingToMachine(const std::string& place, const std::string& what_and_what_to_do, Diagnostics said)
      : InputError(place, what_and_what_to_do), said_(std::move(said)) {}

  const Diagnostics& said() const { return said_; }

 private:
  Diagnostics said_;
};

}  // namespace clearcut::inline model
