#include "pipeline/strategies.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.h"
#include "pipeline/tour_solver.h"
#include "plan/adaptive/adaptive.h"
#include "plan/common/layers.h"
#include "plan/contour/contour.h"
#include "plan/spiral/spiral.h"
#include "plan/tour/tour.h"
#include "plan/zigzag/zigzag.h"

namespace clearcut::pipeline {
namespace {

/// A contour-parallel method by name: its step when the user gives none, and how it treats what steps leave.
struct ContourMethod {
  const char* name;
  const char* description;
  const char* stepover;
  plan::contour::ResidualRule residuals;
};

constexpr ContourMethod kContourMethods[] = {
    {"contour", "contours as wide as the cutter allows, rests cut locally", "widest",
     plan::contour::ResidualRule::kOurs},
    {"lom", "published: step 2 R kappa from the smallest angle", "lom", plan::contour::ResidualRule::kNone},
    {"rho", "published: step 2 R rho, overlap of 1 mm in the corner", "rho",
     plan::contour::ResidualRule::kNone},
    {"second", "published: rho of the second smallest angle, passages along the smallest", "second",
     plan::contour::ResidualRule::kPassages},
    {"lom-corrected", "ours: the widest step between contours that leaves nothing", "lom-corrected",
     plan::contour::ResidualRule::kNone},
    {"rho-corrected", "ours: the same with the overlap of rho", "rho-corrected",
     plan::contour::ResidualRule::kNone},
    {"fixed", "contours at a fixed step, nothing else", "0.9", plan::contour::ResidualRule::kNone},
    {"loops", "published: fixed step and a loop in every corner", "0.9", plan::contour::ResidualRule::kLoops},
    {"pwid", "published: fixed step and a kite in every corner", "0.9", plan::contour::ResidualRule::kPwid},
    {"single", "published: fixed step and a tangent loop in every corner", "0.9",
     plan::contour::ResidualRule::kSingleLoops},
    {"double", "published: fixed step and two tangent loops in every corner", "0.9",
     plan::contour::ResidualRule::kDoubleLoops},
    {"bisectors", "published: fixed step and every corner's bisector", "0.9",
     plan::contour::ResidualRule::kBisectors}};

const ContourMethod* contour_method(const std::string& name) {
  const auto found = std::find_if(std::begin(kContourMethods), std::end(kContourMethods),
                                  [&](const ContourMethod& method) { return name == method.name; });
  return found == std::end(kContourMethods) ? nullptr : found;
}

bool wall_on_right(const Operation& operation) {
  return (*operation.direction == CutDirection::kClimb) == operation.cutting.spindle_clockwise;
}

/// Published methods go from contour to contour along bisectors; what others are measured against takes the shortest way.
/// Leads need rings that are whole.
plan::contour::Passage passage_of(const ContourMethod& method, const Attempt& attempt,
                                  const Operation& operation, const resolve::PlanOptions& options) {
  using plan::contour::Passage;
  const bool leads = operation.lead.value_or(0) > 0;
  if (options.bisector_passages.value_or(false) && leads)
    throw InputError("--passage",
                     "rings that begin with leads are not joined; leave out --lead or --passage bisector");
  const std::string name = method.name;
  const bool is_published = name != "contour" && !name.ends_with("-corrected");
  const bool by_default = is_published && attempt.strategy == options.strategy && !leads;
  return options.bisector_passages.value_or(by_default) ? Passage::kBisector : Passage::kShortest;
}

Strategy contour_strategy(const ContourMethod& method, const Attempt& attempt, const Operation& operation,
                          const resolve::PlanOptions& options) {
  plan::contour::ContourOptions contour;
  contour.step = plan::contour::parse_step_rule(attempt.stepover.value_or(method.stepover));
  contour.residuals = method.residuals;
  contour.passage = passage_of(method, attempt, operation, options);
  contour.machine = options.machine;
  contour.feed = *operation.cutting.feed;
  if (operation.lead.value_or(0) > 0) contour.effort = 0;  // rings stay whole: leads need a place to begin
  contour.wall_on_right = wall_on_right(operation);
  contour.outside_in = options.outside_in;
  contour.start = options.start;
  contour.cancel = options.cancel;
  return plan::once_per_outline([contour, tol = options.tol](const Layer& layer) {
    return plan::contour::plan_contour(layer, contour, tol);
  });
}

Strategy adaptive_strategy(const Operation& operation, const resolve::PlanOptions& options) {
  plan::adaptive::AdaptiveOptions adaptive;
  if (options.engagement_deg) adaptive.engagement = Radians::of_degrees(*options.engagement_deg);
  adaptive.start = options.start;
  adaptive.cancel = options.cancel;
  adaptive.widest_helix = options.shop.widest_helix(operation.entry_size);
  return plan::once_per_outline([adaptive, tol = options.tol](const Layer& layer) {
    return plan::adaptive::plan_adaptive(layer, adaptive, tol);
  });
}

/// mm between lines, where one is asked for; rules about the angles of contours mean nothing to lines.
std::optional<double> line_distance(const std::optional<std::string>& stepover, double diameter) {
  if (!stepover) return std::nullopt;
  const plan::contour::StepRule rule = plan::contour::parse_step_rule(*stepover);
  if (rule.kind == plan::contour::StepRule::Kind::kWidest) return std::nullopt;
  if (rule.kind == plan::contour::StepRule::Kind::kFraction) return rule.value * diameter;
  if (rule.kind == plan::contour::StepRule::Kind::kMm) return rule.value;
  throw InputError("--stepover", fmt::format("'{}' is a rule for contours; give a fraction of the diameter "
                                             "or mm, for example 0.8 or 4.5mm",
                                             *stepover));
}

Strategy zigzag_strategy(const Attempt& attempt, const Operation& operation,
                         const resolve::PlanOptions& options) {
  plan::zigzag::ZigzagOptions zigzag;
  // Among others, lines are free to run where they are fastest.
  if (options.strategy == "zigzag") zigzag.angle = operation.feed_direction;
  if (options.angle_deg) zigzag.angle = Radians::of_degrees(*options.angle_deg);
  zigzag.material_on_right = wall_on_right(operation);
  zigzag.machine = options.machine;
  zigzag.feed = *operation.cutting.feed;
  line_distance(attempt.stepover, 1);  // refused before anything is planned
  return plan::once_per_outline(
      [zigzag, stepover = attempt.stepover, tol = options.tol](const Layer& layer) mutable {
        zigzag.stepover = line_distance(stepover, 2 * layer.tool_radius);
        return plan::zigzag::plan_zigzag(layer, zigzag, tol);
      });
}

Strategy tour_strategy(const Attempt& attempt, const Operation& operation,
                       const resolve::PlanOptions& options) {
  auto grid =
      attempt.stepover ? plan::tour::parse_tour_grid(*attempt.stepover) : plan::tour::TourGridOptions{};
  if (options.published_grid) {
    grid.published = true;
    if (!attempt.stepover) grid.pitch = 1;  // Tour 4.2.4: the diameter, where no engagement is asked for
  }
  return plan::once_per_outline(
      [grid, solve = tour_solver(options, *operation.cutting.feed, attempt.briefly),
       tol = options.tol](const Layer& layer) { return plan::tour::plan_tour(layer, grid, solve, tol); });
}

Strategy spiral_strategy(const Attempt& attempt, const Operation& operation,
                         const resolve::PlanOptions& options) {
  plan::spiral::SpiralOptions spiral;
  spiral.wall_on_right = wall_on_right(operation);
  spiral.machine = options.machine;
  spiral.feed = *operation.cutting.feed;
  line_distance(attempt.stepover, 1);  // refused before anything is planned
  return plan::once_per_outline(
      [spiral, stepover = attempt.stepover, tol = options.tol](const Layer& layer) mutable {
        spiral.stepover = line_distance(stepover, 2 * layer.tool_radius);
        return plan::spiral::plan_spiral(layer, spiral, tol);
      });
}

}  // namespace

const std::vector<std::string>& strategy_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"auto", "zigzag", "spiral", "adaptive", "tour"};
    for (const auto& method : kContourMethods) all.emplace_back(method.name);
    return all;
  }();
  return names;
}

