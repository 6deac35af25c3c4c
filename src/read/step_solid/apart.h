// Work that may crash or never end, done in a process of its own.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace clearcut {

/// What `work` returns; nothing where it crashed, or took more than `seconds` of processor time. It runs in a
/// copy of this process without standard output: nothing else that it does is seen here.
///
/// Throws  std::system_error where no process can be started.
/// Cost    about a millisecond on top of the work's.
std::optional<std::string> done_apart(const std::function<std::string()>& work, int seconds);

}  // namespace clearcut
