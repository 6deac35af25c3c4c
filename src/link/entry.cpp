#include "link/entry.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "link/moves.h"

namespace clearcut::link {
namespace {

/// Radius of the centre's circle as a share of the tool radius; below 1, so that no post is left in the middle.
constexpr double kWidestHelix = 0.9;
constexpr double kNarrowestHelix = 0.2;
constexpr double kHelixShrink = 0.8;      // factor from one tried radius to the next
constexpr double kLongestRamp = 4;        // share of the tool radius
constexpr double kShortestRamp = 0.2;     // share of the tool radius
constexpr double kMostRounds = 4;         // greatest number of rounds along a ring during a descent
constexpr double kWidestArc = 1.6 * kPi;  // radians
constexpr double kSameTurn = 1e-6;        // arcs: rounding of a sweep by less adds no further arc

struct Circle {
  Vec2 center;
  double radius = 0;
};

/// Whether the whole disc is legal, within the tolerance of legal moves.
bool fits(const Circle& circle, const Regions& legal) {
  return std::any_of(legal.begin(), legal.end(), [&](const Region& region) {
    return region.contains(circle.center) &&
           region.boundary_distance(circle.center) >= circle.radius - LegalArea::kSlack;
  });
}

/// Radians that a helix turns to the depth at the entry angle; at least one turn, so that the whole depth is nowhere cut at once.
double turned_by_helix(const EntryPlace& place, const Circle& circle, const LinkOptions& options) {
  const double asked = (place.z_above - place.z) / (circle.radius * base::tan(options.entry_angle.radians()));
  return std::max(2 * kPi, asked);
}

std::optional<Circle> helix_circle(const EntryPlace& place, const Regions& legal,
                                   const LinkOptions& options) {
  if (place.circle_center) return Circle{*place.circle_center, distance(*place.circle_center, place.start)};
  const double widest = options.helix_widest.value_or(2 * kWidestHelix * options.tool_radius) / 2;
  const double narrowest = options.helix_narrowest.value_or(2 * kNarrowestHelix * options.tool_radius) / 2;
  for (double radius = widest; radius >= narrowest; radius *= kHelixShrink) {
    const Circle circle{place.start + left_of(place.direction) * radius, radius};
    if (turned_by_helix(place, circle, options) > 2 * kPi * kMostHelixTurns) return std::nullopt;
    if (fits(circle, legal)) return circle;
  }
  return std::nullopt;
}

/// At the ramp feed, reduced on steep ramps as required by the plunge feed.
Move ramp_move(const Edge& path, double z_from, double z_to, const LinkOptions& options) {
  const MmPerMin feed = sinking_feed(options.ramp_feed, options.plunge_feed, path.length(), z_from - z_to);
  return {path, z_from, z_to, MoveKind::kRamp, feed, 0};
}

/// Adds arcs counter-clockwise round the circle, as few as posts can write, from the end of `moves` (or from
/// `turned` radians before `end`) to `end`.
void append_turns(const Circle& circle, Vec2 end, double turned, double z_from, double z_to,
                  const LinkOptions& options, std::vector<Move>& moves) {
  const int arcs = static_cast<int>(std::ceil(turned / kWidestArc - kSameTurn));
  Vec2 at = moves.empty() ? circle.center + rotated(end - circle.center, -turned) : moves.back().path.to;
  double z = z_from;
  for (int left = arcs - 1; left >= 0; --left) {
    const double share = static_cast<double>(left) / arcs;
    const Vec2 next = left == 0 ? end : circle.center + rotated(end - circle.center, -turned * share);
    const double low = z_to + (z_from - z_to) * share;
    moves.push_back(ramp_move(Edge::arc(at, next, circle.center, Turn::kCounterClockwise), z, low, options));
    at = next;
    z = low;
  }
}

/// A helix that ends at the start of the pass.
std::vector<Move> helix(const EntryPlace& place, const Circle& circle, const LinkOptions& options) {
  const double turned = turned_by_helix(place, circle, options);
  std::vector<Move> moves;
  append_turns(circle, place.start, turned, place.z_above, place.z, options, moves);
  if (!place.circle_center) append_turns(circle, place.start, 2 * kPi, place.z, place.z, options, moves);
  return moves;
}

/// A ramp along the ring, edge by edge, up to the place where the depth is reached.
std::optional<Entry> ramp_along(const EntryPlace& place, const LinkOptions& options) {
  const double slope = base::tan(options.entry_angle.radians());
  const double around = length(*place.ring), stroke = (place.z_above - place.z) / slope;
  if (!(stroke > 0) || stroke > kMostRounds * around) return std::nullopt;
  Entry entry{{}, EntryKind::kRamp, std::fmod(stroke, around)};
  double left = stroke, z = place.z_above;
  for (std::size_t i = 0; left > 0; i = (i + 1) % place.ring->size()) {
    const Edge& edge = (*place.ring)[i];
    const double size = edge.length();
    const bool last = left <= size;
    const Edge piece = last && left < size ? edge.part(0, left / size) : edge;
    const double low = last ? place.z : z - size * slope;
    entry.moves.push_back(ramp_move(piece, z, low, options));
    z = low;
    left -= size;
  }
  return entry;
}

/// mm; length of the zigzag.
double longest_ramp(const LinkOptions& options) {
  return options.zigzag_length > 0 ? options.zigzag_length : kLongestRamp * options.tool_radius;
}

std::optional<Path> straight_stroke(const EntryPlace& place, const LegalArea& area,
                                    const LinkOptions& options) {
  for (double reach = longest_ramp(options); reach >= kShortestRamp * options.tool_radius; reach /= 2) {
    for (const double side : {1.0, -1.0}) {
      const Vec2 end = place.start + place.direction * (side * reach);
      if (area.holds(end) && area.holds_line(place.start, end)) return Path{Edge::line(place.start, end)};
    }
  }
  return std::nullopt;
}

/// The path of a zigzag during a descent.
std::optional<Path> stroke_at(const EntryPlace& place, const LegalArea& area, const LinkOptions& options) {
  Path along;
  if (place.run) along = beginning(*place.run, longest_ramp(options));
  if (place.stays_on_run && length(along) > kShortestRamp * options.tool_radius) return along;
  auto straight = straight_stroke(place, area, options);
  const double needed = straight ? 2 * length(*straight) : kShortestRamp * options.tool_radius;
  return length(along) > needed ? std::move(along) : straight;
}

std::vector<Move> ramp(const EntryPlace& place, const Path& stroke, const LinkOptions& options) {
  const double around = length(stroke), per_stroke = around * base::tan(options.entry_angle.radians());
  const double drop = place.z_above - place.z;
  const int pairs = std::max(1, static_cast<int>(std::ceil(drop / (2 * per_stroke))));
  const Path back = reversed(stroke);
  std::vector<Move> moves;
  const auto run = [&](const Path& path, double z_from, double z_to) {
    double z = z_from, along = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      along += path[i].length();
      const double next = i + 1 == path.size() ? z_to : z_from + (z_to - z_from) * along / around;
      moves.push_back(ramp_move(path[i], z, next, options));
      z = next;
    }
  };
  for (int i = 0; i < pairs; ++i) {
    const double from = place.z_above - drop * i / pairs, to = place.z_above - drop * (i + 1) / pairs;
    run(stroke, from, (from + to) / 2);
    run(back, (from + to) / 2, to);
  }
  run(stroke, place.z, place.z);
  run(back, place.z, place.z);
  return moves;
}

}  // namespace

Entry entry_at(const EntryPlace& place, const Regions& legal, const LinkOptions& options) {
  if (options.entry == EntryKind::kHelix || place.circle_center) {
    if (const auto circle = helix_circle(place, legal, options))
      return {helix(place, *circle, options), EntryKind::kHelix};
  }
  if (options.entry != EntryKind::kPlunge || !options.may_plunge) {
    if (place.ring && options.entry != EntryKind::kZigzagRamp) {
      if (auto along = ramp_along(place, options)) return *std::move(along);
    }
    if (const auto stroke = stroke_at(place, LegalArea(legal), options))
      return {ramp(place, *stroke, options), EntryKind::kZigzagRamp};
  }
  const Edge down = Edge::line(place.start, place.start);
  return {{{down, place.z_above, place.z, MoveKind::kPlunge, options.plunge_feed, 0}}, EntryKind::kPlunge};
}

}  // namespace clearcut::link
