#include <algorithm>
#include <limits>
#include <optional>

#include "base/parallel.h"
#include "base/progress.h"
#include "base/work_budget.h"
#include "plan/common/machine_clock.h"
#include "plan/contour/passes.h"
#include "plan/contour/skeleton/skeleton.h"
#include "plan/contour/skeleton/tighten.h"

namespace clearcut::plan::contour {
namespace {

/// One tried plan.
struct Variant {
  double step;  ///< share of the diameter: wide steps leave more in corners, narrow ones need more rings
  /// Cost of a corner of a right angle, as a share of the path needed by the machine for braking and accelerating.
  double turn_cost;
};
/// Large pockets use the first few of these, small ones all.
constexpr Variant kVariants[] = {{0.95, 0.15}, {1.0, 0.15}, {0.9, 0.15}, {0.85, 0.15}, {0.8, 0.15},
                                 {0.95, 0.0},  {0.9, 0.0},  {1.0, 0.0},  {0.85, 0.0},  {0.75, 0.15}};
/// Greatest number of vertices of flexible paths: over all candidates, and in one tree of rings. Rings around larger
/// trees are unchanged, and only links and the paths inside are shortened.
constexpr double kMostVerticesInAll = 800;
constexpr double kMostFlexible = 800;
/// There is no search if rings have more edges than kMostEdges, or if all passes but those at walls would have more
/// vertices than kMostVertices, because the search would take more than about 5 s.
constexpr std::size_t kMostEdges = 60000;
constexpr double kMostVertices = 40000;
/// Step of the rings if only inner ones are flexible, as a share of the diameter.
constexpr double kLargeStep = 0.98;
/// mm; overlap of passes that are not shortened: more than the margin of the proof.
constexpr double kSpareMargin = 0.002;
/// Number of vertices of flexible paths for each radius of length, about.
constexpr double kVerticesPerRadius = 1.7;
/// Share of the radius by which flexible paths may deviate from their initial rings.
constexpr double kChord = 0.004;
/// Number of rounds after which plans are compared, and of further rounds for the best.
constexpr int kCompareRounds = 3;
constexpr int kFinalRounds = 3;
/// Number of plans kept until the last comparison; factor by which a plan may be slower than the fastest and is still
/// finished.
constexpr std::size_t kFinalists = 2;
constexpr double kAsGood = 1.01;
/// A plan with a residual must be faster by this factor than one without.
constexpr double kResidualHandicap = 1.005;
/// mm. Assumed distance of a retract link.
constexpr double kAcross = 10;

/// Replaces the indices of other passes in `pass` by their new ones.
void renumber(Pass& pass, const std::vector<int>& number) {
  if (pass.parent >= 0) pass.parent = number[static_cast<std::size_t>(pass.parent)];
  for (int& before : pass.after) before = number[static_cast<std::size_t>(before)];
}

/// The passes of one component with numbers of their own, in the requested direction, without lines on which the
/// cutter just fits.
std::vector<Pass> component_of(const std::vector<Pass>& passes, int component, bool turned_round) {
  std::vector<Pass> own;
  std::vector<int> number(passes.size(), -1);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (passes[i].component != component || (passes[i].parent < 0 && !passes[i].closed)) continue;
    number[i] = static_cast<int>(own.size());
    own.push_back(passes[i]);
    if (turned_round && own.back().closed) own.back().path = reversed(own.back().path);
    renumber(own.back(), number);
  }
  return own;
}

/// Runs work(i) for all i in parallel. Isolated, so that a waiting thread takes up no other work meanwhile.
template <typename Work>
void in_parallel(std::size_t count, const Work& work) {
  const auto uncounted = [&](std::size_t i) {
    const WorkBudget own = WorkBudget::unlimited();
    work(i);
  };
  isolated_parallel_for(std::size_t{0}, count, uncounted);
}

/// Compares candidate plans for one component.
class Search {
 public:
  Search(const ContourOptions& options, const RetractHeights& heights, const LegalArea& legal, double radius,
         const Box& where, bool bare)
      : options_(options), legal_(legal), retract_(options.machine, options.feed, heights) {
    job_.bare = bare;
    job_.radius = radius;
    job_.legal = &legal;
    job_.where = where;
    job_.matters = [this](Vec2 p) { return job_.where.contains(p) && legal_.contains(p); };
  }
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  struct Candidate {
    std::vector<Pass> passes;
    double turn_cost = 0;
  };

  void enter(const std::vector<Candidate>& candidates) {
    std::vector<std::optional<Entry>> entries(candidates.size());
    in_parallel(candidates.size(), [&](std::size_t i) { entries[i] = entry_of(candidates[i]); });
    for (auto& entry : entries) entries_.push_back(*std::move(entry));
  }

  struct Fastest {
    std::vector<Path> paths;
    double residual = 0;  ///< mm; permitted thickness of its residual
    double time = std::numeric_limits<double>::infinity();
  };

