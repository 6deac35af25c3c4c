#include "plan/contour/search.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "base/progress.h"
#include "base/work_budget.h"
#include "plan/common/retract_link.h"
#include "plan/contour/skeleton.h"
#include "plan/contour/tighten.h"

namespace clearcut::plan::contour {
namespace {

/// One plan that is tried.
struct Trial {
  double step;  ///< share of the diameter: wide steps need more mending in corners, narrow ones more rings
  double turn_cost;  ///< what a right-angled corner counts, as a share of the way that braking and speeding
                     ///< up take
};
/// The first few serve large pockets, all of them small ones.
constexpr Trial kTrials[] = {{0.95, 0.15}, {1.0, 0.15}, {0.9, 0.15}, {0.85, 0.15}, {0.8, 0.15},
                             {0.95, 0.0},  {0.9, 0.0},  {1.0, 0.0},  {0.85, 0.0},  {0.75, 0.15}};
/// Work allowed, in vertices of flexible ways: over all trials, and in one tree of rings. Rings that surround more
/// stay as they are; only their links and what they surround is pulled taut.
constexpr double kMostVerticesInAll = 800;
constexpr double kMostFlexible = 800;
/// Edges of rings; beyond, they stay without further search.
constexpr std::size_t kMostEdges = 60000;
/// Step of the rings where only the inner ones are flexible, as a share of the diameter.
constexpr double kLargeStep = 0.98;
/// mm by which passes that stay clear more than just so: above the margin of the proof.
constexpr double kSpareMargin = 0.002;
/// Flexible ways have about this many vertices per radius of length.
constexpr double kVerticesPerRadius = 1.7;
/// Share of the radius by which flexible ways may stray from the rings they start as.
constexpr double kChord = 0.004;
/// Rounds after which plans are compared, and further rounds of the best.
constexpr int kHeats = 3;
constexpr int kFinalRounds = 3;
/// Plans that stay to the end of the heats, and how much slower than the fastest they may be to be finished, too.
constexpr std::size_t kFinalists = 2;
constexpr double kAsGood = 1.01;
/// A plan that leaves a film has to be this much faster than one that does not.
constexpr double kFilmHandicap = 1.005;
/// mm. How far a lift crosses, for comparing with staying down.
constexpr double kAcross = 10;

/// The passes of one component, numbered anew and in the sense asked for, without lines on which the cutter
/// just fits.
std::vector<Pass> component_of(const std::vector<Pass>& passes, int component, bool turned_round) {
  std::vector<Pass> own;
  std::vector<int> number(passes.size(), -1);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (passes[i].component != component || (passes[i].parent < 0 && !passes[i].closed)) continue;
    number[i] = static_cast<int>(own.size());
    own.push_back(passes[i]);
    if (turned_round && own.back().closed) own.back().path = reversed(own.back().path);
    if (own.back().parent >= 0) own.back().parent = number[static_cast<std::size_t>(own.back().parent)];
  }
  return own;
}

/// Trials have nothing to do with one another. What waits for them takes up no other work meanwhile.
template <typename Work>
void in_parallel(std::size_t count, const Work& work) {
  const auto uncounted = [&](std::size_t i) {
    const WorkBudget own = WorkBudget::unlimited();
    work(i);
  };
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, count, uncounted); });
}

/// One component's contest.
class Search {
 public:
  Search(const ContourOptions& options, const HopHeights& heights, const LegalArea& legal, double radius,
         const Box& where, bool bare)
      : options_(options), legal_(legal), hop_(options.machine, options.feed, heights) {
    job_.bare = bare;
    job_.radius = radius;
    job_.legal = &legal;
    job_.where = where;
    job_.matters = [this](Vec2 p) { return job_.where.contains(p) && legal_.contains(p); };
  }
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  struct Contestant {
    std::vector<Pass> passes;
    double turn_cost = 0;
  };

  void enter(const std::vector<Contestant>& contestants) {
    std::vector<std::optional<Entry>> entries(contestants.size());
    in_parallel(contestants.size(), [&](std::size_t i) { entries[i] = entry_of(contestants[i]); });
    for (auto& entry : entries) entries_.push_back(*std::move(entry));
  }

  struct Winner {
    std::vector<Path> ways;
    double film = 0;  ///< mm
    double time = std::numeric_limits<double>::infinity();
  };

