#include "plan/adaptive/clearing/clearing_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "plan/adaptive/clearing/arcs.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
double widened_circle(double cleared_radius, double tool_radius, double engagement) {
  const double across = tool_radius * base::sin(engagement);
  const double inside = std::max(0.0, cleared_radius * cleared_radius - across * across);
  return -tool_radius * base::cos(engagement) + std::sqrt(inside);
}

namespace {

/// mm. Two moves are joined if one move stays this near to both.
constexpr double kSame = 1e-4;
/// Share of the tool radius: the same where no wall is near.
constexpr double kNearlySame = 1.5e-3;
/// Share of the tool radius: how much wider than the cutter a hole must be for a pass to begin in it.
constexpr double kLeastHole = 0.05;
/// Number of samples along a half turn of the spiral.
constexpr int kSpiralSamples = 8;
/// Factor by which the widening of a half turn that exceeds the limit is reduced, and the least widening, a
/// share of the tool radius.
constexpr double kNarrower = 0.97;
constexpr double kLeastWidening = 0.05;

}  // namespace

bool begins_in_hole(double cleared, double tool_radius) {
  return cleared - tool_radius > kLeastHole * tool_radius;
}

void ClearingPath::open(const Disc& disc, double entry_radius, double engagement, double cleared) {
  finish_pass();
  const double tool = remaining_.tool_radius();
  const bool in_hole = begins_in_hole(cleared, tool);
  const double first = std::min({entry_radius, disc.radius - tool, in_hole ? cleared - tool : entry_radius});
  at_ = disc.center + Vec2{first, 0};
  if (first <= kSamePlaceMm) return;
  spiral_ = {first, first};
  pass_.starts_clear = in_hole;
  if (!in_hole) pass_.entry_center = disc.center;
  cut_arc(disc.center, disc.center - Vec2{first, 0});
  cut_arc(disc.center, disc.center + Vec2{first, 0});
  while (widen(disc, engagement, Turns::kFull)) {
  }
}

void ClearingPath::open_along(const Edge& stroke) {
  finish_pass();
  at_ = stroke.from;
  cut({stroke}, {});
}

void ClearingPath::widen_to_rim(const Disc& disc, double engagement) {
  while (widen(disc, engagement, Turns::kAny)) {
  }
}

/// Cuts one more half turn; false if none is possible.
bool ClearingPath::widen(const Disc& disc, double engagement, Turns turns) {
  const double tool = remaining_.tool_radius(), last = disc.radius - tool;
  const auto [left, right] = spiral_;
  if (right >= last) return false;
  const double most = widened_circle(left + tool, tool, engagement);
  if (most >= last && turns == Turns::kFull) return false;
  double reach = std::min(last, most);
  const auto end = [&] { return disc.center + Vec2{at_.x > disc.center.x ? -reach : reach, 0}; };
  const auto half_turn = [&] { return Edge::arc(at_, end(), (at_ + end()) / 2.0, Turn::kCounterClockwise); };
  // The closed form holds for full circles; half turns that widen engage a little more.
  while (!keeps_limit(half_turn(), engagement + EngagementTolerance::kLongExcess) &&
         reach > left + kLeastWidening * tool)
    reach = left + (reach - left) * kNarrower;
  const Vec2 to = end();
  cut_arc((at_ + to) / 2.0, to);
  spiral_ = {right, reach};
  return true;
}

/// Whether the half turn keeps the limit. Along a spiral the engagement changes smoothly, so a few samples
/// are enough.
bool ClearingPath::keeps_limit(const Edge& half_turn, double limit) const {
  for (int i = 1; i <= kSpiralSamples; ++i) {
    const double t = static_cast<double>(i) / kSpiralSamples;
    if (remaining_.engagement(half_turn.at(t), half_turn.tangent_at(t)) > limit) return false;
  }
  return true;
}

void ClearingPath::append(const Path& cut, const LinkPath& link) {
  if (cut.empty()) return;
  if (pass_.path.empty()) {
    at_ = cut.front().from;
  } else {
    for (const LinkMove& move : link) append_link(move);
  }
  for (Edge edge : cut) {
    if (distance(at_, edge.to) < kSamePlaceMm) continue;  // it has no heading
    edge.from = at_;
    if (const auto whole = joined_to_last(edge)) {
      pass_.path.back() = *whole;
    } else {
      pass_.path.push_back(edge);
      pass_.kinds.push_back(MoveKind::kCut);
    }
    at_ = edge.to;
  }
}

