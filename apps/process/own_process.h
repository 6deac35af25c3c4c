// This process and its machine: what differs between systems.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace clearcut::process {

/// Goes on as the program at this path; `words` begin with the name it is told. Returns only if the program cannot be
/// started.
void replace_by(const std::string& program, const std::vector<std::string>& words);

/// The machine's memory by the number of jobs, in bytes.
std::uint64_t memory_share(int jobs);

/// Sets a variable of the environment, for this process and those that it starts.
void set_variable(const char* name, const std::string& value);

/// Fills `bytes` with random numbers that nobody can guess. Throws InternalError if the system has none.
void fill_randomly(std::span<unsigned char> bytes);

}  // namespace clearcut::process
