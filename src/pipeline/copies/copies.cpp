#include "pipeline/copies/copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/text/format.h"
#include "base/text/quantity.h"
#include "base/tolerances.h"
#include "model/section_names.h"
#include "pipeline/copies/nest.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/steps/certify.h"
#include "read/common/moved_part.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

/// More than that is no sheet of parts but a mistyped number.
constexpr int kMostCopies = 10'000;

std::optional<int> count_in(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 1) return std::nullopt;
  return value;
}

bool is_cut_out(const Feature& feature) {
  return feature.profile && feature.profile->closed && feature.profile->side == ProfileSide::kOutside;
}

/// What stays of a part, or is to be kept free for it.
Box box_of_part(const Part& part) {
  Box outlines, cut;
  for (const Feature& feature : part.features) {
    if (is_cut_out(feature)) outlines.add(box(feature.profile->line));
    cut.add(box(feature.target));
  }
  if (!outlines.empty()) return outlines;
  return part.stock ? part.stock->plan : cut;
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

/// Throws InputError where one copy's cutter comes into the box of the next.
void require_gap(double needed, double gap) {
  if (needed <= gap + kSamePlaceMm) return;
  const double rounded = std::ceil(needed * 100 - kSamePlaceMm) / 100;
  throw InputError("--gap",
                   fmt::format("{} mm between parts is less than the cutter needs beside one; give {} mm or "
                               "more, or entries and leads that stay in the kerf",
                               trimmed(gap, 3), trimmed(rounded, 2)));
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

/// Row by row there and back.
Places places_of(const Copies& copies, const Box& own) {
  const Vec2 pitch{own.width() + copies.gap, own.height() + copies.gap};
  Places places;
  for (int row = 0; row < copies.up; ++row)
    for (int k = 0; k < copies.across; ++k) {
      const int column = row % 2 == 0 ? k : copies.across - 1 - k;
      places.push_back({false, {column * pitch.x, row * pitch.y}});
    }
  return places;
}

NestQuestion question_of(const Sheet& sheet, const Box& own) {
  return {sheet.width, sheet.height, sheet.edge, sheet.gap, own.width(), own.height()};
}

Places places_of(const Sheet& sheet, const Box& own) {
  std::vector<NestPlace> found = nest(question_of(sheet, own));
  if (found.empty())
    throw InputError(
        "--nest", fmt::format("not one part of {} by {} mm fits on {} by {} mm with {} mm of its edge left "
                              "free",
                              trimmed(own.width(), 3), trimmed(own.height(), 3), trimmed(sheet.width, 3),
                              trimmed(sheet.height, 3), trimmed(sheet.edge, 3)));
  if (sheet.count && *sheet.count < static_cast<int>(found.size()))
    found.resize(static_cast<std::size_t>(*sheet.count));
  Places places;
  for (const NestPlace& one : found) {
    // The corner of the box that is the lower left one after the turn.
    const Vec2 corner = one.turned ? Vec2{-own.max.y, own.min.x} : own.min;
    places.push_back({one.turned, one.at - corner});
  }
  return places;
}

/// The block is the sheet, as thick as the part's own; where that is not stated, as deep as is cut.
void take_block(const Sheet& sheet, Part& part) {
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

/// Each tool does its work on all parts before the next comes in; every other tool begins where the one before ended.
Toolpath placed_by_tool(const Toolpath& one, const Places& places, int steps) {
  Toolpath all;
  bool back = false;
  const auto& sections = one.sections;
  for (std::size_t begin = 0; begin < sections.size();) {
    std::size_t end = begin + 1;
    while (end < sections.size() && sections[end].tool_number == sections[begin].tool_number) ++end;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const std::size_t k = back ? places.size() - 1 - n : n;
      for (std::size_t i = begin; i < end; ++i)
        all.sections.push_back(placed(sections[i], places[k], static_cast<int>(k) * steps));
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

/// What is placed anew on every sheet.
void refuse_for_checks(const resolve::PlanOptions& options) {
  refuse_for_copies(options);
  if (options.tabs.any())
    throw InputError("--tabs",
                     "of copies are placed by their plan; a program of copies is checked without them");
}

/// Parts on which no fault was found.
int clean_parts_of(const Findings& findings, int parts, int steps) {
  std::vector<bool> clean(static_cast<std::size_t>(parts), true);
  for (const FeatureFindings& feature : findings.features)
    if (feature.workingstep >= 0 && !feature.figures.clean)
      clean[static_cast<std::size_t>(feature.workingstep / steps)] = false;
  const bool any_of_none = std::any_of(findings.faults.begin(), findings.faults.end(),
                                       [](const Fault& fault) { return fault.feature.empty(); });
  return any_of_none ? 0 : static_cast<int>(std::count(clean.begin(), clean.end(), true));
}

}  // namespace

Copies parse_copies(const std::string& text, double gap) {
  const auto x = text.find_first_of("xX");
  const auto across = count_in(std::string_view(text).substr(0, x));
  const auto up = x == std::string::npos ? std::nullopt : count_in(std::string_view(text).substr(x + 1));
  if (!across || !up || *across > kMostCopies / *up)
    throw InputError("--copies " + text, "needs columns and rows, for example 3x2");
  if (!(gap >= 0)) throw InputError("--gap", "must be 0 mm or more");
  return {*across, *up, gap};
}

Sheet parse_sheet(const std::string& text) {
  const auto x = text.find_first_of("xX");
  const auto length = [](std::string_view word) { return length_in_mm(word); };
  const auto width = length(std::string_view(text).substr(0, x));
  const auto height = x == std::string::npos ? std::nullopt : length(std::string_view(text).substr(x + 1));
  if (!width || !height || !(*width > 0) || !(*height > 0))
    throw InputError("--nest " + text, "needs the width and height of the sheet, for example 600x400");
  Sheet sheet;
  sheet.width = *width;
  sheet.height = *height;
  return sheet;
}

namespace {

/// Plans the part once and places it.
PlannedCopies planned_at(PlanResult one, ResolvedPlan plan, const Places& places,
                         const std::optional<Sheet>& sheet, const std::string& told) {
  PlannedCopies out;
  out.parts = static_cast<int>(places.size());
  out.turned = static_cast<int>(
      std::count_if(places.begin(), places.end(), [](const auto& place) { return place.turned; }));
  const auto steps = static_cast<int>(plan.steps.size());
  const std::vector<ResolvedStep> of_one = plan.steps;
  for (int k = 1; k < out.parts; ++k) plan.steps.insert(plan.steps.end(), of_one.begin(), of_one.end());
  plan.part = sheet_of(plan.part, places);
  if (sheet) take_block(*sheet, plan.part);
  Toolpath toolpath = placed_by_tool(one.planned, places, steps);
  const SectionNames names(plan.part);
  for (Section& section : toolpath.sections) section.label = names.of(section.workingstep);

  PlanResult& result = out.result;
  result = std::move(one);
  const Diagnostics said = result.part.diagnostics;
  result.part = plan.part;
  result.part.diagnostics = said;
  out.sheet = plan.part.stock ? plan.part.stock->plan : swept_by(toolpath, plan.part);
  result.part.diagnostics.note("copies", told);
  certify(result, toolpath, plan);
  complete_verdict(toolpath, plan, result);
  out.clean_parts = clean_parts_of(result.findings, out.parts, steps);
  result.planned = std::move(toolpath);
  return out;
}

}  // namespace

Part sheet_of_copies(const Part& part, const resolve::PlanOptions& options, const Copies& copies) {
  refuse_for_checks(options);
  return sheet_of(part, places_of(copies, box_of_part(resolved_one(part, options).part)));
}

Part sheet_of_copies(const Part& part, const resolve::PlanOptions& options, const Sheet& sheet) {
  refuse_for_checks(options);
  Part all = sheet_of(part, places_of(sheet, box_of_part(resolved_one(part, options).part)));
  take_block(sheet, all);
  return all;
}

PlannedCopies plan_copies(const Part& part, const resolve::PlanOptions& options, const Copies& copies) {
  refuse_for_copies(options);
  PlanResult one = plan_part(part, options);
  ResolvedPlan plan = resolved_one(part, options);
  const Box own = box_of_part(plan.part);
  require_gap(overhang_of(own, swept_by(one.planned, plan.part), copies.across > 1, copies.up > 1),
              copies.gap);
  return planned_at(std::move(one), std::move(plan), places_of(copies, own), std::nullopt,
                    fmt::format("{} parts, {}x{}, {} mm apart; planned once and placed", copies.count(),
                                copies.across, copies.up, trimmed(copies.gap, 3)));
}

PlannedCopies plan_copies(const Part& part, const resolve::PlanOptions& options, const Sheet& sheet) {
  refuse_for_copies(options);
  PlanResult one = plan_part(part, options);
  ResolvedPlan plan = resolved_one(part, options);
  const Box own = box_of_part(plan.part);
  const Places places = places_of(sheet, own);
  if (places.size() > 1)
    require_gap(overhang_of(own, swept_by(one.planned, plan.part), true, true), sheet.gap);
  PlannedCopies out =
      planned_at(std::move(one), std::move(plan), places, sheet,
                 fmt::format("{} parts on {} by {} mm, {} mm apart; planned once and placed", places.size(),
                             trimmed(sheet.width, 3), trimmed(sheet.height, 3), trimmed(sheet.gap, 3)));
  out.wanted = sheet.count;
  out.at_most = most_by_area(question_of(sheet, own));
  return out;
}

}  // namespace clearcut::pipeline
