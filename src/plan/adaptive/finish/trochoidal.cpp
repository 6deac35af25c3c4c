#include "plan/adaptive/finish/trochoidal.h"

#include <algorithm>
#include <cmath>

#include "plan/adaptive/clearing/arcs.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// Share of the tool radius: distance between samples along the wall.
constexpr double kWallStep = 0.03;
/// Shares of the tool radius: lengths of moves off the wall, the first and the longest; factor from one to
/// the next.
constexpr double kFirst = 0.01;
constexpr double kLongest = 0.06;
constexpr double kGrow = 1.4;
/// Shares of the tool radius: length without engagement that ends a step, after it has cut something and
/// before.
constexpr double kAir = 0.15;
constexpr double kFarAir = 0.6;
/// Share of the tool radius: radius of the tightest turn to the right, towards the material.
constexpr double kRightTurn = 0.5;
/// mm. Length of the shortest move off the wall.
constexpr double kShortest = 4e-4;
/// mm. Error of places on the wall, and of the arcs that are fitted to the moves.
constexpr double kPlace = 1e-4;
constexpr double kFitTolerance = 2e-4;
/// Radians. Greatest turn within a move; greatest turn where the cutter leaves the wall, and within the
/// shortest moves.
constexpr double kTurn = 0.16;
constexpr double kLeave = 1.9;
/// Radians. Error of turns; an engagement this much below the limit counts as at the limit.
constexpr double kAngle = 1e-3;
constexpr double kNearLimit = 5e-4;
/// After this many moves, or changes between the wall and the open, a step ends.
constexpr int kMostSteps = 4000;
constexpr int kMostRuns = 30;

}  // namespace

void TrochoidalSteps::begin(double s, double until) {
  s_ = s;
  until_ = until;
  path_.clear();
  run_.clear();
  air_ = engaged_ = 0;
  state_ = {wall_.at(s), wall_.heading(s)};
}

Path TrochoidalSteps::trochoidal_step(double s, double until) {
  begin(s, until);
  return run(Next::kWall);
}

Path TrochoidalSteps::trochoidal_step_from_aside(Vec2 approach_point, double s) {
  begin(s, s + 2 * wall_.length());
  state_.point = approach_point;
  return run(Next::kFree);
}

Path TrochoidalSteps::run(Next next) {
  for (int i = 0; i < kMostRuns && next != Next::kDone; ++i)
    next = next == Next::kWall ? along_wall() : freely();
  if (engaged_ <= 0) return {};
  return std::move(path_);
}

double TrochoidalSteps::wall_engagement(double s) const {
  return remaining_.engagement(wall_.at(s), wall_.heading(s));
}

/// Adds a move to the lengths with and without engagement. False if the cutter has cut nothing for too long.
bool TrochoidalSteps::counts_air(double step, double engagement) {
  if (engagement > EngagementTolerance::kNone) {
    engaged_ += step;
    air_ = 0;
  } else {
    air_ += step;
  }
  return air_ <= (engaged_ > 0 ? kAir : kFarAir) * radius_;
}

TrochoidalSteps::Next TrochoidalSteps::along_wall() {
  const double first = s_;
  Next next = Next::kDone;
  while (s_ < until_) {
    const double to = std::min({s_ + kWallStep * radius_, std::max(wall_.edge_end(s_), s_ + kPlace), until_});
    const auto engagement = [&](double s) {
      return std::max(wall_engagement(s - 1e-7), wall_engagement(s + 1e-7));
    };
    const double ahead = engagement(to);
    if (ahead > limit_) {
      double good = s_, bad = to;
      while (bad - good > kPlace) (engagement((good + bad) / 2) > limit_ ? bad : good) = (good + bad) / 2;
      if (good > s_) counts_air(good - s_, limit_);
      s_ = good;
      next = Next::kFree;
      break;
    }
    const bool on = counts_air(to - s_, ahead);
    s_ = to;
    if (!on) break;
  }
  if (s_ - first > kPlace) {
    for (const Edge& edge : wall_.part(first, s_)) path_.push_back(edge);
  }
  state_ = {wall_.at(s_), wall_.heading(s_)};
  return next;
}

