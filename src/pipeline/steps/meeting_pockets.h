// Pockets that run into each other: where they meet there is no wall, and the cutter may pass.
#pragma once

#include <optional>
#include <vector>

#include "model/layer.h"
#include "model/part.h"

namespace clearcut::pipeline {

/// The other features of the workplan that run into the pocket of a workingstep without lying inside it, and are either
/// cut before or begin no higher. Over others more may stand than the pocket's layers are deep: of them counts what cutters
/// have cleared before down to where the pocket begins. Round holes and open
/// features have none, because they are bounded by themselves, unless stock is to stay on their walls: no finished wall stands
/// where others take it away, and there is nothing for stock to stay on. Profiles keep to their kerf.
class MeetingPockets {
 public:
  MeetingPockets(const Part& part, int workingstep, const Tolerances& tol);

  bool empty() const { return met_.empty(); }

  /// Widens a layer of the pocket by what those features take away at its depth or below, where that lets the cutter reach
  /// more of its target: up to a diameter beside what is gained. What is added is cut with the layer, whether the other
  /// feature comes before or after. Cost: some offsets and booleans, once for layers of one outline.
  void widen(Layer& layer);

 private:
  std::vector<const Feature*> open_at(double z) const;
  /// What is added to the layer's area; nothing where it gains nothing.
  std::optional<Regions> added_to(const Layer& layer, const std::vector<const Feature*>& open) const;

  /// A feature's outline at a depth, as far as its place is free down to the top of the pocket.
  Regions room_of(const Feature& other, double z) const;

  std::vector<const Feature*> met_;
  std::vector<const Feature*> higher_;  ///< of those: cut later, and begin higher than the pocket
  Regions cleared_;  ///< down to the top of the pocket by what is cut before; only for those
  Tolerances tol_;
  std::vector<const Feature*> last_open_;  ///< of the layer that was widened last
  Regions last_allowed_;                   ///< its area before
  std::optional<Regions> last_added_;
};

}  // namespace clearcut::pipeline
