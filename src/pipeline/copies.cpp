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
#include "pipeline/run.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/steps/certify.h"
#include "post/post.h"
#include "read/common/moved_part.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

bool is_cut_out(const Feature& feature) {
  return feature.profile && feature.profile->closed && feature.profile->side == ProfileSide::kOutside;
}

/// What stays of a part, or is to be kept free for it: with its outlines what is cut apart from them.
Box box_of_part(const Part& part) {
  Box outlines, cut;
  for (const Feature& feature : part.features) {
    if (is_cut_out(feature)) outlines.add(box(feature.profile->line));
    cut.add(box(feature.target));
  }
  if (outlines.empty()) return part.stock ? part.stock->plan : cut;
  Box all = outlines;
  for (const Feature& feature : part.features) {
    const Box own = box(feature.target);
    if (!is_cut_out(feature) && !own.overlaps(outlines)) all.add(own);
  }
  return all;
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

using Places = std::vector<read::PlanPlacement>;

std::string numbered(const std::string& name, int copy) {
  return fmt::format("{}.{}", name, copy + 1);
}

/// The copies as one part: features and steps of the first, then of the second, and so on.
Part sheet_of(const Part& one, const Places& places) {
  Part sheet = one;
  sheet.features.clear();
  sheet.workplan.clear();
  sheet.predrilled.clear();
  for (std::size_t k = 0; k < places.size(); ++k) {
    Part copy = read::with_placement(one, places[k]);
    const auto first = static_cast<int>(sheet.features.size());
    for (Feature& feature : copy.features) {
      feature.name = numbered(feature.name, static_cast<int>(k));
      sheet.features.push_back(std::move(feature));
    }
    for (Workingstep& step : copy.workplan) {
      step.name = numbered(step.name, static_cast<int>(k));
      step.feature += first;
      sheet.workplan.push_back(std::move(step));
    }
    for (const PredrilledHole& hole : copy.predrilled) sheet.predrilled.push_back(hole);
    if (!sheet.stock) continue;
    if (k == 0) sheet.stock->plan = {};
    sheet.stock->plan.add(copy.stock->plan);
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
  std::optional<int> count;
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
      places.push_back({false, {column * pitch.x, row * pitch.y}});
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

Places places_on_sheet(const CopiesQuestion& question, const Box& own) {
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
  for (const NestPlace& one : found) {
    // The corner of the box that is the lower left one after the turn.
    const Vec2 corner = one.turned ? Vec2{-own.max.y, own.min.x} : own.min;
    places.push_back({one.turned, one.at - corner});
  }
  return places;
}

Places places_of(const CopiesQuestion& question, const Box& own) {
  Places places = question.fills_sheet ? places_on_sheet(question, own) : places_in_grid(question, own);
  if (question.step == 0) return places;
  for (read::PlanPlacement& place : places)
    place.by = {std::round(place.by.x / question.step) * question.step,
                std::round(place.by.y / question.step) * question.step};
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

/// Each tool does its work on all parts before the next comes in; every other tool begins where the one before ended.
PlacedPath placed_by_tool(const Toolpath& one, const Places& places, int steps) {
  PlacedPath all;
  bool back = false;
  const auto& sections = one.sections;
  for (std::size_t begin = 0; begin < sections.size();) {
    std::size_t end = begin + 1;
    while (end < sections.size() && sections[end].tool_number == sections[begin].tool_number) ++end;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const std::size_t k = back ? places.size() - 1 - n : n;
      for (std::size_t i = begin; i < end; ++i) {
        all.toolpath.sections.push_back(placed(sections[i], places[k], static_cast<int>(k) * steps));
        all.same_moves.push_back(2 * static_cast<int>(i) + (places[k].turned ? 2 : 1));
      }
    }
    back = !back;
    begin = end;
  }
  return all;
}

ResolvedPlan resolved_one(const Part& part, const resolve::PlanOptions& options) {
  return resolve::resolve_possible(part, options, strategies_of(options));
}

/// What is said of places on one part.
void refuse_for_copies(const resolve::PlanOptions& options) {
  if (options.earlier)
    throw InputError("--after", "what ran before was cut into one part, not into copies; leave it out");
  if (!options.predrilled.empty())
    throw InputError("--predrilled", "names places on one part; state such holes in the part's own file");
}

/// Numbers and spacings of tabs are those of each outline, which has its tabs at the same places on each copy.
void refuse_for_checks(const resolve::PlanOptions& options) {
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

/// Clamps on a sheet to fill are in its coordinates, not in those of the part that is planned.
std::vector<KeepOut> take_clamps(Part& part, resolve::PlanOptions& options) {
  std::vector<KeepOut> clamps = std::move(part.keep_outs);
  clamps.insert(clamps.end(), options.keep_outs.begin(), options.keep_outs.end());
  part.keep_outs.clear();
  options.keep_outs.clear();
  return clamps;
}

CopiesMade made_of(const CopiesQuestion& question, const Places& places, const Box& own) {
  CopiesMade made;
  made.parts = static_cast<int>(places.size());
  made.turned = static_cast<int>(
      std::count_if(places.begin(), places.end(), [](const auto& place) { return place.turned; }));
  made.gap = question.gap;
  made.wanted = question.count;
  if (question.fills_sheet) made.at_most = most_by_area(nest_question_of(question, own));
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

std::string told_of(const CopiesQuestion& question, std::size_t parts) {
  const std::string where = question.fills_sheet ? fmt::format("on {} by {} mm", trimmed(question.width, 3),
                                                               trimmed(question.height, 3))
                                                 : fmt::format("{}x{}", question.across, question.up);
  return fmt::format("{} parts, {}, {} mm apart; planned once and placed", parts, where,
                     trimmed(question.gap, 3));
}

/// Throws InputError where the program is the same without subprograms.
void refuse_idle_subprograms(const resolve::PlanOptions& options, const ResolvedPlan& plan,
                             const Toolpath& toolpath, const PlanResult& result) {
  if (!options.copies.subprograms || !options.refuse_idle) return;
  PostOptions plain = plan.post;
  plain.subprograms.clear();
  if (post::write_program(toolpath, result.part, plan.post) ==
      post::write_program(toolpath, result.part, plain))
    throw InputError(
        "--subprograms",
        "has no effect: there is one part, or all that is cut are holes by cycles; leave it out");
}

/// The path of the one part and its plan at all places; the plan becomes that of the sheet.
PlacedPath take_places(const Toolpath& one, ResolvedPlan& plan, const Places& places,
                       const CopiesQuestion& question) {
  const auto steps = static_cast<int>(plan.steps.size());
  const std::vector<ResolvedStep> of_one = plan.steps;
  for (std::size_t k = 1; k < places.size(); ++k)
    plan.steps.insert(plan.steps.end(), of_one.begin(), of_one.end());
  plan.part = sheet_of(plan.part, places);
  if (question.fills_sheet) {
    take_block(question, plan.part);
    plan.part.keep_outs = question.clamps;
  }
  PlacedPath path = placed_by_tool(one, places, steps);
  const SectionNames names(plan.part);
  for (Section& section : path.toolpath.sections) section.label = names.of(section.workingstep);
  return path;
}

}  // namespace

void require_copies(const CopiesOptions& copies) {
  if (copies.grid && copies.sheet)
    throw InputError("--nest", "fills a sheet, and --copies makes columns and rows; leave one of them out");
  if (!copies.any() && copies.subprograms)
    throw InputError("--subprograms", "are of copies; add --copies or --nest");
  if (!copies.any() && copies.gap) throw InputError("--gap", "lies between copies; add --copies or --nest");
  if (copies.sheet) return;
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
  made.clean_parts = any_of_none ? 0 : static_cast<int>(std::count(clean.begin(), clean.end(), true));
}

SheetOfCopies sheet_of_copies(const Part& part, const resolve::PlanOptions& options) {
  require_copies(options.copies);
  refuse_for_checks(options);
  CopiesQuestion question = question_of(options.copies);
  if (options.copies.subprograms) question.step = printed_step(options.post);
  question.gap = *options.copies.gap;
  Part bare = part;
  resolve::PlanOptions own = options;
  if (question.fills_sheet) question.clamps = take_clamps(bare, own);
  const Part resolved = resolved_one(bare, own).part;
  const Box box = box_of_part(resolved);
  if (options.tabs.any() && question.gap < gap_for_tabs(resolved))
    throw InputError("--tabs",
                     fmt::format("of parts {} mm apart are not checked: the kerfs of neighbours meet, and "
                                 "what is left between holds no tab; they are from {} mm on",
                                 trimmed(question.gap, 3), trimmed(gap_for_tabs(resolved), 3)));
  const Places places = places_of(question, box);
  SheetOfCopies sheet{sheet_of(bare, places), made_of(question, places, box)};
  if (question.fills_sheet) {
    take_block(question, sheet.part);
    sheet.part.keep_outs = part.keep_outs;
  }
  return sheet;
}

PlanResult plan_copies(const Part& part, const resolve::PlanOptions& options) {
  require_copies(options.copies);
  refuse_for_copies(options);
  if (options.copies.subprograms && !post::has_subprograms(options.post.dialect))
    throw InputError("--subprograms", options.post.dialect +
                                          " has none that stand in the program itself; leave it out, or name "
                                          "another control");
  CopiesQuestion question = question_of(options.copies);
  if (options.copies.subprograms) question.step = printed_step(options.post);
  Part bare = part;
  resolve::PlanOptions own = options;
  if (question.fills_sheet) question.clamps = take_clamps(bare, own);
  PlanResult result = plan_one_part(bare, own);
  ResolvedPlan plan = resolved_one(bare, own);
  const Box box = box_of_part(plan.part);
  const bool in_x = question.fills_sheet || question.across > 1,
             in_y = question.fills_sheet || question.up > 1;
  question.gap = gap_of(options.copies, overhang_of(box, swept_by(result.planned, plan.part), in_x, in_y));
  if (options.tabs.any() && !options.copies.gap)
    question.gap = std::max(question.gap, gap_for_tabs(plan.part));
  const Places places = places_of(question, box);
  const PlacedPath path = take_places(result.planned, plan, places, question);
  const Toolpath& toolpath = path.toolpath;
  if (options.copies.subprograms) plan.post.subprograms = path.same_moves;
  Diagnostics said = std::move(result.part.diagnostics);
  said.note("copies", told_of(question, places.size()));
  if (options.tabs.any() && places.size() > 1 && question.gap < gap_for_tabs(plan.part))
    said.doubt("copies", "loose-part",
               fmt::format(
                   "the kerfs of neighbours meet where parts are less than {} mm apart, so that tabs between "
                   "parts hold to nothing; what is cut free is held otherwise",
                   trimmed(gap_for_tabs(plan.part), 3)));
  result.part = plan.part;
  result.part.diagnostics = std::move(said);
  certify(result, toolpath, plan);
  complete_verdict(toolpath, plan, result);
  refuse_idle_subprograms(options, plan, toolpath, result);
  CopiesMade& made = result.copies.emplace(made_of(question, places, box));
  made.sheet = plan.part.stock ? plan.part.stock->plan : swept_by(toolpath, plan.part);
  count_clean_parts(result.findings, made);
  result.planned = toolpath;
  return result;
}

PlanResult plan_part(const Part& part, const resolve::PlanOptions& options) {
  require_copies(options.copies);
  return options.copies.any() ? plan_copies(part, options) : plan_one_part(part, options);
}

namespace {

/// Share of a rectangle by which sums of lengths may miss a whole number of them.
constexpr double kWhole = 1e-9;

/// How many rectangles of `side` fit into `length` with a gap between them. mm.
int fitting(double length, double side, double gap) {
  if (length < side * (1 - kWhole)) return 0;
  return static_cast<int>(std::floor((length + gap) / (side + gap) + kWhole));
}

/// A grid of rectangles, from its lower left corner, mm.
struct NestBlock {
  Vec2 at;
  int across = 0, up = 0;
  bool turned = false;
  int count() const { return across * up; }
};

NestBlock block_in(const NestQuestion& q, Vec2 at, double width, double height, bool turned) {
  const double w = turned ? q.part_height : q.part_width, h = turned ? q.part_width : q.part_height;
  return {at, fitting(width, w, q.gap), fitting(height, h, q.gap), turned};
}

void append(const NestBlock& block, const NestQuestion& q, std::vector<NestPlace>& places) {
  const double w = block.turned ? q.part_height : q.part_width,
               h = block.turned ? q.part_width : q.part_height;
  for (int row = 0; row < block.up; ++row)
    for (int k = 0; k < block.across; ++k) {
      const int column = row % 2 == 0 ? k : block.across - 1 - k;
      places.push_back({block.at + Vec2{column * (w + q.gap), row * (h + q.gap)}, block.turned});
    }
}

}  // namespace

std::vector<NestPlace> nest(const NestQuestion& q) {
  const Vec2 corner{q.edge, q.edge};
  const double width = q.width - 2 * q.edge, height = q.height - 2 * q.edge;
  NestBlock first, second;
  const auto consider = [&](const NestBlock& a, const NestBlock& b) {
    if (a.count() + b.count() > first.count() + second.count()) {
      first = a;
      second = b;
    }
  };
  for (const bool turned : {false, true}) {
    const NestBlock whole = block_in(q, corner, width, height, turned);
    consider(whole, {});
    const double w = turned ? q.part_height : q.part_width, h = turned ? q.part_width : q.part_height;
    for (int columns = 1; columns < whole.across; ++columns) {
      NestBlock left = whole;
      left.across = columns;
      const double used = columns * (w + q.gap);
      consider(left, block_in(q, corner + Vec2{used, 0}, width - used, height, !turned));
    }
    for (int rows = 1; rows < whole.up; ++rows) {
      NestBlock low = whole;
      low.up = rows;
      const double used = rows * (h + q.gap);
      consider(low, block_in(q, corner + Vec2{0, used}, width, height - used, !turned));
    }
    // All of one orientation, and what is left over beside or above them.
    const double across = whole.across * (w + q.gap), up = whole.up * (h + q.gap);
    consider(whole, block_in(q, corner + Vec2{across, 0}, width - across, height, !turned));
    consider(whole, block_in(q, corner + Vec2{0, up}, width, height - up, !turned));
  }
  std::vector<NestPlace> places;
  append(first, q, places);
  append(second, q, places);
  return places;
}

int most_by_area(const NestQuestion& q) {
  const double width = q.width - 2 * q.edge, height = q.height - 2 * q.edge;
  if (fitting(std::max(width, height), std::max(q.part_width, q.part_height), q.gap) == 0 ||
      fitting(std::min(width, height), std::min(q.part_width, q.part_height), q.gap) == 0)
    return 0;
  // Each takes its own area and that of the gaps to its right and above.
  return static_cast<int>(std::floor(
      (width + q.gap) * (height + q.gap) / ((q.part_width + q.gap) * (q.part_height + q.gap)) + kWhole));
}

}  // namespace clearcut::pipeline
