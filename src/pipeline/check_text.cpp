#include "pipeline/check_text.h"

#include <algorithm>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "options/idle.h"
#include "options/row.h"
#include "pipeline/check.h"
#include "pipeline/stated_machine.h"
#include "pipeline/texts.h"
#include "read/common/data_value.h"
#include "read/common/text.h"
#include "read/drawing/layer_rules.h"
#include "read/job/machine_file.h"
#include "read/job/machine_library.h"
#include "read/job/read_part.h"
#include "read/outline/outline_reader.h"

namespace clearcut::pipeline {
namespace {

/// Name of the question's text in messages and certificates.
constexpr const char* kQuestion = "question";

struct Question {
  std::string program_name = "program";  ///< in messages and in the certificate
  std::optional<Dialect> dialect;        ///< absent: recognised
  std::optional<Part> part;              ///< absent: the program is checked alone
  std::optional<Stock> stock;            ///< of a program alone
  std::optional<double> top;             ///< mm; of a program alone
  PlanOptions options;
};

/// "question:LINE", or "question:LINE: KEY".
std::string place_of(const read::DataValue& value, const std::string& key = "") {
  return std::string(kQuestion) + ":" + std::to_string(value.line) + (key.empty() ? "" : ": " + key);
}

/// A number, a text or a truth value as `clearcut verify` takes it.
std::string text_of(const read::DataValue& value, const std::string& place) {
  if (value.is_string()) return value.text;
  if (value.is_number()) return trimmed(value.number, 9);
  throw InputError(place, "must be a number, a text, true, or a list of them");
}

std::vector<std::string> texts_of(const read::DataValue& value, const std::string& place) {
  if (!value.is_array()) return {text_of(value, place)};
  std::vector<std::string> texts;
  for (const read::DataValue& item : value.items) texts.push_back(text_of(item, place));
  return texts;
}

const Row& row_of(const std::string& name, const std::string& place) {
  const Row* const row = row_named(name);
  if (row && row->checks & kCheckOfTexts) return *row;
  const std::string meant = row ? "" : nearest_name(name, question_options());
  throw InputError(place, (row ? "is not asked of a check of texts" : "is no option") +
                              (meant.empty() ? "; docs/verify-module.md lists those there are"
                                             : "; did you mean '" + meant + "'?"));
}

void take_option(const read::DataMember& member, Asked& asked) {
  const std::string place = place_of(member.value, read::printable(member.key));
  const Row& row = row_of(member.key, place);
  if (row.kind == ValueKind::kFlag) {
    if (member.value.kind != read::DataValue::Kind::kBoolean)
      throw InputError(place, "must be true or false");
    if (member.value.boolean) row.field.set(asked, Value(true), row.names);
    return;
  }
  const std::vector<std::string> texts = texts_of(member.value, place);
  if (!takes_several(row.kind) && texts.size() != 1) throw InputError(place, "must be one value");
  row.field.set(
      asked,
      takes_several(row.kind) ? value_of_texts(row, texts, place) : value_of_text(row, texts[0], place),
      row.names);
}

/// A name of the library, the settings of a control as text, or an object with the keys of a machine file.
Machine machine_of(const read::DataValue& value, Sources& sources) {
  const std::string place = place_of(value, "machine");
  if (value.is_object()) {
    sources.merge(read::machine_sources_of(value, kQuestion, Origin::kMachineFile));
    return read::machine_of_section(read::DataSection(value, kQuestion, "machine"), Machine{});
  }
  if (!value.is_string()) throw InputError(place, "must be a name, the settings of a control, or an object");
  std::optional<Machine> machine = read::library_machine(value.text);
  if (!machine)
    if (const auto settings = read::read_machine_settings(value.text, place)) machine = settings->machine;
  if (!machine)
    throw InputError(place, "'" + read::printable(value.text.substr(0, 40)) +
                                "' is neither a machine of the library nor the settings of a control");
  for (const char* const key : {"machine", "planner"}) sources.set(key, {Origin::kMachineFile, place});
  return *machine;
}

/// The part with what the options say of it.
Part part_of(const read::DataValue& value, const InputOptions& input) {
  const ReadOptions options = read::completed(read::read_options_of(input));
  Part part = read::as_asked(read::read_outline_value(value, kQuestion, options), options, kQuestion);
  if (input.clearance_z) part.clearance_z = input.clearance_z;
  return part;
}

using Members = std::vector<read::DataMember>;

/// Refuses options that have no effect: those of the part without one, those of other inputs with one.
void refuse_idle(const Members& options, const std::optional<Part>& part) {
  for (const read::DataMember& member : options) {
    const Row& row = *row_named(member.key);
    const std::string place = place_of(member.value, member.key);
    if (part) {
      const std::string reason = idle_on_input(row, input_kind_of(*part));
      if (!reason.empty()) throw InputError(place, reason);
    } else if (!(row.checks & kCheckOfProgram)) {
      throw InputError(place, "needs a part");
    }
  }
}

/// The members of `options`; none where the question has none.
Members stated_options(const read::DataValue& root) {
  const read::DataValue* const options = root.find("options");
  if (!options) return {};
  if (!options->is_object())
    throw InputError(place_of(*options, "options"), "must be an object of names and values");
  return options->members;
}

/// The machine of the question, with the values of it that its options state.
void take_machine(const read::DataValue& root, const Members& stated, const InputOptions& input,
                  PlanOptions& options) {
  Machine machine;
  if (const read::DataValue* const value = root.find("machine")) {
    machine = machine_of(*value, options.sources);
    accept_what_is_held(options.sources, options);
  }
  const auto is_typed = [&](std::string_view name) {
    return std::any_of(stated.begin(), stated.end(), [&](const auto& member) { return member.key == name; });
  };
  options.machine = with_typed(std::move(machine), {input.machine_kind, options.machine, is_typed});
}

/// The whole text as one object.
Question question_of(const read::DataValue& root) {
  read::DataSection section(root, kQuestion, "");
  Question question;
  if (const auto name = section.text("name")) question.program_name = *name;
  if (const auto name = section.text("dialect")) {
    question.dialect = read::gcode::dialect_named(*name);
    if (!question.dialect)
      section.fail_at("dialect", "'" + read::printable(*name) + "' is no control that is known");
  }
  const std::vector<std::string> tools = section.texts("tools");
  const auto stock = section.text("stock");
  question.top = section.number("top");
  for (const char* const key : {"part", "machine", "options"}) section.value(key);
  section.refuse_unknown();

  const Members stated = stated_options(root);
  Asked asked;
  for (const read::DataMember& member : stated) take_option(member, asked);
  question.options = std::move(asked.plan);
  const InputOptions& input = asked.input;
  if (const read::DataValue* const part = root.find("part")) question.part = part_of(*part, input);
  refuse_idle(stated, question.part);
  if (!question.part && !question.top) question.top = input.top;
  if (question.part && (stock || question.top))
    section.fail_at(stock ? "stock" : "top", "is asked without a part; the part states its stock");
  if (stock) question.stock = resolve::parse_stock(*stock, question.top.value_or(0));
  for (const std::string& tool : tools) question.options.tools.push_back(resolve::parse_tool(tool));
  resolve::add_places(input.keep_outs, input.predrilled, question.options);
  take_machine(root, stated, input, question.options);
  for (const read::DataMember& member : stated)
    question.options.sources.set(member.key, {Origin::kUser, place_of(member.value)});
  question.options.threads = 1;
  resolve::check(question.options);
  return question;
}

std::string certificate_of(std::string_view program, std::string_view text) {
  const Question question = question_of(read::parse_json(text, kQuestion));
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

std::string error_of(const std::string& what) {
  return "{\"error\": " + nlohmann::json(read::printable(what)).dump() + "}";
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

std::vector<std::string> question_options() {
  std::vector<std::string> names;
  for (const Row& row : rows())
    if (row.checks & kCheckOfTexts) names.push_back(row.name);
  return names;
}

}  // namespace clearcut::pipeline
