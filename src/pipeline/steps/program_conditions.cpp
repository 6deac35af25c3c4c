#include "pipeline/steps/program_conditions.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "features/round_hole.h"
#include "geometry/box.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// mm. Permitted distance from the work below its top, where clamps are beside it; and above, where greater distances
/// exceed machines of any size.
constexpr double kFarLow = 50, kFarHigh = 2000;
/// mm, for heights rounded by the coarsest controller (0.0001 inch).
constexpr double kRoundedHeight = 5.5e-3;

Box box_of_work(const Part& part) {
  if (part.stock) return part.stock->plan;
  Box work;
  for (const Feature& feature : part.features) {
    if (!feature.allowed.empty()) work.add(box(feature.allowed));
    if (!feature.target.empty()) work.add(box(feature.target));
  }
  return work;
}

double beyond(const Box& work, const Box& path) {
  return std::max(
      {work.min.x - path.min.x, work.min.y - path.min.y, path.max.x - work.max.x, path.max.y - work.max.y});
}

}  // namespace

std::optional<Condition> far_move(const Part& part, const Toolpath& toolpath) {
  const Box work = box_of_work(part);
  if (work.empty()) return std::nullopt;
  const double low = part.top_z() - kRoundedHeight;
  const Move* farthest = nullptr;
  double most = 0;
  for (const Section& section : toolpath.sections) {
    const Tool* const tool = tool_numbered(part.tools, section.tool_number);
    const double width = tool ? 2 * widest_radius(*tool) : 0;
    for (const Move& move : section.moves) {
      const Box path = move.path.box();
      const double away = beyond(work, path);
      const bool is_low = std::min(move.z_from, move.z_to) < low;
      if (away <= (is_low ? kFarLow + width : kFarHigh) || away <= most) continue;
      farthest = &move;
      most = away;
    }
  }
  if (!farthest) return std::nullopt;
  return Condition{
      "far-move",
      fmt::format("a move to z {} leads {} mm away from the work; it is meant so, and its way is free",
                  trimmed(farthest->z_to, 3), trimmed(most, 1)),
      farthest->line};
}

namespace {

/// mm. Rounding of coordinates read back.
constexpr double kSlack = 1e-5;

constexpr double kMicrometres = 1000;  // per mm

}  // namespace

void explain_rounded_places(PlanResult& result, const ResolvedPlan& plan) {
  for (const FeatureFindings& found : result.findings.features) {
    if (found.figures.clean || found.workingstep < 0) continue;
    const Workingstep& step = result.part.workplan[static_cast<std::size_t>(found.workingstep)];
    const bool plunges = makes_holes(tool_of(result.part, step));
    const double beside = plunges ? post::rounding_of_lines(plan.post) : post::rounding_of(plan.post);
    const double gouge = found.figures.gouge_mm;
    if (gouge <= plan.tol.gouge || gouge > beside + kSlack) continue;
    result.part.diagnostics.warn(
        found.name,
        fmt::format("the program's digits put {} up to {} um beside {} {}: add --decimals {} if the control "
                    "reads as many",
                    plunges ? "holes" : "a cutter that has no room", trimmed(beside * kMicrometres, 2),
                    plunges ? "their places, this one" : "its path, here", trimmed(gouge * kMicrometres, 2),
                    post::decimals_of(plan.post) + 1));
  }
}

namespace {

/// mm, for heights rounded by the coarsest controller (0.0001 inch).
constexpr double kHeightSlack = 5.5e-3;

double low_z(const Move& move) {
  return std::min(move.z_from, move.z_to);
}

double radius_of(const Section& section, const std::vector<Tool>& tools) {
  const Tool* const tool = tool_numbered(tools, section.tool_number);
  return tool ? tool->radius() : 0;
}

int line_of_move(const Toolpath& toolpath, std::size_t index) {
  for (const Section& section : toolpath.sections) {
    if (index < section.moves.size()) return section.moves[index].line;
    index -= section.moves.size();
  }
  return 0;
}

}  // namespace

std::optional<Stock> box_of_cuts(const Toolpath& toolpath, const std::vector<Tool>& tools, double top) {
  Stock stock;
  stock.z_top = stock.z_bottom = top;
  for (const Section& section : toolpath.sections) {
    const double radius = radius_of(section, tools);
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || low_z(move) >= top) continue;
      const Box path = move.path.box();
      stock.plan.add(path.grown(radius));
      stock.z_bottom = std::min(stock.z_bottom, low_z(move));
    }
  }
  if (stock.plan.empty()) return std::nullopt;
  return stock;
}

const Move* work_above(const Toolpath& toolpath, double top) {
  const Move* highest = nullptr;
  double crossing = top;   // height of the highest rapid across so far
  bool came_down = false;  // the tool came down to the current height, not up
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      const bool across = !move.is_vertical(), feeds = !is_rapid(move.kind);
      if (!feeds && across) crossing = std::max(crossing, move.z_to);
      if (move.z_to < move.z_from) came_down = feeds || move.z_to < crossing - kHeightSlack;
      if (move.z_to > move.z_from) came_down = false;
      const bool works = feeds && across && move.z_from <= move.z_to + kHeightSlack && came_down;
      if (!works || low_z(move) <= top + kHeightSlack) continue;
      if (!highest || move.z_to > highest->z_to) highest = &move;
    }
  }
  return highest;
}

