#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "read/common/foreign_files.h"
#include "read/gcode/klartext/words.h"
#include "read/gcode/recognise.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

constexpr std::string_view kBlank = " \t\r\n\xEF\xBB\xBF";  // with the byte order mark
constexpr const char* kGive = "give the text that the post wrote for the machine";

std::string_view trimmed_left(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(kBlank), text.size()));
}

/// "[part]", after comments.
bool is_job(std::string_view text) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    line = trimmed_left(line);
    const bool is_comment = line.size() > 1 && line[0] == '#' && (line[1] == ' ' || line[1] == '#');
    if (!line.empty() && !is_comment) return line[0] == '[';
  }
  return false;
}

/// A first line with nothing but the number of a group: no block of a program begins with a digit.
bool is_dxf(std::string_view start) {
  const std::string_view line = start.substr(0, start.find_first_of("\r\n"));
  return line == "0" || line == "999" || start.substr(0, 18) == "AutoCAD Binary DXF";
}

/// Also in programs M48 is a word, so the unit of a drill file has to be there.
bool is_drill_file(std::string_view start) {
  const std::string_view head = start.substr(0, 4096);
  return start.substr(0, 3) == "M48" &&
         (head.find("METRIC") != std::string_view::npos || head.find("INCH") != std::string_view::npos);
}

/// What a part is read from, by how it starts; "" for none.
std::string_view part_file(std::string_view start) {
  if (is_dxf(start)) return "a DXF drawing";
  const FileKind kind = kind_of_content(start);
  if (kind == FileKind::kStep) return "a STEP file";
  if (kind == FileKind::kSvg && start[0] == '<') return "an SVG drawing";
  if (kind == FileKind::kJson) return "a JSON file";
  if (kind == FileKind::kGerber) return "a Gerber file";
  if (kind == FileKind::kExcellon && is_drill_file(start)) return "an Excellon drill file";
  return is_job(start) ? "a job file" : "";
}

bool begins_number(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == '+' || c == '-';
}

/// Whether a line begins as blocks do: a letter and a number, or what stands for one where programs compute.
bool is_block(std::string_view line) {
  line = trimmed_left(line);
  if (line.substr(0, 1) == "/") line = trimmed_left(line.substr(1));
  if (line.empty()) return false;
  if (line[0] == '#' || line[0] == ':') return true;
  if (!std::isalpha(static_cast<unsigned char>(line[0]))) return false;
  line = trimmed_left(line.substr(1));
  return !line.empty() && (begins_number(line[0]) || line[0] == '#' || line[0] == '[' || line[0] == '<');
}

bool has_blocks(std::string_view text) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    // A comment may stand before the first word.
    line = trimmed_left(line);
    while (!line.empty() && line[0] == '(' && line.find(')') != std::string_view::npos)
      line = trimmed_left(line.substr(line.find(')') + 1));
    if (is_block(line)) return true;
  }
  return false;
}

}  // namespace

void refuse_what_is_no_program(std::string_view text, const std::string& file_name) {
  const std::string_view start = trimmed_left(text);
  if (start.empty()) throw InputError(file_name, std::string("the file is empty; ") + kGive);
  const std::string_view foreign = foreign_content(text, file_name), part = part_file(start);
  if (!foreign.empty())
    throw InputError(file_name, "this is " + std::string(foreign) + ", no program; " + kGive);
  if (!part.empty())
    throw InputError(file_name, "this is " + std::string(part) +
                                    ", no program; give it as the part, and the program that is to make it");
  if (text.substr(0, 4096).find('\0') != std::string_view::npos)
    throw InputError(file_name, std::string("this is a binary file or UTF-16 text, no program; ") + kGive);
  if (!is_klartext(text) && !has_blocks(text))
    throw InputError(file_name,
                     std::string("no line of it is a block of a program, such as G1 X10 F300; ") + kGive);
}

}  // namespace clearcut::read::gcode
