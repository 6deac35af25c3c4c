// Conditions of a verdict as JSON: the same in the certificate and in the report's page.
#pragma once

#include <nlohmann/json.hpp>

#include "model/results/findings.h"

namespace clearcut::report {

/// Keys name, text, line (0: none) and met_by ("" while the condition is open).
nlohmann::ordered_json condition_json(const Condition& condition);

}  // namespace clearcut::report
