#include "pipeline/setups/meeting_floors.h"

#include "base/text/format.h"
#include "geometry/contours/boolean.h"

namespace clearcut::pipeline {
namespace {

/// mm by which floors must overlap, and mm2 over which, to count.
constexpr double kDeeper = 0.01;
constexpr double kOver = 1;

bool ends_in_the_block(const Feature& feature, const Stock& block) {
  return feature.floor_z > block.z_bottom + kDeeper;
}

Regions moved(const Regions& regions, const SetupPlace& place, const Tolerances& tol) {
  std::vector<Loop> loops;
  const auto add = [&](const Loop& loop) {
    Loop& out = loops.emplace_back();
    for (const Edge& edge : loop) out.push_back(model::moved(edge, place));
  };
  for (const Region& region : regions) {
    add(region.outer());
    for (const Loop& island : region.islands()) add(island);
  }
  return resolve_nonzero(loops, tol);
}

/// The features of `next` in the coordinates of one earlier set-up.
class FeaturesFromBelow {
 public:
  FeaturesFromBelow(const Part& next, const SetupPlace& to_earlier, const Tolerances& tol) : tol_(tol) {
    for (const Feature& feature : next.features) {
      if (!ends_in_the_block(feature, *next.stock)) continue;
      features_.push_back(
          {&feature, moved(feature.target, to_earlier, tol), moved_z(feature.floor_z, to_earlier)});
    }
  }

  void meet(const MachinedSetup& setup, std::size_t number, std::vector<Condition>& conditions) const {
    const Stock& block = *setup.part.stock;
    for (const Feature& above : setup.part.features) {
      if (!ends_in_the_block(above, block)) continue;
      for (const FromBelow& below : features_) {
        if (below.ceiling < above.floor_z + kDeeper || !box(below.target).overlaps(box(above.target)))
          continue;
        const double shared = area(intersect(above.target, below.target, tol_));
        if (shared <= kOver) continue;
        conditions.push_back({"floors-meet",
                              below.feature->name + " cuts the floor of " + above.name + " of set-up " +
                                  std::to_string(number) + " away: together they go " +
                                  trimmed(below.ceiling - above.floor_z, 3) +
                                  " mm deeper than the block is thick, over " + trimmed(shared, 1) + " mm2",
                              0,
                              {}});
      }
    }
  }

 private:
  struct FromBelow {
    const Feature* feature;
    Regions target;
    double ceiling;  ///< mm; its floor, seen from above
  };
  const Tolerances& tol_;
  std::vector<FromBelow> features_;
};

}  // namespace

std::vector<Condition> meeting_floors(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                                      const Part& next, const Tolerances& tol) {
  std::vector<Condition> conditions;
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    if (earlier[i].part.is_solid && next.is_solid) continue;
    const SetupPlace back = between(place, earlier[i].place);
    if (!keeps_verticals(back) || !turns_over(back)) continue;
    FeaturesFromBelow(next, back, tol).meet(earlier[i], i + 1, conditions);
  }
  return conditions;
}

}  // namespace clearcut::pipeline
