#include "plan/adaptive_ground.h"

#include <algorithm>
#include <cmath>

namespace clearcut {
namespace {

/// mm. Thinner contact is rounding.
constexpr double kRounding = 2e-4;
/// Radians. Less of the circle in material is rounding.
constexpr double kTouch = 1e-6;
/// Tool radii between the places where a straight way is looked at.
constexpr double kLookStep = 0.2;
/// Tool radii between the places where the contact of a cut is looked at.
constexpr double kCheckStep = 0.1;
/// Radians. No farther than this apart on arcs.
constexpr double kCheckTurn = 0.15;

Move level_move(const Edge& edge) {
  return {edge, -1, -1, MoveKind::kCut, {}, 0};
}

}  // namespace

Ground::Ground(const Regions& legal, double tool_radius, const std::optional<Box>& stock)
    : legal_(legal), tool_radius_(tool_radius), material_(stock, 0, {tool_radius}) {}

double Ground::contact(Vec2 p, Vec2 heading) const {
  return material_.engagement(p, heading, tool_radius_ - kRounding, -1).angle;
}

double Ground::length_within(const Edge& edge, double limit) const {
  const double length = edge.length();
  const double by_length = length / (tool_radius_ * kCheckStep),
               by_turn = std::abs(edge.sweep()) / kCheckTurn;
  const int steps = static_cast<int>(std::max(by_length, by_turn)) + 1;
  double good = 0;
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    if (contact(edge.at(t), edge.tangent_at(t)) > limit) return good * length;
    good = t;
  }
  return length;
}

bool Ground::touches(Vec2 p, double film) const {
  return touched(p, film).has_value();
}

std::optional<Vec2> Ground::touched(Vec2 p, double film) const {
  const double radius = tool_radius_ - film;
  const AngleSet left = material_.circle_in_material(p, radius, -1);
  AngleInterval widest;
  double sum = 0;
  for (const AngleInterval& item : left.intervals()) {
    sum += item.width();
    if (item.width() > widest.width()) widest = item;
  }
  if (sum <= kTouch) return std::nullopt;
  return p + direction_of((widest.from + widest.to) / 2) * radius;
}

bool Ground::is_free(Vec2 a, Vec2 b, double film) const {
  if (!legal_.holds_line(a, b)) return false;
  const int steps = static_cast<int>(distance(a, b) / (tool_radius_ * kLookStep)) + 1;
  // Most ways that are not free are seen at once by where the centre would run.
  for (int i = steps; i >= 0; --i) {
    if (!is_removed(lerp(a, b, static_cast<double>(i) / steps))) return false;
  }
  for (int i = 0; i <= steps; ++i) {
    if (touches(lerp(a, b, static_cast<double>(i) / steps), film)) return false;
  }
  return true;
}

bool Ground::keeps_limit(const std::vector<Edge>& cuts, double limit, double tiny) {
  const std::size_t before = material_.sweeps();
  bool kept = true;
  for (const Edge& edge : cuts) {
    kept = edge.length() < tiny || length_within(edge, limit) >= edge.length();
    if (!kept) break;
    cut(edge);
  }
  material_.forget_beyond(before);
  return kept;
}

void Ground::remove_disc(Vec2 center, double radius) {
  material_.add(level_move(Edge::line(center, center)), radius);
}

void Ground::cut(const Edge& edge) {
  material_.add(level_move(edge), tool_radius_);
}

}  // namespace clearcut
