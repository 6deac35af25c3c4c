// Work that may crash or never end, done by a program of its own.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::inline base {

/// What the program `command` (its path, then its arguments) writes when it is given `input`; nothing where it crashed,
/// failed, or took more than `seconds` of processor time. What it says on standard error is dropped.
///
/// Throws  std::system_error where it cannot be started.
/// Cost    about a millisecond on top of the program's own.
std::optional<std::string> done_apart(const std::vector<std::string>& command, std::string_view input,
                                      int seconds);

}  // namespace clearcut::inline base
