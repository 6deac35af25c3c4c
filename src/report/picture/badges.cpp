#include "report/picture/badges.h"

#include <algorithm>

#include "base/units.h"
#include "report/picture/palette.h"

namespace clearcut::report {
namespace {

constexpr double kBadgeHalfHeight = 12;
/// Page units: width of a digit, and the total margin on both sides of a text.
constexpr double kBadgeDigit = 7.6, kBadgeBeside = 12;
constexpr double kBadgeGap = 1;
/// Distance of the rings about the place on which room is searched, and places on each ring.
constexpr double kBadgeRingStep = 7;
constexpr int kBadgeRings = 40, kBadgePlaces = 16;

double badge_half_width(const std::string& text) {
  return std::max(kBadgeHalfHeight, (kBadgeDigit * static_cast<double>(text.size()) + kBadgeBeside) / 2);
}

bool is_inside(const Box& inner, const Box& outer) {
  return outer.contains(inner.min) && outer.contains(inner.max);
}

}  // namespace

Box covered_by(const std::string& text, Vec2 middle) {
  const Vec2 half{badge_half_width(text), kBadgeHalfHeight};
  return {middle - half, middle + half};
}

std::vector<PlacedBadge> placed_apart(const std::vector<Badge>& badges, const Box& bounds) {
  std::vector<PlacedBadge> placed;
  std::vector<Box> taken;
  const auto is_free = [&](const Box& box) {
    return is_inside(box, bounds) &&
           std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return box.overlaps(other); });
  };
  const auto try_at = [&](const Badge& badge, Vec2 middle) {
    const Box box = covered_by(badge.text, middle);
    if (!is_free(box)) return false;
    taken.push_back(box.grown(kBadgeGap));
    placed.push_back({middle, badge});
    return true;
  };
  for (const Badge& badge : badges) {
    bool is_placed = try_at(badge, badge.place);
    for (int ring = 1; ring <= kBadgeRings && !is_placed; ++ring) {
      for (int i = 0; i < kBadgePlaces && !is_placed; ++i)
        is_placed =
            try_at(badge, badge.place + direction_of(2 * kPi * i / kBadgePlaces) * (ring * kBadgeRingStep));
    }
  }
  return placed;
}

std::string numbers_text(const std::vector<int>& ascending) {
  std::string text;
  for (std::size_t i = 0; i < ascending.size();) {
    std::size_t last = i;
    while (last + 1 < ascending.size() && ascending[last + 1] == ascending[last] + 1) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(ascending[i]);
    if (last > i) text += (last > i + 1 ? "-" : ", ") + std::to_string(ascending[last]);
    i = last + 1;
  }
  return text;
}

void draw_badges(SvgWriter& svg, const std::vector<PlacedBadge>& badges) {
  for (const PlacedBadge& one : badges) {
    const Vec2 at = one.middle;
    if (!covered_by(one.badge.text, at).contains(one.badge.place)) {
      svg.leaf("path", {{"d", "M" + svg_number(at.x) + " " + svg_number(at.y) + "L" +
                                  svg_number(one.badge.place.x) + " " + svg_number(one.badge.place.y)},
                        {"stroke", report::palette::kInk},
                        {"stroke-width", "1"},
                        {"fill", "none"}});
    }
  }
  for (const PlacedBadge& one : badges) {
    const Box box = covered_by(one.badge.text, one.middle);
    svg.leaf("rect", {{"x", svg_number(box.min.x)},
                      {"y", svg_number(box.min.y)},
                      {"width", svg_number(box.width())},
                      {"height", svg_number(box.height())},
                      {"rx", svg_number(kBadgeHalfHeight)},
                      {"fill", "#ffffff"},
                      {"stroke", report::palette::kInk},
                      {"stroke-width", "1.4"},
                      {"class", "badge"}});
    svg.text({one.middle.x, one.middle.y + 4.6}, one.badge.text,
             {{"font-size", "13"},
              {"font-weight", "bold"},
              {"text-anchor", "middle"},
              {"fill", report::palette::kInk}});
  }
}

}  // namespace clearcut::report