const std::vector<std::string>& contour_method_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& method : kContourMethods) all.emplace_back(method.name);
    return all;
  }();
  return names;
}

std::optional<plan::contour::StepRule> published_rule(const std::string& strategy) {
  const auto* method = contour_method(strategy);
  const bool steps_alone = method != nullptr && (method->residuals == plan::contour::ResidualRule::kNone ||
                                                 method->residuals == plan::contour::ResidualRule::kPassages);
  if (!steps_alone) return std::nullopt;
  return plan::contour::parse_step_rule(method->stepover);
}

std::optional<plan::contour::StepRule> contour_rule(const resolve::PlanOptions& options) {
  const auto* method = contour_method(options.strategy);
  if (method == nullptr || options.strategy == "contour") return std::nullopt;
  return plan::contour::parse_step_rule(options.stepover.value_or(method->stepover));
}

std::string description_of(const std::string& strategy) {
  if (const auto* method = contour_method(strategy)) return method->description;
  if (strategy == "adaptive") return "engagement limited, spiral and arcs";
  if (strategy == "spiral") return "smooth turns from contour to contour, without passages";
  if (strategy == "tour") return "a grid of places in the order a search finds best, then along the walls";
  if (strategy == "zigzag") return "parallel lines to and fro, then along the walls";
  return "the fastest that certifies clean";
}

