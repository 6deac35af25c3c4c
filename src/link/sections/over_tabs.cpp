#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "link/sections/high_rapids.h"

namespace clearcut::link {
namespace {

/// mm. Paths with a smaller change of distance from the outline count as parallel to it.
constexpr double kParallel = 1e-6;
/// mm. Other paths are raised in pieces of this length.
constexpr double kPiece = 0.1;
/// Share of a path's length: places nearer to each other are one.
constexpr double kSamePlace = 1e-9;
/// mm above the top of a square tab at which the cutter crosses the tab without rubbing on it.
constexpr double kAbove = 0.2;
/// mm. Ends of passes on both sides of a tab are on one contour, and equally far from its middle, to within this.
constexpr double kSameContour = 1e-3;
constexpr double kSymmetric = 0.1;
/// mm. Programs of four decimals of an inch round both ends of a move to 0.0013 mm; arcs they may divide into so many
/// pieces.
constexpr double kRounded = 0.0026;
constexpr double kPiecesOfArc = 8;
constexpr double kNowhere = -std::numeric_limits<double>::infinity();

/// A place seen from a tab, mm.
struct Beside {
  double along = 0;   ///< from the tab's middle along the outline
  double aside = 0;   ///< from the outline into the kerf
  double radius = 0;  ///< from the centre of the outline's arc; unused beside lines
};

/// Whether the outline's arc runs counter-clockwise: 1, else -1.
double turn_of(const Tab& tab) {
  return tab.foot.turn == Turn::kCounterClockwise ? 1 : -1;
}

Beside beside(const Tab& tab, Vec2 p) {
  const Vec2 middle = tab.foot.at(0.5);
  const double side = tab.aside < 0 ? -1 : 1;
  if (!tab.foot.is_arc()) {
    const Vec2 along = tab.foot.tangent_at(0.5), from = p - middle;
    return {dot(from, along), dot(from, left_of(along)) * side, 0};
  }
  const Vec2 arm = middle - tab.foot.center, to = p - tab.foot.center;
  const double angle = base::atan2(cross(arm, to), dot(arm, to)) * turn_of(tab);
  // The centre of a counter-clockwise arc is on its left.
  const double inwards = tab.foot.radius() - norm(to);
  return {angle * tab.foot.radius(), inwards * turn_of(tab) * side, norm(to)};
}

/// One triangular tab, and the lowest permitted heights of a cutter around it.
class Ridge {
 public:
  Ridge(const Tab& tab, double radius)
      : tab_(tab),
        radius_(radius),
        steepness_(2 * (tab.top_z - tab.bottom_z) / tab.foot.length()),
        around_(box(tab.body).grown(radius)) {}

  double steepness() const { return steepness_; }

  bool is_near(const Move& move) const {
    const Box path = move.path.box();
    return std::min(move.z_from, move.z_to) < tab_.top_z && path.overlaps(around_);
  }

  /// The lowest permitted height of the tip with the cutter's centre over p.
  double lowest(Vec2 p) const {
    const Beside at = beside(tab_, p);
    const bool in_kerf = at.aside > -radius_ && at.aside < std::abs(tab_.aside) + radius_;
    if (!in_kerf) return kNowhere;
    return tab_.top_z - steepness_ * std::max(0.0, std::abs(at.along) - reach(at));
  }

  /// Whether the lowest height over the path is linear between its bends.
  bool is_followed_by(const Edge& path) const {
    if (path.is_arc() != tab_.foot.is_arc()) return false;
    if (path.is_arc()) return distance(path.center, tab_.foot.center) < kParallel;
    return std::abs(beside(tab_, path.from).aside - beside(tab_, path.to).aside) < kParallel;
  }

  /// Parameters of a path along the tab at which its lowest height changes from rising to level and from level to
  /// falling; some may be beyond its ends.
  std::vector<double> bends(const Edge& path) const {
    const Beside from = beside(tab_, path.from);
    const double r = tab_.foot.radius();
    const double way =
        path.is_arc() ? path.sweep() * turn_of(tab_) * r : beside(tab_, path.to).along - from.along;
    std::vector<double> places;
    for (const double bend : {-reach(from), reach(from)}) {
      places.push_back((bend - from.along) / way);
      if (!path.is_arc()) continue;
      // The path may pass the angle at which angles wrap around.
      places.push_back((bend - from.along + 2 * kPi * r) / way);
      places.push_back((bend - from.along - 2 * kPi * r) / way);
    }
    return places;
  }

