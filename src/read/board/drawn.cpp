#include "read/board/drawn.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "base/units.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "read/common/curve_fit.h"

namespace clearcut::read {
namespace {

/// Whole numbers of so many digits are exact.
constexpr std::size_t kMostDigits = 15;

}  // namespace

std::optional<double> plain_number(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<int> code_number(std::string_view text) {
  const auto number = plain_number(text);
  if (!number || !(*number >= 0 && *number < 1e9)) return std::nullopt;
  return static_cast<int>(*number);
}

std::optional<double> coordinate(std::string_view text, const CoordinateFormat& format) {
  if (text.find('.') != std::string_view::npos) return plain_number(text);
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  std::string digits(text);
  const auto all = static_cast<std::size_t>(format.whole + format.decimals);
  if (format.trailing_omitted && digits.size() < all) digits.resize(all, '0');
  if (text.empty() || digits.size() > kMostDigits ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  double scale = 1;
  for (int i = 0; i < format.decimals; ++i) scale *= 10;
  const double value = static_cast<double>(std::stoll(digits)) / scale;
  return negative ? -value : value;
}

std::optional<Words> words_of(std::string_view text) {
  Words words;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ' || text[at] == '\t') {
      ++at;
      continue;
    }
    if (std::isupper(static_cast<unsigned char>(text[at])) == 0) return std::nullopt;
    const std::size_t end = text.find_first_not_of("+-.0123456789", at + 1);
    const std::size_t length = (end == std::string_view::npos ? text.size() : end) - at - 1;
    words.emplace_back(text[at], text.substr(at + 1, length));
    at += 1 + length;
  }
  return words;
}

namespace {

Path mapped(const Path& path, const Affine& map, bool as_loop) {
  Path out;
  for (const Edge& edge : map.mirrors() && as_loop ? reversed(path) : path)
    append_mapped(edge, map, kCurveTolerance, out);
  return out;
}

}  // namespace

Drawn mapped(const Drawn& drawn, const Affine& map) {
  Drawn out{drawn.dark, {}, mapped(drawn.line, map, false)};
  for (const Path& piece : drawn.pieces) out.pieces.push_back(mapped(piece, map, true));
  return out;
}

Regions dark_area(const std::vector<Drawn>& drawn, const RepairOptions& options) {
  Diagnostics crossings;  // overlapping items are no mistake
  Regions dark;
  for (std::size_t i = 0; i < drawn.size();) {
    const bool adds = drawn[i].dark;
    std::vector<RawCurve> curves;
    for (; i < drawn.size() && drawn[i].dark == adds; ++i)
      for (const Path& piece : drawn[i].pieces)
        curves.push_back({piece, true, "what is drawn", Compound{0, true}});
    if (curves.empty() || (!adds && dark.empty())) continue;
    const Regions area = repair(std::move(curves), options, crossings);
    dark = dark.empty() ? area : adds ? unite(dark, area, options.tol) : subtract(dark, area, options.tol);
  }
  return dark;
}

namespace {

/// Permitted difference of the distances of an arc's ends from its centre, as a share of the radius.
constexpr double kSameRadii = 0.1;
/// Greatest sweep of a quadrant arc in quarter turns, with an allowance for rounding.
constexpr double kRounding = 1.05;

Vec2 on_bisector(Vec2 center, Vec2 from, Vec2 to) {
  const Vec2 normal = unit(left_of(to - from)), middle = lerp(from, to, 0.5);
  return middle + normal * dot(center - middle, normal);
}

double difference_of_radii(Vec2 center, Vec2 from, Vec2 to) {
  return std::abs(distance(center, from) - distance(center, to));
}

/// The centre of an arc of at most a quarter turn whose offset is written without signs.
std::optional<Vec2> quadrant_center(Vec2 from, Vec2 to, Vec2 offset, Turn turn) {
  std::optional<Vec2> best;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Vec2 center = from + Vec2{x * std::abs(offset.x), y * std::abs(offset.y)};
      if (std::abs(Edge::arc(from, to, center, turn).sweep()) > kPi / 2 * kRounding) continue;
      if (!best || difference_of_radii(center, from, to) < difference_of_radii(*best, from, to))
        best = center;
    }
  }
  return best;
}

}  // namespace

void GerberMove::set(char letter, double value) {
  if (letter == 'X') x = value;
  if (letter == 'Y') y = value;
  if (letter == 'I') i = value;
  if (letter == 'J') j = value;
}

Vec2 GerberMove::end(Vec2 from, bool is_incremental) const {
  if (is_incremental) return from + Vec2{x.value_or(0), y.value_or(0)};
  return {x.value_or(from.x), y.value_or(from.y)};
}

std::optional<Path> gerber_edge(Vec2 from, Vec2 to, Vec2 offset, Turn turn, bool single_quadrant) {
  if (turn == Turn::kStraight) return from == to ? Path{} : Path{Edge::line(from, to)};
  if (from == to) {
    if (single_quadrant || norm(offset) == 0) return Path{};
    const Vec2 center = from + offset, across = center + offset;
    return Path{Edge::arc(from, across, center, turn), Edge::arc(across, from, center, turn)};
  }
  const std::optional<Vec2> center =
      single_quadrant ? quadrant_center(from, to, offset, turn) : std::optional(from + offset);
  if (!center || difference_of_radii(*center, from, to) > kSameRadii * distance(*center, from))
    return std::nullopt;
  return Path{Edge::arc(from, to, on_bisector(*center, from, to), turn)};
}

Path swept_rectangle(const Edge& line, Vec2 size, const Affine& map) {
  // The convex hull of the corners at both ends: from the left end below to the right, then back above (Andrew 1979).
  std::vector<Vec2> points;
  for (const Vec2 end : {line.from, line.to})
    for (const Vec2 corner : std::array<Vec2, 4>{Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}})
      points.push_back(end + map.linear({corner.x * size.x / 2, corner.y * size.y / 2}));
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vec2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const Vec2 p : points) {
      while (hull.size() >= begin + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return loop_from_points(hull);
}

}  // namespace clearcut::read
