#include "pipeline/steps/section_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "features/derived_outlines.h"
#include "geometry/box.h"
#include "link/sections/load_feeds.h"
#include "order/search/solve.h"
#include "pipeline/steps/certify.h"
#include "post/post.h"
#include "stock/cutting_load.h"
#include "stock/material.h"
#include "verify/program/verify_options.h"

namespace clearcut::pipeline {
namespace {

/// Seconds of one core planned for the search, and its rounds: no clock, so that programs repeat.
constexpr double kEffort = 0.005;
constexpr long long kRounds = 3;
/// Greatest number of sections stored in all states of the search for few tool changes.
constexpr std::size_t kMostLooks = 200'000;

using Indices = std::vector<std::size_t>;

Vec2 begin_of(const Section& section) {
  return section.moves.front().path.from;
}

Vec2 end_of(const Section& section) {
  return section.moves.back().path.to;
}

Box swept_box(const Section& section, const Part& part) {
  Box swept;
  for (const Move& move : section.moves) {
    const Box path = move.path.box();
    swept.add(path.min);
    swept.add(path.max);
  }
  return swept.grown(tool_of(part, part.workplan[static_cast<std::size_t>(section.workingstep)]).radius());
}

/// The sections required before each section.
std::vector<Indices> predecessors(const std::vector<Section>& sections, const Part& part) {
  std::vector<Box> boxes;
  for (const Section& section : sections) boxes.push_back(swept_box(section, part));
  std::vector<Indices> before(sections.size());
  // Cut-outs that may free a piece come last, inner ones before outer ones in the order of the workplan.
  const auto frees = [&](std::size_t i) {
    const int index = part.workplan[static_cast<std::size_t>(sections[i].workingstep)].feature;
    if (index >= static_cast<int>(part.features.size())) return false;
    return features::may_free(
        feature_of(part, part.workplan[static_cast<std::size_t>(sections[i].workingstep)]), part);
  };
  for (std::size_t i = 0; i < sections.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (boxes[i].overlaps(boxes[j]) || (frees(i) && !frees(j))) before[i].push_back(j);
    }
  }
  return before;
}

/// Sections in turns of one tool each.
class ToolTurns {
 public:
  ToolTurns(const std::vector<Section>& sections, const std::vector<Indices>& before)
      : sections_(sections), before_(before) {}

  /// The least number of turns found by the search; if greedy use of the tool in the spindle needs no more, the
  /// greedy order.
  std::vector<Indices> fewest() const {
    std::vector<Indices> turns = in_the_order_given();
    std::set<int> tools;
    for (const Section& section : sections_) tools.insert(section.tool_number);
    if (turns.size() <= tools.size()) return turns;
    const auto fewer = search(turns.size());
    return fewer ? *fewer : turns;
  }

 private:
  /// Sections already cut, and their turns.
  struct State {
    std::vector<char> done;
    std::vector<Indices> turns;
  };

  State nothing_done() const { return {std::vector<char>(sections_.size(), 0), {}}; }

  bool is_ready(std::size_t i, const State& state) const {
    return !state.done[i] &&
           std::all_of(before_[i].begin(), before_[i].end(), [&](std::size_t j) { return state.done[j]; });
  }

  /// Adds a turn of all sections ready for the tool of `first`, and of sections waiting only for these; `first` must
  /// be ready.
  void add_turn(std::size_t first, State& state) const {
    Indices turn;
    // Sections waiting for another one come later in the list, so one test of each is enough.
    for (std::size_t i = first; i < sections_.size(); ++i) {
      if (sections_[i].tool_number != sections_[first].tool_number || !is_ready(i, state)) continue;
      state.done[i] = 1;
      turn.push_back(i);
    }
    state.turns.push_back(std::move(turn));
  }

  static bool is_complete(const State& state) {
    return std::all_of(state.done.begin(), state.done.end(), [](char done) { return done != 0; });
  }

  std::vector<Indices> in_the_order_given() const {
    State state = nothing_done();
    for (std::size_t first = 0; !is_complete(state); first = 0) {
      while (!is_ready(first, state)) ++first;
      add_turn(first, state);
    }
    return state.turns;
  }

