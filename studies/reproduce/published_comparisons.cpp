#include "studies/reproduce/published_comparisons.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "geometry/side_list.h"
#include "geometry/voronoi/clearance.h"
#include "kinematics/kinematics.h"
#include "pipeline/compare.h"
#include "pipeline/run.h"
#include "pipeline/tool_sets.h"
#include "studies/reproduce/planned_outline.h"

namespace clearcut::studies {
namespace {

/// CPO-kappa table 1: cutter and step of the rivals.
constexpr double kLengthRadius = 4, kLengthStep = 7.2;
/// CPO-rho section 4. The teeth and feeds per tooth are not printed: these are ours.
constexpr double kCuttingSpeed = 36.6;  // m/min
/// mm: from this radius on the printed times of all methods are equal.
constexpr double kSameForAll = 10;
constexpr int kMostCorners = 10;
/// One feed for all cutters each, as multiples of the one that fits the printed times.
constexpr std::array<double, 4> kTrendFeeds{0.5, 1, 2, 4};
/// Length of a circle over the way along a bisector from contour to contour, half as wide as which it is.
constexpr double kCircleOverSegment = kPi / 2;
/// Degrees of the star's tips.
constexpr double kTip = 32.5;
/// Two printed lengths of each shape, plain contours and kappa's, fix two measures of ours; others are free.
const Explanation kOutline{"the outline is not printed; ours is sized by the contours and kappa's path",
                           0.15};
const Explanation kNotPrinted{
    "outline and feed are not printed; ours stands in, and one feed is fitted to all cutters", 0.4};

/// Twelve sides of 42.2 mm: of the regular six-pointed stars that kappa leaves clean the one whose contours 7.2 mm apart and whose
/// contours by kappa are nearest to theirs, both within 0.5 %.
Region concave_star() {
  return star(42.2, kTip);
}

/// Four corners of 48, 25, 132 and 155 degrees, sized by the same two lengths and by the bisectors of eq. 3.
Region acute_convex() {
  return scaled({{0, 0}, {83.2, 0}, {29.9, 24.6}, {17.3, 19.1}}, 1);
}

std::optional<Figures> figures_of(const Part& part, const OutlineMethod& method) {
  const auto planned = planned_outline(part, method);
  return planned ? std::optional(planned->findings.all) : std::nullopt;
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
  const Part part = pocket_part(region, shape, 2 * kLengthRadius);
  const std::string step = fmt::format("{}mm", kLengthStep);
  const auto fixed = figures_of(part, {.strategy = "fixed", .stepover = step, .as_printed = true});
  const auto text = [](double value) { return fmt::format("{:.2f}", value); };
  double segments = 0;
  for (const auto& row : rows) {
    const std::string strategy = row.strategy;
    const bool adds = strategy == "bisectors" || strategy == "loops" || strategy == "single";
    const auto figures = figures_of(part, {strategy, adds ? std::optional(step) : std::nullopt});
    if (!figures || !fixed) continue;
    const double total = length_in_plan(*figures), contours = adds ? length_in_plan(*fixed) : total;
    if (strategy == "bisectors") segments = total - contours;
    const bool printed = row.contours > 0;
    const auto ours = [&](double value, double theirs) {
      return printed ? beside(value, theirs, 2, kOutline) : Cell(text(value));
    };
    result.add({shape, row.method, printed ? text(row.contours) : "", ours(contours, row.contours),
                printed ? text(row.added) : "", ours(total - contours, row.added),
                printed ? text(row.contours + row.added) : "", ours(total, row.contours + row.added),
                figures->clean ? "yes" : "NO"});
  }
  if (fixed) {
    const double contours = length_in_plan(*fixed), circles = kCircleOverSegment * segments;
    result.add({shape, "circles on segments", "", text(contours), "", text(circles), "",
                text(contours + circles), "gouges"});
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

/// The way of a cutter in plan; absent where it does not fit.
struct CutterWay {
  PublishedTime published;
  bool clean = false;

  /// Minutes by eq. 9 at one feed, mm/min.
  double minutes(double feed) const { return published.seconds_at(MmPerMin::of(feed)) / 60; }
};

std::optional<CutterWay> way_of(const Region& polygon, double radius, const std::string& strategy) {
  const auto planned = planned_outline(pocket_part(polygon, "polygon", 2 * radius), {strategy});
  if (!planned) return std::nullopt;
  return CutterWay{kinematics::published_time(planned->toolpath), planned->findings.all.clean};
}

/// The one feed, mm/min, at which the printed times of rho come out with the least relative squares, and what then stays.
struct FittedFeed {
  double mm_per_min = 0;
  double rms = 0, greatest = 0;  ///< share of the printed time
};

FittedFeed fitted_feed(const Region& polygon) {
  double across = 0, squares = 0;
  std::vector<std::pair<double, CutterWay>> rows;
  for (const CutterRow& row : kCutters) {
    const auto way = row.present > 0 ? way_of(polygon, row.radius, "rho") : std::nullopt;
    if (!way) continue;
    rows.emplace_back(row.present, *way);
    const double stops = published_seconds(0, way->published.discontinuities) / 60;
    const double share = way->published.length_mm / row.present;
    across += share * (row.present - stops) / row.present;
    squares += share * share;
  }
  FittedFeed fit{squares / across};
  for (const auto& [printed, way] : rows) {
    const double off = std::abs(way.minutes(fit.mm_per_min) - printed) / printed;
    fit.rms += off * off / static_cast<double>(rows.size());
    fit.greatest = std::max(fit.greatest, off);
  }
  fit.rms = std::sqrt(fit.rms);
  return fit;
}

/// Contours of a convex outline shorten ever faster with their distance from the wall (lengths of inner parallel bodies are concave).
/// Returns the least minutes of the one contour of a cutter by eq. 9, from those of a smaller one at the same feed, with room for a
/// third between the walls and at most `kMostCorners` corners.
double least_minutes_in_convex(double radius, const CutterRow& smaller, double widest) {
  const double stops = published_seconds(0, kMostCorners) / 60;
  return (widest - radius) / (widest - smaller.radius) * (smaller.present - stops);
}

/// That no convex outline has the printed times of the widest cutters by one feed.
std::string limit_of_convex() {
  constexpr const CutterRow &one_contour = kCutters[8], &next = kCutters[9], &widest = kCutters[10];
  return fmt::format(
      "no convex outline has these times by one feed: contours shorten ever faster inwards, so that one with "
      "room for {} mm, {:.2f} min at R = {} and up to {} corners takes at least {:.2f} min at R = {}, where "
      "{:.2f} is printed",
      widest.radius, one_contour.present, one_contour.radius, kMostCorners,
      least_minutes_in_convex(next.radius, one_contour, widest.radius), next.radius, next.present);
}

/// What the printed times of table 3 follow, and how well.
std::string law_of_times(const FittedFeed& fit) {
  return fmt::format(
      "the printed times follow one feed for all cutters, V_f = {:.0f} mm/min as fitted to "
      "rho's: relative residual {:.0f} % "
      "(root of the mean square), at most {:.0f} %",
      fit.mm_per_min, 100 * fit.rms, 100 * fit.greatest);
}

/// "NO" where the certificate finds a fault.
Cell minutes_beside(const std::optional<CutterWay>& way, double feed, double printed) {
  if (!way)
    return beside("does not fit", fmt::format("{:.2f}", printed), Agreement::kDiffers, kNotPrinted.reason);
  Cell cell = beside(way->minutes(feed), printed, 2, kNotPrinted);
  if (!way->clean) cell.text += " NO";
  return cell;
}

/// "4, 5, 6" : the cutters, mm, of table 3 for which rho takes less time than the rival at one feed, mm/min.
std::string radii_where_rho_wins(const Region& polygon, const std::string& rival, double feed) {
  std::string radii;
  for (const auto& row : kCutters) {
    if (row.radius >= kSameForAll) break;
    const auto own = way_of(polygon, row.radius, "rho"), other = way_of(polygon, row.radius, rival);
    if (own && other && own->minutes(feed) < other->minutes(feed))
      radii += fmt::format("{}{}", radii.empty() ? "" : " ", row.radius);
  }
  return radii.empty() ? "none" : radii;
}

}  // namespace

Reproduction length_comparison() {
  Reproduction result;
  TextTable& table = result.table;
  table.title = "CPO-kappa table 1: path lengths, mm; R = 4 mm, rivals at a step of 7.2 mm";
  table.columns = {{"shape", Align::kLeft}, {"method", Align::kLeft},
                   {"contours, theirs"},    {"ours"},
                   {"added, theirs"},       {"ours"},
                   {"total, theirs"},       {"ours"},
                   {"clean", Align::kLeft}};
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
      "their outlines are not printed, the shapes are ours: a six-pointed star and an acute quadrilateral, "
      "sized by the "
      "printed contours and kappa's path; what can be compared is the order, and kappa's path is shorter "
      "than both rivals "
      "on both shapes");
  const double acute = base::sin(Radians::of_degrees(kTip).radians() / 2);
  table.notes.push_back(
      fmt::format("circles on segments: pi / 2 of the printed 244 mm of segments, one way as eq. 3 of "
                  "CPO-rho has them, are {:.1f} mm, "
                  "where 382 are printed: a circle half as wide as the way along the bisector from contour "
                  "to contour. From sin(alpha / 2) = "
                  "1 / 3 on, 39 degrees, it stays within the outer contour, at the star's {:g} degrees it "
                  "runs {:.1f} mm over it; of "
                  "the 67 mm of the convex shape it makes {:.1f} mm, and 58 are printed, so many if loops "
                  "stand at corners with {:.0f} % "
                  "of the segments' length",
                  kCircleOverSegment * 244, kTip, kLengthStep * (0.25 / acute - 0.75),
                  kCircleOverSegment * 67, 100 * 58 / (kCircleOverSegment * 67)));
  table.notes.push_back("lengths of linked programs in plan, with passages; clean: by the certificate");
  return result;
}

Reproduction cutter_comparison() {
  const Region polygon = inscribed_polygon({});
  const FittedFeed fit = fitted_feed(polygon);
  Reproduction result;
  TextTable& table = result.table;
  table.title = "CPO-rho table 3: cutting time by eq. 9, min; polygon of inscribed radius 20.46 mm";
  table.columns = {{"R mm"}, {"rho, theirs"},   {"ours"}, {"bisectors, theirs"},
                   {"ours"}, {"loops, theirs"}, {"ours"}, {"contour (ours)"}};
  for (const auto& row : kCutters) {
    const auto beside_print = [&](const char* strategy, double printed) {
      const auto way = way_of(polygon, row.radius, strategy);
      return printed > 0 ? minutes_beside(way, fit.mm_per_min, printed)
                         : Cell(way ? fmt::format("{:.2f}", way->minutes(fit.mm_per_min)) : "does not fit");
    };
    result.add({fmt::format("{}", row.radius), fmt::format("{:.2f}", row.present),
                beside_print("rho", row.present), fmt::format("{:.2f}", row.bisectors),
                beside_print("bisectors", row.bisectors), fmt::format("{:.2f}", row.loops),
                beside_print("loops", row.loops), beside_print("contour", 0)});
  }
  table.notes.push_back(
      fmt::format("{}; by the printed V_c = {} m/min and one feed a "
                  "tooth V_f would go as 1/R, and the "
                  "times of all cutters be nearly the same",
                  law_of_times(fit), kCuttingSpeed));
  table.notes.push_back(limit_of_convex());
  table.notes.emplace_back(
      "their outline is not printed, the polygon is ours with their smallest angle, 30 degrees; the cutter "
      "as wide as the polygon "
      "moves nowhere");
  table.notes.emplace_back(
      "contour takes the least time with acceleration and cornering, not by eq. 9, which counts every turn "
      "as a stop");
  table.notes.emplace_back("NO: the certificate finds something left (the papers had no certificate)");
  return result;
}

Reproduction cutter_trend() {
  const Region polygon = inscribed_polygon({});
  const FittedFeed fit = fitted_feed(polygon);
  Reproduction result;
  result.table.title =
      "CPO-rho table 3, its trend: the cutters (R mm) for which rho is faster than the rivals";
  result.table.columns = {{"V_f mm/min"},
                          {"than bisectors, theirs", Align::kLeft},
                          {"ours", Align::kLeft},
                          {"than loops, theirs", Align::kLeft},
                          {"ours", Align::kLeft}};
  const auto checked = [](const std::string& ours, const std::string& printed, const char* why) {
    const bool same = ours == printed;
    return beside(ours, printed, same ? Agreement::kAgrees : Agreement::kDiffers, same ? "" : why);
  };
  const std::string bisectors = "4 5 6 7 8 9", loops = "6 7 8 9";
  std::string reproduced;  // feeds at which the whole trend comes out
  for (const double share : kTrendFeeds) {
    const double feed = share * fit.mm_per_min;
    const std::string over_bisectors = radii_where_rho_wins(polygon, "bisectors", feed);
    const std::string over_loops = radii_where_rho_wins(polygon, "loops", feed);
    result.add({fmt::format("{:.0f}", feed), bisectors,
                checked(over_bisectors, bisectors, "the outline is not printed"), loops,
                checked(over_loops, loops,
                        "our loops are no longer than the rests ask for: they beat rho at every feed")});
    if (over_bisectors == bisectors && over_loops == loops)
      reproduced += fmt::format("{}{:.0f}", reproduced.empty() ? "" : ", ", feed);
  }
  result.table.notes.push_back(reproduced.empty()
                                   ? "the printed trend comes out whole at none of these feeds"
                                   : "the printed trend comes out whole at " + reproduced + " mm/min");
  result.table.notes.push_back(law_of_times(fit) + "; the other feeds are half, twice and four times it");
  result.table.notes.push_back("cutters of 10 mm and more take the same time by all three in print");
  return result;
}

}  // namespace clearcut::studies
