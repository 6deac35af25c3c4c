// The path of an adaptive pass under construction: cuts, and links between them that are free.
#pragma once

#include <optional>
#include <vector>

#include "geometry/clearance.h"
#include "plan/adaptive_cut.h"
#include "plan/adaptive_ground.h"
#include "toolpath/pass.h"

namespace clearcut {

/// Ways through what is cleared: straight, else over points of the medial axis.
class FreeWays {
 public:
  /// `least`: clearance of the axis points that the centre may use, `pitch`: distance between them, mm.
  FreeWays(const MedialAxis& axis, double least, double pitch);

  /// Points from `from` (left out) to `to`, all straight ways between them free of anything thicker than
  /// `film` mm; none when there is no way.
  std::optional<std::vector<Vec2>> find(Vec2 from, Vec2 to, const Ground& ground, double film) const;

 private:
  int add_node(Vec2 p);
  void join(int a, int b);
  static std::optional<Vec2> one_corner(Vec2 from, Vec2 to, const Ground& ground, double film);
  static void pull_taut(std::vector<Vec2>& way, Vec2 from, const Ground& ground, double film);
  std::vector<int> nearest_free(Vec2 p, const Ground& ground, double film) const;
  std::vector<Vec2> shortest(const std::vector<int>& sources, const std::vector<int>& targets, Vec2 from,
                             Vec2 to, const Ground& ground, double film) const;

  std::vector<Vec2> nodes_;
  struct Step {
    int to = 0;
    /// mm; thinnest film beyond which the step was found free. What is free once stays free.
    mutable double free_beyond = 1e300;
  };
  static bool is_free(const Step& step, Vec2 from, Vec2 to, const Ground& ground, double film);
  /// The last place where a way began, for the next one from there.
  struct Sources {
    Vec2 from;
    double film = -1;
    std::vector<int> nodes;
  };
  const std::vector<int>& sources_of(Vec2 from, const Ground& ground, double film) const;
  std::vector<std::vector<Step>> steps_;
  mutable Sources sources_;
};

/// Builds one pass.
class ClearingPath {
 public:
  ClearingPath(Ground& ground, const FreeWays& ways) : ground_(ground), ways_(ways) {}

  /// Begins a pass with a circle of `entry_radius` about the disc's centre and widens it in half turns as long as they
  /// stay inside the disc and take all that `engagement` lets them.
  /// `cleared`: radius of a hole that is there about the centre; where it leaves the cutter room the pass begins in it.
  void open(const Disc& disc, double entry_radius, double engagement, double cleared = 0);
  /// Goes on, right after open(), until the disc's rim is touched all round: the last turns are thinner.
  void widen_to_rim(const Disc& disc, double engagement);
  /// The next pass begins where nothing stands any more, or not.
  void start_clear(bool clear) { pass_.starts_clear = clear; }
  /// Goes over the points of `link` to the start of `cut` and appends it; a pass begins with its first cut.
  void append(const Path& cut, const std::vector<Vec2>& link);
  std::optional<std::vector<Vec2>> way_to(Vec2 p, double film) const {
    return ways_.find(at_, p, ground_, film);
  }

  const Path& path() const { return pass_.path; }
  bool empty() const { return pass_.path.empty(); }
  std::optional<Edge> last_arc() const;
  Vec2 at() const { return at_; }
  /// The pass built so far; the next one begins empty.
  Pass take();
  /// Goes on with a pass taken before, when nothing was begun since.
  void resume(Pass pass);

 private:
  enum class Turns { kFull, kAny };
  bool widen(const Disc& disc, double engagement, Turns turns);
  void cut_arc(Vec2 center, Vec2 to);
  void link_line(Vec2 to);

  Ground& ground_;
  const FreeWays& ways_;
  Pass pass_;
  Vec2 at_;
  /// Distances of the spiral's last two ends from its centre, mm.
  struct Ends {
    double left = 0;
    double right = 0;
  } spiral_;
};

}  // namespace clearcut
