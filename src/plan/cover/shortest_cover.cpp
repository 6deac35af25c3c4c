#include "plan/cover/shortest_cover.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <span>

#include "base/progress.h"
#include "plan/cover/lattice_starts.h"
#include "plan/cover/places_left.h"
#include "plan/cover/shortening.h"

namespace clearcut::plan::cover {
namespace {

/// The pitch of witness points is widened if there would be more than these.
constexpr double kMostWitnesses = 4e6;
/// Paths are searched with a disc smaller by this share, so that uncleared places between witnesses vanish soon.
constexpr double kReserve = 2e-5;
/// A part of the search. Lengths in radii.
struct Phase {
  double pitch;            ///< pitch of witness points
  double reserve;          ///< reduction of the disc meanwhile, so that little is left between witnesses
  double of_rest;          ///< share of the remaining steps and of the remaining time
  double first_tolerance;  ///< longer paths are kept up to so much, at first
  double last_tolerance;
  bool learns;  ///< searches uncleared places between the witnesses
};
constexpr Phase kPhases[] = {{0.12, 0.02, 0.4, 0.06, 0.02, false},
                             {0.07, 0.006, 0.6, 0.02, 0.004, true},
                             {0.05, kReserve, 1, 0.004, 0.001, true}};
/// Of brief searches: uncleared slivers between strips as thin as these reserves escape the witnesses.
constexpr Phase kBriefPhases[] = {{0.12, 1e-3, 0.5, 0.02, 0.004, false}, {0.07, 5e-4, 1, 0.004, 0.001, true}};
std::span<const Phase> phases_of(bool quick) {
  return quick ? std::span<const Phase>(kBriefPhases) : std::span<const Phase>(kPhases);
}
/// Share of the steps and of the time after which no further initial path is tried.
constexpr double kBeginning = 0.2;
/// Square diameters from which one initial lattice is tried instead of several, and up to which any is: larger areas begin
/// with strips.
constexpr double kManySquares = 1000, kMostSquaresOfLattice = 3000;
/// Square diameters times edges of the area up to which lattices are ordered by legal moves.
constexpr double kMostDetours = 20'000;
/// Share of the steps and of the time reserved for the end.
constexpr double kFinishing = 0.15;
/// Steps counted for each move and for each edge of the boundary when places left between the witnesses are searched, and
/// for each witness point when the path is rebuilt.
constexpr std::uint64_t kStepsPerMove = 40, kStepsPerEdge = 40;
constexpr double kStepsPerWitness = 0.05;
/// Steps of corners, in radii: while searching and at the end.
constexpr double kCoarse = 0.02, kFine = 5e-4;
/// Least cost of a corner, in radii: of paths of nearly equal length those with few corners are searched faster.
constexpr double kLeastCornerPrice = 3e-4;
constexpr int kMostRepairs = 40, kPulledRepairs = 8;
/// Shares of the radius by which detours go farther than necessary, while the path is pulled taut and afterwards.
constexpr double kTightMargin = 1e-4, kWideMargin = 2e-3;
/// Shares of the search after which uncleared places between the witnesses are searched.
constexpr double kLearning = 0.34;

class Search {
 public:
  Search(const CoverTask& task, const CoverEffort& effort)
      : task_(task),
        effort_(effort),
        began_(std::chrono::steady_clock::now()),
        area_(task.area),
        squares_(area(task.area) / (4 * task.radius * task.radius)),
        is_quick_(effort.brief || squares_ > kMostSquaresOfLattice),
        phases_(phases_of(is_quick_)) {
    least_pitch_ = std::sqrt(area(task.area) / kMostWitnesses);
    pitch_ = std::max(phases_[0].pitch * task.radius, least_pitch_);
    reserve_ = phases_[0].reserve;
  }

  CoverResult run() {
    LatticeStartOptions options;
    options.radius = is_quick_ ? task_.radius * (1 - reserve_) : task_.radius;
    options.closed = task_.closed;
    options.seed = effort_.seed;
    options.cancel = effort_.cancel;
    if (task_.legal != nullptr) {
      options.bends = [this](Vec2 a, Vec2 b) {
        return task_.legal->bends(a, b).value_or(std::vector<Vec2>{});
      };
      options.may_stand = [this](Vec2 p) { return task_.legal->area().holds(p); };
      options.orders_by_detours = squares_ * static_cast<double>(area_.edges.size()) < kMostDetours;
    }
    options.most = squares_ < kManySquares ? 4 : 1;
    std::vector<std::vector<Vec2>> starts;
    if (is_quick_) starts = strip_starts(task_.area, options);
    if (starts.empty()) starts = lattice_starts(task_.area, options);
    std::size_t best = 0;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      // Of the few strips, which one is best is known only when they have been pulled taut.
      if (!candidates_.empty() && !is_quick_ &&
          (seconds() > kBeginning * effort_.seconds || spent_ > share_of_steps(kBeginning)))
        break;
      Candidate candidate = begin(starts[i]);
      if (!candidate.path) continue;
      tell("begun", candidate);
      candidates_.push_back(std::move(candidate));
      if (cost_of(candidates_.back()) < cost_of(candidates_[best])) best = candidates_.size() - 1;
    }
    CoverResult result;
    if (candidates_.empty()) return result;
    Candidate chosen = std::move(candidates_[best]);
    candidates_.clear();
    anneal(chosen);
    result.points = finish(chosen, result.proven);
    result.steps = spent(chosen);
    result.length = length_of(result.points);
    return result;
  }

