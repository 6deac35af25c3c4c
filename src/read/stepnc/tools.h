// The tools of a program.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "model/tool.h"
#include "read/stepnc/file/node.h"

namespace clearcut::read::stepnc {

/// All tools of the file, in order of their entities, equal ones once.
class Tools {
 public:
  /// Tools that cannot be read are left out until find() asks for them.
  explicit Tools(Context& context);
  const std::vector<Tool>& list() const { return tools_; }
  /// Index of the tool of a MILLING_CUTTING_TOOL. Throws InputError for what is missing in it.
  int find(const Node& tool, Context& context) const;
  bool left_handed(const Node& tool) const;

 private:
  int add(Tool tool, bool numbered);
  void number_the_rest();
  std::vector<Tool> tools_;
  std::vector<bool> numbered_;
  std::map<std::uint64_t, int> by_entity_;
};

}  // namespace clearcut::read::stepnc
