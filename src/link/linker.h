// Cuts passes in a given order, or always the one reached soonest, and writes the moves with their links.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "link/access_paths.h"
#include "link/lead.h"
#include "link/link.h"
#include "link/moves.h"
#include "link/pass_start.h"
#include "link/work.h"

namespace clearcut::link {

/// A pass to be cut next; it begins at `start`, or at the nearest place.
struct Task {
  std::size_t item = 0;
  std::optional<PassStart> start;
};

/// A pass that was cut: where from and where to.
struct Cut {
  std::size_t item = 0;
  PassStart start;
  Vec2 begin;
  Vec2 end;
  bool stayed_down = false;  ///< since the pass before
};

/// Where the cutter is.
struct CutterAt {
  Vec2 at;
  double z = 0;
};

/// Where a pass may begin.
struct Beginning {
  std::size_t item = 0;
  Vec2 point;
  double rapid_z = 0;  ///< where a rapid down to it ends
};

class Linker {
 public:
  Linker(const Work& work, const LinkOptions& options, Progress::Layers layers)
      : work_(work), options_(options), progress_(work, layers) {}

  /// All passes, always the one that is reached soonest.
  void cut_nearest_first();
  /// All passes in this order, which keeps precedence.
  void cut_in_order(const std::vector<Task>& tasks);

  /// Seconds from a place to the beginning of a pass, as far as is known before anything is cut. `low`: the link may be near
  /// the material or in it where that is legal.
  double travel(const CutterAt& from, const Beginning& to, bool low) const;
  Beginning beginning(std::size_t item, Vec2 point) const { return {item, point, approach_z(point, item)}; }

  const std::vector<Cut>& cuts() const { return cuts_; }
  /// What was asked for and did not fit, in words.
  std::vector<std::string> notes() const;
  /// All moves, up to the safe height.
  std::vector<Move> take_moves();

 private:
  struct Choice {
    std::size_t item = std::numeric_limits<std::size_t>::max();
    PassStart start;
    bool stay_down = false;
    double cost = std::numeric_limits<double>::infinity();
  };

  bool running() const { return !moves_.empty(); }
  bool is_at_depth_of(std::size_t item) const { return moves_.z() == layer(item).layer().z; }
  const LayerWork& layer(std::size_t item) const { return work_.layer_of(item); }
  AccessPaths access_paths() const { return {work_, options_, progress_}; }
  CutterAt here() const { return {moves_.at(), moves_.z()}; }

  Choice choose() const;
  Choice first_choice() const;
  Choice evaluate(std::size_t item, const PassStart& start) const;
  double retract_time(const CutterAt& from, const Beginning& to, double height) const;
  double straight_time(const CutterAt& from, const Beginning& to) const;
  double retract_height(const CutterAt& from, Vec2 to, std::size_t item) const;
  double approach_z(Vec2 p, std::size_t item) const;
  bool is_at_wall(Vec2 p, std::size_t item) const;

  void cut_pass(Choice next);
  std::optional<Lead> lead_for_pass(const Path& path, const Choice& next);
  void start_from_air(Choice& next) const;
  double go_to(const Choice& next, const Path& path, bool is_ring);
  void link_to(Vec2 p);
  void go_over(Vec2 p, std::size_t item);
  double enter_material(Vec2 start, const Path& path, const Path* ring, std::size_t item);
  void rise_and_cross(Vec2 to, double height);
  Path oriented(const Choice& next) const;
  void cut(const Path& path, const std::vector<MoveKind>& kinds);
  MmPerMin feed_of(MoveKind kind) const;
  MmPerMin lead_feed() const { return options_.lead_feed.value_or(options_.feed); }
  double rapid_time(double length) const;

  const Work& work_;
  const LinkOptions& options_;
  Progress progress_;
  MoveList moves_{{}, 0};
  std::vector<Cut> cuts_;
  std::array<int, 4> entries_{};  ///< into material, by kind
  int without_lead_ = 0;
};

}  // namespace clearcut::link
