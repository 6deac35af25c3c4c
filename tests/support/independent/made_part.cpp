#include "support/independent/made_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace clearcut::test_support {
namespace {

constexpr double kTurn = 6.283185307179586;
/// Directions in which a centre of the cutter is looked for around a place; the nearest is 1.9 degrees off.
constexpr int kDirections = 96;
/// What that takes off the distance from a straight wall, of the cutter's radius.
constexpr double kOffDirection = 0.001;

double to_line(double px, double py, std::pair<double, double> a, std::pair<double, double> b) {
  const double dx = b.first - a.first, dy = b.second - a.second, squared = dx * dx + dy * dy;
  const double t =
      squared > 0 ? std::clamp(((px - a.first) * dx + (py - a.second) * dy) / squared, 0.0, 1.0) : 0;
  return std::hypot(px - a.first - t * dx, py - a.second - t * dy);
}

MadeShape shape_of(std::istream& words) {
  MadeShape shape;
  std::string kind;
  words >> kind;
  if (kind == "all") {
    shape.kind = MadeShape::Kind::kAll;
  } else if (kind == "disc") {
    shape.kind = MadeShape::Kind::kDisc;
    words >> shape.x >> shape.y >> shape.round;
  } else if (kind == "box") {
    shape.kind = MadeShape::Kind::kBox;
    words >> shape.x >> shape.y >> shape.width >> shape.height >> shape.round >> shape.angle;
  } else if (kind == "path") {
    shape.kind = MadeShape::Kind::kPath;
    words >> shape.round;
    for (double x = 0, y = 0; words >> x >> y;) shape.path.push_back({x, y});
  } else if (kind == "polygon") {
    shape.kind = MadeShape::Kind::kPolygon;
    for (double x = 0, y = 0; words >> x >> y;) shape.path.push_back({x, y});
  } else {
    throw std::runtime_error("unknown shape " + kind);
  }
  return shape;
}

HeightCurve curve_of(std::istream& words) {
  HeightCurve curve;
  for (double inside = 0, z = 0; words >> inside >> z;) curve.points.push_back({inside, z});
  return curve;
}

MadeCutter cutter_of(std::istream& words) {
  MadeCutter cutter;
  std::string end;
  words >> cutter.kind >> end;
  TurnedBody& body = cutter.body;
  body.end = end == "round"  ? TurnedBody::End::kRounded
             : end == "cone" ? TurnedBody::End::kCone
             : end == "disc" ? TurnedBody::End::kDisc
                             : TurnedBody::End::kFlat;
  words >> body.diameter >> body.round >> body.angle >> body.tip >> body.height >> body.neck;
  words >> cutter.pitch >> cutter.length >> cutter.may_plunge;
  body.removes = cutter.kind != "tap" && cutter.kind != "threadmill";
  return cutter;
}

/// A line about the element that was begun last; false for other words.
bool add_to_element(MadeElement& element, const std::string& word, std::istream& words) {
  if (word == "shape") {
    element.shape = shape_of(words);
  } else if (word == "island") {
    element.islands.push_back(shape_of(words));
  } else if (word == "band") {
    words >> element.band.emplace();
  } else if (word == "low") {
    element.low = curve_of(words);
  } else if (word == "high") {
    element.high = curve_of(words);
  } else if (word == "roof") {
    words >> element.undercut_roof.emplace();
  } else if (word == "reach") {
    MadeElement::Reach& reach = element.reach.emplace();
    words >> reach.radius >> reach.flat >> reach.foot;
  } else {
    return false;
  }
  return true;
}

}  // namespace

double MadeShape::inside(double px, double py) const {
  switch (kind) {
    case Kind::kAll:
      return std::numeric_limits<double>::infinity();
    case Kind::kDisc:
      return round - std::hypot(px - x, py - y);
    case Kind::kBox: {
      const double c = std::cos(angle), s = std::sin(angle);
      const double u = std::abs(c * (px - x) + s * (py - y)) - width / 2 + round;
      const double v = std::abs(c * (py - y) - s * (px - x)) - height / 2 + round;
      return round - std::hypot(std::max(u, 0.0), std::max(v, 0.0)) - std::min(0.0, std::max(u, v));
    }
    case Kind::kPath: {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        least = std::min(least, to_line(px, py, path[i], path[i + 1]));
      return round - least;
    }
    case Kind::kPolygon: {
      double least = std::numeric_limits<double>::infinity();
      bool is_inside = false;
      for (std::size_t i = 0; i < path.size(); ++i) {
        const auto a = path[i], b = path[(i + 1) % path.size()];
        least = std::min(least, to_line(px, py, a, b));
        const bool crosses = (a.second > py) != (b.second > py);
        if (crosses && px < a.first + (b.first - a.first) * (py - a.second) / (b.second - a.second))
          is_inside = !is_inside;
      }
      return is_inside ? least : -least;
    }
  }
  return 0;
}

std::optional<double> HeightCurve::at(double inside) const {
  if (points.empty() || inside < points.front().first) return {};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [a, za] = points[i - 1];
    const auto [b, zb] = points[i];
    if (inside <= b) return b > a ? za + (zb - za) * (inside - a) / (b - a) : zb;
  }
  return points.back().second;
}

double MadeElement::inside(double x, double y) const {
  double inside = shape.inside(x, y);
  if (band) inside = std::min(inside, *band - inside);
  for (const MadeShape& island : islands) inside = std::min(inside, -island.inside(x, y));
  return inside;
}

bool MadeElement::is_reached(double x, double y) const {
  if (!reach) return true;
  const double here = inside(x, y), needed = std::min(here, reach->foot) + reach->radius;
  if (here >= needed) return true;
  const double away = here < reach->foot ? reach->radius : reach->flat;
  for (int i = 0; i < kDirections; ++i) {
    const double a = kTurn * i / kDirections;
    if (inside(x + away * std::cos(a), y + away * std::sin(a)) >= needed - kOffDirection * reach->radius)
      return true;
  }
  return false;
}

MadePart made_part(const std::string& description) {
  MadePart part;
  std::istringstream lines(description);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word)) continue;
    if (word == "block") {
      words >> part.x0 >> part.y0 >> part.x1 >> part.y1 >> part.bottom;
    } else if (word == "zero") {
      words >> part.zero_x >> part.zero_y >> part.zero_z;
    } else if (word == "cutter") {
      int number = 0;
      words >> number;
      part.cutters[number] = cutter_of(words);
    } else if (word == "element") {
      words >> part.elements.emplace_back().name;
    } else if (word == "thread") {
      MadeThread& t = part.threads.emplace_back();
      words >> t.x >> t.y >> t.crest >> t.root >> t.pitch >> t.top >> t.bottom >> t.hand;
    } else if (word == "visit") {
      MadeVisit& visit = part.visits.emplace_back();
      words >> visit.kind >> visit.x >> visit.y >> visit.z;
    } else if (part.elements.empty() || !add_to_element(part.elements.back(), word, words)) {
      throw std::runtime_error("unknown word in: " + line);
    }
  }
  return part;
}

}  // namespace clearcut::test_support
