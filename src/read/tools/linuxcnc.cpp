// LinuxCNC's tool table: one tool a line, words like T1 P1 Z0.5 D6.0, a comment after a semicolon.
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "read/common/text.h"
#include "read/tools/formats.h"

namespace clearcut::read {
namespace {

/// The kind of tool named in the comment; an end mill otherwise.
ToolKind kind_in(const std::string& comment) {
  const std::string text = capitals(comment);
  const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
  if (has("DRILL")) return ToolKind::kDrill;
  if (has("REAMER")) return ToolKind::kReamer;
  if (has("BALL")) return ToolKind::kBallEndMill;
  if (has("FACE")) return ToolKind::kFaceMill;
  return ToolKind::kEndMill;
}

/// Taps and probes have a diameter too.
bool is_no_cutter(const std::string& comment) {
  const std::string text = capitals(comment);
  for (const char* word : {"TAP", "PROBE", "V-BIT", "VBIT", "CHAMFER", "ENGRAV", "THREAD"}) {
    if (text.find(word) != std::string::npos) return true;
  }
  return false;
}

struct Row {
  Tool tool;
  bool has_number = false;
};

Row row_of(std::string_view words, const std::string& place, double unit) {
  Row row;
  row.tool.number = 0;
  while (!(words = stripped(words)).empty()) {
    const char letter = capitals(words.substr(0, 1))[0];
    double value = 0;
    const auto [end, error] = std::from_chars(words.data() + 1 + (words.substr(1, 1) == "+" ? 1 : 0),
                                              words.data() + words.size(), value);
    if (letter < 'A' || letter > 'Z' || error != std::errc{} || !std::isfinite(value)) {
      throw InputError(
          place, "'" + printable(words) + "' is no word like T1 or D6.0; this is not a LinuxCNC tool table");
    }
    words.remove_prefix(static_cast<std::size_t>(end - words.data()));
    if (letter == 'T' && value >= 0 && value < 1e6) {
      row.tool.number = static_cast<int>(value);
      row.has_number = true;
    }
    if (letter == 'D') row.tool.diameter = std::abs(value) * unit;
  }
  return row;
}

}  // namespace

ToolLibrary read_linuxcnc_table(std::string_view text, const std::string& file_name,
                                const ToolOptions& options) {
  ToolLibrary library;
  const double unit = options.unit ? require_unit(*options.unit, "unit") : 1;
  if (!options.unit)
    library.diagnostics.warn(file_name, "a LinuxCNC tool table names no unit: millimetres assumed");
  const char line_end = line_end_of(text);
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find(line_end);
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const std::string place = file_name + ":" + std::to_string(++number);
    const std::size_t semicolon = line.find(';');
    const std::string_view words = stripped(line.substr(0, semicolon));
    const std::string comment(semicolon == std::string_view::npos ? ""
                                                                  : stripped(line.substr(semicolon + 1)));
    if (words.empty()) continue;
    Row row = row_of(words, place, unit);
    row.tool.name = comment;
    row.tool.kind = kind_in(comment);
    if (row.tool.kind == ToolKind::kBallEndMill) row.tool.corner_radius = row.tool.diameter / 2;
    if (!row.has_number || is_no_cutter(comment)) {
      library.diagnostics.skip(place,
                               "'" + printable(comment) + "' was dropped: it is no cutter for pockets");
      continue;
    }
    library.tools.push_back({std::move(row.tool), {}});
  }
  return library;
}

}  // namespace clearcut::read
