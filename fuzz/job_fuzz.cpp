// Any text as a job: read, or refused in one line. No other file is opened.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "read/job/job_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  try {
    read::read_job_text({reinterpret_cast<const char*>(data), size}, "/nowhere/fuzz.toml");
  } catch (const InputError&) {
  }
  return 0;
}
