// A list of moves, each beginning at the end of the previous one, and the feed of descending moves.
#pragma once

#include <algorithm>
#include <vector>

#include "base/elementary.h"
#include "base/units.h"
#include "model/move.h"

namespace clearcut::link {

class MoveList {
 public:
  MoveList(Vec2 at, double z) : at_(at), z_(z) {}

  Vec2 at() const { return at_; }
  double z() const { return z_; }

  /// Adds nothing if the height is already z.
  void vertical(double z, MoveKind kind, MmPerMin feed) {
    if (z == z_) return;
    moves_.push_back({Edge::line(at_, at_), z_, z, kind, feed, 0});
    z_ = z;
  }

  void line(Vec2 to, MoveKind kind, MmPerMin feed) {
    if (to == at_) return;
    moves_.push_back({Edge::line(at_, to), z_, z_, kind, feed, 0});
    at_ = to;
  }

  /// Once round `center` in two half circles, and evenly to the height `z`.
  void circle(Vec2 center, Turn turn, double z, MoveKind kind, MmPerMin feed) {
    const Vec2 start = at_, opposite = center * 2.0 - at_;
    const double from = z_, middle = (z_ + z) / 2;
    moves_.push_back({Edge::arc(start, opposite, center, turn), from, middle, kind, feed, 0});
    moves_.push_back({Edge::arc(opposite, start, center, turn), middle, z, kind, feed, 0});
    z_ = z;
  }

  /// A level move; `path` must begin at the end of the list.
  void along(const Edge& path, MoveKind kind, MmPerMin feed) {
    moves_.push_back({path, z_, z_, kind, feed, 0});
    at_ = path.to;
  }

  /// Adds moves that begin at the end of the list.
  void append(const std::vector<Move>& moves) {
    if (moves.empty()) return;
    moves_.insert(moves_.end(), moves.begin(), moves.end());
    at_ = moves.back().path.to;
    z_ = moves.back().z_to;
  }

  const std::vector<Move>& all() const { return moves_; }
  bool empty() const { return moves_.empty(); }
  bool ends_upright() const { return !moves_.empty() && moves_.back().is_vertical(); }
  std::vector<Move> take() { return std::move(moves_); }

 private:
  std::vector<Move> moves_;
  Vec2 at_;
  double z_;
};

/// The feed, reduced so that the tip descends no faster than at `plunge_feed` on a move `along` mm long in plan and
/// `down` mm deep. A written coordinate is rounded by at most half of 0.0001 inch; this may make a short piece
/// steeper.
inline MmPerMin sinking_feed(MmPerMin feed, MmPerMin plunge_feed, double along, double down) {
  constexpr double kRounded = 0.0013;  // mm
  if (down <= 0) return feed;
  const double deeper = down + 2 * kRounded, shorter = std::max(0.0, along - 3 * kRounded);
  const double share = deeper / base::hypot(shorter, deeper);
  return std::min(feed, plunge_feed * (1 / share));
}

}  // namespace clearcut::link
