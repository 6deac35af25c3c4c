#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <regex>

#include "base/text.h"
#include "base/units.h"
#include "read/gcode/recognise.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

/// mm; no comment describes a cutter beyond it.
constexpr double kWidest = 300;

/// Words of a kind of tool, the more special first, and the kind as --tool names it; "": one whose shape takes more than a diameter.
struct KindWord {
  const char* word;
  const char* kind;
};
constexpr KindWord kKindWords[] = {
    {"v-bit", ""},           {"vbit", ""},         {"v bit", ""},         {"engrav", ""},
    {"chamfer", ""},         {"spot", ""},         {"center", ""},        {"countersink", ""},
    {"thread", ""},          {"tapered", ""},      {"bull", "endmill"},   {"ball", "ball"},
    {"drill", "drill"},      {"reamer", "reamer"}, {"face", "facemill"},  {"endmill", "endmill"},
    {"end mill", "endmill"}, {"flat", "endmill"},  {"router", "endmill"}, {"cutter", "endmill"},
    {"mill", "endmill"},     {"bit", "endmill"},   {"tool", "endmill"}};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

const char* kind_in(const std::string& comment) {
  for (const KindWord& entry : kKindWords)
    if (comment.find(entry.word) != std::string::npos) return entry.kind;
  return nullptr;
}

double unit_of(const std::string& text, double unit) {
  if (text == "mm") return 1;
  return text.empty() ? unit : kMmPerInch;
}

/// mm; the diameter that a comment states, `unit` mm where it says none. A kind of tool beside it makes a plain size one.
std::optional<double> diameter_in(const std::string& comment, double unit, bool has_kind) {
  static const std::regex said(
      R"((?:\bd|dia(?:m(?:eter)?)?\.?)\s*[:=]?\s*(\d+\.?\d*|\.\d+)\s*(mm|in\b|inch|")?)");
  static const std::regex with_unit(R"((\d+\.?\d*|\.\d+)\s*(mm|in\b|inch|"))");
  static const std::regex behind_bar(R"(\|\s*(\d+\.?\d*|\.\d+)\s)");
  static const std::regex behind_colon(R"(^\s*t\s*\d+\s*:\s*(\d+\.?\d*|\.\d+)\s*$)");
  static const std::regex fraction(R"((\d+)\s*/\s*(\d+)\s*(?:in\b|inch|"))");
  std::smatch found;
  if (std::regex_search(comment, found, fraction)) {
    const double below = std::atof(found[2].str().c_str());
    return below > 0 ? std::optional(std::atof(found[1].str().c_str()) / below * kMmPerInch) : std::nullopt;
  }
  const auto value = [&](double of) { return std::atof(found[1].str().c_str()) * of; };
  if (std::regex_search(comment, found, said)) return value(unit_of(found[2].str(), unit));
  if (has_kind && std::regex_search(comment, found, with_unit)) return value(unit_of(found[2].str(), unit));
  if (has_kind && std::regex_search(comment, found, behind_bar)) return value(unit);
  if (std::regex_search(comment, found, behind_colon)) return value(unit);
  return std::nullopt;
}

/// The T word of a comment, or the number before what it describes.
int number_in_comment(const std::string& comment) {
  static const std::regex numbered(R"((?:\bt|\btool)\s*#?(\d{1,4})\b|^\s*(\d{1,4})\s*=)");
  std::smatch found;
  if (!std::regex_search(comment, found, numbered)) return 0;
  return std::atoi((found[1].matched ? found[1] : found[2]).str().c_str());
}

/// ":corner=1" of a bull-nose mill, "" of others.
std::string corner_in(const std::string& comment, double unit, double diameter) {
  static const std::regex corner(R"(\bcr\s*=\s*(\d+\.?\d*|\.\d+))");
  std::smatch found;
  if (!std::regex_search(comment, found, corner)) return "";
  const double radius = std::atof(found[1].str().c_str()) * unit;
  return radius > 0 && radius < diameter / 2 ? ":corner=" + trimmed(radius, 4) : "";
}

