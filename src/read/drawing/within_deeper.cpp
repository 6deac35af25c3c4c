#include "read/drawing/within_deeper.h"

#include <cmath>
#include <iterator>

#include "base/text/format.h"
#include "base/tolerances.h"
#include "geometry/contours/boolean.h"
#include "read/common/text.h"
#include "read/drawing/layer_overlaps.h"

namespace clearcut::read {
namespace {

bool is_pocket(const Feature& feature) {
  return feature.kind == FeatureKind::kClosedPocket;
}

/// Pockets of one depth are united elsewhere, chamfers break the edges of pockets, and isolated areas are inside
/// their own band.
bool may_be_cut_away(const Feature& feature) {
  return feature.kind != FeatureKind::kChamfer && feature.kind != FeatureKind::kIsolation &&
         feature.kind != FeatureKind::kPlanarFace && feature.kind != FeatureKind::kExternalThread;
}

/// Decided only by heights.
bool would_cut_away(const Feature& pocket, const Feature& feature) {
  if (!is_pocket(pocket) || std::abs(pocket.top_z - feature.top_z) > kSamePlaceMm) return false;
  const double deeper = feature.floor_z - pocket.floor_z;
  return is_pocket(feature) ? deeper > kSamePlaceMm : deeper > -kSamePlaceMm;
}

bool holds(const Box& outer, const Box& inner) {
  return outer.grown(kSamePlaceMm).contains(inner.min) && outer.grown(kSamePlaceMm).contains(inner.max);
}

DrawingQuestion question_of(const Feature& feature, const Feature& pocket) {
  const std::string name = printable(feature.name), layer = printable(pocket.source);
  const double depth = feature.top_z - feature.floor_z;
  std::string meant;
  std::vector<DrawingAnswer> answers;
  if (is_pocket(feature)) {
    answers.push_back({"--op", "step:" + printable(feature.source)});
    meant = "--op step:" + printable(feature.source) + " if it is a step that stays in that pocket";
  } else if (feature.carving || feature.profile) {
    meant = "if it is meant on that floor say so in its layer's name, as in TOP" +
            trimmed(pocket.floor_z, 4) + " D" + trimmed(depth, 4);
  } else {
    meant = "if it is meant on that floor give its depth from the top, as in D" +
            trimmed(feature.top_z - pocket.floor_z + depth, 4);
  }
  answers.push_back({"--op", "ignore:" + printable(feature.source)});
  return {"",
          name + " is " + trimmed(depth, 4) + " mm deep and lies in a pocket of layer " + layer +
              ", which takes all of it away: " + meant + "; --op ignore:" + printable(feature.source) +
              " leaves it out",
          answers};
}

/// Whether `pocket` would remove the step's floor.
bool reaches_below(const DrawnGroup& pocket, const DrawnGroup& step, const ReadOptions& options) {
  const bool same_top =
      options.top || std::abs(pocket.top.value_or(0) - step.top.value_or(0)) <= kSamePlaceMm;
  return is_pocket(pocket.role) && same_top && !options.depth && pocket.depth && step.depth &&
         *pocket.depth > *step.depth + kSamePlaceMm;
}

Regions beside_steps(Regions pockets, const Regions& steps, const Tolerances& tol) {
  constexpr double kOutside = 0.01;  // mm2; less is rounding
  Regions within, about;
  for (Region& region : pockets) {
    const bool meets = near_any(steps, {region});
    const bool in_step = meets && area(subtract({region}, steps, tol)) < kOutside;
    (in_step || !meets ? within : about).push_back(std::move(region));
  }
  Regions all = about.empty() ? Regions{} : subtract(about, steps, tol);
  std::move(within.begin(), within.end(), std::back_inserter(all));
  return all;
}

}  // namespace

void let_steps_stand(std::vector<ShapedGroup>& groups, const ReadOptions& options) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i].group.role != LayerRole::kStep) continue;
    for (std::size_t j = 0; j < groups.size(); ++j) {
      if (reaches_below(groups[j].group, groups[i].group, options) &&
          near_any(groups[j].regions, groups[i].regions))
        groups[j].regions = beside_steps(std::move(groups[j].regions), groups[i].regions, options.tol);
    }
  }
}

std::optional<DrawingQuestion> question_of_cut_away(const std::vector<Feature>& features,
                                                    const Tolerances& tol) {
  std::vector<Box> boxes;
  for (const Feature& feature : features) boxes.push_back(box(feature.target));
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!may_be_cut_away(features[i])) continue;
    for (std::size_t j = 0; j < features.size(); ++j) {
      if (i != j && would_cut_away(features[j], features[i]) && holds(boxes[j], boxes[i]) &&
          lies_in(features[i].target, features[j].target, tol))
        return question_of(features[i], features[j]);
    }
  }
  return std::nullopt;
}

}  // namespace clearcut::read
