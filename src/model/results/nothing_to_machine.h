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
  /// `said`: what is known of the part, each workingstep as not machined. `is_done`: earlier set-ups have cut away all
  /// of it, so that nothing is missing.
  NothingToMachine(const std::string& place, const std::string& what_and_what_to_do, Diagnostics said,
                   bool is_done = false)
      : InputError(place, what_and_what_to_do), said_(std::move(said)), is_done_(is_done) {}

  const Diagnostics& said() const { return said_; }
  bool is_done() const { return is_done_; }

 private:
  Diagnostics said_;
  bool is_done_;
};

}  // namespace clearcut::inline model
