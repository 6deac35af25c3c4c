#include "read/board/macro_shapes.h"

#include <cctype>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "geometry/contours/loops.h"
#include "read/board/coordinates.h"
#include "read/board/macro_expression.h"
#include "read/common/text.h"
#include "read/repair/clean.h"

namespace clearcut::read {
namespace {

/// Corners of an outline: more are a trap.
constexpr double kMostCorners = 10000;
/// Greatest number of rings of a moiré.
constexpr double kMostRings = 1000;

Path polygon(const std::vector<Vec2>& corners) {
  Path path;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 to = corners[(i + 1) % corners.size()];
    if (corners[i] != to) path.push_back(Edge::line(corners[i], to));
  }
  return signed_area(path) < 0 ? reversed(path) : path;
}

Path box_about(Vec2 center, double width, double height) {
  const Vec2 half{width / 2, height / 2}, across{width / 2, -height / 2};
  return polygon({center - half, center + across, center + half, center - across});
}

/// The fields of one primitive after its code: numbers, lengths in units of the file.
class Primitive {
 public:
  Primitive(const std::string& block, const MacroVariables& variables, const ApertureContext& context)
      : block_(block), context_(context) {
    for (std::size_t at = 0; at <= block.size();) {
      const std::size_t end = std::min(block.find(',', at), block.size());
      const auto value = macro_value(std::string_view(block).substr(at, end - at), variables);
      // A comma at the end is common.
      if (!value && end == block.size() && at == end && !fields_.empty()) break;
      if (!value) fail();
      fields_.push_back(*value);
      at = end + 1;
    }
  }

  std::size_t size() const { return fields_.size(); }
  double number(std::size_t i) const { return i < fields_.size() ? fields_[i] : fail(); }
  double length(std::size_t i) const { return number(i) * context_.mm; }
  Vec2 point(std::size_t i) const { return {length(i), length(i + 1)}; }
  /// Radians about the macro's origin; 0 if the field is left out.
  double turn(std::size_t i) const { return i < fields_.size() ? fields_[i] * kPi / 180 : 0; }
  [[noreturn]] double fail() const {
    throw InputError(context_.repair.where,
                     "macro primitive '" + printable(block_) + "' is not understood; export the layer again");
  }