std::optional<ToolComment> tool_in(const std::string& comment, double unit) {
  const char* const kind = kind_in(comment);
  if (kind && *kind == '\0') return std::nullopt;
  const auto diameter = diameter_in(comment, unit, kind != nullptr);
  if (!diameter || !(*diameter > 0) || *diameter > kWidest) return std::nullopt;
  ToolComment tool;
  tool.number = number_in_comment(comment);
  if (!kind && tool.number == 0) return std::nullopt;
  tool.tool = std::string(kind ? kind : "endmill") + ":" + trimmed(*diameter, 4) +
              corner_in(comment, unit, *diameter);
  return tool;
}

/// What of a line stands in parentheses or behind a semicolon; and the rest.
struct Parts {
  std::vector<std::string> comments;
  std::string code;
};

Parts parts_of(std::string_view line) {
  Parts parts;
  while (!line.empty()) {
    const std::size_t begin = line.find_first_of("(;");
    parts.code += lower_case(line.substr(0, begin));
    if (begin == std::string_view::npos) break;
    const bool rest = line[begin] == ';';
    const std::size_t end = rest ? line.size() : std::min(line.find(')', begin), line.size());
    parts.comments.push_back(lower_case(line.substr(begin + 1, end - begin - 1)));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return parts;
}

/// The T word of a line's code, 0 where it has none.
int called_in(const std::string& code) {
  static const std::regex call(R"((?:^|[^a-z])(?:t|tool call )\s*0*(\d{1,4})(?!\d))");
  std::smatch found;
  return std::regex_search(code, found, call) ? std::atoi(found[1].str().c_str()) : 0;
}

/// mm in one unit of length of the program, from its first word that states a unit; without such a word 1.
double unit_of_program(std::string_view text) {
  static const std::regex inches(R"((?:^|[^a-z0-9])g0?[27]0(?![0-9.])|begin pgm .* inch)");
  static const std::regex mm(R"((?:^|[^a-z0-9])g0?[27]1(?![0-9.])|begin pgm .* mm)");
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    const std::string code = parts_of(line.substr(0, 400)).code;
    if (std::regex_search(code, inches)) return kMmPerInch;
    if (std::regex_search(code, mm)) return 1;
  }
  return 1;
}

/// Longer lines hold no comment of a post.
constexpr std::size_t kLongestLine = 400;

}  // namespace

std::vector<ToolComment> tools_in_comments(std::string_view text) {
  const double unit = unit_of_program(text);
  std::vector<ToolComment> tools;
  const auto is_known = [&](int number) {
    return std::any_of(tools.begin(), tools.end(),
                       [&](const ToolComment& one) { return one.number == number; });
  };
  std::optional<ToolComment> waiting;  // described before its T word
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    const Parts parts = parts_of(line.substr(0, kLongestLine));
    const int called = called_in(parts.code);
    for (const std::string& comment : parts.comments) {
      std::optional<ToolComment> tool = tool_in(comment, unit);
      if (!tool) continue;
      tool->line = lines.number();
      if (tool->number == 0) tool->number = called;
      if (tool->number == 0)
        waiting = waiting.value_or(*tool);
      else if (!is_known(tool->number))
        tools.push_back(*tool);
    }
    if (called == 0 || !waiting) continue;
    waiting->number = called;
    if (!is_known(called)) tools.push_back(*waiting);
    waiting.reset();
  }
  if (waiting && tools.empty()) tools.push_back(*waiting);
  for (ToolComment& one : tools)
    if (one.number > 0) one.tool += ":T" + std::to_string(one.number);
  return tools;
}

std::vector<int> tools_announced(std::string_view text) {
  constexpr std::string_view kSays = "tool change t";
  std::vector<int> numbers;
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    for (const std::string& comment : parts_of(line.substr(0, kLongestLine)).comments) {
      const auto at = comment.find(kSays);
      const int number = at == std::string::npos ? 0 : std::atoi(comment.c_str() + at + kSays.size());
      if (number > 0) numbers.push_back(number);
    }
  }
  return numbers;
}

}  // namespace clearcut::read::gcode
