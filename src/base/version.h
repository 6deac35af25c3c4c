#pragma once

namespace clearcut {

/// Version of the software, as in CMakeLists.txt (a test compares them).
inline constexpr const char* kVersion = "0.1.0";

}  // namespace clearcut
