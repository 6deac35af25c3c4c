// The check of a program as a function of texts, for programs in other languages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clearcut::pipeline {

/// Checks `program` as `question` asks: alone, or against a part given as outlines. The question is a JSON object with what verify takes
/// as arguments, without any file; docs/verify-module.md describes its keys.
///
/// Returns the certificate as JSON; for a question or a program that cannot be understood an object with one member, "error": one
///         line with its place and remedy, "question:LINE: KEY: ..." in a question. Reads and writes no file. Throws nothing.
std::string check_text(std::string_view program, std::string_view question);

/// Names of the rows of the table of options that a question may state.
std::vector<std::string> question_options();

}  // namespace clearcut::pipeline
