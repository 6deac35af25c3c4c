#include "studies/reproduce/reproduce_coefficients.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>

#include "base/units.h"
#include "geometry/side_list.h"
#include "model/layer.h"
#include "model/pass.h"
#include "plan/contour/contour.h"
#include "plan/contour/side_offsets.h"
#include "studies/reproduce/page/reproduction_figures.h"

namespace clearcut::studies {
namespace {

constexpr std::array<int, 9> kAngles{10, 30, 50, 70, 90, 110, 130, 150, 170};
using Printed = std::array<double, 9>;

struct PrintedOverlaps {
  double radius;  ///< mm
  Printed printed;
};

/// CPO-rho table 1.
constexpr std::array<PrintedOverlaps, 6> kOverlaps{{{5, {.09, .26, .42, .57, .71, .82, .91, .96, 1.00}},
                                                    {10, {.08, .26, .42, .56, .70, .82, .92, .96, 1.00}},
                                                    {20, {.08, .28, .44, .56, .72, .80, .92, .96, 1.00}},
                                                    {30, {.06, .24, .42, .54, .72, .84, .90, .96, 1.02}},
                                                    {40, {.08, .24, .40, .56, .72, .80, .96, .96, 1.04}},
                                                    {50, {.10, .30, .40, .50, .70, .80, .90, .90, 1.00}}}};

/// CPO-rho table 2.
constexpr Printed kLom{.543, .629, .711, .786, .853, .909, .953, .982, .998};
constexpr std::array<PrintedOverlaps, 6> kRho{{{5, {.534, .603, .669, .729, .782, .827, .862, .886, .898}},
                                               {10, {.539, .616, .690, .758, .818, .868, .907, .934, .948}},
                                               {20, {.541, .622, .700, .772, .835, .889, .930, .958, .973}},
                                               {30, {.542, .625, .704, .777, .841, .895, .938, .966, .981}},
                                               {40, {.542, .626, .706, .779, .844, .899, .941, .970, .985}},
                                               {50, {.542, .626, .707, .781, .846, .901, .944, .973, .988}}}};

double radians(int degrees) {
  return Radians::of_degrees(degrees).radians();
}

Reproduction angle_table(const std::string& title) {
  Reproduction result;
  result.table.title = title;
  result.table.columns = {{"row", report::Align::kLeft}};
  for (const int angle : kAngles) result.table.columns.push_back({fmt::format("{} deg", angle)});
  return result;
}

void add_rows(Reproduction& result, const std::string& name, const Printed& printed, int decimals,
              const std::function<double(double)>& ours) {
  std::vector<Cell> first{name + ", printed"}, second{name + ", ours"};
  for (std::size_t i = 0; i < kAngles.size(); ++i) {
    first.emplace_back(fmt::format("{:.{}f}", printed[i], decimals));
    second.push_back(beside(cut_to(ours(radians(kAngles[i])), decimals), printed[i], decimals));
  }
  result.add(first);
  result.add(second);
}

Region equilateral(double edge) {
  const std::vector<Vec2> corners{{0, 0}, {edge, 0}, {edge / 2, edge * std::sqrt(3.0) / 2}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

/// CPO-kappa eq. 1 to 3, without geometry.
double total_by_formulas(double edge, double radius, double step) {
  SideList list;
  for (int i = 0; i < 3; ++i) list.sides.push_back({edge, kPi / 3, 0});
  return plan::contour::published_length(list, radius, 0, [&](double) { return step; }).total;
}

/// Closed contours of an outline, from the wall inwards.
std::vector<Pass> contours_of(const Region& outline, double radius, double step) {
  Layer layer;
  layer.z = -1;
  layer.tool_radius = radius;
  layer.allowed = layer.target = {outline};
  plan::contour::ContourOptions options;
  options.step = {plan::contour::StepRule::Kind::kMm, step};
  options.residuals = plan::contour::ResidualRule::kNone;
  std::vector<Pass> contours;
  for (const Pass& pass : plan::contour::plan_contour(layer, options, {}).passes)
    if (pass.closed) contours.push_back(pass);
  return contours;
}

/// A six-pointed star with tips of `tip` degrees.
Region star(int tip) {
  SideList list;
  for (int i = 0; i < 6; ++i) {
    list.sides.push_back({50, radians(300 - tip), 0});
    list.sides.push_back({50, radians(tip), 0});
  }
  return Region::from_valid_loops(closed_by_compass_rule(traced(list)), {});
}

}  // namespace

Reproduction coefficient_table() {
  Reproduction result = angle_table("CPO-rho table 2: recovery coefficients");
  add_rows(result, "LOM", kLom, 3, plan::contour::kappa);
  for (const PrintedOverlaps& row : kRho) {
    add_rows(result, fmt::format("rho, R = {} mm", row.radius), row.printed, 3,
             [r = row.radius](double alpha) { return plan::contour::rho(alpha, r); });
  }
  result.table.notes.push_back("printed figures are cut, not rounded; ours are cut alike");
  return result;
}

Reproduction overlap_table() {
  Reproduction result = angle_table("CPO-rho table 1: overlap in the corner, mm");
  for (const PrintedOverlaps& row : kOverlaps) {
    add_rows(result, fmt::format("R = {} mm", row.radius), row.printed, 2, [r = row.radius](double alpha) {
      return 2 * r * (cut_to(plan::contour::kappa(alpha), 3) - cut_to(plan::contour::rho(alpha, r), 3));
    });
  }
  result.table.notes.push_back(
      "2 R (LOM - rho) of the coefficients cut to three digits; without that cut every R would give "
      "w sin(alpha / 2), w = 1 mm, so the growth with R that the text sees is rounding");
  return result;
}

Reproduction triangle_figure() {
  constexpr double kStep = 7.01, kRadius = 5, kEdge = 79.9861;
  Reproduction result;
  result.table.title = "CPO-kappa figure 10: equilateral triangle, edge 79.9861 mm, R = 5 mm, step 7.01 mm";
  result.table.columns = {{"contour", report::Align::kLeft}, {"printed"}, {"ours"}, {"length, ours"}};
  const Region triangle = equilateral(kEdge);
  const auto contours = contours_of(triangle, kRadius, kStep);
  result.figures.push_back(passes_figure("contours of CPO-kappa figure 10", {triangle}, contours));
  constexpr std::array<double, 3> kOffsets{5, 12.01, 19.02};
  double total = (static_cast<double>(contours.size()) - 1) * plan::contour::passage_length(kStep, kPi / 3);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const double printed = i < kOffsets.size() ? kOffsets[i] : 0;
    result.add({fmt::format("contour {}, from the wall", i + 1), fmt::format("{:.2f}", printed),
                beside(contours[i].offset, printed, 2), fmt::format("{:.4f}", length(contours[i].path))});
    total += length(contours[i].path);
  }
  const Box first = box(contours.front().path);
  const double ours_by_formulas = total_by_formulas(kEdge, kRadius, kStep);
  result.add({"first contour from x", "8.6603", beside(first.min.x, 8.6603, 4), ""});
  result.add({"first contour to x", "71.3259",
              beside(first.max.x, 71.3259, 4, {"the edge is printed to within 0.00005 mm", 2e-6}), ""});
  result.add({"total with passages", "373.4802", beside(total, 373.4802, 4), ""});
  result.add({"by lengths and angles alone", "373.4802", beside(ours_by_formulas, 373.4802, 4), ""});
  const double alpha = plan::contour::smallest_angle(triangle);
  result.table.notes.push_back(fmt::format(
      "7.01 is not 2 R kappa = {:.2f} (eq. 6, the centre would be cut by two contours): it is 0.01 mm above "
      "2 R rho = {:.2f} of the other paper (eq. 8, w = 1 mm); the text does not say so",
      2 * kRadius * plan::contour::kappa(alpha), 2 * kRadius * plan::contour::rho(alpha, kRadius)));
  return result;
}

Reproduction caption_figures() {
  Reproduction result;
  result.table.title = "Coefficients and steps printed in captions";
  result.table.columns = {{"figure", report::Align::kLeft}, {"smallest angle, deg"}, {"printed"}, {"ours"}};
  const Region tips = star(90), triangle = equilateral(100);
  const double tip = plan::contour::smallest_angle(tips), corner = plan::contour::smallest_angle(triangle);
  const auto degrees = [](double angle) { return fmt::format("{:.2f}", angle * 180 / kPi); };
  result.add({"CPO-kappa 9: kappa, star, R = 8 mm", degrees(tip), "0.8535",
              beside(cut_to(plan::contour::kappa(tip), 4), 0.8535, 4)});
  result.add({"CPO-rho 10: rho, R = 4 mm", "30.00", "0.5970",
              beside(cut_to(plan::contour::rho(radians(30), 4), 4), 0.5970, 4)});
  result.add({"CPO-rho 11: rho, triangle of 100 mm, R = 8 mm", degrees(corner), "0.7187",
              beside(cut_to(plan::contour::rho(corner, 8), 4), 0.7187, 4)});
  constexpr double kStarRadius = 8;
  result.figures.push_back(passes_figure(
      "contours of a star as in CPO-kappa figure 9, edges of 50 mm (its lengths are not printed)", {tips},
      contours_of(tips, kStarRadius, 2 * kStarRadius * plan::contour::kappa(tip))));
  result.figures.push_back(passes_figure(
      "contours of CPO-rho figure 11", {triangle},
      contours_of(triangle, kStarRadius, 2 * kStarRadius * plan::contour::rho(corner, kStarRadius))));
  result.table.notes.push_back(
      "figures 9 and 10 do not print their angles: 90 and 30 degrees are what their coefficients stand for");
  return result;
}

}  // namespace clearcut::studies
