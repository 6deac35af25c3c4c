// The check of a program as a function of texts, for programs in other languages.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::pipeline {

/// Checks `program` as `question` (a JSON object, docs/gate.md) asks: alone, or against a part given as outlines.
///
/// Returns the certificate as JSON; for a question or a program that cannot be understood an object with one member, "error": one
///         line with its place and remedy. Reads and writes no file. Throws nothing.
std::string check_text(std::string_view program, std::string_view question);

}  // namespace clearcut::pipeline
