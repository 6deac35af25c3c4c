// Conditions of what is read otherwise than it is drawn, or not read at all.
#pragma once

namespace clearcut::read {

/// The condition of all that is read otherwise than it is drawn, docs/conditions.md.
inline constexpr const char* kNotAsDrawn = "not-as-drawn";
/// The condition of what the input has and the program does not make.
inline constexpr const char* kLeftOut = "left-out";

}  // namespace clearcut::read
