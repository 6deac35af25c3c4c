// Shortens a path as long as all witness points stay cleared.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

#include "base/random.h"
#include "plan/cover/cover_path.h"

namespace clearcut::plan::cover {

/// Whether the cutter's centre may go straight from one point to the other; empty: everywhere.
using MayMove = std::function<bool(Vec2 from, Vec2 to)>;

struct ShorteningLimits {
  std::stop_token cancel;    ///< asked to stop, all end with Cancelled
  bool fixed_start = false;  ///< the first corner of an open path is fixed
  double corner_price = 0;   ///< cost of a corner in mm
  MayMove may_move;
  /// Bends of the shortest path from one place to the other, absent if there is none; empty function: all are
  /// straight.
  std::function<std::optional<std::vector<Vec2>>(Vec2 from, Vec2 to)> bends;
};

/// The changes made by a search for a short path. Each keeps all witness points cleared, or can be undone.
class Shortening {
 public:
  Shortening(CoverPath& path, Witnesses& witnesses, ShorteningLimits limits, std::uint64_t seed)
      : path_(path), witnesses_(witnesses), limits_(std::move(limits)), random_(seed) {}

  /// Clears all these points, by cheap detours. False if some cannot be cleared. Cost: proportional to the number of
  /// points, if they are many: those far from each other are cleared one square after the other.
  bool clear(std::vector<Vec2> bare);
  /// Pulls the path taut at these corners and their neighbours, in steps down to `finest` mm.
  void pull(std::vector<Corner> corners, double finest);
  void pull_all(double finest, int rounds);
  /// One random change: part of the path is removed or joined differently, uncleared points are cleared again, and
  /// the path is pulled taut. The change is kept if the path is longer by less than a random share of `tolerance` mm;
  /// else undone. Returns whether the change is kept.
  bool change(double tolerance, double finest);

  /// Whether moves are shifted as a whole only seldom: quicker.
  void set_brief(bool brief) { moves_share_ = brief ? 1 : 4; }
  /// From now on detours go at least this share of the radius farther than they must.
  void set_margin(double margin) { margin_ = margin; }

  /// From now on detours go to and fro where moving the path aside would uncover points, as between strips as wide as the
  /// disc.
  void set_to_and_fro(bool to_and_fro) { to_and_fro_ = to_and_fro; }

  /// The path is no longer pulled taut once work() exceeds this.
  void set_most_work(std::uint64_t most) { most_work_ = most; }

  /// Steps so far.
  std::uint64_t work() const { return witnesses_.work() + work_; }

 private:
  bool may_move(Vec2 a, Vec2 b);
  bool clear_together(std::vector<Vec2> bare);
  bool is_fixed(Corner c) const {
    return path_.is_nowhere(c) || (limits_.fixed_start && path_.previous(c) == CoverPath::kNowhere);
  }
  Corner random_corner();
  double cost_of(Vec2 q, Corner a, Corner b) const;
  struct Insertion {
    Corner after = -1;
    Vec2 at;
    double cost = 0;
  };
  Insertion cheapest(Vec2 bare);
  bool pull_corner(Corner c, double finest);
  void move_corner(Corner c, Vec2 p);
  bool cut_corner(Corner c, double finest);
  bool pull_move(Corner c, double finest);
  bool all_cleared(const Vec2* line, int points);
  bool take_out_stretch(std::vector<Vec2>& bare);
  bool take_out_disc(std::vector<Vec2>& bare);
  bool join_otherwise(std::vector<Vec2>& bare);
  bool move_stretch(std::vector<Vec2>& bare);
  void remove_cleared(Corner from, Corner to, std::vector<Vec2>& points) const;
  void insert_detour(Corner after, Vec2 p, std::vector<Vec2>& uncovered);
  struct PlaceOnMove {
    double away = 0;  ///< mm from the point
    Corner after = -1;
    Vec2 at;
  };
  std::vector<PlaceOnMove> places_near(Vec2 p);
  bool visit_around(Vec2 p, std::vector<Vec2>& bare);
  void pull_some(std::vector<Corner> corners, double finest, std::size_t most);

  CoverPath& path_;
  Witnesses& witnesses_;
  ShorteningLimits limits_;
  Random random_;
  std::vector<Vec2> needed_;  ///< points that the current moves must clear
  double margin_ = 0;
  bool to_and_fro_ = false;
  std::uint64_t moves_share_ = 4;  ///< quarters of the corners whose moves are shifted as a whole, too
  std::uint64_t work_ = 0;
  std::uint64_t most_work_ = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace clearcut::plan::cover
