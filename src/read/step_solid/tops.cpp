#include "read/step_solid/tops.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "features/stacking.h"
#include "read/drawing/drawing.h"
#include "read/step_solid/height_map.h"

namespace clearcut::read {

std::vector<Feature> settle_tops(std::vector<Feature>& features, const Stock& stock, const Tolerances& tol) {
  std::vector<Feature> thin;
  for (;;) {
    Part part;
    part.stock = stock;
    add_features(part, features);
    const std::vector<double> tops = features::stacked_tops(part, tol);
    for (std::size_t i = 0; i < tops.size(); ++i) features[i].top_z = tops[i];
    const auto first = std::find_if(features.begin(), features.end(), [&](const Feature& feature) {
      return feature.top_z - feature.floor_z < tol.gouge + kSameHeight;
    });
    if (first == features.end()) return thin;
    // One at a time: material not cut by it remains over the features below.
    thin.push_back(std::move(*first));
    features.erase(first);
  }
}

}  // namespace clearcut::read
