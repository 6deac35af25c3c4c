#include "verify/verify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/elementary.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "model/cutter_profile.h"
#include "verify/coverage/carving.h"
#include "verify/coverage/coverage.h"
#include "verify/coverage/feature_work.h"
#include "verify/coverage/length_bound.h"
#include "verify/engagement/load.h"
#include "verify/faults/faults.h"
#include "verify/faults/move_gouge.h"
#include "verify/faults/stock_to_leave.h"
#include "verify/faults/tabs.h"
#include "verify/faults/threads.h"
#include "verify/part/finished_parts.h"
#include "verify/program/checked_move.h"
#include "verify/program/shaped_cutter.h"

namespace clearcut::verify {
namespace {

/// Degrees. Smaller changes of direction are due to rounding and are no turns.
constexpr double kTurn = 0.1;

double degrees_between(Vec2 a, Vec2 b) {
  return std::abs(base::atan2(cross(a, b), dot(a, b))) * 180 / kPi;
}

void add_lengths(Figures& figures, const CheckedMove& checked) {
  const Move& move = *checked.move;
  const double length = move.length();
  (checked.feeds() ? figures.feed_mm : figures.rapid_mm) += length;
  if (checked.feeds() && move.is_vertical() && move.z_to < move.z_from) figures.plunge_mm += length;
  figures.time_s += checked.time_s;
  figures.waits_s += checked.waits_s;
  figures.time_naive_s += checked.time_naive_s;
}

void add_turns(Figures& figures, std::span<const CheckedMove* const> moves) {
  const Move* before = nullptr;
  for (const CheckedMove* checked : moves) {
    const Move& move = *checked->move;
    if (!checked->feeds() || move.is_vertical()) {
      before = nullptr;
      continue;
    }
    if (before && distance(before->path.to, move.path.from) < 1e-9) {
      const double turn = degrees_between(before->path.tangent_at(1), move.path.tangent_at(0));
      if (turn > kTurn) {
        ++figures.turns;
        figures.turn_angle_deg += turn;
      }
    }
    before = &move;
  }
}

void add_retracts(Figures& figures, std::span<const CheckedMove* const> moves, double top_z) {
  bool cutting = false, risen = false;
  for (const CheckedMove* checked : moves) {
    const Move& move = *checked->move;
    if (cutting && std::max(move.z_from, move.z_to) >= top_z) risen = true;
    if (checked->feeds() && checked->low_z() < top_z) {
      if (risen) ++figures.retracts;
      risen = false;
      cutting = true;
    }
  }
}

void add_forces(Figures& figures, const CuttingLoad& forces) {
  if (!figures.load) figures.load = CuttingLoad{};
  CuttingLoad& sum = *figures.load;
  sum.energy_j += forces.energy_j;
  sum.removed_mm3 += forces.removed_mm3;
  sum.wear += forces.wear;
  sum.max_power_w = std::max(sum.max_power_w, forces.max_power_w);
  if (forces.max_force_n <= sum.max_force_n) return;
  sum.max_force_n = forces.max_force_n;
  sum.max_force_at = forces.max_force_at;
}

void add_entry(Entries& entries, const EntryLoad& load) {
  if (load.begins) ++entries.count;
  entries.length_mm += load.length_mm;
  entries.max_axial_mm = std::max(entries.max_axial_mm, load.max_axial_mm);
  if (load.max_deg <= entries.max_deg) return;
  entries.max_deg = load.max_deg;
  entries.max_at = load.max_at;
}

void add_load(Figures& figures, const MoveLoad& load) {
  if (load.entry) add_entry(figures.entries, *load.entry);
  Engagement& engagement = figures.engagement;
  if (load.max_deg > engagement.max_deg) {
    engagement.max_deg = load.max_deg;
    engagement.max_at = load.max_at;
  }
  engagement.over_limit_mm += load.over_limit_mm;
  engagement.climb_mm += load.climb_mm;
  engagement.conventional_mm += load.conventional_mm;
  load.classes.add_to(engagement.histogram_mm);
  if (load.forces) add_forces(figures, *load.forces);
  figures.air_cut_mm += load.air_mm;
  figures.max_axial_mm = std::max(figures.max_axial_mm, load.axial_mm);
  if (load.reference && (!figures.reference_load || load.reference->share > figures.reference_load->share))
    figures.reference_load = *load.reference;
  if (load.rapid_contact) ++figures.rapid_in_material;
}

}  // namespace

Figures figures_of(std::span<const CheckedMove* const> moves, double top_z) {
  Figures figures;
  double cutting_mm = 0, angle_mm_deg = 0, force_mm_n = 0;
  for (const CheckedMove* checked : moves) {
    add_lengths(figures, *checked);
    add_load(figures, checked->load);
    cutting_mm += checked->load.cutting_mm;
    angle_mm_deg += checked->load.angle_mm_deg;
    force_mm_n += checked->load.force_mm_n;
    if (checked->gouge && checked->gouge->depth > figures.gouge_mm) {
      figures.gouge_mm = checked->gouge->depth;
      figures.gouge_at = Place{checked->gouge->point, checked->gouge->z, checked->move->line};
    }
  }
  if (cutting_mm > 0) figures.engagement.mean_deg = angle_mm_deg / cutting_mm;
  if (cutting_mm > 0 && figures.load) figures.load->mean_force_n = force_mm_n / cutting_mm;
  add_turns(figures, moves);
  add_retracts(figures, moves, top_z);
  return figures;
}

namespace {

/// Number of moves checked in one task.
constexpr std::size_t kChunk = 2000;

void check_gouges(const FinishedParts& finished, std::span<CheckedMove> moves, const Tolerances& tol) {
  const CheckedMove* before = nullptr;  // the last move, if known to end outside the part
  for (CheckedMove& checked : moves) {
    if (checked.radius() <= 0) {
      before = nullptr;
      continue;
    }
    if (has_flanks(*checked.tool)) {
      checked.gouge = gouge_of_move(finished, checked, *checked.move, 0, tol.gouge, false);
      before = nullptr;
      continue;
    }
    const bool joined = before && before->move->path.to == checked.move->path.from &&
                        before->move->z_to == checked.move->z_from && before->radius() == checked.radius();
    checked.gouge = gouge_of_move(finished, checked, *checked.move, 0, tol.gouge, joined);
    const bool spared = !checked.gouge || checked.gouge->depth < checked.radius() / 2;
    before = spared && !checked.gouge.value_or(Gouge{}).floor ? &checked : nullptr;
  }
}

/// Keeps the deeper of two gouges.
void keep_deeper(std::optional<Gouge>& gouge, const std::optional<Gouge>& other) {
  if (other && (!gouge || other->depth > gouge->depth)) gouge = other;
}

/// Adds the gouge of a cutter with flanks for the permitted deviation of the control from its path. Where a vertical move begins or ends,
/// a rounded corner leads over places at which the other moves of the corner are deeper.
void check_shaped_liberty(const FinishedParts& finished, const std::vector<CheckedMove>& all,
                          CheckedMove& checked, const Tolerances& tol) {
  const double before = &checked == all.data() ? 0 : (&checked - 1)->path_tolerance;
  const double rounds = checked.move->is_vertical() ? 0 : std::max(checked.path_tolerance, before);
  const double off = std::max(checked.doubt, rounds);
  if (off <= 0) return;
  // Off its path in any direction of space, also downwards, a flank comes nearer sideways by this at most.
  const double aside = off * base::hypot(1.0, flank_slope(*checked.tool));
  keep_deeper(checked.gouge, gouge_of_move(finished, checked, *checked.move, aside, tol.gouge, false));
}

/// Adds possible gouges by the control within its tolerance: at rounded corners, on arcs of another radius.
void check_liberties(const FinishedParts& finished, const std::vector<CheckedMove>& all,
                     std::span<CheckedMove> moves, const Tolerances& tol) {
  for (CheckedMove& checked : moves) {
    if (checked.radius() <= 0) continue;
    if (has_flanks(*checked.tool)) {
      check_shaped_liberty(finished, all, checked, tol);
      continue;
    }
    const auto keep = [&](const Move& move, double aside) {
      keep_deeper(checked.gouge, gouge_of_move(finished, checked, move, aside, tol.gouge, false));
    };
    if (checked.doubt > 0) keep(*checked.move, checked.doubt);
    if (&checked == all.data()) continue;
    const CheckedMove& before = *(&checked - 1);
    const auto corner =
        rounded_corner(before, checked, std::max(before.path_tolerance, checked.path_tolerance));
    if (!corner) continue;
    for (const Move& move : *corner) keep(move, 0);
  }
}

/// Share of an area that rounding may seem to leave out of it.
constexpr double kRoundingShare = 1e-12;

/// mm; lower bound of the feed length for clearing the reachable area in one level, begun by one entry for each region.
double bound_of(const FeatureWork& work, const Feature& feature) {
  double perimeter = 0;
  for (const Region& region : feature.target) perimeter += length(region.edges());
  const double draft = base::tan(feature.wall_slope.radians()) * (feature.top_z - feature.floor_z);
  LengthBoundQuestion question;
  question.area = feature.target;
  question.radius = work.greatest_radius;
  question.paths = static_cast<int>(feature.target.size());
  const double whole = area(feature.target);
  const Coverage& floor = work.floor.coverage;
  question.left_out_mm2 =
      whole - floor.target_mm2 + floor.unreachable_mm2 + (work.allowance_side + draft) * perimeter;
  if (question.left_out_mm2 <= kRoundingShare * whole) question.left_out_mm2 = 0;
  return length_bound(question).mm;
}

/// mm; bound_of() of all works, on up to `threads` threads: the search for the points of a bound takes longer than all other
/// findings together.
std::vector<double> bounds_of(const std::vector<FeatureWork>& works, const Part& part, int threads) {
  std::vector<double> bounds(works.size());
  on_threads(threads, [&] {
    parallel_for(std::size_t{0}, works.size(), [&](std::size_t i) {
      bounds[i] = bound_of(works[i], part.features[static_cast<std::size_t>(works[i].feature)]);
    });
  });
  return bounds;
}

bool is_clean(const Figures& figures, const Tolerances& tol) {
  return figures.uncut_thickness_mm <= tol.uncut && figures.gouge_mm <= tol.gouge &&
         figures.rapid_in_material == 0;
}

void add_coverage(Figures& figures, const LevelCoverage& level) {
  const Coverage& coverage = level.coverage;
  figures.uncut_mm2 += coverage.uncut_mm2;
  figures.path_tolerance_mm = std::max(figures.path_tolerance_mm, coverage.path_tolerance_mm);
  figures.unreachable_mm2 += coverage.unreachable_mm2;
  if (coverage.thickness_mm < figures.uncut_thickness_mm) return;
  figures.uncut_thickness_mm = coverage.thickness_mm;
  if (coverage.worst) figures.uncut_at = Place{*coverage.worst, level.z, 0};
}

class FindingsBuilder {
 public:
  FindingsBuilder(const Part& part, const CheckedProgram& program, const std::vector<FeatureWork>& works,
                  const std::vector<CarvingWork>& carvings, const VerifyOptions& options)
      : part_(part), program_(program), works_(works), carvings_(carvings), options_(options) {}

