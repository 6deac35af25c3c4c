#include "pipeline/infill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/progress.h"
#include "base/text.h"
#include "base/work_budget.h"
#include "geometry/contours/boolean.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/steps/step_work.h"
#include "post/laying_writer.h"
#include "read/gcode/laying.h"
#include "resolve/resolve.h"
#include "resolve/values/names.h"
#include "verify/coverage/laid_cover.h"

namespace clearcut::pipeline {
namespace {

/// Stepovers as shares of the width, the widest first: neighbours that just touch, and nearer ones for strategies that leave gaps then.
const std::vector<std::string> kStepovers{"1", "0.95", "0.9", "0.8", "0.7"};
/// Share of the width up to which gaps do not count, no more than tol.uncut.
constexpr double kGapShare = 0.02;
/// mm. Chords of arcs are no farther from them than this share of the permitted gap.
constexpr double kChordShare = 0.05;
/// mm; depth of the pocket that stands for the layer while it is planned. Any will do: it is one cut deep.
constexpr double kPlannedDepth = 1;
/// Area in squares of the line's width up to which auto tries strategies that search for an order: beyond it they take minutes.
constexpr double kMostSearched = 500;
/// E words are printed with five decimals.
constexpr double kFilamentRounding = 1e-5;

using Polyline = std::vector<Vec2>;

void refuse_nonsense(const InfillOptions& options) {
  const auto above_0 = [](double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value)) throw InputError(what, "must be above 0");
  };
  above_0(options.width, "width of the line");
  above_0(options.rate, options.word == LayingWord::kExtruded ? "filament" : "power");
  above_0(options.feed.mm_per_min(), "feed");
  above_0(options.travel.mm_per_min(), "feed of travel");
  if (!(options.most_over >= 0)) throw InputError("share laid over", "must not be below 0");
}

Regions areas_of(const Part& part, const Tolerances& tol) {
  Regions all;
  for (const Feature& feature : part.features) {
    if (feature.profile || feature.carving || feature.chamfer || feature.t_slot)
      throw InputError(feature.name, std::string("is no area to fill but ") + name_of(feature.kind) +
                                         "; leave it out, for drawings with --op ignore:" + feature.source);
    all.insert(all.end(), feature.target.begin(), feature.target.end());
  }
  if (all.empty()) throw InputError(part.source_file, "holds no area to fill");
  return unite_all(all, tol);
}

Tolerances tolerances_of(const InfillOptions& options) {
  Tolerances tol = options.plan.tol;
  tol.uncut = std::min(tol.uncut, kGapShare * options.width);
  return tol;
}

/// The areas as one pocket, to be cut in one layer by a cutter as wide as the line.
Part layer_of(const Part& part, const Regions& areas, const InfillOptions& options) {
  Part layer;
  layer.name = part.name;
  layer.source_file = part.source_file;
  Tool tool;
  tool.diameter = options.width;
  layer.tools.push_back(tool);
  Feature feature;
  feature.name = "layer";
  feature.target = feature.allowed = areas;
  feature.top_z = kPlannedDepth;
  layer.features.push_back(feature);
  Workingstep step;
  step.name = feature.name;
  step.operation.stepdown = kPlannedDepth;
  step.operation.stepover = 1;
  layer.workplan.push_back(step);
  return layer;
}

/// What a pass cuts, without its links.
void append_lines(const Pass& pass, double chord, std::vector<Polyline>& lines) {
  bool joins = false;
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    const bool cuts = pass.kinds.empty() || pass.kinds[i] == MoveKind::kCut;
    if (cuts && !joins) lines.push_back({pass.path[i].from});
    if (cuts) append_flattened(pass.path[i], chord, lines.back());
    joins = cuts;
  }
}

bool is_closed(const Polyline& line) {
  return line.size() > 3 && line.front() == line.back();
}

/// Lets a closed line begin at the corner nearest to `from`, and an open one at its nearer end. Returns the distance to it, mm.
double begin_near(Polyline& line, Vec2 from) {
  if (!is_closed(line)) {
    if (distance(line.back(), from) < distance(line.front(), from)) std::reverse(line.begin(), line.end());
    return distance(line.front(), from);
  }
  line.pop_back();
  const auto nearest = std::min_element(
      line.begin(), line.end(), [from](Vec2 a, Vec2 b) { return distance(a, from) < distance(b, from); });
  std::rotate(line.begin(), nearest, line.end());
  line.push_back(line.front());
  return distance(line.front(), from);
}

double distance_to(const Polyline& line, Vec2 from) {
  if (!is_closed(line)) return std::min(distance(line.front(), from), distance(line.back(), from));
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 p : line) least = std::min(least, distance(p, from));
  return least;
}

