#include "pipeline/copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "model/section_names.h"
#include "options/copies_options.h"
#include "pipeline/job_options.h"
#include "pipeline/nesting/kinds.h"
#include "pipeline/nesting/one_kind.h"
#include "pipeline/nesting/several_kinds.h"
#include "pipeline/nesting/tool_runs.h"
#include "pipeline/run.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/steps/certify.h"
#include "post/post.h"
#include "read/common/moved_part.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

Box outlines_of(const Part& part) {
  Box outlines;
  for (const Feature& feature : part.features)
    if (is_cut_out(feature)) outlines.add(box(feature.profile->line));
  return outlines;
}

/// What is cut of a part apart from the outlines that are cut out; without outlines and block all of it.
std::vector<const Feature*> cut_beside(const Part& part, const Box& outlines) {
  std::vector<const Feature*> beside;
  if (outlines.empty() && part.stock) return beside;
  for (const Feature& feature : part.features)
    if (!is_cut_out(feature) && (outlines.empty() || !box(feature.target).overlaps(outlines)))
      beside.push_back(&feature);
  return beside;
}

/// What stays of a part, or is to be kept free for it: with its outlines what is cut apart from them.
Box box_of_part(const Part& part) {
  Box all = outlines_of(part);
  const auto beside = cut_beside(part, all);
  if (all.empty() && part.stock) return part.stock->plan;
  for (const Feature* const feature : beside) all.add(box(feature->target));
  return all;
}

/// A feature whose wall is a side of the part's box, so that beside it there must be material; null: there is none.
const Feature* wall_at_side(const Part& part, const Box& own, bool in_x, bool in_y) {
  const auto is_at = [](double a, double b) { return std::abs(a - b) < kSamePlaceMm; };
  for (const Feature* const feature : cut_beside(part, outlines_of(part))) {
    if (feature->kind != FeatureKind::kClosedPocket && feature->kind != FeatureKind::kInsideProfile) continue;
    const Box cut = box(feature->target);
    if ((in_x && (is_at(cut.min.x, own.min.x) || is_at(cut.max.x, own.max.x))) ||
        (in_y && (is_at(cut.min.y, own.min.y) || is_at(cut.max.y, own.max.y))))
      return feature;
  }
  return nullptr;
}

/// Where the cutter comes below the top of the work, its full width.
Box swept_by(const Toolpath& toolpath, const Part& part) {
  Box swept;
  for (const Section& section : toolpath.sections) {
    const Tool* const tool = tool_numbered(part.tools, section.tool_number);
    for (const Move& move : section.moves)
      if (tool && std::min(move.z_from, move.z_to) < part.top_z() - kSamePlaceMm)
        swept.add(move.path.box().grown(tool->radius()));
  }
  return swept;
}

/// By how much the cutter comes out of the box of its part, at the side where it does most, mm.
double overhang_of(const Box& part, const Box& swept, bool in_x, bool in_y) {
  double most = 0;
  if (in_x) most = std::max({most, part.min.x - swept.min.x, swept.max.x - part.max.x});
  if (in_y) most = std::max({most, part.min.y - swept.min.y, swept.max.y - part.max.y});
  return most;
}

/// mm between two parts: as stated, else `needed`. Throws InputError where one copy's cutter comes into the box of the next.
double gap_of(const CopiesOptions& copies, double needed) {
  const double enough = std::ceil(needed * 100 - kSamePlaceMm) / 100;
  const double gap = copies.gap.value_or(enough);
  if (needed > gap + kSamePlaceMm)
    throw InputError("--gap",
                     fmt::format("{} mm between parts is less than the cutter needs beside one; give {} mm "
                                 "or more, or entries and leads that stay in the kerf",
                                 trimmed(gap, 3), trimmed(enough, 2)));
  return gap;
}

Section placed(Section section, const read::PlanPlacement& place, int first_step) {
  for (Move& move : section.moves) {
    move.path.from = place.placed(move.path.from);
    move.path.to = place.placed(move.path.to);
    if (move.path.is_arc()) move.path.center = place.placed(move.path.center);
  }
  section.workingstep += first_step;
  return section;
}

/// Where one part lies, and which one it is.
struct PartPlace {
  std::size_t kind = 0;
  read::PlanPlacement at;
};
using Places = std::vector<PartPlace>;

