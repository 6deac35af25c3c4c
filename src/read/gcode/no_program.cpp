#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/text.h"
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

std::string_view first_line(std::string_view text) {
  return text.substr(0, text.find_first_of("\r\n"));
}

/// The first line that is no comment of the kind that `is_comment` knows, without blanks at both ends; "" where there is none.
template <typename IsComment>
std::string_view first_block(std::string_view text, IsComment is_comment) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    line = stripped(line, kBlank);
    if (!line.empty() && !is_comment(line)) return line;
  }
  return {};
}

/// "[part]", after comments: no blank stands in the name, as in comments of some controls.
bool is_job(std::string_view text) {
  const std::string_view line = first_block(text, [](std::string_view one) {
    return one.size() > 1 && one[0] == '#' && (one[1] == ' ' || one[1] == '#');
  });
  return line.substr(0, 1) == "[" && line.substr(0, line.find(']')).find(' ') == std::string_view::npos;
}

/// Blocks of Heidenhain's ISO language end with a star.
bool is_iso_of_heidenhain(std::string_view start) {
  const std::string_view line = first_block(start, [](std::string_view one) { return one[0] == ';'; });
  return line.size() > 1 && line.back() == '*' && (line[0] == '%' || line[0] == 'N' || line[0] == 'G');
}

/// Commands of two letters with values behind commas; comments begin with an apostrophe.
bool is_shopbot(std::string_view start) {
  const std::string_view line = first_block(start, [](std::string_view one) {
    return one[0] == '\'' || one.substr(0, 3) == "IF " || one.substr(0, 1) == "&";
  });
  const std::string_view word = line.substr(0, line.find_first_of(" \t'"));
  return word == "SA" || word == "SR" ||
         (line.size() > 3 && line[2] == ',' && (line[0] == 'M' || line[0] == 'J' || line[0] == 'C') &&
          std::isalnum(static_cast<unsigned char>(line[1])) != 0);
}

bool is_plot(std::string_view start) {
  return start.substr(0, 3) == "IN;" || start.substr(0, 3) == "PA;" || start.substr(0, 3) == "PU;";
}

/// APT and what CAM systems write before their posts.
bool is_cutter_location(std::string_view start) {
  const std::string_view head = start.substr(0, 4096);
  return start.substr(0, 10) == "TOOL PATH/" || start.substr(0, 7) == "PARTNO/" ||
         start.substr(0, 7) == "PARTNO " ||
         (start.substr(0, 2) == "$$" && head.find("GOTO/") != std::string_view::npos);
}

/// A language that machines or posts understand and this reader does not.
struct OtherLanguage {
  bool (*is)(std::string_view start);  ///< the text without blanks in front; not empty
  const char* what;
  const char* instead;
};
constexpr OtherLanguage kOtherLanguages[] = {
    {is_iso_of_heidenhain, "a program in Heidenhain's ISO language", "post it as Klartext (BEGIN PGM)"},
    {is_shopbot, "a program of ShopBot commands", "post it for a control that --dialect names"},
    {is_plot, "a plot file (HPGL)", "give the drawing to `clearcut plan` as SVG or DXF"},
    {is_cutter_location, "cutter location data (APT)", kGive}};

/// A first line with nothing but the number of a group: no block of a program begins with a digit.
bool is_dxf(std::string_view start) {
  const std::string_view line = first_line(start);
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
  for (const OtherLanguage& language : kOtherLanguages) {
    if (language.is(start))
      throw InputError(file_name,
                       "this is " + std::string(language.what) + ", which is not read; " + language.instead);
  }
  if (text.substr(0, 4096).find('\0') != std::string_view::npos)
    throw InputError(file_name, std::string("this is a binary file or UTF-16 text, no program; ") + kGive);
  if (!is_klartext(text) && !has_blocks(text))
    throw InputError(file_name,
                     std::string("no line of it is a block of a program, such as G1 X10 F300; ") + kGive);
}

}  // namespace clearcut::read::gcode
