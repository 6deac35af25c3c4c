#include "terminal/output.h"

#include <clearcut/error.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "terminal/signals_held.h"
#include "terminal/terminal.h"

namespace clearcut::cli {
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
