#include "read/svg/svg_page.h"

#include <algorithm>
#include <array>

#include "read/svg/svg_numbers.h"

namespace clearcut::read {
namespace {

constexpr double kPxPerInch = 96;
constexpr double kMmPerPx = 25.4 / kPxPerInch;

struct ViewBox {
  double x = 0, y = 0, width = 0, height = 0;
};

std::optional<ViewBox> view_box_of(const std::string& text) {
  SvgScanner scanner(text);
  std::array<double, 4> n{};
  for (double& value : n) {
    const auto number = scanner.number();
    if (!number) return std::nullopt;
    value = *number;
  }
  if (!(n[2] > 0) || !(n[3] > 0)) return std::nullopt;
  return ViewBox{n[0], n[1], n[2], n[3]};
}

/// Whether a length has a unit of its own other than the screen's.
bool is_physical(const std::string& length) {
  SvgScanner scanner(length);
  if (!scanner.number()) return false;
  const std::string_view unit = scanner.word();
  return !unit.empty() && unit != "px" && px_per_unit(unit);
}

/// Nothing for lengths in percent.
std::optional<double> stated(const std::string& text) {
  const auto length = text.find('%') == std::string::npos ? svg_length(text, 0) : std::nullopt;
  return length && *length > 0 ? length : std::nullopt;
}

}  // namespace

Affine view_box_map(const std::string& text, const std::string& aspect, double width, double height) {
  const auto box = view_box_of(text);
  if (!box) return {};
  double sx = width / box->width, sy = height / box->height;
  double shift_x = 0, shift_y = 0;
  if (aspect.find("none") == std::string::npos) {
    const double scale = aspect.find("slice") != std::string::npos ? std::max(sx, sy) : std::min(sx, sy);
    const auto share = [&](const char* low, const char* high) {
      return aspect.find(low) != std::string::npos ? 0.0 : aspect.find(high) != std::string::npos ? 1.0 : 0.5;
    };
    shift_x = (width - scale * box->width) * share("xMin", "xMax");
    shift_y = (height - scale * box->height) * share("YMin", "YMax");
    sx = sy = scale;
  }
  return Affine::translation({shift_x, shift_y}) * Affine::scaling(sx, sy) *
         Affine::translation({-box->x, -box->y});
}

SvgViewSize view_size(const std::string& view_box, const SvgViewSize& own) {
  const auto box = view_box_of(view_box);
  return box ? SvgViewSize{box->width, box->height} : own;
}

PixelSize pixel_size_of(std::string_view text, std::string_view inkscape_version) {
  // The comment naming the generator is before the root.
  const std::string_view prolog = text.substr(0, text.find("<svg"));
  if (prolog.find("Generator: Adobe Illustrator") != std::string_view::npos)
    return {72, "as Adobe Illustrator writes them"};
  SvgScanner scanner(inkscape_version);
  const auto version = scanner.number();
  if (version && *version < 0.92) return {90, "as Inkscape before 0.92 writes them"};
  return {};
}

SvgPage page_of(const SvgViewport& viewport, std::optional<double> user_unit, double px_per_inch) {
  SvgPage page;
  const auto box = view_box_of(viewport.view_box);
  auto width = stated(viewport.width), height = stated(viewport.height);
  if (user_unit && box) {
    width = box->width;
    height = box->height;
  }
  // One of the two gives the other by the viewBox's shape.
  if (box && width && !height) height = *width * box->height / box->width;
  if (box && height && !width) width = *height * box->width / box->height;
  if (!width) width = box ? box->width : 0;
  if (!height) height = box ? box->height : 0;
  page.has_size = is_physical(viewport.width) || is_physical(viewport.height);
  // Without a viewBox a user unit is a px: that of the writing program, if it used its own pixels.
  const bool own_pixels = !box && px_per_inch != kPxPerInch;
  page.physical = user_unit || (page.has_size && !own_pixels);
  const double stretch = !user_unit && page.has_size && own_pixels ? px_per_inch / kPxPerInch : 1;
  width = *width * stretch;
  height = *height * stretch;
  page.view_width = box ? box->width : *width;
  page.view_height = box ? box->height : *height;
  const double unit = user_unit ? *user_unit : page.physical ? kMmPerPx : 25.4 / px_per_inch;
  const Affine up = Affine::translation({0, *height * unit}) * Affine::scaling(unit, -unit);
  page.to_mm = up * view_box_map(viewport.view_box, viewport.aspect, *width, *height);
  return page;
}

}  // namespace clearcut::read
