// Everything the library promises to its users. Plans 2.5-D pocket-milling programs and proves them:
//
//     #include <clearcut/clearcut.h>
//
//     const clearcut::Part part = clearcut::read_part("bracket.dxf", {});
//     clearcut::PlanOptions options;
//     options.tools = {clearcut::parse_tool("endmill:6")};
//     const clearcut::PlanResult result = clearcut::plan_part(part, options);
//     if (result.findings.all.clean) machine.send(result.program);
//
// Units     mm, radians and seconds; x right, y up, z the height of the tool's tip.
// Errors    InputError for files and wishes that cannot be met, Cancelled where the caller asked to stop, InternalError for a
//           broken promise of ours. What a plan leaves undone is in its Findings and Diagnostics, never thrown.
// Threads   every function may be called from several threads at once. There is no global state. Nothing is printed, nothing
//           exits; files are written by write_files() alone.
// Promise   the names of these headers in the namespace `clearcut`, and the values that they take and give. No stage stands behind an
//           include: namespaces of stages (clearcut::plan, clearcut::read, ...) are not seen by users and may change.
#pragma once

#include "clearcut/copies.h"
#include "clearcut/elements.h"
#include "clearcut/error.h"
#include "clearcut/file.h"
#include "clearcut/geometry.h"
#include "clearcut/infill.h"
#include "clearcut/order.h"
#include "clearcut/part.h"
#include "clearcut/plan.h"
#include "clearcut/report.h"
#include "clearcut/setups.h"
#include "clearcut/strategy.h"
#include "clearcut/text.h"
#include "clearcut/verify.h"
#include "clearcut/version.h"
#include "clearcut/witness.h"
