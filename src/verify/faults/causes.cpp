#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "base/text.h"
#include "base/units.h"
#include "geometry/box.h"
#include "verify/faults/faults.h"

namespace clearcut::verify {
namespace {

/// mm; extent of moves beyond the cut area, in addition to two diameters: leads, entries beside the stock.
constexpr double kBeside = 5;
/// mm; depth of a program below the cut volume: breakthrough.
constexpr double kBelow = 3;
/// Least size of a program of the right size, as a share of the work's size. Small pockets are cut by short paths.
constexpr double kLeastShare = 0.25;
/// Factor between the sizes of program and work, in either direction, that no program of the right size has.
constexpr double kOtherSize = 4;

std::string counted_faults(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " fault that follows is" : " faults that follow are") +
         " not listed.";
}

/// Faults of one cause.
struct Group {
  std::size_t worst = 0;  ///< place in the list
  std::size_t count = 0;
  int first_line = 0, last_line = 0;

  void add(const std::vector<Fault>& faults, std::size_t i) {
    const int line = faults[i].at.line;
    if (count == 0 || faults[i].size > faults[worst].size) worst = i;
    first_line = count == 0 ? line : std::min(first_line, line);
    last_line = std::max(last_line, line);
    ++count;
  }
};

std::string told_of_others(const Group& group) {
  if (group.count == 1) return "";
  std::string text =
      " Likewise in " + std::to_string(group.count - 1) + " more place" + (group.count == 2 ? "" : "s");
  if (group.first_line > 0 && group.first_line < group.last_line)
    text += ", lines " + std::to_string(group.first_line) + " to " + std::to_string(group.last_line);
  return text + ".";
}

/// One fault for each kind and cause; for kinds that depend on the feature, for each feature.
void fold_alike(std::vector<Fault>& faults) {
  using Key = std::tuple<FaultKind, std::string, std::string>;
  std::map<Key, Group> groups;
  const auto key = [](const Fault& fault) {
    const bool is_one = row_of(fault.kind).of_state || fault.cause == kWrongStock;
    return Key{fault.kind, fault.cause, is_one ? std::string() : fault.feature};
  };
  for (std::size_t i = 0; i < faults.size(); ++i)
    if (!faults[i].cause.empty()) groups[key(faults[i])].add(faults, i);
  std::vector<Fault> kept;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (faults[i].cause.empty()) {
      kept.push_back(std::move(faults[i]));
      continue;
    }
    const Group& group = groups[key(faults[i])];
    if (group.worst != i) continue;
    const std::string others = told_of_others(group);
    kept.push_back(std::move(faults[i]));
    kept.back().text += others;
    kept.back().cause.clear();
  }
  faults = std::move(kept);
}

/// Sets the kind of the cause of the faults selected by `follows`; returns their number.
template <typename Follows>
std::size_t mark_followers(std::vector<Fault>& faults, FaultKind cause, Follows follows) {
  std::size_t count = 0;
  for (Fault& fault : faults) {
    if (!fault.cause.empty() || !follows(fault)) continue;
    fault.cause = name_of(cause);
    ++count;
  }
  return count;
}

bool is_unknown(const CheckedMove& checked) {
  return checked.feeds() && !checked.earlier && (!checked.tool || checked.tool->diameter <= 0);
}

/// Names of the features cut by unknown tools.
std::set<std::string> cut_by_unknown_tools(const Part& part, const CheckedProgram& program) {
  std::set<std::string> names;
  for (const Feature& feature : part.features) {
    Box area;
    for (const Region& region : feature.allowed) area.add(region.box());
    for (const Region& region : feature.target) area.add(region.box());
    if (area.empty()) continue;
    const bool is_cut =
        std::any_of(program.moves.begin(), program.moves.end(), [&](const CheckedMove& checked) {
          return is_unknown(checked) && checked.low_z() < feature.top_z &&
                 area.overlaps(checked.move->path.box());
        });
    if (is_cut) names.insert(feature.name);
  }
  return names;
}

/// Leaves out faults about material that the work of unknown tools does not count as having cut.
void fold_unknown_tools(const Part& part, const CheckedProgram& program, std::vector<Fault>& faults) {
  const auto cause = std::find_if(faults.begin(), faults.end(),
                                  [](const Fault& fault) { return fault.kind == FaultKind::kWrongTool; });
  if (cause == faults.end() || !part.is_shape_stated) return;
  const std::set<std::string> names = cut_by_unknown_tools(part, program);
  const std::size_t count = mark_followers(faults, FaultKind::kWrongTool, [&](const Fault& fault) {
    return row_of(fault.kind).of_missing_cuts && names.count(fault.feature) > 0;
  });
  if (count > 0) cause->text += " What it cuts counts as uncut; " + counted_faults(count);
}

