#include "studies/reproduce/published_comparisons.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/elementary.h"
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
/// mm: from this radius on the printed times of all methods are equal.
constexpr double kSameForAll = 10;
constexpr std::array<double, 4> kTrendFeeds{0.02, 0.05, 0.1, 0.2};  // mm a tooth
constexpr const char* kOutline = "the outline is not printed; ours stands in";

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

/// Five corners, the sharpest of 30 degrees as the paper's (figure 10 prints its rho), scaled to the inscribed radius
/// of the paper.
Region inscribed_polygon(const Tolerances& tol) {
  const std::vector<Vec2> corners{{0, 0}, {120, 0}, {95, 40}, {72, 72 * base::tan(kPi / 6)}};
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

void add_lengths(Reproduction& result, const char* shape, const Region& region,
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
    const auto ours = [&](double value, double theirs) {
      return printed ? beside(value, theirs, 2, kOutline) : Cell(text(value));
    };
    result.add({shape, row.method, printed ? text(row.contours) : "", ours(contours, row.contours),
                printed ? text(row.added) : "", ours(total - contours, row.added),
                printed ? text(row.contours + row.added) : "", ours(total, row.contours + row.added),
                figures->clean ? "yes" : "NO"});
  }
  result.add_rule();
}

struct CutterRow {
  double radius;
  double present, bisectors, loops;  ///< min, printed
};

constexpr CutterRow kCutters[] = {{2, 19.51, 17.23, 15.46}, {3, 15.15, 14.97, 13.25}, {4, 8.49, 9.30, 8.21},
                                  {5, 5.34, 6.17, 5.51},    {6, 4.16, 4.42, 4.69},    {7, 3.29, 3.83, 4.37},
                                  {8, 2.70, 3.74, 4.61},    {9, 2.14, 3.49, 4.76},    {10, 2.03, 2.03, 2.03},
                                  {13, 1.14, 1.14, 1.14},   {20.46, 0, 0, 0}};

/// Minutes by eq. 9, of the way in plan; absent where the cutter does not fit.
struct Minutes {
  double value = 0;
  bool clean = false;
};

std::optional<Minutes> minutes(const Part& part, const std::string& strategy, double feed_per_tooth) {
  const CuttingData cutting = pipeline::driven(part.tools.front(), kCuttingSpeed, feed_per_tooth);
  const auto figures = figures_of(part, strategy, std::nullopt, cutting);
  if (!figures) return std::nullopt;
  const double feed = length_in_plan(*figures) / std::max(figures->feed_mm, 1e-9) * figures->time_naive_s;
  return Minutes{pipeline::published_time(feed, figures->turns) / 60, figures->clean};
}

/// "NO" where the certificate finds a fault.
Cell minutes_beside(const Part& part, const std::string& strategy, double printed) {
  const auto ours = minutes(part, strategy, kFeedPerTooth);
  if (!ours) return beside("does not fit", fmt::format("{:.2f}", printed), Agreement::kExplained, kOutline);
  Cell cell = beside(ours->value, printed, 2, kOutline);
  if (!ours->clean) cell.text += " NO";
  return cell;
}

Part polygon_part(const Region& polygon, double radius) {
  Tool tool;
  tool.diameter = 2 * radius;
  tool.teeth = kTeeth;
  return part_of(polygon, "polygon", tool);
}

/// "4, 5, 6" : the cutters, mm, of table 3 for which rho takes less time than the rival.
std::string radii_where_rho_wins(const Region& polygon, const std::string& rival, double feed_per_tooth) {
  std::string radii;
  for (const auto& row : kCutters) {
    if (row.radius >= kSameForAll) break;
    const Part part = polygon_part(polygon, row.radius);
    const auto own = minutes(part, "rho", feed_per_tooth), other = minutes(part, rival, feed_per_tooth);
    if (own && other && own->value < other->value)
      radii += fmt::format("{}{}", radii.empty() ? "" : " ", row.radius);
  }
  return radii.empty() ? "none" : radii;
}

}  // namespace

