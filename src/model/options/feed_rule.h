// Rule by which the feed follows the load of the cutter.
#pragma once

#include <optional>

#include "base/units.h"

namespace clearcut::inline model {

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

}  // namespace clearcut::inline model
