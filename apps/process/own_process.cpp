#include "process/own_process.h"

#include <clearcut/error.h>
#include <stdlib.h>
#include <sys/random.h>
#include <unistd.h>

namespace clearcut::process {

void replace_by(const std::string& program, const std::vector<std::string>& words) {
  std::vector<std::string> own = words;
  std::vector<char*> given;
  for (std::string& word : own) given.push_back(word.data());
  given.push_back(nullptr);
  ::execv(program.c_str(), given.data());
}

std::uint64_t memory_share(int jobs) {
  const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / static_cast<std::uint64_t>(jobs);
}

void set_variable(const char* name, const std::string& value) {
  ::setenv(name, value.c_str(), 1);
}

void fill_randomly(std::span<unsigned char> bytes) {
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw InternalError("no random numbers");
}

}  // namespace clearcut::process
