#include "output.h"

#include <cstdio>

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

}  // namespace clearcut::cli