std::string numbered(const std::string& name, int copy) {
  return fmt::format("{}.{}", name, copy + 1);
}

/// All features and steps of one part, numbered and placed.
void add_part(const Part& one, const read::PlanPlacement& place, int number, Part& sheet) {
  Part copy = read::with_placement(one, place);
  const auto first = static_cast<int>(sheet.features.size());
  for (Feature& feature : copy.features) {
    feature.name = numbered(feature.name, number);
    sheet.features.push_back(std::move(feature));
  }
  for (Workingstep& step : copy.workplan) {
    step.name = numbered(step.name, number);
    step.feature += first;
    sheet.workplan.push_back(std::move(step));
  }
  for (const PredrilledHole& hole : copy.predrilled) sheet.predrilled.push_back(hole);
  for (Region& region : copy.left_out) sheet.left_out.push_back(std::move(region));
  if (!copy.stock) return;
  if (!sheet.stock) sheet.stock = Stock{{}, copy.stock->z_bottom, copy.stock->z_top};
  sheet.stock->plan.add(copy.stock->plan);
}

/// The parts of all places as one part: features and steps of the first place, then of the second, and so on. `kinds`: one part of each.
Part sheet_of(const std::vector<const Part*>& kinds, const Places& places) {
  Part sheet = *kinds.front();
  sheet.features.clear();
  sheet.workplan.clear();
  sheet.predrilled.clear();
  sheet.left_out.clear();
  sheet.stock.reset();
  for (std::size_t k = 0; k < places.size(); ++k)
    add_part(*kinds[places[k].kind], places[k].at, static_cast<int>(k), sheet);
  for (std::size_t kind = 1; kind < kinds.size(); ++kind) {
    sheet.name += " + " + kinds[kind]->name;
    sheet.order_free = sheet.order_free && kinds[kind]->order_free;
  }
  return sheet;
}

/// What is asked, in numbers. mm.
struct CopiesQuestion {
  int across = 1, up = 1;  ///< of copies in columns and rows
  bool fills_sheet = false;
  double width = 0, height = 0;  ///< of the sheet to fill
  double edge = 0;
  double gap = 0;
  double step =
      0;  ///< places are whole multiples of it, so that subprograms are rounded alike at each; 0: any
  std::optional<int> count;     ///< of the first kind
  std::vector<KeepOut> clamps;  ///< on the sheet to fill
};

CopiesQuestion question_of(const CopiesOptions& copies) {
  CopiesQuestion question;
  if (copies.grid) {
    const auto counts = counts_of_copies(*copies.grid);
    if (!counts) throw InputError("--copies " + *copies.grid, "needs columns and rows, for example 3x2");
    std::tie(question.across, question.up) = *counts;
  }
  if (copies.sheet) {
    const auto size = size_of_sheet(*copies.sheet);
    if (!size)
      throw InputError("--nest " + *copies.sheet,
                       "needs the width and height of the sheet, for example 600x400");
    std::tie(question.width, question.height) = *size;
    question.fills_sheet = true;
  }
  question.edge = copies.edge.value_or(0);
  question.count = copies.count;
  return question;
}

/// Row by row there and back.
Places places_in_grid(const CopiesQuestion& question, const Box& own) {
  const Vec2 pitch{own.width() + question.gap, own.height() + question.gap};
  Places places;
  for (int row = 0; row < question.up; ++row)
    for (int k = 0; k < question.across; ++k) {
      const int column = row % 2 == 0 ? k : question.across - 1 - k;
      places.push_back({0, {false, {column * pitch.x, row * pitch.y}}});
    }
  return places;
}

NestQuestion nest_question_of(const CopiesQuestion& question, const Box& own) {
  return {question.width, question.height, question.edge, question.gap, own.width(), own.height()};
}

/// Whether a part there is no nearer to a clamp than the gap.
bool is_beside_clamps(const NestPlace& place, const CopiesQuestion& question, const Box& own) {
  Box taken;
  taken.add(place.at);
  taken.add(place.at + (place.turned ? Vec2{own.height(), own.width()} : Vec2{own.width(), own.height()}));
  const Box kept = taken.grown(question.gap);
  return std::none_of(question.clamps.begin(), question.clamps.end(), [&](const KeepOut& clamp) {
    return clamp.plan.min.x < kept.max.x && kept.min.x < clamp.plan.max.x && clamp.plan.min.y < kept.max.y &&
           kept.min.y < clamp.plan.max.y;
  });
}

