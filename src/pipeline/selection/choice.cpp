#include "pipeline/selection/choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace clearcut::pipeline {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

bool is_clean(const Figures* plan) {
  return plan != nullptr && plan->clean;
}

/// A plan that meets no material has no load.
CuttingLoad load_of(const Figures& figures, ObjectiveKind kind) {
  if (figures.load) return *figures.load;
  if (figures.engagement.max_deg <= 0) return {};
  throw InputError("--objective", fmt::format("{} is not known: spindle speed, teeth or feed are not stated",
                                              name_of(kind)));
}

double conventional_share(const Engagement& engagement) {
  const double sided = engagement.climb_mm + engagement.conventional_mm;
  return sided > 0 ? engagement.conventional_mm / sided : 0;
}

/// The unit of a quantity among several plans: the least that is above 0. A share is one already.
double unit_of(ObjectiveKind kind, const std::vector<const Figures*>& plans) {
  if (kind == ObjectiveKind::kClimb) return 1;
  double least = kNever;
  for (const Figures* plan : plans) {
    const double figure = is_clean(plan) ? figure_of(kind, *plan) : 0;
    if (figure > 0) least = std::min(least, figure);
  }
  return least < kNever ? least : 1;
}

}  // namespace

double figure_of(ObjectiveKind kind, const Figures& figures) {
  switch (kind) {
    case ObjectiveKind::kLength:
      return figures.feed_mm;
    case ObjectiveKind::kTurns:
      return figures.turns;
    case ObjectiveKind::kAngle:
      return figures.turn_angle_deg;
    case ObjectiveKind::kTime:
      return figures.time_s;
    case ObjectiveKind::kForce:
      return load_of(figures, kind).max_force_n;
    case ObjectiveKind::kEnergy:
      return load_of(figures, kind).energy_j;
    case ObjectiveKind::kWear:
      return load_of(figures, kind).wear;
    case ObjectiveKind::kClimb:
      return conventional_share(figures.engagement);
    case ObjectiveKind::kEngagement:
    case ObjectiveKind::kEngagementInverse:
    case ObjectiveKind::kEngagementExact:
      break;
  }
  throw InputError("--objective", fmt::format("{} is for the order of a tour alone", name_of(kind)));
}

std::vector<double> costs_of(const Objective& objective, const std::vector<const Figures*>& plans) {
  std::vector<double> costs;
  for (const Figures* plan : plans) costs.push_back(is_clean(plan) ? 0 : kNever);
  for (const ObjectiveTerm& term : objective.terms) {
    const double unit = objective.weighted ? unit_of(term.kind, plans) : 1;
    for (std::size_t i = 0; i < plans.size(); ++i) {
      if (is_clean(plans[i])) costs[i] += term.weight * figure_of(term.kind, *plans[i]) / unit;
    }
  }
  return costs;
}

}  // namespace clearcut::pipeline
