#include "verify/feature_work.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <span>
#include <stop_token>
#include <thread>

#include "base/progress.h"
#include "verify/blend.h"

namespace clearcut::verify {
namespace {

using Tasks = std::vector<std::function<void()>>;

/// Arcs are cut into swaths below this sweep: less than half a turn.
constexpr double kSwathSweep = 2.0;

/// Runs independent tasks on up to `threads` threads; each writes only what is its own. Rethrows the first
/// exception in task order. No task is begun any more once `cancel` asks to stop: then it throws Cancelled.
void run_all(const Tasks& tasks, int threads, const std::stop_token& cancel) {
  std::vector<std::exception_ptr> thrown(tasks.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size() && !cancel.stop_requested(); i = next++) {
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
  throw_if_cancelled(cancel);
}

/// Adds the parts of a feed move whose tip is at or below z, as wide as they are at `level`.
void append_swaths(const JudgedMove& judged, double z, double level, std::vector<Swath>& out) {
  const Move& move = *judged.move;
  const double tip = move.is_vertical() ? judged.low_z() : std::max(move.z_from, move.z_to);
  const double radius = radius_at(*judged.tool, level - tip);
  if (radius <= 0) return;
  if (move.is_vertical()) return out.push_back({move.path, radius});
  double t0 = 0, t1 = 1;
  if (move.z_from > z) t0 = (z - move.z_from) / (move.z_to - move.z_from);
  if (move.z_to > z) t1 = (z - move.z_from) / (move.z_to - move.z_from);
  const double sweep = std::abs(move.path.sweep()) * (t1 - t0);
  const int pieces = std::max(1, static_cast<int>(std::ceil(sweep / kSwathSweep)));
  for (int i = 0; i < pieces; ++i) {
    const double a = t0 + (t1 - t0) * i / pieces, b = t0 + (t1 - t0) * (i + 1) / pieces;
    Edge piece = a == 0 && b == 1 ? move.path : move.path.part(a, b);
    if (piece.from == piece.to) piece.turn = Turn::kStraight;
    out.push_back({piece, radius});
  }
}

/// Feed moves near the target whose tips count for a level at or below z.
bool counts_at(const JudgedMove& judged, double z, const Box& target, const Tolerances& tol) {
  if (!judged.feeds() || !judged.tool || judged.low_z() > z) return false;
  const Move& move = *judged.move;
  const Box path = move.is_vertical() ? Box{move.path.from, move.path.from} : move.path.box();
  return path.grown(judged.radius() + 2 * tol.uncut).overlaps(target);
}

/// What feed moves sweep of a level, as far as tips that miss it by `tol.uncut` count for it. Those that come within 2
/// tol.uncut of the target: what a swath almost reaches is thin.
std::vector<Swath> swaths_at(double level, const Box& target, const std::vector<JudgedMove>& moves,
                             const Tolerances& tol) {
  const double z = level + tol.uncut;
  std::vector<Swath> swaths;
  for (const JudgedMove& judged : moves) {
    if (counts_at(judged, z, target, tol)) append_swaths(judged, z, level, swaths);
  }
  return swaths;
}

/// The most that the control may leave the paths of those moves: it rounds corners, or takes another arc.
double liberty_at(double z, const Box& target, const std::vector<JudgedMove>& moves, const Tolerances& tol) {
  double most = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!counts_at(moves[i], z, target, tol)) continue;
    most = std::max(most, moves[i].doubt);
    if (i > 0 && moves[i].path_tolerance > most)
      most = std::max(most, corner_tolerance(std::span(&moves[i - 1], 2)));
  }
  return most;
}

/// How far above the level the highest level move stands that counts for it.
double height_above(double level, const Box& target, const std::vector<JudgedMove>& moves,
                    const Tolerances& tol) {
  double most = 0;
  for (const JudgedMove& judged : moves) {
    const bool counts = judged.is_flat() && counts_at(judged, level + tol.uncut, target, tol);
    if (counts) most = std::max(most, judged.low_z() - level);
  }
  return most;
}

class WorkJudge {
 public:
  WorkJudge(const Part& part, const FinishedPart& finished, const JudgedProgram& program,
            const VerifyOptions& options)
      : part_(part), finished_(finished), program_(program), options_(options) {}

  void judge_level(const FeatureWork& work, LevelCoverage& level) const {
    if (work.smallest_radius <= 0) return;
    const Tolerances& tol = options_.tol;
    const Feature& feature = part_.features[work.feature];
    CoverageQuestion question;
    question.part = &finished_;
    question.target = &feature.target;
    question.z = level.z + tol.gouge;
    question.radius = work.smallest_radius;
    question.flat = work.smallest_flat;
    question.allowance = work.allowance_side;
    question.swaths = swaths_at(level.z, box(feature.target), program_.moves, tol);
    question.path_tolerance = liberty_at(level.z + tol.uncut, box(feature.target), program_.moves, tol);
    question.above = height_above(level.z, box(feature.target), program_.moves, tol);
    level.any_cut = !question.swaths.empty();
    level.coverage = coverage_of(question, tol);
  }

