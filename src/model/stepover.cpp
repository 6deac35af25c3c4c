#include "model/stepover.h"

#include <charconv>
#include <optional>

#include "base/error.h"

namespace clearcut::inline model {
namespace {

using Kind = StepoverRule::Kind;

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0 && value < 1e9))
    return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const std::string& text) {
  throw InputError("stepover",
                   "'" + text +
                       "' is none; use a fraction of the diameter above 0 and at most 1, a length such as "
                       "3.5mm, lom, rho, second, lom-corrected, rho-corrected, widest, or several with "
                       "commas, one a contour");
}

std::optional<StepoverRule> named_rule(const std::string& text) {
  if (text == "widest") return StepoverRule{};
  if (text == "lom" || text == "kappa") return StepoverRule{Kind::kKappa, 0};
  if (text == "lom-corrected" || text == "kappa-corrected") return StepoverRule{Kind::kKappaCorrected, 0};
  const auto colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const auto kind = name == "rho"             ? std::optional(Kind::kRho)
                    : name == "second"        ? std::optional(Kind::kSecondAngle)
                    : name == "rho-corrected" ? std::optional(Kind::kRhoCorrected)
                                              : std::nullopt;
  if (!kind) return std::nullopt;
  const auto w = colon == std::string::npos ? 1.0 : number_in(text.substr(colon + 1));
  return w ? std::optional(StepoverRule{*kind, *w}) : std::nullopt;
}

StepoverRule single_rule(const std::string& text) {
  if (const auto rule = named_rule(text)) return *rule;
  const bool mm = text.ends_with("mm");
  const auto value = number_in(mm ? text.substr(0, text.size() - 2) : text);
  if (!value || *value <= 0 || (!mm && *value > 1)) refuse(text);
  return {mm ? Kind::kMm : Kind::kFraction, *value};
}

}  // namespace

StepoverRule parse_step_rule(const std::string& text) {
  if (text.find(',') == std::string::npos) return single_rule(text);
  StepoverRule rule;
  rule.kind = Kind::kPerContour;
  for (std::size_t from = 0; from <= text.size();) {
    const auto comma = std::min(text.find(',', from), text.size());
    rule.contours.push_back(single_rule(text.substr(from, comma - from)));
    from = comma + 1;
  }
  return rule;
}

Stepover parse_stepover(const std::string& text) {
  return text.empty() ? Stepover{} : Stepover{text, parse_step_rule(text)};
}

}  // namespace clearcut::inline model