Strategy strategy_for(const Attempt& attempt, const Operation& operation,
                      const resolve::PlanOptions& options) {
  if ((options.published_grid || options.published_solver) && options.strategy != "auto" &&
      attempt.strategy != "tour")
    throw InputError("--solver",
                     fmt::format("and --grid are for the strategy tour; '{}' has no grid", attempt.strategy));
  if (const auto* method = contour_method(attempt.strategy)) {
    return contour_strategy(*method, attempt, operation, options);
  }
  if (options.bisector_passages && options.strategy != "auto")
    throw InputError("--passage", fmt::format("is for contours; '{}' has none", attempt.strategy));
  if (attempt.strategy == "adaptive") return adaptive_strategy(operation, options);
  if (attempt.strategy == "spiral") return spiral_strategy(attempt, operation, options);
  if (attempt.strategy == "zigzag") return zigzag_strategy(attempt, operation, options);
  if (attempt.strategy == "tour") return tour_strategy(attempt, operation, options);
  throw InputError("--strategy", fmt::format("'{}' is unknown; use one of {}", attempt.strategy,
                                             fmt::join(strategy_names(), ", ")));
}

const std::vector<Attempt>& rival_attempts() {
  static const std::vector<Attempt> all{
      {"single", {}}, {"double", {}}, {"pwid", {}}, {"loops", {}}, {"lom-corrected", {}}};
  return all;
}

Attempts attempts_for(const resolve::PlanOptions& options) {
  const Attempt beside{"contour", options.stepover, !options.stepover}, plain{"contour", options.stepover};
  if (options.strategy == "contour") return {{beside}, {plain}};
  if (options.strategy != "auto") return {{{options.strategy, options.stepover}}, {}};
  Attempts attempts{{beside}, {plain, {"contour", "0.6"}, {"contour", "0.35"}}};
  if (options.engagement_deg) {
    // The others begin with a slot.
    attempts.contest = {{"adaptive", std::nullopt}};
    return attempts;
  }
  for (const char* name : {"zigzag", "spiral"}) attempts.contest.push_back({name, options.stepover});
  attempts.contest.push_back({"adaptive", std::nullopt});
  attempts.contest.push_back({"tour", options.stepover, false, true});
  return attempts;
}

}  // namespace clearcut::pipeline