  /// After every round of all the slower half retires; the fastest runs to the end, and others that are as good as
  /// it. No ways when none is proven to clear everything.
  Winner winner() {
    if (entries_.empty()) return {};
    std::size_t running = entries_.size();
    for (int heat = 0; heat < kHeats; ++heat) {
      in_parallel(running, [&](std::size_t i) { run_heat(entries_[i]); });
      const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(running);
      std::sort(entries_.begin(), end, [](const Entry& a, const Entry& b) { return a.time < b.time; });
      running = std::min(running, std::max(kFinalists, (running + 1) / 2));
    }
    const auto promising = static_cast<std::size_t>(
        std::count_if(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(running),
                      [&](const Entry& entry) { return entry.time < kAsGood * entries_.front().time; }));
    std::vector<Winner> finished(std::max<std::size_t>(promising, 1));
    in_parallel(finished.size(), [&](std::size_t i) { finished[i] = finish(entries_[i]); });
    const auto best = std::min_element(finished.begin(), finished.end(),
                                       [](const Winner& a, const Winner& b) { return a.time < b.time; });
    Winner winner = std::move(*best);
    for (std::size_t i = finished.size(); i < entries_.size() && winner.ways.empty(); ++i)
      winner = finish(entries_[i]);
    return winner;
  }

 private:
  struct Entry {
    Tightener tightener;
    double time = 0;
  };

  Entry entry_of(const Contestant& contestant) const {
    throw_if_cancelled(options_.cancel);
    const double v = options_.feed.mm_per_s();
    TightenJob job = job_;
    job.turn_cost = contestant.turn_cost * v * v / options_.machine.acceleration;
    SkeletonOptions skeleton;
    skeleton.chord = kChord * job_.radius;
    if (!options_.outside_in) skeleton.begin = options_.start;
    skeleton.flexible = kMostFlexible / kVerticesPerRadius * job_.radius * options_.effort;
    skeleton.hop = hop_.time(kAcross) * options_.feed.mm_per_s();
    skeleton.legal = [&](Vec2 a, Vec2 b) { return legal_.holds_line(a, b); };
    return {Tightener(skeleton_of(contestant.passes, skeleton), job), 0};
  }

  void run_heat(Entry& entry) const {
    throw_if_cancelled(options_.cancel);
    entry.tightener.pull(1);
    entry.time = hop_.time_of(paths_of(entry.tightener.skeleton()), kAcross);
  }

  /// No ways when they are not proven to clear everything.
  Winner finish(Entry& entry) const {
    throw_if_cancelled(options_.cancel);
    entry.tightener.pull(kFinalRounds);
    if (!entry.tightener.finish()) return {};
    auto ways = paths_of(entry.tightener.skeleton());
    const double film = entry.tightener.film(),
                 time = hop_.time_of(ways, kAcross) * (film > 0 ? kFilmHandicap : 1);
    return {std::move(ways), film, time};
  }

  const ContourOptions& options_;
  const LegalArea& legal_;
  Hop hop_;
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

void replace_component(LayerPasses& layer, int component, const std::vector<Path>& ways) {
  std::vector<Pass> kept;
  std::vector<int> number(layer.passes.size(), -1);
  for (std::size_t i = 0; i < layer.passes.size(); ++i) {
    if (layer.passes[i].component == component) continue;
    number[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(layer.passes[i]));
    if (kept.back().parent >= 0) kept.back().parent = number[static_cast<std::size_t>(kept.back().parent)];
  }
  for (const auto& way : ways) {
    Pass pass;
    pass.path = way;
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
  if (edges > kMostEdges || options.effort <= 0) return;
  const bool large = vertices > kMostFlexible * options.effort;
  if (large) job.margin = kSpareMargin;
  const auto trials = std::clamp<std::size_t>(
      static_cast<std::size_t>(kMostVerticesInAll * options.effort / std::max(vertices, 1.0)), 1,
      std::size(kTrials));
  std::vector<std::vector<Pass>> variants(trials);
  in_parallel(trials, [&](std::size_t k) {
    RingJob own = job;
    own.step = [&, k](const RingNode&, const std::vector<AxisPiece>&) {
      return 2 * job.radius * (large ? kLargeStep : kTrials[k].step);
    };
    variants[k] = ring_passes(domains, own, tol);
  });
  double film = 0;
  int components = 0;
  for (const auto& pass : result.passes) components = std::max(components, pass.component + 1);
  for (int component = 0; component < components; ++component) {
    Box where;
    for (const auto& pass : component_of(result.passes, component, false)) where.add(box(pass.path));
    if (where.empty()) continue;
    Search search(options, hop_heights(layer), legal, job.radius, where, layer.bare);
    std::vector<Search::Contestant> contestants;
    for (std::size_t k = 0; k < trials; ++k) {
      auto own = component_of(variants[k], component, !options.wall_on_right);
      if (!own.empty()) contestants.push_back({std::move(own), kTrials[k].turn_cost});
    }
    search.enter(contestants);
    const auto winner = search.winner();
    film = std::max(film, winner.ways.empty() ? result.film : winner.film);
    if (!winner.ways.empty()) replace_component(result, component, winner.ways);
  }
  result.film = film;
}

}  // namespace clearcut::plan::contour
