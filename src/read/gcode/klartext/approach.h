// Approach to a contour and departure from it (APPR, DEP): points and arcs that follow from its first or last element.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/edge.h"
#include "read/gcode/motion/arc.h"

namespace clearcut::read::gcode {

/// The second word of the block, P for polar coordinates left out.
enum class ContactKind : unsigned char {
  kTangent,    ///< LT: by a line that goes on as the contour
  kNormal,     ///< LN: by a line across the contour
  kArc,        ///< CT: by an arc tangent to the contour
  kLineAndArc  ///< LCT: by an arc tangent to the contour and a line tangent to this arc
};

/// Words of the block that no other block has are taken out of `words`.
struct ContactWords {
  ContactKind kind = ContactKind::kTangent;
  bool polar = false;
  std::optional<std::string> length;  ///< behind LEN
  std::optional<std::string> angle;   ///< behind CCA
  std::vector<std::string> words;     ///< APPR or DEP and the rest
};

/// Absent where the second word is none of the kinds.
std::optional<ContactWords> contact_words(const std::vector<std::string>& words);

/// A point of the contour, and the side on which the tool's centre runs.
struct Contact {
  Vec2 place;
  Vec2 along;              ///< of length 1, as the tool runs
  double side = 0;         ///< 1: left, -1: right, 0: the centre is on the contour
  double tool_radius = 0;  ///< mm
};

/// The centre's distance from the contour grows by `length`, straight across.
Vec2 place_across(const Contact& contact, double length);

/// As programmed, beside which the tool's centre runs. `radius`: mm, > 0 on the tool's side of the contour, < 0 on the other. `sweep`: radians.
ArcShape arc_to(const Contact& contact, double radius, double sweep);
ArcShape arc_from(const Contact& contact, double radius, double sweep);

/// The same arc as long as the line between the centre's arc and `outside` is tangent to it. Needs radius > contact.tool_radius; absent where `outside`
/// lies within the circle.
std::optional<ArcShape> arc_to_from(const Contact& contact, double radius, Vec2 outside);
std::optional<ArcShape> arc_from_to(const Contact& contact, double radius, Vec2 outside);

}  // namespace clearcut::read::gcode
