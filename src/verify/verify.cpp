#include "verify/verify.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <thread>

#include "verify/coverage.h"
#include "verify/faults.h"
#include "verify/figures.h"
#include "verify/finished_part.h"
#include "verify/gouge.h"
#include "verify/judged_move.h"
#include "verify/load.h"

namespace clearcut {
namespace {

/// Arcs are cut into swaths below this sweep: less than half a turn.
constexpr double kSwathSweep = 2.0;
/// Moves judged as one task.
constexpr std::size_t kChunk = 2000;

/// Runs independent tasks on up to `threads` threads; each writes only what is its own. Rethrows the first
/// exception in task order.
void run_all(const std::vector<std::function<void()>>& tasks, int threads) {
  std::vector<std::exception_ptr> thrown(tasks.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      try {
        tasks[i]();
      } catch (...) {
        thrown[i] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < std::min<int>(threads, static_cast<int>(tasks.size())); ++i)
      helpers.emplace_back(work);
    work();
  }
  for (const std::exception_ptr& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
}

/// What is asked of the coverage of one feature.
struct FeatureWork {
  int feature = 0;
  int last_workingstep = 0;
  double smallest_radius = 0;
  double greatest_radius = 0;
  double allowance_side = 0;
  double allowance_floor = 0;
  CoverageQuestion question;
  Coverage coverage;
};

/// One entry a feature, in order of its first workingstep: the finest that any of its operations is to do.
std::vector<FeatureWork> works_of(const Part& part) {
  std::vector<FeatureWork> works;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const Workingstep& step = part.workplan[i];
    const Operation& operation = step.operation;
    const bool known = operation.tool >= 0 && operation.tool < static_cast<int>(part.tools.size());
    const double radius = known ? part.tools[operation.tool].radius() : 0;
    auto work = std::find_if(works.begin(), works.end(),
                             [&](const FeatureWork& w) { return w.feature == step.feature; });
    if (work == works.end()) {
      works.push_back(
          {step.feature, 0, radius, radius, operation.allowance_side, operation.allowance_floor, {}, {}});
      work = works.end() - 1;
    }
    work->last_workingstep = static_cast<int>(i);
    work->smallest_radius = std::min(work->smallest_radius, radius);
    work->greatest_radius = std::max(work->greatest_radius, radius);
    work->allowance_side = std::min(work->allowance_side, operation.allowance_side);
    work->allowance_floor = std::min(work->allowance_floor, operation.allowance_floor);
  }
  return works;
}

/// Adds the parts of a feed move whose tip is at or below z.
void append_swaths(const JudgedMove& judged, double z, std::vector<Swath>& out) {
  const Move& move = *judged.move;
  if (judged.low_z() > z) return;
  if (move.is_vertical()) return out.push_back({move.path, judged.radius()});
  double t0 = 0, t1 = 1;
  if (move.z_from > z) t0 = (z - move.z_from) / (move.z_to - move.z_from);
  if (move.z_to > z) t1 = (z - move.z_from) / (move.z_to - move.z_from);
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(std::abs(move.path.sweep()) * (t1 - t0) / kSwathSweep)));
  for (int i = 0; i < pieces; ++i) {
    const double a = t0 + (t1 - t0) * i / pieces, b = t0 + (t1 - t0) * (i + 1) / pieces;
    Edge piece = a == 0 && b == 1 ? move.path : move.path.part(a, b);
    if (piece.from == piece.to) piece.turn = Turn::kStraight;
    out.push_back({piece, judged.radius()});
  }
}

CoverageQuestion question_of(const Part& part, const FinishedPart& finished, const FeatureWork& work,
                             double z, const std::vector<JudgedMove>& moves, const Tolerances& tol) {
  const Feature& feature = part.features[work.feature];
  CoverageQuestion question{
      &finished, &feature.target, z + tol.gouge, work.smallest_radius, work.allowance_side, {}};
  const Box box = clearcut::box(feature.target);
  for (const JudgedMove& judged : moves) {
    if (!judged.feeds() || judged.radius() <= 0 || judged.low_z() > z + tol.uncut) continue;
    const Move& move = *judged.move;
    const Box path = move.is_vertical() ? Box{move.path.from, move.path.from} : move.path.box();
    if (path.grown(judged.radius()).overlaps(box)) append_swaths(judged, z + tol.uncut, question.swaths);
  }
  return question;
}

void judge_gouges(const FinishedPart& finished, std::span<JudgedMove> moves, const Tolerances& tol) {
  const JudgedMove* before = nullptr;  // ended outside the part
  for (JudgedMove& judged : moves) {
    if (judged.radius() <= 0) {
      before = nullptr;
      continue;
    }
    const bool joined = before && before->move->path.to == judged.move->path.from &&
                        before->move->z_to == judged.move->z_from && before->radius() == judged.radius();
    judged.gouge = gouge_of(finished, *judged.move, judged.radius(), tol.gouge, joined);
    const bool spared = !judged.gouge || judged.gouge->depth < judged.radius() / 2;
    before = spared && !judged.gouge.value_or(Gouge{}).floor ? &judged : nullptr;
  }
}

