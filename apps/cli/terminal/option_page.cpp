#include "terminal/option_page.h"

#include <clearcut/options.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace clearcut::cli {
namespace {

std::string value_text(const Row& row) {
  if (row.kind == ValueKind::kFlag) return "";
  if (row.kind == ValueKind::kChoice) return fmt::format("{}", fmt::join(row.names, ", "));
  if (!row.counted_in().empty()) return row.counted_in();
  if (row.kind == ValueKind::kPoint || row.kind == ValueKind::kPoints) return "X,Y";
  if (row.kind == ValueKind::kFile || row.kind == ValueKind::kFiles) return "file";
  return is_number(row.kind) || row.kind == ValueKind::kSeed ? "number" : "text";
}

std::string job_text_of(const Row& row) {
  if (row.table == JobTable::kNone) return "";
  const std::string key = fmt::format("`[{}] {}`", name_of(row.table), row.job_key());
  return row.key_is_opposite ? key + " (opposite)" : key;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

}  // namespace

std::string options_page() {
  std::string text =
      "# All options of a plan\n\nMade by `clearcut generate table` from the table of options, "
      "[src/options/rows.cpp](../src/options/rows.cpp). Whatever is given and can have no effect on the part "
      "is "
      "refused, exit code 2, with what it serves.\n";
  const Group* group = nullptr;
  for (const Row& row : rows()) {
    if (!group || *group != row.group) {
      text += fmt::format(
          "\n## {}\n\n| option | value | what it does | default | in a job |\n|---|---|---|---|---|\n",
          name_of(row.group));
      group = &row.group;
    }
    text += fmt::format("| `--{}` | {} | {} | {} | {} |\n", row.name, value_text(row), escaped(row.sentence),
                        escaped(row.fallback), job_text_of(row));
  }
  text.pop_back();
  return text;
}

}  // namespace clearcut::cli