/// So that the corner of the box that is the lower left one after the turn comes to `at`.
read::PlanPlacement with_corner_at(Vec2 at, bool turned, const Box& own) {
  return {turned, at - (turned ? Vec2{-own.max.y, own.min.x} : own.min)};
}

Places places_of_one_kind(const CopiesQuestion& question, const Box& own) {
  std::vector<NestPlace> found = nest(nest_question_of(question, own));
  std::erase_if(found, [&](const NestPlace& one) { return !is_beside_clamps(one, question, own); });
  if (found.empty())
    throw InputError(
        "--nest",
        fmt::format("not one part of {} by {} mm fits on {} by {} mm with {} mm of its edge left free{}",
                    trimmed(own.width(), 3), trimmed(own.height(), 3), trimmed(question.width, 3),
                    trimmed(question.height, 3), trimmed(question.edge, 3),
                    question.clamps.empty() ? "" : ", beside the clamps"));
  if (question.count && *question.count < static_cast<int>(found.size()))
    found.resize(static_cast<std::size_t>(*question.count));
  Places places;
  for (const NestPlace& one : found) places.push_back({0, with_corner_at(one.at, one.turned, own)});
  return places;
}

/// How many of each kind have a place: "lid.dxf 4, box.dxf 0".
std::string counts_by_kind(const Kinds& kinds, const std::vector<KindPlace>& places) {
  std::string told;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    told += fmt::format("{}{} {}", kind == 0 ? "" : ", ", kinds[kind].name,
                        std::count_if(places.begin(), places.end(),
                                      [&](const KindPlace& place) { return place.kind == kind; }));
  return told;
}

/// Throws InputError for the first kind of which no part has a place.
void refuse_without_place(const CopiesQuestion& question, const Kinds& kinds, const std::vector<Box>& boxes,
                          const std::vector<KindPlace>& places) {
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    if (std::any_of(places.begin(), places.end(), [&](const KindPlace& one) { return one.kind == kind; }))
      continue;
    throw InputError(
        "--nest",
        fmt::format("not one part of {}, {} by {} mm, fits on {} by {} mm with {} mm of its edge left "
                    "free{} beside the others; of each kind there would be: {}",
                    kinds[kind].name, trimmed(boxes[kind].width(), 3), trimmed(boxes[kind].height(), 3),
                    trimmed(question.width, 3), trimmed(question.height, 3), trimmed(question.edge, 3),
                    question.clamps.empty() ? "" : ", beside the clamps and", counts_by_kind(kinds, places)));
  }
}

Places places_of_several_kinds(const CopiesQuestion& question, const Kinds& kinds,
                               const std::vector<Box>& boxes) {
  KindsQuestion asked{question.width, question.height, question.edge, question.gap, {}, {}};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    asked.kinds.push_back({boxes[kind].width(), boxes[kind].height(), kinds[kind].count});
  for (const KeepOut& clamp : question.clamps) asked.kept_free.push_back(clamp.plan);
  const std::vector<KindPlace> found = nest_kinds(asked);
  refuse_without_place(question, kinds, boxes, found);
  Places places;
  for (const KindPlace& one : found)
    places.push_back({one.kind, with_corner_at(one.at, one.turned, boxes[one.kind])});
  return places;
}

/// `boxes`: of one part of each kind.
Places places_of(const CopiesQuestion& question, const Kinds& kinds, const std::vector<Box>& boxes) {
  Places places = kinds.size() > 1       ? places_of_several_kinds(question, kinds, boxes)
                  : question.fills_sheet ? places_of_one_kind(question, boxes.front())
                                         : places_in_grid(question, boxes.front());
  if (question.step == 0) return places;
  for (PartPlace& place : places)
    place.at.by = {std::round(place.at.by.x / question.step) * question.step,
                   std::round(place.at.by.y / question.step) * question.step};
  return places;
}

/// mm; the last decimal of a program's coordinates.
double printed_step(const PostOptions& post) {
  return base::pow(10.0, -post::decimals_of(post)) * (post.inch ? kMmPerInch : 1);
}

