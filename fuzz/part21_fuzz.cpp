// Any bytes: read_stepnc reads them or throws InputError, and what it read can be written and read again.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.h"
#include "post/part/part_writers.h"
#include "read/stepnc/stepnc.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  clearcut::Part part;
  try {
    part = clearcut::read::stepnc::read_stepnc(text, "fuzz.p21", {});
  } catch (const clearcut::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) __builtin_trap();
    return 0;
  }
  if (part.workplan.empty() || part.features.empty()) __builtin_trap();
  try {
    clearcut::read::stepnc::read_stepnc(clearcut::post::write_stepnc(part), "again.p21", {});
  } catch (const clearcut::InputError&) {
    // What is left of a damaged file may end in features with nothing to cut.
  }
  return 0;
}
