// What other features mean for the layers of a workingstep: pockets that run into each other, where the cutter may
// pass, and parts that others were to remove, but could not.
#pragma once

#include <optional>
#include <vector>

#include "model/layer.h"
#include "model/options/resolved_plan.h"
#include "model/part.h"
#include "plan/common/round_on_wall.h"

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

  /// The cutter of the workingstep touches its own leaning walls with its rounded end, and its layers say how far it keeps off those.
  /// From steeper walls of others it has to keep farther off: their outlines count as that much narrower.
  void touch_walls(const plan::RoundOnWall& own) { own_ = own; }

  /// Widens a layer of the pocket by what those features take away at its depth or below, where that lets the cutter reach
  /// more of its target: up to a diameter beside what is gained. What is added is cut with the layer, whether the other
  /// feature comes before or after. Between leaning walls it may be gained deep down alone: layers are widened from the lowest one up,
  /// and each by what those under it are. Cost: some offsets and booleans, once for layers of one outline.
  void widen(Layer& layer);

 private:
  std::vector<const Feature*> open_at(double z) const;
  /// The area added to the layer; nothing without a gain.
  std::optional<Regions> added_to(const Layer& layer, const std::vector<const Feature*>& open) const;

  /// A feature's outline at a depth, as far as its place is free down to the top of the pocket, and as the cutter may come near to it.
  Regions room_of(const Feature& other, double z) const;

  std::vector<const Feature*> met_;
  std::vector<const Feature*> higher_;  ///< of those: cut later, and begin higher than the pocket
  bool leans_ = false;                  ///< whether the pocket's walls do
  Regions below_;                       ///< what was added to layers so far, under leaning walls
  Regions cleared_;  ///< down to the top of the pocket by what is cut before; only for those
  Tolerances tol_;
  double corner_ = 0;                      ///< mm; radius of the corner of the workingstep's cutter
  plan::RoundOnWall own_;                  ///< no round: the cutter keeps off all walls alike
  std::vector<const Feature*> last_open_;  ///< of the layer that was widened last
  Regions last_allowed_;                   ///< its area before
  std::optional<Regions> last_added_;
};

/// For a layer that, by the outlines of earlier work, is already clear: the part not reached by the cutters of that
/// work, as in narrow corners, but within reach of this workingstep's cutter. Nothing for walls with draft. Slivers
/// are left out. The layer must belong to a feature closed all round. Cost: some offsets and booleans for each
/// earlier workingstep overlapping the layer.
Regions missed_by_others(int workingstep, const Layer& layer, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
