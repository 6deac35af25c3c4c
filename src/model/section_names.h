// What the sections of a program are called, and which workingstep each of them is.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::inline model {

/// The names of a part's workingsteps in programs and tables: that of the feature, and where several steps work on it what each
/// does: rough, rest, finish. No two are the same to a reader of programs, who sees capitals, digits and signs alone.
class SectionNames {
 public:
  explicit SectionNames(const Part& part);

  /// Of a workingstep, by its index in the workplan.
  const std::string& of(int workingstep) const { return names_[static_cast<std::size_t>(workingstep)]; }

  /// Index into the workplan of the step that a section is labelled by: with its name here, its own, or its feature's; where no step
  /// has that name the section's number, if it is one; else -1. Programs number their sections in the order of cutting, so a name goes
  /// before a number.
  int workingstep_of(const Section& section) const;

  /// Gives every section as read the index of its workingstep.
  void settle(Toolpath& toolpath) const;

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, int> by_key_;
};

}  // namespace clearcut::inline model
