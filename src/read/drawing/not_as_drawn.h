// Conditions for items read differently than drawn, or not read at all.
#pragma once

namespace clearcut::read {

/// The condition for all items read differently than drawn, docs/conditions.md.
inline constexpr const char* kNotAsDrawn = "not-as-drawn";
/// The condition for items of the input not made by the program.
inline constexpr const char* kLeftOut = "left-out";

}  // namespace clearcut::read
