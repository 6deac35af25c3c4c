// Marks on a plan view, in page units: scale bar, worst places, faults.
#pragma once

#include <vector>

#include "report/picture/plan_picture.h"

namespace clearcut::report {

/// A bar of 1, 2 or 5 times a power of ten mm, lower left.
void draw_scale_bar(SvgWriter& svg, const PlanView& view);

/// The places of the thickest rest, the deepest gouge and the largest engagement, with their figures.
void draw_worst_places(SvgWriter& svg, const PlanView& view,
                       const std::vector<const FeatureFindings*>& findings);

/// The place that limits the margin of `feature` (the smallest of all features if null), with the margin.
void draw_margin(SvgWriter& svg, const PlanView& view, const Margin& margin, const Feature* feature);

/// A cross at each fault of `feature` (of all features if null) in the view.
void draw_faults(SvgWriter& svg, const PlanView& view, const Findings& findings, const Feature* feature);

}  // namespace clearcut::report
