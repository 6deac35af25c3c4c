#include "plan/clearing_path.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace clearcut {
namespace {

/// Channels with less room than this share of the radius are slots: no arc fits in them.
constexpr double kSlotRoom = 0.1;
/// mm. Shorter moves are left out.
constexpr double kShortest = 1e-6;
/// Crescents wider than this go all the way round.
constexpr double kNearlyRound = kPi * 0.98;

}  // namespace

int ClearingPath::add(const Disc& disc, int parent) {
  discs_.push_back({disc, parent});
  at_disc_ = static_cast<int>(discs_.size()) - 1;
  return at_disc_;
}

int ClearingPath::open(const Disc& disc, double entry_radius, double engagement) {
  const double last = disc.radius - tool_radius_;
  double right = std::min(entry_radius, last), left = right;
  at_ = disc.center + Vec2{right, 0};
  pass_.entry_center = disc.center;
  if (last <= kShortest) {
    pass_.entry_center.reset();
    return add(disc, -1);
  }
  cut_circle({disc.center, right + tool_radius_}, at_);
  for (int finished = right >= last ? 2 : 0; finished < 2;) {
    const double reach = std::min(last, widened_circle(left + tool_radius_, tool_radius_, engagement));
    const Vec2 to = disc.center + Vec2{at_.x > disc.center.x ? -reach : reach, 0};
    cut_arc((at_ + to) / 2.0, at_, to);
    finished = right >= last && reach >= last ? finished + 1 : 0;
    left = right;
    right = reach;
  }
  return add(disc, -1);
}

int ClearingPath::widen(int from, const Disc& next) {
  const Disc cleared = disc(from);
  const double room = next.radius - tool_radius_;
  if (room < kSlotRoom * tool_radius_) {
    link_to(cleared.center, from);
    cut_line(next.center);
    return add(next, from);
  }
  const Disc inner_cleared{cleared.center, cleared.radius - tool_radius_};
  const double half = crescent_half_angle(inner_cleared, {next.center, room});
  const double axis = angle_of(next.center - cleared.center);
  if (half >= kNearlyRound) {
    const Vec2 start = next.center + direction_of(axis + kPi) * room;
    link_to(start, from);
    cut_circle(next, start);
  } else {
    link_to(next.center + direction_of(axis - half) * room, from);
    cut_arc(next.center, at_, next.center + direction_of(axis + half) * room);
  }
  return add(next, from);
}

void ClearingPath::cut_circle(const Disc& next, Vec2 start) {
  const Vec2 opposite = next.center * 2.0 - start;
  cut_arc(next.center, start, opposite);
  cut_arc(next.center, opposite, start);
}

void ClearingPath::cut_arc(Vec2 center, Vec2 from, Vec2 to) {
  if (distance(from, to) < kShortest) return;
  pass_.path.push_back(Edge::arc(from, to, center, Turn::kCounterClockwise));
  pass_.kinds.push_back(MoveKind::kCut);
  at_ = to;
}

void ClearingPath::cut_line(Vec2 to) {
  if (distance(at_, to) < kShortest) return;
  pass_.path.push_back(Edge::line(at_, to));
  pass_.kinds.push_back(MoveKind::kCut);
  at_ = to;
}

void ClearingPath::link_line(Vec2 to) {
  if (distance(at_, to) < kShortest) return;
  pass_.path.push_back(Edge::line(at_, to));
  pass_.kinds.push_back(MoveKind::kLink);
  at_ = to;
}

/// Discs from `from` to `to` over their nearest common ancestor, both included.
std::vector<int> ClearingPath::route(int from, int to) const {
  const auto ancestry = [&](int index) {
    std::vector<int> line;
    for (; index >= 0; index = discs_[static_cast<std::size_t>(index)].parent) line.push_back(index);
    return line;
  };
  auto up = ancestry(from), down = ancestry(to);
  while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2]) {
    up.pop_back();
    down.pop_back();
  }
  down.pop_back();
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

bool ClearingPath::is_free(Vec2 a, Vec2 b) const {
  const int steps = static_cast<int>(distance(a, b) / (tool_radius_ * 0.1)) + 1;
  for (int i = 0; i <= steps; ++i) {
    const Vec2 p = lerp(a, b, static_cast<double>(i) / steps);
    const bool inside = std::any_of(discs_.begin(), discs_.end(), [&](const ClearedDisc& cleared) {
      return distance(p, cleared.disc.center) <= cleared.disc.radius - tool_radius_ + kShortest;
    });
    if (!inside) return false;
  }
  return true;
}

void ClearingPath::link_to(Vec2 to, int within) {
  if (at_disc_ == within) return link_line(to);
  const auto discs = route(at_disc_, within);
  std::vector<Vec2> stations;
  for (const int index : discs) stations.push_back(disc(index).center);
  stations.push_back(to);
  for (std::size_t next = 0; next < stations.size();) {
    std::size_t farthest = next;
    for (std::size_t jump = stations.size() - 1; jump > next; jump = next + (jump - next) / 2) {
      if (!is_free(at_, stations[jump])) continue;
      farthest = jump;
      break;
    }
    link_line(stations[farthest]);
    next = farthest + 1;
  }
  at_disc_ = within;
}

Pass ClearingPath::finish(int component) const {
  Pass pass = pass_;
  pass.component = component;
  pass.reversible = false;
  return pass;
}

}  // namespace clearcut
