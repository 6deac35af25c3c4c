#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

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

/// A mistake from which other faults follow.
struct Cause {
  std::size_t fault = 0;    ///< its place in the list
  std::string consequence;  ///< what its sentence says further if any fault follows
  std::function<bool(const Fault&)> causes;
};

/// Faults that follow from the cause state its kind as theirs, and its sentence states their number.
void fold_followers(const Cause& cause, std::vector<Fault>& faults) {
  Fault& first = faults[cause.fault];
  std::size_t count = 0;
  for (Fault& fault : faults) {
    if (&fault == &first || !fault.cause.empty() || !cause.causes(fault)) continue;
    fault.cause = name_of(first.kind);
    ++count;
  }
  if (count > 0) first.text += cause.consequence + " " + counted_faults(count);
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

/// An unknown tool causes faults about material that its work does not count as having cut.
std::optional<Cause> unknown_tool(const Part& part, const CheckedProgram& program,
                                  const std::vector<Fault>& faults) {
  const auto at = std::find_if(faults.begin(), faults.end(),
                               [](const Fault& fault) { return fault.kind == FaultKind::kWrongTool; });
  if (at == faults.end() || !part.is_shape_stated) return std::nullopt;
  return Cause{static_cast<std::size_t>(at - faults.begin()), " What it cuts counts as uncut;",
               [names = cut_by_unknown_tools(part, program)](const Fault& fault) {
                 return row_of(fault.kind).of_missing_cuts && names.count(fault.feature) > 0;
               }};
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

/// The least share of the stated stock's area that another stock takes in if the stated one is to be a mistake.
constexpr double kLeastStock = 0.3;
/// The least share of the length of all cuts that meets such a stock.
constexpr double kLeastCuts = 0.75;

Box swept_by(const CheckedMove& checked) {
  return checked.move->path.box().grown(checked.radius());
}

bool is_own_cut(const CheckedMove& checked) {
  return !checked.earlier && !checked.is_carried() && checked.cuts();
}

/// mm; the highest end of the program's cuts: rapids above it are over all work.
double highest_cut(const CheckedProgram& program) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const CheckedMove& checked : program.moves)
    if (is_own_cut(checked)) highest = std::max(highest, checked.low_z());
  return highest;
}

constexpr unsigned kSides = 4;

/// Takes the least from one of the sides whose bit in `sides` is set that leaves nothing of `plan` in `swept`.
void trim_one_side(Box& plan, const Box& swept, unsigned sides) {
  const std::array<double, kSides> losses{swept.max.x - plan.min.x, plan.max.x - swept.min.x,
                                          swept.max.y - plan.min.y, plan.max.y - swept.min.y};
  unsigned least = kSides;
  for (unsigned side = 0; side < kSides; ++side)
    if ((sides >> side & 1U) && (least == kSides || losses[side] < losses[least])) least = side;
  if (*std::min_element(losses.begin(), losses.end()) <= 0) return;
  const std::array<double*, kSides> ends{&plan.min.x, &plan.max.x, &plan.min.y, &plan.max.y};
  *ends[least] += least % 2 == 0 ? losses[least] : -losses[least];
}

/// mm2; 0 for a box without extent.
double area_of(const Box& plan) {
  return std::max(plan.width(), 0.0) * std::max(plan.height(), 0.0);
}

/// The largest box within `plan`, taking from some of its sides, that leaves nothing in any of `swept`.
Box trimmed_plan(const Box& plan, const std::vector<Box>& swept) {
  Box best;
  for (unsigned sides = 1; sides < 1U << kSides; ++sides) {
    Box left = plan;
    for (const Box& box : swept) trim_one_side(left, box, sides);
    if (best.empty() || area_of(left) > area_of(best)) best = left;
  }
  return best;
}

/// Whether most of what is cut of the stated stock is cut of `other`, too.
bool is_stock_of_program(const Stock& other, const Stock& stated, const CheckedProgram& program) {
  if (area_of(other.plan) < kLeastStock * area_of(stated.plan) || other.z_top <= other.z_bottom) return false;
  double all = 0, met = 0;
  for (const CheckedMove& checked : program.moves) {
    if (!is_own_cut(checked)) continue;
    const double length = checked.move->length();
    all += length;
    if (checked.low_z() < other.z_top && other.plan.overlaps(swept_by(checked))) met += length;
  }
  return met >= kLeastCuts * all && all > 0;
}

/// The part of the stock that no rapid touches: without its outer parts, in which rapids go down or over the work.
Stock stock_without_rapids(const Stock& stated, const CheckedProgram& program) {
  Stock other = stated;
  const double over_work = highest_cut(program);
  std::vector<Box> beside_work;
  for (const CheckedMove& checked : program.moves) {
    if (checked.earlier || checked.is_carried() || !checked.load.rapid_contact) continue;
    if (checked.low_z() > over_work) {
      other.z_top = std::min(other.z_top, checked.low_z());
    } else {
      beside_work.push_back(swept_by(checked));
    }
  }
  other.plan = trimmed_plan(stated.plan, beside_work);
  return other;
}

std::string text_of(const Stock& stock) {
  const auto range = [](const char* axis, double low, double high) {
    return std::string(axis) + " " + trimmed(low, 3) + " to " + trimmed(high, 3);
  };
  return range("x", stock.plan.min.x, stock.plan.max.x) + ", " +
         range("y", stock.plan.min.y, stock.plan.max.y) + ", " + range("z", stock.z_bottom, stock.z_top);
}

/// A stock that is stated too large or in another place, or rapids that are too low for it, cause all faults of rapids,
/// and those below the bottom of a stock that is stated too high.
std::optional<Cause> outer_stock(const Part& part, const CheckedProgram& program,
                                 const std::vector<Fault>& faults) {
  const auto at = std::find_if(faults.begin(), faults.end(), [](const Fault& fault) {
    return fault.kind == FaultKind::kRapidInMaterial && fault.cause.empty();
  });
  if (at == faults.end() || !part.stock) return std::nullopt;
  Stock other = stock_without_rapids(*part.stock, program);
  const double too_high = part.stock->z_top - other.z_top;
  const auto is_too_high = [too_high](const Fault& fault) {
    return fault.kind == FaultKind::kBeyondStock && too_high > 0 && fault.size <= too_high + kBelow;
  };
  if (std::any_of(faults.begin(), faults.end(), is_too_high)) other.z_bottom -= too_high;
  if (!is_stock_of_program(other, *part.stock, program)) return std::nullopt;
  return Cause{static_cast<std::size_t>(at - faults.begin()),
               " None would with a stock of " + text_of(other) + " in place of " + text_of(*part.stock) +
                   ": the stock is stated too large or elsewhere, or rapids are too low.",
               [is_too_high](const Fault& fault) {
                 return fault.kind == FaultKind::kRapidInMaterial || is_too_high(fault);
               }};
}

}  // namespace

void fold_causes(const Part& part, const CheckedProgram& program, const VerifyOptions& options,
                 std::vector<Fault>& faults) {
  if (faults.empty()) return;
  fold_alike(faults);
  if (const auto cause = unknown_tool(part, program, faults)) fold_followers(*cause, faults);
  if (std::optional<Fault> units = wrong_units(part, program, options)) {
    faults.insert(faults.begin(), *std::move(units));
    fold_followers({0, "", [](const Fault& fault) { return !row_of(fault.kind).of_state; }}, faults);
    return;
  }
  if (const auto cause = outer_stock(part, program, faults)) fold_followers(*cause, faults);
}

}  // namespace clearcut::verify
