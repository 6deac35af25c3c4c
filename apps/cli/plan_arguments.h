// The options that plan, compare and verify share, as the user types them.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/plan_options.h"
#include "read/read_part.h"

namespace clearcut::cli {

/// Raw option values; `options()` turns them into PlanOptions or throws InputError.
class PlanArguments {
 public:
  void add_part_options(CLI::App& command, const std::string& input_name);
  void add_tool_options(CLI::App& command);
  void add_cutting_options(CLI::App& command);

  Part read() const;
  PlanOptions options() const;
  const std::string& input() const { return input_; }
  std::uint64_t seed() const { return seed_; }

 private:
  std::string input_;
  std::vector<std::string> tools_;
  std::optional<std::string> unit_;
  std::vector<std::string> layers_;
  std::optional<double> top_;
  std::optional<double> depth_;
  std::string strategy_ = "auto";
  std::optional<std::string> stepover_;
  std::optional<double> stepdown_;
  std::optional<double> allowance_;
  std::optional<double> allowance_floor_;
  std::optional<double> engagement_;
  std::optional<std::string> entry_;
  std::optional<std::string> direction_;
  std::optional<double> feed_;
  std::optional<double> plunge_feed_;
  std::optional<double> spindle_;
  std::optional<double> acceleration_;
  std::optional<double> junction_deviation_;
  std::optional<double> rapid_feed_;
  std::string post_ = "linuxcnc";
  bool inch_ = false;
  std::optional<double> clearance_z_;
  std::string objective_ = "time";
  std::optional<double> time_;
  std::uint64_t seed_ = 1;
  int threads_ = 1;
};

}  // namespace clearcut::cli
