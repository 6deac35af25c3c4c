// The path of an adaptive pass under construction: cuts, and links that are free because they stay in cleared
// discs.
#pragma once

#include <vector>

#include "plan/adaptive_cut.h"
#include "toolpath/pass.h"

namespace clearcut {

/// Builds one pass. Every disc knows the disc that it was cut from, so that a way back through cleared discs
/// exists.
class ClearingPath {
 public:
  explicit ClearingPath(double tool_radius) : tool_radius_(tool_radius) {}

  /// Begins with a circle of `entry_radius` about the disc's centre and widens it in half turns until the
  /// disc is cleared; no turn takes more than `engagement`. Returns the disc's index.
  int open(const Disc& disc, double entry_radius, double engagement);
  /// Cuts what `next` has outside disc `from` and returns its index.
  int widen(int from, const Disc& next);

  const Disc& disc(int index) const { return discs_[static_cast<std::size_t>(index)].disc; }
  Pass finish(int component) const;

 private:
  struct ClearedDisc {
    Disc disc;
    int parent = -1;
  };

  double room(int index) const { return disc(index).radius - tool_radius_; }
  int add(const Disc& disc, int parent);
  void cut_circle(const Disc& next, Vec2 start);
  void cut_arc(Vec2 center, Vec2 from, Vec2 to);
  void cut_line(Vec2 to);
  void link_to(Vec2 to, int within);
  void link_line(Vec2 to);
  std::vector<int> route(int from, int to) const;
  bool is_free(Vec2 a, Vec2 b) const;

  double tool_radius_;
  std::vector<ClearedDisc> discs_;
  Pass pass_;
  Vec2 at_;
  int at_disc_ = -1;  ///< a disc that contains at_ within its room
};

}  // namespace clearcut
