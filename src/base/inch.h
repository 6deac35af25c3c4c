// The inch. Lengths are mm everywhere inside; inches exist only in reading and writing files.
#pragma once

namespace clearcut::inline base {

/// By definition (ISO 80000-3).
inline constexpr double kMmPerInch = 25.4;

}  // namespace clearcut::inline base
