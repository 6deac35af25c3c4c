// Certificates that were read back: their schema, their seal, and where two of them differ.
#pragma once

#include "base/file.h"
#include "report/certificate/certificate_check.h"

namespace clearcut {

using report::certificate_contradictions;
using report::certificate_differences;
using report::certificate_faults;
using report::seal_holds;

}  // namespace clearcut
