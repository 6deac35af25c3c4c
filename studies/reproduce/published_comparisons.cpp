#include "studies/reproduce/published_comparisons.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
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
/// The concave shape: a star with so many tips of so many degrees.
constexpr int kTips = 4;
constexpr double kTip = 26.9;
const Explanation kOutline{"the outline is not printed; ours is sized by the printed lengths", 0.05};
const Explanation kNotPrinted{
    "outline and feed are not printed; ours stands in, and one feed is fitted to all cutters", 0.4};

/// Eight sides, and four corners of 68, 88, 65 and 139 degrees: outlines that kappa leaves clean and on which all four printed lengths
/// come out together, each within the stated share, by the one rule for loops.
Region concave_star() {
  return star(kTips, 60.6, kTip);
}

Region acute_convex() {
  return scaled({{0, 0}, {34.8, -15.5}, {51.7, 25.9}, {25.2, 24.4}}, 1);
}

double length_in_plan(const Figures& figures) {
  return figures.feed_mm - figures.plunge_mm;
}

/// Loops as the printed lengths allow them: a circle half as wide as the way along the bisector from contour to contour, once for each
/// contour but the first in each corner of the outline in which the step leaves material.
double length_of_circles(const Region& outline, std::size_t contours) {
  double ways = 0;
  const std::vector<Edge> edges = outline.edges();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vec2 in = edges[i].tangent_at(1), out = edges[(i + 1) % edges.size()].tangent_at(0);
    const double half = (kPi - base::atan2(cross(in, out), dot(in, out))) / 2;
    if (half < kPi / 2 && kLengthStep > kLengthRadius * (1 + base::sin(half)))
      ways += kLengthStep / base::sin(half);
  }
  return kCircleOverSegment * ways * static_cast<double>(contours - 1);
}

/// The printed lengths of a shape: contours by kappa; contours at the rivals' step, and what segments and loops add.
struct PrintedLengths {
  double kappa, contours, segments, loops;
};