/// The block is the sheet, as thick as the part's own; where that is not stated, as deep as is cut.
void take_block(const CopiesQuestion& sheet, Part& part) {
  Stock block;
  block.plan.add(Vec2{0, 0});
  block.plan.add(Vec2{sheet.width, sheet.height});
  block.z_top = block.z_bottom = part.top_z();
  for (const Feature& feature : part.features)
    block.z_bottom =
        std::min(block.z_bottom, feature.floor_z + (feature.profile ? feature.profile->beyond : 0));
  if (part.stock) {
    block.z_top = part.stock->z_top;
    block.z_bottom = part.stock->z_bottom;
  }
  part.stock = block;
}

/// The path of all parts, and of each of its sections which ones make the same moves elsewhere (PostOptions::subprograms).
struct PlacedPath {
  Toolpath toolpath;
  std::vector<int> same_moves;
};

/// The part of one kind, planned.
struct PlannedKind {
  PlanResult result;
  ResolvedPlan plan;
  Box box;
};

/// Consecutive sections with one tool, from the first to before the last.
struct ToolStay {
  int tool = 0;
  std::size_t begin = 0, end = 0;
};

std::vector<ToolStay> runs_of(const Toolpath& toolpath) {
  std::vector<ToolStay> runs;
  const auto& sections = toolpath.sections;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (runs.empty() || runs.back().tool != sections[i].tool_number)
      runs.push_back({sections[i].tool_number, i, i});
    runs.back().end = i + 1;
  }
  return runs;
}

/// The first workingstep of each place.
std::vector<int> first_steps(const std::vector<PlannedKind>& kinds, const Places& places) {
  std::vector<int> first;
  int next = 0;
  for (const PartPlace& place : places) {
    first.push_back(next);
    next += static_cast<int>(kinds[place.kind].plan.steps.size());
  }
  return first;
}

/// Each tool does its work on all parts before the next comes in; every other tool begins where the one before ended. The order of tools
/// is one for all kinds.
PlacedPath placed_by_tool(const std::vector<PlannedKind>& kinds, const Places& places) {
  std::vector<std::vector<ToolStay>> runs;
  std::vector<std::vector<int>> tools;
  std::vector<std::size_t> first_section{0};
  for (const PlannedKind& kind : kinds) {
    runs.push_back(runs_of(kind.result.planned));
    tools.emplace_back();
    for (const ToolStay& run : runs.back()) tools.back().push_back(run.tool);
    first_section.push_back(first_section.back() + kind.result.planned.sections.size());
  }
  const std::vector<int> first = first_steps(kinds, places);
  PlacedPath all;
  bool back = false;
  for (const SharedRun& shared : merged_runs(tools)) {
    std::vector<const ToolStay*> of_kind(kinds.size(), nullptr);
    for (const SharedRun::Share& share : shared.shares) of_kind[share.kind] = &runs[share.kind][share.run];
    for (std::size_t n = 0; n < places.size(); ++n) {
      const std::size_t k = back ? places.size() - 1 - n : n;
      const std::size_t kind = places[k].kind;
      if (!of_kind[kind]) continue;
      for (std::size_t i = of_kind[kind]->begin; i < of_kind[kind]->end; ++i) {
        all.toolpath.sections.push_back(
            placed(kinds[kind].result.planned.sections[i], places[k].at, first[k]));
        all.same_moves.push_back(2 * static_cast<int>(first_section[kind] + i) +
                                 (places[k].at.turned ? 2 : 1));
      }
    }
    back = !back;
  }
  return all;
}

ResolvedPlan resolved_one(const Part& part, const PlanOptions& options) {
  return resolve::resolve_possible(part, options, strategies_of(options));
}

/// What is said of places on one part.
void refuse_for_copies(const PlanOptions& options) {
  if (options.earlier)
    throw InputError("--after", "what ran before was cut into one part, not into copies; leave it out");
  if (!options.predrilled.empty())
    throw InputError("--predrilled", "names places on one part; state such holes in the part's own file");
}

/// Files of further parts are read before anything is planned.
void refuse_unread(const PlanOptions& options) {
  if (options.copies.with.size() > options.nested.size())
    throw InputError("--nest-with", options.copies.with[options.nested.size()] +
                                        " is not read; give its part in PlanOptions::nested");
  if (!options.nested.empty() && !options.copies.sheet)
    throw InputError("--nest-with", "lies on a sheet that is filled; add --nest");
}

