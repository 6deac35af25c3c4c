#include "report/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/text.h"
#include "base/units.h"
#include "report/words/text_table.h"

namespace clearcut::report {

namespace {

constexpr int kDecimals = 4;

std::string numbers(Vec2 p) {
  return fixed(p.x, kDecimals) + " " + fixed(p.y, kDecimals);
}

std::string segment(const Edge& edge) {
  std::string line = numbers(edge.from) + " " + numbers(edge.to);
  if (edge.is_arc()) line += " " + numbers(edge.center) + (edge.turn == Turn::kClockwise ? " G02" : " G03");
  return line + "\n";
}

bool has_segment(const Move& move) {
  return !is_rapid(move.kind) && !move.is_vertical();
}

std::string layer_heading(const Section& section, double z) {
  return fmt::format("# {} tool {} z {}\n", ascii(section.label), section.tool_number, fixed(z, kDecimals));
}

/// Appends the segments of one section and returns their length.
double append_section(const Section& section, std::string& text) {
  double total = 0;
  std::optional<double> z;
  for (const Move& move : section.moves) {
    if (!has_segment(move)) continue;
    if (z != move.z_to) {
      z = move.z_to;
      text += layer_heading(section, *z);
    }
    text += segment(move.path);
    total += move.path.length();
  }
  return total;
}

/// "7.2000", or all steps if they differ.
std::string steps_of(const std::vector<double>& from_wall) {
  std::vector<std::string> steps;
  for (std::size_t i = 1; i < from_wall.size(); ++i) {
    steps.push_back(fixed(from_wall[i] - from_wall[i - 1], kDecimals));
  }
  const bool one = std::adjacent_find(steps.begin(), steps.end(), std::not_equal_to<>()) == steps.end();
  return fmt::format("{}", fmt::join(steps.begin(), one ? steps.begin() + 1 : steps.end(), " "));
}

std::string contour_lines(const ContourLevels& contours) {
  std::vector<std::string> levels;
  for (const double level : contours.from_wall) levels.push_back(fixed(level, kDecimals));
  const std::string name = ascii(contours.feature);
  std::string text = fmt::format("# {} contours at {}\n", name, fmt::join(levels, " "));
  if (levels.size() > 1) text += fmt::format("# {} offset step {}\n", name, steps_of(contours.from_wall));
  for (const ContourCoefficient& one : contours.coefficients) {
    text += fmt::format("# {} contour at {} smallest angle {} coefficient {} residual F {}\n", name,
                        fixed(one.from_wall, kDecimals), fixed(one.smallest_angle * 180 / kPi, kDecimals),
                        fixed(one.share, kDecimals), fixed(one.residual, kDecimals));
  }
  return text;
}

/// "# time by CPO-rho eq. 9 26.30 s: sum L 373.4802 mm, V_f 1000 mm/min, nd 10, tau 0.177 s".
std::string published_line(const PublishedTime& time) {
  std::string feed = trimmed(time.slowest.mm_per_min(), 3);
  if (time.fastest.mm_per_min() > time.slowest.mm_per_min())
    feed += " to " + trimmed(time.fastest.mm_per_min(), 3);
  return fmt::format("# time by CPO-rho eq. 9 {} s: sum L {} mm, V_f {} mm/min, nd {}, tau {} s\n",
                     fixed(time.seconds(), 2), fixed(time.length_mm, kDecimals), feed, time.discontinuities,
                     trimmed(kPublishedStop, 3));
}

}  // namespace

std::string result_file(const Toolpath& toolpath, const ResultInfo& info) {
  std::string text = "# " + ascii(info.name) + "\n# x_i y_i x_f y_f [x_c y_c G02|G03], mm\n";
  for (const ContourLevels& contours : info.contours) text += contour_lines(contours);
  if (info.published) text += published_line(*info.published);
  double total = 0;
  for (const Section& section : toolpath.sections) total += append_section(section, text);
  return text + "# total length " + fixed(total, kDecimals) + "\n";
}

namespace {

std::string without_comments(std::string_view line) {
  std::string text;
  bool inside = false;
  for (const char c : line) {
    if (!inside && c == ';') break;
    inside = inside || c == '(';
    if (!inside) text += c;
    if (c == ')') inside = false;
  }
  return text;
}

std::string_view without_number(std::string_view line) {
  const std::size_t digits = line.find_first_not_of("0123456789");
  return digits == 0 ? line : line.substr(std::min(digits, line.size()));
}

}  // namespace

std::string motion_text(std::string_view program) {
  std::string text;
  while (!program.empty()) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    const std::string line = without_comments(program.substr(0, end));
    const std::string_view words = stripped(without_number(stripped(line)));
    if (!words.empty()) text.append(words).append("\n");
    program.remove_prefix(std::min(end + 1, program.size()));
  }
  return text;
}

}  // namespace clearcut::report
