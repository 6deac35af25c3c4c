#include "link/tracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/elementary.h"
#include "link/moves.h"

namespace clearcut::link {
namespace {

/// mm above the material down to which the tool moves at the rapid.
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
      // The lowest row begins a pitch below the thread, and the highest one ends up to a pitch less high than there are rows.
      const double height = thread_.z_top - thread_.full_z + thread_.pitch;
      const int sets = std::max(1, static_cast<int>(std::ceil(height / thread_.rows - 1e-9)));
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

namespace {

/// mm. Of starts equally near to within this the first is taken, so that rounding does not decide.
constexpr double kAsNear = 0.01;

Track turned(const Track& track) {
  Track out{{}, track.closed};
  for (auto piece = track.pieces.rbegin(); piece != track.pieces.rend(); ++piece)
    out.pieces.push_back({piece->path.reversed(), piece->z_to, piece->z_from});
  return out;
}

Track begun_at(Track track, std::size_t piece) {
  std::rotate(track.pieces.begin(), track.pieces.begin() + static_cast<std::ptrdiff_t>(piece),
              track.pieces.end());
  return track;
}

/// A possible start of a track, and its distance.
struct TrackStart {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t piece = 0;
  bool backwards = false;
};

TrackStart nearest_start(const Track& track, Vec2 from) {
  TrackStart best;
  const auto offer = [&](Vec2 at, std::size_t piece, bool backwards) {
    const double d = distance(from, at);
    if (d < best.distance - kAsNear) best = {d, piece, backwards};
  };
  const std::size_t starts = track.closed ? track.pieces.size() : 1;
  for (std::size_t i = 0; i < starts; ++i) offer(track.pieces[i].path.from, i, false);
  if (!track.closed) offer(track.pieces.back().path.to, 0, true);
  return best;
}

class TrackLinker {
 public:
  TrackLinker(double clear_z, const LinkOptions& options, const TipRoom& room)
      : clear_z_(clear_z), options_(options), room_(room) {}

  void run(const Track& track) {
    const Track::Piece& first = track.pieces.front();
    if (!list_) list_.emplace(first.path.from, options_.safe_z);
    if (list_->at() != first.path.from && !stay_down_to(first)) {
      list_->vertical(std::max(options_.cross_z, clear_z_), MoveKind::kRapid, {});
      list_->line(first.path.from, MoveKind::kRapid, {});
    }
    if (is_standing(track) && list_->z() > first.z_from) lift_between_plunges();
    if (list_->z() > clear_z_) list_->vertical(clear_z_, MoveKind::kRapid, {});
    if (list_->z() < first.z_from) {
      list_->vertical(first.z_from, MoveKind::kRetract, options_.feed);
    } else {
      list_->vertical(first.z_from, MoveKind::kPlunge, options_.plunge_feed);
    }
    std::vector<Move> moves;
    for (const Track::Piece& piece : track.pieces) {
      if (piece.path.from != piece.path.to)
        moves.push_back({piece.path, piece.z_from, piece.z_to, MoveKind::kCut, feed_of(piece), 0});
    }
    list_->append(moves);
  }

  Vec2 at() const { return list_ ? list_->at() : Vec2{}; }

  Section finish() {
    Section section;
    section.spindle_clockwise = options_.spindle_clockwise;
    if (!list_) return section;
    list_->vertical(options_.safe_z, MoveKind::kRapid, {});
    section.moves = list_->take();
    return section;
  }

 private:
  /// Moves to the start of a track as low as allowed, if this is as quick as a link over the part.
  bool stay_down_to(const Track::Piece& first) {
    const Vec2 to = first.path.from;
    const double apart = distance(list_->at(), to), shallower = std::max(list_->z(), first.z_from);
    const double z = apart > room_.longest_below ? std::max(shallower, room_.high) : shallower;
    const double over = std::max(options_.cross_z, clear_z_);
    const double rapid = (over - list_->z() + apart + over - clear_z_) / options_.machine.rapid.mm_per_s();
    const double lifted = rapid + (clear_z_ - first.z_from) / options_.plunge_feed.mm_per_s();
    const double down = (z - list_->z() + apart) / options_.feed.mm_per_s() +
                        (z - first.z_from) / options_.plunge_feed.mm_per_s();
    if (!room_.holds || z >= clear_z_ || down > lifted || !room_.holds(list_->at(), to, z)) return false;
    if (list_->z() < z) list_->vertical(z, MoveKind::kRetract, options_.feed);
    list_->line(to, MoveKind::kLink, options_.feed);
    return true;
  }

  static bool is_standing(const Track& track) {
    return std::all_of(track.pieces.begin(), track.pieces.end(),
                       [](const Track::Piece& piece) { return piece.path.from == piece.path.to; });
  }

  /// In the middle of a round area, on which the tip only goes down: out of the cut, so that no plunge is deeper than one pass, and back
  /// to just above its end.
  void lift_between_plunges() {
    const double end = list_->z();
    if (end >= clear_z_) return;
    list_->vertical(clear_z_, MoveKind::kRapid, {});
    list_->vertical(std::min(clear_z_, end + kAbove), MoveKind::kRapid, {});
  }

  MmPerMin feed_of(const Track::Piece& piece) const {
    return sinking_feed(options_.feed, options_.plunge_feed, piece.path.length(), piece.z_from - piece.z_to);
  }

  double clear_z_;
  const LinkOptions& options_;
  const TipRoom& room_;
  std::optional<MoveList> list_;
};

}  // namespace

Section link_tracks(std::vector<std::vector<Track>> sets, double clear_z, const LinkOptions& options,
                    const TipRoom& room) {
  TrackLinker linker(clear_z, options, room);
  for (std::vector<Track>& set : sets) {
    while (!set.empty()) {
      std::size_t next = 0;
      TrackStart best;
      for (std::size_t i = 0; i < set.size(); ++i) {
        const TrackStart one = nearest_start(set[i], linker.at());
        if (one.distance < best.distance - kAsNear) best = one, next = i;
      }
      Track track = std::move(set[next]);
      set.erase(set.begin() + static_cast<std::ptrdiff_t>(next));
      linker.run(best.backwards ? turned(track) : begun_at(std::move(track), best.piece));
    }
  }
  return linker.finish();
}

}  // namespace clearcut::link