  /// The first ready section of each tool.
  Indices choices(const State& state) const {
    Indices firsts;
    std::set<int> tools;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      if (tools.count(sections_[i].tool_number) == 0 && is_ready(i, state)) {
        tools.insert(sections_[i].tool_number);
        firsts.push_back(i);
      }
    }
    return firsts;
  }

  /// Turn by turn with every possible next tool: cutting everything possible with a tool is never worse. Nothing if
  /// the search finds no fewer than `most` turns, or if there are too many possibilities.
  std::optional<std::vector<Indices>> search(std::size_t most) const {
    std::vector<State> states{nothing_done()};
    for (std::size_t count = 1; count < most; ++count) {
      std::vector<State> next;
      std::set<std::vector<char>> known;
      for (const State& state : states) {
        for (const std::size_t first : choices(state)) {
          State one = state;
          add_turn(first, one);
          if (is_complete(one)) return one.turns;
          if (known.insert(one.done).second) next.push_back(std::move(one));
        }
      }
      if (next.size() * sections_.size() > kMostLooks) return std::nullopt;
      states = std::move(next);
    }
    return std::nullopt;
  }

  const std::vector<Section>& sections_;
  const std::vector<Indices>& before_;
};

double rapids(const Indices& turn, const std::vector<Section>& sections, std::optional<Vec2> at) {
  double sum = 0;
  for (const std::size_t i : turn) {
    if (at) sum += distance(*at, begin_of(sections[i]));
    at = end_of(sections[i]);
  }
  return sum;
}

/// A turn as a path through the middles between the sections' beginnings and ends; `at` is its first point.
order::Problem problem_of(const Indices& turn, const std::vector<Section>& sections,
                          const std::vector<Indices>& before, std::optional<Vec2> at) {
  order::Problem problem;
  problem.name = "sections";
  problem.shape = order::Shape::kOpenPath;
  for (const std::size_t i : turn)
    problem.points.push_back(lerp(begin_of(sections[i]), end_of(sections[i]), 0.5));
  for (std::size_t a = 0; a < turn.size(); ++a) {
    for (const std::size_t j : before[turn[a]]) {
      const auto b = std::find(turn.begin(), turn.end(), j);
      if (b != turn.end())
        problem.precedence.push_back({static_cast<int>(b - turn.begin()), static_cast<int>(a)});
    }
  }
  if (at) {
    problem.start = problem.size();
    problem.points.push_back(*at);
  }
  return problem;
}

Indices shorter(const Indices& turn, const std::vector<Section>& sections, const std::vector<Indices>& before,
                std::optional<Vec2> at) {
  if (turn.size() < (at ? 2 : 3)) return turn;
  order::SolveOptions options;
  options.stop.seconds = std::numeric_limits<double>::infinity();
  options.stop.effort = kEffort;
  options.stop.rounds = kRounds;
  const auto tour =
      order::solve(problem_of(turn, sections, before, at), *order::length_objective(), options).tour;
  Indices ordered;
  for (const int i : tour) {
    if (i < static_cast<int>(turn.size())) ordered.push_back(turn[static_cast<std::size_t>(i)]);
  }
  return rapids(ordered, sections, at) < rapids(turn, sections, at) ? ordered : turn;
}

/// Text of the section's moves without their place, if it only moves straight down and up at one place, like a cycle;
/// else "".
std::string cycle_of(const Section& section) {
  std::string text;
  for (const Move& move : section.moves) {
    if (!move.is_vertical() || move.path.from != begin_of(section)) return "";
    text += fmt::format("{} {} {} {};", static_cast<int>(move.kind), move.z_from, move.z_to,
                        move.feed.mm_per_min());
  }
  return text + fmt::format("{} {}", section.spindle_rpm, static_cast<int>(section.coolant));
}

/// The turn in groups of holes alike, in the order of their first ones; all other sections are one group. The whole
/// turn if a section must wait for one of another group.
std::vector<Indices> alike(const Indices& turn, const std::vector<Section>& sections,
                           const std::vector<Indices>& before) {
  std::vector<std::string> keys;
  std::vector<Indices> groups;
  std::map<std::size_t, std::size_t> group_of;
  for (const std::size_t i : turn) {
    const std::string key = cycle_of(sections[i]);
    const auto known = static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
    if (known == keys.size()) {
      keys.push_back(key);
      groups.emplace_back();
    }
    groups[known].push_back(i);
    group_of[i] = known;
  }
  for (const std::size_t i : turn) {
    for (const std::size_t j : before[i]) {
      const auto other = group_of.find(j);
      if (other != group_of.end() && other->second != group_of.at(i)) return {turn};
    }
  }
  return groups;
}

}  // namespace