  Findings build() {
    std::vector<const CheckedMove*> all;
    std::vector<std::vector<const CheckedMove*>> by_step(part_.workplan.size());
    for (const CheckedMove& checked : program_.moves) {
      if (checked.earlier) continue;
      all.push_back(&checked);
      findings_.move_engagement_deg.push_back(static_cast<float>(checked.load.max_deg));
      if (options_.material) findings_.move_force_n.push_back(force_of(checked));
      if (checked.workingstep >= 0) by_step[checked.workingstep].push_back(&checked);
    }
    findings_.faults = faults_of_moves(part_, program_, options_);
    for (Fault& fault : faults_of_tabs(part_, program_, options_.tol))
      findings_.faults.push_back(std::move(fault));
    for (Fault& fault : faults_of_loose_parts(part_, program_, options_.tol))
      findings_.faults.push_back(std::move(fault));
    for (Fault& fault : faults_of_holes(part_, program_, options_))
      findings_.faults.push_back(std::move(fault));
    findings_.all = figures_of(all, part_.top_z());
    for (std::size_t i = 0; i < by_step.size(); ++i) add_feature(static_cast<int>(i), by_step[i]);
    const std::vector<double> bounds = bounds_of(works_, part_, options_.threads);
    for (std::size_t i = 0; i < works_.size(); ++i) check_coverage(works_[i], bounds[i]);
    for (const CarvingWork& work : carvings_) add_carving(work);
    set_clean();
    fold_causes(part_, program_, options_, findings_.faults);
    sort_worst_first(findings_.faults);
    return std::move(findings_);
  }