  void add_layers(FeatureWork& work) const {
    for (std::size_t i = 0; i < part_.workplan.size(); ++i) {
      const Workingstep& step = part_.workplan[i];
      // What leaves stock on the walls for a later step makes no steps in them.
      if (step.feature != work.feature || step.operation.allowance_side > work.allowance_side) continue;
      for (const double z : program_.layers[i]) {
        if (z > work.floor.z + options_.tol.uncut) work.layers.push_back({z, false, {}});
      }
    }
    const auto higher = [](const LevelCoverage& a, const LevelCoverage& b) { return a.z > b.z; };
    std::sort(work.layers.begin(), work.layers.end(), higher);
  }

  bool leans(const FeatureWork& work) const { return part_.features[work.feature].wall_slope.radians() > 0; }

 private:
  const Part& part_;
  const FinishedPart& finished_;
  const JudgedProgram& program_;
  const VerifyOptions& options_;
};

void refine(FeatureWork& work, const Operation& operation, double radius, double flat) {
  if (radius < work.smallest_radius) {
    work.smallest_radius = radius;
    work.smallest_flat = flat;
  }
  work.greatest_radius = std::max(work.greatest_radius, radius);
  work.allowance_side = std::min(work.allowance_side, operation.allowance_side);
  work.allowance_floor = std::min(work.allowance_floor, operation.allowance_floor);
  if (operation.scallop)
    work.scallop = std::min(work.scallop.value_or(*operation.scallop), *operation.scallop);
}

}  // namespace

std::optional<Scallop> scallop_of(const Feature& feature, const FeatureWork& work) {
  if (feature.wall_slope.radians() <= 0) return std::nullopt;
  Scallop scallop{0, work.scallop, feature.top_z};
  double above = feature.top_z;
  const auto look_at = [&](double z) {
    const double step = (above - z) * std::sin(feature.wall_slope.radians());
    if (step > scallop.height_mm) scallop.height_mm = step, scallop.z = z;
    above = z;
  };
  for (const LevelCoverage& layer : work.layers) look_at(layer.z);
  look_at(work.floor.z);
  return scallop;
}

std::vector<FeatureWork> works_of(const Part& part) {
  std::vector<FeatureWork> works;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const Workingstep& step = part.workplan[i];
    const Operation& operation = step.operation;
    if (part.features[static_cast<std::size_t>(step.feature)].carving) continue;
    const bool known = operation.tool >= 0 && operation.tool < static_cast<int>(part.tools.size());
    const Tool tool = known ? part.tools[operation.tool] : Tool{};
    if (is_carved(part.features[static_cast<std::size_t>(step.feature)], tool)) continue;
    auto work = std::find_if(works.begin(), works.end(),
                             [&](const FeatureWork& w) { return w.feature == step.feature; });
    if (work == works.end()) {
      FeatureWork first;
      first.feature = step.feature;
      first.smallest_radius = first.greatest_radius = tool.radius();
      first.smallest_flat = flat_radius_of(tool);
      first.allowance_side = operation.allowance_side;
      first.allowance_floor = operation.allowance_floor;
      works.push_back(first);
      work = works.end() - 1;
    }
    work->last_workingstep = static_cast<int>(i);
    refine(*work, operation, tool.radius(), flat_radius_of(tool));
    work->floor.z = part.features[step.feature].floor_z + work->allowance_floor;
  }
  return works;
}

void judge_works(const Part& part, const FinishedPart& finished, const JudgedProgram& program,
                 const VerifyOptions& options, std::vector<FeatureWork>& works, Tasks beside) {
  const WorkJudge judge(part, finished, program, options);
  const auto add_layer_tasks = [&](FeatureWork& work, Tasks& tasks) {
    judge.add_layers(work);
    for (LevelCoverage& layer : work.layers) {
      tasks.push_back([&judge, &work, &layer] { judge.judge_level(work, layer); });
    }
  };
  Tasks first = std::move(beside);
  for (FeatureWork& work : works) {
    first.push_back([&judge, &work] { judge.judge_level(work, work.floor); });
    if (judge.leans(work)) add_layer_tasks(work, first);
  }
  run_all(first, options.threads, options.cancel);

  Tasks second;
  for (FeatureWork& work : works) {
    const bool left = work.floor.any_cut && work.floor.coverage.thickness_mm > options.tol.uncut;
    if (left && work.layers.empty()) add_layer_tasks(work, second);
  }
  run_all(second, options.threads, options.cancel);
}

}  // namespace clearcut::verify