TrochoidalSteps::State TrochoidalSteps::stepped(double step, double turn) const {
  const Vec2 heading = rotated(state_.heading, turn);
  return {state_.point + heading * step, heading};
}

/// The least turn to the left, between `least` and `most`, after which a move of `step` mm keeps the limit.
std::optional<double> TrochoidalSteps::step_turn(double step, double least, double most) const {
  const auto excess = [&](double turn) {
    const State next = stepped(step, turn);
    return remaining_.engagement(next.point, next.heading) - limit_;
  };
  double above = excess(least);
  if (above <= 0) return least;
  double below = excess(most);
  if (below > 0) return std::nullopt;
  // By the secant where it converges, else by bisection: the engagement may jump.
  bool halve = false;
  while (most - least > kAngle && below < -kNearLimit) {
    const double width = most - least;
    const double share = std::clamp(above / (above - below) + kNearLimit / width, 0.05, 0.95);
    const double turn = least + (halve ? 0.5 : share) * width;
    const double there = excess(turn);
    (there <= 0 ? most : least) = turn;
    (there <= 0 ? below : above) = there;
    halve = most - least > width / 2;
  }
  return most;
}

void TrochoidalSteps::take(Vec2 p) {
  if (run_.empty()) run_.push_back(state_.point);
  run_.push_back(p);
}

/// Beside a wall an arc through places that are all legal may bulge into it between two of them; lines do not.
void TrochoidalSteps::end_run() {
  if (run_.size() > 1) {
    Path fitted = fit_arcs(run_, kFitTolerance);
    if (!std::all_of(fitted.begin(), fitted.end(),
                     [this](const Edge& edge) { return remaining_.is_legal(edge); })) {
      fitted.clear();
      for (std::size_t i = 1; i < run_.size(); ++i) fitted.push_back(Edge::line(run_[i - 1], run_[i]));
    }
    path_.insert(path_.end(), fitted.begin(), fitted.end());
  }
  run_.clear();
}

TrochoidalSteps::Next TrochoidalSteps::freely() {
  step_ = kFirst * radius_;
  bool first = true;
  for (int i = 0; i < kMostSteps; ++i) {
    const bool shortest = step_ <= kShortest;
    const double most = first || shortest ? kLeave : kTurn;
    const auto turn = step_turn(step_, first ? 0 : -step_ / (kRightTurn * radius_), most);
    if (!turn && shortest) break;
    if (!turn || (first && !shortest && *turn > kTurn)) {
      step_ = std::max(kShortest, step_ / 2);
      continue;
    }
    const State next = stepped(step_, *turn);
    if (!is_legal(next.point)) return meet_wall(next.point);
    const bool on = counts_air(step_, remaining_.engagement(next.point, next.heading));
    take(next.point);
    state_ = next;
    if (!on) break;
    if (*turn < kTurn / 2) step_ = std::min(step_ * kGrow, kLongest * radius_);
    first = false;
  }
  end_run();
  return Next::kDone;
}

/// Goes to the wall where it lies between the cutter and `outside`, a point beyond it.
TrochoidalSteps::Next TrochoidalSteps::meet_wall(Vec2 outside) {
  double in = 0, out = 1;
  while ((out - in) * distance(state_.point, outside) > kPlace) {
    const double middle = (in + out) / 2;
    (is_legal(lerp(state_.point, outside, middle)) ? in : out) = middle;
  }
  const Vec2 met = lerp(state_.point, outside, in);
  const auto hit = wall_.nearest(met);
  if (in > 0) take(met);
  end_run();
  state_.point = met;
  if (hit.distance > 2 * kPlace) return Next::kDone;
  // A step does not go back to where it has already been.
  const double lap = std::ceil((s_ - kPlace - hit.s) / wall_.length()) * wall_.length();
  if (hit.s + lap >= until_ || hit.s + lap <= s_ + kPlace) return Next::kDone;
  s_ = hit.s + lap;
  return Next::kWall;
}

}  // namespace clearcut::plan::adaptive
