// Relations of a certificate's question: between its workplan and features, its tools, limits, machine and values, and its arguments.
#pragma once

#include "report/certificate/certificate_fields.h"

namespace clearcut::report {

/// Adds a sentence for every field that others of the certificate exclude.
void check_question(const nlohmann::ordered_json& certificate, Sentences& out);

}  // namespace clearcut::report
