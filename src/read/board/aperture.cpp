#include "read/board/aperture.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/rectangle.h"
#include "read/board/coordinates.h"
#include "read/board/macro_shapes.h"
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

}  // namespace clearcut::read
