#include "arguments/margin_arguments.h"

namespace clearcut::cli {
namespace {

/// mm; machines that are farther off are none that mill.
constexpr double kMostError = 1;

}  // namespace

void MarginArguments::add_options(CLI::App& command) {
  command.option_defaults()->group("Margin");
  auto* const asked = command.add_flag(
      "--margin", is_asked, "Find how far the machine may leave the path before too much is left or cut");
  command.add_option("--margin-uncut", bounds.uncut, "mm that may then be left (default 0.01)")
      ->needs(asked)
      ->check(CLI::Range(1e-3, kMostError));
  command.add_option("--margin-gouge", bounds.gouge, "mm that may then be cut too deep (default 0.001)")
      ->needs(asked)
      ->check(CLI::Range(1e-3, kMostError));
}

}  // namespace clearcut::cli
