#include "verify/faults/faults.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "base/text.h"
#include "verify/engagement/tool_takes.h"
#include "verify/faults/state_faults.h"
#include "verify/faults/threads.h"
#include "verify/program/attribution.h"

namespace clearcut::verify {
namespace {

/// mm by which a pass may be deeper than the stepdown: two heights rounded by the coarsest controller (0.0001
/// inch), without significance for a cutter.
constexpr double kStepdownSlack = 5.5e-3;

/// Share by which a load may exceed the reference: feed words are rounded, and engagement is measured at discrete
/// places.
constexpr double kReferenceSlack = 0.005;

std::string mm(double value) {
  return trimmed(value, 3) + " mm";
}

std::string at(const Place& place) {
  std::string text =
      " at x " + trimmed(place.point.x, 3) + " y " + trimmed(place.point.y, 3) + " z " + trimmed(place.z, 3);
  if (place.line > 0) text += ", line " + std::to_string(place.line);
  return text;
}

std::string name_of_work(const Part& part, int workingstep) {
  return workingstep < 0 ? "" : part.features[part.workplan[workingstep].feature].name;
}

class FaultFinder {
 public:
  FaultFinder(const Part& part, const VerifyOptions& options)
      : part_(part), options_(options), attribution_(part) {
    for (const Workingstep& step : part.workplan)
      least_stepdown_ = std::min(least_stepdown_, step.operation.stepdown.value_or(least_stepdown_));
    for (const auto& [number, limits] : options.tool_limits)
      least_stepdown_ = std::min(least_stepdown_, limits.stepdown.value_or(least_stepdown_));
  }

  std::optional<Fault> gouge(const CheckedMove& checked) const {
    if (!checked.gouge || checked.gouge->depth <= options_.tol.gouge) return std::nullopt;
    const Gouge& gouge = *checked.gouge;
    const Place place{gouge.point, gouge.z, checked.move->line};
    const std::string owner =
        gouge.feature >= 0 ? "the wall of " + part_.features[gouge.feature].name : "the part";
    if (gouge.by != CutterPart::kEnd) return gouge_of_t_slot(checked, place);
    const std::string what = gouge.floor ? "goes " + mm(gouge.depth) + " below where the part begins"
                                         : "goes " + mm(gouge.depth) + " into " + owner;
    return fault(FaultKind::kGouge, checked, place, gouge.depth,
                 (checked.feeds() ? "The cutter " : "A rapid ") + what);
  }

  std::optional<Fault> overcut(const CheckedMove& checked) const {
    if (!checked.load.overcut) return std::nullopt;
    const Overcut& overcut = *checked.load.overcut;
    return fault(FaultKind::kMoreThanItCuts, checked, overcut.at, overcut.taken_mm,
                 overcut_text(checked, part_));
  }

  std::optional<Fault> stock_to_leave(const CheckedMove& checked) const {
    const bool gouges = checked.gouge && checked.gouge->depth > options_.tol.gouge;
    if (!checked.into_stock_to_leave || gouges) return std::nullopt;
    const Gouge& cut = *checked.into_stock_to_leave;
    const std::string owner =
        cut.feature >= 0 ? " of " + part_.features[static_cast<std::size_t>(cut.feature)].name : "";
    return fault(FaultKind::kStockToLeave, checked, {cut.point, cut.z, checked.move->line}, cut.depth,
                 "The cutter goes " + mm(cut.depth) + " into the stock to leave on the " +
                     (cut.floor ? "floor" : "wall") + owner);
  }

  std::optional<Fault> rapid(const CheckedMove& checked) const {
    if (!checked.load.rapid_contact) return std::nullopt;
    return fault(FaultKind::kRapidInMaterial, checked, *checked.load.rapid_contact, checked.move->length(),
                 "A rapid passes through material");
  }

  std::optional<Fault> holder(const CheckedMove& checked, double lowest) const {
    if (!checked.load.holder_contact) return std::nullopt;
    return fault(FaultKind::kHolder, checked, *checked.load.holder_contact, checked.move->length(),
                 !checked.load.is_shank
                     ? "The holder runs into material" + stickout_that_clears(part_.top_z(), lowest)
                 : checked.tool->kind == ToolKind::kTSlot ? "The neck above the disc runs into material"
                                                          : "The shank above the flutes runs into material");
  }

  std::optional<Fault> depth(const CheckedMove& checked) const {
    if (checked.load.axial_mm <= least_stepdown_ + kStepdownSlack || goes_down_alone(checked))
      return std::nullopt;
    const std::optional<double> stepdown = stepdown_of(checked);
    if (!stepdown || checked.load.axial_mm <= *stepdown + kStepdownSlack) return std::nullopt;
    return fault(
        FaultKind::kTooDeep, checked, checked.load.axial_at, checked.load.axial_mm,
        "A pass takes " + mm(checked.load.axial_mm) + " at once where the stepdown is " + mm(*stepdown));
  }

