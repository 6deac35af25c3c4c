// Stands in for src/read/step_solid/solid_model.cpp: neither a page nor Clearcut for Windows has a CAD kernel.
#include "base/error.h"
#include "read/step_solid/solid_model.h"

#ifndef CLEARCUT_HERE
#define CLEARCUT_HERE "this page"
#endif

namespace clearcut::read {

bool solids_can_be_read() {
  return false;
}

SolidModel load_solid(std::string_view /*text*/, const std::string& file_name,
                      const SolidChoice& /*choice*/) {
  throw InputError(file_name, "a STEP solid, which " CLEARCUT_HERE
                              " cannot read, because it runs without the CAD kernel; export "
                              "the outline as DXF or SVG, or plan with the clearcut command of Linux");
}

}  // namespace clearcut::read
