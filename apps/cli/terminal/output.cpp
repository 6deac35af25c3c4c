#include "terminal/output.h"

#include <clearcut/error.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace clearcut::cli {
namespace {

constexpr std::size_t kDefaultWidth = 80;
constexpr std::size_t kLeastWidth = 40;
/// Wider than any table.
constexpr std::size_t kUnbroken = 100000;

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

std::optional<std::size_t> width_given() {
  if (const auto shown = terminal_columns()) return shown;
  const char* columns = std::getenv("COLUMNS");
  const int width = columns == nullptr ? 0 : std::atoi(columns);
  return width > 0 ? std::optional(static_cast<std::size_t>(width)) : std::nullopt;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kColours{
    {{"CLEAN", "\x1b[32m"}, {"CONDITIONAL", "\x1b[33m"}, {"FAULTY", "\x1b[31m"}}};

/// The verdict stated in a line, "" for others.
std::string_view verdict_in(std::string_view line) {
  constexpr std::string_view kLabel = "verdict: ";
  if (line.starts_with(kLabel)) line.remove_prefix(kLabel.size());
  for (const auto& [word, colour] : kColours) {
    if (line.starts_with(word) && (line.size() == word.size() || line[word.size()] == ' ' ||
                                   line[word.size()] == ':' || line[word.size()] == ','))
      return word;
  }
  return "";
}

std::string coloured(const std::string& line) {
  const std::string_view verdict = verdict_in(line);
  if (verdict.empty()) return line;
  const auto* const colour =
      std::find_if(kColours.begin(), kColours.end(), [&](const auto& one) { return one.first == verdict; });
  const std::size_t at = line.find(verdict);
  return line.substr(0, at) + std::string(colour->second) + std::string(verdict) + "\x1b[0m" +
         line.substr(at + verdict.size());
}

}  // namespace

std::size_t text_width() {
  return std::max(width_given().value_or(kDefaultWidth), kLeastWidth);
}

std::size_t table_width() {
  return std::max(width_given().value_or(kUnbroken), kLeastWidth);
}

bool shows_colours() {
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
  return output_is_terminal() && !is_set("NO_COLOR") && !dumb;
}

std::string with_colours(const std::string& text) {
  if (!shows_colours()) return text;
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out += coloured(text.substr(at, end - at));
    if (end < text.size()) out += '\n';
    at = end + 1;
  }
  return out;
}

namespace {

const char* word_for(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kRepair:
      return "repaired";
    case Severity::kWarning:
      return "warning";
    case Severity::kSkipped:
      return "skipped";
  }
  return "note";
}

}  // namespace

void print(const Diagnostics& diagnostics, bool verbose) {
  for (const auto& item : diagnostics.items()) {
    if (item.severity == Severity::kNote && !verbose) continue;
    std::fprintf(stderr, "%s: %s: %s\n", word_for(item.severity), item.where.c_str(), item.what.c_str());
  }
}

void print_warnings(const Diagnostics& diagnostics) {
  for (const auto& item : diagnostics.items()) {
    if (item.severity == Severity::kWarning)
      std::fprintf(stderr, "%s: %s: %s\n", word_for(item.severity), item.where.c_str(), item.what.c_str());
  }
}

void print_line(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (text.empty() || text.back() != '\n') std::fputc('\n', stdout);
}

void print_left_out(int setup, const NothingToMachine& why, bool verbose) {
  print_line("set-up " + std::to_string(setup) +
             (why.is_done() ? ": no program, as nothing in it is left to cut: "
                            : ": no program, as nothing in it can be machined: ") +
             why.what());
  if (verbose) print(why.said(), true);
  for (const auto& name : names_not_machined(why.said())) print_line("NOT MACHINED: " + name);
}

void complain(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::fprintf(stderr, "clearcut: %s\n", message.c_str());
}

void print_table(const TextTable& table, bool as_markdown) {
  print_line(as_markdown ? markdown(table) : fitted(table, table_width()));
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

void write_outputs(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.path);
  check_outputs(names, inputs);
  std::vector<OutputFile> named, printed;
  for (const auto& file : files) (file.path == "-" ? printed : named).push_back(file);
  {
    const SignalsHeld signals;
    write_files(named, inputs, SignalsHeld::any);
  }
  for (const auto& file : printed) {
    const std::size_t written = std::fwrite(file.content.data(), 1, file.content.size(), stdout);
    if (written != file.content.size() || std::fflush(stdout) != 0)
      throw InputError("standard output", "cannot be written; check that it has room");
  }
}

}  // namespace clearcut::cli
