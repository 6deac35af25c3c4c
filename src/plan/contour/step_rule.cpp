#include "plan/contour/step_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "plan/contour/contour.h"
#include "plan/contour/ring_band.h"

namespace clearcut::plan::contour {
namespace {

using Kind = StepRule::Kind;

/// mm. A path longer than the radius by less than this counts as without residual.
constexpr double kNoRest = 0.001;

/// mm; the overlap w. The published rule (CPO-rho eq. 8) has 1 mm, too much for small cutters: w is at most
/// R / 2.
double overlap_of(const StepRule& rule, double radius) {
  return std::min(rule.value, radius / 2);
}

/// kappa or rho of the contour for the angle used by the rule.
double coefficient(const Region& contour, const StepRule& rule, double radius) {
  switch (rule.kind) {
    case Kind::kKappa:
      return kappa(smallest_angle(contour));
    case Kind::kRho:
      return rho(smallest_angle(contour), radius, overlap_of(rule, radius));
    default:
      return rho(second_smallest_angle(contour), radius, overlap_of(rule, radius));
  }
}

double greatest_clearance(const std::vector<AxisPiece>& inside) {
  double most = 0;
  for (const auto& piece : inside) most = std::max(most, piece.high.clearance);
  return most;
}

double published_step(const RingNode& ring, const std::vector<AxisPiece>& inside, const StepRule& rule,
                      double radius) {
  const double share = coefficient(ring.contour, rule, radius), step = 2 * radius * share;
  const double to_centre = greatest_clearance(inside) - ring.level;  // A of CPO-kappa alg. 3
  return to_centre > radius && to_centre <= step ? 1.5 * radius * share : step;
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0 && value < 1e9))
    return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const std::string& text) {
  throw InputError(
      "stepover",
      "'" + text +
          "' is none; use a fraction of the diameter above 0 and at most 1 (or 40%), a length such as "
          "3.5mm, lom, rho, second, lom-corrected, rho-corrected, widest, or several with "
          "commas, one a contour");
}

std::optional<StepRule> named_rule(const std::string& text) {
  if (text == "widest") return StepRule{};
  if (text == "lom" || text == "kappa") return StepRule{Kind::kKappa, 0};
  if (text == "lom-corrected" || text == "kappa-corrected") return StepRule{Kind::kKappaCorrected, 0};
  const auto colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const auto kind = name == "rho"             ? std::optional(Kind::kRho)
                    : name == "second"        ? std::optional(Kind::kSecondAngle)
                    : name == "rho-corrected" ? std::optional(Kind::kRhoCorrected)
                                              : std::nullopt;
  if (!kind) return std::nullopt;
  const auto w = colon == std::string::npos ? 1.0 : number_in(text.substr(colon + 1));
  return w ? std::optional(StepRule{*kind, *w}) : std::nullopt;
}

StepRule single_rule(const std::string& text) {
  if (const auto rule = named_rule(text)) return *rule;
  const bool mm = text.ends_with("mm"), percent = text.ends_with("%");
  auto value = number_in(text.substr(0, text.size() - (mm ? 2 : percent ? 1 : 0)));
  if (value && percent) *value /= 100;
  if (!value || *value <= 0 || (!mm && *value > 1)) refuse(text);
  return {mm ? Kind::kMm : Kind::kFraction, *value};
}

}  // namespace

StepRule parse_step_rule(const std::string& text) {
  if (text.find(',') == std::string::npos) return single_rule(text);
  StepRule rule;
  rule.kind = Kind::kPerContour;
  for (std::size_t from = 0; from <= text.size();) {
    const auto comma = std::min(text.find(',', from), text.size());
    rule.contours.push_back(single_rule(text.substr(from, comma - from)));
    from = comma + 1;
  }
  return rule;
}

