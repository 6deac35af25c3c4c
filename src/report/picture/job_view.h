// What every picture needs of a job: the sections, tools and figures of each feature, and the area of a floor within
// a cutter's reach.
#pragma once

#include <limits>
#include <vector>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "report/picture/plan_picture.h"

namespace clearcut::report {

/// Index of the feature of `section`: by its workingstep, else by its label, else the only feature
/// of the part; -1 when unknown.
int feature_of(const Part& part, const Section& section);

/// The tool with the number of the section; nullptr when the part has none.
const Tool* tool_of(const Part& part, const Section& section);

/// Findings about one feature, in order of work; several if several operations cut the feature.
std::vector<const FeatureFindings*> findings_of(const Part& part, const Findings& findings, int feature);

/// Depth of the last layer of a section: the lowest cutting move; +infinity when there is none.
double last_layer(const Section& section);

/// The moves of the last layer with its entries, and the rapids between them; all moves when `all_layers`.
std::vector<Move> shown_moves(const Section& section, bool all_layers);

/// Shade of a floor at `z`, 0 at the top of the part to 1 at its deepest floor: half by depth, half by rank
/// among the floors (piecewise linear), to distinguish floors of nearly the same depth.
double depth_fraction(const Part& part, double z);

/// "gouge 0.250 mm"; without a length for kinds without one.
std::string headline_of(const Fault& fault);

/// "T1 end mill 10 mm"
std::string description_of(const Tool& tool);

struct Reach {
  /// Diameter of the smallest cutter that worked on the feature, or was planned for it; 0: none.
  double diameter = 0;
  double flat = 0;  ///< diameter of the flat of its end, the only part that cuts down to the floor
  Regions centers;  ///< legal positions of its centre at the floor
  std::vector<Path> fit_lines;   ///< lines on which the cutter just fits,
  std::vector<Vec2> fit_points;  ///< along lines or in a single point (a drill in its hole)
};

/// mm; width of a cutter `above` mm over its tip. For holes ending in the cone of a drill, the drill's full width.
double width_on_floor(const Feature& feature, const Tool& tool, double above);

/// Cost: one Clearance of the feature's allowed area.
Reach reach_of(const Job& job, int feature);

/// The outlines at the floor: smaller than at the top if walls have draft.
Regions floor_target(const Feature& feature);
Regions floor_allowed(const Feature& feature);

}  // namespace clearcut::report
