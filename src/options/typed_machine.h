// Values of a machine that are typed besides its file or name.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "model/machine.h"

namespace clearcut::inline options {

/// Values of a machine that are typed besides it.
struct TypedMachine {
  const std::optional<std::string>& kind;          ///< --machine-kind
  const Machine& values;                           ///< of which those count that were typed
  std::function<bool(std::string_view)> is_typed;  ///< by the name of the option
};

}  // namespace clearcut::inline options
