// Features of a drawing within a deeper pocket.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"
#include "read/common/read_options.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {

/// The question about the first feature wholly removed by a pocket around it that is at least as deep and begins at
/// the same height: a shallower pocket may be a step, any other feature may be intended on the floor. Nothing if
/// there is none. Cost O(n m) boxes for n features and m pockets, and a boolean for each feature within such a
/// pocket.
std::optional<DrawingQuestion> question_of_cut_away(const std::vector<Feature>& features,
                                                    const Tolerances& tol);

/// Subtracts every step from deeper pockets of the same top that overlap it. Features wholly inside a step are cut in
/// the step. Does nothing if a depth is missing: the depth is asked first.
void let_steps_stand(std::vector<ShapedGroup>& groups, const ReadOptions& options);

}  // namespace clearcut::read
