// Any text as a job or a machine: read, or refused in one line. No other file is opened.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "read/job/job_file.h"
#include "read/job/machine_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    read_job_text(text, "/nowhere/fuzz.toml");
  } catch (const InputError&) {
  }
  try {
    read_machine_text(text, "fuzz.toml");
  } catch (const InputError&) {
  }
  return 0;
}
