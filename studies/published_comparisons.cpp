#include "studies/published_comparisons.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/units.h"
#include "geometry/clearance.h"
#include "geometry/side_list.h"
#include "pipeline/run.h"
#include "pipeline/selection/compare.h"
#include "pipeline/selection/tool_sets.h"

namespace clearcut::studies {
namespace {

/// CPO-kappa table 1: cutter and step of the rivals.
constexpr double kLengthRadius = 4, kLengthStep = 7.2;
/// CPO-rho section 4. The teeth and feeds per tooth are not printed: these are ours.
constexpr double kCuttingSpeed = 36.6, kFeedPerTooth = 0.02;
constexpr int kTeeth = 2;
constexpr double kInscribed = 20.46;

double radians(double degrees) {
  return Radians::of_degrees(degrees).radians();
}

Region region_of(const SideList& list) {
  return Region::from_valid_loops(closed_by_compass_rule(traced(list)), {});
}

/// A star of six points: twelve sides of 28.6 mm, so that contours 7.2 mm apart are about as long as theirs.
Region concave_star() {
  SideList list;
  for (int i = 0; i < 6; ++i) {
    list.sides.push_back({28.6, radians(240), 0});
    list.sides.push_back({28.6, radians(60), 0});
  }
  return region_of(list);
}

Region scaled(const std::vector<Vec2>& corners, double factor) {
  std::vector<Vec2> points;
  for (const Vec2 corner : corners) points.push_back(corner * factor);
  return Region::from_valid_loops(loop_from_points(points), {});
}

/// Four corners of 41, 68, 111 and 140 degrees, sized like the star.
Region acute_convex() {
  return scaled({{0, 0}, {60, 0}, {43, 29}, {24, 21}}, 1.113);
}

/// Five corners, the sharpest of 52 degrees, scaled to the inscribed radius of the paper.
Region inscribed_polygon(const Tolerances& tol) {
  const std::vector<Vec2> corners{{0, 0}, {95, 0}, {78, 40}, {50, 58}, {32, 41}};
  return scaled(corners, kInscribed / Clearance(scaled(corners, 1), tol).max());
}

Part part_of(const Region& region, const std::string& name, const Tool& tool) {
  Part part;
  part.name = name;
  part.tools = {tool};
  Feature feature;
  feature.name = name;
  feature.target = feature.allowed = {region};
  feature.floor_z = -1;
  part.features = {feature};
  Workingstep step;
  step.operation.stepdown = 1;
  step.operation.entry = EntryKind::kPlunge;
  part.workplan = {step};
  return part;
}

std::optional<Figures> figures_of(const Part& part, const std::string& strategy,
                                  const std::optional<std::string>& stepover = {},
                                  const CuttingData& cutting = {}) {
  resolve::PlanOptions options;
  options.cutting = cutting;
  options.strategy = strategy;
  options.stepover = stepover;
  try {
    return pipeline::plan_part(part, options).findings.all;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

double length_in_plan(const Figures& figures) {
  return figures.feed_mm - figures.plunge_mm;
}

/// A row of the printed table; a method of ours has no printed figures.
struct LengthRow {
  const char* method;
  const char* strategy;
  double contours = 0;
  double added = 0;
};

void add_lengths(report::TextTable& table, const char* shape, const Region& region,
                 const std::vector<LengthRow>& rows) {
  Tool tool;
  tool.diameter = 2 * kLengthRadius;
  const Part part = part_of(region, shape, tool);
  const std::string step = fmt::format("{}mm", kLengthStep);
  const auto fixed = figures_of(part, "fixed", step);
  const auto text = [](double value) { return fmt::format("{:.2f}", value); };
  for (const auto& row : rows) {
    const std::string strategy = row.strategy;
    const bool adds = strategy == "bisectors" || strategy == "loops" || strategy == "single";
    const auto figures = figures_of(part, strategy, adds ? std::optional(step) : std::nullopt);
    if (!figures || !fixed) continue;
    const double total = length_in_plan(*figures), contours = adds ? length_in_plan(*fixed) : total;
    const bool printed = row.contours > 0;
    table.add({shape, row.method, printed ? text(row.contours) : "", text(contours),
               printed ? text(row.added) : "", text(total - contours),
               printed ? text(row.contours + row.added) : "", text(total), figures->clean ? "yes" : "NO"});
  }
  table.add_rule();
}

struct CutterRow {
  double radius;
  double present, bisectors, loops;  ///< min, printed
};

constexpr CutterRow kCutters[] = {{2, 19.51, 17.23, 15.46}, {3, 15.15, 14.97, 13.25}, {4, 8.49, 9.30, 8.21},
                                  {5, 5.34, 6.17, 5.51},    {6, 4.16, 4.42, 4.69},    {7, 3.29, 3.83, 4.37},
                                  {8, 2.70, 3.74, 4.61},    {9, 2.14, 3.49, 4.76},    {10, 2.03, 2.03, 2.03},
                                  {13, 1.14, 1.14, 1.14},   {20.46, 0, 0, 0}};

/// Minutes by eq. 9, of the way in plan; "NO" where the certificate finds a fault.
std::string minutes(const Part& part, const std::string& strategy) {
  const CuttingData cutting = pipeline::driven(part.tools.front(), kCuttingSpeed, kFeedPerTooth);
  const auto figures = figures_of(part, strategy, std::nullopt, cutting);
  if (!figures) return "does not fit";
  const double feed = length_in_plan(*figures) / std::max(figures->feed_mm, 1e-9) * figures->time_naive_s;
  return fmt::format("{:.2f}{}", pipeline::published_time(feed, figures->turns) / 60,
                     figures->clean ? "" : " NO");
}

}  // namespace

report::TextTable length_comparison() {
  report::TextTable table;
  table.title = "CPO-kappa table 1: path lengths, mm; R = 4 mm, rivals at a step of 7.2 mm";
  table.columns = {{"shape", report::Align::kLeft},
                   {"method", report::Align::kLeft},
                   {"contours, theirs"},
                   {"ours"},
                   {"added, theirs"},
                   {"ours"},
                   {"total, theirs"},
                   {"ours"},
                   {"clean", report::Align::kLeft}};
  add_lengths(table, "concave", concave_star(),
              {{"proposed (lom)", "lom", 747.30, 0},
               {"bisector segments", "bisectors", 584.84, 244},
               {"loops", "loops", 584.84, 382},
               {"tangent loops", "single"},
               {"lom corrected", "lom-corrected"},
               {"contour (ours)", "contour"}});
  add_lengths(table, "convex", acute_convex(),
              {{"proposed (lom)", "lom", 194.26, 0},
               {"bisector segments", "bisectors", 165.79, 67},
               {"loops", "loops", 165.79, 58},
               {"tangent loops", "single"},
               {"lom corrected", "lom-corrected"},
               {"contour (ours)", "contour"}});
  table.notes.push_back(
      "their outlines are not printed, the shapes are ours (a six-pointed star, an acute quadrilateral) and "
      "sized alike: "
      "figures differ for that, what can be compared is the order");
  table.notes.push_back("lengths of linked programs in plan, with passages; clean: by the certificate");
  return table;
}

report::TextTable cutter_comparison() {
  const Tolerances tol;
  const Region polygon = inscribed_polygon(tol);
  report::TextTable table;
  table.title = "CPO-rho table 3: cutting time by eq. 9, min; polygon of inscribed radius 20.46 mm";
  table.columns = {{"R mm"}, {"rho, theirs"},   {"ours"}, {"bisectors, theirs"},
                   {"ours"}, {"loops, theirs"}, {"ours"}, {"contour (ours)"}};
  for (const auto& row : kCutters) {
    Tool tool;
    tool.diameter = 2 * row.radius;
    tool.teeth = kTeeth;
    const Part part = part_of(polygon, "polygon", tool);
    table.add({fmt::format("{}", row.radius), fmt::format("{:.2f}", row.present), minutes(part, "rho"),
               fmt::format("{:.2f}", row.bisectors), minutes(part, "bisectors"),
               fmt::format("{:.2f}", row.loops), minutes(part, "loops"), minutes(part, "contour")});
  }
  table.notes.push_back(
      fmt::format("their outline is not printed, the polygon is ours; V_c = {} m/min is printed, Z = {} and "
                  "f_z = {} mm are ours: figures "
                  "differ for that",
                  kCuttingSpeed, kTeeth, kFeedPerTooth));
  table.notes.push_back(
      "contour takes the least time with acceleration and cornering, not by eq. 9, which counts every turn "
      "as a stop");
  table.notes.push_back("NO: the certificate finds something left (the papers had no certificate)");
  return table;
}

}  // namespace clearcut::studies
