#include "pipeline/steps/rounded_places.h"

#include <fmt/format.h>

#include "base/text/format.h"
#include "post/post.h"
#include "stock/round_hole.h"

namespace clearcut::pipeline {
namespace {

/// mm. Roundness of what is read back.
constexpr double kSlack = 1e-5;

constexpr double kMicrometres = 1000;  // per mm

}  // namespace

void explain_rounded_places(PlanResult& result, const ResolvedPlan& plan) {
  const double beside = post::rounding_of_lines(plan.post);
  for (const FeatureFindings& found : result.findings.features) {
    if (found.figures.clean || found.workingstep < 0) continue;
    const Workingstep& step = result.part.workplan[static_cast<std::size_t>(found.workingstep)];
    if (!stock::only_plunges(tool_of(result.part, step))) continue;
    const double gouge = found.figures.gouge_mm;
    if (gouge <= plan.tol.gouge || gouge > beside + kSlack) continue;
    result.part.diagnostics.warn(
        found.name,
        fmt::format("the program's digits put holes up to {} um beside their places, this one {}: add "
                    "--decimals {} if the control reads as many",
                    trimmed(beside * kMicrometres, 2), trimmed(gouge * kMicrometres, 2),
                    post::decimals_of(plan.post) + 1));
  }
}

}  // namespace clearcut::pipeline
