// --margin and its bounds, of plan and verify.
#pragma once

#include <clearcut/verify.h>

#include <CLI/CLI.hpp>
#include <optional>

namespace clearcut::cli {

struct MarginArguments {
  bool is_asked = false;
  MarginBounds bounds;

  void add_options(CLI::App& command);

  /// Nothing where it is not asked for.
  template <typename Result>
  std::optional<Margin> of(const Result& result, const PlanOptions& options) const {
    if (!is_asked) return std::nullopt;
    return margin_of(result, options, bounds);
  }
};

}  // namespace clearcut::cli
