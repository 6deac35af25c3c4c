#include "read/common/features/within_deeper.h"

#include <cmath>

#include "base/text/format.h"
#include "read/common/layers/layer_overlaps.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

/// mm. Depths that differ by less are the same.
constexpr double kSameDepth = 1e-6;

bool is_pocket(const Feature& feature) {
  return feature.kind == FeatureKind::kClosedPocket;
}

/// Pockets of one depth are united elsewhere, chamfers break the edges of pockets, and what is isolated stands in a band of its own.
bool may_be_cut_away(const Feature& feature) {
  return feature.kind != FeatureKind::kChamfer && feature.kind != FeatureKind::kIsolation &&
         feature.kind != FeatureKind::kPlanarFace && feature.kind != FeatureKind::kExternalThread;
}

/// By heights alone.
bool would_cut_away(const Feature& pocket, const Feature& feature) {
  if (!is_pocket(pocket) || std::abs(pocket.top_z - feature.top_z) > kSameDepth) return false;
  const double deeper = feature.floor_z - pocket.floor_z;
  return is_pocket(feature) ? deeper > kSameDepth : deeper > -kSameDepth;
}

bool holds(const Box& outer, const Box& inner) {
  return outer.grown(kSameDepth).contains(inner.min) && outer.grown(kSameDepth).contains(inner.max);
}

std::string question_of(const Feature& feature, const Feature& pocket) {
  const std::string name = printable(feature.name), layer = printable(pocket.source);
  const double depth = feature.top_z - feature.floor_z;
  std::string meant;
  if (is_pocket(feature)) {
    meant = "if it is a step in that pocket draw its outline on layer " + layer + ", too";
  } else if (feature.carving || feature.profile) {
    meant = "if it is meant on that floor say so in its layer's name, as in TOP" +
            trimmed(pocket.floor_z, 4) + " D" + trimmed(depth, 4);
  } else {
    meant = "if it is meant on that floor give its depth from the top, as in D" +
            trimmed(feature.top_z - pocket.floor_z + depth, 4);
  }
  return name + " is " + trimmed(depth, 4) + " mm deep and lies in a pocket of layer " + layer +
         ", which takes all of it away: " + meant + "; --op ignore:" + printable(feature.source) +
         " leaves it out";
}

}  // namespace

std::optional<std::string> question_of_cut_away(const std::vector<Feature>& features, const Tolerances& tol) {
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