 private:
  struct Candidate {
    std::unique_ptr<Witnesses> witnesses;
    std::unique_ptr<CoverPath> path;
    std::unique_ptr<Shortening> shortening;
  };

  double corner_price() const { return std::max(task_.corner_price, kLeastCornerPrice * task_.radius); }
  double cost_of(const Candidate& candidate) const {
    return candidate.path->length() + corner_price() * candidate.path->corners();
  }

  double length_of(const std::vector<Vec2>& points) const {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
    if (task_.closed && !points.empty()) length += distance(points.back(), points.front());
    return length;
  }

  Candidate build(std::vector<Vec2> points, const std::vector<Vec2>& extra) const {
    Candidate candidate;
    candidate.witnesses = std::make_unique<Witnesses>(task_.area, task_.radius * (1 - reserve_), pitch_);
    for (const Vec2 p : extra) candidate.witnesses->add_point(p, 0);
    const Vec2 last = points.back();
    while (points.size() < 3) points.push_back(last);
    candidate.path = std::make_unique<CoverPath>(points, task_.closed, *candidate.witnesses);
    ShorteningLimits limits;
    limits.cancel = effort_.cancel;
    limits.fixed_start = task_.start && !task_.closed;
    if (task_.legal != nullptr) {
      limits.may_move = [legal = task_.legal](Vec2 a, Vec2 b) { return legal->area().holds_line(a, b); };
      limits.bends = [legal = task_.legal](Vec2 a, Vec2 b) { return legal->bends(a, b); };
    }
    limits.corner_price = corner_price();
    candidate.shortening =
        std::make_unique<Shortening>(*candidate.path, *candidate.witnesses, std::move(limits), effort_.seed);
    candidate.shortening->set_to_and_fro(is_quick_);
    return candidate;
  }

  std::uint64_t share_of_steps(double share) const {
    return static_cast<std::uint64_t>(share * static_cast<double>(effort_.steps));
  }
  /// Steps of the search so far.
  std::uint64_t spent(const Candidate& candidate) const { return spent_ + candidate.shortening->work(); }
  /// The path is pulled taut only until so many steps of the search are spent.
  void limit(const Candidate& candidate, std::uint64_t most) const {
    candidate.shortening->set_most_work(most > spent_ ? most - spent_ : 0);
  }

  Candidate begin(std::vector<Vec2> points) {
    if (task_.start && !task_.closed) {
      if (distance(points.back(), *task_.start) < distance(points.front(), *task_.start))
        std::reverse(points.begin(), points.end());
      points.insert(points.begin(), *task_.start);
    }
    Candidate candidate = build(std::move(points), {});
    spent_ += steps_of_witnesses();
    if (!candidate.shortening->clear(candidate.witnesses->bare())) return {};
    limit(candidate, spent_ + share_of_steps(kBeginning));
    candidate.shortening->pull_all(kCoarse * task_.radius, 3);
    candidate.path->forget();
    spent_ += candidate.shortening->work();
    return candidate;
  }

  void tell(const char* what, const Candidate& candidate) const {
    if (effort_.progress)
      effort_.progress({what, candidate.path->length(), candidate.path->corners(), seconds()});
  }

  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

  /// Searches through all phases, as long as there are steps.
  void anneal(Candidate& candidate) {
    spent_ -= candidate.shortening->work();  // counted by itself until it is rebuilt
    for (std::size_t i = 0; i < phases_.size() && spent(candidate) < share_of_steps(1 - kFinishing); ++i) {
      if (i > 0) {
        pitch_ = std::max(phases_[i].pitch * task_.radius, least_pitch_);
        reserve_ = phases_[i].reserve;
        rebuild(candidate, candidate.path->points());
        limit(candidate, share_of_steps(1 - kFinishing));
        candidate.shortening->pull_all(kCoarse * task_.radius, 3);
        candidate.path->forget();
      }
      anneal(candidate, phases_[i]);
    }
  }

