// The options that say how the program is written.
#pragma once

#include <clearcut/plan.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace clearcut::cli {

class PostArguments {
 public:
  void add_options(CLI::App& command);
  /// What was typed goes before what a job says.
  PostOptions options(PostOptions of_job) const;

 private:
  std::optional<std::string> dialect_;
  bool inch_ = false;
  std::optional<int> decimals_;
  bool no_arcs_ = false, no_tool_change_ = false, no_length_offset_ = false, exact_stop_ = false;
  std::optional<std::string> work_offset_, end_position_;
  std::optional<int> program_number_;
  bool block_numbers_ = false, optional_stop_ = false;
  std::optional<double> spindle_wait_;
};

}  // namespace clearcut::cli