/// Numbers and spacings of tabs are those of each outline, which has its tabs at the same places on each copy.
void refuse_for_checks(const PlanOptions& options) {
  refuse_for_copies(options);
  if (!options.tabs.at.empty())
    throw InputError("--tab-at",
                     "names places on one part; a program of copies is checked with --tabs or --tab-spacing");
  if (!options.copies.gap)
    throw InputError("--gap",
                     "is missing; a program of copies is checked with the gap that it was made with");
}

/// mm; of the cutter that leaves the widest one round a part.
double widest_kerf(const Part& part) {
  double widest = 0;
  for (const Workingstep& step : part.workplan)
    if (is_cut_out(feature_of(part, step))) widest = std::max(widest, tool_of(part, step).diameter);
  return widest;
}

/// mm; from this gap on each part has a web of its own beyond its kerf, which its tabs hold to.
double gap_for_tabs(const Part& part) {
  constexpr double kLeastWeb = 0.1;
  return 2 * widest_kerf(part) + kLeastWeb;
}

/// Says that tabs of parts `gap` mm apart do not hold, where that is less than `for_tabs`.
void doubt_tabs_between(double gap, double for_tabs, Diagnostics& said) {
  if (gap >= for_tabs) return;
  said.doubt(
      "copies", "loose-part",
      fmt::format("the kerfs of neighbours meet where parts are less than {} mm apart, so that tabs between "
                  "parts hold to nothing; what is cut free is held otherwise",
                  trimmed(for_tabs, 3)));
}

/// mm; a thinner wall is none.
constexpr double kLeastWall = 0.1;

/// Throws InputError where a pocket's own wall would have no thickness: at the sheet's edge, or beside another part.
void refuse_without_walls(const CopiesQuestion& question, const Part& part, const Box& own) {
  const Feature* const at_edge = question.fills_sheet ? wall_at_side(part, own, true, true) : nullptr;
  if (at_edge && question.edge < kLeastWall)
    throw InputError("--edge",
                     fmt::format("{} mm leave no wall of {} at the edge of the sheet, where its part ends; "
                                 "give the thickness of the wall",
                                 trimmed(question.edge, 3), at_edge->name));
  const Feature* const beside = wall_at_side(part, own, question.fills_sheet || question.across > 1,
                                             question.fills_sheet || question.up > 1);
  if (beside && question.gap < kLeastWall)
    throw InputError(
        "--gap", fmt::format("{} mm between parts leave no wall of {}, with which its part ends; give the "
                             "thickness of the wall",
                             trimmed(question.gap, 3), beside->name));
}

/// The box of one part where it lies.
Box placed_box(const Box& own, const read::PlanPlacement& place) {
  Box placed;
  placed.add(place.placed(own.min));
  placed.add(place.placed(own.max));
  return placed;
}

void count_by_kind(const Kinds& kinds, const Places& places, const std::vector<Box>& boxes,
                   CopiesMade& made) {
  for (const Kind& kind : kinds) made.kinds.push_back({kind.name, 0, 0, 0, kind.count});
  for (const PartPlace& place : places) {
    KindMade& kind = made.kinds[place.kind];
    ++kind.parts;
    kind.turned += place.at.turned ? 1 : 0;
    made.places.push_back({place.kind, placed_box(boxes[place.kind], place.at), place.at.turned});
  }
}

CopiesMade made_of(const CopiesQuestion& question, const Kinds& kinds, const Places& places,
                   const std::vector<Box>& boxes) {
  CopiesMade made;
  made.parts = static_cast<int>(places.size());
  made.turned = static_cast<int>(
      std::count_if(places.begin(), places.end(), [](const PartPlace& place) { return place.at.turned; }));
  made.gap = question.gap;
  if (kinds.size() > 1) {
    count_by_kind(kinds, places, boxes, made);
    return made;
  }
  made.wanted = question.count;
  if (question.fills_sheet) made.at_most = most_by_area(nest_question_of(question, boxes.front()));
  return made;
}

