// Certificates as JSON that was read back: their schema, their seal, and where two of them differ.
#pragma once

#include "base/files/digest.h"
#include "report/certificate_question.h"
#include "report/certificate_schema.h"

namespace clearcut {

using report::certificate_schema;
using report::differences;
using report::schema_faults;
using report::seal_of;

}  // namespace clearcut
