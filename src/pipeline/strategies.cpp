#include "pipeline/strategies.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "plan/adaptive.h"
#include "plan/contour.h"

namespace clearcut {
namespace {

ContourOptions contour_options(const Operation& operation, const PlanOptions& options) {
  ContourOptions contour;
  if (options.stepover) contour.step = parse_step_rule(*options.stepover);
  contour.machine = options.machine;
  contour.feed = *operation.cutting.feed;
  return contour;
}

}  // namespace

const std::vector<std::string>& strategy_names() {
  static const std::vector<std::string> names{"auto", "contour", "adaptive"};
  return names;
}

Strategy strategy_named(const std::string& name, const Operation& operation, const PlanOptions& options) {
  if (name == "contour") {
    return [contour = contour_options(operation, options), tol = options.tol](const Layer& layer) {
      return plan_contour(layer, contour, tol);
    };
  }
  if (name == "adaptive") {
    AdaptiveOptions adaptive;
    if (options.engagement_deg) adaptive.engagement = Radians::of_degrees(*options.engagement_deg);
    return [adaptive, tol = options.tol](const Layer& layer) { return plan_adaptive(layer, adaptive, tol); };
  }
  throw InputError("--strategy",
                   fmt::format("'{}' is unknown; use one of {}", name, fmt::join(strategy_names(), ", ")));
}

std::vector<std::string> candidates_for(const std::string& name) {
  if (name != "auto") return {name};
  return {"contour"};
}

}  // namespace clearcut