/// The copy that a feature of the sheet belongs to, from 0: "POCKET.2" and "POCKET.2_walls" are of the second.
std::optional<std::size_t> part_of_name(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  std::size_t number = 0;
  if (dot == std::string::npos) return std::nullopt;
  const auto [end, error] = std::from_chars(name.data() + dot + 1, name.data() + name.size(), number);
  if (error != std::errc{} || number == 0) return std::nullopt;
  return number - 1;
}

std::string told_of(const CopiesQuestion& question, const Kinds& kinds, std::size_t parts) {
  const std::string where = question.fills_sheet ? fmt::format("on {} by {} mm", trimmed(question.width, 3),
                                                               trimmed(question.height, 3))
                                                 : fmt::format("{}x{}", question.across, question.up);
  const std::string what = kinds.size() > 1 ? fmt::format("{} parts of {} kinds", parts, kinds.size())
                                            : fmt::format("{} parts", parts);
  return fmt::format("{}, {}, {} mm apart; {}planned once and placed", what, where, trimmed(question.gap, 3),
                     kinds.size() > 1 ? "each kind is " : "");
}

/// Throws InputError for an option that has an effect on none of several kinds.
void refuse_idle_for_all(const std::vector<PlannedKind>& kinds, const Kinds& asked) {
  std::vector<IdleOption> idle =
      idle_options(kinds.front().result, kinds.front().plan, asked.front().options);
  for (std::size_t kind = 1; kind < kinds.size(); ++kind) {
    const auto own = idle_options(kinds[kind].result, kinds[kind].plan, asked[kind].options);
    std::erase_if(idle, [&](const IdleOption& one) {
      return std::none_of(own.begin(), own.end(),
                          [&](const IdleOption& other) { return other.place == one.place; });
    });
  }
  if (!idle.empty()) throw InputError(idle.front().place, idle.front().reason);
}

/// Throws InputError where the program is the same without subprograms.
void refuse_idle_subprograms(const PlanOptions& options, const ResolvedPlan& plan, const Toolpath& toolpath,
                             const PlanResult& result) {
  if (!options.copies.subprograms || !options.refuse_idle) return;
  PostOptions plain = plan.post;
  plain.subprograms.clear();
  if (post::write_program(toolpath, result.part, plan.post) ==
      post::write_program(toolpath, result.part, plain))
    throw InputError(
        "--subprograms",
        "has no effect: there is one part, or all that is cut are holes by cycles; leave it out");
}

/// The plan of the sheet: that of the first kind, with the parts and steps of all places.
ResolvedPlan plan_of_sheet(const std::vector<PlannedKind>& kinds, const Places& places,
                           const CopiesQuestion& question) {
  ResolvedPlan plan = kinds.front().plan;
  plan.steps.clear();
  std::vector<const Part*> parts;
  for (const PlannedKind& kind : kinds) parts.push_back(&kind.plan.part);
  for (const PartPlace& place : places) {
    const auto& steps = kinds[place.kind].plan.steps;
    plan.steps.insert(plan.steps.end(), steps.begin(), steps.end());
  }
  plan.part = sheet_of(parts, places);
  if (question.fills_sheet) {
    take_block(question, plan.part);
    plan.part.keep_outs = question.clamps;
  }
  return plan;
}

/// The path of all parts, its sections named by their workingsteps.
PlacedPath path_of_sheet(const std::vector<PlannedKind>& kinds, const Places& places, const Part& sheet) {
  PlacedPath path = placed_by_tool(kinds, places);
  const SectionNames names(sheet);
  for (Section& section : path.toolpath.sections) section.label = names.of(section.workingstep);
  return path;
}

void say(const Diagnostic& one, const std::string& where, Diagnostics& all) {
  switch (one.severity) {
    case Severity::kNote:
      return all.note(where, one.what);
    case Severity::kRepair:
      return all.repair(where, one.what);
    case Severity::kWarning:
      return one.condition.empty() ? all.warn(where, one.what) : all.doubt(where, one.condition, one.what);
    case Severity::kSkipped:
      return all.skip(where, one.what);
  }
}

/// What was said of the parts of a kind beside the first, at its file.
void append_said(const Diagnostics& said, const std::string& name, Diagnostics& all) {
  const auto is_known = [&](const Diagnostic& one) {
    return std::any_of(all.items().begin(), all.items().end(), [&](const Diagnostic& known) {
      return known.where == one.where && known.what == one.what;
    });
  };
  for (const Diagnostic& one : said.items()) {
    const bool names_file = one.where.find(name) != std::string::npos;
    if (!is_known(one)) say(one, names_file ? one.where : name + ": " + one.where, all);
  }
}

