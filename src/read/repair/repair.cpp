#include "read/repair/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "geometry/contours/boolean.h"
#include "read/repair/clean.h"
#include "read/repair/crossings.h"
#include "read/repair/joining.h"
#include "read/repair/meetings.h"

namespace clearcut::read {

std::string short_number(double value) {
  return fmt::format("{:.3g}", value);
}

std::string place_text(Vec2 p) {
  return "(" + trimmed(p.x, 4) + ", " + trimmed(p.y, 4) + ")";
}

void Mends::report(const std::string& where, Diagnostics& diagnostics) const {
  constexpr std::size_t kListed = 100;
  const std::size_t listed = std::min(kListed, mends_.size());
  for (std::size_t i = 0; i < listed; ++i) {
    diagnostics.repair(where + " at " + place_text(mends_[i].place),
                       what_ + " of " + short_number(mends_[i].size) + " mm");
  }
  if (listed == mends_.size()) return;
  const auto largest = std::max_element(mends_.begin() + kListed, mends_.end(),
                                        [](const Mend& a, const Mend& b) { return a.size < b.size; });
  diagnostics.repair(where + " at " + place_text(largest->place),
                     what_ + ": " + std::to_string(mends_.size() - listed) + " more, the largest here, " +
                         short_number(largest->size) + " mm");
}

namespace {

/// Loops thinner than this on average enclose nothing to mill, mm.
constexpr double kThinnest = 1e-3;
/// Greatest number of touches examined by the last check.
constexpr std::size_t kMostTouches = 1'000'000;
/// mm. Crossings thinner than this are left: the library gives arcs back to within tol.chord on either
/// side.
constexpr double kShallow = 5e-4;

/// Twice the area over the length: the mean width of a thin loop, mm.
double mean_width(double area, const Loop& loop) {
  return 2 * std::abs(area) / length(loop);
}

/// Whether a line runs straight back over the previous one.
bool turns_back(const Edge& before, const Edge& after) {
  if (before.is_arc() || after.is_arc()) return false;
  const Vec2 a = before.to - before.from, b = after.to - after.from;
  return cross(a, b) == 0 && dot(a, b) < 0;
}

/// The loop without lines run forth and back: these enclose no area, and thousands over each other would take a
/// boolean minutes. O(n).
Loop without_ways_back(const Loop& loop) {
  Loop kept;
  for (const Edge& edge : loop) {
    kept.push_back(edge);
    while (kept.size() > 1 && turns_back(kept[kept.size() - 2], kept.back())) {
      const Vec2 to = kept.back().to;
      kept.pop_back();
      kept.back().to = to;
      if (kept.back().from == to) kept.pop_back();
    }
  }
  return kept;
}

/// Lobes of opposite turn may cancel, so a loop without net area is examined again.
bool is_thin(const Loop& loop, const Tolerances& tol) {
  return mean_width(signed_area(loop), loop) <= kThinnest &&
         mean_width(area(resolve_even_odd(std::span(&loop, 1), tol)), loop) <= kThinnest;
}

/// Removes lines run forth and back if there are hundreds in a loop; a few of them are mended with other touches.
void drop_ways_back(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics) {
  constexpr std::size_t kHundred = 100;
  for (RawLoop& loop : loops) {
    Loop outline = without_ways_back(loop.loop);
    const std::size_t gone = loop.loop.size() - outline.size();
    if (gone < kHundred || outline.size() < 2) continue;
    diagnostics.repair(options.where + " at " + place_text(outline.front().from),
                       "an outline (" + loop.source + ") goes forth and back over itself: " +
                           std::to_string(gone) + " lines that enclose nothing were dropped");
    loop.loop = std::move(outline);
  }
}

std::vector<RawLoop> without_thin(std::vector<RawLoop> loops, const RepairOptions& options,
                                  Diagnostics& diagnostics) {
  std::vector<RawLoop> kept;
  for (RawLoop& loop : loops) {
    if (!is_thin(loop.loop, options.tol)) {
      kept.push_back(std::move(loop));
      continue;
    }
    diagnostics.repair(options.where + " at " + place_text(loop.loop.front().from),
                       "an outline (" + loop.source + ") that encloses nothing was dropped: length " +
                           short_number(length(loop.loop)) + " mm");
  }
  return kept;
}

/// The promise of Region, tested: no loop crosses or runs along itself or another by more than kShallow.
Regions checked(Regions regions, const RepairOptions& options) {
  const std::vector<Loop> loops = loops_of(regions);
  for (const Meeting& meeting : meetings(loops, kMostTouches, options.where)) {
    if (meeting.kind == MeetingKind::kTouch || is_shallow(loops, meeting, kShallow)) continue;
    throw InputError(options.where, "the outlines near " + place_text(meeting.at) +
                                        " lie too close to be told apart; separate them in the drawing");
  }
  return regions;
}

}  // namespace

std::string other_use_of_lines(const RepairOptions& options) {
  return std::string(", or have the cutter follow the lines (--op engrave:'*')") +
         (options.has_pens ? ", or mill them as wide as they are drawn (--strokes areas)" : "");
}

Regions repair(std::vector<RawCurve> curves, const RepairOptions& options, Diagnostics& diagnostics) {
  const bool nothing_drawn = curves.empty();
  std::vector<RawLoop> loops = join(clean(std::move(curves), options, diagnostics), options, diagnostics);
  trim_joints(loops, options, diagnostics);
  drop_ways_back(loops, options, diagnostics);
  loops = without_thin(std::move(loops), options, diagnostics);
  if (loops.empty() && !nothing_drawn && options.may_be_empty) return {};
  if (loops.empty()) {
    throw InputError(options.where, nothing_drawn
                                        ? "no closed outline found; draw the pocket as a closed curve"
                                        : "no outline encloses an area; draw the pocket as a closed curve");
  }
  if (options.find_arcs) find_arcs(loops, options, diagnostics);
  loops = resolve_compounds(std::move(loops), options, diagnostics);
  loops = without_double_loops(std::move(loops), options.tol.join_gap, options.where, diagnostics);
  return checked(nested(resolve_crossings(std::move(loops), options, diagnostics)), options);
}

}  // namespace clearcut::read