 private:
  /// mm along the outline as far as the cutter reaches from its centre, at most.
  double reach(const Beside& at) const {
    if (!tab_.foot.is_arc()) return radius_;
    const double sine = at.radius > radius_ ? radius_ / at.radius : 1;
    return tab_.foot.radius() * base::asin(sine);
  }

  const Tab& tab_;
  double radius_;
  double steepness_;  ///< mm up for each mm along the outline
  Box around_;
};

/// A place on a move, and how high the tip has to be there.
struct Raised {
  double t = 0;
  double z = 0;
};

double z_at(const Move& move, double t) {
  return move.z_from + (move.z_to - move.z_from) * t;
}

void sort_places(std::vector<double>& places) {
  std::erase_if(places, [](double t) { return t < kSamePlace || t > 1 - kSamePlace; });
  places.insert(places.end(), {0.0, 1.0});
  std::sort(places.begin(), places.end());
  const auto same = [](double a, double b) { return b - a < kSamePlace; };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
}

/// Raises a move along the tab's outline: exact.
std::vector<Raised> raised_along(const Move& move, const Ridge& ridge) {
  const auto over = [&](double t) { return ridge.lowest(move.path.at(t)) - z_at(move, t); };
  std::vector<double> places = ridge.bends(move.path);
  sort_places(places);
  std::vector<double> crossings;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double t0 = places[i - 1], t1 = places[i], a = over(t0), b = over(t1);
    if (a * b < 0) crossings.push_back(t0 + (t1 - t0) * a / (a - b));
  }
  places.insert(places.end(), crossings.begin(), crossings.end());
  sort_places(places);
  std::vector<Raised> raised;
  for (const double t : places) {
    const double up = over(t);
    raised.push_back({t, z_at(move, t) + (up > kRoundingMm ? up : 0)});
  }
  return raised;
}

/// Raises any other move: in short pieces, each as high as required at its ends.
std::vector<Raised> raised_across(const Move& move, const Ridge& ridge) {
  const double length = move.path.length();
  const int pieces = std::max(1, static_cast<int>(std::ceil(length / kPiece)));
  const double rise = ridge.steepness() * length / pieces;
  std::vector<double> lowest;
  for (int i = 0; i <= pieces; ++i)
    lowest.push_back(ridge.lowest(move.path.at(static_cast<double>(i) / pieces)) + rise);
  std::vector<Raised> raised;
  for (int i = 0; i <= pieces; ++i) {
    const auto here = lowest.begin() + i;
    const auto first = i > 0 ? here - 1 : here, last = i < pieces ? here + 2 : here + 1;
    const double t = static_cast<double>(i) / pieces;
    raised.push_back({t, std::max(z_at(move, t), *std::max_element(first, last))});
  }
  return raised;
}

bool is_raised(const Move& move, const std::vector<Raised>& places) {
  return std::any_of(places.begin(), places.end(),
                     [&](const Raised& place) { return place.z > z_at(move, place.t) + kRoundingMm; });
}

/// The feed at which the tip descends no faster than at `plunge_feed`, even if the program rounds both ends of a
/// short move.
MmPerMin slowed(const Move& move, MmPerMin plunge_feed) {
  if (is_rapid(move.kind) || move.z_from <= move.z_to) return move.feed;
  const double rounded = kRounded * (move.path.is_arc() ? kPiecesOfArc : 1);
  const double down = move.z_from - move.z_to + rounded, length = std::max(down, move.length() - rounded);
  if (move.feed.mm_per_min() * down <= plunge_feed.mm_per_min() * length) return move.feed;
  return MmPerMin::of(plunge_feed.mm_per_min() * length / down);
}

void append_raised(const Move& move, const Ridge& ridge, MmPerMin plunge_feed, std::vector<Move>& out) {
  if (!ridge.is_near(move)) return out.push_back(move);
  if (move.is_vertical()) {
    Move higher = move;
    const double lowest = ridge.lowest(move.path.from);
    higher.z_from = std::max(move.z_from, lowest);
    higher.z_to = std::max(move.z_to, lowest);
    if (higher.z_from != higher.z_to) out.push_back(higher);
    return;
  }
  const std::vector<Raised> places =
      ridge.is_followed_by(move.path) ? raised_along(move, ridge) : raised_across(move, ridge);
  if (!is_raised(move, places)) return out.push_back(move);
  Vec2 from = move.path.from;
  for (std::size_t i = 1; i < places.size(); ++i) {
    Move piece = move;
    piece.path = move.path.part(places[i - 1].t, places[i].t);
    piece.path.from = from;
    if (i + 1 == places.size()) piece.path.to = move.path.to;
    piece.z_from = places[i - 1].z;
    piece.z_to = places[i].z;
    piece.feed = slowed(piece, plunge_feed);
    from = piece.path.to;
    out.push_back(piece);
  }
}

/// The path over a tab from p to q, if these are on its two sides on one contour beside the outline.
std::optional<Edge> way_over(const Tab& tab, double radius, Vec2 p, Vec2 q) {
  const Beside from = beside(tab, p), to = beside(tab, q);
  const double reach = std::max(tab.foot.length(), norm(q - p)) / 2 + radius;
  const bool opposite = from.along * to.along < 0 && std::abs(from.along + to.along) < kSymmetric;
  const bool on_contour =
      std::abs(from.aside - to.aside) < kSameContour && from.aside > 0 && from.aside < std::abs(tab.aside);
  if (!opposite || !on_contour || distance(p, tab.center) > reach) return std::nullopt;
  if (!tab.foot.is_arc()) return Edge::line(p, q);
  const bool turns_left = cross(p - tab.foot.center, q - tab.foot.center) > 0;
  return Edge::arc(p, q, tab.foot.center, turns_left ? Turn::kCounterClockwise : Turn::kClockwise);
}

/// Adds the moves over the tab along `over` from the height z; returns the height at which the following entry
/// begins.
double append_crossing(const Tab& tab, const Edge& over, double z, double entry_z, MmPerMin feed,
                       std::vector<Move>& out) {
  const double height = std::max(tab.top_z + kAbove, entry_z);
  if (z != height) out.push_back({Edge::line(over.from, over.from), z, height, MoveKind::kLink, feed, 0});
  out.push_back({over, height, height, MoveKind::kLink, feed, 0});
  return height;
}

/// Index of the first move from `from` on other than a rapid.
std::size_t after_rapids(const std::vector<Move>& moves, std::size_t from) {
  while (from < moves.size() && is_rapid(moves[from].kind)) ++from;
  return from;
}

}  // namespace

