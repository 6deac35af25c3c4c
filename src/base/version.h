#pragma once

namespace clearcut::inline base {

/// Version of the software, as in CMakeLists.txt (a test compares them).
inline constexpr const char* kVersion = "0.1.0";

}  // namespace clearcut::inline base
