// Stands in for src/read/step_solid/solid_model.cpp: a page has no CAD kernel.
#include "base/error.h"
#include "read/step_solid/solid_model.h"

namespace clearcut::read {

bool solids_can_be_read() {
  return false;
}

SolidModel load_solid(std::string_view /*text*/, const std::string& file_name,
                      const SolidChoice& /*choice*/) {
  throw InputError(
      file_name,
      "a STEP solid, which this page cannot read, because it runs without the CAD kernel; export the "
      "outline as DXF or SVG, or plan with the clearcut command");
}

}  // namespace clearcut::read
