#include "serve/works/result_files.h"

#include <array>
#include <filesystem>
#include <regex>

namespace clearcut::serve {
namespace {

constexpr const char* kPage = "text/html; charset=utf-8";
constexpr const char* kText = "text/plain; charset=utf-8";
constexpr std::array<ResultKind, 8> kKinds{
    {{"program", ".ngc", kText, "The program for the controller", true},
     {"certificate", ".json", "application/json", "The certificate", true},
     {"report", ".html", kPage, "The page that plays the machining; of elements the page of their squares",
      true},
     {"picture", ".svg", "image/svg+xml", "The picture", true},
     {"setup-sheet", ".html", kPage, "The page for the machine", false},
     {"points", ".csv", "text/csv; charset=utf-8", "The table of all points of elements", false},
     {"tour", ".json", "application/json",
      "The points of a tour in their order, with figures and convergence", false},
     {"text", ".txt", kText, "What the command prints", false}}};

bool is_setup_number(std::string_view text) {
  static const std::regex number("-[1-9][0-9]?");
  return std::regex_match(text.begin(), text.end(), number);
}

}  // namespace

std::span<const ResultKind> result_kinds() {
  return kKinds;
}

const ResultKind* kind_of_result(std::string_view name) {
  for (const ResultKind& kind : kKinds) {
    if (!name.starts_with(kind.name)) continue;
    const std::string_view number = name.substr(std::string_view(kind.name).size());
    if (number.empty() || (kind.is_numbered && is_setup_number(number))) return &kind;
  }
  return nullptr;
}

std::string file_of_result(const ResultKind& kind, std::string_view name) {
  return std::string(name) + kind.ending;
}

std::vector<std::string> results_in(const std::filesystem::path& folder) {
  const auto is_there = [&](const ResultKind& kind, const std::string& name) {
    std::error_code absent;
    return std::filesystem::exists(folder / file_of_result(kind, name), absent);
  };
  std::vector<std::string> names;
  for (const ResultKind& kind : kKinds) {
    if (is_there(kind, kind.name)) names.emplace_back(kind.name);
    for (int setup = 1; kind.is_numbered; ++setup) {
      const std::string name = std::string(kind.name) + "-" + std::to_string(setup);
      if (!is_there(kind, name)) break;
      names.push_back(name);
    }
  }
  return names;
}

}  // namespace clearcut::serve