/// The last cut and the edge as one move: with the same shape, or nearly so where no wall is near.
std::optional<Edge> ClearingPath::joined_to_last(const Edge& edge) {
  if (pass_.path.empty() || pass_.kinds.back() != MoveKind::kCut) return std::nullopt;
  if (const auto same = joined(pass_.path.back(), edge, kSame)) return same;
  const auto whole = joined(pass_.path.back(), edge, kNearlySame * remaining_.tool_radius());
  if (!whole || !remaining_.is_legal(*whole)) return std::nullopt;
  replaced_.insert(replaced_.end(), {pass_.path.back(), edge});
  return whole;
}

bool ClearingPath::is_beside_joined(Vec2 p) const {
  return std::any_of(replaced_.begin(), replaced_.end(),
                     [&](const Edge& edge) { return distance(edge, p) < remaining_.tool_radius(); });
}

void ClearingPath::cut_arc(Vec2 center, Vec2 to) {
  const Edge arc = Edge::arc(at_, to, center, Turn::kCounterClockwise);
  remaining_.cut(arc);
  pass_.path.push_back(arc);
  pass_.kinds.push_back(MoveKind::kCut);
  at_ = to;
}

void ClearingPath::append_link(const LinkMove& move) {
  if (distance(at_, move.to) < kSamePlaceMm) return;
  pass_.path.push_back(move.edge(at_));
  pass_.kinds.push_back(MoveKind::kLink);
  at_ = move.to;
}

std::optional<Edge> ClearingPath::last_arc() const {
  if (pass_.path.empty() || !pass_.path.back().is_arc()) return std::nullopt;
  return pass_.path.back();
}

std::optional<LinkPath> ClearingPath::link_to(Vec2 p, double residual) const {
  return empty() ? LinkPath{{p}} : links_.find(at_, p, remaining_, residual);
}

LinkPath ClearingPath::retract_to(Vec2 p) {
  finish_pass();
  pass_.starts_clear = true;
  return {{p}};
}

std::optional<LinkPath> ClearingPath::retract_if_clear(Vec2 p) {
  if (remaining_.touches(p, RemainingStock::kClear)) return std::nullopt;
  return retract_to(p);
}

void ClearingPath::note_start(Vec2 p) {
  if (empty()) pass_.starts_clear = !remaining_.touches(p, RemainingStock::kClear);
}

void ClearingPath::cut(const Path& cut, const LinkPath& link) {
  note_start(cut.front().from);
  for (const Edge& edge : cut) remaining_.cut(edge);
  append(cut, link);
}

void ClearingPath::finish_pass() {
  if (empty()) return;
  pass_.reversible = false;
  pass_.may_cut_to_start = false;
  passes_.push_back(std::exchange(pass_, {}));
}

void ClearingPath::resume_pass() {
  if (!empty() || passes_.empty()) return;
  at_ = passes_.back().path.back().to;
  pass_ = std::move(passes_.back());
  passes_.pop_back();
}

std::vector<Edge> ClearingPath::moves() const {
  std::vector<Edge> moves;
  for (const Pass& pass : passes_) moves.insert(moves.end(), pass.path.begin(), pass.path.end());
  moves.insert(moves.end(), pass_.path.begin(), pass_.path.end());
  return moves;
}

void ClearingPath::ease_joints(const Deviation& deviation, const MachineClock& clock) {
  const auto ease = [&](Pass& pass) {
    for (const auto& changed :
         {straighten_wide_arcs(pass, deviation), adaptive::ease_joints(pass, deviation, clock)})
      replaced_.insert(replaced_.end(), changed.begin(), changed.end());
  };
  for (Pass& pass : passes_) ease(pass);
  ease(pass_);
}

std::vector<Pass> ClearingPath::take_passes() {
  finish_pass();
  return std::exchange(passes_, {});
}

void StepPictures::after(std::string_view step) {
  if (sink_ == nullptr) return;
  const auto moves = path_.moves();
  if (moves.size() <= drawn_) return;
  sink_->frame(step);
  for (const Edge& edge : legal_.edges()) draw(edge, "black");
  for (std::size_t i = 0; i < moves.size(); ++i) draw(moves[i], i < drawn_ ? "silver" : "steelblue");
  drawn_ = moves.size();
}

void StepPictures::draw(const Edge& edge, std::string_view color) {
  if (!edge.is_arc()) return sink_->line(edge.from.x, edge.from.y, edge.to.x, edge.to.y, color);
  sink_->arc(edge.from.x, edge.from.y, edge.to.x, edge.to.y, edge.center.x, edge.center.y,
             edge.turn == Turn::kCounterClockwise, color);
}

}  // namespace clearcut::plan::adaptive