void add_lengths(Reproduction& result, const char* shape, const Region& region,
                 const PrintedLengths& printed) {
  const Part part = pocket_part(region, shape, 2 * kLengthRadius);
  const std::string step = fmt::format("{}mm", kLengthStep);
  const auto fixed = planned_outline(part, {.strategy = "fixed", .stepover = step, .as_printed = true});
  if (!fixed || fixed->contours.size() != 1) return;
  const double contours = length_in_plan(fixed->findings.all);
  const auto text = [](double value) { return fmt::format("{:.2f}", value); };
  const auto beside_print = [&](const char* method, double ours, double our_added, double theirs,
                                double their_added, const char* clean) {
    result.add({shape, method, text(theirs), beside(ours, theirs, 2, kOutline), text(their_added),
                beside(our_added, their_added, 2, kOutline), text(theirs + their_added),
                beside(ours + our_added, theirs + their_added, 2, kOutline), clean});
  };
  const auto length_of = [&](const char* strategy, bool adds) {
    const auto planned = planned_outline(part, {strategy, adds ? std::optional(step) : std::nullopt});
    return planned
               ? std::pair(length_in_plan(planned->findings.all), planned->findings.all.clean ? "yes" : "NO")
               : std::pair(0.0, "does not fit");
  };
  const auto [kappa, kappa_clean] = length_of("lom", false);
  beside_print("proposed (lom)", kappa, 0, printed.kappa, 0, kappa_clean);
  const auto [segments, segments_clean] = length_of("bisectors", true);
  beside_print("bisector segments", contours, segments - contours, printed.contours, printed.segments,
               segments_clean);
  beside_print("loops as circles", contours,
               length_of_circles(region, fixed->contours.front().from_wall.size()), printed.contours,
               printed.loops, "not planned");
  for (const auto& [method, strategy, adds] :
       {std::tuple("shortest loops", "loops", true), std::tuple("tangent loops", "single", true),
        std::tuple("lom corrected", "lom-corrected", false),
        std::tuple("contour (ours)", "contour", false)}) {
    const auto [total, clean] = length_of(strategy, adds);
    const double alone = adds ? contours : total;
    result.add({shape, method, "", text(alone), "", text(total - alone), "", text(total), clean});
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
  constexpr int kFastest = 500;  // mm/min; the best is far below
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
      "no one ratio of a loop to its segment has these times, whatever the feed: loops take {:.2f} min less "
      "than "
      "segments at R = {} and {:.2f} more at R = {}; were loops the longer ones, segments would have {:.0f} "
      "stops more than loops at R = {}, {:.1f} for each of {} corners of {} contours, and were they the "
      "shorter "
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
  constexpr PrintedLengths kConcave{747.30, 584.84, 244, 382}, kConvex{194.26, 165.79, 67, 58};
  add_lengths(result, "concave", concave_star(), kConcave);
  add_lengths(result, "convex", acute_convex(), kConvex);
  table.notes.push_back(
      "their outlines are not printed, the shapes are ours: a four-pointed star and a quadrilateral, on "
      "which the "
      "printed lengths come out together, in their order: kappa's path is the shortest on both, then "
      "segments "
      "on the concave one and loops on the convex one");
  const double half_tip = Radians::of_degrees(kTip).radians() / 2;
  table.notes.push_back(fmt::format(
      "loops as circles: half as wide as the way along the bisector from contour to contour, one for each "
      "contour "
      "but the first in each corner with a rest; pi / 2 of the printed 244 mm of segments are {:.1f} mm, "
      "where "
      "382 are printed. From sin(alpha / 2) = 1 / 3 on, 39 degrees, such a circle stays within the outer "
      "contour, "
      "at the star's {:g} degrees it runs {:.1f} mm over it, so that it would gouge",
      kCircleOverSegment * kConcave.segments, kTip, kLengthStep * (0.25 / base::sin(half_tip) - 0.75)));
  table.notes.push_back("lengths of linked programs in plan, with passages; clean: by the certificate");
  return result;
}

Reproduction cutter_comparison() {
  const std::vector<CutterWays> all = ways_of_cutters(inscribed_polygon({}));
  const FittedFeed fit = fitted_feed(all);
  Reproduction result;
  TextTable& table = result.table;
  table.title = "CPO-rho table 3: cutting time by eq. 9, min; polygon of inscribed radius 20.46 mm";
  table.columns = {{"R mm"},          {"rho, theirs"}, {"ours"},           {"bisectors, theirs"}, {"ours"},
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
      "circles: pi / 2 of the length of the segments and as many stops, as lengths finds of the printed "
      "loops of "
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
                        all,
                        [](const auto&one) { return std::pair(one.printed.present, one.printed.bisectors); }),
                    loops = radii_where_rho_wins(all, [](const auto&one) {
                      return std::pair(one.printed.present, one.printed.loops);
                    });
  for (const double share : kTrendFeeds) {
    const double feed = share * fit.mm_per_min;
    const auto wins_over = [&](CutterWay CutterWays::*rival) {
      return radii_where_rho_wins(
          all, [&](const auto& one) { return std::pair(one.rho.minutes(feed), (one.*rival).minutes(feed)); });
    };
    result.add({fmt::format("{:.0f}", feed), bisectors,
                checked(wins_over(&CutterWays::bisectors), bisectors, "the outline is not printed"), loops,
                checked(wins_over(&CutterWays::circles), loops,
                        "no one ratio of loops to segments has the printed times, see below"),
                wins_over(&CutterWays::loops)});
  }
  result.table.notes.push_back(limit_of_loops());
  result.table.notes.emplace_back(
      "circles: pi / 2 of the length of the segments and as many stops, as lengths finds of the printed "
      "loops of "
      "the other paper; shortest loops: those that we plan, no longer than the rests ask for");
  result.table.notes.push_back(law_of_times(fit) + "; the other feeds are half, twice and four times it");
  result.table.notes.push_back("cutters of 10 mm and more take the same time by all three in print");
  return result;
}

}  // namespace clearcut::studies
