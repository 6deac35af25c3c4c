// Runs work that may crash or never end in a program of its own.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::inline base {

/// Standard output of the program `command` (its path, then its arguments) for the input `input`; nothing if the
/// program crashed, failed, or took more than `seconds` of processor time. Its standard error is dropped.
///
/// Throws  std::system_error if the program cannot be started.
/// Cost    about a millisecond on top of the program's own.
std::optional<std::string> done_apart(const std::vector<std::string>& command, std::string_view input,
                                      int seconds);

}  // namespace clearcut::inline base