/// Feed length below which the area within reach cannot be cut in one level: area / (2 R), less the first
/// disc.
double lower_bound_of(const FeatureWork& work, const Feature& feature) {
  double perimeter = 0;
  for (const Region& region : feature.target) perimeter += length(region.edges());
  const double lean = std::tan(feature.wall_slope.radians()) * (feature.top_z - feature.floor_z);
  const double left = (work.allowance_side + lean) * perimeter;
  const double area = work.coverage.target_mm2 - work.coverage.unreachable_mm2 - left;
  const double r = work.greatest_radius;
  return r > 0 ? std::max(0.0, (area - kPi * r * r) / (2 * r)) : 0;
}

bool is_clean(const Figures& figures, const Tolerances& tol) {
  return figures.uncut_thickness_mm <= tol.uncut && figures.gouge_mm <= tol.gouge &&
         figures.rapid_in_material == 0;
}

void add_coverage(Figures& figures, const FeatureWork& work, double z) {
  figures.uncut_mm2 += work.coverage.uncut_mm2;
  figures.unreachable_mm2 += work.coverage.unreachable_mm2;
  if (work.coverage.thickness_mm < figures.uncut_thickness_mm) return;
  figures.uncut_thickness_mm = work.coverage.thickness_mm;
  if (work.coverage.worst) figures.uncut_at = Place{*work.coverage.worst, z, 0};
}

class FindingsBuilder {
 public:
  FindingsBuilder(const Part& part, const JudgedProgram& program, const std::vector<FeatureWork>& works,
                  const VerifyOptions& options)
      : part_(part), program_(program), works_(works), options_(options) {}

  Findings build() {
    std::vector<const JudgedMove*> all;
    std::vector<std::vector<const JudgedMove*>> by_step(part_.workplan.size());
    for (const JudgedMove& judged : program_.moves) {
      all.push_back(&judged);
      if (judged.workingstep >= 0) by_step[judged.workingstep].push_back(&judged);
    }
    findings_.faults = faults_of_moves(part_, program_, options_);
    findings_.all = figures_of(all, part_.top_z());
    for (std::size_t i = 0; i < by_step.size(); ++i) add_feature(static_cast<int>(i), by_step[i]);
    for (const FeatureWork& work : works_) judge_coverage(work);
    sort_worst_first(findings_.faults);
    set_clean();
    return std::move(findings_);
  }

 private:
  void add_feature(int workingstep, const std::vector<const JudgedMove*>& moves) {
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
    std::vector<std::vector<const JudgedMove*>> by_layer(heights.size());
    for (const JudgedMove* judged : moves) {
      if (judged->layer >= 0) by_layer[judged->layer].push_back(judged);
    }
    for (std::size_t i = 0; i < heights.size(); ++i) {
      feature.layers.push_back({heights[i], figures_of(by_layer[i], part_.top_z())});
    }
    findings_.features.push_back(std::move(feature));
  }

  void judge_coverage(const FeatureWork& work) {
    const Feature& feature = part_.features[work.feature];
    const double z = feature.floor_z + work.allowance_floor;
    FeatureFindings& found = findings_.features[work.last_workingstep];
    add_coverage(findings_.all, work, z);
    add_coverage(found.figures, work, z);
    if (!found.layers.empty()) add_coverage(found.layers.back().figures, work, z);
    for (Fault& fault :
         faults_of_coverage(feature, work.coverage, !work.question.swaths.empty(), z, options_.tol)) {
      findings_.faults.push_back(std::move(fault));
    }
    const double bound = lower_bound_of(work, feature);
    for (FeatureFindings& step : findings_.features) {
      if (part_.workplan[step.workingstep].feature != work.feature) continue;
      for (LayerFindings& layer : step.layers) {
        // A level that is shorter does not clear the feature.
        if (layer.figures.feed_mm < bound) continue;
        layer.figures.lower_bound_mm = bound;
        step.figures.lower_bound_mm += bound;
        findings_.all.lower_bound_mm += bound;
      }
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
  const JudgedProgram& program_;
  const std::vector<FeatureWork>& works_;
  const VerifyOptions& options_;
  Findings findings_;
};

}  // namespace

Findings verify(const Part& part, const Toolpath& toolpath, const VerifyOptions& options) {
  const FinishedPart finished(part);
  JudgedProgram program = judged_program(part, toolpath, options.machine);
  std::vector<FeatureWork> works = works_of(part);

  std::vector<std::function<void()>> tasks;
  tasks.push_back([&] { measure_load(part, program.moves, {options.tol, options.engagement_limit_deg}); });
  for (FeatureWork& work : works) {
    tasks.push_back([&] {
      const double z = part.features[work.feature].floor_z + work.allowance_floor;
      work.question = question_of(part, finished, work, z, program.moves, options.tol);
      if (work.smallest_radius > 0) work.coverage = coverage_of(work.question, options.tol);
    });
  }
  for (std::size_t i = 0; i < program.moves.size(); i += kChunk) {
    const std::span<JudgedMove> chunk(program.moves.data() + i, std::min(kChunk, program.moves.size() - i));
    tasks.push_back([&finished, &options, chunk] { judge_gouges(finished, chunk, options.tol); });
  }
  run_all(tasks, options.threads);
  return FindingsBuilder(part, program, works, options).build();
}

}  // namespace clearcut