void feed_across_tabs(Section& section, const std::vector<Tab>& tabs, double radius, MmPerMin feed) {
  std::vector<Move> moves;
  const std::vector<Move>& old = section.moves;
  for (std::size_t i = 0; i < old.size();) {
    const std::size_t next = after_rapids(old, i);
    if (next == i || i == 0 || next == old.size() || !old[next].is_vertical()) {
      moves.push_back(old[i++]);
      continue;
    }
    Move entry = old[next];
    std::optional<Edge> over;
    const auto tab = std::find_if(tabs.begin(), tabs.end(), [&](const Tab& one) {
      if (one.shape != TabShape::kSquare) return false;
      over = way_over(one, radius, old[i].path.from, entry.path.from);
      return over.has_value();
    });
    if (tab == tabs.end()) {
      moves.insert(moves.end(), old.begin() + static_cast<std::ptrdiff_t>(i),
                   old.begin() + static_cast<std::ptrdiff_t>(next));
    } else {
      entry.z_from = append_crossing(*tab, *over, old[i].z_from, entry.z_to, feed, moves);
    }
    if (entry.z_from != entry.z_to) moves.push_back(entry);
    i = next + 1;
  }
  section.moves = std::move(moves);
}

void rise_over_tabs(Section& section, const std::vector<Tab>& tabs, double radius, MmPerMin plunge_feed) {
  for (const Tab& tab : tabs) {
    if (tab.shape != TabShape::kTriangular) continue;
    const Ridge ridge(tab, radius);
    std::vector<Move> moves;
    for (const Move& move : section.moves) append_raised(move, ridge, plunge_feed, moves);
    section.moves = std::move(moves);
  }
}

}  // namespace clearcut::link
