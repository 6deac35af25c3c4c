#include "read/svg/svg_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "base/elementary.h"
#include "base/units.h"
#include "read/common/curve_fit.h"
#include "read/svg/svg_numbers.h"

namespace clearcut::read {
namespace {

/// Number of arguments of a command, by its capital letter; -1 for no command.
int numbers_of(char capital) {
  switch (capital) {
    case 'Z':
      return 0;
    case 'H':
    case 'V':
      return 1;
    case 'M':
    case 'L':
    case 'T':
      return 2;
    case 'S':
    case 'Q':
      return 4;
    case 'C':
      return 6;
    case 'A':
      return 7;
    default:
      return -1;
  }
}

char capital_of(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// An elliptical arc by its center (SVG 1.1, appendix F.6.5 and F.6.6).
struct CenterArc {
  Vec2 center, u, v;
  double start = 0, sweep = 0;
};

/// What path data says of an elliptical arc besides its ends.
struct ArcWords {
  double rx = 0, ry = 0;  ///< radii, > 0
  double tilt = 0;        ///< radians from the x axis to the first radius
  bool large = false;     ///< the longer one of the two arcs with these radii
  bool positive = false;  ///< angles grow along the arc
  double place = 1;       ///< at which radii and ends are rounded: 0.001 for three digits behind the point
};

/// Whether the ends lie a diameter apart as far as the written digits tell: a half turn. Near a half turn the center
/// follows from the square root of the difference, so that the rounding of a radius of 5 to 4 digits behind the
/// point would move the center by 0.03. `excess` is the squared half chord on the unit circle.
bool is_half_turn(double excess, const ArcWords& words) {
  // Coarser digits are dimensions that somebody chose, and no rounding.
  constexpr double kCoarsest = 1e-3;
  const double place = words.place / std::min(words.rx, words.ry);
  // Half a unit of the last digit in the radius, and as much in each coordinate of both ends.
  const double rounding = place <= kCoarsest ? 1.25 * place : 0;
  return 1 - std::sqrt(excess) <= rounding;
}

CenterArc center_arc(Vec2 from, Vec2 to, const ArcWords& words) {
  double rx = words.rx, ry = words.ry;
  const double tilt = words.tilt;
  const Vec2 half = rotated((from - to) / 2.0, -tilt);
  const double excess = (half.x / rx) * (half.x / rx) + (half.y / ry) * (half.y / ry);
  if (is_half_turn(excess, words)) {
    rx *= std::sqrt(excess);
    ry *= std::sqrt(excess);
  }
  // On the unit circle: half of the chord and the center's distance from the chord.
  const Vec2 h{half.x / rx, half.y / ry};
  const double h2 = std::min(norm_squared(h), 1.0);
  const double away = (words.large == words.positive ? -1 : 1) * std::sqrt((1 - h2) / h2);
  const Vec2 c = Vec2{h.y, -h.x} * away;
  const Vec2 first = h - c, last = -h - c;
  CenterArc arc;
  arc.center = (from + to) / 2.0 + rotated({c.x * rx, c.y * ry}, tilt);
  arc.u = direction_of(tilt) * rx;
  arc.v = left_of(direction_of(tilt)) * ry;
  arc.start = angle_of(first);
  arc.sweep = base::atan2(cross(first, last), dot(first, last));
  if (words.positive && arc.sweep < 0) arc.sweep += 2 * kPi;
  if (!words.positive && arc.sweep > 0) arc.sweep -= 2 * kPi;
  return arc;
}

class PathReader {
 public:
  PathReader(std::string_view data, const Affine& map) : scanner_(data), map_(map) {}

  SvgPathData read() {
    while (out_.error.empty() && !scanner_.at_end()) command();
    finish(false);
    return std::move(out_);
  }

 private:
  using Numbers = std::array<double, 7>;

  void fail(const std::string& what) {
    out_.error = what + " at character " + std::to_string(scanner_.position() + 1) + " of the path data";
  }

  /// One command letter and all its repeats.
  void command() {
    const char letter = scanner_.peek();
    const char capital = capital_of(letter);
    const int count = numbers_of(capital);
    if (count < 0) return fail(std::string("a command letter was expected"));
    if (!started_ && capital != 'M') return fail("the path does not begin with M");
    scanner_.skip();
    const bool relative = letter != capital;
    if (count == 0) return close();
    char doing = capital;
    do {
      Numbers numbers{};
      if (!take(capital, count, numbers)) return fail("a number was expected");
      apply(doing, relative, numbers);
      if (doing == 'M') doing = 'L';  // further pairs are lines
    } while (out_.error.empty() && more_numbers());
  }

  bool more_numbers() {
    const char c = scanner_.peek();
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
  }

  /// Keeps the place at which lengths are rounded. Numbers may have lost zeros at their end, so the finest place of
  /// the path counts, and a number's own place where the number has all digits that programs write.
  void note_place(const Written& written) {
    constexpr int kAllDigits = 8;
    finest_place_ = std::min(finest_place_, written.place);
    if (written.significant_digits >= kAllDigits) own_place_ = std::max(own_place_, written.place);
  }

  /// Takes the arguments of one command; the tilt of an arc is no length, its flags are no numbers.
  bool take(char capital, int count, Numbers& numbers) {
    own_place_ = 0;
    for (int i = 0; i < count; ++i) {
      std::optional<double> value;
      if (capital == 'A' && (i == 3 || i == 4)) {
        const auto flag = scanner_.flag();
        if (flag) value = *flag ? 1 : 0;
      } else {
        value = scanner_.number();
        if (value && !(capital == 'A' && i == 2)) note_place(scanner_.written());
      }
      if (!value) return false;
      numbers[static_cast<std::size_t>(i)] = *value;
    }
    return true;
  }

  void apply(char capital, bool relative, const Numbers& n) {
    const Vec2 origin = relative ? at_ : Vec2{};
    const auto point = [&](std::size_t i) { return origin + Vec2{n[i], n[i + 1]}; };
    const bool was_cubic = last_ == 'C' || last_ == 'S', was_quadratic = last_ == 'Q' || last_ == 'T';
    last_ = capital;
    switch (capital) {
      case 'M':
        return move_to(point(0));
      case 'L':
        return line_to(point(0));
      case 'H':
        return line_to({origin.x + n[0], at_.y});
      case 'V':
        return line_to({at_.x, origin.y + n[0]});
      case 'C':
        return cubic_to(point(0), point(2), point(4));
      case 'S':
        return cubic_to(was_cubic ? at_ * 2 - control_ : at_, point(0), point(2));
      case 'Q':
        return quadratic_to(point(0), point(2));
      case 'T':
        return quadratic_to(was_quadratic ? at_ * 2 - control_ : at_, point(0));
      default:
        return arc_to(n, point(5));
    }
  }

  void move_to(Vec2 p) {
    finish(false);
    started_ = true;
    at_ = start_ = p;
  }

  void line_to(Vec2 p) {
    if (p != at_) path_.push_back(Edge::line(map_(at_), map_(p)));
    at_ = p;
  }

  void cubic_to(Vec2 c1, Vec2 c2, Vec2 to) {
    const Vec2 p0 = map_(at_), p1 = map_(c1), p2 = map_(c2), p3 = map_(to);
    append_fitted(
        [=](double t) {
          const double s = 1 - t;
          return p0 * (s * s * s) + p1 * (3 * s * s * t) + p2 * (3 * s * t * t) + p3 * (t * t * t);
        },
        kCurveTolerance, path_);
    control_ = c2;
    at_ = to;
  }

  void quadratic_to(Vec2 c, Vec2 to) {
    const Vec2 p0 = map_(at_), p1 = map_(c), p2 = map_(to);
    append_fitted([=](double t) { return p0 * ((1 - t) * (1 - t)) + p1 * (2 * t * (1 - t)) + p2 * (t * t); },
                  kCurveTolerance, path_);
    control_ = c;
    at_ = to;
  }

  void arc_to(const Numbers& n, Vec2 to) {
    const double rx = std::abs(n[0]), ry = std::abs(n[1]);
    if (to == at_) return;
    if (rx == 0 || ry == 0) return line_to(to);
    const CenterArc arc = center_arc(
        at_, to, {rx, ry, n[2] * kPi / 180, n[3] != 0, n[4] != 0, std::max(finest_place_, own_place_)});
    Path piece;
    append_elliptical({map_(arc.center), map_.linear(arc.u), map_.linear(arc.v), arc.start, arc.sweep},
                      kCurveTolerance, piece);
    if (!piece.empty()) {
      // The ends as written, not as computed from the center.
      piece.front().from = map_(at_);
      piece.back().to = map_(to);
    }
    path_.insert(path_.end(), piece.begin(), piece.end());
    at_ = to;
  }

  void close() {
    line_to(start_);
    finish(true);
    last_ = 'Z';
  }

  void finish(bool closed) {
    if (!path_.empty()) out_.subpaths.push_back({std::move(path_), closed});
    path_.clear();
  }

  SvgScanner scanner_;
  const Affine& map_;
  SvgPathData out_;
  Path path_;
  Vec2 at_, start_, control_;
  char last_ = 'M';
  bool started_ = false;
  double finest_place_ = 1;  ///< place of the last digit, the finest of all lengths so far
  double own_place_ = 0;     ///< the coarsest one of lengths of this command that are written with all digits
};

}  // namespace

SvgPathData read_svg_path(std::string_view data, const Affine& map) {
  return PathReader(data, map).read();
}

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
