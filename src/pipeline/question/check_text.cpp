#include "pipeline/question/check_text.h"

#include <exception>
#include <new>

#include "base/error.h"
#include "base/file.h"
#include "pipeline/check.h"
#include "pipeline/question/question.h"
#include "pipeline/texts.h"
#include "read/common/text.h"

namespace clearcut::pipeline {
namespace {

std::string certificate_of(std::string_view program, std::string_view text) {
  const Question question = read_question(text);
  const std::string contents(program);
  const CheckResult result =
      question.part
          ? check_program(*question.part, contents, question.program_name, question.options, question.dialect)
          : check_program_alone(question.stock, contents, question.program_name, question.options,
                                question.dialect, question.top);
  CertificateBasis basis;
  basis.command = "verify";
  basis.inputs.push_back({"question", kQuestion, sha256_hex(text)});
  basis.program_name = question.program_name;
  basis.dialect_stated = question.dialect.has_value();
  return write_certificate(result, question.options, basis, contents);
}

/// `text` as a JSON string.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : read::printable(text)) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

std::string error_of(const std::string& what) {
  return "{\"error\": " + quoted(what) + "}";
}

}  // namespace

std::string check_text(std::string_view program, std::string_view question) {
  try {
    return certificate_of(program, question);
  } catch (const InputError& error) {
    return error_of(error.what());
  } catch (const std::bad_alloc&) {
    return error_of("the memory does not suffice; check a smaller program");
  } catch (const std::exception& error) {
    return error_of(std::string("internal fault: ") + error.what());
  }
}

}  // namespace clearcut::pipeline
