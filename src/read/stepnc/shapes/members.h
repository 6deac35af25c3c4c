// Patterns and compound features as the simple features they stand for.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "read/stepnc/shapes/placement.h"

namespace clearcut::read::stepnc {

/// A feature that can be cut by itself.
bool is_simple_feature(const Node& node);

/// Such a feature and its frame in the program's coordinates.
struct Member {
  Node feature;
  Frame placement;
  std::string name;  ///< its own, else that of what it belongs to
};

/// CIRCULAR_PATTERN, RECTANGULAR_PATTERN and GENERAL_PATTERN: the base feature, placed in the workpiece like the pattern,
/// is the first member; the others are moved copies. COMPOUND_FEATURE, COUNTERBORE_HOLE and COUNTERSUNK_HOLE: elements are
/// placed in the compound. Both may hold one another.
class Members {
 public:
  /// `turn`: from the workpiece's coordinates to those of the program.
  Members(Context& context, const Frame& turn);

  /// The members of a pattern or compound, in the order of the file (of patterns: rows from first to last column); a
  /// simple feature alone, in its compound where it is the element of one. Throws InputError for what is missing, tilted or
  /// nested in a circle, and for patterns of more than 10000.
  std::vector<Member> of(const Node& feature) const;

 private:
  Frame space_of(const Node& feature, int depth) const;

  Context* context_;
  Frame turn_;
  std::map<std::uint64_t, Node> compound_of_;  // by element
};

}  // namespace clearcut::read::stepnc