  /// After every round the slower half is dropped. The fastest is finished, and others that are nearly as
  /// fast. No paths if none is proven to clear everything.
  Fastest fastest() {
    if (entries_.empty()) return {};
    std::size_t running = entries_.size();
    for (int round = 0; round < kCompareRounds; ++round) {
      in_parallel(running, [&](std::size_t i) { run_round(entries_[i]); });
      const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(running);
      std::sort(entries_.begin(), end, [](const Entry& a, const Entry& b) { return a.time < b.time; });
      running = std::min(running, std::max(kFinalists, (running + 1) / 2));
    }
    const auto promising = static_cast<std::size_t>(
        std::count_if(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(running),
                      [&](const Entry& entry) { return entry.time < kAsGood * entries_.front().time; }));
    std::vector<Fastest> finished(std::max<std::size_t>(promising, 1));
    in_parallel(finished.size(), [&](std::size_t i) { finished[i] = finish(entries_[i]); });
    const auto best = std::min_element(finished.begin(), finished.end(),
                                       [](const Fastest& a, const Fastest& b) { return a.time < b.time; });
    Fastest fastest = std::move(*best);
    for (std::size_t i = finished.size(); i < entries_.size() && fastest.paths.empty(); ++i)
      fastest = finish(entries_[i]);
    return fastest;
  }

 private:
  struct Entry {
    Tightener tightener;
    double time = 0;
  };

  Entry entry_of(const Candidate& candidate) const {
    throw_if_cancelled(options_.cancel);
    const double v = options_.feed.mm_per_s();
    TightenJob job = job_;
    job.turn_cost = candidate.turn_cost * v * v / options_.machine.acceleration;
    SkeletonOptions skeleton;
    skeleton.chord = kChord * job_.radius;
    if (!options_.outside_in) skeleton.begin = options_.start;
    skeleton.flexible = kMostFlexible / kVerticesPerRadius * job_.radius * options_.effort;
    skeleton.retract_cost = retract_.time(kAcross) * options_.feed.mm_per_s();
    skeleton.legal = [&](Vec2 a, Vec2 b) { return legal_.holds_line(a, b); };
    return {Tightener(skeleton_of(candidate.passes, skeleton), job), 0};
  }

  void run_round(Entry& entry) const {
    throw_if_cancelled(options_.cancel);
    entry.tightener.pull(1);
    entry.time = retract_.time_of(paths_of(entry.tightener.skeleton()), kAcross);
  }

  /// Finishes one candidate; no paths if the candidate is not proven to clear everything.
  Fastest finish(Entry& entry) const {
    throw_if_cancelled(options_.cancel);
    entry.tightener.pull(kFinalRounds);
    if (!entry.tightener.finish()) return {};
    auto paths = paths_of(entry.tightener.skeleton());
    const double residual = entry.tightener.residual(),
                 time = retract_.time_of(paths, kAcross) * (residual > 0 ? kResidualHandicap : 1);
    return {std::move(paths), residual, time};
  }

  const ContourOptions& options_;
  const LegalArea& legal_;
  RetractLink retract_;
  TightenJob job_;
  std::vector<Entry> entries_;
};

double vertices_of(const std::vector<Pass>& passes, double radius) {
  double length_of_inner = 0;
  for (const auto& pass : passes) {
    if (pass.parent >= 0) length_of_inner += length(pass.path);
  }
  return length_of_inner / radius * kVerticesPerRadius;
}

void replace_component(LayerPasses& layer, int component, const std::vector<Path>& paths) {
  std::vector<Pass> kept;
  std::vector<int> number(layer.passes.size(), -1);
  for (std::size_t i = 0; i < layer.passes.size(); ++i) {
    if (layer.passes[i].component == component) continue;
    number[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(layer.passes[i]));
    renumber(kept.back(), number);
  }
  for (const auto& path : paths) {
    Pass pass;
    pass.path = path;
    pass.component = component;
    pass.reversible = false;
    kept.push_back(std::move(pass));
  }
  layer.passes = std::move(kept);
}

}  // namespace

void shorten_passes(const std::vector<Domain>& domains, RingJob job, const Layer& layer,
                    const ContourOptions& options, const Tolerances& tol, LayerPasses& result) {
  const LegalArea legal(result.legal);
  const double vertices = vertices_of(result.passes, job.radius);
  std::size_t edges = 0;
  for (const auto& pass : result.passes) edges += pass.path.size();
  if (edges > kMostEdges || vertices > kMostVertices || options.effort <= 0) return;
  const bool large = vertices > kMostFlexible * options.effort;
  if (large) job.margin = kSpareMargin;
  const auto count = std::clamp<std::size_t>(
      static_cast<std::size_t>(kMostVerticesInAll * options.effort / std::max(vertices, 1.0)), 1,
      std::size(kVariants));
  std::vector<std::vector<Pass>> variants(count);
  in_parallel(count, [&](std::size_t k) {
    RingJob own = job;
    own.step = [&, k](const RingNode&, const std::vector<AxisPiece>&) {
      return 2 * job.radius * (large ? kLargeStep : kVariants[k].step);
    };
    variants[k] = ring_passes(domains, own, tol).passes;
  });
  double residual = 0;
  int components = 0;
  for (const auto& pass : result.passes) components = std::max(components, pass.component + 1);
  for (int component = 0; component < components; ++component) {
    Box where;
    for (const auto& pass : component_of(result.passes, component, false)) where.add(box(pass.path));
    if (where.empty()) continue;
    Search search(options, retract_heights(layer), legal, job.radius, where, layer.bare);
    std::vector<Search::Candidate> candidates;
    for (std::size_t k = 0; k < count; ++k) {
      auto own = component_of(variants[k], component, !options.wall_on_right);
      if (!own.empty()) candidates.push_back({std::move(own), kVariants[k].turn_cost});
    }
    search.enter(candidates);
    const auto fastest = search.fastest();
    residual = std::max(residual, fastest.paths.empty() ? result.residual : fastest.residual);
    if (!fastest.paths.empty()) replace_component(result, component, fastest.paths);
  }
  result.residual = residual;
}

}  // namespace clearcut::plan::contour
