// Requests for the whole work in addition to the data of each operation: stepover, the rule by which the feed follows
// the load of the cutter, entries and the like.
#pragma once

#include <optional>
#include <string>

#include "base/units.h"

namespace clearcut::inline model {

/// The requested stepover, as text: "0.4" (fraction of the diameter), "3.5mm", "lom", ...; "" leaves it to the
/// strategy. Each strategy reads its own rules, see parse_step_rule.
struct Stepover {
  std::string text;
  bool is_given() const { return !text.empty(); }
};

/// Quantity kept at or below its value at the reference.
enum class FeedBy : unsigned char {
  kChip,    ///< thickness of the chip: the feed times the greatest cosine between advance and contact
  kRemoval  ///< area of material in plan removed per unit of time
};

/// The reference is a straight cut of engagement `reference` at the stated feed.
struct FeedRule {
  FeedBy by = FeedBy::kChip;
  Radians reference;             ///< engagement for which the feed is stated
  std::optional<MmPerMin> feed;  ///< stated for the reference; absent: the feed of each operation
  std::optional<MmPerMin> cap;   ///< no move is fed faster; absent: twice the reference's feed
};

struct ShopOptions {
  std::optional<double> helix_widest;     ///< mm, diameter of the centre's circle during the descent
  std::optional<double> helix_narrowest;  ///< mm
  std::optional<MmPerMin> lead_feed;      ///< arcs and lines into and out of passes
  std::optional<double> lead_overlap;     ///< mm; passes along walls run on over their start
  std::optional<MmPerMin> link_feed;      ///< feed of links at depth through cleared areas
  std::optional<double> overrun;          ///< mm; open sides are cut this far beyond their edge
  std::optional<double> link_lift;        ///< mm; links at depth run higher by this distance
  /// The allowed deviation of the machine from the path is to be found.
  bool margin = false;
  std::optional<double> margin_at_least;  ///< mm; margin that the plan must allow and the verdict requires
  std::optional<double> margin_uncut;     ///< mm; greatest uncut thickness with that margin
  std::optional<double> margin_gouge;     ///< mm; greatest gouge depth with that margin
  std::optional<double> slot_angle_deg;   ///< engagement above which the slot feed is used
  std::optional<FeedBy> feed_by;          ///< feeds follow the load; absent: they are as stated
  std::optional<double> reference_engagement_deg;  ///< engagement for which the feed is stated
  std::optional<MmPerMin> reference_feed;  ///< feed at the reference engagement; absent: the operation's feed
  std::optional<MmPerMin> feed_cap;        ///< no move is fed faster then
  std::optional<bool> rest;  ///< all tools given for each pocket, larger first, each cutting the material
                             ///< left by the previous one
  std::optional<std::string> finish;   ///< "walls", "floor", "all": finishing after everything else
  std::optional<double> finish_stock;  ///< mm left on walls for the finishing pass
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

  std::optional<std::string> style;  ///< "machinist", "fastest": style of all choices left open

  /// The widest helix, mm, if an operation states its own greatest radius: these options take precedence.
  std::optional<double> widest_helix(std::optional<double> operation_radius) const;
  /// Whether cuts are chosen in a machinist's style: as requested, else if the work is a metal.
  bool is_machinist() const;
};

}  // namespace clearcut::inline model
