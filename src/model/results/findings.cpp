#include "model/results/findings.h"

#include <algorithm>

namespace clearcut::inline model {
namespace {

/// Of an area: what areas of arcs and offsets may be wrong by.
constexpr double kAreaError = 1e-4;

}  // namespace

bool is_nothing_in_reach(double unreachable_mm2, double whole_mm2) {
  return unreachable_mm2 >= (1 - kAreaError) * whole_mm2;
}

const char* name_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::kUncut:
      return "uncut";
    case FaultKind::kGouge:
      return "gouge";
    case FaultKind::kRapidInMaterial:
      return "rapid in material";
    case FaultKind::kPlungeTooFast:
      return "plunge too fast";
    case FaultKind::kTooDeep:
      return "too deep";
    case FaultKind::kOutsideTravel:
      return "outside travel";
    case FaultKind::kNoFeed:
      return "no feed";
    case FaultKind::kNothingCut:
      return "nothing cut";
    case FaultKind::kWrongTool:
      return "wrong tool";
    case FaultKind::kToolLength:
      return "tool length";
    case FaultKind::kSpindleOff:
      return "spindle off";
    case FaultKind::kSpindleDirection:
      return "spindle direction";
    case FaultKind::kSpindleSpeed:
      return "spindle speed";
    case FaultKind::kBeyondFlutes:
      return "beyond flutes";
    case FaultKind::kBeyondStock:
      return "beyond stock";
    case FaultKind::kOverEngagement:
      return "over engagement";
    case FaultKind::kMissingTab:
      return "missing tab";
    case FaultKind::kTabHeight:
      return "tab height";
    case FaultKind::kThread:
      return "thread";
    case FaultKind::kHolder:
      return "holder in material";
    case FaultKind::kKeepOut:
      return "keep-out";
    case FaultKind::kTapping:
      return "tapping";
  }
  return "unknown";
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
    text += std::string(name_of(fault.kind)) + ": " + fault.text + "\n";
  for (const Condition& one : open_conditions(findings)) {
    text += "condition " + one.name + ": " + one.text;
    if (one.line > 0) text += " (line " + std::to_string(one.line) + ")";
    text += "\n";
  }
  return text;
}

}  // namespace clearcut::inline model
