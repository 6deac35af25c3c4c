#include "options/idle.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <set>

#include "base/tolerances.h"
#include "geometry/contours/mitred_inset.h"

namespace clearcut::inline options {

Works work_of(const Part& part, const Workingstep& step) {
  const Feature& feature = feature_of(part, step);
  const Tool& tool = tool_of(part, step);
  if (makes_holes(tool) || is_formed(feature)) return kHoleMaking;
  if (feature.t_slot) return kUndercutting;
  if (feature.chamfer) return kChamfering;
  if (feature.carving) return kCarving;
  if (feature.profile) return feature.profile->side == ProfileSide::kOn ? kFollowing : kProfiling;
  return feature.hole_diameter && *feature.hole_diameter <= 2 * tool.diameter ? kBoring : kClearing;
}

namespace {

struct WorkName {
  Works work;
  const char* name;
};

constexpr std::array<WorkName, 8> kWorkNames{{{kClearing, "pockets, slots, steps and faces"},
                                              {kBoring, "round holes that are milled"},
                                              {kProfiling, "profiles"},
                                              {kFollowing, "lines to engrave"},
                                              {kCarving, "carvings"},
                                              {kChamfering, "chamfers"},
                                              {kUndercutting, "T-slots"},
                                              {kHoleMaking, "drilled holes"}}};

struct InputKindName {
  InputKinds kind;
  const char* one;      ///< "a STEP solid"
  const char* several;  ///< "STEP solids"
};

constexpr std::array<InputKindName, 7> kInputNames{
    {{kStepNcInput, "a STEP-NC program", "STEP-NC programs"},
     {kSolidInput, "a STEP solid", "STEP solids"},
     {kDxfInput, "a DXF drawing", "DXF drawings"},
     {kSvgInput, "an SVG drawing", "SVG drawings"},
     {kBoardInput, "a board's file", "Gerber and Excellon files"},
     {kOutlineInput, "an outline in JSON", "outlines in JSON"},
     {kSegmentsInput, "a file of segments", "files of segments"}}};

std::string served_by(unsigned inputs) {
  std::string names;
  for (const InputKindName& name : kInputNames) {
    if ((inputs & name.kind) == 0) continue;
    names += (names.empty() ? "" : ", ") + std::string(name.several);
  }
  return names;
}

bool any_step(const Situation& at,
              const std::function<bool(const Workingstep&, const ResolvedStep&)>& holds) {
  for (std::size_t i = 0; i < at.plan.part.workplan.size(); ++i)
    if (holds(at.plan.part.workplan[i], at.plan.steps[i])) return true;
  return false;
}

bool is_work(const Situation& at, const Workingstep& step, unsigned works) {
  return (work_of(at.plan.part, step) & works) != 0;
}

/// Whether the feature is cleared layer by layer with one strategy or another.
bool is_cleared(const Situation& at, const Workingstep& step) {
  return is_work(at, step, kClearing);
}

/// Whether a section of these works has such a move.
bool any_move(const Situation& at, unsigned works, const std::function<bool(const Move&)>& holds) {
  return std::any_of(at.toolpath.sections.begin(), at.toolpath.sections.end(), [&](const Section& section) {
    if (section.workingstep < 0) return false;
    const Workingstep& step = at.plan.part.workplan[static_cast<std::size_t>(section.workingstep)];
    return is_work(at, step, works) && std::any_of(section.moves.begin(), section.moves.end(), holds);
  });
}

bool is_ramp(const Move& move) {
  return move.kind == MoveKind::kRamp;
}

bool is_lead(const Move& move) {
  return move.kind == MoveKind::kLeadIn || move.kind == MoveKind::kLeadOut;
}

/// Whether the toolpath has cuts of a step of this kind.
bool any_operation(const Situation& at, OperationKind kind) {
  return std::any_of(at.toolpath.sections.begin(), at.toolpath.sections.end(), [&](const Section& section) {
    if (section.workingstep < 0 || section.moves.empty()) return false;
    return at.plan.part.workplan[static_cast<std::size_t>(section.workingstep)].operation.kind == kind;
  });
}

/// What the preparation of the part found to be without effect; "" if it has one.
std::string found_idle(const Situation& at, const char* option) {
  const auto found = at.plan.part.idle.find(option);
  return found == at.plan.part.idle.end() ? "" : found->second;
}

/// Whether a candidate was planned with a path other than the kept one.
bool is_planned(const CandidateResult& candidate, const StrategySelection& selection) {
  if (candidate.outcome == Outcome::kKept) return true;
  if (candidate.outcome == Outcome::kNotTried || candidate.outcome == Outcome::kCannotWin) return false;
  return std::none_of(
      selection.candidates.begin(), selection.candidates.end(), [&](const CandidateResult& other) {
        return other.outcome == Outcome::kKept && std::abs(other.feed_mm - candidate.feed_mm) < kRoundingMm;
      });
}

/// Names of the strategies planned for the cleared steps for which `counts` is true.
std::set<std::string> planned_strategies(const Situation& at,
                                         const std::function<bool(const Workingstep&)>& counts) {
  std::set<std::string> names;
  for (const StrategySelection& selection : at.selections) {
    if (selection.workingstep < 0 || selection.made_alike) continue;
    const Workingstep& step = at.plan.part.workplan[static_cast<std::size_t>(selection.workingstep)];
    if (!is_cleared(at, step) || !counts(step)) continue;
    for (const CandidateResult& candidate : selection.candidates)
      if (is_planned(candidate, selection)) names.insert(candidate.strategy);
  }
  return names;
}

bool is_any_step(const Workingstep& /*step*/) {
  return true;
}

std::string unless_planned(const Situation& at, std::initializer_list<const char*> wanted,
                           const char* whose) {
  const std::set<std::string> planned = planned_strategies(at, is_any_step);
  if (std::any_of(wanted.begin(), wanted.end(), [&](const char* name) { return planned.contains(name); }))
    return "";
  return fmt::format("it is for {}, and nothing is planned so; see --strategy", whose);
}

bool is_helix(const Move& move) {
  return move.kind == MoveKind::kRamp && move.path.is_arc();
}

std::string unless(bool has_effect, const char* reason) {
  return has_effect ? "" : reason;
}

}  // namespace

InputKinds input_kind_of(const Part& part) {
  if (part.is_solid) return kSolidInput;
  std::string extension = std::filesystem::path(part.source_file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  static const std::set<std::string> kSteps{".p21", ".stp", ".step", ".stpnc", ".238"};
  if (kSteps.contains(extension)) return kStepNcInput;
  if (extension == ".dxf") return kDxfInput;
  if (extension == ".svg") return kSvgInput;
  if (extension == ".json") return kOutlineInput;
  if (extension == ".edges") return kSegmentsInput;
  return kBoardInput;
}

std::string idle_on_input(const Row& row, InputKinds input) {
  if ((row.effect.inputs & input) != 0) return "";
  const auto name = std::find_if(kInputNames.begin(), kInputNames.end(),
                                 [&](const InputKindName& one) { return one.kind == input; });
  return fmt::format("has no effect on {}; it serves {}; leave it out", name->one,
                     served_by(row.effect.inputs));
}

unsigned works_of(const ResolvedPlan& plan) {
  unsigned works = 0;
  for (const Workingstep& step : plan.part.workplan) works |= work_of(plan.part, step);
  return works;
}

std::string names_of_works(unsigned works) {
  std::vector<std::string> names;
  for (const WorkName& one : kWorkNames)
    if ((works & one.work) != 0) names.emplace_back(one.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string idle_on_works(const Row& row, unsigned works) {
  if (works == 0 || (row.effect.works & works) != 0) return "";
  return "it serves " + names_of_works(row.effect.works) + ", and the part has none";
}

/// Through cuts of solids, and profiles of drawings, go deeper than the material.
std::string cuts_through_nothing(const Situation& at) {
  const Part& part = at.plan.part;
  const bool through = std::any_of(part.features.begin(), part.features.end(), [&](const Feature& feature) {
    if (!part.is_solid) return feature.profile && feature.profile->side != ProfileSide::kOn;
    return feature.through || (part.stock && feature.floor_z <= part.stock->z_bottom);
  });
  return unless(through, part.is_solid ? "nothing is cut through the material"
                                       : "the drawing has no profile beside an outline");
}

std::string frees_nothing(const Situation& at) {
  return found_idle(at, "skin");
}

std::string leaves_no_tabs(const Situation& at) {
  return found_idle(at, "tabs");
}

std::string without_tabs(const Situation& at) {
  if (!at.asked.tabs.any()) return "no tabs are asked for; see --tabs";
  return leaves_no_tabs(at);
}

std::string leaves_no_stock_on_walls(const Situation& at) {
  return unless(any_step(at, [](const Workingstep& step,
                                const ResolvedStep&) { return step.operation.allowance_side > 0; }),
                "nothing is made to which stock could be left on walls");
}

std::string leaves_no_stock_on_floors(const Situation& at) {
  return unless(any_step(at, [](const Workingstep& step,
                                const ResolvedStep&) { return step.operation.allowance_floor > 0; }),
                "nothing is made to which stock could be left on floors");
}

std::string loads_no_mill(const Situation& at) {
  return unless(any_step(at,
                         [&](const Workingstep& step, const ResolvedStep&) {
                           return is_work(at, step, kMilling) && mills_upright(tool_of(at.plan.part, step));
                         }),
                "it follows the engagement of end mills, and none cuts");
}

std::string follows_no_strategy(const Situation& at) {
  const std::string name = at.asked.strategy.value_or("auto");
  const bool along_outlines = name == "auto" || name == "contour";
  return unless(
      along_outlines || std::any_of(at.selections.begin(), at.selections.end(),
                                    [](const StrategySelection& one) { return !one.made_alike; }),
      "no pocket, slot, step or face is cleared; outlines and lines are cut along themselves, round "
      "holes along a helix");
}

/// Profiles and lines are entered along themselves, open sides from outside. Where an entry as asked has no room, that is
/// said elsewhere.
std::string enters_otherwise(const Situation& at) {
  const EntryKind asked = at.asked.entry.value_or(EntryKind::kPlunge);
  const bool from_above = any_step(at, [&](const Workingstep& step, const ResolvedStep&) {
    return is_work(at, step, kClearing | kBoring) && closed_all_round(feature_of(at.plan.part, step));
  });
  if (from_above) return "";
  const unsigned works =
      asked == EntryKind::kHelix ? kClearing | kBoring : kClearing | kBoring | kProfiling | kFollowing;
  const MoveKind entry = asked == EntryKind::kPlunge ? MoveKind::kPlunge : MoveKind::kRamp;
  return unless(
      any_move(at, works, [&](const Move& move) { return move.kind == entry; }),
      "nothing is entered from above so: outlines and lines are entered along themselves, open sides "
      "from outside");
}

std::string without_zigzag(const Situation& at) {
  return unless_planned(at, {"zigzag"}, "the strategy zigzag");
}

constexpr std::initializer_list<const char*> kContourMethods{
    "contour", "lom",   "rho",  "second", "lom-corrected", "rho-corrected",
    "fixed",   "loops", "pwid", "single", "double",        "bisectors"};

std::string without_contours(const Situation& at) {
  return unless_planned(at, kContourMethods, "the strategy contour and the published methods");
}

std::string without_reflex_corners(const Situation& at) {
  const auto has_reflex_corners = [&](const Workingstep& step) {
    const Feature& feature = feature_of(at.plan.part, step);
    return closed_all_round(feature) &&
           std::any_of(feature.target.begin(), feature.target.end(),
                       [](const Region& region) { return !has_arcs(region) && has_reflex_corner(region); });
  };
  const std::set<std::string> planned = planned_strategies(at, has_reflex_corners);
  return unless(std::any_of(std::begin(kContourMethods), std::end(kContourMethods),
                            [&](const char* name) { return planned.contains(name); }),
                "it is for contours of closed outlines without arcs that have reflex corners");
}

std::string without_start(const Situation& at) {
  const auto begins_there = [&](const Workingstep& step) {
    return !at.plan.start || contains(feature_of(at.plan.part, step).target, *at.plan.start);
  };
  std::set<std::string> planned = planned_strategies(at, begins_there);
  for (const char* other : {"zigzag", "spiral", "tour", "cover"}) planned.erase(other);
  return unless(
      !planned.empty(),
      "it is for contours and adaptive clearing, and what it lies in is planned otherwise; see --strategy");
}

std::string without_tour(const Situation& at) {
  return unless_planned(at, {"tour"}, "the strategy tour");
}

std::string without_objective(const Situation& at) {
  if (at.plan.objective.asks_load())
    return unless(std::any_of(at.selections.begin(), at.selections.end(),
                              [](const StrategySelection& selection) { return selection.planned() > 1; }),
                  "it chooses among several plans, and there is one; see --strategy auto, tour and cover");
  return unless_planned(at, {"tour", "cover"}, "the strategies tour and cover");
}

/// Carvings rise and sink along their outlines; these moves are no entries.
std::string without_ramps(const Situation& at) {
  return unless(any_move(at, kMilling & ~kCarving, is_ramp),
                "nothing is entered along a helix or a ramp; see --entry");
}

std::string without_helix(const Situation& at) {
  const bool asked = any_step(at, [&](const Workingstep& step, const ResolvedStep& resolved) {
    return is_cleared(at, step) && resolved.entry == EntryKind::kHelix &&
           closed_all_round(feature_of(at.plan.part, step));
  });
  return unless(asked || any_move(at, kClearing, is_helix),
                "nothing is entered along a helix; see --entry helix");
}

std::string enters_no_hole(const Situation& at) {
  const auto& holes = at.plan.part.predrilled;
  const bool used = std::any_of(holes.begin(), holes.end(), [&](const PredrilledHole& hole) {
    return any_step(at, [&](const Workingstep& step, const ResolvedStep&) {
      return is_work(at, step, kHoleMaking | kBoring | kClearing) &&
             contains(feature_of(at.plan.part, step).target, hole.center);
    });
  });
  return unless(used, "the hole lies in nothing that is entered from above");
}

std::string without_leads(const Situation& at) {
  const bool asked = any_step(at, [&](const Workingstep& step, const ResolvedStep& resolved) {
    return is_work(at, step, kMilling) && resolved.lead > 0;
  });
  if (!asked) return "no pass begins with a lead; see --lead";
  return unless(any_move(at, kAllWorks, is_lead), "no pass begins with a lead, since none has room");
}

std::string without_margin(const Situation& at) {
  return unless(at.plan.margin.has_value(), "no margin is asked for, see --margin");
}

std::string without_open_sides(const Situation& at) {
  return unless(any_step(at,
                         [&](const Workingstep& step, const ResolvedStep&) {
                           return is_cleared(at, step) && !closed_all_round(feature_of(at.plan.part, step));
                         }),
                "nothing that is cleared has an open side");
}

std::string without_links(const Situation& at) {
  return unless(
      any_move(at, kMilling & ~kCarving, [](const Move& move) { return move.kind == MoveKind::kLink; }),
      "no pass is linked to the next at depth");
}

std::string plunges_nowhere(const Situation& at) {
  return unless(any_move(at, kAllWorks, [](const Move& move) { return move.kind == MoveKind::kPlunge; }),
                "nothing is plunged into");
}

std::string without_slot_feed(const Situation& at) {
  return unless(any_step(at,
                         [](const Workingstep&, const ResolvedStep& step) {
                           return step.slot_feed.mm_per_min() != step.feed.mm_per_min();
                         }),
                "no feed for slots is asked for; see --slot-feed");
}

std::string without_feed_rule(const Situation& at) {
  if (!at.plan.feed_rule) return "feeds are as stated; see --feed-by";
  return loads_no_mill(at);
}

std::string has_one_mill(const Situation& at) {
  const auto& tools = at.plan.part.tools;
  return unless(std::count_if(tools.begin(), tools.end(), clears_floors) > 1,
                "there is one mill alone; give several with --tool");
}

std::string finishes_nothing(const Situation& at) {
  return unless(
      any_operation(at, OperationKind::kSideFinishing) || any_operation(at, OperationKind::kBottomFinishing),
      "no wall and no floor is there to be finished");
}

std::string finishes_no_walls(const Situation& at) {
  if (at.plan.finish != Finish::kWalls && at.plan.finish != Finish::kAll)
    return "no walls are finished; see --finish walls";
  return unless(any_operation(at, OperationKind::kSideFinishing), "no wall is there to be finished");
}

std::string writes_no_compensation(const Situation& at) {
  return unless(
      at.plan.post.wear.has_value(),
      "no path is compensated; plans write --compensation wear where --finish walls finishes walls");
}

std::string finishes_no_floor(const Situation& at) {
  if (at.plan.finish != Finish::kFloor && at.plan.finish != Finish::kAll)
    return "no floors are finished; see --finish floor";
  return unless(any_operation(at, OperationKind::kBottomFinishing), "no floor is there to be finished");
}

std::string without_leaning_walls(const Situation& at) {
  return unless(any_step(at,
                         [&](const Workingstep& step, const ResolvedStep&) {
                           return is_work(at, step, kClearing | kBoring) &&
                                  feature_of(at.plan.part, step).wall_slope.radians() > 0;
                         }),
                "no wall leans");
}

std::string makes_no_copies(const Situation& at) {
  return at.asked.copies.any() ? "" : "it lies between copies; add --copies or --nest";
}

std::string fills_no_sheet(const Situation& at) {
  return at.asked.copies.sheet ? "" : "no sheet is filled; add --nest";
}

std::string states_no_toolpaths(const Situation& at) {
  return unless(
      any_step(at, [](const Workingstep& step, const ResolvedStep&) { return step.stated_path.has_value(); }),
      "the file states no toolpaths");
}

std::string relieves_no_corner(const Situation& at) {
  return found_idle(at, "dogbones");
}

std::string plans_corners_otherwise(const Situation& at) {
  const bool uses = at.planner == MotionPlanner::kGrbl || at.planner == MotionPlanner::kMarlin;
  return unless(
      uses, "the control plans its corners by another rule; Grbl, grblHAL and Marlin by junction deviation");
}

std::string bears_on_no_feeds(const Situation& at) {
  if (at.asked.shop.material || at.plan.part.material) return "";
  const Machine& machine = at.plan.machine;
  return unless(any_step(at,
                         [&](const Workingstep&, const ResolvedStep& step) {
                           const bool at_top = step.spindle_rpm == machine.max_spindle_rpm &&
                                               step.spindle_rpm != kUsualTopRpm;
                           return at_top || step.spindle_rpm == machine.min_spindle_rpm ||
                                  step.feed == machine.max_feed;
                         }),
                "its speeds and power bear on feeds by material alone; see --material");
}

std::string changes_no_feeds(const Situation& at) {
  if (!at.asked.shop.material || (at.plan.material && at.plan.material->has_forces())) return "";
  const std::string& name = at.asked.shop.material.value_or("");
  return unless(
      std::any_of(at.plan.values.begin(), at.plan.values.end(),
                  [&](const ResolvedValue& value) { return value.source.text.starts_with(name + ":"); }),
      "every feed and speed is stated, and forces in this material are not known");
}

}  // namespace clearcut::inline options