 private:
  void add_feature(int workingstep, const std::vector<const CheckedMove*>& moves) {
    const Workingstep& step = part_.workplan[workingstep];
    FeatureFindings feature;
    feature.name = part_.features[step.feature].name;
    feature.workingstep = workingstep;
    if (step.operation.tool >= 0 && step.operation.tool < static_cast<int>(part_.tools.size())) {
      feature.tool_number = part_.tools[step.operation.tool].number;
      feature.tool_diameter = part_.tools[step.operation.tool].diameter;
    }
    feature.figures = figures_of(moves, part_.top_z());
    const LayerHeights& heights = program_.layers[workingstep];
    std::vector<std::vector<const CheckedMove*>> by_layer(heights.size());
    for (const CheckedMove* checked : moves) {
      if (checked->layer >= 0) by_layer[checked->layer].push_back(checked);
    }
    for (std::size_t i = 0; i < heights.size(); ++i) {
      feature.layers.push_back({heights[i], figures_of(by_layer[i], part_.top_z())});
    }
    findings_.features.push_back(std::move(feature));
  }

  void add_carving(const CarvingWork& work) {
    const Feature& feature = part_.features[static_cast<std::size_t>(work.feature)];
    FeatureFindings& found = findings_.features[static_cast<std::size_t>(work.last_workingstep)];
    for (Figures* figures : {&findings_.all, &found.figures}) {
      if (work.left_mm <= figures->uncut_thickness_mm) continue;
      figures->uncut_thickness_mm = work.left_mm;
      figures->uncut_at = Place{work.worst, work.worst_z, 0};
    }
    for (Fault& fault : faults_of_carving(feature, work, options_.tol))
      findings_.faults.push_back(std::move(fault));
  }

