#include "plan/adaptive/clearing/remaining_stock.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/work_budget.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// mm. Engagements are computed for a cutter smaller by this, so that rounding does not count as material.
constexpr double kRounding = 2e-4;
/// Radians. Less of the circle in material than this comes from rounding.
constexpr double kTouch = 1e-6;
/// Share of the tool radius: distance between samples of a link, which only tell whether anything is touched.
constexpr double kSampleStep = 0.2;
/// Radians: greatest turn between samples on arcs.
constexpr double kCheckTurn = 0.15;
/// Share of the tool radius: the first sample is this far from the beginning of an edge, because at the
/// beginning itself a change of heading would count.
constexpr double kBeside = 1e-3;
/// Share of the tool radius: side of the cells of ClearedCells.
constexpr double kCell = 1.0 / 8;
/// Radians. An arc is checked in pieces of this turn, each by its chord and the tangents at its ends.
constexpr double kLegalTurn = 0.6;
/// Number of points of material that are kept for the next queries. A point is kept if more than kWorthNoting
/// radians of the circle lie in material.
constexpr std::size_t kMostStanding = 16;
constexpr double kWorthNoting = 1e-3;
/// mm. Stands for no point.
constexpr Vec2 kNowhere{1e100, 1e100};
/// Number of samples, each nearer to the peak, that are spent on one peak between two samples.
constexpr int kMostPeaks = 5;
/// Number of bisections for the place where the engagement begins to exceed its limit.
constexpr int kMeetingHalvings = 4;

Move level_move(const Edge& edge) {
  return {edge, -1, -1, MoveKind::kCut, {}, 0};
}

}  // namespace

RemainingStock::RemainingStock(const Regions& legal, double tool_radius, const std::optional<Box>& stock)
    : legal_(legal),
      tool_radius_(tool_radius),
      material_(stock, 0, {tool_radius}),
      cleared_(box(legal).grown(tool_radius * (1 + 2 * kCell)), tool_radius * kCell) {}

double RemainingStock::engagement(Vec2 p, Vec2 heading) const {
  WorkBudget::spend(1);
  return material_.engagement_size(p, heading, tool_radius_ - kRounding, -1).angle;
}

RemainingStock::Sample RemainingStock::sample(const Edge& edge, double t) const {
  WorkBudget::spend(1);
  const auto [size, change] =
      material_.engagement_trend(edge.at(t), edge.tangent_at(t), tool_radius_ - kRounding, -1);
  return {t, size.angle, change.per_mm * edge.length() + change.per_radian * edge.sweep(), size.parts};
}

double RemainingStock::length_within(const Edge& edge, double limit) const {
  const double length = edge.length();
  const double by_length = length / (tool_radius_ * RadiusShares::kWallPitch),
               by_turn = std::abs(edge.sweep()) / kCheckTurn;
  const int steps = static_cast<int>(std::max(by_length, by_turn)) + 1;
  // Just beyond the beginning, where the cut before it ends.
  Sample before = sample(edge, std::min(kBeside * tool_radius_ / length, 0.1 / steps));
  for (int i = 1; i <= steps; ++i) {
    const Sample here = sample(edge, static_cast<double>(i) / steps);
    if (here.engagement > limit) return i == 1 ? 0 : before.t * length;
    if (const auto above = peak_above(edge, before, here, limit + EngagementTolerance::kPeak, kMostPeaks))
      return (i == 1 ? last_within(edge, *above, limit) : before.t) * length;
    before = here;
  }
  return length;
}

/// A stretch between two samples, both within `limit`, in which the engagement comes to exceed it.
std::optional<RemainingStock::Stretch> RemainingStock::peak_above(const Edge& edge, const Sample& a,
                                                                  const Sample& b, double limit,
                                                                  int depth) const {
  if (depth == 0) return std::nullopt;
  const auto t = likely_peak(a, b, limit);
  if (!t) return std::nullopt;
  const Sample peak = sample(edge, *t);
  if (peak.engagement > limit) return Stretch{a.t, *t};
  if (const auto above = peak_above(edge, a, peak, limit, depth - 1)) return above;
  return peak_above(edge, peak, b, limit, depth - 1);
}

double RemainingStock::last_within(const Edge& edge, Stretch rise, double limit) const {
  for (int i = 0; i < kMeetingHalvings; ++i) {
    const double middle = (rise.from + rise.to) / 2;
    (engagement(edge.at(middle), edge.tangent_at(middle)) > limit ? rise.to : rise.from) = middle;
  }
  return rise.from;
}

