// Recognises Part 21 files with a solid, only by their text.
#include <string>
#include <string_view>

#include "read/common/text.h"
#include "read/step_solid/step_solid.h"

namespace clearcut::read {
namespace {

/// Whether entities of the file, in capitals, make faces and none a program.
bool holds_faces_alone(const std::string& text) {
  if (text.find("WORKPLAN") != std::string::npos) return false;
  return text.find("ADVANCED_FACE") != std::string::npos || text.find("FACETED_BREP") != std::string::npos;
}

}  // namespace

bool is_step_solid(std::string_view text) {
  const std::string head = capitals(std::string(text.substr(0, 65536)));
  const std::size_t at = head.find("FILE_SCHEMA");
  if (at == std::string::npos) return false;
  const std::string schema = head.substr(at, head.find(';', at) - at);
  for (const char* name : {"AUTOMOTIVE_DESIGN", "CONFIG_CONTROL_DESIGN", "AP203", "AP214", "AP242"})
    if (schema.find(name) != std::string::npos) return true;
  if (schema.find("MACHINING") != std::string::npos || schema.find("CNC") != std::string::npos) return false;
  return holds_faces_alone(capitals(std::string(text)));
}

}  // namespace clearcut::read
