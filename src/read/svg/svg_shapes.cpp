#include "read/svg/svg_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <vector>

#include "base/elementary.h"
#include "base/units.h"
#include "read/common/curve_fit.h"
#include "read/svg/svg_numbers.h"

namespace clearcut::read {
namespace {

constexpr std::array<std::string_view, 7> kShapes{"rect",     "circle",  "ellipse", "line",
                                                  "polyline", "polygon", "path"};

SvgPathData single(Path path, bool closed) {
  SvgPathData out;
  if (!path.empty()) out.subpaths.push_back({std::move(path), closed});
  return out;
}

SvgPathData ellipse(Vec2 center, double rx, double ry, const Affine& map) {
  Path path;
  if (rx > 0 && ry > 0) {
    append_elliptical({map(center), map.linear({rx, 0}), map.linear({0, ry}), 0, 2 * kPi}, kCurveTolerance,
                      path);
  }
  return single(std::move(path), true);
}

SvgPathData polygon(const std::vector<Vec2>& points, bool closed, const Affine& map) {
  Path path;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    path.push_back(Edge::line(map(points[i]), map(points[i + 1])));
  if (closed && points.size() > 2) path.push_back(Edge::line(map(points.back()), map(points.front())));
  return single(std::move(path), closed);
}

SvgPathData points_of(const pugi::xml_node& node, bool closed, const Affine& map) {
  SvgScanner scanner(node.attribute("points").value());
  std::vector<Vec2> points;
  bool half_point = false;
  while (const auto x = scanner.number()) {
    const auto y = scanner.number();
    half_point = !y;
    if (!y) break;
    points.push_back({*x, *y});
  }
  SvgPathData out = polygon(points, closed, map);
  out.half_point = half_point;
  if (!scanner.at_end())
    out.error =
        "a number was expected at character " + std::to_string(scanner.position() + 1) + " of the points";
  return out;
}

SvgPathData line(const pugi::xml_node& node, const SvgViewSize& view, const Affine& map) {
  const Vec2 from{svg_attribute(node, "x1", view.width, 0), svg_attribute(node, "y1", view.height, 0)};
  const Vec2 to{svg_attribute(node, "x2", view.width, 0), svg_attribute(node, "y2", view.height, 0)};
  return polygon({from, to}, false, map);
}

SvgPathData rectangle(const pugi::xml_node& node, const SvgViewSize& view, const Affine& map) {
  const double x = svg_attribute(node, "x", view.width, 0), y = svg_attribute(node, "y", view.height, 0);
  const double w = svg_attribute(node, "width", view.width, 0),
               h = svg_attribute(node, "height", view.height, 0);
  if (!(w > 0) || !(h > 0)) return {};
  double rx = svg_attribute(node, "rx", view.width, -1), ry = svg_attribute(node, "ry", view.height, -1);
  if (rx < 0) rx = std::max(ry, 0.0);
  if (ry < 0) ry = rx;
  rx = std::min(rx, w / 2);
  ry = std::min(ry, h / 2);
  if (!(rx > 0) || !(ry > 0)) return polygon({{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true, map);
  Path path;
  const auto side = [&](Vec2 from, Vec2 to) {
    if (from != to) path.push_back(Edge::line(map(from), map(to)));
  };
  const auto corner = [&](Vec2 center, double start) {
    append_elliptical({map(center), map.linear({rx, 0}), map.linear({0, ry}), start, kPi / 2},
                      kCurveTolerance, path);
  };
  side({x + rx, y}, {x + w - rx, y});
  corner({x + w - rx, y + ry}, -kPi / 2);
  side({x + w, y + ry}, {x + w, y + h - ry});
  corner({x + w - rx, y + h - ry}, 0);
  side({x + w - rx, y + h}, {x + rx, y + h});
  corner({x + rx, y + h - ry}, kPi / 2);
  side({x, y + h - ry}, {x, y + ry});
  corner({x + rx, y + ry}, kPi);
  return single(std::move(path), true);
}

}  // namespace

double SvgViewSize::diagonal() const {
  return base::hypot(width, height) / std::sqrt(2.0);
}

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool is_svg_shape(std::string_view name) {
  return std::find(kShapes.begin(), kShapes.end(), name) != kShapes.end();
}

double svg_attribute(const pugi::xml_node& node, const char* name, double whole, double otherwise) {
  return svg_length(node.attribute(name).value(), whole).value_or(otherwise);
}

SvgPathData svg_shape(const pugi::xml_node& node, const SvgViewSize& view, const Affine& map) {
  const std::string_view name = local_name(node);
  if (name == "path") return read_svg_path(node.attribute("d").value(), map);
  if (name == "rect") return rectangle(node, view, map);
  if (name == "line") return line(node, view, map);
  if (name == "polygon") return points_of(node, true, map);
  if (name == "polyline") return points_of(node, false, map);
  const double diagonal = view.diagonal();
  const Vec2 center{svg_attribute(node, "cx", view.width, 0), svg_attribute(node, "cy", view.height, 0)};
  if (name == "circle") {
    const double r = svg_attribute(node, "r", diagonal, 0);
    return ellipse(center, r, r, map);
  }
  // An unstated radius equals the other.
  const double rx = svg_attribute(node, "rx", view.width, -1),
               ry = svg_attribute(node, "ry", view.height, -1);
  return ellipse(center, rx < 0 ? ry : rx, ry < 0 ? rx : ry, map);
}

}  // namespace clearcut::read
