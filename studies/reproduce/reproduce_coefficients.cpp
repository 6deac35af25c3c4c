#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>

#include "base/error.h"
#include "base/units.h"
#include "geometry/side_list.h"
#include "kinematics/kinematics.h"
#include "model/layer.h"
#include "plan/contour/contour.h"
#include "plan/contour/side_offsets.h"
#include "studies/reproduce/page/reproduction_figures.h"
#include "studies/reproduce/planned_outline.h"
#include "studies/reproduce/reproduce_parts.h"

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
  result.table.columns = {{"row", Align::kLeft}};
  for (const int angle : kAngles) result.table.columns.push_back({fmt::format("{} deg", angle)});
  return result;
}

void add_rows(Reproduction& result, const std::string& name, const Printed& printed, int decimals,
              const std::function<double(double)>& ours) {
  std::vector<Cell> first{name + ", printed"}, second{name + ", ours"};
  for (std::size_t i = 0; i < kAngles.size(); ++i) {
    first.emplace_back(fmt::format("{:.{}f}", printed[i], decimals));
    second.push_back(computed(cut_to(ours(radians(kAngles[i])), decimals), printed[i], decimals));
  }
  result.add(first);
  result.add(second);
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
  options.sharp_reflex = true;  // as the published names plan them
  std::vector<Pass> contours;
  for (const Pass& pass : plan::contour::plan_contour(layer, options, {}).passes)
    if (pass.closed) contours.push_back(pass);
  return contours;
}

/// Step over diameter of the first contour of a planned pocket, as its certificate has it; 0 where the cutter does not fit.
double planned_coefficient(const Region& outline, double radius, const char* strategy) {
  const auto planned = planned_outline(pocket_part(outline, "pocket", 2 * radius), {strategy});
  if (!planned || planned->contours.empty() || planned->contours.front().coefficients.empty()) return 0;
  return planned->contours.front().coefficients.front().share;
}

/// Of the level feed moves, mm.
Box level_box(const Toolpath& toolpath) {
  Box all;
  for (const Section& section : toolpath.sections)
    for (const Move& move : section.moves)
      if (!is_rapid(move.kind) && !move.is_vertical() && move.z_from == move.z_to) all.add(move.path.box());
  return all;
}

}  // namespace

Reproduction coefficient_table() {
  Reproduction result = angle_table("CPO-rho table 2: recovery coefficients");
  add_rows(result, "LOM", kLom, 3, plan::contour::kappa);
  for (const PrintedOverlaps& row : kRho) {
    add_rows(result, fmt::format("rho, R = {} mm", row.radius), row.printed, 3,
             [r = row.radius](double alpha) { return plan::contour::rho(alpha, r); });
  }
  result.table.notes.push_back(
      "by the formulas that the strategies take their steps from; printed figures are cut, not rounded, and "
      "ours are cut alike");
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
  result.table.columns = {{"contour", Align::kLeft}, {"printed"}, {"ours"}};
  const Region triangle = equilateral(kEdge);
  result.figures.push_back(
      passes_figure("contours of CPO-kappa figure 10", {triangle}, contours_of(triangle, kRadius, kStep)));
  const auto planned =
      planned_outline(pocket_part(triangle, "triangle", 2 * kRadius), {"lom", fmt::format("{}mm", kStep), 6});
  CLEARCUT_ASSERT(planned && planned->findings.all.clean && planned->contours.size() == 1);
  constexpr std::array<double, 3> kOffsets{5, 12.01, 19.02};
  const auto& offsets = planned->contours.front().from_wall;
  CLEARCUT_ASSERT(offsets.size() == kOffsets.size());
  for (std::size_t i = 0; i < offsets.size(); ++i)
    result.add({fmt::format("contour {}, from the wall", i + 1), fmt::format("{:.2f}", kOffsets[i]),
                beside(offsets[i], kOffsets[i], 2)});
  const Box first = level_box(planned->toolpath);
  const double total = kinematics::published_time(planned->toolpath).length_mm;
  result.add({"first contour from x", "8.6603", beside(first.min.x, 8.6603, 4)});
  result.add({"first contour to x", "71.3259",
              beside(first.max.x, 71.3259, 4, {"the edge is printed to within 0.00005 mm", 2e-6})});
  result.add({"total with passages", "373.4802", beside(total, 373.4802, 4)});
  result.add({"by lengths and angles alone", "373.4802",
              computed(total_by_formulas(kEdge, kRadius, kStep), 373.4802, 4)});
  const double alpha = plan::contour::smallest_angle(triangle);
  result.table.notes.push_back(
      "of the program, read back: clearcut plan triangle.edges --tool endmill:10 --strategy lom --stepover "
      "7.01mm --decimals 6 --result triangle.txt -o triangle.ngc");
  result.table.notes.push_back(fmt::format(
      "7.01 is not 2 R kappa = {:.2f} (eq. 6, the centre would be cut by two contours): it is 0.01 mm above "
      "2 R rho = {:.2f} of the other paper (eq. 8, w = 1 mm); the text does not say so",
      2 * kRadius * plan::contour::kappa(alpha), 2 * kRadius * plan::contour::rho(alpha, kRadius)));
  return result;
}

Reproduction caption_figures() {
  constexpr double kStarSide = 60, kStarTip = 90;
  Reproduction result;
  result.table.title = "Coefficients printed in captions, of planned pockets";
  result.table.columns = {{"figure", Align::kLeft}, {"smallest angle, deg"}, {"printed"}, {"ours"}};
  const auto add = [&](const char* name, const Region& outline, double radius, const char* strategy,
                       double printed) {
    const double share = planned_coefficient(outline, radius, strategy);
    result.add({name, fmt::format("{:.2f}", plan::contour::smallest_angle(outline) * 180 / kPi),
                fmt::format("{:.4f}", printed), beside(cut_to(share, 4), printed, 4)});
    result.figures.push_back(passes_figure(std::string("contours of ") + name, {outline},
                                           contours_of(outline, radius, 2 * radius * share)));
  };
  add("CPO-kappa 9: kappa, star, R = 8 mm", star(6, kStarSide, kStarTip), 8, "lom", 0.8535);
  add("CPO-rho 10: rho, R = 4 mm", inscribed_polygon({}), 4, "rho", 0.5970);
  add("CPO-rho 11: rho, triangle of 100 mm, R = 8 mm", equilateral(100), 8, "rho", 0.7187);
  result.table.notes.push_back(
      "figures 9 and 10 do not print their outlines: tips of 90 and a smallest corner of 30 degrees are what "
      "their coefficients stand for; the sides are ours");
  result.table.notes.push_back("each pocket is planned and certified; the coefficient is the certificate's");
  return result;
}

}  // namespace clearcut::studies
