#include "studies/reproduce/published_comparisons.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
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
#include "studies/reproduce/printed_figures.h"

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

/// The way of a cutter in plan.
struct CutterWay {
  PublishedTime published;
  bool clean = false;

  /// Minutes by eq. 9 at one feed, mm/min.
  double minutes(double feed) const { return published.seconds_at(MmPerMin::of(feed)) / 60; }
};

/// Absent where the cutter does not fit.
std::optional<CutterWay> way_of(const Region& polygon, double radius, const std::string& strategy) {
  const auto planned = planned_outline(pocket_part(polygon, "polygon", 2 * radius), {strategy});
  if (!planned) return std::nullopt;
  return CutterWay{kinematics::published_time(planned->toolpath), planned->findings.all.clean};
}

/// The ways of one cutter by all methods; none where it does not fit.
struct CutterWays {
  PrintedCutter printed;
  CutterWay rho, bisectors, loops, contour;
  /// Circles in place of the segments, as long as table 1 of the other paper has them, with the segments' stops; not planned.
  CutterWay circles;
};

std::vector<CutterWays> ways_of_cutters(const Region& polygon) {
  std::vector<CutterWays> all;
  for (const PrintedCutter& row : kPrintedCutters) {
    const auto rho = way_of(polygon, row.radius, "rho"), fixed = way_of(polygon, row.radius, "fixed"),
               bisectors = way_of(polygon, row.radius, "bisectors"),
               loops = way_of(polygon, row.radius, "loops"), contour = way_of(polygon, row.radius, "contour");
    if (!rho || !fixed || !bisectors || !loops || !contour) continue;
    CutterWay circles = *bisectors;
    const double contours = fixed->published.length_mm;
    circles.published.length_mm = contours + kCircleOverSegment * (circles.published.length_mm - contours);
    all.push_back({row, *rho, *bisectors, *loops, *contour, circles});
  }
  return all;
}

/// The one feed, mm/min, at which the greatest relative residual of all printed times is least.
struct FittedFeed {
  int mm_per_min = 0;
  double rms = 0, greatest = std::numeric_limits<double>::infinity();  ///< share of the printed time
};

FittedFeed residual_at(int feed, const std::vector<CutterWays>& all) {
  FittedFeed fit{feed, 0, 0};
  int times = 0;
  const auto add = [&](const CutterWay& way, double printed) {
    if (printed <= 0) return;
    const double off = std::abs(way.minutes(feed) - printed) / printed;
    ++times;
    fit.rms += off * off;
    fit.greatest = std::max(fit.greatest, off);
  };
  for (const CutterWays& one : all) {
    add(one.rho, one.printed.present);
    add(one.bisectors, one.printed.bisectors);
    add(one.circles, one.printed.loops);
  }
  fit.rms = std::sqrt(fit.rms / times);
  return fit;
}

FittedFeed fitted_feed(const std::vector<CutterWays>& all) {
  constexpr int kFastest = 500;  // mm/min: with it the printed times would be of paths some metres long
  FittedFeed best;
  for (int feed = 1; feed <= kFastest; ++feed) {
    const FittedFeed one = residual_at(feed, all);
    if (one.greatest < best.greatest) best = one;
  }
  return best;
}

/// Contours of a convex outline shorten ever faster with their distance from the wall (lengths of inner parallel bodies are concave).
/// Returns the least minutes of the one contour of a cutter by eq. 9, from those of a smaller one at the same feed, with room for a
/// third between the walls and at most `kMostCorners` corners.
double least_minutes_in_convex(double radius, const PrintedCutter& smaller, double widest) {
  const double stops = published_seconds(0, kMostCorners) / 60;
  return (widest - radius) / (widest - smaller.radius) * (smaller.present - stops);
}

/// That no convex outline has the printed times of the widest cutters by one feed.
std::string limit_of_convex() {
  constexpr const PrintedCutter &one_contour = kPrintedCutters[8], &next = kPrintedCutters[9],
                                &widest = kPrintedCutters[10];
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
      "the printed times follow one feed for all cutters, V_f = {} mm/min as fitted to "
      "all of them: relative residual {:.0f} % "
      "(root of the mean square), at most {:.0f} %",
      fit.mm_per_min, 100 * fit.rms, 100 * fit.greatest);
}

/// Stops that make up for the difference of two printed times of a cutter by eq. 9, at any feed.
double stops_between(double minutes, double others) {
  return std::abs(minutes - others) * 60 / (2 * kPublishedStop);
}

/// Contours at the rivals' step of 0.9 of the diameter that a pocket of the printed width has room for.
int contours_of_rivals(double radius) {
  return 1 + static_cast<int>((kInscribed - radius) / (0.9 * 2 * radius));
}

/// That no one length of a loop over that of its segment has the printed times, whatever the feed. At the rivals' step this ratio
/// depends on the corner's angle alone, not on the cutter.
std::string limit_of_loops() {
  constexpr const PrintedCutter &narrow = kPrintedCutters.front(), &wide = kPrintedCutters[7];
  const double narrow_stops = stops_between(narrow.loops, narrow.bisectors),
               wide_stops = stops_between(wide.loops, wide.bisectors);
  return fmt::format(
      "no one ratio of a loop to its segment has these times, whatever the feed: loops take {:.2f} min less than "
      "segments at R = {} and {:.2f} more at R = {}; were loops the longer ones, segments would have {:.0f} "
      "stops more than loops at R = {}, {:.1f} for each of {} corners of {} contours, and were they the shorter "
      "ones, loops {:.0f} more at R = {}, {:.1f} for each of {} corners of {} contour; a segment has 2",
      narrow.bisectors - narrow.loops, narrow.radius, wide.loops - wide.bisectors, wide.radius, narrow_stops,
      narrow.radius, narrow_stops / (kMostCorners * contours_of_rivals(narrow.radius)), kMostCorners,
      contours_of_rivals(narrow.radius), wide_stops, wide.radius,
      wide_stops / (kMostCorners * contours_of_rivals(wide.radius)), kMostCorners,
      contours_of_rivals(wide.radius));
}

