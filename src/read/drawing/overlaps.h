// Outlines that overlap others: islands, layers in one another, features within a deeper pocket, and outlines
// reaching the edge of the stock.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/tolerances.h"
#include "geometry/region.h"
#include "model/part.h"
#include "options/read_options.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {

/// `regions` without the islands they contain or overlap. An area within an island, such as a hole in a boss, stays
/// whole: it is cut in the island. An outline as large as the island below it is left out, and reported at `place`,
/// since the two contradict each other.
Regions without_islands(Regions regions, const Regions& islands, const std::string& place,
                        const Tolerances& tol, Diagnostics& diagnostics);

/// Whether the boxes of any of `regions` and of `others` as a whole overlap.
bool near_any(const Regions& regions, const Regions& others);

/// Whether `inner` is in `outer` except for rounding, and does not fill it.
bool lies_in(const Regions& inner, const Regions& outer, const Tolerances& tol);

/// The first outline in a pocket of another layer with the same top and depth, if neither has a stated role, with all
/// other layers in the same unclear situation: they may be islands.
std::optional<DrawingQuestion> question_of_layers(const std::vector<ShapedGroup>& groups,
                                                  const ReadOptions& options);

/// Makes pockets of several layers, of one top and one depth, one pocket if they overlap.
void unite_overlapping_layers(std::vector<ShapedGroup>& groups, const ReadOptions& options,
                              Diagnostics& diagnostics);

/// Keeps the cutter of a face or an isolation, which may leave these on all sides, off what lies apart from them: there the material
/// beside them is the wall of another feature. The way to that wall is halved between both, up to 20 mm. Drilled holes deeper than
/// an isolation need no wall kept beside it. Cost: a few booleans for each feature whose box overlaps and that lies beside.
void keep_open_features_off_others(std::vector<Feature>& features, const Tolerances& tol);

/// The question about the first feature wholly removed by a pocket around it that is at least as deep and begins at
/// the same height: a shallower pocket may be a step, any other feature may be intended on the floor. Nothing if
/// there is none. Cost O(n m) boxes for n features and m pockets, and a boolean for each feature within such a
/// pocket.
std::optional<DrawingQuestion> question_of_cut_away(const std::vector<Feature>& features,
                                                    const Tolerances& tol);

/// Subtracts every step from deeper pockets of the same top that overlap it. Features wholly inside a step are cut in
/// the step. Does nothing if a depth is missing: the depth is asked first.
void let_steps_stand(std::vector<ShapedGroup>& groups, const ReadOptions& options);

/// Gives the part the block bounded by outlines of the role stock, if there are any: down to their depth, else the
/// depth of the deepest feature; there must be one.
void set_stock(Part& part, const std::vector<ShapedGroup>& groups, const std::vector<Feature>& features,
               const ReadOptions& options);

/// Lets the cutter of every feature of a drawing or outline that reaches part.stock's edge run out over this edge,
/// whatever permitted area is stated: there is no wall where nothing stands. Areas beside the stock are no target. Does
/// nothing without a stock. Cost: two booleans for each feature that reaches the edge.
void open_at_stock_edge(Part& part, const Tolerances& tol);

}  // namespace clearcut::read
