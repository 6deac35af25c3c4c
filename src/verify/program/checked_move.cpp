#include "verify/program/checked_move.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "kinematics/kinematics.h"
#include "kinematics/planner.h"
#include "verify/program/attribution.h"

namespace clearcut::verify {
namespace {

/// mm. Heights differing by less belong to one layer.
constexpr double kSameLayer = 1e-3;

const Tool* tool_of(const Part& part, int number) {
  if (const Tool* const tool = tool_numbered(part.tools, number)) return tool;
  // A program without tool words, for a part with one tool.
  return number <= 0 && part.tools.size() == 1 ? &part.tools.front() : nullptr;
}

void attribute(const Part& part, const Toolpath& toolpath, std::vector<CheckedMove>& moves) {
  const Attribution attribution(part);
  std::size_t k = 0;
  int previous = -1;
  for (const Section& section : toolpath.sections) {
    const int whole = attribution.by_section(section);
    for (std::size_t i = 0; i < section.moves.size(); ++i, ++k) {
      CheckedMove& checked = moves[k];
      checked.workingstep = whole;
      if (whole >= 0 || !checked.feeds()) continue;
      checked.workingstep = previous = attribution.by_place(checked, previous);
    }
  }
  // Rapids, and feed moves off all features, belong to the workingstep of the next move, at the end of the last.
  int next = -1;
  for (auto checked = moves.rbegin(); checked != moves.rend(); ++checked) {
    if (checked->workingstep < 0) checked->workingstep = next;
    next = checked->workingstep;
  }
  previous = -1;
  for (CheckedMove& checked : moves) {
    if (checked.workingstep < 0) checked.workingstep = previous;
    previous = checked.workingstep;
  }
}

/// A workingstep cut only by plunges has one layer, at its lowest tip.
void add_drilled_depths(const Part& part, CheckedProgram& program) {
  std::vector<double> lowest(program.layers.size(), part.top_z());
  for (const CheckedMove& checked : program.moves) {
    if (checked.workingstep < 0 || !checked.feeds()) continue;
    double& low = lowest[checked.workingstep];
    low = std::min(low, checked.low_z());
  }
  for (std::size_t i = 0; i < lowest.size(); ++i) {
    if (program.layers[i].empty() && lowest[i] < part.top_z()) program.layers[i].push_back(lowest[i]);
  }
}

/// Passes rising over the tabs of a profile are level on top: this level is no layer.
bool is_over_tabs(const Part& part, const CheckedMove& checked) {
  const Feature& feature = feature_of(part, part.workplan[static_cast<std::size_t>(checked.workingstep)]);
  return feature.profile && !feature.profile->tabs.empty() && checked.low_z() > feature.top_z - kSameLayer;
}

void find_layers(const Part& part, CheckedProgram& program) {
  program.layers.resize(part.workplan.size());
  for (const CheckedMove& checked : program.moves) {
    if (checked.workingstep < 0 || !checked.feeds() || !checked.is_flat() ||
        checked.low_z() >= part.top_z() || is_over_tabs(part, checked))
      continue;
    LayerHeights& layers = program.layers[checked.workingstep];
    const bool known = std::any_of(layers.begin(), layers.end(),
                                   [&](double z) { return std::abs(z - checked.low_z()) < kSameLayer; });
    if (!known) layers.push_back(checked.low_z());
  }
  add_drilled_depths(part, program);
  for (LayerHeights& layers : program.layers) std::sort(layers.rbegin(), layers.rend());
}

/// A descending move belongs to the layer at its end, moves in between to the layer cut before.
void assign_layers(CheckedProgram& program) {
  int layer = 0, workingstep = -1;
  for (CheckedMove& checked : program.moves) {
    if (checked.workingstep < 0) continue;
    const LayerHeights& layers = program.layers[checked.workingstep];
    if (checked.workingstep != workingstep) layer = 0;
    workingstep = checked.workingstep;
    if (layers.empty()) continue;
    if (checked.feeds() && checked.low_z() < layers.front() + kSameLayer) {
      const auto at = std::find_if(layers.begin(), layers.end(),
                                   [&](double z) { return z <= checked.low_z() + kSameLayer; });
      layer = static_cast<int>(std::min<std::ptrdiff_t>(at - layers.begin(), std::ssize(layers) - 1));
    }
    checked.layer = layer;
  }
}

/// mm; 0 if the control keeps to the path. 0 also if no bound is known; this is then a condition of the certificate.
double path_tolerance_of(const ControlState* state, const Machine& machine) {
  if (state == nullptr) return 0;
  const PathControl& path = state->path;
  switch (path.mode) {
    case PathMode::kExactPath:
    case PathMode::kExactStop:
      return 0;
    case PathMode::kTolerance:
      return path.tolerance_mm.value_or(0) + path.merging_mm.value_or(0);
    case PathMode::kUnstated:
    case PathMode::kContinuous:
    case PathMode::kSmoothness:
      break;
  }
  return machine.path_tolerance.value_or(0);
}

/// Adds dwells, and the time of tool changes on this machine.
void add_waits(const ControlTable& control, const Machine& machine, std::vector<CheckedMove>& moves) {
  if (moves.empty()) return;
  for (const ControlEvent& event : control.events) {
    const double seconds = event.kind == ControlEventKind::kDwell        ? event.seconds
                           : event.kind == ControlEventKind::kToolChange ? machine.tool_change_s
                                                                         : 0;
    CheckedMove& after = moves[std::min(event.before_move, moves.size() - 1)];
    after.waits_s += seconds;
    after.time_s += seconds;
  }
}

void append_moves(const Part& part, const Toolpath& toolpath, const Machine& machine,
                  std::vector<CheckedMove>& out, const ControlTable* control) {
  const std::size_t begin = out.size();
  std::size_t count = begin;
  for (const Section& section : toolpath.sections) count += section.moves.size();
  out.reserve(count);
  const std::vector<kinematics::PlannedMove> planned = kinematics::planned_moves(toolpath, control);
  const std::vector<Seconds> times = kinematics::planned_times(
      planned, machine, control ? control->planner : std::optional<MotionPlanner>());
  for (const Section& section : toolpath.sections) {
    const std::size_t first = out.size() - begin;
    for (std::size_t i = 0; i < section.moves.size(); ++i) {
      CheckedMove checked;
      checked.move = &section.moves[i];
      checked.tool = tool_of(part, section.tool_number);
      checked.tool_number = section.tool_number;
      checked.clockwise = section.spindle_clockwise;
      checked.carried_below = section.carried_below;
      checked.is_of_stock = section.is_of_stock;
      checked.rpm = section.spindle_rpm;
      if (control) {
        checked.control = control->at(first + i);
        checked.path_tolerance = path_tolerance_of(checked.control, machine);
        checked.doubt = control->doubt_at(first + i);
      }
      checked.time_s = times[first + i].seconds();
      checked.time_naive_s = kinematics::naive_time(section.moves[i], machine).seconds();
      out.push_back(checked);
    }
  }
  if (control) add_waits(*control, machine, out);
}

}  // namespace

CheckedProgram checked_program(const Part& part, const Toolpath& toolpath, const Machine& machine,
                               const Toolpath* earlier, const ControlTable* control,
                               const ControlTable* earlier_control) {
  CheckedProgram program;
  append_moves(part, toolpath, machine, program.moves, control);
  attribute(part, toolpath, program.moves);
  find_layers(part, program);
  assign_layers(program);
  if (earlier == nullptr) return program;
  std::vector<CheckedMove> own = std::move(program.moves);
  program.moves.clear();
  append_moves(part, *earlier, machine, program.moves, earlier_control);
  for (CheckedMove& checked : program.moves) checked.earlier = true;
  program.moves.insert(program.moves.end(), own.begin(), own.end());
  return program;
}

namespace {

/// Radians. Smaller turns are due to rounding of smooth joins: the cut-off there is thousandths of a move's length.
constexpr double kSmoothTurn = 0.01;

bool may_round(const CheckedMove& checked) {
  return checked.feeds() && !checked.move->is_vertical();
}

double turn_between(const Move& before, const Move& after) {
  const Vec2 in = before.path.tangent_at(1), out = after.path.tangent_at(0);
  return std::abs(base::atan2(cross(in, out), dot(in, out)));
}

bool is_corner(const CheckedMove& before, const CheckedMove& after) {
  return may_round(before) && may_round(after) &&
         distance(before.move->path.to, after.move->path.from) < kSamePlaceMm &&
         turn_between(*before.move, *after.move) > kSmoothTurn;
}

/// The piece of a move from one point to another replacing its end: an arc keeps its curvature, because its chord
/// would cut off more than a control within the tolerance.
Edge bent(const Edge& path, Vec2 from, Vec2 to) {
  return path.is_arc() ? Edge::from_bulge(from, to, base::tan(path.sweep() / 4)) : Edge::line(from, to);
}

}  // namespace

std::optional<std::array<Move, 2>> rounded_corner(const CheckedMove& before, const CheckedMove& after,
                                                  double tolerance) {
  if (tolerance <= 0 || !is_corner(before, after)) return std::nullopt;
  const Move &a = *before.move, &b = *after.move;
  // The circle tangent to both moves that passes the corner at the tolerance, on at most half of each move.
  const double half = (kPi - turn_between(a, b)) / 2;
  const double legs = std::min(a.path.length(), b.path.length()) / 2;
  const double sine = std::max(base::sin(half), 1e-6);
  const double along = std::min(legs, tolerance * base::cos(half) / std::max(1 - sine, 1e-9));
  if (along <= kSamePlaceMm) return std::nullopt;
  const double ta = 1 - along / a.path.length(), tb = along / b.path.length();
  const Vec2 leave = a.path.at(ta), join = b.path.at(tb), corner = a.path.to;
  const Vec2 inward = (leave + join) / 2 - corner;
  if (norm(inward) <= kSamePlaceMm) return std::nullopt;
  const Vec2 inside = corner + unit(inward) * std::min(tolerance, norm(inward));
  const double za = std::lerp(a.z_from, a.z_to, ta), zb = std::lerp(b.z_from, b.z_to, tb);
  Move first = a, second = b;
  first.path = bent(a.path.part(ta, 1), leave, inside);
  first.z_from = za, first.z_to = a.z_to;
  second.path = bent(b.path.part(0, tb), inside, join);
  second.z_from = a.z_to, second.z_to = zb;
  return std::array<Move, 2>{first, second};
}

double corner_tolerance(std::span<const CheckedMove> moves) {
  double most = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const double tolerance = std::max(moves[i - 1].path_tolerance, moves[i].path_tolerance);
    if (tolerance > most && is_corner(moves[i - 1], moves[i])) most = tolerance;
  }
  return most;
}

}  // namespace clearcut::verify
