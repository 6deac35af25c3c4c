#include "post/words/comment.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/text.h"
#include "base/units.h"

namespace clearcut::post {
namespace {

/// Decimals of an inch in sizes of tools.
constexpr int kInchDecimals = 4;
/// mm. Greatest error of these decimals for a size to count as exact.
constexpr double kSameSize = 1e-5;

void append_blank(std::string& text) {
  if (!text.empty() && text.back() != ' ') text += ' ';
}

}  // namespace

std::string plain_comment(std::string_view text) {
  constexpr std::string_view kPunctuation = "+-=/.,:_<>#'";
  std::string plain;
  bool first_word = true;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ',' && first_word) {
      plain += ':';
    } else if (c == ' ') {
      append_blank(plain);
    } else if (byte < 128 && (std::isalnum(byte) || kPunctuation.find(c) != std::string_view::npos)) {
      plain += static_cast<char>(std::toupper(byte));
    } else if (byte < 128 || byte >= 192) {  // one mark for a whole UTF-8 character
      if (c == '(' || c == ')' || std::isspace(byte)) {
        append_blank(plain);
      } else {
        plain += '.';
      }
    }
    first_word = first_word && (std::isalnum(byte) || c == ' ' || c == '_');
  }
  while (!plain.empty() && plain.back() == ' ') plain.pop_back();
  return plain;
}

std::vector<std::string> comment_pieces(std::string_view text, std::size_t room) {
  std::vector<std::string> pieces;
  std::string rest = plain_comment(text);
  while (rest.size() > room) {
    const std::size_t blank = rest.rfind(' ', room);
    const bool between = blank != std::string::npos && blank > 0;
    pieces.push_back(rest.substr(0, between ? blank : room));
    rest = plain_comment(rest.substr(between ? blank + 1 : room));  // its first word is now first
  }
  pieces.push_back(rest);
  return pieces;
}

std::string operation_comment(int place, std::string_view label) {
  const std::string number = place > 0 ? " " + std::to_string(place) : "";
  return "OPERATION" + number + ": " + plain_comment(label);
}

std::string size_text(double mm, bool inch) {
  if (!inch) return trimmed(mm, 4) + " MM";
  const std::string inches = trimmed(mm / kMmPerInch, kInchDecimals);
  const bool exact = std::abs(std::stod(inches) * kMmPerInch - mm) < kSameSize;
  return inches + " IN" + (exact ? "" : " = " + trimmed(mm, 4) + " MM");
}

std::string shape_words(const Tool& tool, bool inch) {
  std::string words;
  if (is_conical(tool)) words += " " + trimmed(tool.tip_angle->degrees(), 2) + " DEG";
  if (is_conical(tool) && tool.tip_diameter > 0) words += " TIP " + size_text(tool.tip_diameter, inch);
  if (tool.kind == ToolKind::kTapered)
    words += " TAPER " + trimmed(tool.tip_angle.value_or(Radians{}).degrees() / 2, 2) + " DEG A SIDE";
  if (tool.kind == ToolKind::kTSlot && tool.flute_length)
    words += " HIGH " + size_text(*tool.flute_length, inch) + " NECK " + size_text(tool.shank_diameter, inch);
  const bool rounded = tool.corner_radius > 0 && tool.corner_radius < tool.radius();
  if (rounded) words += " R " + size_text(tool.corner_radius, inch);
  const std::string pitch = inch ? size_text(tool.pitch, true) : trimmed(tool.pitch, 4);
  return words + (tool.pitch > 0 ? " PITCH " + pitch : "") + (tool.left_hand ? " LEFT HAND" : "") +
         (tool.floating ? " FLOATING HOLDER" : "");
}

std::string tool_change_comment(const Part& part, int number, bool inch) {
  const std::string change = "TOOL CHANGE T" + std::to_string(number);
  const Tool* const tool = tool_numbered(part.tools, number);
  if (tool == nullptr) return change;
  return change + ": " + plain_comment(name_of(tool->kind)) + " D" + size_text(tool->diameter, inch) +
         shape_words(*tool, inch);
}

int program_number(std::string_view name) {
  if (!name.empty() && (name.front() == 'O' || name.front() == 'o')) name.remove_prefix(1);
  const bool digits = !name.empty() && name.size() <= 4 &&
                      std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int number = digits ? std::stoi(std::string(name)) : 0;
  return number > 0 ? number : 1;
}

}  // namespace clearcut::post
