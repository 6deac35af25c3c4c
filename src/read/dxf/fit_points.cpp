#include "read/dxf/fit_points.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"

namespace clearcut::read {
namespace {

/// Points by which a closed run is continued over both ends. The influence of an end on the slopes at least halves
/// from point to point, so it vanishes inside.
constexpr std::size_t kWrap = 60;

/// Share of the extent of all points: points nearer than this are one, written with different rounding. Between two
/// of them the curve would turn arbitrarily.
constexpr double kSamePoint = 1e-6;

std::vector<Vec2> without_repeats(std::span<const Vec2> points, bool closed) {
  Box all;
  for (const Vec2 p : points) all.add(p);
  const double same = all.empty() ? 0 : kSamePoint * std::max(all.width(), all.height());
  std::vector<Vec2> out;
  for (const Vec2 p : points) {
    if (out.empty() || distance(out.back(), p) > same) out.push_back(p);
  }
  while (closed && out.size() > 1 && distance(out.back(), out.front()) <= same) out.pop_back();
  return out;
}

struct Row {
  double before = 0, own = 0, after = 0;
  Vec2 right;
};

/// Thomas's elimination; the rows are diagonally dominant.
std::vector<Vec2> solve(std::vector<Row> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double share = rows[i].before / rows[i - 1].own;
    rows[i].own -= share * rows[i - 1].after;
    rows[i].right = rows[i].right - rows[i - 1].right * share;
  }
  std::vector<Vec2> values(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;) {
    const Vec2 known = i + 1 < rows.size() ? values[i + 1] * rows[i].after : Vec2{};
    values[i] = (rows[i].right - known) / rows[i].own;
  }
  return values;
}

std::optional<Vec2> unit(const std::optional<Vec2>& direction) {
  if (!direction || !(norm(*direction) > 0)) return std::nullopt;
  return *direction / norm(*direction);
}

/// At an end the slope is given, or the second derivative is 0.
Row end_row(const std::optional<Vec2>& direction, Vec2 chord_slope) {
  if (const auto slope = unit(direction)) return {0, 1, 0, *slope};
  return {1, 2, 1, chord_slope * 3.0};
}

/// Slopes at points all different from their neighbours.
std::vector<Vec2> slopes_at(const std::vector<Vec2>& points, const FitEnds& ends) {
  const std::size_t last = points.size() - 1;
  const auto chord = [&](std::size_t i) { return distance(points[i], points[i + 1]); };
  const auto slope = [&](std::size_t i) { return (points[i + 1] - points[i]) / chord(i); };
  std::vector<Row> rows(points.size());
  rows.front() = end_row(ends.start, slope(0));
  rows.back() = end_row(ends.end, slope(last - 1));
  rows.front().before = rows.back().after = 0;
  for (std::size_t i = 1; i < last; ++i) {
    const double a = 1 / chord(i - 1), b = 1 / chord(i);
    rows[i] = {a, 2 * (a + b), b, (slope(i - 1) * a + slope(i) * b) * 3.0};
  }
  return solve(std::move(rows));
}

std::vector<FitSpan> spans_of(const std::vector<Vec2>& points, const std::vector<Vec2>& slopes,
                              std::size_t begin, std::size_t count) {
  std::vector<FitSpan> spans;
  for (std::size_t i = begin; i < begin + count; ++i) {
    spans.push_back({points[i], points[i + 1], slopes[i], slopes[i + 1], distance(points[i], points[i + 1])});
  }
  return spans;
}

}  // namespace

Vec2 FitSpan::at(double t) const {
  const double s = 1 - t;
  return from * (s * s * (1 + 2 * t)) + to * (t * t * (1 + 2 * s)) +
         (from_slope * (s * s * t) - to_slope * (s * t * t)) * length;
}

std::vector<FitSpan> cubic_through(std::span<const Vec2> points, const FitEnds& ends) {
  const std::vector<Vec2> own = without_repeats(points, ends.closed);
  if (own.size() < 2) return {};
  if (!ends.closed || own.size() < 3) return spans_of(own, slopes_at(own, ends), 0, own.size() - 1);
  std::vector<Vec2> round;
  for (std::size_t i = 0; i < own.size() + 2 * kWrap + 1; ++i)
    round.push_back(own[(i + own.size() * kWrap - kWrap) % own.size()]);
  auto spans = spans_of(round, slopes_at(round, {}), kWrap, own.size());
  spans.back().to_slope = spans.front().from_slope;
  return spans;
}

}  // namespace clearcut::read