  std::optional<Fault> above_reference(const CheckedMove& checked) const {
    if (!options_.reference || !checked.load.reference ||
        checked.load.reference->share <= 1 + kReferenceSlack)
      return std::nullopt;
    const ReferenceLoad& load = *checked.load.reference;
    const bool is_cap =
        checked.move->feed.mm_per_min() >=
        load.share * options_.reference->cap(checked.workingstep, checked.tool_number) * (1 - 1e-9);
    const std::string what = is_cap ? "the cap of feeds"
                             : options_.reference->rule.by == FeedBy::kChip
                                 ? "the chip of the reference"
                                 : "the removal rate of the reference";
    return caused(what, fault(FaultKind::kAboveReference, checked, load.at, load.share,
                              "A feed of " + trimmed(checked.move->feed.mm_per_min(), 0) + " mm/min is " +
                                  trimmed(100 * load.share, 1) + " % of " + what));
  }

  std::optional<Fault> travel(const CheckedMove& checked) const {
    if (!options_.machine.travel) return std::nullopt;
    const auto& limits = *options_.machine.travel;
    const Move& move = *checked.move;
    Box box = move.path.box();
    const double low[] = {box.min.x, box.min.y, std::min(move.z_from, move.z_to)};
    const double high[] = {box.max.x, box.max.y, std::max(move.z_from, move.z_to)};
    double most = 0;
    int axis = -1;
    for (int i = 0; i < 3; ++i) {
      const double zero = work_zero(options_.machine, static_cast<std::size_t>(i));
      const double over = std::max(limits[i][0] - low[i] - zero, high[i] + zero - limits[i][1]);
      if (over > most + 1e-9) most = over, axis = i;
    }
    if (axis < 0) return std::nullopt;
    return fault(FaultKind::kOutsideTravel, checked, {move.path.to, move.z_to, move.line}, most,
                 std::string("A move leaves the machine's ") + "XYZ"[axis] + " travel by " + mm(most));
  }

  std::optional<Fault> feed(const CheckedMove& checked) const {
    if (!checked.feeds() || checked.move->feed.mm_per_min() > 0) return std::nullopt;
    const std::string what = "A feed move has no feed";
    return caused(what, fault(FaultKind::kNoFeed, checked,
                              {checked.move->path.from, checked.move->z_from, checked.move->line}, 0, what));
  }

  std::optional<Fault> tool(const CheckedMove& checked) const {
    if (!checked.feeds() || (checked.tool && checked.tool->diameter > 0)) return std::nullopt;
    const std::string known = part_.is_shape_stated ? "part's tools" : "tools that were given";
    const std::string what = checked.tool_number == 0
                                 ? "The program calls no tool before it cuts, and which of the " + known +
                                       " is meant nobody says; add a T word, or give one tool alone"
                                 : "Tool " + std::to_string(checked.tool_number) + " is not among the " +
                                       known + "; nothing is known of its moves";
    return caused(what, fault(FaultKind::kWrongTool, checked,
                              {checked.move->path.from, checked.move->z_from, checked.move->line}, 0, what));
  }

 private:
  /// Repeated faults with the same text get the same cause.
  static Fault caused(const std::string& what, Fault fault) {
    fault.cause = what;
    return fault;
  }

  /// The fault of a gouge by the neck, or by the upper side of the disc.
  Fault gouge_of_t_slot(const CheckedMove& checked, const Place& place) const {
    const Gouge& gouge = *checked.gouge;
    const std::string depth = mm(gouge.depth);
    const std::string what = gouge.by == CutterPart::kNeck
                                 ? "The neck of the T-slot cutter goes " + depth + " into the part"
                                 : "The disc of the T-slot cutter goes " + depth +
                                       " into what stands over the undercut of " +
                                       part_.features[static_cast<std::size_t>(gouge.feature)].name;
    return fault(FaultKind::kGouge, checked, place, gouge.depth,
                 what + (checked.feeds() ? "" : ", in a rapid"));
  }

  /// Whether the tool works along its axis, without layers.
  static bool goes_down_alone(const CheckedMove& checked) {
    return checked.tool && (makes_holes(*checked.tool) || checked.tool->kind == ToolKind::kTap);
  }

  /// mm; stepdown stated for the tool, else for the work at this place.
  std::optional<double> stepdown_of(const CheckedMove& checked) const {
    const auto limits =
        checked.tool ? options_.tool_limits.find(checked.tool->number) : options_.tool_limits.end();
    if (limits != options_.tool_limits.end() && limits->second.stepdown) return limits->second.stepdown;
    return attribution_.stepdown_at(checked);
  }

