#include "arguments/quantities.h"

#include <clearcut/error.h>
#include <clearcut/options.h>

#include <string>

namespace clearcut::cli {

CLI::Validator is_seed() {
  return {[](const std::string& text) {
            value_of_text(*row_named("seed"), text, "--seed");
            return std::string();
          },
          ""};
}

}  // namespace clearcut::cli