std::vector<Section> in_short_order(std::vector<Section> sections, const Part& part, bool alike_together) {
  const auto before = predecessors(sections, part);
  std::vector<Section> out;
  std::optional<Vec2> at;
  for (const Indices& turn : ToolTurns(sections, before).fewest()) {
    const Indices whole = shorter(turn, sections, before, at);
    const auto groups = alike_together ? alike(whole, sections, before) : std::vector<Indices>{whole};
    for (const Indices& group : groups) {
      for (const std::size_t i : groups.size() == 1 ? whole : shorter(group, sections, before, at)) {
        at = end_of(sections[i]);
        out.push_back(std::move(sections[i]));
      }
    }
  }
  return out;
}

namespace {

/// mm below every floor.
constexpr double kBelow = 1;

void take_away_holes(stock::Material& material, const Part& part) {
  double bottom = part.top_z();
  for (const Feature& feature : part.features) bottom = std::min(bottom, feature.floor_z);
  for (const PredrilledHole& hole : part.predrilled) {
    const Edge down = Edge::line(hole.center, hole.center);
    material.add({down, part.top_z(), bottom - kBelow, MoveKind::kPlunge, {}, 0}, hole.diameter / 2);
  }
}

}  // namespace

void take_away(stock::Material& material, const Section& section, const Tool& tool) {
  for (const Move& move : section.moves)
    if (!is_rapid(move.kind)) stock::remove_cut(material, move, tool);
}

stock::Material material_at_start(const Part& part, const std::optional<Toolpath>& earlier,
                                  std::vector<double> radii) {
  for (const PredrilledHole& hole : part.predrilled) radii.push_back(hole.diameter / 2);
  stock::Material material(part.stock ? std::optional(part.stock->plan) : std::nullopt, part.top_z(), radii);
  take_away_holes(material, part);
  if (!earlier) return material;
  for (const Section& section : earlier->sections) {
    // Material not known to be cut counts as present; this can only lower feeds.
    const Tool* const tool = tool_numbered(part.tools, section.tool_number);
    if (tool && section.counts_below(part.top_z())) take_away(material, section, *tool);
  }
  return material;
}

namespace {

/// mm. Digits that move a path less than this change no chip.
constexpr double kFineDigits = 2e-4;

}  // namespace

void follow_load(Toolpath& toolpath, const ResolvedPlan& plan) {
  if (!plan.feed_rule) return;
  const Part& part = plan.part;
  const double rounding = post::rounding_of(plan.post) + (plan.post.arcs ? 0 : plan.tol.chord);
  const double displaced = rounding > kFineDigits ? rounding : 0;
  std::vector<double> radii;
  for (const Tool& tool : part.tools) radii.push_back(tool.radius() + 2 * displaced);
  stock::Material material = material_at_start(part, plan.earlier, radii);
  const verify::LoadReference reference = load_reference_of(plan);
  for (Section& section : toolpath.sections) {
    const Tool& tool = tool_of(part, part.workplan[static_cast<std::size_t>(section.workingstep)]);
    if (!mills_upright(tool)) {
      take_away(material, section, tool);
      continue;
    }
    MmPerMin cap = MmPerMin::of(reference.cap(section.workingstep, section.tool_number));
    if (plan.machine.max_feed && *plan.machine.max_feed < cap) cap = *plan.machine.max_feed;
    const ResolvedStep& step = plan.steps[static_cast<std::size_t>(section.workingstep)];
    const bool compensates = plan.post.wear && plan.post.wear->shifts(section.workingstep);
    link::set_load_feeds(
        section, tool,
        {*plan.feed_rule, MmPerMin::of(reference.feed(section.workingstep, section.tool_number)), cap,
         step.feed, plan.machine.acceleration, true, !compensates, displaced},
        material);
  }
}

}  // namespace clearcut::pipeline