double step_after(const RingNode& ring, const std::vector<AxisPiece>& inside, const StepRule& rule,
                  double radius) {
  switch (rule.kind) {
    case Kind::kWidest:
      return 2 * radius;
    case Kind::kKappa:
    case Kind::kRho:
    case Kind::kSecondAngle:
      return published_step(ring, inside, rule, radius);
    case Kind::kKappaCorrected:
      return RingBand(inside, ring.level, radius).widest_step(radius);
    case Kind::kRhoCorrected:
      return RingBand(inside, ring.level, radius).widest_step(radius - overlap_of(rule, radius));
    case Kind::kFraction:
      return 2 * radius * rule.value;
    case Kind::kMm:
      return std::min(rule.value, 2 * radius);
    case Kind::kPerContour:
      break;
  }
  CLEARCUT_ASSERT(!rule.contours.empty());
  const auto index = std::min(static_cast<std::size_t>(ring.depth), rule.contours.size() - 1);
  return step_after(ring, inside, rule.contours[index], radius);
}

double step_past_reflex_corners(const RingNode& ring, const StepRule& rule, double radius) {
  if (rule.kind == Kind::kPerContour) {
    const auto index = std::min(static_cast<std::size_t>(ring.depth), rule.contours.size() - 1);
    return step_past_reflex_corners(ring, rule.contours[index], radius);
  }
  if (rule.kind != Kind::kKappaCorrected && rule.kind != Kind::kRhoCorrected)
    return std::numeric_limits<double>::infinity();
  const double reach = rule.kind == Kind::kKappaCorrected ? radius : radius - overlap_of(rule, radius);
  return radius + reach * base::sin(greatest_angle(ring.contour) / 2);
}

std::vector<ContourStep> contour_steps(const Regions& allowed, const StepRule& rule, double radius,
                                       double first_level, const Tolerances& tol) {
  std::vector<ContourStep> all, merged;
  for (const auto& region : allowed) {
    const auto step_of = [&](const RingNode& ring, const std::vector<AxisPiece>& inside) {
      return std::max(step_after(ring, inside, rule, radius), 1e-3 * radius);
    };
    for (const RingNode& ring : ring_tree(Clearance(region, tol), region, first_level, step_of, tol)) {
      const double step = ring.children.empty() ? 0 : ring.next_level - ring.level;
      all.push_back({ring.level, smallest_angle(ring.contour), step});
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const ContourStep& a, const ContourStep& b) { return a.from_wall < b.from_wall; });
  for (const ContourStep& one : all) {
    if (merged.empty() || one.from_wall - merged.back().from_wall >= kSamePlaceMm) {
      merged.push_back(one);
    } else if (one.smallest_angle < merged.back().smallest_angle) {
      merged.back() = one;
    }
  }
  return merged;
}

Rest worst_rest(const Regions& allowed, const StepRule& rule, double radius, const Tolerances& tol) {
  Rest worst;
  for (const auto& region : allowed) {
    const auto step_of = [&](const RingNode& ring, const std::vector<AxisPiece>& inside) {
      const double step = std::max(step_after(ring, inside, rule, radius), radius);
      const Rest rest = RingBand(inside, ring.level, radius).worst(step, radius + kNoRest);
      if (rest.length > worst.length) worst = rest;
      return step;
    };
    ring_tree(Clearance(region, tol), region, radius, step_of, tol);
  }
  return worst;
}

}  // namespace clearcut::plan::contour

namespace clearcut::plan {

std::optional<double> line_distance(const Stepover& stepover, double diameter) {
  using Kind = contour::StepRule::Kind;
  if (!stepover.is_given()) return std::nullopt;
  const contour::StepRule rule = contour::parse_step_rule(stepover.text);
  if (rule.kind == Kind::kWidest) return std::nullopt;
  if (rule.kind == Kind::kFraction) return rule.value * diameter;
  if (rule.kind == Kind::kMm) return rule.value;
  throw InputError("--stepover", fmt::format("'{}' is a rule for contours; give a fraction of the diameter "
                                             "or mm, for example 0.8 or 4.5mm",
                                             stepover.text));
}

}  // namespace clearcut::plan