  void anneal(Candidate& candidate, const Phase& phase) {
    const double radius = task_.radius;
    const double begun = seconds(),
                 until = begun + (effort_.seconds - kFinishing * effort_.seconds - begun) * phase.of_rest;
    const std::uint64_t first = spent(candidate), end = share_of_steps(1 - kFinishing);
    const double steps = end > first ? static_cast<double>(end - first) * phase.of_rest : 0;
    limit(candidate, end);
    double done = steps > 0 ? 0 : 1, learned = 0;
    std::vector<Vec2> best = candidate.path->points();
    double best_cost = cost_of(candidate);
    for (long long i = 0; done < 1; ++i) {
      if (phase.learns && done >= learned) {
        candidate.shortening->set_brief(false);
        learn(candidate, kCoarse * radius);
        best = candidate.path->points();
        best_cost = cost_of(candidate);
        learned += kLearning;
        tell("completed", candidate);
      }
      candidate.shortening->set_brief(true);
      const double tolerance = radius * phase.first_tolerance *
                               base::pow(phase.last_tolerance / phase.first_tolerance, std::min(1.0, done));
      candidate.shortening->change(tolerance, kCoarse * radius);
      if (cost_of(candidate) < best_cost - 1e-3 * radius) {
        best = candidate.path->points();
        spent_ += best.size() / 8;
        best_cost = cost_of(candidate);
      }
      done = static_cast<double>(spent(candidate) - first) / steps;
      if (i % 16 == 0) {
        throw_if_cancelled(effort_.cancel);
        if (seconds() >= until)
          done = 1;
        else
          done = std::max(done, (seconds() - begun) / (until - begun));
      }
    }
    tell("searched", candidate);
    candidate.shortening->set_brief(false);
    if (cost_of(candidate) > best_cost) rebuild(candidate, best);
  }

  std::uint64_t steps_of_witnesses() const {
    return static_cast<std::uint64_t>(kStepsPerWitness * area(task_.area) / (pitch_ * pitch_));
  }

  void rebuild(Candidate& candidate, const std::vector<Vec2>& points) {
    spent_ += candidate.shortening->work() + steps_of_witnesses();
    candidate = build(points, extra_);
    candidate.shortening->clear(candidate.witnesses->bare());
    candidate.path->forget();
  }

  std::vector<Vec2> left_by(const std::vector<Vec2>& points) {
    std::vector<Vec2> line = points;
    if (task_.closed) line.push_back(points.front());
    Path path;
    for (std::size_t i = 1; i < line.size(); ++i)
      if (line[i] != line[i - 1]) path.push_back(Edge::line(line[i - 1], line[i]));
    if (path.empty()) path.push_back(Edge::line(line.front(), line.front()));
    spent_ += kStepsPerMove * path.size() + kStepsPerEdge * area_.edges.size();
    return places_left(area_, path, task_.radius);
  }

  /// Turns uncleared places between the witnesses into witnesses and clears them. False if there were none.
  bool learn(Candidate& candidate, double finest) {
    const std::vector<Vec2> left = left_by(candidate.path->points());
    std::vector<Vec2> bare;
    for (const Vec2 p : left) {
      const int moves = candidate.path->moves_within(p, candidate.witnesses->radius());
      candidate.witnesses->add_point(p, moves);
      if (moves == 0) bare.push_back(p);
    }
    extra_.insert(extra_.end(), left.begin(), left.end());
    candidate.path->forget();
    candidate.shortening->clear(std::move(bare));
    if (finest > 0) candidate.shortening->pull(candidate.path->changed_since(0), finest);
    candidate.path->forget();
    return !left.empty();
  }

  std::vector<Vec2> finish(Candidate& candidate, bool& proven) {
    limit(candidate, effort_.steps);
    if (!effort_.brief && seconds() < effort_.seconds)
      candidate.shortening->pull_all(kFine * task_.radius, 4);
    for (int repair = 0; repair < kMostRepairs && !proven; ++repair) {
      // The path is pulled taut again while there is time; then only completed, which ends soon.
      const bool pulls = !effort_.brief && repair < kPulledRepairs && seconds() < effort_.seconds &&
                         spent(candidate) < effort_.steps;
      candidate.shortening->set_margin(pulls ? kTightMargin : kWideMargin);
      proven = !learn(candidate, pulls ? kFine * task_.radius : 0);
    }
    return candidate.path->points();
  }

  const CoverTask& task_;
  const CoverEffort& effort_;
  std::chrono::steady_clock::time_point began_;
  CoveredArea area_;
  double squares_;  ///< the area in square diameters
  bool is_quick_;   ///< begins with strips
  std::span<const Phase> phases_;
  double pitch_ = 0, least_pitch_ = 0;
  double reserve_ = 0;
  std::uint64_t spent_ = 0;
  std::vector<Candidate> candidates_;
  std::vector<Vec2> extra_;
};

}  // namespace

CoverResult shortest_cover(const CoverTask& task, const CoverEffort& effort) {
  if (task.area.empty()) return {};
  return Search(task, effort).run();
}

}  // namespace clearcut::plan::cover
