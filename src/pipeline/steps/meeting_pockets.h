// Pockets that run into each other: at their common border there is no wall, and the cutter may pass.
#pragma once

#include <optional>
#include <vector>

#include "model/layer.h"
#include "model/part.h"

namespace clearcut::pipeline {

/// The other features of the workplan that overlap the pocket of a workingstep without being inside it, and are
/// either cut before or begin no higher. Over other features there may be more material than the depth of the
/// pocket's layers: of these, only areas already cleared down to the pocket's top count. Round holes and open
/// features have none, because they are bounded by themselves, unless stock is to be left on their walls: no finished
/// wall remains where other features remove it, so no stock can be left there. Profiles keep to their kerf.
class MeetingPockets {
 public:
  MeetingPockets(const Part& part, int workingstep, const Tolerances& tol);

  bool empty() const { return met_.empty(); }

  /// Widens a layer of the pocket by the areas that these features remove at its depth or below, if this lets the
  /// cutter reach more of its target: up to a diameter beside the gained area. The added area is cut with the layer,
  /// whether the other feature comes before or after. Cost: some offsets and booleans, once for layers of one
  /// outline.
  void widen(Layer& layer);

 private:
  std::vector<const Feature*> open_at(double z) const;
  /// The area added to the layer; nothing without a gain.
  std::optional<Regions> added_to(const Layer& layer, const std::vector<const Feature*>& open) const;

  /// A feature's outline at a depth, as far as its place is free down to the top of the pocket.
  Regions room_of(const Feature& other, double z) const;

  std::vector<const Feature*> met_;
  std::vector<const Feature*> higher_;  ///< features cut later that begin higher than the pocket
  Regions cleared_;  ///< area cleared down to the top of the pocket by earlier work; only for these features
  Tolerances tol_;
  std::vector<const Feature*> last_open_;  ///< open features of the last widened layer
  Regions last_allowed_;                   ///< its area before
  std::optional<Regions> last_added_;
};

}  // namespace clearcut::pipeline
