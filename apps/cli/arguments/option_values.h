// Options of the table as a command takes them, validators of other values, and suggestions for words unknown to the
// command.
#pragma once

#include <clearcut/options.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace clearcut::cli {

/// A seed is any whole number of 64 bits; greater numbers are refused, not truncated.
CLI::Validator is_seed();

/// "'--stepdwn' is no option of plan; did you mean '--stepdown'?" for the first unused argument.
std::string about_unexpected(const CLI::App& app, const std::vector<std::string>& arguments);

/// Accepts one of these names, and suggests one for other words; the names are shown in help and completion.
CLI::Validator one_of(const std::vector<std::string>& names);
/// Accepts any text; the names are used only in completion.
CLI::Validator for_example(const std::vector<std::string>& names);

/// The typed values, by the names of their rows. Values refused by a row give an InputError during parsing of the
/// command line.
class OptionValues {
 public:
  /// Adds every `wanted` row to the command, under the heading of its group.
  void add(CLI::App& command, const std::function<bool(const Row&)>& wanted);
  bool has(const std::string& name) const;
  /// The names of the typed rows.
  std::set<std::string> names() const;
  /// Stores the typed values into `asked`, replacing existing ones.
  void put_into(Asked& asked) const;
  Asked asked() const;
  /// Whether the command has the row.
  bool knows(const std::string& name) const { return texts_.contains(name) || flags_.contains(name); }
  /// As though it had been typed. Throws InputError at `place` where the row refuses it.
  void set(const std::string& name, const std::vector<std::string>& values, const std::string& place);

 private:
  void add_row(CLI::App& command, const Row& row);
  // In nodes with fixed addresses: the parser keeps their addresses.
  std::map<std::string, std::vector<std::string>> texts_;
  std::map<std::string, bool> flags_;
};

}  // namespace clearcut::cli
