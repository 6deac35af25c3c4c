// From drafts to the regions a cutter removes and the regions it may enter.
#pragma once

#include "read/stepnc/shapes/draft.h"

namespace clearcut::read::stepnc {

/// The block that holds every outline of `drafts`, for files that do not give one; nothing where no face
/// shows how far the stock reaches. z_top and z_bottom are left to the caller.
std::optional<Box> plan_of_drafts(const std::vector<Draft>& drafts);

/// target and allowed of a feature. Closed features: the boundary minus bosses, both the same. Others: the
/// part of it in the stock, and all of it with everything outside the stock up to kOpenReach, where it
/// reaches the stock's edge. Throws InputError where nothing is left to remove or the stock is needed and
/// absent.
struct FeatureRegions {
  Regions target;
  Regions allowed;
};
FeatureRegions feature_regions(const Draft& draft, const std::optional<Stock>& stock, Context& context);

/// The course of a slot that a cutter makes by its own form, prolonged at open ends. Throws InputError for flat ends, which round cutters
/// do not leave.
Path groove_course(const Draft& draft, const std::optional<Stock>& stock, Context& context);

}  // namespace clearcut::read::stepnc