  /// `bound`: mm; see bound_of().
  void check_coverage(const FeatureWork& work, double bound) {
    const Feature& feature = part_.features[work.feature];
    const LevelCoverage& worst = worst_level(work);
    FeatureFindings& found = findings_.features[work.last_workingstep];
    add_coverage(findings_.all, worst);
    add_coverage(found.figures, worst);
    found.scallop = scallop_of(feature, work, options_.tol);
    if (found.scallop && leaves_steps(work, *found.scallop, options_.tol))
      add_steps(found.figures, *found.scallop);
    for (FeatureFindings& step : findings_.features) {
      if (part_.workplan[step.workingstep].feature == work.feature) add_layer_coverage(step, work);
    }
    for (Fault& fault : faults_of_work(feature, work, options_.tol))
      findings_.faults.push_back(std::move(fault));
    for (FeatureFindings& step : findings_.features) {
      if (part_.workplan[step.workingstep].feature != work.feature) continue;
      for (LayerFindings& layer : step.layers) {
        // A level with less feed length does not clear the feature.
        if (layer.figures.feed_mm < bound) continue;
        layer.figures.lower_bound_mm = bound;
        step.figures.lower_bound_mm += bound;
        findings_.all.lower_bound_mm += bound;
      }
    }
  }

  /// Impermissible steps on walls count as uncut material.
  void add_steps(Figures& own, const Scallop& steps) {
    for (Figures* figures : {&findings_.all, &own})
      figures->uncut_thickness_mm = std::max(figures->uncut_thickness_mm, steps.height_mm);
  }

  static void add_layer_coverage(FeatureFindings& step, const FeatureWork& work) {
    for (LayerFindings& layer : step.layers) {
      for (const LevelCoverage& level : work.layers) {
        if (level.z == layer.z) add_coverage(layer.figures, level);
      }
    }
    if (step.workingstep == work.last_workingstep && !step.layers.empty()) {
      add_coverage(step.layers.back().figures, work.floor);
    }
  }

  void set_clean() {
    findings_.all.clean = findings_.faults.empty();
    for (FeatureFindings& feature : findings_.features) {
      const bool faulty = std::any_of(findings_.faults.begin(), findings_.faults.end(),
                                      [&](const Fault& fault) { return fault.feature == feature.name; });
      feature.figures.clean = !faulty && is_clean(feature.figures, options_.tol);
      for (LayerFindings& layer : feature.layers) layer.figures.clean = is_clean(layer.figures, options_.tol);
    }
  }

