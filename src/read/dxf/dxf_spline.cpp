#include "read/dxf/dxf_spline.h"

#include "read/common/b_spline.h"
#include "read/common/curve_fit.h"
#include "read/dxf/fit_points.h"

namespace clearcut::read {
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
