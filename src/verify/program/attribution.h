// Assignment of moves to workingsteps.
#pragma once

#include <optional>
#include <vector>

#include "model/move.h"
#include "model/part.h"
#include "model/section_names.h"
#include "verify/part/edge_tree.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// Finds the workingstep of a feed move. Labels of the program group figures and name faults; no verdict rests on
/// them.
class Attribution {
 public:
  explicit Attribution(const Part& part);

  /// The workingstep named by the whole section: by its label, else by its number; -1: none.
  int by_section(const Section& section) const;

  /// `previous`, if the move is in its feature; else a workingstep with the move in its feature, if possible with the
  /// same tool; -1: none.
  int by_place(const CheckedMove& checked, int previous) const;

  /// mm. The greatest stepdown of all workingsteps with a feature around the move or less than a radius away, because
  /// work on one feature extends into the next; if some of them use the move's tool, only of these. Absent if none
  /// states a stepdown, or one of the move's tool states none.
  std::optional<double> stepdown_at(const CheckedMove& checked) const;

 private:
  bool has_tool(const CheckedMove& checked, int workingstep) const;
  /// Whether the cutter at p touches the workingstep's feature, or is within `beside` mm of it, at the move's depth.
  bool fits(const CheckedMove& checked, Vec2 p, int workingstep, double beside = 0) const;

  const Part& part_;
  SectionNames names_;
  std::vector<EdgeTree> outlines_;  ///< outlines of the features' targets
};

}  // namespace clearcut::verify
