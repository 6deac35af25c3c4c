// The passes of an adaptive layer while they are built: cuts, and clear links between them.
#pragma once

#include <optional>
#include <vector>

#include "model/pass.h"
#include "plan/adaptive/clear_links.h"
#include "plan/adaptive/disc_engagement.h"

namespace clearcut::plan::adaptive {

/// The passes finished so far and the one that is being built. What is cut is taken away from the remaining stock.
class ClearingPath {
 public:
  ClearingPath(RemainingStock& remaining, const ClearLinks& links) : remaining_(remaining), links_(links) {}

  /// Begins a pass with a circle of `entry_radius` about the disc's centre and widens it in half turns as long as they
  /// stay inside the disc and take all that `engagement` lets them.
  /// `cleared`: radius of a hole that is there about the centre; where it leaves the cutter room the pass begins in it.
  void open(const Disc& disc, double entry_radius, double engagement, double cleared = 0);
  /// Goes on, right after open(), until the disc's rim is touched all round: the last turns are thinner.
  void widen_to_rim(const Disc& disc, double engagement);

  /// A link from the end of the pass to p on which nothing thicker than `residual` mm is touched; empty where a pass begins,
  /// none where there is no link.
  std::optional<LinkPath> link_to(Vec2 p, double residual) const;
  /// Begins a new pass at p, where nothing stands any more, from above.
  LinkPath retract_to(Vec2 p);
  /// The same where nothing stands.
  std::optional<LinkPath> retract_if_clear(Vec2 p);
  /// What is known about the place where a pass begins, before it is cut.
  void note_start(Vec2 p);
  /// Goes over `link` to the start of `cut` and appends it; a pass begins with its first cut. The remaining stock is as
  /// after the cut already.
  void append(const Path& cut, const LinkPath& link);
  /// The same, and takes the cut from the remaining stock.
  void cut(const Path& cut, const LinkPath& link);

  bool empty() const { return pass_.path.empty(); }
  std::optional<Edge> last_arc() const;
  Vec2 at() const { return at_; }
  /// Ends the pass; the next one begins with its first cut.
  void finish_pass();
  /// Takes the last pass back where nothing was begun after it.
  void resume_pass();
  /// All moves so far.
  std::vector<Edge> moves() const;
  /// All passes, the last one ended.
  std::vector<Pass> take_passes();

 private:
  enum class Turns { kFull, kAny };
  bool widen(const Disc& disc, double engagement, Turns turns);
  bool keeps_limit(const Edge& half_turn, double limit) const;
  void cut_arc(Vec2 center, Vec2 to);
  void append_link(const LinkMove& move);
  std::optional<Edge> joined_to_last(const Edge& edge) const;

  RemainingStock& remaining_;
  const ClearLinks& links_;
  std::vector<Pass> passes_;
  Pass pass_;
  Vec2 at_;
  /// Distances of the spiral's last two ends from its centre, mm.
  struct Ends {
    double left = 0;
    double right = 0;
  } spiral_;
};

}  // namespace clearcut::plan::adaptive