 private:
  const std::string& block_;
  const ApertureContext& context_;
  std::vector<double> fields_;
};

Drawn circle(const Primitive& p) {
  const double radius = p.length(2) / 2;
  if (!(radius > 0)) return {};
  return mapped(Drawn{true, {full_circle(p.point(3), radius)}, {}}, Affine::rotation(p.turn(5)));
}

/// A line with a width and square ends not extending beyond the line.
Drawn vector_line(const Primitive& p) {
  const Vec2 from = p.point(3), to = p.point(5);
  if (from == to || !(p.length(2) > 0)) return {};
  const Vec2 side = left_of(unit(to - from)) * (p.length(2) / 2);
  return mapped(Drawn{true, {polygon({from - side, to - side, to + side, from + side})}, {}},
                Affine::rotation(p.turn(7)));
}

Drawn box_primitive(const Primitive& p, bool from_corner) {
  const double width = p.length(2), height = p.length(3);
  if (!(width > 0 && height > 0)) return {};
  const Vec2 center = p.point(4) + (from_corner ? Vec2{width / 2, height / 2} : Vec2{});
  return mapped(Drawn{true, {box_about(center, width, height)}, {}}, Affine::rotation(p.turn(6)));
}

Drawn outline(const Primitive& p) {
  const double corners = p.number(2);
  if (!(corners >= 1 && corners <= kMostCorners)) p.fail();
  const auto count = static_cast<std::size_t>(corners);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(p.point(3 + 2 * i));
  return mapped(Drawn{true, {polygon(points)}, {}}, Affine::rotation(p.turn(3 + 2 * (count + 1))));
}

Drawn polygon_primitive(const Primitive& p) {
  const double corners = p.number(2);
  if (!(corners >= 3 && corners <= kMostCorners) || !(p.length(5) > 0)) p.fail();
  return mapped(Drawn{true, {regular_polygon(p.point(3), p.length(5) / 2, static_cast<int>(corners), 0)}, {}},
                Affine::rotation(p.turn(6)));
}

/// A ring parted by a cross.
Drawn thermal(const Primitive& p, const ApertureContext& context) {
  const Vec2 center = p.point(1);
  const double outer = p.length(3), inner = p.length(4), gap = p.length(5);
  if (!(outer > 0)) p.fail();
  std::vector<Drawn> parts{{true, {full_circle(center, outer / 2)}, {}}};
  if (inner > 0) parts.push_back({false, {full_circle(center, inner / 2)}, {}});
  if (gap > 0) {
    parts.push_back({false, {box_about(center, 2 * outer, gap), box_about(center, gap, 2 * outer)}, {}});
  }
  return mapped(Drawn{true, loops_of(dark_area(parts, context.repair)), {}}, Affine::rotation(p.turn(6)));
}

/// Rings about each other and a cross over them.
Drawn moire(const Primitive& p, const ApertureContext& context) {
  const Vec2 center = p.point(1);
  const double thickness = p.length(4), gap = p.length(5), most = p.number(6);
  if (!(thickness >= 0 && gap >= 0 && most >= 0 && most <= kMostRings)) p.fail();
  std::vector<Drawn> parts;
  double diameter = p.length(3);
  for (int i = 0; i < static_cast<int>(most) && diameter > 0; ++i) {
    parts.push_back({true, {full_circle(center, diameter / 2)}, {}});
    diameter -= 2 * thickness;
    if (diameter > 0) parts.push_back({false, {full_circle(center, diameter / 2)}, {}});
    diameter -= 2 * gap;
  }
  const double line = p.length(7), length = p.length(8);
  if (line > 0 && length > 0)
    parts.push_back({true, {box_about(center, length, line), box_about(center, line, length)}, {}});
  return mapped(Drawn{true, loops_of(dark_area(parts, context.repair)), {}}, Affine::rotation(p.turn(9)));
}

Drawn drawn_by(const Primitive& p, const ApertureContext& context) {
  const double code = p.number(0);
  Drawn drawn = code == 1                 ? circle(p)
                : code == 2 || code == 20 ? vector_line(p)
                : code == 21              ? box_primitive(p, false)
                : code == 22              ? box_primitive(p, true)
                : code == 4               ? outline(p)
                : code == 5               ? polygon_primitive(p)
                : code == 6               ? moire(p, context)
                : code == 7               ? thermal(p, context)
                                          : (p.fail(), Drawn{});
  drawn.dark = code == 6 || code == 7 || p.number(1) != 0;
  return drawn;
}

/// "$4=$1x0.75".
void set_variable(const std::string& block, MacroVariables& variables, const ApertureContext& context) {
  const std::size_t equals = block.find('=');
  const auto number = equals == std::string::npos ? std::nullopt : plain_number(block.substr(1, equals - 1));
  const auto value =
      number ? macro_value(std::string_view(block).substr(equals + 1), variables) : std::nullopt;
  if (!value || !(*number >= 1 && *number <= 1000)) {
    throw InputError(context.repair.where,
                     "macro variable '" + printable(block) + "' is not understood; export the layer again");
  }
  variables[static_cast<int>(*number)] = *value;
}

}  // namespace

Path regular_polygon(Vec2 center, double radius, int corners, double turned) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i)
    points.push_back(center + direction_of(turned + 2 * kPi * i / corners) * radius);
  return polygon(points);
}

std::vector<Drawn> macro_shape(const std::vector<std::string>& blocks, const std::vector<double>& parameters,
                               const ApertureContext& context) {
  MacroVariables variables;
  for (std::size_t i = 0; i < parameters.size(); ++i) variables[static_cast<int>(i) + 1] = parameters[i];
  std::vector<Drawn> all;
  bool clears = false;
  for (const std::string& block : blocks) {
    const std::size_t first = block.find_first_not_of(' ');
    if (first == std::string::npos || block[first] == '0') continue;  // a comment
    if (block[first] == '$') {
      set_variable(block.substr(first), variables, context);
      continue;
    }
    all.push_back(drawn_by(Primitive(block, variables, context), context));
    clears = clears || !all.back().dark;
  }
  if (!clears) return all;
  return {{true, loops_of(dark_area(all, context.repair)), {}}};
}

}  // namespace clearcut::read