Reproduction length_comparison() {
  Reproduction result;
  report::TextTable& table = result.table;
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
  add_lengths(result, "concave", concave_star(),
              {{"proposed (lom)", "lom", 747.30, 0},
               {"bisector segments", "bisectors", 584.84, 244},
               {"loops", "loops", 584.84, 382},
               {"tangent loops", "single"},
               {"lom corrected", "lom-corrected"},
               {"contour (ours)", "contour"}});
  add_lengths(result, "convex", acute_convex(),
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
  return result;
}

Reproduction cutter_comparison() {
  const Region polygon = inscribed_polygon({});
  Reproduction result;
  report::TextTable& table = result.table;
  table.title = "CPO-rho table 3: cutting time by eq. 9, min; polygon of inscribed radius 20.46 mm";
  table.columns = {{"R mm"}, {"rho, theirs"},   {"ours"}, {"bisectors, theirs"},
                   {"ours"}, {"loops, theirs"}, {"ours"}, {"contour (ours)"}};
  for (const auto& row : kCutters) {
    const Part part = polygon_part(polygon, row.radius);
    const auto contour = minutes(part, "contour", kFeedPerTooth);
    result.add({fmt::format("{}", row.radius), fmt::format("{:.2f}", row.present),
                minutes_beside(part, "rho", row.present), fmt::format("{:.2f}", row.bisectors),
                minutes_beside(part, "bisectors", row.bisectors), fmt::format("{:.2f}", row.loops),
                minutes_beside(part, "loops", row.loops),
                contour ? fmt::format("{:.2f}", contour->value) : "does not fit"});
  }
  table.notes.push_back(
      fmt::format("their outline is not printed, the polygon is ours with their smallest angle, 30 degrees; "
                  "V_c = {} m/min is printed, Z = {} and f_z = {} mm are ours: figures differ for that",
                  kCuttingSpeed, kTeeth, kFeedPerTooth));
  table.notes.push_back(
      "contour takes the least time with acceleration and cornering, not by eq. 9, which counts every turn "
      "as a stop");
  table.notes.push_back("NO: the certificate finds something left (the papers had no certificate)");
  return result;
}

Reproduction cutter_trend() {
  const Region polygon = inscribed_polygon({});
  Reproduction result;
  result.table.title =
      "CPO-rho table 3, its trend: the cutters (R mm) for which rho is faster than the rivals";
  result.table.columns = {{"f_z mm"},
                          {"than bisectors, theirs", report::Align::kLeft},
                          {"ours", report::Align::kLeft},
                          {"than loops, theirs", report::Align::kLeft},
                          {"ours", report::Align::kLeft}};
  const auto checked = [](const std::string& ours, const std::string& printed, const char* why) {
    const bool same = ours == printed;
    return beside(ours, printed, same ? Agreement::kAgrees : Agreement::kExplained, same ? "" : why);
  };
  const std::string bisectors = "4 5 6 7 8 9", loops = "6 7 8 9";
  std::string reproduced;  // feeds at which the whole trend comes out
  for (const double feed_per_tooth : kTrendFeeds) {
    const std::string over_bisectors = radii_where_rho_wins(polygon, "bisectors", feed_per_tooth);
    const std::string over_loops = radii_where_rho_wins(polygon, "loops", feed_per_tooth);
    result.add({fmt::format("{:g}", feed_per_tooth), bisectors,
                checked(over_bisectors, bisectors, "the outline and the feed are not printed"), loops,
                checked(over_loops, loops,
                        "our loops are no longer than the rests ask for: they beat rho at every feed")});
    if (over_bisectors == bisectors && over_loops == loops)
      reproduced += fmt::format("{}{:g}", reproduced.empty() ? "" : ", ", feed_per_tooth);
  }
  result.table.notes.push_back(reproduced.empty()
                                   ? "the printed trend comes out whole at none of these feeds"
                                   : "the printed trend comes out whole at " + reproduced + " mm a tooth");
  result.table.notes.push_back("cutters of 10 mm and more take the same time by all three in print");
  return result;
}

}  // namespace clearcut::studies