/// "NO" where the certificate finds a fault.
Cell minutes_beside(const CutterWay& way, double feed, double printed) {
  Cell cell = printed > 0 ? beside(way.minutes(feed), printed, 2, kNotPrinted)
                          : Cell(fmt::format("{:.2f}", way.minutes(feed)));
  if (!way.clean) cell.text += " NO";
  return cell;
}

/// "4 5 6": the cutters, mm, for which rho takes less time than a rival.
template <typename Times>
std::string radii_where_rho_wins(const std::vector<CutterWays>& all, const Times& times) {
  std::string radii;
  for (const CutterWays& one : all) {
    if (one.printed.radius >= kSameForAll) break;
    const auto [rho, rival] = times(one);
    if (rho < rival) radii += fmt::format("{}{}", radii.empty() ? "" : " ", one.printed.radius);
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
  const std::vector<CutterWays> all = ways_of_cutters(inscribed_polygon({}));
  const FittedFeed fit = fitted_feed(all);
  Reproduction result;
  TextTable& table = result.table;
  table.title = "CPO-rho table 3: cutting time by eq. 9, min; polygon of inscribed radius 20.46 mm";
  table.columns = {{"R mm"},           {"rho, theirs"}, {"ours"},           {"bisectors, theirs"}, {"ours"},
                   {"loops, theirs"}, {"circles"},     {"shortest loops"}, {"contour (ours)"}};
  for (const CutterWays& one : all) {
    const PrintedCutter& row = one.printed;
    const auto cell = [&](const CutterWay& way, double printed) {
      return minutes_beside(way, fit.mm_per_min, printed);
    };
    result.add({fmt::format("{}", row.radius), fmt::format("{:.2f}", row.present), cell(one.rho, row.present),
                fmt::format("{:.2f}", row.bisectors), cell(one.bisectors, row.bisectors),
                fmt::format("{:.2f}", row.loops), cell(one.circles, row.loops), cell(one.loops, 0),
                cell(one.contour, 0)});
  }
  table.notes.push_back(
      fmt::format("{}; by the printed V_c = {} m/min and one feed a "
                  "tooth V_f would go as 1/R, and the "
                  "times of all cutters be nearly the same",
                  law_of_times(fit), kCuttingSpeed));
  table.notes.push_back(limit_of_convex());
  table.notes.emplace_back(
      "circles: pi / 2 of the length of the segments and as many stops, as lengths finds of the printed loops of "
      "the other paper; shortest loops: those that we plan, no longer than the rests ask for");
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
  const std::vector<CutterWays> all = ways_of_cutters(inscribed_polygon({}));
  const FittedFeed fit = fitted_feed(all);
  Reproduction result;
  result.table.title =
      "CPO-rho table 3, its trend: the cutters (R mm) for which rho is faster than the rivals";
  result.table.columns = {{"V_f mm/min"},
                          {"than bisectors, theirs", Align::kLeft},
                          {"ours", Align::kLeft},
                          {"than loops, theirs", Align::kLeft},
                          {"circles", Align::kLeft},
                          {"shortest loops", Align::kLeft}};
  const auto checked = [](const std::string& ours, const std::string& printed, const char* why) {
    const bool same = ours == printed;
    return beside(ours, printed, same ? Agreement::kAgrees : Agreement::kDiffers, same ? "" : why);
  };
  const std::string bisectors = radii_where_rho_wins(
                        all, [](const auto& one) { return std::pair(one.printed.present, one.printed.bisectors); }),
                    loops = radii_where_rho_wins(
                        all, [](const auto& one) { return std::pair(one.printed.present, one.printed.loops); });
  for (const double share : kTrendFeeds) {
    const double feed = share * fit.mm_per_min;
    const auto wins_over = [&](CutterWay CutterWays::* rival) {
      return radii_where_rho_wins(all, [&](const auto& one) {
        return std::pair(one.rho.minutes(feed), (one.*rival).minutes(feed));
      });
    };
    result.add({fmt::format("{:.0f}", feed), bisectors,
                checked(wins_over(&CutterWays::bisectors), bisectors, "the outline is not printed"), loops,
                checked(wins_over(&CutterWays::circles), loops,
                        "no one ratio of loops to segments has the printed times, see below"),
                wins_over(&CutterWays::loops)});
  }
  result.table.notes.push_back(limit_of_loops());
  result.table.notes.emplace_back(
      "circles: pi / 2 of the length of the segments and as many stops, as lengths finds of the printed loops of "
      "the other paper; shortest loops: those that we plan, no longer than the rests ask for");
  result.table.notes.push_back(law_of_times(fit) + "; the other feeds are half, twice and four times it");
  result.table.notes.push_back("cutters of 10 mm and more take the same time by all three in print");
  return result;
}

}  // namespace clearcut::studies