  const Part& part_;
  const CheckedProgram& program_;
  const std::vector<FeatureWork>& works_;
  const std::vector<CarvingWork>& carvings_;
  const VerifyOptions& options_;
  Findings findings_;
};

}  // namespace

Findings verify_program(const Part& part, const Toolpath& toolpath, const VerifyOptions& options) {
  const FinishedParts finished(part);
  const StockToLeave left(part, options.tol);
  CheckedProgram program = checked_program(part, toolpath, options.machine, options.earlier, options.control,
                                           options.earlier_control);
  std::vector<FeatureWork> works = works_of(part);
  std::vector<CarvingWork> carvings = carvings_of(part);

  const std::size_t gouging = part.is_shape_stated ? program.moves.size() : 0;
  ProgressMeter meter(options.progress, options.cancel);
  meter.begin(Stage::kCertifying, samples_of(part, program.moves) + gouging);
  const LoadOptions load{options.tol,
                         options.engagement_limit_deg,
                         options.material,
                         options.cancel,
                         options.reference ? &*options.reference : nullptr,
                         &meter,
                         part.is_shape_stated ? &finished.plain() : nullptr};
  const int threads = options.threads > 0 ? options.threads : available_threads();
  std::vector<std::function<void()>> tasks = load_tasks(part, program.moves, load, threads);
  for (std::size_t i = 0; i < gouging; i += kChunk) {
    const std::span<CheckedMove> chunk(program.moves.data() + i, std::min(kChunk, program.moves.size() - i));
    tasks.push_back([&finished, &left, &options, &program, &meter, chunk, i] {
      check_gouges(finished, chunk, options.tol);
      check_liberties(finished, program.moves, chunk, options.tol);
      check_stock_to_leave(left, program.moves, i, i + chunk.size());
      meter.add(chunk.size());
    });
  }
  for (CarvingWork& work : carvings)
    tasks.push_back([&part, &program, &options, &work] { check_carving(part, program, options.tol, work); });
  check_works(part, finished, program, options, works, std::move(tasks));
  meter.finish();
  if (!part.is_shape_stated) return findings_without_part(part, program, options);
  Findings findings = FindingsBuilder(part, program, works, carvings, options).build();
  findings.conditions = conditions_of_moves(program, options);
  if (auto pecks = stated_pecks_exceeded(part, program)) findings.conditions.push_back(*std::move(pecks));
  if (auto dwell = stated_dwell_missing(part, program)) findings.conditions.push_back(*std::move(dwell));
  if (findings.all.load)
    findings.all.thin_wall =
        thinnest_wall(finished.plain(), findings.all.load->max_force_n, *options.material);
  return findings;
}

namespace {

/// mm. Heights differing by less belong to one layer.
constexpr double kSameHeight = 1e-3;

Figures figures_not_asked(Figures figures) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  figures.uncut_mm2 = figures.uncut_thickness_mm = figures.unreachable_mm2 = none;
  figures.gouge_mm = figures.lower_bound_mm = none;
  return figures;
}

/// The tip of a cone that cuts with its flank alone is in no material: its depth is that of the flank at most.
Figures figures_with_flanks(const std::vector<const CheckedMove*>& moves, double top_z) {
  Figures figures = figures_of(moves, top_z);
  for (const CheckedMove* checked : moves) {
    if (!checked->load.by_flank) continue;
    const double deep = std::min(flank_height(*checked->tool), top_z - checked->low_z());
    figures.max_axial_mm = std::max(figures.max_axial_mm, deep);
  }
  return figures;
}

/// Heights of a tool's level moves through material, the highest first.
std::vector<LayerFindings> layers_of(const std::vector<const CheckedMove*>& moves, double top_z) {
  std::map<long long, std::vector<const CheckedMove*>, std::greater<>> by_height;
  for (const CheckedMove* checked : moves) {
    if (checked->cuts() && checked->is_flat() && !checked->move->is_vertical())
      by_height[std::llround(checked->low_z() / kSameHeight)].push_back(checked);
  }
  std::vector<LayerFindings> layers;
  for (const auto& [height, own] : by_height)
    layers.push_back({own.front()->low_z(), figures_not_asked(figures_of(own, top_z))});
  return layers;
}

/// Figures of the moves of one tool.
FeatureFindings row_of(const std::vector<const CheckedMove*>& own, double top) {
  FeatureFindings row;
  row.tool_number = own.front()->tool_number;
  row.name = "T" + std::to_string(row.tool_number);
  if (own.front()->tool) row.tool_diameter = own.front()->tool->diameter;
  row.figures = figures_not_asked(figures_with_flanks(own, top));
  row.layers = layers_of(own, top);
  return row;
}

}  // namespace

Findings findings_without_part(const Part& part, const CheckedProgram& program,
                               const VerifyOptions& options) {
  Findings findings;
  findings.without_part = true;
  std::vector<const CheckedMove*> all;
  std::vector<int> order;  // order of the tools' first moves
  std::map<int, std::vector<const CheckedMove*>> by_tool;
  for (const CheckedMove& checked : program.moves) {
    if (checked.earlier) continue;
    all.push_back(&checked);
    findings.move_engagement_deg.push_back(static_cast<float>(checked.load.max_deg));
    if (options.material) findings.move_force_n.push_back(force_of(checked));
    auto& own = by_tool[checked.tool_number];
    if (own.empty()) order.push_back(checked.tool_number);
    own.push_back(&checked);
  }
  findings.conditions = conditions_of_moves(program, options);
  findings.faults = faults_of_moves(part, program, options);
  fold_causes(part, program, options, findings.faults);
  sort_worst_first(findings.faults);
  findings.all = figures_not_asked(figures_with_flanks(all, part.top_z()));
  findings.all.clean = findings.faults.empty();
  for (const int number : order) findings.features.push_back(row_of(by_tool[number], part.top_z()));
  return findings;
}

}  // namespace clearcut::verify
