// Names of the sections of a program, and the workingstep of each section.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::inline model {

/// The names of a part's workingsteps in programs and tables: the feature's name and, if several steps work on the
/// feature, the task of each: rough, rest, finish. No two names are the same to a reader of programs, in which only
/// capitals, digits and signs are distinguished.
class SectionNames {
 public:
  explicit SectionNames(const Part& part);

  /// Name of a workingstep, by its index in the workplan.
  const std::string& of(int workingstep) const { return names_[static_cast<std::size_t>(workingstep)]; }

  /// Index into the workplan of the step named by a section's label: by the step's name in this table, the step's own
  /// name, or its feature's name. If no step has this name, the section's number, if it is a valid index; else -1.
  /// Programs number their sections in the order of cutting, so a name takes precedence over a number.
  int workingstep_of(const Section& section) const;

  /// Gives every section as read the index of its workingstep.
  void settle(Toolpath& toolpath) const;

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, int> by_key_;
};

}  // namespace clearcut::inline model