/// What is known of the plans of all kinds, on the first part of each; only the findings are still those of one part.
PlanResult result_of(std::vector<PlannedKind>& kinds, const Kinds& asked, const Places& places) {
  PlanResult result = std::move(kinds.front().result);
  const std::vector<int> first = first_steps(kinds, places);
  for (std::size_t kind = 1; kind < kinds.size(); ++kind) {
    PlanResult& own = kinds[kind].result;
    const auto place =
        std::find_if(places.begin(), places.end(), [&](const PartPlace& one) { return one.kind == kind; });
    const int step = first[static_cast<std::size_t>(place - places.begin())];
    append_said(own.part.diagnostics, asked[kind].name, result.part.diagnostics);
    for (ResolvedValue& value : own.values) {
      if (value.step < 0) continue;
      value.step += step;
      result.values.push_back(std::move(value));
    }
    for (StrategySelection& one : own.selections) {
      if (one.workingstep >= 0) one.workingstep += step;
      result.selections.push_back(std::move(one));
    }
    for (ContourLevels& one : own.contours) result.contours.push_back(std::move(one));
  }
  return result;
}

/// The plan that a program of the sheet is checked with.
ResolvedPlan resolved_sheet(const Kinds& kinds, const Places& places, const CopiesQuestion& question,
                            const PlanOptions& asked) {
  std::vector<PlannedKind> resolved;
  for (const Kind& kind : kinds) {
    PlanOptions own = asked;
    own.keep_outs = kind.options.keep_outs;
    own.step_sources = kind.options.step_sources;
    own.step_published = kind.options.step_published;
    if (asked.tools.empty()) own.tool_cutting = kind.options.tool_cutting;
    resolved.push_back({{}, resolve::resolve(kind.part, own, strategies_of(asked)), {}});
  }
  ResolvedPlan plan = plan_of_sheet(resolved, places, question);
  for (std::size_t kind = 1; kind < kinds.size(); ++kind)
    append_said(resolved[kind].plan.part.diagnostics, kinds[kind].name, plan.part.diagnostics);
  return plan;
}

PlannedKind planned_kind(const Kind& kind) {
  PlannedKind planned{plan_one_part(kind.part, kind.options), resolved_one(kind.part, kind.options), {}};
  planned.box = box_of_part(planned.plan.part);
  return planned;
}

}  // namespace

void require_copies(const CopiesOptions& copies) {
  if (copies.grid && copies.sheet)
    throw InputError("--nest", "fills a sheet, and --copies makes columns and rows; leave one of them out");
  if (!copies.any() && copies.subprograms)
    throw InputError("--subprograms", "are of copies; add --copies or --nest");
  if (!copies.any() && copies.gap) throw InputError("--gap", "lies between copies; add --copies or --nest");
  if (copies.sheet) return;
  if (!copies.with.empty()) throw InputError("--nest-with", "lies on a sheet that is filled; add --nest");
  if (copies.edge) throw InputError("--edge", "is of a sheet that is filled; add --nest");
  if (copies.count) throw InputError("--count", "is of a sheet that is filled; add --nest");
}

void count_clean_parts(const Findings& findings, CopiesMade& made) {
  std::vector<bool> clean(static_cast<std::size_t>(made.parts), true);
  for (const FeatureFindings& feature : findings.features) {
    const std::optional<std::size_t> part = part_of_name(feature.name);
    if (part && *part < clean.size() && !feature.figures.clean) clean[*part] = false;
  }
  const bool any_of_none = std::any_of(findings.faults.begin(), findings.faults.end(),
                                       [](const Fault& fault) { return fault.feature.empty(); });
  if (any_of_none) clean.assign(clean.size(), false);
  made.clean_parts = static_cast<int>(std::count(clean.begin(), clean.end(), true));
  for (std::size_t k = 0; k < made.places.size(); ++k)
    made.kinds[made.places[k].kind].clean_parts += clean[k] ? 1 : 0;
}

