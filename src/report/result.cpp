#include "report/result.h"

#include <fmt/format.h>

#include "report/text.h"

namespace clearcut {

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

}  // namespace

std::string result_file(const Toolpath& toolpath, const ResultInfo& info) {
  std::string text = "# " + ascii(info.name) + "\n# x_i y_i x_f y_f [x_c y_c G02|G03], mm\n";
  if (info.offset_step) text += "# offset step " + fixed(*info.offset_step, kDecimals) + "\n";
  double total = 0;
  for (const Section& section : toolpath.sections) total += append_section(section, text);
  return text + "# total length " + fixed(total, kDecimals) + "\n";
}

}  // namespace clearcut
