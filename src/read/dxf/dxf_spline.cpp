#include "read/dxf/dxf_spline.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "read/common/curve_fit.h"

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

namespace {

/// Points of the groups x_code and x_code + 10.
std::vector<Vec2> points_of(const DxfDocument& document, const DxfEntity& entity, int x_code) {
  std::vector<Vec2> points;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == x_code) points.push_back({document.number(group), 0});
    if (group.code == x_code + 10 && !points.empty()) points.back().y = document.number(group);
  }
  return points;
}

BSpline read_spline(const DxfDocument& document, const DxfEntity& entity, const SplineCodes& codes,
                    const Affine& map) {
  BSpline spline;
  spline.degree = document.integer(entity, codes.degree, 3);
  const std::vector<Vec2> points = points_of(document, entity, 10);
  std::vector<double> weights;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 40) spline.knots.push_back(document.number(group));
    if (group.code == codes.weight) weights.push_back(document.number(group));
  }
  if (!weights.empty() && weights.size() != points.size()) {
    document.fail(entity.line, "a spline with " + std::to_string(weights.size()) + " weights for " +
                                   std::to_string(points.size()) +
                                   " control points; the file is damaged here");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = weights.empty() ? 1 : weights[i];
    spline.poles.push_back({map(points[i]) * w, w});
  }
  return spline;
}

std::optional<Vec2> direction_of_end(const DxfDocument& document, const DxfEntity& entity, int x_code) {
  const auto given = points_of(document, entity, x_code);
  if (given.empty() || norm(given.front()) == 0) return std::nullopt;
  return given.front();
}

/// The curve through fit points, if the drawing program left out the control points derived from them.
std::optional<Path> path_through_points(const DxfDocument& document, const DxfEntity& entity,
                                        const Affine& map) {
  constexpr int kClosed = 1;
  FitEnds ends{direction_of_end(document, entity, 12), direction_of_end(document, entity, 13)};
  ends.closed = document.integer(entity, 70, 0) & kClosed;
  Path path;
  for (const FitSpan& span : cubic_through(points_of(document, entity, 11), ends))
    append_span([&](double t) { return map(span.at(t)); }, kCurveTolerance, path);
  if (path.empty()) return std::nullopt;
  return path;
}

}  // namespace

std::optional<Path> spline_by_poles(const DxfDocument& document, const DxfEntity& entity,
                                    const SplineCodes& codes, const Affine& map) {
  const BSpline spline = read_spline(document, entity, codes, map);
  if (spline.poles.empty()) return std::nullopt;
  const std::string fault = fault_of(spline);
  if (!fault.empty()) document.fail(entity.line, "a spline with " + fault + "; the file is damaged here");
  Path path;
  append_spline(spline, kCurveTolerance, path);
  return path;
}

std::optional<Path> spline_path(const DxfDocument& document, const DxfEntity& entity, const Affine& map) {
  const auto path = spline_by_poles(document, entity, {.degree = 71, .weight = 41}, map);
  return path ? path : path_through_points(document, entity, map);
}

}  // namespace clearcut::read
