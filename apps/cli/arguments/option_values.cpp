#include "arguments/option_values.h"

#include <fmt/format.h>

#include "arguments/suggest.h"

namespace clearcut::cli {
namespace {

std::string type_of(const Row& row) {
  if (!row.type.empty()) return row.type;
  if (row.kind == ValueKind::kFile || row.kind == ValueKind::kFiles) return "FILE";
  return is_number(row.kind) || row.kind == ValueKind::kSeed ? "FLOAT" : "TEXT";
}

/// Typed values are checked during parsing, so that mistakes are reported before any file is read.
CLI::Validator understood(const Row& row) {
  return {[&row](std::string& text) {
            const std::string place = "--" + row.name;
            if (takes_several(row.kind))
              value_of_texts(row, {text}, place);
            else
              value_of_text(row, text, place);
            return std::string();
          },
          ""};
}

}  // namespace

void OptionValues::add_row(CLI::App& command, const Row& row) {
  command.option_defaults()->group(name_of(row.group));
  const std::string typed = "--" + row.name;
  if (row.kind == ValueKind::kFlag) {
    command.add_flag(typed, flags_[row.name], row.described());
    return;
  }
  auto& texts = texts_[row.name];
  CLI::Option* option = command.add_option(typed, texts, row.described())->type_name(type_of(row));
  if (!takes_several(row.kind)) option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::Throw);
  if (row.kind == ValueKind::kPoints) option->allow_extra_args(false);
  option->check(understood(row));
  if (!row.names.empty()) option->check(for_example(row.names));
}

void OptionValues::add(CLI::App& command, const std::function<bool(const Row&)>& wanted) {
  for (const Row& row : rows())
    if (wanted(row)) add_row(command, row);
}

void OptionValues::set(const std::string& name, const std::vector<std::string>& values,
                       const std::string& place) {
  const Row& row = *row_named(name);
  if (row.kind == ValueKind::kFlag) {
    flags_[name] = true;
  } else {
    if (takes_several(row.kind))
      value_of_texts(row, values, place);
    else
      value_of_text(row, values.back(), place);
    texts_[name] = values;
  }
}

bool OptionValues::has(const std::string& name) const {
  const auto texts = texts_.find(name);
  if (texts != texts_.end()) return !texts->second.empty();
  const auto flag = flags_.find(name);
  return flag != flags_.end() && flag->second;
}

std::set<std::string> OptionValues::names() const {
  std::set<std::string> names;
  for (const Row& row : rows())
    if (has(row.name)) names.insert(row.name);
  return names;
}

void OptionValues::put_into(Asked& asked) const {
  for (const Row& row : rows()) {
    if (!has(row.name)) continue;
    const std::string place = "--" + row.name;
    const auto texts = texts_.find(row.name);
    const Value value = texts == texts_.end()     ? Value(true)
                        : takes_several(row.kind) ? value_of_texts(row, texts->second, place)
                                                  : value_of_text(row, texts->second.back(), place);
    row.field.set(asked, value, row.names);
  }
}

Asked OptionValues::asked() const {
  Asked asked;
  put_into(asked);
  return asked;
}

}  // namespace clearcut::cli
