#include "link/tracks/thread.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "link/moves.h"

namespace clearcut::link {
namespace {

/// mm above the material down to which the mill moves at the rapid.
constexpr double kAbove = 1;

class ThreadPath {
 public:
  ThreadPath(const ThreadWork& thread, const LinkOptions& options)
      : thread_(thread),
        options_(options),
        wall_(thread.center + Vec2{thread.radius + (thread.external ? 1 : -1) * options.tool_radius, 0}),
        away_(thread.external ? wall_ + Vec2{thread.aside, 0} : thread.center),
        list_(away_, options.safe_z) {
    const bool climbs = (options.direction == CutDirection::kClimb) == options.spindle_clockwise;
    turn_ = climbs != thread.external ? Turn::kCounterClockwise : Turn::kClockwise;
    // A right-hand thread rises counter-clockwise.
    rises_ = (turn_ == Turn::kCounterClockwise) != thread.left_hand;
  }

  std::vector<Move> moves() {
    const double low = thread_.full_z - thread_.pitch;
    if (thread_.rows <= 0) {
      const double turns = std::ceil((thread_.z_top - low) / thread_.pitch - 1e-9);
      add_helix(rises_ ? low : low + turns * thread_.pitch, static_cast<int>(turns));
    } else {
      const int sets =
          std::max(1, static_cast<int>(std::ceil((thread_.z_top - thread_.full_z) / thread_.rows - 1e-9)));
      for (int i = 0; i < sets; ++i)
        add_helix(thread_.full_z + i * thread_.rows - (rises_ ? thread_.pitch : 0), 1);
    }
    list_.vertical(options_.safe_z, MoveKind::kRapid, {});
    return list_.take();
  }

 private:
  double step() const { return rises_ ? thread_.pitch : -thread_.pitch; }

  /// Rise (mm) of the helix along a lead-in or lead-out. In a hole a lead is a quarter of a turn seen from the axis.
  /// About a boss the lead is on the helix at the root and at the point where the teeth reach the crests, and nearly
  /// so between.
  double rise_of_lead() const {
    if (!thread_.external) return step() / 4;
    const double half = thread_.aside / 2;
    const double along =
        base::acos(std::max(-1.0, 1 - (thread_.crest - thread_.radius) / half));  // share of the half circle
    const double seen =
        base::atan2(half * base::sin(along), distance(wall_, thread_.center) + half * (1 - base::cos(along)));
    return step() * seen / (2 * along);
  }

  void add_helix(double z, int turns) {
    const double begin = z - rise_of_lead();
    if (list_.z() > thread_.z_top + kAbove) list_.vertical(thread_.z_top + kAbove, MoveKind::kRapid, {});
    list_.vertical(begin, MoveKind::kPlunge, options_.plunge_feed);
    half_circle(away_, wall_, z, MoveKind::kLeadIn);
    for (int i = 1; i <= turns; ++i)
      list_.circle(thread_.center, turn_, z + i * step(), MoveKind::kCut, options_.feed);
    const double end = z + turns * step();
    half_circle(wall_, away_, end + rise_of_lead(), MoveKind::kLeadOut);
  }

  void half_circle(Vec2 from, Vec2 to, double z, MoveKind kind) {
    const Turn opposite = turn_ == Turn::kClockwise ? Turn::kCounterClockwise : Turn::kClockwise;
    const Edge path = Edge::arc(from, to, lerp(from, to, 0.5), thread_.external ? opposite : turn_);
    const Move move{path, list_.z(), z, kind, options_.feed, 0};
    list_.append({move});
  }

  const ThreadWork& thread_;
  const LinkOptions& options_;
  Vec2 wall_, away_;
  MoveList list_;
  Turn turn_ = Turn::kCounterClockwise;
  bool rises_ = true;
};

}  // namespace

Section mill_thread(const ThreadWork& thread, const LinkOptions& options) {
  Section section;
  section.spindle_clockwise = options.spindle_clockwise;
  section.moves = ThreadPath(thread, options).moves();
  return section;
}

}  // namespace clearcut::link
