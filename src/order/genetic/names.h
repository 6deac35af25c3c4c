// Operators by name: one list serves the command line, its messages and the studies.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace clearcut::order {

template <class Maker>
struct NamedMakers {
  std::string kind;
  std::vector<std::pair<std::string, Maker>> entries;

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : entries) all.push_back(entry.first);
    return all;
  }
  /// Throws InputError, listing the names.
  const Maker& at(const std::string& name) const {
    std::string known;
    for (const auto& entry : entries) {
      if (entry.first == name) return entry.second;
      known += (known.empty() ? "" : ", ") + entry.first;
    }
    throw InputError(kind, "'" + name + "' is unknown; use one of " + known);
  }
};

}  // namespace clearcut::order
