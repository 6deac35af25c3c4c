// Relations that hold among the figures of every true certificate: within the figures of the whole, a feature or a layer, and between
// the whole and its features, a feature and its layers.
#pragma once

#include "report/certificate/certificate_fields.h"

namespace clearcut::report {

/// Adds a sentence for every figure that the other figures of the certificate exclude.
void check_figures(const nlohmann::ordered_json& certificate, Sentences& out);

}  // namespace clearcut::report
