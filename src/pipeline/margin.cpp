#include "pipeline/margin.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text/format.h"
#include "verify/margin.h"

namespace clearcut::pipeline {
namespace {

template <typename Result>
Margin found_for(const Result& result, const resolve::PlanOptions& options, const MarginBounds& bounds) {
  verify::VerifyOptions asked;
  asked.tol = options.tol;
  asked.machine = options.machine;
  asked.threads = options.threads;
  asked.cancel = options.cancel;
  asked.control = &result.control;
  if (result.earlier) asked.earlier = &*result.earlier;
  return verify::margin_of(result.part, result.toolpath, asked, bounds);
}

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

Margin margin_of(const PlanResult& result, const resolve::PlanOptions& options, const MarginBounds& bounds) {
  return found_for(result, options, bounds);
}

Margin margin_of(const CheckResult& result, const resolve::PlanOptions& options, const MarginBounds& bounds) {
  return found_for(result, options, bounds);
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