SheetOfCopies sheet_of_copies(const Part& part, const PlanOptions& options) {
  require_copies(options.copies);
  refuse_unread(options);
  refuse_for_checks(options);
  CopiesQuestion question = question_of(options.copies);
  if (options.copies.subprograms) question.step = printed_step(options.post);
  question.gap = *options.copies.gap;
  const Kinds kinds = kinds_of(part, options, question.clamps);
  std::vector<Box> boxes;
  std::vector<const Part*> parts;
  double for_tabs = 0;
  for (const Kind& kind : kinds) {
    const Part resolved = resolved_one(kind.part, kind.options).part;
    boxes.push_back(box_of_part(resolved));
    refuse_without_walls(question, resolved, boxes.back());
    parts.push_back(&kind.part);
    for_tabs = std::max(for_tabs, gap_for_tabs(resolved));
  }
  const Places places = places_of(question, kinds, boxes);
  SheetOfCopies sheet{sheet_of(parts, places), made_of(question, kinds, places, boxes),
                      kinds.front().options.tool_cutting,
                      [kinds, places, question, for_tabs](const PlanOptions& asked) {
                        ResolvedPlan plan = resolved_sheet(kinds, places, question, asked);
                        if (asked.tabs.any() && places.size() > 1)
                          doubt_tabs_between(question.gap, for_tabs, plan.part.diagnostics);
                        return plan;
                      }};
  if (question.fills_sheet) {
    take_block(question, sheet.part);
    sheet.part.keep_outs = part.keep_outs;
  }
  return sheet;
}

PlanResult plan_copies(const Part& part, const PlanOptions& options) {
  require_copies(options.copies);
  refuse_unread(options);
  refuse_for_copies(options);
  if (options.copies.subprograms && !post::has_subprograms(options.post.dialect))
    throw InputError("--subprograms", options.post.dialect +
                                          " has none that stand in the program itself; leave it out, or name "
                                          "another control");
  CopiesQuestion question = question_of(options.copies);
  if (options.copies.subprograms) question.step = printed_step(options.post);
  const Kinds kinds = kinds_of(part, options, question.clamps);
  std::vector<PlannedKind> planned;
  std::vector<Box> boxes;
  const bool in_x = question.fills_sheet || question.across > 1,
             in_y = question.fills_sheet || question.up > 1;
  double overhang = 0, for_tabs = 0;
  for (const Kind& kind : kinds) {
    const PlannedKind& one = planned.emplace_back(planned_kind(kind));
    boxes.push_back(one.box);
    overhang =
        std::max(overhang, overhang_of(one.box, swept_by(one.result.planned, one.plan.part), in_x, in_y));
    for_tabs = std::max(for_tabs, gap_for_tabs(one.plan.part));
  }
  if (kinds.size() > 1 && options.refuse_idle) refuse_idle_for_all(planned, kinds);
  question.gap = gap_of(options.copies, overhang);
  if (options.tabs.any() && !options.copies.gap) question.gap = std::max(question.gap, for_tabs);
  for (const PlannedKind& one : planned) refuse_without_walls(question, one.plan.part, one.box);
  const Places places = places_of(question, kinds, boxes);
  ResolvedPlan plan = plan_of_sheet(planned, places, question);
  const PlacedPath path = path_of_sheet(planned, places, plan.part);
  const Toolpath& toolpath = path.toolpath;
  if (options.copies.subprograms) plan.post.subprograms = path.same_moves;
  PlanResult result = result_of(planned, kinds, places);
  Diagnostics said = std::move(result.part.diagnostics);
  said.note("copies", told_of(question, kinds, places.size()));
  if (options.tabs.any() && places.size() > 1) doubt_tabs_between(question.gap, for_tabs, said);
  result.part = plan.part;
  result.part.diagnostics = std::move(said);
  certify(result, toolpath, plan);
  complete_verdict(toolpath, plan, result);
  refuse_idle_subprograms(options, plan, toolpath, result);
  CopiesMade& made = result.copies.emplace(made_of(question, kinds, places, boxes));
  made.sheet = plan.part.stock ? plan.part.stock->plan : swept_by(toolpath, plan.part);
  count_clean_parts(result.findings, made);
  result.planned = toolpath;
  return result;
}

PlanResult plan_part(const Part& part, const PlanOptions& options) {
  require_copies(options.copies);
  return options.copies.any() ? plan_copies(part, options) : plan_one_part(part, options);
}

}  // namespace clearcut::pipeline
