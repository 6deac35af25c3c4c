#include "plan/contour/entries.h"

#include <algorithm>

#include "base/error.h"
#include "plan/common/layers.h"

namespace clearcut::plan::contour {
namespace {

/// A contour-parallel method: its name, its step if none is given, and its rule for clearing residuals.
struct ContourMethod {
  const char* name;
  const char* description;
  const char* stepover;
  ResidualRule residuals;
};

constexpr ContourMethod kContourMethods[] = {
    {"contour", "contours as wide as the cutter allows, rests cut locally", "widest", ResidualRule::kOurs},
    {"lom", "published: step 2 R kappa from the smallest angle", "lom", ResidualRule::kNone},
    {"rho", "published: step 2 R rho, overlap of 1 mm in the corner", "rho", ResidualRule::kNone},
    {"second", "published: rho of the second smallest angle, passages along the smallest", "second",
     ResidualRule::kPassages},
    {"lom-corrected", "ours: the widest step between contours that leaves nothing", "lom-corrected",
     ResidualRule::kNone},
    {"rho-corrected", "ours: the same with the overlap of rho", "rho-corrected", ResidualRule::kNone},
    {"fixed", "contours at a fixed step, nothing else", "0.9", ResidualRule::kNone},
    {"loops", "published: fixed step and a loop in every corner", "0.9", ResidualRule::kLoops},
    {"pwid", "published: fixed step and a kite in every corner", "0.9", ResidualRule::kPwid},
    {"single", "published: fixed step and a tangent loop in every corner", "0.9", ResidualRule::kSingleLoops},
    {"double", "published: fixed step and two tangent loops in every corner", "0.9",
     ResidualRule::kDoubleLoops},
    {"bisectors", "published: fixed step and every corner's bisector", "0.9", ResidualRule::kBisectors}};

/// Published methods connect contours along bisectors, but use the shortest links if another strategy was requested
/// and they only serve for comparison, and if there are leads, because leads need closed rings.
Passage passage_of(const ContourMethod& method, const StrategyRequest& request) {
  const bool leads = request.step.lead > 0;
  if (request.step.bisector_passages.value_or(false) && leads)
    throw InputError("--passage",
                     "rings that begin with leads are not joined; leave out --lead or --passage bisector");
  const std::string name = method.name;
  const bool is_published = name != "contour" && !name.ends_with("-corrected");
  const bool is_asked_for = request.step.strategy != nullptr && request.step.strategy->name == name;
  return request.step.bisector_passages.value_or(is_published && is_asked_for && !leads) ? Passage::kBisector
                                                                                         : Passage::kShortest;
}

/// Methods that also cut residuals need contours with round corners, since they know the residuals of those.
bool cuts_contours_alone(const ContourMethod& method) {
  return method.residuals == ResidualRule::kNone || method.residuals == ResidualRule::kPassages;
}

/// As in the published texts: lom, rho and second have corners.
bool has_sharp_reflex(const ContourMethod& method, const StrategyRequest& request) {
  const std::string name = method.name;
  const bool is_printed_so = name == "lom" || name == "rho" || name == "second";
  const bool is_corrected = name.ends_with("-corrected");  // its step is the one for round corners
  return cuts_contours_alone(method) && !is_corrected && request.step.sharp_reflex.value_or(is_printed_so);
}

Strategy make(const ContourMethod& method, const StrategyRequest& request) {
  ContourOptions options;
  options.step = parse_step_rule(request.stepover.is_given() ? request.stepover.text : method.stepover);
  options.residuals = method.residuals;
  options.passage = passage_of(method, request);
  options.sharp_reflex = has_sharp_reflex(method, request);
  options.machine = request.plan.machine;
  options.feed = request.step.feed;
  if (request.step.lead > 0) options.effort = 0;  // rings stay whole, because leads need a place to begin
  options.wall_on_right = request.step.wall_on_right();
  options.outside_in = request.plan.order == ContourOrder::kOutsideIn;
  options.start = request.plan.start;
  options.cancel = request.plan.cancel;
  return once_per_outline(
      [options, tol = request.plan.tol](const Layer& layer) { return plan_contour(layer, options, tol); });
}

StrategyEntry entry_of(const ContourMethod& method) {
  StrategyEntry entry;
  entry.name = method.name;
  entry.description = method.description;
  entry.make = [&method](const StrategyRequest& request) { return make(method, request); };
  if (method.residuals != ResidualRule::kOurs) return entry;
  entry.in_auto = AutoUse::kFirst;
  // Methods without residuals by construction are compared with this one.
  entry.rivals = {"single", "double", "pwid", "loops", "lom-corrected"};
  entry.fallbacks = {"", "0.6", "0.35"};
  return entry;
}

}  // namespace

std::vector<StrategyEntry> entries() {
  std::vector<StrategyEntry> all;
  for (const ContourMethod& method : kContourMethods) all.push_back(entry_of(method));
  return all;
}

std::optional<StepRule> contour_rule(const std::string& name, const Stepover& stepover) {
  const auto method = std::find_if(std::begin(kContourMethods), std::end(kContourMethods),
                                   [&](const ContourMethod& one) { return name == one.name; });
  if (method == std::end(kContourMethods) || method->residuals == ResidualRule::kOurs) return std::nullopt;
  return parse_step_rule(stepover.is_given() ? stepover.text : method->stepover);
}

std::optional<StepRule> published_rule(const std::string& name) {
  const auto method = std::find_if(std::begin(kContourMethods), std::end(kContourMethods),
                                   [&](const ContourMethod& one) { return name == one.name; });
  const bool steps_alone =
      method != std::end(kContourMethods) &&
      (method->residuals == ResidualRule::kNone || method->residuals == ResidualRule::kPassages);
  if (!steps_alone) return std::nullopt;
  return parse_step_rule(method->stepover);
}

}  // namespace clearcut::plan::contour