Condition stock_taken(const Stock& stock) {
  const auto range = [](const char* axis, double low, double high) {
    return fmt::format("{} {} to {}", axis, trimmed(low, 3), trimmed(high, 3));
  };
  return {
      "stock",
      fmt::format("no stock was stated (--stock): the box of what the program cuts is taken, {}, {}, {}",
                  range("x", stock.plan.min.x, stock.plan.max.x),
                  range("y", stock.plan.min.y, stock.plan.max.y), range("z", stock.z_bottom, stock.z_top)),
      0};
}

std::optional<Condition> below_stock(const Toolpath& toolpath, const Stock& stock) {
  const Move* deepest = nullptr;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      if (!is_rapid(move.kind) && (!deepest || low_z(move) < low_z(*deepest))) deepest = &move;
    }
  }
  const double below = deepest ? stock.z_bottom - low_z(*deepest) : 0;
  if (below <= kHeightSlack) return std::nullopt;
  return Condition{"below-stock",
                   fmt::format("what the stock lies on may be cut {} mm deep, down to z {}",
                               trimmed(below, 3), trimmed(low_z(*deepest), 3)),
                   deepest->line};
}

std::optional<Condition> doubtful_arcs(const Toolpath& toolpath, const ControlTable& control,
                                       const Tolerances& tol) {
  const auto worst =
      std::max_element(control.arcs.begin(), control.arcs.end(),
                       [](const ArcDoubt& a, const ArcDoubt& b) { return a.apart_mm < b.apart_mm; });
  if (worst == control.arcs.end() || worst->apart_mm <= tol.uncut) return std::nullopt;
  return Condition{
      "arc-radii",
      fmt::format("the words of an arc give two radii {} mm apart: controls run another arc, or stop",
                  trimmed(worst->apart_mm, 3)),
      line_of_move(toolpath, worst->move)};
}

std::optional<Condition> cuts_nothing(const Findings& findings) {
  if (findings.all.max_axial_mm > 0) return std::nullopt;
  return Condition{
      "cuts-nothing",
      "no feed move meets the stock: nothing is to be cut, or the stock is stated where it is not (--stock, "
      "--top)",
      0};
}

namespace {

bool is_known(const std::vector<Fault>& faults, const Fault& fault) {
  return std::any_of(faults.begin(), faults.end(), [&](const Fault& other) {
    return other.kind == fault.kind && other.feature == fault.feature;
  });
}

/// Has the steps of a tool clear what the tool reaches with its present size, whatever becomes of the tool: they get a copy of it, with
/// its number, behind the tool that programs call.
void keep_reach(Part& part, int tool) {
  part.tools.push_back(part.tools[static_cast<std::size_t>(tool)]);
  for (Workingstep& step : part.workplan) {
    if (step.operation.tool == tool) step.operation.tool = static_cast<int>(part.tools.size()) - 1;
  }
}

bool moves_alike(const Section& a, const Section& b) {
  return std::equal(a.moves.begin(), a.moves.end(), b.moves.begin(), b.moves.end(),
                    [](const Move& one, const Move& other) { return one.path == other.path; });
}

/// Names of the features whose passes are not where they were; empty if nobody knows whose they are.
std::set<std::string> shifted_features(const WearQuestion& question, const Toolpath& shifted) {
  const auto& before = question.toolpath->sections;
  if (before.size() != shifted.sections.size()) return {};
  std::set<std::string> names;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (moves_alike(before[i], shifted.sections[i])) continue;
    if (before[i].workingstep < 0) return {};
    const auto step = static_cast<std::size_t>(before[i].workingstep);
    names.insert(feature_of(*question.part, question.part->workplan[step]).name);
  }
  return names;
}

}  // namespace

Part worn(Part part, const std::vector<int>& numbers, double wear) {
  const std::size_t count = part.tools.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (std::find(numbers.begin(), numbers.end(), part.tools[i].number) == numbers.end()) continue;
    if (wear < 0) keep_reach(part, static_cast<int>(i));
    part.tools[i].diameter += 2 * wear;
  }
  return part;
}

void check_wear(Findings& findings, const WearQuestion& question,
                const std::function<WornProgram(double)>& read_at) {
  if (question.tools.empty()) return;
  findings.wear = WearFindings{question.range, question.tools};
  const std::vector<Fault> known = findings.faults;
  for (const double wear : {-question.range, question.range}) {
    const std::string end = "with " + trimmed(wear, 4) + " mm in D and cutters as much off their size: ";
    WornProgram worn;
    try {
      worn = read_at(wear);
    } catch (const InputError& error) {
      throw InputError("--wear-range", end + error.what() + "; give a smaller range");
    }
    const std::set<std::string> shifted = shifted_features(question, worn.toolpath);
    for (Fault fault : worn.findings.faults) {
      const bool counts = shifted.empty() || fault.feature.empty() || shifted.contains(fault.feature);
      if (!counts || is_known(known, fault)) continue;
      fault.text = end + fault.text;
      findings.faults.push_back(std::move(fault));
    }
  }
  findings.all.clean = findings.faults.empty();
}

}  // namespace clearcut::pipeline