/// Always the nearest line next. One that begins where the last ends continues it.
std::vector<Polyline> in_short_order(std::vector<Polyline> lines, const Tolerances& tol) {
  std::vector<Polyline> ordered;
  while (!lines.empty()) {
    const Vec2 at = ordered.empty() ? lines.front().front() : ordered.back().back();
    const auto next = std::min_element(
        lines.begin(), lines.end(),
        [at](const Polyline& a, const Polyline& b) { return distance_to(a, at) < distance_to(b, at); });
    const double travel = begin_near(*next, at);
    if (!ordered.empty() && travel <= tol.coincident)
      ordered.back().insert(ordered.back().end(), next->begin() + 1, next->end());
    else
      ordered.push_back(std::move(*next));
    lines.erase(next);
  }
  return ordered;
}

/// Lines read back: middles of what is laid without a break.
std::vector<Path> lines_of(const read::gcode::LayingProgram& program) {
  std::vector<Path> lines;
  bool joins = false;
  for (const auto& move : program.moves) {
    if (move.lays && !joins) lines.emplace_back();
    if (move.lays) lines.back().push_back(move.path);
    joins = move.lays;
  }
  return lines;
}

void find_amounts(const read::gcode::LayingProgram& program, const InfillOptions& options,
                  LaidFindings& found) {
  for (const auto& move : program.moves) {
    const double mm = move.path.length();
    (move.lays ? found.laid_mm : found.travel_mm) += mm;
    if (move.feed.mm_per_min() > 0) found.time_s += mm / move.feed.mm_per_s();
    if (!move.lays) continue;
    const bool extrudes = program.word == LayingWord::kExtruded;
    found.amount = extrudes ? found.amount + move.word : std::max(found.amount, move.word);
    // The ends of the move are rounded like the amount is.
    const double wanted = extrudes ? options.rate * mm : options.rate;
    const double allowed = extrudes ? kFilamentRounding + 2e-4 * options.rate : 1e-3;
    if (std::abs(move.word - wanted) > allowed && found.faults.empty())
      found.faults.push_back(fmt::format("line {}: lays with {} {}, stated are {}", move.line,
                                         extrudes ? "E" : "S", trimmed(move.word, 5), trimmed(wanted, 5)));
    if (std::abs(move.z - options.z) > kSamePlaceMm && found.faults.empty())
      found.faults.push_back(fmt::format("line {}: lays at Z {}, the layer is at {}", move.line,
                                         trimmed(move.z, 4), trimmed(options.z, 4)));
  }
}

void judge(const Tolerances& tol, LaidFindings& found) {
  if (found.lines == 0) found.faults.push_back("nothing is laid");
  if (found.uncut_mm2 > 0)
    found.faults.push_back(fmt::format("up to {} mm2 within reach may be left bare, {} mm wide",
                                       trimmed(found.uncut_mm2, 4), trimmed(found.uncut_thickness_mm, 4)));
  if (found.outside_mm > tol.gouge)
    found.faults.push_back(
        fmt::format("the line reaches {} mm over the edge of the area", trimmed(found.outside_mm, 4)));
  if (found.over_share > found.most_over)
    found.faults.push_back(
        fmt::format("{} % of the area is laid over what is covered already, stated are {} %",
                    trimmed(100 * found.over_share, 2), trimmed(100 * found.most_over, 2)));
}

LaidFindings findings_on(const Regions& areas, const std::string& text, const std::string& file_name,
                         const InfillOptions& options) {
  const Tolerances tol = tolerances_of(options);
  const auto program = read::gcode::read_laying(text, file_name);
  const verify::LaidQuestion question{areas, options.width, lines_of(program)};
  const verify::LaidCover cover = verify::laid_cover_of(question, tol);
  LaidFindings found;
  found.word = program.word;
  found.width = options.width;
  found.lines = question.lines.size();
  found.most_over = options.most_over;
  if (found.lines > 0 && program.word != options.word)
    found.faults.push_back("lays with the other word: E for S, or S for E");
  find_amounts(program, options, found);
  found.region_mm2 = cover.cover.target_mm2;
  found.unreachable_mm2 = cover.cover.unreachable_mm2;
  found.uncut_mm2 = cover.cover.uncut_mm2;
  found.uncut_thickness_mm = cover.cover.thickness_mm;
  found.uncut_at = cover.cover.worst;
  if (!cover.cover.reachable) found.faults.push_back("the line is wider than every place of the area");
  found.over_mm2 = cover.over_mm2;
  if (cover.covered_mm2 > 0) found.over_share = cover.over_mm2 / cover.covered_mm2;
  found.outside_mm = cover.outside_mm;
  found.outside_at = cover.outside_at;
  judge(tol, found);
  return found;
}