/// Parameter between two samples at which the engagement may exceed `limit`; nothing if it cannot.
std::optional<double> RemainingStock::likely_peak(const Sample& a, const Sample& b, double limit) {
  const double span = b.t - a.t, fall = a.slope - b.slope;
  // The number of engaged parts changes, so the engagement may have jumped.
  if (a.parts != b.parts) return a.t + span / 2;
  if (fall <= 0) return std::nullopt;
  // Else it peaks about where the tangents at both samples meet.
  const double from_a = (b.engagement - a.engagement - b.slope * span) / fall;
  if (from_a < 0 || from_a > span) return a.t + span / 2;
  if (a.engagement + a.slope * from_a <= limit) return std::nullopt;
  return a.t + std::clamp(from_a, span / 8, 7 * span / 8);
}

bool RemainingStock::touches(Vec2 p, double residual) const {
  const double radius = tool_radius_ - residual;
  if (is_standing_within(p, radius)) return true;
  const auto touch = material_.circle_touch(p, radius, -1);
  if (!touch || touch->angle <= kTouch) return false;
  if (touch->angle > kWorthNoting) note_standing(p + touch->toward * radius);
  return true;
}

std::optional<Vec2> RemainingStock::touched(Vec2 p, double residual, Vec2 likely) const {
  const double radius = tool_radius_ - residual;
  const Vec2 beside = p + likely * (radius - kRounding);
  if (!is_removed(beside)) return beside;
  const auto touch = material_.circle_touch(p, radius, -1);
  if (!touch || touch->angle <= kTouch) return std::nullopt;
  return p + touch->toward * radius;
}

void RemainingStock::note_standing(Vec2 met) const {
  if (standing_.size() < kMostStanding) standing_.resize(kMostStanding, {met, age_});
  standing_[oldest_++ % kMostStanding] = {met, age_};
}

/// Whether a point of material met by earlier queries lies within `radius` of p and still stands.
bool RemainingStock::is_standing_within(Vec2 p, double radius) const {
  const double near = radius - kRounding;
  for (Standing& met : standing_) {
    if (norm_squared(met.at - p) >= near * near) continue;
    if (met.age == age_ || !is_removed(met.at)) {
      met.age = age_;
      return true;
    }
    met.at = kNowhere;
  }
  return false;
}

bool RemainingStock::is_free(const Edge& path, double residual) const {
  if (!is_legal(path)) return false;
  const int steps = static_cast<int>(path.length() / (tool_radius_ * kSampleStep)) + 1;
  const auto at = [&](int sample) { return path.at(static_cast<double>(sample) / steps); };
  // The points of the path itself are cheap to test and decide most cases.
  for (int i = steps; i >= 0; --i) {
    if (!cleared_.holds(at(i), 0) && !is_removed(at(i))) return false;
  }
  for (int i = 0; i <= steps; ++i) {
    if (!cleared_.holds(at(i), tool_radius_ - residual) && touches(at(i), residual)) return false;
  }
  return true;
}

/// An arc lies between its chords and its tangents: both are checked.
bool RemainingStock::is_legal(const Edge& path) const {
  if (!path.is_arc()) return legal_.holds_line(path.from, path.to);
  const int pieces = static_cast<int>(std::abs(path.sweep()) / kLegalTurn) + 1;
  const double half = path.sweep() / (2 * pieces), out = 1 / base::cos(half);
  for (int i = 0; i < pieces; ++i) {
    const Vec2 a = path.at(static_cast<double>(i) / pieces), b = path.at((i + 1.0) / pieces),
               corner = path.center + rotated(a - path.center, half) * out;
    if (!legal_.holds_line(a, b) || !legal_.holds_line(a, corner) || !legal_.holds_line(corner, b))
      return false;
  }
  return true;
}

bool RemainingStock::keeps_limit(const std::vector<Edge>& cuts, double limit, double tiny) {
  const std::size_t before = material_.sweeps();
  bool kept = true;
  for (const Edge& edge : cuts) {
    kept = edge.length() < tiny || length_within(edge, limit) >= edge.length();
    if (!kept) break;
    cut(edge);
  }
  forget_beyond(before);
  return kept;
}

void RemainingStock::remove_disc(Vec2 center, double radius) {
  take(Edge::line(center, center), radius);
}

void RemainingStock::cut(const Edge& edge) {
  take(edge, tool_radius_);
}

void RemainingStock::take(const Edge& path, double radius) {
  ++age_;
  sweeps_.push_back(material_.sweeps());
  material_.add(level_move(path), radius);
  cleared_.add(path, radius);
}

void RemainingStock::forget_beyond(std::size_t cuts) {
  material_.forget_beyond(cuts);
  while (!sweeps_.empty() && sweeps_.back() >= cuts) sweeps_.pop_back();
  cleared_.forget_beyond(sweeps_.size());
}

}  // namespace clearcut::plan::adaptive
