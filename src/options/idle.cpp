#include "options/idle.h"

#include <fmt/format.h>

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
namespace {

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

bool any_move(const Situation& at, const std::function<bool(const Move&)>& holds) {
  for (const Section& section : at.toolpath.sections)
    if (std::any_of(section.moves.begin(), section.moves.end(), holds)) return true;
  return false;
}

bool is_drilled(const Situation& at, const Workingstep& step) {
  const Tool& tool = tool_of(at.plan.part, step);
  return makes_holes(tool) || is_formed(feature_of(at.plan.part, step));
}

bool is_milled(const Situation& at, const Workingstep& step) {
  return !is_drilled(at, step);
}

/// Whether a mill bores the hole along one helix, with any strategy.
bool is_bored(const Situation& at, const Workingstep& step) {
  const Feature& feature = feature_of(at.plan.part, step);
  return feature.hole_diameter && *feature.hole_diameter <= 2 * tool_of(at.plan.part, step).diameter;
}

/// Whether the feature is cleared layer by layer with one strategy or another.
bool is_cleared(const Situation& at, const Workingstep& step) {
  const Feature& feature = feature_of(at.plan.part, step);
  return is_milled(at, step) && !is_bored(at, step) && !feature.profile && !feature.chamfer &&
         !feature.carving && !feature.t_slot;
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
    if (selection.workingstep < 0) continue;
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

/// Through cuts of solids, and profiles of drawings, go deeper than the material.
std::string cuts_through_nothing(const Situation& at) {
  const Part& part = at.plan.part;
  const bool through = std::any_of(part.features.begin(), part.features.end(), [&](const Feature& feature) {
    if (!part.is_solid) return feature.profile.has_value();
    return feature.through || (part.stock && feature.floor_z <= part.stock->z_bottom);
  });
  return unless(through,
                part.is_solid ? "nothing is cut through the material" : "the drawing has no profile");
}

std::string frees_nothing(const Situation& at) {
  const auto& features = at.plan.part.features;
  return unless(std::any_of(features.begin(), features.end(),
                            [](const Feature& feature) { return feature.profile.has_value(); }),
                "the part has no profile and no line through the material that would cut a piece free");
}

std::string without_tabs(const Situation& at) {
  const std::string nothing = frees_nothing(at);
  if (!nothing.empty()) return nothing;
  return unless(at.asked.tabs.any(), "no tabs are asked for; see --tabs");
}

std::string mills_nothing(const Situation& at) {
  return unless(any_step(at, [&](const auto& step, const auto&) { return is_milled(at, step); }),
                "nothing is milled, all is made along the tool's axis");
}

std::string clears_nothing(const Situation& at) {
  return unless(any_step(at, [&](const auto& step, const auto&) { return is_cleared(at, step); }),
                "no pocket, slot, step or face is cleared");
}

std::string without_zigzag(const Situation& at) {
  return unless_planned(at, {"zigzag"}, "the strategy zigzag");
}

std::string without_contours(const Situation& at) {
  return unless_planned(at,
                        {"contour", "lom", "rho", "second", "lom-corrected", "rho-corrected", "fixed",
                         "loops", "pwid", "single", "double", "bisectors"},
                        "the strategy contour and the published methods");
}

std::string without_reflex_corners(const Situation& at) {
  const auto has_reflex_corners = [&](const Workingstep& step) {
    const Regions& target = feature_of(at.plan.part, step).target;
    return std::any_of(target.begin(), target.end(),
                       [](const Region& region) { return !has_arcs(region) && has_reflex_corner(region); });
  };
  const std::set<std::string> planned = planned_strategies(at, has_reflex_corners);
  const std::set<std::string> published{"lom", "rho", "second", "fixed"};
  return unless(std::any_of(planned.begin(), planned.end(),
                            [&](const std::string& name) { return published.contains(name); }),
                "it is for lom, rho, second and fixed on outlines without arcs that have reflex corners");
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

std::string without_ramps(const Situation& at) {
  return unless(any_move(at, [](const Move& move) { return move.kind == MoveKind::kRamp; }),
                "nothing is entered along a helix or a ramp; see --entry");
}

std::string without_helix(const Situation& at) {
  const bool asked = any_step(at, [&](const Workingstep& step, const ResolvedStep& resolved) {
    return is_milled(at, step) && !is_bored(at, step) && resolved.entry == EntryKind::kHelix;
  });
  const bool any =
      std::any_of(at.toolpath.sections.begin(), at.toolpath.sections.end(), [&](const Section& section) {
        const auto step = static_cast<std::size_t>(section.workingstep);
        return section.workingstep >= 0 && !is_bored(at, at.plan.part.workplan[step]) &&
               std::any_of(section.moves.begin(), section.moves.end(), is_helix);
      });
  return unless(asked || any, "nothing is entered along a helix; see --entry helix");
}

std::string enters_no_hole(const Situation& at) {
  const auto& holes = at.plan.part.predrilled;
  const bool used = std::any_of(holes.begin(), holes.end(), [&](const PredrilledHole& hole) {
    return std::any_of(
        at.plan.part.features.begin(), at.plan.part.features.end(), [&](const Feature& feature) {
          return std::any_of(feature.target.begin(), feature.target.end(),
                             [&](const Region& region) { return region.contains(hole.center); });
        });
  });
  return unless(used, "the hole lies in nothing that is cut");
}

std::string without_leads(const Situation& at) {
  return unless(
      any_step(at, [&](const Workingstep& step,
                       const ResolvedStep& resolved) { return is_milled(at, step) && resolved.lead > 0; }),
      "no pass begins with a lead; see --lead");
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
  return unless(any_move(at, [](const Move& move) { return move.kind == MoveKind::kLink; }),
                "no pass is linked to the next at depth");
}

std::string plunges_nowhere(const Situation& at) {
  return unless(any_move(at, [](const Move& move) { return move.kind == MoveKind::kPlunge; }),
                "nothing is plunged into");
}

std::string ramps_nowhere(const Situation& at) {
  return without_ramps(at);
}

std::string without_slot_feed(const Situation& at) {
  const std::string nothing = mills_nothing(at);
  if (!nothing.empty()) return nothing;
  return unless(any_step(at,
                         [](const Workingstep&, const ResolvedStep& step) {
                           return step.slot_feed.mm_per_min() != step.feed.mm_per_min();
                         }),
                "no feed for slots is asked for; see --slot-feed");
}

std::string without_feed_rule(const Situation& at) {
  const std::string nothing = mills_nothing(at);
  if (!nothing.empty()) return nothing;
  return unless(at.plan.feed_rule.has_value(), "feeds are as stated; see --feed-by");
}

std::string has_one_mill(const Situation& at) {
  const auto& tools = at.plan.part.tools;
  return unless(std::count_if(tools.begin(), tools.end(), clears_floors) > 1,
                "there is one mill alone; give several with --tool");
}

std::string finishes_no_walls(const Situation& at) {
  return unless(at.plan.finish == Finish::kWalls || at.plan.finish == Finish::kAll,
                "no walls are finished; see --finish walls");
}

std::string writes_no_compensation(const Situation& at) {
  return unless(
      at.plan.post.wear.has_value(),
      "no path is compensated; plans write --compensation wear where --finish walls finishes walls");
}

std::string finishes_no_floor(const Situation& at) {
  return unless(at.plan.finish == Finish::kFloor || at.plan.finish == Finish::kAll,
                "no floors are finished; see --finish floor");
}

std::string without_leaning_walls(const Situation& at) {
  return unless(any_step(at,
                         [&](const Workingstep& step, const ResolvedStep&) {
                           return is_milled(at, step) &&
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

namespace {

/// Whether two edges of a line meet at an angle.
bool has_corner(const Path& line) {
  constexpr double kTangent = 1e-3;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 in = line[i].tangent_at(1), out = line[i + 1].tangent_at(0);
    if (std::abs(cross(in, out)) > kTangent) return true;
  }
  return false;
}

}  // namespace

std::string has_no_corners(const Situation& at) {
  return unless(
      any_step(at,
               [&](const Workingstep& step, const ResolvedStep&) {
                 const Feature& feature = feature_of(at.plan.part, step);
                 if (is_drilled(at, step)) return false;
                 if (feature.profile) return has_corner(feature.profile->line);
                 return std::any_of(feature.target.begin(), feature.target.end(), [](const Region& region) {
                   return has_corner(region.outer()) ||
                          std::any_of(region.islands().begin(), region.islands().end(), has_corner);
                 });
               }),
      "no pocket and no profile has a corner");
}

std::string plans_corners_otherwise(const Situation& at) {
  const auto by_deviation = [](MotionPlanner planner) {
    return planner == MotionPlanner::kGrbl || planner == MotionPlanner::kMarlin;
  };
  const std::string& control = at.plan.post.dialect;
  const bool uses = at.plan.machine.planner ? by_deviation(*at.plan.machine.planner)
                                            : control == "grbl" || control == "marlin";
  return unless(uses, "the control plans its corners by another rule; Grbl and Marlin by junction deviation");
}

std::string bears_on_no_feeds(const Situation& at) {
  if (at.asked.shop.material) return "";
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
