#include <toml++/toml.h>

#include "base/error.h"
#include "read/common/data_value.h"

namespace clearcut::read {
namespace {

int line_of(const toml::source_region& source) {
  return static_cast<int>(source.begin.line);
}

constexpr int kDeepest = 64;

DataValue converted(const toml::node& node, const std::string& file, int depth);

DataValue scalar(const toml::node& node, const std::string& file) {
  DataValue out;
  out.line = line_of(node.source());
  if (const auto* number = node.as_floating_point()) {
    out.kind = DataValue::Kind::kNumber;
    out.number = number->get();
  } else if (const auto* integer = node.as_integer()) {
    out.kind = DataValue::Kind::kNumber;
    out.number = static_cast<double>(integer->get());
  } else if (const auto* text = node.as_string()) {
    out.kind = DataValue::Kind::kString;
    out.text = text->get();
  } else if (const auto* boolean = node.as_boolean()) {
    out.kind = DataValue::Kind::kBoolean;
    out.boolean = boolean->get();
  } else {
    throw InputError(file + ":" + std::to_string(out.line), "dates and times have no use here; remove it");
  }
  return out;
}

DataValue converted_table(const toml::table& table, const std::string& file, int depth) {
  DataValue out;
  out.kind = DataValue::Kind::kObject;
  out.line = line_of(table.source());
  for (const auto& [key, value] : table) {
    out.members.push_back({std::string(key.str()), converted(value, file, depth + 1)});
    // An implied table in brackets has no line of its own; its key has one.
    DataValue& made = out.members.back().value;
    if (made.line == 0) made.line = line_of(key.source());
  }
  return out;
}

DataValue converted(const toml::node& node, const std::string& file, int depth) {
  if (depth > kDeepest) {
    throw InputError(file + ":" + std::to_string(line_of(node.source())),
                     "nested deeper than 64 levels; simplify it");
  }
  if (const auto* table = node.as_table()) return converted_table(*table, file, depth);
  const auto* array = node.as_array();
  if (!array) return scalar(node, file);
  DataValue out;
  out.kind = DataValue::Kind::kArray;
  out.line = line_of(array->source());
  for (const toml::node& item : *array) out.items.push_back(converted(item, file, depth + 1));
  if (out.line == 0 && !out.items.empty()) out.line = out.items.front().line;
  return out;
}

/// The library's reason on one line.
std::string one_line(std::string_view reason) {
  std::string out(reason.substr(0, 160));
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return out;
}

/// Dotted keys of very many parts, which the library processes by recursion until the stack overflows.
void refuse_long_keys(std::string_view text, const std::string& file) {
  int dots = 0, line = 1;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++line;
    if (quote != 0) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '.' && ++dots > kDeepest) {
      throw InputError(file + ":" + std::to_string(line), "a key of more than 64 parts; simplify it");
    } else if (std::string_view("\n,=[]{}").find(c) != std::string_view::npos) {
      dots = 0;
    }
  }
}

}  // namespace

DataValue parse_toml(std::string_view text, const std::string& file_name) {
  refuse_long_keys(text, file_name);
  try {
    const toml::table table = toml::parse(text, file_name);
    DataValue root = converted_table(table, file_name, 0);
    root.line = 1;
    return root;
  } catch (const toml::parse_error& error) {
    throw InputError(file_name + ":" + std::to_string(line_of(error.source())),
                     "not TOML (" + one_line(error.description()) + "); mend the text there");
  }
}

}  // namespace clearcut::read
