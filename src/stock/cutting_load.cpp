#include "stock/cutting_load.h"

#include <algorithm>

#include "base/elementary.h"

namespace clearcut::stock {

Removal removal_by(const Tool& tool) {
  const bool asks = !is_conical(tool) && tool.kind != ToolKind::kTSlot;
  return {inner_profile(tool), asks ? tool.radius() : 0};
}

int add_tool(Material& material, const Tool& tool) {
  const Removal removal = removal_by(tool);
  return material.add_cutter(removal.profile, removal.circle);
}

void remove_cut(Material& material, const Move& move, const Tool& tool) {
  const int cutter = add_tool(material, tool);
  if (cutter != Material::kCylinder) {
    material.add_sweep(move, cutter);
  } else {
    material.add(move, tool.radius());
  }
}

namespace {

/// The greatest cosine of any angle of the interval; angles are within a quarter turn of 0.
double greatest_cosine(const AngleInterval& contact) {
  if (contact.from <= 0 && contact.to >= 0) return 1;
  return std::max(base::cos(contact.from), base::cos(contact.to));
}

}  // namespace

double load_at_feed_of_one(FeedBy by, Radians engagement) {
  const double angle = std::clamp(engagement.radians(), 0.0, kPi);
  if (by == FeedBy::kRemoval) return 1 - base::cos(angle);
  return angle >= kPi / 2 ? 1 : base::sin(angle);
}

double load_at_feed_of_one(FeedBy by, const CutterEngagement& contact) {
  if (contact.angle <= 0) return 0;
  double load = 0;
  for (const AngleInterval& item : contact.angles.intervals())
    load = by == FeedBy::kChip ? std::max(load, greatest_cosine(item))
                               : load + base::sin(item.to) - base::sin(item.from);
  return std::max(load, load_at_feed_of_one(by, Radians::of(contact.angle)));
}

}  // namespace clearcut::stock
