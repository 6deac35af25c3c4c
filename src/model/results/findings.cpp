#include "model/results/findings.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <string_view>

namespace clearcut::inline model {
namespace {

constexpr std::array kRows{
    // Facts that the program leaves to the control and to the operator.
    ConditionRow{"units"}, ConditionRow{"motion-mode"}, ConditionRow{"arc-centres"},
    ConditionRow{"decimal-point"}, ConditionRow{"dialect"}, ConditionRow{"start-position"},
    ConditionRow{"g#", "g55"}, ConditionRow{"g#-p#", "g54.1-p2"}, ConditionRow{"g#-h#", "g15-h2"},
    ConditionRow{"g80-spindle"}, ConditionRow{"cycle-dwell"}, ConditionRow{"datum-#", "datum-247"},
    ConditionRow{"g#-home", "g28-home"}, ConditionRow{"tool-in-spindle"},
    ConditionRow{"tool-length-h#", "tool-length-h5"}, ConditionRow{"tool-length-g#", "tool-length-g43.1"},
    ConditionRow{"tool-length-dl"}, ConditionRow{"tool-length-def"}, ConditionRow{"tool-length-off"},
    ConditionRow{"spindle-by-hand"}, ConditionRow{"speed-by-hand"}, ConditionRow{"tool-by-hand"},
    ConditionRow{"tool-change-height"}, ConditionRow{"block-delete"}, ConditionRow{"blending"},
    ConditionRow{"m#", "m6"}, ConditionRow{"stray-word"}, ConditionRow{"dwell"}, ConditionRow{"chip-load"},
    ConditionRow{"cutting-speed"}, ConditionRow{"stated-feed"}, ConditionRow{"stated-speed"},
    ConditionRow{"stated-peck"}, ConditionRow{"stated-dwell"}, ConditionRow{"rigid-tap"},
    ConditionRow{"oriented-retract"}, ConditionRow{"manual-retract"}, ConditionRow{"scaling"},
    ConditionRow{"far-move"}, ConditionRow{"ends-low"}, ConditionRow{"program-end"}, ConditionRow{"d#", "d1"},
    ConditionRow{"tool-name-#", "tool-name-1"}, ConditionRow{"parameter-#", "parameter-100"},
    ConditionRow{"measured-move"}, ConditionRow{"measured-value"},
    ConditionRow{"subprogram-#", "subprogram-1"}, ConditionRow{"compressor"},
    ConditionRow{"compensation-d#", "compensation-d1"}, ConditionRow{"compensation-t#", "compensation-t1"},
    ConditionRow{"compensation-corners"}, ConditionRow{"approach-height"}, ConditionRow{"do-after-break"},
    ConditionRow{"rtliof"}, ConditionRow{"h"}, ConditionRow{"cycle800"},
    // Facts unknown without a part.
    ConditionRow{"stock"}, ConditionRow{"below-stock"}, ConditionRow{"arc-radii"},
    ConditionRow{"cuts-nothing"},
    // Shapes of the part that the program does not make, or makes differently.
    ConditionRow{"out-of-reach"}, ConditionRow{"not-parted"}, ConditionRow{"not-as-drawn"},
    ConditionRow{"left-out"}, ConditionRow{"loose-part"}, ConditionRow{"not-followed"},
    ConditionRow{"leaning-walls"}, ConditionRow{"floors-meet"}, ConditionRow{"engraved-by-mill"},
    ConditionRow{"margin"}};

/// Whether `name` is the pattern with a number in place of each `#`.
bool fits(std::string_view pattern, std::string_view name) {
  std::size_t at = 0;
  for (const char wanted : pattern) {
    if (wanted != '#') {
      if (at == name.size() || name[at] != wanted) return false;
      ++at;
      continue;
    }
    const std::size_t first = at;
    while (at < name.size() && (std::isdigit(static_cast<unsigned char>(name[at])) || name[at] == '.')) ++at;
    if (at == first) return false;
  }
  return at == name.size();
}

}  // namespace

std::span<const ConditionRow> condition_rows() {
  return kRows;
}

bool is_condition(const std::string& name) {
  return std::any_of(kRows.begin(), kRows.end(),
                     [&](const ConditionRow& row) { return fits(row.name, name); });
}

namespace {

/// Relative error of the areas of arcs and offsets.
constexpr double kAreaError = 1e-4;

}  // namespace

bool is_nothing_in_reach(double unreachable_mm2, double whole_mm2) {
  return unreachable_mm2 >= (1 - kAreaError) * whole_mm2;
}

const std::vector<FaultRow>& fault_rows() {
  static const std::vector<FaultRow> kRows = {
      {.kind = FaultKind::kUncut,
       .name = "uncut",
       .rank = 28,
       .meaning = "reachable material left, thicker than the tolerance",
       .of_missing_cuts = true},
      {.kind = FaultKind::kGouge,
       .name = "gouge",
       .rank = 6,
       .meaning = "the part itself was cut: a wall, an island, or a floor cut too deep"},
      {.kind = FaultKind::kRapidInMaterial,
       .name = "rapid in material",
       .rank = 4,
       .meaning = "a rapid passes through stock"},
      {.kind = FaultKind::kPlungeTooFast,
       .name = "plunge too fast",
       .rank = 18,
       .meaning = "down into material faster than the tool's plunge feed, or steeper than the tool may"},
      {.kind = FaultKind::kTooDeep,
       .name = "too deep",
       .rank = 19,
       .meaning = "more axial depth in one pass than the stepdown allows (a level was never cut)"},
      {.kind = FaultKind::kOutsideTravel,
       .name = "outside travel",
       .rank = 24,
       .meaning = "beyond the machine's limits",
       .by_strategy = false},
      {.kind = FaultKind::kNoFeed,
       .name = "no feed",
       .rank = 26,
       .meaning = "a feed move without a feed",
       .has_length = false,
       .of_state = true},
      {.kind = FaultKind::kNothingCut,
       .name = "nothing cut",
       .rank = 27,
       .meaning = "a feature asked for is not cut at all",
       .has_length = false,
       .of_missing_cuts = true},
      {.kind = FaultKind::kWrongTool,
       .name = "wrong tool",
       .rank = 2,
       .meaning = "tool unknown, so nothing can be said",
       .has_length = false,
       .by_strategy = false,
       .of_state = true},
      {.kind = FaultKind::kToolLength,
       .name = "tool length",
       .rank = 14,
       .meaning = "the length in force is not that of the tool that cuts",
       .has_length = false,
       .by_strategy = false,
       .of_state = true},
      {.kind = FaultKind::kSpindleOff,
       .name = "spindle off",
       .rank = 15,
       .meaning =
           "a feed move in material while the spindle stands, has no speed or has not had its time to start",
       .has_length = false,
       .by_strategy = false,
       .of_state = true},
      {.kind = FaultKind::kSpindleDirection,
       .name = "spindle direction",
       .rank = 23,
       .meaning = "the spindle turns the wrong way for the tool",
       .has_length = false,
       .by_strategy = false,
       .of_state = true},
      {.kind = FaultKind::kSpindleSpeed,
       .name = "spindle speed",
       .rank = 22,
       .meaning = "above what the tool or the machine may, or below what the machine can",
       .has_length = false,
       .by_strategy = false,
       .of_state = true},
      {.kind = FaultKind::kBeyondFlutes,
       .name = "beyond flutes",
       .rank = 17,
       .meaning = "deeper than the flutes are long",
       .by_strategy = false,
       .of_state = true},
      {.kind = FaultKind::kBeyondStock,
       .name = "beyond stock",
       .rank = 16,
       .meaning = "below the bottom of the stock, farther than a way through needs",
       .by_strategy = false},
      {.kind = FaultKind::kOverEngagement,
       .name = "over engagement",
       .rank = 20,
       .meaning = "more of the cutter's circle in material than the limit asked for"},
      {.kind = FaultKind::kMissingTab,
       .name = "missing tab",
       .rank = 12,
       .meaning = "a tab that was asked for is cut away"},
      {.kind = FaultKind::kTabHeight,
       .name = "tab height",
       .rank = 13,
       .meaning = "a tab stands, but not as high as asked, or higher",
       .of_missing_cuts = true},
      {.kind = FaultKind::kThread,
       .name = "thread",
       .rank = 9,
       .meaning = "a milled thread of another pitch, hand or size, or cut across on the way in or out",
       .by_strategy = false,
       .of_missing_cuts = true},
      {.kind = FaultKind::kHolder,
       .name = "holder in material",
       .rank = 5,
       .meaning = "the holder or the shank runs into material that stands"},
      {.kind = FaultKind::kKeepOut,
       .name = "keep-out",
       .rank = 3,
       .meaning = "the tool or its holder comes where a clamp is"},
      {.kind = FaultKind::kLoosePart,
       .name = "loose part",
       .rank = 7,
       .meaning = "cut where a profile has cut the piece free before",
       .by_strategy = false},
      {.kind = FaultKind::kFeedTooFast,
       .name = "feed too fast",
       .rank = 25,
       .meaning = "above the machine's highest feed",
       .has_length = false,
       .by_strategy = false,
       .of_state = true},
      {.kind = FaultKind::kTapping,
       .name = "tapping",
       .rank = 8,
       .meaning =
           "a tap whose feed is not its pitch times the speed, or that does not turn back on its way out",
       .has_length = false,
       .by_strategy = false},
      {.kind = FaultKind::kStockToLeave,
       .name = "stock to leave",
       .rank = 11,
       .meaning = "stock that was to be left on a wall or a floor is cut away"},
      {.kind = FaultKind::kMoreThanItCuts,
       .name = "more than it cuts",
       .rank = 10,
       .meaning =
           "a tool takes more than its kind can: sideways, or straight down without the hole that it needs"},
      {.kind = FaultKind::kAboveReference,
       .name = "above the reference",
       .rank = 21,
       .meaning = "fed so that the load exceeds that of the reference by which feeds were asked to go",
       .by_strategy = false,
       .of_state = true},
      {.kind = FaultKind::kUnits,
       .name = "wrong units",
       .rank = 1,
       .meaning =
           "inches taken for mm, or the other way round: the program is 25.4 times too large or too small"}};
  return kRows;
}

const FaultRow& row_of(FaultKind kind) {
  return fault_rows()[static_cast<std::size_t>(kind)];
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

namespace {

/// Up to this number of reasons of one kind, each is listed; of more only the first, with the number of others: in a
/// sheet of hundreds of features all usually have one mistake as their cause.
constexpr std::size_t kFewAlike = 8;

struct Reason {
  std::string kind;
  std::string text;
};

/// The reasons, one per line; `others` is the noun for the number of further ones.
std::string lines_of(const std::vector<Reason>& reasons, std::string_view others) {
  std::map<std::string_view, std::size_t> count, told;
  for (const Reason& one : reasons) ++count[one.kind];
  std::string text;
  for (const Reason& one : reasons) {
    const std::size_t all = count[one.kind];
    if (all > kFewAlike && told[one.kind]++ > 0) continue;
    text += one.kind + ": " + one.text;
    if (all > kFewAlike)
      text += " (" + std::to_string(all - 1) + " more " + std::string(others) + " like it)";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string verdict_and_reasons(const Findings& findings) {
  std::vector<Reason> faults, conditions;
  for (const Fault& fault : findings.faults)
    if (fault.cause.empty()) faults.push_back({std::string(name_of(fault.kind)), fault.text});
  for (const Condition& one : open_conditions(findings)) {
    const std::string line = one.line > 0 ? " (line " + std::to_string(one.line) + ")" : "";
    conditions.push_back({"condition " + one.name, one.text + line});
  }
  return verdict_words(findings) + "\n" + lines_of(faults, "faults") + lines_of(conditions, "conditions");
}

namespace {

/// Text between the name and the reason.
const std::string kMark = " is not machined: ";

bool is_not_machined(const Diagnostic& item) {
  return item.severity == Severity::kSkipped && item.what.find(kMark) != std::string::npos;
}

std::string name_in(const Diagnostic& item) {
  return item.what.substr(0, item.what.find(kMark));
}

}  // namespace

void say_not_machined(Diagnostics& diagnostics, const std::string& where, const std::string& name,
                      const std::string& why) {
  diagnostics.skip(where, name + kMark + why);
}

std::vector<std::string> names_not_machined(const Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const Diagnostic& item : diagnostics.items()) {
    if (is_not_machined(item)) names.push_back(name_in(item));
  }
  return names;
}

void add_not_machined(const Diagnostics& diagnostics, Findings& findings) {
  std::vector<Fault> faults;
  for (const Diagnostic& item : diagnostics.items()) {
    if (!is_not_machined(item)) continue;
    Fault fault;
    fault.kind = FaultKind::kNothingCut;
    fault.feature = name_in(item);
    fault.text = item.where.empty() ? item.what : item.where + ": " + item.what;
    faults.push_back(std::move(fault));
  }
  if (faults.empty()) return;
  findings.all.clean = false;
  findings.faults.insert(findings.faults.begin(), faults.begin(), faults.end());
}

std::vector<Fault> told_faults(const Findings& findings) {
  std::vector<Fault> told;
  std::copy_if(findings.faults.begin(), findings.faults.end(), std::back_inserter(told),
               [](const Fault& fault) { return fault.cause.empty(); });
  return told;
}

}  // namespace clearcut::inline model
