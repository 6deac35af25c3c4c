#include "read/board/aperture.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "read/board/drawn.h"
#include "read/common/text.h"
#include "read/drawing/stroke.h"
#include "read/repair/clean.h"

namespace clearcut::read {
namespace {

/// Sides of a regular polygon; Gerber allows 3 to 12.
constexpr double kFewestSides = 3, kMostSides = 12;

[[noreturn]] void fail(const std::string& definition, const ApertureContext& context) {
  throw InputError(context.repair.where,
                   "aperture '" + printable(definition) + "' is not understood; export the layer again");
}

std::vector<double> parameters_of(const std::string& definition, const ApertureContext& context) {
  std::vector<double> numbers;
  for (std::size_t at = definition.find(','); at != std::string::npos;) {
    const std::size_t end = definition.find_first_of("xX", at + 1);
    const std::size_t length = (end == std::string::npos ? definition.size() : end) - at - 1;
    const auto number = plain_number(std::string_view(definition).substr(at + 1, length));
    if (!number) fail(definition, context);
    numbers.push_back(*number);
    at = end;
  }
  return numbers;
}

Aperture circle(double diameter) {
  Aperture aperture;
  aperture.diameter = diameter;
  if (diameter > 0) aperture.shape = {{true, {full_circle({}, diameter / 2)}, {}}};
  return aperture;
}

Aperture rectangle(double width, double height) {
  Aperture aperture;
  aperture.size = Vec2{width, height};
  Box box;
  box.add(Vec2{-width / 2, -height / 2});
  box.add(Vec2{width / 2, height / 2});
  if (width > 0 && height > 0) aperture.shape = {{true, {rectangular_region(box).outer()}, {}}};
  return aperture;
}

/// A rectangle whose shorter sides are half circles.
Aperture obround(double width, double height) {
  const double pen = std::min(width, height);
  const Vec2 end = width > height ? Vec2{(width - pen) / 2, 0} : Vec2{0, (height - pen) / 2};
  if (norm(end) == 0) return circle(pen);
  Aperture aperture;
  const Subpath line{{Edge::line(-end, end)}, false};
  if (pen > 0)
    aperture.shape = {{true, stroke_pieces({line}, {pen, StrokeCap::kRound, StrokeJoin::kRound}), {}}};
  return aperture;
}

/// A hole removes its area; the aperture can then not draw lines.
void cut_hole(Aperture& aperture, double diameter) {
  if (!(diameter > 0) || aperture.shape.empty()) return;
  aperture.shape.front().pieces.push_back(reversed(full_circle({}, diameter / 2)));
  aperture.diameter.reset();
  aperture.size.reset();
}

Aperture standard(char kind, const std::string& definition, std::vector<double> numbers,
                  const ApertureContext& context) {
  const std::size_t sizes = kind == 'C' ? 1 : 2, most = kind == 'P' ? 4 : sizes + 1;
  if (numbers.size() < sizes || numbers.size() > most + 1) fail(definition, context);
  for (const double number : numbers)
    if (!(number >= 0) && kind != 'P') fail(definition, context);
  const double a = numbers[0] * context.mm;
  if (kind == 'P') {
    numbers.resize(4, 0);
    if (!(a > 0) || !(numbers[1] >= kFewestSides && numbers[1] <= kMostSides)) fail(definition, context);
    Aperture aperture;
    aperture.shape = {
        {true, {regular_polygon({}, a / 2, static_cast<int>(numbers[1]), numbers[2] * kPi / 180)}, {}}};
    cut_hole(aperture, numbers[3] * context.mm);
    return aperture;
  }
  const double b = sizes == 2 ? numbers[1] * context.mm : a;
  Aperture aperture = kind == 'C' ? circle(a) : kind == 'R' ? rectangle(a, b) : obround(a, b);
  if (numbers.size() > sizes) cut_hole(aperture, numbers[sizes] * context.mm);
  return aperture;
}

}  // namespace

Aperture aperture_of(const std::string& definition, const ApertureContext& context) {
  const std::string name = definition.substr(0, definition.find(','));
  std::vector<double> numbers = parameters_of(definition, context);
  if (name.size() == 1 && std::string_view("CROP").find(name[0]) != std::string_view::npos)
    return standard(name[0], definition, std::move(numbers), context);
  const auto macro = context.macros.find(name);
  if (macro == context.macros.end()) fail(definition, context);
  Aperture aperture;
  aperture.shape = macro_shape(macro->second, numbers, context);
  return aperture;
}

namespace {

constexpr int kDeepest = 100;  // parentheses within parentheses

class Parser {
 public:
  Parser(std::string_view text, const MacroVariables& variables) : text_(text), variables_(variables) {}

  std::optional<double> whole() {
    const double value = sum();
    return is_good_ && at_ == text_.size() && std::isfinite(value) ? std::optional(value) : std::nullopt;
  }

 private:
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  double fail() {
    is_good_ = false;
    at_ = text_.size();
    return 0;
  }

  double sum() {
    double value = product();
    while (true) {
      if (take('+')) {
        value += product();
      } else if (take('-')) {
        value -= product();
      } else {
        return value;
      }
    }
  }

  double product() {
    double value = factor();
    while (true) {
      if (take('x') || take('X')) {
        value *= factor();
      } else if (take('/')) {
        value /= factor();
      } else {
        return value;
      }
    }
  }

  double factor() {
    double sign = 1;
    while (next() == '-' || next() == '+') sign = text_[at_++] == '-' ? -sign : sign;
    if (take('(')) {
      if (++depth_ > kDeepest) return fail();
      const double value = sum();
      --depth_;
      return take(')') ? sign * value : fail();
    }
    if (take('$')) return sign * variable();
    double value = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value, std::chars_format::fixed);
    if (error != std::errc{}) return fail();
    at_ = static_cast<std::size_t>(end - text_.data());
    return sign * value;
  }

  double variable() {
    int number = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
    if (error != std::errc{}) return fail();
    at_ = static_cast<std::size_t>(end - text_.data());
    const auto found = variables_.find(number);
    return found == variables_.end() ? 0 : found->second;
  }

  std::string_view text_;
  const MacroVariables& variables_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool is_good_ = true;
};

std::string without_blanks(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\t') out += c;
  return out;
}

}  // namespace

std::optional<double> macro_value(std::string_view text, const MacroVariables& variables) {
  return Parser(without_blanks(text), variables).whole();
}

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
