// Drawings that are read otherwise than they are drawn.
#pragma once

namespace clearcut::read {

/// The condition of all that is read otherwise than it is drawn, docs/conditions.md.
inline constexpr const char* kNotAsDrawn = "not-as-drawn";

}  // namespace clearcut::read
