#include <algorithm>
#include <iterator>
#include <map>

#include "geometry/contours/boolean.h"
#include "read/repair/crossings.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

using CompoundPair = std::pair<Compound, Compound>;

/// The crossing pairs of fills of one colour, each with a place.
std::map<CompoundPair, Vec2> crossing_fills(const std::vector<RawLoop>& loops,
                                            const std::vector<Meeting>& harmful) {
  std::map<CompoundPair, Vec2> pairs;
  for (const Meeting& meeting : harmful) {
    const auto& a = loops[static_cast<std::size_t>(meeting.a.loop)].compound;
    const auto& b = loops[static_cast<std::size_t>(meeting.b.loop)].compound;
    if (a && b && *a != *b && a->paint == b->paint) pairs.try_emplace(std::minmax(*a, *b), meeting.at);
  }
  return pairs;
}

/// The areas of fills, and their grouping.
class Fills {
 public:
  Fills(const std::vector<RawLoop>& loops, const Tolerances& tol) : loops_(loops), tol_(tol) {}

  /// Joins two partly overlapping fills.
  bool join(const Compound& a, const Compound& b) {
    const double shared = area(intersect(area_of(a), area_of(b), tol_));
    const double smaller = std::min(area(area_of(a)), area(area_of(b)));
    if (shared <= kSlightOverlap * smaller || shared >= kMostlyInside * smaller) return false;
    const Compound from = first_of(a), into = first_of(b);
    for (auto& [compound, first] : first_)
      if (first == from) first = into;
    return true;
  }

  /// All loops, those of joined fills united.
  std::vector<RawLoop> united() const {
    std::vector<RawLoop> out;
    for (const RawLoop& loop : loops_)
      if (!loop.compound || !first_.contains(*loop.compound)) out.push_back(loop);
    std::map<Compound, Regions> areas;
    for (const auto& [compound, first] : first_)
      std::copy(areas_.at(compound).begin(), areas_.at(compound).end(), std::back_inserter(areas[first]));
    for (const auto& [first, regions] : areas)
      for (Loop& loop : loops_of(unite_all(regions, tol_)))
        out.push_back({std::move(loop), source_of(first), first});
    return out;
  }

  const std::string& source_of(const Compound& compound) const {
    return std::find_if(loops_.begin(), loops_.end(),
                        [&](const RawLoop& loop) { return loop.compound == compound; })
        ->source;
  }

 private:
  const Regions& area_of(const Compound& compound) {
    const auto [found, is_new] = areas_.try_emplace(compound);
    if (is_new) {
      std::vector<Loop> own;
      for (const RawLoop& loop : loops_)
        if (loop.compound == compound) own.push_back(loop.loop);
      found->second = resolve_even_odd(own, tol_);
    }
    return found->second;
  }

  Compound first_of(const Compound& compound) { return first_.try_emplace(compound, compound).first->second; }

  const std::vector<RawLoop>& loops_;
  const Tolerances& tol_;
  std::map<Compound, Regions> areas_;
  std::map<Compound, Compound> first_;  ///< of joined fills: the one representing all
};

}  // namespace

bool unite_fills(std::vector<RawLoop>& loops, const std::vector<Meeting>& harmful,
                 const RepairOptions& options, Diagnostics& diagnostics) {
  const std::map<CompoundPair, Vec2> pairs = crossing_fills(loops, harmful);
  if (pairs.empty() || pairs.size() > kMostCrossingPairs) return false;
  Fills fills(loops, options.tol);
  bool any = false;
  for (const auto& [pair, at] : pairs) {
    if (!fills.join(pair.first, pair.second)) continue;
    any = true;
    diagnostics.note(options.where + " at " + place_text(at),
                     "filled shapes that overlap (" + fills.source_of(pair.first) + ", " +
                         fills.source_of(pair.second) + ") are one area");
  }
  if (any) loops = fills.united();
  return any;
}

}  // namespace clearcut::read
