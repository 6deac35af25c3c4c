#include "pipeline/margin.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text/format.h"
#include "base/tolerances.h"
#include "pipeline/steps/certify.h"
#include "verify/margin.h"

namespace clearcut::pipeline {
namespace {

std::string place_of(const FeatureMargin& least) {
  if (!least.at) return "";
  const std::string line = least.at->line > 0 ? fmt::format(", line {}", least.at->line) : "";
  return fmt::format(" at ({}, {}){}", trimmed(least.at->point.x, 3), trimmed(least.at->point.y, 3), line);
}

std::string not_asked_of(const Margin& margin) {
  if (margin.not_asked.empty()) return "";
  return fmt::format("; not found for {}, whose walls lean or whose shape its tool forms",
                     fmt::join(margin.not_asked, ", "));
}

}  // namespace

std::optional<Margin> margin_asked(const ProgramRead& program, const ResolvedPlan& plan, Findings& findings) {
  if (!plan.margin) return std::nullopt;
  verify::VerifyOptions asked = verify_options(plan);
  asked.control = &program.control;
  Margin margin = verify::margin_of(program.part, program.toolpath, asked, plan.margin->bounds);
  const FeatureMargin* const least = margin.least();
  if (least && least->mm < plan.margin->at_least - kRoundingMm) {
    Condition open;
    open.name = "margin";
    open.text =
        fmt::format("{}: {} mm were asked for", margin_line(margin), trimmed(plan.margin->at_least, 4));
    findings.conditions.push_back(std::move(open));
    accept_conditions(findings, plan.accept);
  }
  return margin;
}

std::string margin_line(const Margin& margin) {
  const FeatureMargin* const least = margin.least();
  if (!least) return "margin: of no feature" + not_asked_of(margin);
  const std::string what =
      least->limit == MarginLimit::kUncut
          ? fmt::format("{} mm would be left", trimmed(margin.bounds.uncut, 4))
          : fmt::format("the part would be cut {} mm too deep", trimmed(margin.bounds.gouge, 4));
  return fmt::format("margin: holds for {} mm of machine error; beyond it {} in {}{}{}",
                     trimmed(least->mm, 4), what, least->feature, place_of(*least), not_asked_of(margin));
}

}  // namespace clearcut::pipeline