  Fault fault(FaultKind kind, const CheckedMove& checked, const Place& place, double size,
              const std::string& what) const {
    return fault_of(part_, kind, checked, place, size, what);
  }

  const Part& part_;
  const VerifyOptions& options_;
  Attribution attribution_;
  /// mm; passes with a smaller depth are never too deep.
  double least_stepdown_ = std::numeric_limits<double>::infinity();
};

/// Successive moves with one fault, and the worst of them.
class FaultRun {
 public:
  void add(Fault found) {
    ++length_;
    const int line = found.at.line;
    first_line_ = length_ == 1 ? line : std::min(first_line_, line);
    last_line_ = std::max(last_line_, line);
    if (!worst_ || found.size > worst_->size) worst_ = std::move(found);
  }

  /// The fault of the run, none if it is empty; then a new run begins.
  std::optional<Fault> take() {
    std::optional<Fault> fault = std::move(worst_);
    if (fault && length_ > 1)
      fault->text += " " + std::to_string(length_) + " successive moves do so" + lines() + ".";
    *this = {};
    return fault;
  }

 private:
  std::string lines() const {
    if (first_line_ == 0 || first_line_ == last_line_) return "";
    return ", lines " + std::to_string(first_line_) + " to " + std::to_string(last_line_);
  }

