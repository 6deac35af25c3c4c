#include "report/picture/plan_marks.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/text.h"
#include "base/units.h"
#include "report/picture/svg_writer.h"
#include "report/words/text_table.h"

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

namespace {

constexpr int kMostFaultsMarked = 60;
constexpr double kLeastShown = 0.0005;  // mm: less prints as zero

/// 1, 2 or 5 times a power of ten, at most `most`.
double round_length(double most) {
  const double power = base::pow(10.0, std::floor(base::log10(most)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= most) return factor * power;
  }
  return power;
}

void halo_text(SvgWriter& svg, Vec2 at, const std::string& words, const std::string& color,
               const std::string& anchor) {
  svg.text(at, words,
           {{"font-size", "12"},
            {"font-weight", "bold"},
            {"text-anchor", anchor},
            {"fill", color},
            {"stroke", "#ffffff"},
            {"stroke-width", "3"},
            {"stroke-linejoin", "round"},
            {"paint-order", "stroke"}});
}

bool in_sight(const PlanView& view, Vec2 world_point) {
  return drawable(world_point) && view.visible().contains(world_point);
}

/// A ring with words beside it, on the side with room.
void draw_place(SvgWriter& svg, const PlanView& view, const Place& place, const std::string& words,
                const std::string& color) {
  if (!in_sight(view, place.point)) return;
  const Vec2 at = view.page(place.point);
  svg.leaf("circle", {{"cx", svg_number(at.x)},
                      {"cy", svg_number(at.y)},
                      {"r", "6.5"},
                      {"fill", "none"},
                      {"stroke", "#ffffff"},
                      {"stroke-width", "4.5"}});
  svg.leaf("circle", {{"cx", svg_number(at.x)},
                      {"cy", svg_number(at.y)},
                      {"r", "6.5"},
                      {"fill", "none"},
                      {"stroke", color},
                      {"stroke-width", "2"}});
  const bool left = at.x > view.corner.x + view.width * 0.65;
  const double y = std::clamp(at.y + 4, view.corner.y + 14, view.corner.y + view.height - 6);
  halo_text(svg, {at.x + (left ? -11 : 11), y}, words, color, left ? "end" : "start");
}

}  // namespace

void draw_scale_bar(SvgWriter& svg, const PlanView& view) {
  const double length = round_length(std::max(view.mm(view.width * 0.22), 1e-3));
  const Vec2 left{view.corner.x + 14, view.corner.y + view.height - 14};
  const double right = left.x + length * view.scale();
  const std::string data =
      "M" + svg_number(left.x) + " " + svg_number(left.y - 5) + "v5H" + svg_number(right) + "v-5";
  svg.leaf("path", {{"d", data}, {"fill", "none"}, {"stroke", "#ffffff"}, {"stroke-width", "4.5"}});
  svg.leaf("path",
           {{"d", data}, {"fill", "none"}, {"stroke", report::palette::kInk}, {"stroke-width", "1.6"}});
  halo_text(svg, {(left.x + right) / 2, left.y - 6}, trimmed(length, 3) + " mm", report::palette::kInk,
            "middle");
}

void draw_margin(SvgWriter& svg, const PlanView& view, const Margin& margin, const Feature* feature) {
  const FeatureMargin* shown = feature ? nullptr : margin.least();
  for (const FeatureMargin& one : margin.features)
    if (feature && one.feature == feature->name) shown = &one;
  if (shown && shown->at)
    draw_place(svg, view, *shown->at, "holds for " + trimmed(shown->mm, 4) + " mm", report::palette::kInk);
}

void draw_worst_places(SvgWriter& svg, const PlanView& view,
                       const std::vector<const FeatureFindings*>& findings) {
  for (const FeatureFindings* one : findings) {
    const Figures& f = one->figures;
    const char* checked = f.clean ? report::palette::kFaint : report::palette::kBad;
    if (f.engagement.max_at) {
      draw_place(svg, view, *f.engagement.max_at, fixed(f.engagement.max_deg, 0) + "\u00b0",
                 report::palette::kFaint);
    }
    if (f.uncut_at && f.uncut_thickness_mm >= kLeastShown) {
      draw_place(svg, view, *f.uncut_at, "left \u2264 " + fixed(f.uncut_thickness_mm, 3), checked);
    }
    // For a clean feature the gouge is below the limit.
    if (f.gouge_at && f.gouge_mm >= kLeastShown && !f.clean)
      draw_place(svg, view, *f.gouge_at, "gouge " + fixed(f.gouge_mm, 3), report::palette::kGouge);
  }
}

void draw_faults(SvgWriter& svg, const PlanView& view, const Findings& findings, const Feature* feature) {
  int marked = 0;
  for (const Fault& fault : findings.faults) {
    const bool wanted = feature == nullptr || fault.feature == feature->name;
    if (!wanted || !in_sight(view, fault.at.point) || marked == kMostFaultsMarked) continue;
    ++marked;
    const Vec2 at = view.page(fault.at.point);
    const std::string cross = "M" + svg_number(at.x - 5) + " " + svg_number(at.y - 5) + "l10 10m0 -10l-10 10";
    svg.open("g", {{"fill", "none"}, {"stroke-linecap", "round"}});
    svg.words("title", std::string(name_of(fault.kind)) + ": " + fault.text);
    svg.leaf("path", {{"d", cross}, {"stroke", "#ffffff"}, {"stroke-width", "5"}});
    svg.leaf("path", {{"d", cross}, {"stroke", report::palette::kBad}, {"stroke-width", "2.4"}});
    svg.close();
  }
}

}  // namespace clearcut::report
