#include "report/picture/svg_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/units.h"

namespace clearcut::report::palette {

namespace {

using Rgb = std::array<double, 3>;
constexpr std::array<Rgb, 5> kDepths{
    {{234, 240, 244}, {189, 214, 231}, {122, 170, 207}, {61, 117, 168}, {27, 69, 116}}};

/// How a material looks where light falls on it.
struct Look {
  const char* material;
  Rgb color;
};
constexpr std::array<Look, 12> kLooks{{{"aluminium", {214, 218, 222}},
                                       {"brass", {224, 190, 98}},
                                       {"steel", {178, 186, 194}},
                                       {"alloy-steel", {164, 172, 182}},
                                       {"stainless", {196, 202, 206}},
                                       {"cast-iron", {138, 142, 146}},
                                       {"titanium", {182, 178, 172}},
                                       {"plastic", {232, 236, 240}},
                                       {"softwood", {232, 202, 156}},
                                       {"hardwood", {190, 140, 92}},
                                       {"mdf", {198, 166, 128}},
                                       {"plywood", {224, 190, 140}}}};
/// Share of the light that the deepest floor has lost.
constexpr double kShadow = 0.5;

std::string hex_of(const Rgb& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", std::lround(color[0]), std::lround(color[1]),
                     std::lround(color[2]));
}

}  // namespace

std::string material_color(const std::string& material, double fraction) {
  for (const Look& look : kLooks) {
    if (material != look.material) continue;
    const double light = 1 - kShadow * std::clamp(fraction, 0.0, 1.0);
    return hex_of({look.color[0] * light, look.color[1] * light, look.color[2] * light});
  }
  return depth_color(fraction);
}

std::string depth_color(double fraction) {
  const double position = std::clamp(fraction, 0.0, 1.0) * (kDepths.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(position), kDepths.size() - 2);
  const double t = position - static_cast<double>(low);
  std::array<long, 3> mixed{};
  for (std::size_t i = 0; i < 3; ++i)
    mixed[i] = std::lround(kDepths[low][i] * (1 - t) + kDepths[low + 1][i] * t);
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

std::string line_color_on_depth(double fraction) {
  return fraction > 0.5 ? "#ffffff" : "#14406e";
}

std::string tool_color(int i) {
  static const std::array<const char*, 5> kColors{kCut, "#6b2fa0", "#00818a", "#8a4b08", "#3d4650"};
  return kColors[static_cast<std::size_t>(std::max(i, 0)) % kColors.size()];
}

}  // namespace clearcut::report::palette

namespace clearcut::report {

namespace {

constexpr double kFarthest = 1e7;          // mm
constexpr double kSmallestSagitta = 5e-4;  // mm: flatter arcs are drawn as lines, half of the last digit
constexpr double kLongestArc =
    0.75 * kPi;  // SVG finds the centre from the printed ends: near half a turn, badly

std::string pair_of(Vec2 p) {
  return svg_number(p.x) + " " + svg_number(p.y);
}

/// The point rounded as in print.
Vec2 printed(Vec2 p) {
  return {std::round(p.x * 1000) / 1000, std::round(p.y * 1000) / 1000};
}

}  // namespace

std::string svg_number(double value) {
  return std::isfinite(value) ? trimmed(value, 3) : "0";
}

bool drawable(Vec2 p) {
  return std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest;
}

bool drawable(const Edge& edge) {
  return drawable(edge.from) && drawable(edge.to) && (!edge.is_arc() || drawable(edge.center));
}

void PathData::line_to(Vec2 p) {
  if (printed(p) != printed(pen_)) text_ += "L" + pair_of(p);
}

void PathData::arc_to(const Edge& arc) {
  const double sweep = std::abs(arc.sweep()), radius = arc.radius();
  if (radius * (1 - base::cos(sweep / 2)) < kSmallestSagitta) return line_to(arc.to);
  if (sweep > kLongestArc) {
    arc_to(arc.part(0, 0.5));
    return arc_to(arc.part(0.5, 1));
  }
  text_ += "A" + svg_number(radius) + " " + svg_number(radius) + " 0 0 " +
           (arc.turn == Turn::kCounterClockwise ? "1 " : "0 ") + pair_of(arc.to);
}

void PathData::add(const Edge& edge) {
  if (!drawable(edge)) {
    down_ = false;
    return;
  }
  if (!down_ || printed(pen_) != printed(edge.from)) text_ += "M" + pair_of(edge.from);
  pen_ = edge.from;
  if (edge.is_arc()) {
    arc_to(edge);
  } else {
    line_to(edge.to);
  }
  pen_ = edge.to;
  down_ = true;
}

void PathData::add(const Loop& closed) {
  down_ = false;
  for (const Edge& edge : closed) add(edge);
  if (down_) text_ += "Z";
  down_ = false;
}

void PathData::add(const Region& region) {
  add(region.outer());
  for (const Loop& island : region.islands()) add(island);
}

void PathData::add(const Regions& regions) {
  for (const Region& region : regions) add(region);
}

void PathData::add(Vec2 point) {
  if (drawable(point)) text_ += "M" + pair_of(point) + "h0";
  down_ = false;
}

void SvgWriter::begin(std::string_view element, const Attributes& attributes) {
  text_.append(open_.size(), ' ');
  text_ += "<";
  text_ += element;
  for (const auto& [name, value] : attributes) {
    text_ += " ";
    text_ += name;
    text_ += "=\"" + xml_escaped(value) + "\"";
  }
}

void SvgWriter::open(std::string_view element, const Attributes& attributes) {
  begin(element, attributes);
  text_ += ">\n";
  open_.emplace_back(element);
}

void SvgWriter::close() {
  CLEARCUT_ASSERT(!open_.empty());
  const std::string element = open_.back();
  open_.pop_back();
  text_.append(open_.size(), ' ');
  text_ += "</" + element + ">\n";
}

void SvgWriter::leaf(std::string_view element, const Attributes& attributes) {
  begin(element, attributes);
  text_ += "/>\n";
}

void SvgWriter::words(std::string_view element, std::string_view content, const Attributes& attributes) {
  begin(element, attributes);
  text_ += ">" + xml_escaped(content) + "</";
  text_ += element;
  text_ += ">\n";
}

void SvgWriter::text(Vec2 at, std::string_view content, const Attributes& attributes) {
  Attributes all{{"x", svg_number(at.x)}, {"y", svg_number(at.y)}};
  all.insert(all.end(), attributes.begin(), attributes.end());
  words("text", content, all);
}

std::string SvgWriter::new_id(std::string_view stem) {
  return std::string(stem) + std::to_string(++ids_);
}

std::string hatch(SvgWriter& svg, const std::string& color, double step, double width) {
  const std::string id = svg.new_id("hatch");
  svg.open("pattern", {{"id", id},
                       {"width", svg_number(step)},
                       {"height", svg_number(step)},
                       {"patternUnits", "userSpaceOnUse"},
                       {"patternTransform", "rotate(45)"}});
  svg.leaf("path",
           {{"d", "M0 0V" + svg_number(step)}, {"stroke", color}, {"stroke-width", svg_number(width)}});
  svg.close();
  return "url(#" + id + ")";
}

std::string svg_path(const Loop& loop) {
  PathData data;
  data.add(loop);
  return data.text();
}

}  // namespace clearcut::report
