// The tools of a program.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "model/tool.h"
#include "read/stepnc/file/node.h"

namespace clearcut::read::stepnc {

/// What the workingsteps of a program do with a tool, which tells apart what one kind of body stands for.
struct StatedUse {
  bool mills = false;         ///< it runs along something, and not straight down alone
  double neck = 0;            ///< mm; width of the narrowest slot that it undercuts; 0: none
  bool breaks_edges = false;  ///< all that it works on are chamfers
};

/// All tools of the file, in order of their entities, equal ones once.
class Tools {
 public:
  /// Tools that cannot be read are left out until find() asks for them.
  Tools(Context& context, const std::map<std::uint64_t, StatedUse>& uses);
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
  std::map<std::uint64_t, StatedUse> uses_;
};

}  // namespace clearcut::read::stepnc
