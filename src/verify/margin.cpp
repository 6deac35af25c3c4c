#include "verify/margin.h"

#include <algorithm>
#include <map>

#include "base/elementary.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "model/cutter_profile.h"
#include "verify/coverage/feature_work.h"
#include "verify/faults/move_gouge.h"
#include "verify/part/finished_parts.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {
namespace {

/// The largest number of steps of kMarginStep, at most `most`, for which `holds` is true; `holds` must be monotone.
/// -1: false even for 0 steps.
template <typename Holds>
int largest_at(int most, Holds holds) {
  if (!holds(0)) return -1;
  if (holds(most)) return most;
  int low = 0, high = most;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

int steps_within(double mm) {
  return static_cast<int>(mm / kMarginStep + 1e-6);
}

class MarginSearch {
 public:
  MarginSearch(const Part& part, const Toolpath& toolpath, const VerifyOptions& options)
      : part_(part),
        options_(options),
        finished_(part),
        program_(checked_program(part, toolpath, options.machine, options.earlier, options.control,
                                 options.earlier_control)),
        floor_at_(floor_check(part, finished_, program_, options)) {}

  Margin run(const MarginBounds& bounds) {
    Margin margin{bounds, {}, not_asked()};
    std::vector<FeatureWork> works = works_of(part_);
    std::erase_if(works, [&](const FeatureWork& work) { return leans(work.feature); });
    std::vector<FeatureMargin> found(works.size());
    for (std::size_t i = 0; i < works.size(); ++i) {
      throw_if_cancelled(options_.cancel);
      found[i] = by_coverage(works[i]);
    }
    for (std::size_t i = 0; i < works.size(); ++i) by_feature_[works[i].feature] = &found[i];
    for (const CheckedMove& checked : program_.moves) by_gouges(checked);
    margin.features = std::move(found);
    return margin;
  }

 private:
  bool leans(int feature) const {
    return part_.features[static_cast<std::size_t>(feature)].wall_slope.radians() > 0;
  }

  /// Features without a work of plain floors and walls.
  std::vector<std::string> not_asked() const {
    std::vector<char> asked(part_.features.size(), 0);
    for (const FeatureWork& work : works_of(part_))
      if (!leans(work.feature)) asked[static_cast<std::size_t>(work.feature)] = 1;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < part_.features.size(); ++i)
      if (asked[i] == 0) names.push_back(part_.features[i].name);
    return names;
  }

  FeatureMargin by_coverage(const FeatureWork& work) const {
    FeatureMargin margin{
        part_.features[static_cast<std::size_t>(work.feature)].name, 0, MarginLimit::kUncut, {}};
    const double uncut = options_.tol.uncut;
    LevelCoverage beyond;
    const auto holds = [&](int steps) {
      const LevelCoverage floor = floor_at_(work, steps * kMarginStep);
      const Coverage& coverage = floor.coverage;
      const bool is_left = coverage.reachable && (!floor.any_cut || coverage.thickness_mm > uncut);
      if (is_left) beyond = floor;
      return !is_left;
    };
    const int most = steps_within(uncut);
    const int steps = largest_at(most, holds);
    margin.mm = std::max(steps, 0) * kMarginStep;
    if (steps < most && beyond.coverage.worst) margin.at = Place{*beyond.coverage.worst, beyond.z, 0};
    return margin;
  }

  /// The relevant gouge of a move displaced by `off` mm from its path in any direction.
  std::optional<Gouge> gouge_at(const CheckedMove& checked, double off) const {
    Move lower = *checked.move;
    lower.z_from -= off;
    lower.z_to -= off;
    const double before = &checked == program_.moves.data() ? 0 : (&checked - 1)->path_tolerance;
    const double liberty = std::max({checked.doubt, checked.path_tolerance, before});
    // A lower flank comes nearer to walls according to its slope.
    const double lean = has_flanks(*checked.tool) ? base::hypot(1.0, flank_slope(*checked.tool)) : 1;
    const auto gouge =
        gouge_of_move(finished_, checked, lower, (off + liberty) * lean, options_.tol.gouge, false);
    return gouge && gouge->depth > options_.tol.gouge ? gouge : std::nullopt;
  }

  /// The margin to which this move applies: that of its step's feature, or, without a step, that of the feature whose
  /// wall is gouged.
  FeatureMargin* margin_for(const CheckedMove& checked, const Gouge& gouge) const {
    const int feature = checked.workingstep >= 0
                            ? part_.workplan[static_cast<std::size_t>(checked.workingstep)].feature
                            : gouge.feature;
    const auto found = by_feature_.find(feature);
    return found == by_feature_.end() ? nullptr : found->second;
  }

  /// Reduces its feature's margin if this move allows less.
  void by_gouges(const CheckedMove& checked) {
    throw_if_cancelled(options_.cancel);
    if (checked.radius() <= 0 || checked.is_of_stock || checked.is_carried()) return;
    std::optional<Gouge> beyond = gouge_at(checked, options_.tol.uncut);
    FeatureMargin* const margin = beyond ? margin_for(checked, *beyond) : nullptr;
    if (!margin) return;
    beyond.reset();
    const int most = steps_within(margin->mm);
    const int steps = largest_at(most, [&](int at) {
      const auto gouge = gouge_at(checked, at * kMarginStep);
      if (gouge) beyond = gouge;
      return !gouge;
    });
    if (!beyond) return;
    margin->mm = std::max(steps, 0) * kMarginStep;
    margin->limit = MarginLimit::kGouge;
    margin->at = Place{beyond->point, beyond->z, checked.move->line};
  }

  const Part& part_;
  const VerifyOptions& options_;
  const FinishedParts finished_;
  const CheckedProgram program_;
  const FloorCheck floor_at_;
  std::map<int, FeatureMargin*> by_feature_;
};

}  // namespace

Margin margin_of(const Part& part, const Toolpath& toolpath, const VerifyOptions& options,
                 const MarginBounds& bounds) {
  VerifyOptions asked = options;
  asked.tol.uncut = bounds.uncut;
  asked.tol.gouge = bounds.gouge;
  return MarginSearch(part, toolpath, asked).run(bounds);
}

}  // namespace clearcut::verify
