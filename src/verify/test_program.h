// For tests: parts and programs written by hand, move by move.
#pragma once

#include <vector>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::testing {

inline Regions rectangle(double x0, double y0, double x1, double y1) {
  const std::vector<Vec2> corners{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return {Region::from_valid_loops(loop_from_points(corners), {})};
}

inline Loop circle_loop(Vec2 center, double radius) {
  const Vec2 a = center + Vec2{radius, 0}, b = center - Vec2{radius, 0};
  return {Edge::arc(a, b, center, Turn::kCounterClockwise), Edge::arc(b, a, center, Turn::kCounterClockwise)};
}

/// A closed pocket from z = 0 down to `floor_z`, no stock given.
inline Part pocket_part(const Regions& outline, double diameter, double floor_z) {
  Part part;
  Tool tool;
  tool.diameter = diameter;
  part.tools.push_back(tool);
  Feature feature;
  feature.name = "POCKET";
  feature.target = feature.allowed = outline;
  feature.floor_z = floor_z;
  part.features.push_back(feature);
  Workingstep step;
  step.name = "POCKET rough";
  step.feature = 0;
  step.operation.tool = 0;
  part.workplan.push_back(step);
  return part;
}

/// Writes moves one after the other, as a program read back: no labels, line numbers from 1.
class Writer {
 public:
  explicit Writer(int tool = 1) { tool_change(tool); }

  Writer& tool_change(int tool) {
    toolpath_.sections.push_back({});
    toolpath_.sections.back().tool_number = tool;
    return *this;
  }
  Writer& rapid(Vec2 to, double z) { return add(Edge::line(at_, to), z, MoveKind::kRapid, 0); }
  Writer& feed(Vec2 to, double z, double feed = 1000) {
    return add(Edge::line(at_, to), z, MoveKind::kCut, feed);
  }
  Writer& feed(Vec2 to) { return feed(to, z_); }
  Writer& arc(Vec2 to, Vec2 center, Turn turn) {
    return add(Edge::arc(at_, to, center, turn), z_, MoveKind::kCut, 1000);
  }
  /// Counter-clockwise about `center`, down or up to z.
  Writer& helix(Vec2 to, Vec2 center, double z) {
    return add(Edge::arc(at_, to, center, Turn::kCounterClockwise), z, MoveKind::kCut, 500);
  }
  /// Rapid over `to`, rapid down to 1 mm over `top`, plunge to z.
  Writer& enter(Vec2 to, double top, double z) {
    rapid(at_, 10).rapid(to, 10).rapid(to, top + 1);
    return feed(to, z, 300);
  }
  Writer& leave() { return rapid(at_, 10); }
  int line() const { return line_; }
  Toolpath done() { return leave().toolpath_; }

 private:
  Writer& add(Edge path, double z, MoveKind kind, double feed) {
    if (path.from == path.to && z == z_) return *this;
    toolpath_.sections.back().moves.push_back({path, z_, z, kind, MmPerMin::of(feed), ++line_});
    at_ = path.to;
    z_ = z;
    return *this;
  }

  Toolpath toolpath_;
  Vec2 at_;
  double z_ = 10;
  int line_ = 0;
};

/// Square rings about `center` at the given half widths, from the innermost outwards, staying down.
inline void cut_square_rings(Writer& writer, Vec2 center, const std::vector<double>& half_widths, double top,
                             double z) {
  bool down = false;
  for (const double h : half_widths) {
    const Vec2 start = center + Vec2{-h, -h};
    if (down) {
      writer.feed(start);
    } else {
      writer.enter(start, top, z);
    }
    down = true;
    writer.feed(center + Vec2{h, -h}).feed(center + Vec2{h, h}).feed(center + Vec2{-h, h}).feed(start);
  }
}

}  // namespace clearcut::testing
