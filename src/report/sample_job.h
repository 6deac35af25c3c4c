// A small job made by hand, for tests of reports: a block with a pocket around a round island, and a slot.
#pragma once

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::sample {

inline Vec2 at(double x, double y) {
  return {x, y};
}

inline Loop rectangle(double x0, double y0, double x1, double y1) {
  const Vec2 points[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return loop_from_points(points);
}

inline Loop circle(Vec2 center, double r) {
  const BulgeVertex vertices[] = {{{center.x - r, center.y}, 1}, {{center.x + r, center.y}, 1}};
  return loop_from_bulges(vertices);
}

inline Feature pocket(const std::string& name, Loop outer, std::vector<Loop> islands, double top,
                      double floor) {
  Feature f;
  f.name = name;
  f.target = {Region::from_valid_loops(std::move(outer), std::move(islands))};
  f.allowed = f.target;
  f.top_z = top;
  f.floor_z = floor;
  return f;
}

inline Part part() {
  Part p;
  p.name = "sample <part> & \"name\"";
  p.source_file = "sample.json";
  p.stock = Stock{{{0, 0}, {120, 80}}, -30, 0};
  p.tools = {Tool{1, "T1", ToolKind::kEndMill, 10, 0, 2, {}, true}};
  p.features = {pocket("POCKET1", rectangle(10, 10, 70, 60), {circle({40, 35}, 8)}, 0, -4),
                pocket("SLOT <2>", rectangle(80, 10, 110, 22), {}, 0, -8)};
  for (int i = 0; i < 2; ++i) {
    Workingstep step;
    step.name = "WS" + std::to_string(i + 1);
    step.feature = i;
    p.workplan.push_back(step);
  }
  return p;
}

/// Builds the moves of a section one after the other.
class Moves {
 public:
  explicit Moves(Vec2 start, double z) : at_(start), z_(z) {}
  Moves& to(MoveKind kind, Vec2 p, double z) { return add(Edge::line(at_, p), kind, z); }
  Moves& arc_to(MoveKind kind, Vec2 p, Vec2 center, Turn turn) {
    return add(Edge::arc(at_, p, center, turn), kind, z_);
  }
  Moves& loop(MoveKind kind, const Loop& loop) {
    for (const Edge& edge : loop) add(edge, kind, z_);
    return *this;
  }
  std::vector<Move> moves;

 private:
  Moves& add(const Edge& path, MoveKind kind, double z) {
    Move move;
    move.path = path;
    move.z_from = z_;
    move.z_to = z;
    move.kind = kind;
    move.feed = MmPerMin::of(is_rapid(kind) ? 0 : kind == MoveKind::kPlunge ? 200 : 800);
    move.line = 10 + static_cast<int>(moves.size());
    moves.push_back(move);
    at_ = path.to;
    z_ = z;
    return *this;
  }
  Vec2 at_;
  double z_;
};

inline Section pocket_section() {
  Section s{"POCKET1", 0, 1, 6000, true, Coolant::kOff, {}};
  Moves m({15, 15}, 5);
  for (const double z : {-2.0, -4.0}) {
    m.to(MoveKind::kRapid, {15, 15}, 1)
        .to(MoveKind::kPlunge, {15, 15}, z)
        .loop(MoveKind::kCut, rectangle(15, 15, 65, 55));
    m.to(MoveKind::kLink, {22, 22}, z).loop(MoveKind::kCut, rectangle(22, 22, 58, 48));
    m.to(MoveKind::kLink, {27, 35}, z);
    m.arc_to(MoveKind::kCut, {53, 35}, {40, 35}, Turn::kClockwise);
    m.arc_to(MoveKind::kCut, {27, 35}, {40, 35}, Turn::kClockwise);
    m.to(MoveKind::kRetract, {27, 35}, 5).to(MoveKind::kRapid, {15, 15}, 5);
  }
  s.moves = std::move(m.moves);
  return s;
}

inline Section slot_section() {
  Section s{"SLOT <2>", 1, 1, 6000, true, Coolant::kOff, {}};
  Moves m({85, 15}, 5);
  m.to(MoveKind::kRapid, {85, 15}, 1).to(MoveKind::kRamp, {105, 15}, -4).to(MoveKind::kRamp, {85, 15}, -8);
  m.loop(MoveKind::kCut, rectangle(85, 15, 105, 17)).to(MoveKind::kRetract, {85, 15}, 5);
  s.moves = std::move(m.moves);
  return s;
}

inline Toolpath toolpath() {
  return {{pocket_section(), slot_section()}};
}

inline Figures figures(double scale) {
  Figures f;
  f.feed_mm = 1000.25 * scale;
  f.rapid_mm = 200.5 * scale;
  f.plunge_mm = 12 * scale;
  f.turns = static_cast<int>(40 * scale);
  f.turn_angle_deg = 3600 * scale;
  f.retracts = static_cast<int>(2 * scale);
  f.time_s = 90 * scale;
  f.time_naive_s = 75 * scale;
  f.uncut_mm2 = 0.125;
  f.uncut_thickness_mm = 0.25;
  f.uncut_at = Place{{66.5, 56.5}, -4, 0};
  f.gouge_mm = 0.0005;
  f.gouge_at = Place{{15, 10}, -4, 12};
  f.unreachable_mm2 = 21.46 * scale;
  f.max_axial_mm = 2;
  f.engagement.max_deg = 180;
  f.engagement.max_at = Place{{30, 15}, -2, 12};
  f.engagement.mean_deg = 75.5;
  f.engagement.histogram_mm[9] = 640.5;
  f.engagement.climb_mm = 500;
  f.engagement.conventional_mm = 250;
  f.air_cut_mm = 3.5;
  f.lower_bound_mm = 640;
  f.clean = false;
  return f;
}

inline Findings findings() {
  Findings found;
  found.all = figures(2);
  for (const int i : {0, 1}) {
    FeatureFindings f{i == 0 ? "POCKET1" : "SLOT <2>", i, 1, 10, figures(1), {}};
    f.layers = {{-2, figures(0.5)}, {-4, figures(0.5)}};
    found.features.push_back(f);
  }
  found.faults.push_back(
      {FaultKind::kUncut, "POCKET1", {{66.5, 56.5}, -4, 0}, 0.25, "0.25 mm left in the <corner>"});
  return found;
}

}  // namespace clearcut::sample
