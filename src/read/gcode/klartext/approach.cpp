#include "read/gcode/klartext/approach.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::read::gcode {

std::optional<ContactWords> contact_words(const std::vector<std::string>& words) {
  constexpr std::string_view kKinds[] = {"LT", "LN", "CT", "LCT"};
  if (words.size() < 2) return std::nullopt;
  ContactWords found;
  found.polar = words[1][0] == 'P';
  const std::string_view name = std::string_view(words[1]).substr(found.polar ? 1 : 0);
  const auto* const kind = std::find(std::begin(kKinds), std::end(kKinds), name);
  if (kind == std::end(kKinds)) return std::nullopt;
  found.kind = static_cast<ContactKind>(kind - std::begin(kKinds));
  found.words = {words[0]};
  for (std::size_t k = 2; k < words.size(); ++k) {
    if (words[k].rfind("LEN", 0) == 0)
      found.length = words[k].substr(3);
    else if (words[k].rfind("CCA", 0) == 0)
      found.angle = words[k].substr(3);
    else
      found.words.push_back(words[k]);
  }
  return found;
}

Vec2 place_across(const Contact& contact, double length) {
  return contact.place + left_of(contact.along) * (contact.side * (length + contact.tool_radius));
}

namespace {

/// 1 where an arc of that radius turns counter-clockwise, else -1.
double turn_of(const Contact& contact, double radius) {
  return contact.side * radius > 0 ? 1 : -1;
}

Vec2 center_of(const Contact& contact, double radius) {
  return contact.place + left_of(contact.along) * (contact.side * radius);
}

Turn named(double turn) {
  return turn > 0 ? Turn::kCounterClockwise : Turn::kClockwise;
}

/// radians, between the point of contact and that where the line to `outside` touches the circle of the centre. `comes`: the tool comes from there.
std::optional<double> sweep_between(const Contact& contact, double radius, Vec2 outside, bool comes) {
  const Vec2 center = center_of(contact, radius), arm = outside - center;
  const double of_center = radius - contact.tool_radius, apart = norm(arm);
  if (!(apart > of_center)) return std::nullopt;
  const double turn = turn_of(contact, radius), beside = base::acos(of_center / apart);
  const Vec2 touches = rotated(arm, (comes ? turn : -turn) * beside), at = contact.place - center;
  const Vec2 from = comes ? touches : at, to = comes ? at : touches;
  const double sweep = turn * base::atan2(cross(from, to), dot(from, to));
  return sweep < 0 ? sweep + 2 * kPi : sweep;
}

}  // namespace

ArcShape arc_to(const Contact& contact, double radius, double sweep) {
  const Vec2 center = center_of(contact, radius);
  const double turn = turn_of(contact, radius);
  return {center + rotated(contact.place - center, -turn * sweep), contact.place, center, named(turn), sweep};
}

ArcShape arc_from(const Contact& contact, double radius, double sweep) {
  const Vec2 center = center_of(contact, radius);
  const double turn = turn_of(contact, radius);
  return {contact.place, center + rotated(contact.place - center, turn * sweep), center, named(turn), sweep};
}

std::optional<ArcShape> arc_to_from(const Contact& contact, double radius, Vec2 outside) {
  const auto sweep = sweep_between(contact, radius, outside, true);
  if (!sweep) return std::nullopt;
  return arc_to(contact, radius, *sweep);
}

std::optional<ArcShape> arc_from_to(const Contact& contact, double radius, Vec2 outside) {
  const auto sweep = sweep_between(contact, radius, outside, false);
  if (!sweep) return std::nullopt;
  return arc_from(contact, radius, *sweep);
}

}  // namespace clearcut::read::gcode
