// Areas filled by a line of constant width, as a bead of an extruder or by a laser: planned, written, and proven from the text.
#pragma once

#include "clearcut/plan.h"
#include "pipeline/infill.h"
#include "report/certificate/laid_certificate.h"

namespace clearcut {

using pipeline::check_infill;
using pipeline::InfillOptions;
using pipeline::InfillResult;
using pipeline::plan_infill;
using report::laid_certificate;
using report::laid_table;
using report::LaidCertificateInfo;

}  // namespace clearcut