/// Plans of one layer by any strategy.
class LayerPlanner {
 public:
  LayerPlanner(const Part& part, const InfillOptions& options)
      : options_(options),
        strategies_(strategies_of(options.plan)),
        areas_(areas_of(part, options.plan.tol)) {
    PlanOptions plan = options.plan;
    plan.tol = tolerances_of(options);
    plan.refuse_idle = false;
    plan_ = resolve::resolve(layer_of(part, areas_, options), plan, strategies_);
    works_ = step_works(plan_);
  }

  /// Throws InputError, OutOfWork as the strategies do.
  InfillResult planned(const StrategyEntry& strategy, const std::string& stepover) const {
    const WorkBudget budget(kMostWorkAlone);
    const Strategy run = strategy_for({&strategy, Stepover{stepover}}, plan_.steps.front(), plan_);
    std::vector<Polyline> lines;
    for (const LayerLeft& layer : works_.front().layers)
      for (const Pass& pass : run(layer.layer).passes)
        append_lines(pass, kChordShare * plan_.tol.uncut, lines);
    InfillResult result;
    result.strategy = strategy.name;
    result.stepover = stepover;
    result.program =
        post::write_laying(in_short_order(std::move(lines), plan_.tol), plan_.part.name,
                           {options_.word, options_.rate, options_.feed, options_.travel, options_.z});
    result.findings = findings_on(areas_, result.program, "program", options_);
    return result;
  }

  /// The strategies to try.
  std::vector<const StrategyEntry*> wanted() const {
    if (const StrategyEntry* named = resolve::strategy_named(options_.strategy, strategies_, "--strategy"))
      return {named};
    std::vector<const StrategyEntry*> all;
    for (const StrategyEntry& entry : strategies_.entries())
      if (is_tried(entry)) all.push_back(&entry);
    return all;
  }

  std::vector<std::string> stepovers_of(const StrategyEntry& strategy) const {
    if (options_.stepover) return {*options_.stepover};
    if (strategy.in_auto == AutoUse::kNever || !strategy.takes_stepover) return {""};
    return kStepovers;
  }

 private:
  /// Strategies that limit the engagement lay narrow strips over each other by design.
  bool is_tried(const StrategyEntry& strategy) const {
    if (strategy.in_auto == AutoUse::kNever || strategy.limits_engagement) return false;
    ClearedSize size;
    size.reached_mm2 = area(areas_);
    if (strategy.in_auto == AutoUse::kBriefly &&
        size.reached_mm2 > kMostSearched * options_.width * options_.width)
      return false;
    for (const Edge& edge : edges_of(areas_)) size.legal_rim_mm += edge.length();
    size.edges = edge_count(areas_);
    return !strategy.is_small_enough || strategy.is_small_enough(size, options_.width / 2);
  }

  const InfillOptions& options_;
  const StrategyTable& strategies_;
  Regions areas_;
  ResolvedPlan plan_;
  std::vector<StepWork> works_;
};

/// Whether `a` is the better one: fewer faults, then less laid over, then less travelled.
bool is_better(const InfillResult& a, const InfillResult& b) {
  const auto rank = [](const InfillResult& one) {
    const LaidFindings& found = one.findings;
    return std::tuple(found.uncut_mm2 > 0, found.faults.size(), found.over_mm2, found.travel_mm);
  };
  return rank(a) < rank(b);
}

}  // namespace

InfillResult plan_infill(const Part& part, const InfillOptions& options) {
  refuse_nonsense(options);
  const LayerPlanner planner(part, options);
  std::optional<InfillResult> best;
  std::string refusal = "no strategy fills this area";
  for (const StrategyEntry* strategy : planner.wanted()) {
    for (const std::string& stepover : planner.stepovers_of(*strategy)) {
      throw_if_cancelled(options.plan.cancel);
      try {
        InfillResult next = planner.planned(*strategy, stepover);
        const bool covers = next.findings.uncut_mm2 == 0 && next.findings.lines > 0;
        if (!best || is_better(next, *best)) best = std::move(next);
        if (covers) break;  // nearer lines only lay more over each other
      } catch (const OutOfWork&) {
        refusal = strategy->name + " takes too much work; use another --strategy or a wider line";
      } catch (const InputError& error) {
        refusal = error.what();
      }
    }
  }
  if (!best) throw InputError("infill", refusal);
  if (best->findings.lines == 0) throw InputError("infill", "the line is wider than every place of the area");
  return std::move(*best);
}

LaidFindings check_infill(const Part& part, const std::string& program, const std::string& file_name,
                          const InfillOptions& options) {
  refuse_nonsense(options);
  return findings_on(areas_of(part, options.plan.tol), program, file_name, options);
}

}  // namespace clearcut::pipeline