  std::optional<Fault> worst_;
  int length_ = 0, first_line_ = 0, last_line_ = 0;
};

/// Earlier cuts included in a check.
enum class Before {
  kNone,    ///< no earlier cuts: those of an earlier set-up were checked there
  kMissing  ///< volumes missing in the stock: whether they belong to the part
};

/// Adds one fault for each run of successive moves of one workingstep with this fault.
void collect(const std::vector<CheckedMove>& moves, const MoveCheck& check, Before before,
             std::vector<Fault>& out) {
  FaultRun run;
  int workingstep = -1;
  const auto finish = [&] {
    if (std::optional<Fault> fault = run.take()) out.push_back(*std::move(fault));
  };
  for (const CheckedMove& checked : moves) {
    const bool is_asked = !checked.is_carried() || (before == Before::kMissing && checked.is_of_stock);
    std::optional<Fault> found = is_asked ? check(checked) : std::nullopt;
    if (!found || checked.workingstep != workingstep) finish();
    workingstep = checked.workingstep;
    if (found) run.add(*std::move(found));
  }
  finish();
}

/// Faults of the steps left by layers on a wall with draft, measured square to the wall.
std::vector<Fault> faults_of_steps(const Feature& feature, const FeatureWork& work, const Tolerances& tol) {
  const auto scallop = scallop_of(feature, work, tol);
  if (!scallop || !leaves_steps(work, *scallop, tol)) return {};
  const Vec2 corner = feature.target.empty() ? Vec2{} : feature.target.front().outer().front().from;
  return {{FaultKind::kUncut,
           feature.name,
           {corner, scallop->z, 0},
           scallop->height_mm,
           feature.name + ": the layers leave steps of " + mm(scallop->height_mm) +
               " on the drafted wall above z " + trimmed(scallop->z, 3) + " where " + mm(*scallop->asked_mm) +
               " is allowed" + (work.scallop ? "" : " (see --scallop)") + "."}};
}

std::string why_nothing_is_cut(const FeatureWork& work, bool unreachable) {
  if (work.ends_in_point)
    return "its cutter ends in a point, which leaves a cone on the floor: use a flat end";
  if (work.smallest_flat <= 0)
    return "its cutter ends in a ball, which leaves cusps on every floor: use a flat end";
  if (unreachable) return "no cutter of its work fits into it with its flat end";
  if (!work.deepest) return "the program has no feed move down there";
  return "the deepest feed move there ends at z " + trimmed(work.deepest->z, 3) + ", line " +
         std::to_string(work.deepest->line);
}

}  // namespace

Fault fault_of(const Part& part, FaultKind kind, const CheckedMove& checked, const Place& place, double size,
               const std::string& what) {
  const std::string feature = name_of_work(part, checked.workingstep);
  const std::string whose = checked.is_of_stock ? "in the stock, which lacks material of the part: "
                            : checked.earlier   ? "in the program before: "
                            : feature.empty()   ? ""
                                                : feature + ": ";
  return {kind, feature, place, size, whose + what + at(place) + ".", checked.is_of_stock ? kWrongStock : ""};
}

std::vector<Fault> faults_of_moves(const Part& part, const CheckedProgram& program,
                                   const VerifyOptions& options) {
  const FaultFinder finder(part, options);
  std::map<const Tool*, double> lowest;  // heights of tips
  for (const CheckedMove& m : program.moves) {
    const auto [at, is_first] = lowest.try_emplace(m.tool, m.low_z());
    if (!is_first) at->second = std::min(at->second, m.low_z());
  }
  std::vector<MoveCheck> checks{[&](const CheckedMove& m) { return finder.rapid(m); },
                                [&](const CheckedMove& m) { return finder.holder(m, lowest[m.tool]); },
                                [&](const CheckedMove& m) { return finder.stock_to_leave(m); },
                                [&](const CheckedMove& m) { return finder.overcut(m); },
                                [&](const CheckedMove& m) { return keep_out_fault(part, m, lowest[m.tool]); },
                                [&](const CheckedMove& m) { return finder.depth(m); },
                                [&](const CheckedMove& m) { return finder.above_reference(m); },
                                [&](const CheckedMove& m) { return finder.travel(m); },
                                [&](const CheckedMove& m) { return finder.feed(m); },
                                [&](const CheckedMove& m) { return finder.tool(m); }};
  const HandWorks hands(program, options);
  for (MoveCheck& check : state_checks(part, program, options, hands)) checks.push_back(std::move(check));
  for (MoveCheck& check : tapping_checks(part, program, options)) checks.push_back(std::move(check));
  std::vector<Fault> faults;
  collect(
      program.moves, [&](const CheckedMove& m) { return finder.gouge(m); }, Before::kMissing, faults);
  for (const MoveCheck& check : checks) collect(program.moves, check, Before::kNone, faults);
  return faults;
}

std::vector<Condition> conditions_of_moves(const CheckedProgram& program, const VerifyOptions& options) {
  std::vector<Condition> conditions = HandWorks(program, options).conditions();
  for (Condition& one : doubtful_cutting_data(program, options)) conditions.push_back(std::move(one));
  for (Condition& one : conditions_of_taps(program, options)) conditions.push_back(std::move(one));
  return conditions;
}

bool leaves_steps(const FeatureWork& work, const Scallop& scallop, const Tolerances& tol) {
  return scallop.height_mm > *scallop.asked_mm + tol.uncut && !work.is_cut_between_layers;
}

const LevelCoverage& worst_level(const FeatureWork& work) {
  const LevelCoverage* worst = &work.floor;
  for (const LevelCoverage& layer : work.layers) {
    if (layer.coverage.thickness_mm > worst->coverage.thickness_mm) worst = &layer;
  }
  return *worst;
}

namespace {

void add_uncut(const Feature& feature, const LevelCoverage& level, const Tolerances& tol,
               std::vector<Fault>& faults) {
  const Coverage& left = level.coverage;
  if (left.thickness_mm <= widest_left(tol)) return;
  const Vec2 middle = feature.target.empty() ? Vec2{} : box(feature.target).center();
  const Place place{left.worst.value_or(middle), level.z, 0};
  faults.push_back({FaultKind::kUncut, feature.name, place, left.thickness_mm,
                    feature.name + ": " + trimmed(left.uncut_mm2, 4) +
                        " mm2 within reach is left uncut, up to " + mm(left.thickness_mm) + " wide," +
                        at(place) + "."});
}

}  // namespace

std::vector<Fault> faults_of_work(const Feature& feature, const FeatureWork& work, const Tolerances& tol) {
  const LevelCoverage& floor = work.floor;
  const Coverage& bottom = floor.coverage;
  const Vec2 middle = feature.target.empty() ? Vec2{} : box(feature.target).center();
  const bool unreachable =
      !bottom.reachable || is_nothing_in_reach(bottom.unreachable_mm2, bottom.target_mm2);
  if (!floor.any_cut || unreachable) {
    // A ball leaves cusps on the floor, and yet its walls are to be cut.
    std::vector<Fault> faults;
    if (work.smallest_flat <= 0 && !work.ends_in_point && !work.layers.empty())
      faults = faults_of_steps(feature, work, tol);
    faults.push_back({FaultKind::kNothingCut,
                      feature.name,
                      {middle, floor.z, 0},
                      std::sqrt(bottom.target_mm2),
                      feature.name + ": nothing is cut at z " + trimmed(floor.z, 3) + "; " +
                          why_nothing_is_cut(work, unreachable) + "."});
    // Cutters without a flat end clear what is above their cusps or cone.
    if (work.smallest_flat <= 0) add_uncut(feature, floor, tol, faults);
    return faults;
  }
  std::vector<Fault> faults = faults_of_steps(feature, work, tol);
  add_uncut(feature, worst_level(work), tol, faults);
  return faults;
}

void sort_worst_first(std::vector<Fault>& faults) {
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    if (a.cause.empty() != b.cause.empty()) return a.cause.empty();  // caused faults come last
    if (a.kind != b.kind) return row_of(a.kind).rank < row_of(b.kind).rank;
    return a.size > b.size;
  });
}

}  // namespace clearcut::verify
