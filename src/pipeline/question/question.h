// Questions about a program as JSON text: what verify takes as arguments, without any file. docs/gate.md describes the keys.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/part.h"
#include "read/gcode/program/dialect.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// Name of the question's text in messages and certificates.
inline constexpr const char* kQuestion = "question";

struct Question {
  std::string program_name = "program";         ///< in messages and in the certificate
  std::optional<read::gcode::Dialect> dialect;  ///< absent: recognised
  std::optional<Part> part;                     ///< absent: the program is checked alone
  std::optional<Stock> stock;                   ///< of a program alone
  std::optional<double> top;                    ///< mm; of a program alone
  resolve::PlanOptions options;
};

/// Throws InputError "question:line: key: ..." for bad JSON, unknown keys and refused values.
Question read_question(std::string_view text);

/// Names of the rows of the table of options that a question may state.
std::vector<std::string> question_options();

}  // namespace clearcut::pipeline
