#include "pipeline/steps/worn_feeds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "link/sections/load_feeds.h"
#include "model/section_names.h"
#include "pipeline/steps/certify.h"
#include "pipeline/steps/program_conditions.h"
#include "pipeline/steps/section_order.h"
#include "read/gcode/program/program.h"
#include "verify/program/verify_options.h"

namespace clearcut::pipeline {
namespace {

/// The feed moves of the toolpath, in their order.
std::vector<Move*> feed_moves_of(Toolpath& toolpath) {
  std::vector<Move*> moves;
  for (Section& section : toolpath.sections)
    for (Move& move : section.moves)
      if (!is_rapid(move.kind)) moves.push_back(&move);
  return moves;
}

/// Feeds one move after the other at 1, 2, 3 ... mm/min: every move read from the program tells which planned move it is.
Toolpath numbered_by_feeds(Toolpath toolpath) {
  double number = 0;
  for (Move* const move : feed_moves_of(toolpath)) move->feed = MmPerMin::of(++number);
  return toolpath;
}

/// Of a move read from a program that numbered_by_feeds() wrote: the place among the feed moves.
std::size_t place_of(const Move& read) {
  return static_cast<std::size_t>(std::lround(read.feed.mm_per_min())) - 1;
}

/// What lowers the feeds of one section.
link::LoadFeeds lowered_feeds(const Section& section, const verify::LoadReference& reference) {
  link::LoadFeeds feeds;
  feeds.rule = reference.rule;
  feeds.reference = MmPerMin::of(reference.feed(section.workingstep, section.tool_number));
  feeds.cap = MmPerMin::of(reference.cap(section.workingstep, section.tool_number));
  feeds.divides = false;
  return feeds;
}

/// Lowers `moves`, the feed moves of the plan, to what cutters larger by `wear` allow on the paths of `read`.
void lower(const std::vector<Move*>& moves, Toolpath read, const Part& part, const ResolvedPlan& plan) {
  std::vector<double> radii;
  for (const Tool& tool : part.tools) radii.push_back(tool.radius());
  stock::Material material = material_at_start(part, plan.earlier, radii);
  const verify::LoadReference reference = load_reference_of(plan);
  for (Section& section : read.sections) {
    const Tool* const tool = tool_numbered(part.tools, section.tool_number);
    if (tool == nullptr) continue;
    if (!mills_upright(*tool)) {
      take_away(material, section, *tool);
      continue;
    }
    std::vector<std::size_t> places;
    for (Move& move : section.moves) {
      if (is_rapid(move.kind)) continue;
      places.push_back(place_of(move));
      move.feed = moves[places.back()]->feed;
    }
    link::set_load_feeds(section, *tool, lowered_feeds(section, reference), material);
    std::size_t next = 0;
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind)) continue;
      Move& planned = *moves[places[next++]];
      planned.feed = std::min(planned.feed, move.feed);
    }
  }
}

}  // namespace

void keep_load_when_worn(Toolpath& toolpath, const ResolvedPlan& plan) {
  if (!plan.feed_rule || !plan.post.wear) return;
  const Toolpath numbered = numbered_by_feeds(toolpath);
  const std::string program = unchecked_program(numbered, plan.part, plan);
  const std::vector<Move*> moves = feed_moves_of(toolpath);
  for (const double wear : {-plan.post.wear->range, plan.post.wear->range}) {
    try {
      Program read = read_back(program, numbered, plan, wear);
      const Part part = worn(plan.part, read.compensated_tools, wear);
      SectionNames(part).settle(read.toolpath);
      lower(moves, std::move(read.toolpath), part, plan);
    } catch (const InputError&) {
      return;  // The control stops there: the check of the program refuses it, with the end of the range.
    }
  }
}

}  // namespace clearcut::pipeline
