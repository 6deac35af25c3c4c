#include "support/drawings.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "base/units.h"
#include "geometry/vec2.h"

namespace clearcut::test_support {
namespace {

struct BulgePoint {
  Vec2 at;
  double bulge = 0;
};

/// A drawing of these entities; `units` as in $INSUNITS, 4 for mm, 0 for none.
std::string dxf(int units, const std::string& entities) {
  std::string header;
  if (units != 0) header = fmt::format("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{}\n0\nENDSEC\n", units);
  return header + "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

std::string line(Vec2 a, Vec2 b) {
  return fmt::format("0\nLINE\n8\n0\n10\n{:.9f}\n20\n{:.9f}\n11\n{:.9f}\n21\n{:.9f}\n", a.x, a.y, b.x, b.y);
}

std::string arc(Vec2 center, double radius, double from_deg, double to_deg) {
  return fmt::format("0\nARC\n8\n0\n10\n{:.9f}\n20\n{:.9f}\n40\n{:.9f}\n50\n{}\n51\n{}\n", center.x, center.y,
                     radius, from_deg, to_deg);
}

std::string circle(Vec2 center, double radius) {
  return fmt::format("0\nCIRCLE\n8\n0\n10\n{}\n20\n{}\n40\n{}\n", center.x, center.y, radius);
}

std::string closed_polyline(const std::vector<BulgePoint>& points) {
  std::string text = fmt::format("0\nLWPOLYLINE\n8\n0\n90\n{}\n70\n1\n", points.size());
  for (const BulgePoint& p : points) text += fmt::format("10\n{}\n20\n{}\n42\n{}\n", p.at.x, p.at.y, p.bulge);
  return text;
}

/// With the first vertex again at the end, and not marked closed.
std::string old_polyline(const std::vector<Vec2>& points) {
  std::string text = "0\nPOLYLINE\n8\n0\n66\n1\n70\n0\n";
  const auto vertex = [](Vec2 p) { return fmt::format("0\nVERTEX\n8\n0\n10\n{}\n20\n{}\n", p.x, p.y); };
  for (const Vec2 p : points) text += vertex(p);
  return text + vertex(points.front()) + "0\nSEQEND\n8\n0\n";
}

std::vector<Vec2> square(Vec2 corner, double edge) {
  return {corner, corner + Vec2{edge, 0}, corner + Vec2{edge, edge}, corner + Vec2{0, edge}};
}

}  // namespace

std::string gear_with_gaps_dxf() {
  std::vector<Vec2> corners;
  for (int tooth = 0; tooth < 12; ++tooth) {
    const double step = 2 * kPi / 12, at = tooth * step;
    corners.push_back(direction_of(at) * 11);
    corners.push_back(direction_of(at + 0.4 * step) * 11);
    corners.push_back(direction_of(at + 0.5 * step) * 14);
    corners.push_back(direction_of(at + 0.9 * step) * 14);
  }
  std::string entities;
  for (std::size_t i = 0; i < corners.size(); ++i)
    entities += line(corners[i], corners[(i + 1) % corners.size()] + Vec2{1e-4, 0});
  for (int i = 0; i < 8; ++i) entities += arc({0, 0}, 4, 45 * i, 45 * (i + 1));
  return dxf(0, entities);
}

std::string narrow_necks_dxf() {
  const std::vector<BulgePoint> profile{{{0, 0}},   {{20, 0}},  {{20, 6}},    {{14, 6}},    {{14, 9}},
                                        {{20, 9}},  {{20, 20}}, {{11.5, 20}}, {{11.5, 16}}, {{15, 16}},
                                        {{15, 13}}, {{5, 13}},  {{5, 16}},    {{8.5, 16}},  {{8.5, 20}},
                                        {{0, 20}},  {{0, 9}},   {{6, 9}},     {{6, 6}},     {{0, 6}}};
  return dxf(4, closed_polyline(profile) + circle({10, 9}, 1));
}

std::string old_polylines_dxf() {
  std::string entities;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) entities += old_polyline(square({150.0 * column, 150.0 * row}, 100));
  return dxf(0, entities);
}

std::string bulges_dxf() {
  const std::vector<BulgePoint> outline{{{0, 0}},        {{120, 0}, 0.5}, {{120, 60}},
                                        {{80, 60}, 1.5}, {{40, 60}},      {{0, 60}, -0.2}};
  const std::vector<BulgePoint> island{{{20, 25}, 0.3}, {{35, 25}, 0.3}, {{35, 40}, 0.3}, {{20, 40}, 0.3}};
  return dxf(4, closed_polyline(outline) + closed_polyline(island) +
                    closed_polyline({{{80, 30}, 1}, {{90, 30}, 1}}));
}

std::string touching_squares_svg() {
  std::string path;
  for (int column = 0; column < 5; ++column)
    for (int row = 0; row < 4; ++row)
      if ((column + row) % 2 == 0) path += fmt::format("M{} {}h10v10h-10z", 10 * column, 10 * row);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"50mm\" height=\"40mm\" viewBox=\"0 0 50 "
         "40\"><path d=\"" +
         path + "\"/></svg>\n";
}

std::string traced_svg() {
  constexpr int kCurves = 60;
  const auto at = [](double i) {
    const double t = 2 * kPi * i / kCurves;
    return Vec2{200, 200} + direction_of(t) * (120 + 25 * std::cos(3 * t) + 8 * std::sin(7 * t));
  };
  std::string path = fmt::format("M{:.3f} {:.3f}", at(0).x, at(0).y);
  for (int i = 0; i < kCurves; ++i) {
    const Vec2 a = at(i), b = at(i + 1), mid = at(i + 0.5), control = mid * 2 - (a + b) * 0.5;
    path += fmt::format("Q{:.3f} {:.3f} {:.3f} {:.3f}", control.x, control.y, b.x, b.y);
  }
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"400\" height=\"400\"><path d=\"" + path +
         "z\"/></svg>\n";
}

}  // namespace clearcut::test_support
