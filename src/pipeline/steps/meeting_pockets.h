// Pockets that run into each other: where they meet there is no wall, and the cutter may pass.
#pragma once

#include <optional>
#include <vector>

#include "model/layer.h"
#include "model/part.h"

namespace clearcut::pipeline {

/// The other features of the workplan that run into the pocket of a workingstep without lying inside it, and are either
/// cut before or begin no higher: over the others more may stand than the pocket's layers are deep. Open features and
/// round holes have none: they are bounded by themselves.
class MeetingPockets {
 public:
  MeetingPockets(const Part& part, int workingstep, const Tolerances& tol);

  bool empty() const { return met_.empty(); }

  /// Widens a layer of the pocket by what those features take away at its depth or below, where that lets the cutter reach
  /// more of the pocket: up to a diameter beside what is gained. What is added is cut with the layer, whether the other
  /// feature comes before or after. Cost: some offsets and booleans, once for layers of one outline.
  void widen(Layer& layer);

 private:
  std::vector<const Feature*> open_at(double z) const;
  /// The layer's area with what it gains; nothing where it gains nothing.
  std::optional<Regions> widened(const Layer& layer, const std::vector<const Feature*>& open) const;

  std::vector<const Feature*> met_;
  Tolerances tol_;
  std::vector<const Feature*> last_open_;  ///< of the layer that was widened last
  Regions last_allowed_;                   ///< its area before
  std::optional<Regions> last_widened_;
};

}  // namespace clearcut::pipeline
