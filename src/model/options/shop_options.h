// What may be asked of the whole work beyond each operation's own data.
#pragma once

#include <optional>
#include <string>

#include "base/units.h"
#include "model/options/feed_rule.h"

namespace clearcut::inline model {

struct ShopOptions {
  std::optional<double> helix_widest;              ///< mm, diameter of the centre's circle on the way down
  std::optional<double> helix_narrowest;           ///< mm
  std::optional<MmPerMin> lead_feed;               ///< arcs and lines into and out of passes
  std::optional<double> lead_overlap;              ///< mm; passes along walls run on over their start
  std::optional<MmPerMin> link_feed;               ///< ways at depth through what is cut
  std::optional<double> overrun;                   ///< mm; open sides are cut this far beyond their edge
  std::optional<double> link_lift;                 ///< mm; such ways are run this much higher
  bool margin = false;                             ///< how far the machine may leave the path is to be found
  std::optional<double> margin_at_least;           ///< mm; the plan is to allow that, and the verdict asks it
  std::optional<double> margin_uncut;              ///< mm; what may be left then
  std::optional<double> margin_gouge;              ///< mm; what may be cut too deep then
  std::optional<double> slot_angle_deg;            ///< engagement above which the slot feed rules
  std::optional<FeedBy> feed_by;                   ///< feeds follow the load; absent: they are as stated
  std::optional<double> reference_engagement_deg;  ///< at which a feed is meant as stated
  std::optional<MmPerMin> reference_feed;          ///< meant there; absent: that of the operation
  std::optional<MmPerMin> feed_cap;                ///< no move is fed faster then
  std::optional<bool> rest;           ///< all tools given for each pocket, larger first, each on what is left
  std::optional<std::string> finish;  ///< "walls", "floor", "all": finishing after everything else
  std::optional<double> finish_stock;  ///< mm left on walls for it
  std::optional<double> finish_stock_floor;
  std::optional<std::string>
      dogbones;  ///< "corner", "t-bone": relief in inside corners, so that square parts fit
  std::optional<double>
      stock_oversize;                   ///< mm by which the stock may be larger than stated, beside and above
  std::optional<double> finish_depths;  ///< number of depths in which walls are finished
  std::optional<double> finish_steps;   ///< number of passes beside each other in which walls come to size
  std::optional<double> spring_passes;  ///< number of passes along walls that are at size already
  std::optional<std::string>
      compensation;                  ///< "radius", "wear": what the control adds to paths that it compensates
  std::optional<double> wear_range;  ///< mm by which a D word may be off 0 either way
  std::optional<std::string> material;  ///< of the work, for forces and wear: a name of work_materials()

  std::optional<std::string> style;  ///< "machinist", "fastest": what is done where nobody says how

  /// The widest helix, mm, where an operation states a greatest radius of its own: these options come first.
  std::optional<double> widest_helix(std::optional<double> operation_radius) const;
  /// Whether cuts are those that a machinist would choose: said, or else where the work is a metal.
  bool is_machinist() const;
};

}  // namespace clearcut::inline model
