// The rows of the table of options as attributes of PlanOptions.
#pragma once

#include <string>

#include "bindings.h"

namespace clearcut::python {

/// "finish-stock" of "finish_stock".
inline std::string option_name(std::string keyword) {
  for (char& c : keyword) {
    if (c == '_') c = '-';
  }
  return keyword;
}

using OptionsClass = py::class_<AskedOptions>;

/// One attribute for each row of the table of options that lands in PlanOptions.
void add_rows(OptionsClass& options);

}  // namespace clearcut::python
