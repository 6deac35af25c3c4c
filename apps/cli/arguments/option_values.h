// Options of the table as a command takes them.
#pragma once

#include <clearcut/options.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace clearcut::cli {

/// The values that were typed, by the names of their rows. What a row refuses is an InputError while the command line is parsed.
class OptionValues {
 public:
  /// Adds every row that is `wanted` to the command, under the heading of its group.
  void add(CLI::App& command, const std::function<bool(const Row&)>& wanted);
  bool has(const std::string& name) const;
  /// The names of the rows that were typed.
  std::set<std::string> names() const;
  /// Puts what was typed into `asked`, over what is there.
  void put_into(Asked& asked) const;
  Asked asked() const;
  /// Whether the command has the row.
  bool knows(const std::string& name) const { return texts_.contains(name) || flags_.contains(name); }
  /// As though it had been typed. Throws InputError at `place` where the row refuses it.
  void set(const std::string& name, const std::vector<std::string>& values, const std::string& place);

 private:
  void add_row(CLI::App& command, const Row& row);
  // In nodes that stay where they are: the parser keeps their addresses.
  std::map<std::string, std::vector<std::string>> texts_;
  std::map<std::string, bool> flags_;
};

}  // namespace clearcut::cli