/// Extent of a cut volume in plan view, and its depth.
struct Work {
  Box plan;
  double low = 0;

  double size() const { return std::max(plan.width(), plan.height()); }
};

double size_of(const Box& box) {
  return std::max(box.width(), box.height());
}

std::optional<Work> work_of(const Part& part) {
  Work work;
  work.low = part.stock ? part.stock->z_bottom : part.top_z();
  for (const Workingstep& step : part.workplan) {
    const Feature& feature = feature_of(part, step);
    for (const Region& region : feature.target) work.plan.add(region.box());
    work.low = std::min(work.low, feature.floor_z);
  }
  if (!part.is_shape_stated && part.stock) work.plan = part.stock->plan;
  if (work.plan.empty() || work.size() <= 0) return std::nullopt;
  return work;
}

/// Whether the cuts of the program, times `scale`, have the size and place of the work.
bool fits_at(double scale, const Work& cuts, const Work& work, double beside) {
  const Box plan{cuts.plan.min * scale, cuts.plan.max * scale}, room = work.plan.grown(beside);
  return room.contains(plan.min) && room.contains(plan.max) && size_of(plan) >= kLeastShare * work.size() &&
         cuts.low * scale >= work.low - kBelow;
}

/// The feed moves of the program itself.
std::optional<Work> cuts_of(const CheckedProgram& program) {
  Work cuts;
  for (const CheckedMove& checked : program.moves) {
    if (!checked.feeds() || checked.earlier || checked.is_carried()) continue;
    cuts.plan.add(checked.move->path.box());
    cuts.low = std::min(cuts.low, checked.low_z());
  }
  if (cuts.plan.empty() || cuts.size() <= 0) return std::nullopt;
  return cuts;
}

double widest_tool(const Part& part) {
  double widest = 0;
  for (const Tool& tool : part.tools) widest = std::max(widest, tool.diameter);
  return widest;
}

/// Sentence on the units stated in the program.
std::string told_of_units(const ControlTable* control, bool too_large) {
  const int line = !control ? 0 : too_large ? control->inch_line : control->mm_line;
  const std::string fits = std::string("; it fits in ") + (too_large ? "mm (G21)" : "inches (G20)");
  if (line > 0)
    return "it is read in " + std::string(too_large ? "inches" : "mm") + ", line " + std::to_string(line) +
           fits;
  return (too_large ? "it is read as it is written" : "it states no unit and is read in mm") + fits;
}

std::optional<Fault> wrong_units(const Part& part, const CheckedProgram& program,
                                 const VerifyOptions& options) {
  const std::optional<Work> work = work_of(part), cuts = cuts_of(program);
  if (!work || !cuts) return std::nullopt;
  const double beside = kBeside + 2 * widest_tool(part);
  const bool too_large =
      cuts->size() > kOtherSize * work->size() && fits_at(1 / kMmPerInch, *cuts, *work, beside);
  const bool too_small = part.is_shape_stated && kOtherSize * cuts->size() < work->size() &&
                         fits_at(kMmPerInch, *cuts, *work, beside);
  if (!too_large && !too_small) return std::nullopt;
  const auto first = std::find_if(program.moves.begin(), program.moves.end(), [](const CheckedMove& checked) {
    return checked.feeds() && !checked.earlier;
  });
  const Move& move = *first->move;
  return Fault{FaultKind::kUnits,
               "",
               {move.path.to, move.z_to, move.line},
               cuts->size(),
               "The program cuts over " + trimmed(cuts->size(), 3) + " mm where the work is " +
                   trimmed(work->size(), 3) + " mm wide: " + told_of_units(options.control, too_large) + "."};
}

}  // namespace

void fold_causes(const Part& part, const CheckedProgram& program, const VerifyOptions& options,
                 std::vector<Fault>& faults) {
  if (faults.empty()) return;
  fold_alike(faults);
  fold_unknown_tools(part, program, faults);
  std::optional<Fault> units = wrong_units(part, program, options);
  if (!units) return;
  const std::size_t count = mark_followers(faults, FaultKind::kUnits,
                                           [](const Fault& fault) { return !row_of(fault.kind).of_state; });
  if (count > 0) units->text += " " + counted_faults(count);
  faults.insert(faults.begin(), *std::move(units));
}

}  // namespace clearcut::verify
