// Builds the passes of one adaptive layer: cuts, and clear links between them. Engagement of a cutter that widens a
// cleared disc, in closed form, and pictures of each step (docs/adaptive.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "base/debug_sink.h"
#include "geometry/region.h"
#include "geometry/vec2.h"
#include "model/layer.h"
#include "plan/adaptive/clearing/arcs.h"
#include "plan/adaptive/clearing/clear_links.h"

namespace clearcut::plan::adaptive {

/// A disc of cleared material.
struct Disc {
  Vec2 center;
  double radius = 0;  ///< mm
};

/// mm; the greatest radius of a circle on which the centre may run inside a cleared disc of `cleared_radius`
/// mm so that the engagement is at most `engagement` radians. Both are about the same centre. By the law of
/// cosines, with R for tool_radius: -R cos(engagement) + sqrt(cleared_radius^2 - R^2 sin(engagement)^2).
double widened_circle(double cleared_radius, double tool_radius, double engagement);

/// Whether a cutter of `tool_radius` has room to begin in a hole of radius `cleared`, mm.
bool begins_in_hole(double cleared, double tool_radius);

/// The finished passes and the one that is being built. Everything that is cut is removed from the remaining
/// stock.
class ClearingPath {
 public:
  ClearingPath(RemainingStock& remaining, const ClearLinks& links) : remaining_(remaining), links_(links) {}

  /// Begins a pass with a circle of `entry_radius` mm about the disc's centre and widens it by half turns,
  /// each as far as `engagement` (radians) allows, while they stay inside the disc. `cleared`: mm, radius of
  /// a hole that exists about the centre; if the cutter has room in it, the pass begins there.
  void open(const Disc& disc, double entry_radius, double engagement, double cleared = 0);
  /// Begins a pass with a straight cut, where there is no room for a circle.
  void open_along(const Edge& stroke);
  /// To be called right after open(): goes on with thinner turns until all of the disc's rim is reached.
  void widen_to_rim(const Disc& disc, double engagement);

  /// A link from the end of the pass to p that touches nothing thicker than `residual` mm. An empty link
  /// where a pass begins; nothing if there is no link.
  std::optional<LinkPath> link_to(Vec2 p, double residual) const;
  /// Ends the pass and begins a new one at p, where nothing stands: the cutter comes down from above.
  LinkPath retract_to(Vec2 p);
  /// The same if nothing stands at p; else nothing.
  std::optional<LinkPath> retract_if_clear(Vec2 p);
  /// Records for the pass that begins at p whether anything stands there. To be called before p is cut.
  void note_start(Vec2 p);
  /// Appends `link` and `cut` to the pass; a pass begins with its first cut. The cut has already been removed
  /// from the remaining stock.
  void append(const Path& cut, const LinkPath& link);
  /// Appends `link` and `cut` and removes the cut from the remaining stock.
  void cut(const Path& cut, const LinkPath& link);

  bool empty() const { return pass_.path.empty(); }
  std::optional<Edge> last_arc() const;
  Vec2 at() const { return at_; }
  /// Ends the pass; the next cut begins a new one.
  void finish_pass();
  /// Reopens the last pass if none was begun after it.
  void resume_pass();
  /// All moves so far.
  std::vector<Edge> moves() const;
  /// Whether p is cleared by cuts that were joined into others, which run a little beside them and may not clear it.
  bool is_beside_joined(Vec2 p) const;
  /// Puts arcs in the place of the kinks between cuts, where that saves the machine time.
  void ease_joints(const Deviation& deviation, const MachineClock& clock);
  /// All passes; ends the current one.
  std::vector<Pass> take_passes();

 private:
  enum class Turns { kFull, kAny };
  bool widen(const Disc& disc, double engagement, Turns turns);
  bool keeps_limit(const Edge& half_turn, double limit) const;
  void cut_arc(Vec2 center, Vec2 to);
  void append_link(const LinkMove& move);
  std::optional<Edge> joined_to_last(const Edge& edge);

  RemainingStock& remaining_;
  const ClearLinks& links_;
  std::vector<Pass> passes_;
  std::vector<Edge> replaced_;  ///< cuts as they were before they were joined, where that moved them
  Pass pass_;
  Vec2 at_;
  /// mm from the spiral's centre to its last two ends of half turns.
  struct Ends {
    double left = 0;
    double right = 0;
  } spiral_;
};

/// A picture of one legal area for each step. References are kept.
class StepPictures {
 public:
  /// Draws nothing if `sink` is null.
  StepPictures(DebugSink* sink, const Region& legal, const ClearingPath& path)
      : sink_(sink), legal_(legal), path_(path) {}

  /// To be called after a step: the legal area in black, the moves of earlier steps in grey, those of this step, links
  /// included, in blue. No picture if the step has cut nothing.
  void after(std::string_view step);

 private:
  void draw(const Edge& edge, std::string_view color);

  DebugSink* sink_;
  const Region& legal_;
  const ClearingPath& path_;
  std::size_t drawn_ = 0;  ///< number of moves at the last picture
};

}  // namespace clearcut::plan::adaptive
