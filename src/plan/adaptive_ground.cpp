#include "plan/adaptive_ground.h"

#include <cmath>

namespace clearcut {
namespace {

/// mm. Thinner contact is rounding.
constexpr double kRounding = 2e-4;
/// Tool radii between the places where a straight way is looked at.
constexpr double kLookStep = 0.2;
/// Radians between the places where a contact is compared with the outline of the stock.
constexpr double kStockStep = 0.02;

Move level_move(const Edge& edge) {
  return {edge, -1, -1, MoveKind::kCut, {}, 0};
}

}  // namespace

Ground::Ground(const Regions& legal, double tool_radius, std::optional<Regions> stock)
    : legal_(legal), tool_radius_(tool_radius), material_(std::nullopt, 0, {tool_radius}) {
  if (stock) stock_.emplace(std::move(*stock));
}

double Ground::in_stock(const AngleSet& angles, Vec2 p, double reference) const {
  if (!stock_) return angles.measure();
  double sum = 0;
  for (const AngleInterval& item : angles.intervals()) {
    const int parts = static_cast<int>(item.width() / kStockStep) + 1;
    for (int i = 0; i < parts; ++i) {
      const double angle = reference + item.from + item.width() * (i + 0.5) / parts;
      if (stock_->contains(p + direction_of(angle) * tool_radius_)) sum += item.width() / parts;
    }
  }
  return sum;
}

double Ground::contact(Vec2 p, Vec2 heading) const {
  const Contact contact = material_.engagement(p, heading, tool_radius_ - kRounding, -1);
  return contact.angle > 0 ? in_stock(contact.angles, p, angle_of(heading)) : 0;
}

bool Ground::touches(Vec2 p, double film) const {
  const double radius = tool_radius_ - film;
  const AngleSet angles = material_.circle_in_material(p, radius, -1);
  return !angles.empty() && angles.measure() > 1e-6 && in_stock(angles, p, 0) > 0;
}

bool Ground::is_free(Vec2 a, Vec2 b, double film) const {
  if (!legal_.holds_line(a, b)) return false;
  const int steps = static_cast<int>(distance(a, b) / (tool_radius_ * kLookStep)) + 1;
  for (int i = 0; i <= steps; ++i) {
    if (touches(lerp(a, b, static_cast<double>(i) / steps), film)) return false;
  }
  return true;
}

void Ground::cut(const Edge& edge) {
  material_.add(level_move(edge), tool_radius_);
}

}  // namespace clearcut
