// Features of a drawing that lie within a deeper pocket.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"
#include "read/common/read_options.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {

/// What is to be asked of the first feature of which a pocket around it, as deep as itself or deeper and from the same height, leaves
/// nothing: a shallower pocket may be a step, anything else may be meant on the floor. Nothing where there is none. Cost O(n m) boxes
/// for n features and m pockets, and a boolean for each that lies within such a pocket.
std::optional<DrawingQuestion> question_of_cut_away(const std::vector<Feature>& features,
                                                    const Tolerances& tol);

/// Takes every step out of the deeper pockets from the same height that reach over it. What lies wholly in a step is cut in it. Where
/// no depth is given nothing happens: that is asked first.
void let_steps_stand(std::vector<ShapedGroup>& groups, const ReadOptions& options);

}  // namespace clearcut::read
