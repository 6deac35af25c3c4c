#include "base/debug_sink.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/file.h"
#include "base/text.h"

namespace clearcut::inline base {

namespace {

constexpr int kDecimals = 6;
constexpr double kPageSize = 1000;  // pixels along the longer side

std::string pair_of(double x, double y) {
  return trimmed(x, kDecimals) + " " + trimmed(y, kDecimals);
}

/// Letters, digits and dashes only: safe as part of a file's name.
std::string file_part(std::string_view title) {
  std::string name;
  for (const char c : title.substr(0, 40)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain) name += c;
    if (!plain && !name.empty() && name.back() != '-') name += '-';
  }
  return name;
}

}  // namespace

SvgFrames::SvgFrames(std::filesystem::path folder, std::string prefix)
    : folder_(std::move(folder)), prefix_(std::move(prefix)) {}

SvgFrames::~SvgFrames() {
  try {
    finish();
  } catch (const std::exception&) {
    // A missing debug picture must not end the run.
  }
}

void SvgFrames::frame(std::string_view title) {
  finish();
  title_ = title;
}

void SvgFrames::line(double x0, double y0, double x1, double y1, std::string_view color) {
  polyline({{x0, y0}, {x1, y1}}, false, color);
}

void SvgFrames::arc(double x0, double y0, double x1, double y1, double cx, double cy, bool counter_clockwise,
                    std::string_view color) {
  const double radius = base::hypot(x0 - cx, y0 - cy);
  if ((x0 == x1 && y0 == y1) || !take(x0, y0) || !take(x1, y1)) return;
  if (!std::isfinite(cx) || !std::isfinite(cy)) {
    ++skipped_;
    return;
  }
  // The picture must contain the arc's outermost points, but not its centre: the centre may be far away.
  for (const auto& [ux, uy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
    const double x = cx + radius * ux, y = cy + radius * uy;
    const double side = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0);
    if (counter_clockwise ? side < 0 : side > 0) take(x, y);
  }
  const double cross = (x0 - cx) * (y1 - cy) - (y0 - cy) * (x1 - cx);
  const bool large = counter_clockwise ? cross < 0 : cross > 0;
  add_path(fmt::format("M{}A{} {} 0 {} {} {}", pair_of(x0, y0), trimmed(radius, kDecimals),
                       trimmed(radius, kDecimals), large ? 1 : 0, counter_clockwise ? 1 : 0, pair_of(x1, y1)),
           color);
}

void SvgFrames::polyline(const std::vector<std::pair<double, double>>& points, bool closed,
                         std::string_view color) {
  std::string data;
  for (const auto& [x, y] : points) {
    if (take(x, y)) data += (data.empty() ? "M" : "L") + pair_of(x, y);
  }
  if (!data.empty()) add_path(data + (closed ? "Z" : ""), color);
}

void SvgFrames::dot(double x, double y, std::string_view label, std::string_view color) {
  if (take(x, y)) dots_.push_back({x, y, std::string(label), std::string(color)});
}

void SvgFrames::finish() {
  if (!empty_ || skipped_ > 0) {
    const std::string title = file_part(title_);
    const auto file = folder_ / fmt::format("{}-{:03}{}{}.svg", prefix_, written_.size() + 1,
                                            title.empty() ? "" : "-", title);
    const std::string text = picture();
    paths_.clear();
    dots_.clear();
    empty_ = true;
    skipped_ = 0;
    min_x_ = max_x_ = min_y_ = max_y_ = 0;
    std::filesystem::create_directories(folder_);
    write_files({{file.string(), text}});
    written_.push_back(file);
  }
  title_.clear();
}

bool SvgFrames::take(double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) {
    ++skipped_;
    return false;
  }
  min_x_ = empty_ ? x : std::min(min_x_, x);
  max_x_ = empty_ ? x : std::max(max_x_, x);
  min_y_ = empty_ ? y : std::min(min_y_, y);
  max_y_ = empty_ ? y : std::max(max_y_, y);
  empty_ = false;
  return true;
}

void SvgFrames::add_path(const std::string& data, std::string_view color) {
  paths_ += fmt::format("<path d=\"{}\" stroke=\"{}\"/>\n", data, xml_escaped(color));
}

std::string SvgFrames::picture() const {
  const double extent = std::max({max_x_ - min_x_, max_y_ - min_y_, 1e-6});
  const double scale = kPageSize / extent, margin = 30;
  const double width = (max_x_ - min_x_) * scale + 2 * margin;
  const double height = (max_y_ - min_y_) * scale + 2 * margin + 20;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "font-family=\"sans-serif\" "
      "font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"10\" "
      "y=\"20\">{}{}</text>\n",
      width, height, xml_escaped(title_),
      skipped_ > 0 ? fmt::format(" ({} points that are not finite left out)", skipped_) : "");
  text += fmt::format(
      "<g transform=\"translate({:.6f} {:.6f}) scale({:.9g} {:.9g})\" fill=\"none\" "
      "stroke-width=\"{:.9g}\">\n",
      margin - min_x_ * scale, margin + 20 + max_y_ * scale, scale, -scale, 1 / scale);
  text += paths_ + "</g>\n";
  for (const Dot& dot : dots_) {
    const double x = margin + (dot.x - min_x_) * scale, y = margin + 20 + (max_y_ - dot.y) * scale;
    text += fmt::format(
        "<circle cx=\"{0:.3f}\" cy=\"{1:.3f}\" r=\"3\" fill=\"{2}\"/><text x=\"{3:.3f}\" y=\"{1:.3f}\" "
        "fill=\"{2}\">{4}</text>\n",
        x, y, xml_escaped(dot.color), x + 5, xml_escaped(dot.label));
  }
  return text + "</svg>\n";
}

}  // namespace clearcut::inline base
