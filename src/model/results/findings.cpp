#include "model/results/findings.h"

#include <algorithm>
#include <iterator>

namespace clearcut::inline model {
namespace {

/// Of an area: what areas of arcs and offsets may be wrong by.
constexpr double kAreaError = 1e-4;

/// In the order of FaultKind.
constexpr const char* kFaultNames[] = {"uncut",
                                       "gouge",
                                       "rapid in material",
                                       "plunge too fast",
                                       "too deep",
                                       "outside travel",
                                       "no feed",
                                       "nothing cut",
                                       "wrong tool",
                                       "tool length",
                                       "spindle off",
                                       "spindle direction",
                                       "spindle speed",
                                       "beyond flutes",
                                       "beyond stock",
                                       "over engagement",
                                       "missing tab",
                                       "tab height",
                                       "thread",
                                       "holder in material",
                                       "keep-out",
                                       "loose part",
                                       "feed too fast",
                                       "tapping",
                                       "stock to leave",
                                       "more than it cuts",
                                       "above the reference",
                                       "wrong units"};
static_assert(std::size(kFaultNames) == static_cast<std::size_t>(FaultKind::kUnits) + 1);

}  // namespace

bool is_nothing_in_reach(double unreachable_mm2, double whole_mm2) {
  return unreachable_mm2 >= (1 - kAreaError) * whole_mm2;
}

const char* name_of(FaultKind kind) {
  return kFaultNames[static_cast<std::size_t>(kind)];
}

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kClean:
      return "CLEAN";
    case Verdict::kConditional:
      return "CONDITIONAL";
    case Verdict::kFaulty:
      return "FAULTY";
  }
  return "FAULTY";
}

Verdict verdict_of(const Findings& findings) {
  if (!findings.all.clean || !findings.faults.empty()) return Verdict::kFaulty;
  return open_conditions(findings).empty() ? Verdict::kClean : Verdict::kConditional;
}

std::string verdict_words(const Findings& findings) {
  const Verdict verdict = verdict_of(findings);
  const bool is_less = findings.without_part && verdict != Verdict::kFaulty;
  return std::string(name_of(verdict)) + (is_less ? " AS FAR AS CAN BE SAID WITHOUT A PART" : "");
}

std::vector<Condition> open_conditions(const Findings& findings) {
  std::vector<Condition> open;
  std::copy_if(findings.conditions.begin(), findings.conditions.end(), std::back_inserter(open),
               [](const Condition& one) { return one.met_by.empty(); });
  return open;
}

std::vector<std::string> accept_conditions(Findings& findings, const std::vector<std::string>& names) {
  std::vector<std::string> unknown;
  for (const std::string& name : names) {
    bool found = false;
    for (Condition& one : findings.conditions) {
      if (one.name != name) continue;
      found = true;
      if (one.met_by.empty()) one.met_by = "accepted";
    }
    if (!found) unknown.push_back(name);
  }
  return unknown;
}

std::string verdict_and_reasons(const Findings& findings) {
  std::string text = verdict_words(findings) + "\n";
  for (const Fault& fault : findings.faults)
    if (fault.cause.empty()) text += std::string(name_of(fault.kind)) + ": " + fault.text + "\n";
  for (const Condition& one : open_conditions(findings)) {
    text += "condition " + one.name + ": " + one.text;
    if (one.line > 0) text += " (line " + std::to_string(one.line) + ")";
    text += "\n";
  }
  return text;
}

}  // namespace clearcut::inline model
