#include "studies/reproduce.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <functional>

#include "base/error.h"
#include "base/units.h"
#include "geometry/clearance.h"
#include "model/layer.h"
#include "model/pass.h"
#include "plan/contour/contour.h"
#include "plan/contour/side_offsets.h"
#include "studies/published_comparisons.h"
#include "studies/reproduce_objectives.h"
#include "studies/reproduce_orders.h"
#include "studies/reproduce_scallop.h"
#include "studies/reproduce_tour.h"

namespace clearcut::studies {
namespace {

constexpr std::array<int, 9> kAngles{10, 30, 50, 70, 90, 110, 130, 150, 170};
using Printed = std::array<double, 9>;

/// The papers cut figures to the printed digits instead of rounding them.
double cut_to(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::floor(value * scale + 1e-9) / scale;
}

double radians(int degrees) {
  return Radians::of_degrees(degrees).radians();
}

std::string marked(double ours, double printed, int decimals) {
  const bool same = std::abs(ours - printed) < 0.5 * std::pow(10.0, -decimals);
  return fmt::format("{:.{}f}{}", ours, decimals, same ? "" : " (differs)");
}

report::TextTable angle_table(const std::string& title) {
  report::TextTable table;
  table.title = title;
  table.columns = {{"row", report::Align::kLeft}};
  for (const int angle : kAngles) table.columns.push_back({fmt::format("{} deg", angle)});
  return table;
}

void add_rows(report::TextTable& table, const std::string& name, const Printed& printed, int decimals,
              const std::function<double(double)>& ours) {
  std::vector<std::string> first{name + ", printed"}, second{name + ", ours"};
  for (std::size_t i = 0; i < kAngles.size(); ++i) {
    first.push_back(fmt::format("{:.{}f}", printed[i], decimals));
    second.push_back(marked(cut_to(ours(radians(kAngles[i])), decimals), printed[i], decimals));
  }
  table.add(first);
  table.add(second);
}

/// CPO-rho table 2.
report::TextTable coefficients() {
  report::TextTable table = angle_table("CPO-rho table 2: recovery coefficients");
  add_rows(table, "LOM", {.543, .629, .711, .786, .853, .909, .953, .982, .998}, 3, plan::contour::kappa);
  const std::pair<double, Printed> rows[] = {{5, {.534, .603, .669, .729, .782, .827, .862, .886, .898}},
                                             {10, {.539, .616, .690, .758, .818, .868, .907, .934, .948}},
                                             {20, {.541, .622, .700, .772, .835, .889, .930, .958, .973}},
                                             {50, {.542, .626, .707, .781, .846, .901, .944, .973, .988}}};
  for (const auto& [radius, printed] : rows) {
    add_rows(table, fmt::format("rho, R = {} mm", radius), printed, 3,
             [r = radius](double alpha) { return plan::contour::rho(alpha, r); });
  }
  table.notes.push_back("printed figures are cut, not rounded; ours are cut alike");
  return table;
}

struct OverlapRow {
  double radius;
  Printed printed;
};

/// CPO-rho table 1, as printed: six radii by nine angles.
constexpr std::array<OverlapRow, 6> kOverlaps{{{5, {.09, .26, .42, .57, .71, .82, .91, .96, 1.00}},
                                               {10, {.08, .26, .42, .56, .70, .82, .92, .96, 1.00}},
                                               {20, {.08, .28, .44, .56, .72, .80, .92, .96, 1.00}},
                                               {30, {.06, .24, .42, .54, .72, .84, .90, .96, 1.02}},
                                               {40, {.08, .24, .40, .56, .72, .80, .96, .96, 1.04}},
                                               {50, {.10, .30, .40, .50, .70, .80, .90, .90, 1.00}}}};

/// CPO-rho table 1: the overlap 2 R (kappa - rho), mm. The printed figures come from coefficients that were cut to three
/// digits, ours alike; without that cut the overlap is w sin(alpha / 2) for every R.
report::TextTable overlaps() {
  report::TextTable table = angle_table("CPO-rho table 1: overlap in the corner, mm");
  for (const OverlapRow& row : kOverlaps) {
    add_rows(table, fmt::format("R = {} mm", row.radius), row.printed, 2, [r = row.radius](double alpha) {
      return 2 * r * (cut_to(plan::contour::kappa(alpha), 3) - cut_to(plan::contour::rho(alpha, r), 3));
    });
  }
  std::vector<std::string> exact{"w sin(alpha/2)"};
  for (const int angle : kAngles) exact.push_back(fmt::format("{:.2f}", std::sin(radians(angle) / 2)));
  table.add_rule();
  table.add(exact);
  table.notes.push_back(
      "the figures come from coefficients cut to three digits; without the cut every R gives the last row");
  return table;
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

/// CPO-kappa figure 10.
report::TextTable triangle() {
  constexpr double kStep = 7.01, kRadius = 5;
  Layer layer;
  layer.z = -1;
  layer.tool_radius = kRadius;
  layer.allowed = layer.target = {equilateral(79.9861)};
  plan::contour::ContourOptions options;
  options.step = {plan::contour::StepRule::Kind::kMm, kStep};
  options.residuals = plan::contour::ResidualRule::kNone;
  report::TextTable table;
  table.title = "CPO-kappa figure 10: equilateral triangle, edge 79.9861 mm, R = 5 mm, step 7.01 mm";
  table.columns = {{"contour", report::Align::kLeft}, {"offset, printed"}, {"ours"}, {"length, ours"}};
  double total = 0;
  int contours = 0;
  Box first;
  for (const auto& pass : plan::contour::plan_contour(layer, options, {}).passes) {
    if (!pass.closed) continue;
    if (contours == 0) first = box(pass.path);
    const double printed = kRadius + contours * kStep;
    table.add({std::to_string(++contours), fmt::format("{:.2f}", printed), marked(pass.offset, printed, 2),
               fmt::format("{:.4f}", length(pass.path))});
    total += length(pass.path);
  }
  total += (contours - 1) * plan::contour::passage_length(kStep, kPi / 3);
  table.add({"first contour from x", "8.6603", marked(first.min.x, 8.6603, 4), ""});
  table.add({"first contour to x", "71.3259", marked(first.max.x, 71.3259, 3), ""});
  table.notes.push_back(
      "the edge is printed to within 0.00005 mm; the end of the first contour agrees within that");
  table.add({"total with passages", "373.4802", marked(total, 373.4802, 4), ""});
  table.add({"by lengths and angles alone", "373.4802",
             marked(total_by_formulas(79.9861, kRadius, kStep), 373.4802, 4), ""});
  return table;
}

/// CPO-rho figure 11.
report::TextTable rho_triangle() {
  report::TextTable table;
  table.title = "CPO-rho figure 11: equilateral triangle, edge 100 mm, R = 8 mm";
  table.columns = {{"coefficient", report::Align::kLeft}, {"printed"}, {"ours"}};
  table.add(
      {"rho", "0.7187",
       marked(cut_to(plan::contour::rho(plan::contour::smallest_angle(equilateral(100)), 8), 4), 0.7187, 4)});
  return table;
}

struct Entry {
  std::string name;
  report::TextTable (*make)();
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{{"coefficients", coefficients}, {"overlaps", overlaps},
                                      {"triangle", triangle},         {"rho-triangle", rho_triangle},
                                      {"lengths", length_comparison}, {"cutters", cutter_comparison},
                                      {"genetic", genetic_figures},   {"lattices", lattice_table},
                                      {"fishhead", fishhead_table},   {"objectives", objectives_table},
                                      {"scallop", scallop_table},     {"tour-engagement", engagement_table}};
  return all;
}

}  // namespace

const std::vector<std::string>& reproducible_tables() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& entry : entries()) all.push_back(entry.name);
    return all;
  }();
  return names;
}

report::TextTable reproduce(const std::string& name) {
  for (const auto& entry : entries()) {
    if (entry.name == name) return entry.make();
  }
  throw InputError("reproduce", fmt::format("'{}' is unknown; use one of {}", name,
                                            fmt::join(reproducible_tables(), ", ")));
}

}  // namespace clearcut::studies
