// Plan views: the whole part seen from above, and one feature with the material left by its last layer.
#pragma once

#include <string>
#include <vector>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/margin.h"
#include "report/picture/svg_writer.h"

namespace clearcut::report {

/// A rectangle of the page and the piece of the world shown in it, centred, with x right and y up.
struct PlanView {
  Vec2 corner;       ///< upper left, on the page
  double width = 0;  ///< width on the page
  double height = 0;
  Box world;

  double scale() const;          ///< page units per mm
  Vec2 page(Vec2 point) const;   ///< page coordinates of a point of the world
  double mm(double size) const;  ///< mm of a size on the page
  /// The part of the world visible in the whole rectangle.
  Box visible() const;
};

/// A job with its findings; the referenced objects must outlive it.
struct Job {
  const Part& part;
  const Toolpath& toolpath;
  const Findings& findings;
  bool all_layers = false;
  const Toolpath* earlier = nullptr;  ///< earlier cuts
  const Margin* margin = nullptr;     ///< allowed machine error, if it was asked for
};

/// The area of a picture of the whole part: the stock, else the targets, else the feed moves.
Box world_of(const Job& job);
/// The same for one feature.
Box world_of(const Job& job, int feature);

/// Every floor in the shade of its depth, deeper over shallower as one sees them from above, each with the
/// lines of its last layer and its badge; faults. `badges`: a text for each feature, "" for none; empty: the
/// features' numbers.
void draw_overview(SvgWriter& svg, const PlanView& view, const Job& job,
                   const std::vector<std::string>& badges = {});

/// One feature: floor, uncut material (reachable or not), tool impact, lines of the last layer, worst places.
void draw_feature(SvgWriter& svg, const PlanView& view, const Job& job, int feature);

}  // namespace clearcut::report
