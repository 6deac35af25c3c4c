#include "output.h"

#include <clearcut/error.h>

#include <cstdio>

#include "terminal.h"

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

void print_table(const TextTable& table, bool as_markdown) {
  print_line(as_markdown ? markdown(table) : fitted(table, output_width()));
}

void write_outputs(const std::vector<OutputFile>& files) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.path);
  check_outputs(names);
  std::vector<OutputFile> named, printed;
  for (const auto& file : files) (file.path == "-" ? printed : named).push_back(file);
  write_files(named);
  for (const auto& file : printed) {
    const std::size_t written = std::fwrite(file.content.data(), 1, file.content.size(), stdout);
    if (written != file.content.size() || std::fflush(stdout) != 0)
      throw InputError("standard output", "cannot be written; check that it has room");
  }
}

}  // namespace clearcut::cli
