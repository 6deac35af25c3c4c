// Record of the input used by a reader, for naming the unused input.
#pragma once

#include <cstddef>
#include <vector>

namespace clearcut::read {

/// One mark for each item of an input: attributes of entities, codes of a drawing, keys of a file. A reader marks the
/// items it acts on; afterwards a walk through the input finds the unmarked ones. Marks are never removed.
class UseLedger {
 public:
  UseLedger() = default;
  explicit UseLedger(std::size_t items) : used_(items, 0) {}

  void use(std::size_t item) {
    if (item < used_.size()) used_[item] = 1;
  }
  bool is_used(std::size_t item) const { return item < used_.size() && used_[item] != 0; }

 private:
  std::vector<unsigned char> used_;
};

}  // namespace clearcut::read
