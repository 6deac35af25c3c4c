// Tools, cutting data and operations.
#pragma once

#include <map>

#include "model/part.h"
#include "read/stepnc/node.h"

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

/// An operation; its retract_z is above the top of the feature. Throws InputError for operations that cannot be machined yet and for missing tools.
Operation read_operation(const Node& operation, const Tools& tools, Context& context);

}  // namespace clearcut::read::stepnc
