#include "pipeline/steps/rounded_places.h"

#include <fmt/format.h>

#include "base/text/format.h"
#include "features/round_hole.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// mm. Rounding of coordinates read back.
constexpr double kSlack = 1e-5;

constexpr double kMicrometres = 1000;  // per mm

}  // namespace

void explain_rounded_places(PlanResult& result, const ResolvedPlan& plan) {
  for (const FeatureFindings& found : result.findings.features) {
    if (found.figures.clean || found.workingstep < 0) continue;
    const Workingstep& step = result.part.workplan[static_cast<std::size_t>(found.workingstep)];
    const bool plunges = makes_holes(tool_of(result.part, step));
    const double beside = plunges ? post::rounding_of_lines(plan.post) : post::rounding_of(plan.post);
    const double gouge = found.figures.gouge_mm;
    if (gouge <= plan.tol.gouge || gouge > beside + kSlack) continue;
    result.part.diagnostics.warn(
        found.name,
        fmt::format("the program's digits put {} up to {} um beside {} {}: add --decimals {} if the control "
                    "reads as many",
                    plunges ? "holes" : "a cutter that has no room", trimmed(beside * kMicrometres, 2),
                    plunges ? "their places, this one" : "its path, here", trimmed(gouge * kMicrometres, 2),
                    post::decimals_of(plan.post) + 1));
  }
}

}  // namespace clearcut::pipeline
