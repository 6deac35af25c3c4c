#include "plan/zigzag/cells.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/units.h"

namespace clearcut::plan::zigzag {
namespace {

/// mm. Lines are shortened as for a radius smaller by this.
constexpr double kShortening = 0.001;

struct Interval {
  double from = 0;
  double to = 0;
};

/// A piece of the boundary, monotone in x and in y; from `low` to `high`.
struct Piece {
  Vec2 low;
  Vec2 high;
  bool arc = false;
  Vec2 center;
  double radius = 0;
  double side = 0;  ///< side of arcs, 1 or -1: x = center.x + side * sqrt(radius^2 - (y - center.y)^2)

  double x_at(double y) const {
    if (high.y - low.y < 1e-12) return low.x;
    if (!arc) return low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
    const double dy = y - center.y;
    const double x = center.x + side * std::sqrt(std::max(0.0, radius * radius - dy * dy));
    return std::clamp(x, std::min(low.x, high.x), std::max(low.x, high.x));
  }
};

/// Parameters of the horizontal and vertical places of an arc, and of both ends.
std::vector<double> quadrant_cuts(const Edge& edge) {
  std::vector<double> cuts{0};
  const double begin = angle_of(edge.from - edge.center), sweep = edge.sweep();
  const double low = std::min(begin, begin + sweep), high = std::max(begin, begin + sweep);
  for (double quarter = std::ceil(low / (kPi / 2)); quarter * kPi / 2 < high; ++quarter) {
    const double t = (quarter * kPi / 2 - begin) / sweep;
    if (t > 1e-9 && t < 1 - 1e-9) cuts.push_back(t);
  }
  cuts.push_back(1);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

void add_pieces(const Edge& edge, std::vector<Piece>& pieces) {
  const auto add = [&](Vec2 a, Vec2 b, double side) {
    Piece piece{a, b, edge.is_arc(), edge.center, edge.is_arc() ? edge.radius() : 0, side};
    if (piece.low.y > piece.high.y) std::swap(piece.low, piece.high);
    pieces.push_back(piece);
  };
  if (!edge.is_arc()) return add(edge.from, edge.to, 0);
  const auto cuts = quadrant_cuts(edge);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const Vec2 a = i == 1 ? edge.from : edge.at(cuts[i - 1]),
               b = i + 1 == cuts.size() ? edge.to : edge.at(cuts[i]);
    add(a, b, edge.at((cuts[i - 1] + cuts[i]) / 2).x > edge.center.x ? 1 : -1);
  }
}

/// Requirement of one connected part of a strip for its line.
struct Need {
  Interval reach;    ///< x: extent of this part of the region
  double right_end;  ///< x: the line has to extend at least to here
  double left_end;   ///< x: the line has to begin here or farther left
};

class Strips {
 public:
  Strips(const Region& rest, double radius, double widest_step) : radius_(radius - kShortening) {
    for (const auto& edge : rest.edges()) add_pieces(edge, pieces_);
    const Box box = rest.box();
    count_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(box.height() / widest_step - 1e-9)));
    height_ = box.height() / static_cast<double>(count_);
    bottom_ = box.min.y;
    sort_in();
  }

  std::size_t count() const { return count_; }
  double middle(std::size_t strip) const { return bottom_ + (static_cast<double>(strip) + 0.5) * height_; }

  std::vector<Need> needs(std::size_t strip) const {
    std::vector<Interval> reaches = sections(strip, low(strip));
    const auto upper = sections(strip, high(strip));
    reaches.insert(reaches.end(), upper.begin(), upper.end());
    for (const std::size_t i : pieces_in_[strip]) {
      const auto [a, b] = clipped(pieces_[i], strip);
      reaches.push_back({std::min(a.x, b.x), std::max(a.x, b.x)});
    }
    std::vector<Need> needs;
    for (const Interval& reach : merged(std::move(reaches))) needs.push_back({reach, reach.from, reach.to});
    for (const std::size_t i : pieces_in_[strip]) demand(pieces_[i], strip, needs);
    return needs;
  }

 private:
  double low(std::size_t strip) const { return bottom_ + static_cast<double>(strip) * height_; }
  double high(std::size_t strip) const { return low(strip) + height_; }

  void sort_in() {
    pieces_in_.resize(count_);
    const auto strip_of = [&](double y) {
      const double s = height_ > 0 ? (y - bottom_) / height_ : 0;
      return static_cast<std::size_t>(std::clamp(s, 0.0, static_cast<double>(count_ - 1)));
    };
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const std::size_t first = strip_of(pieces_[i].low.y), last = strip_of(pieces_[i].high.y);
      // Pieces ending on the border of two strips belong to both.
      const std::size_t from = first > 0 && pieces_[i].low.y - low(first) < 1e-9 ? first - 1 : first;
      for (std::size_t s = from; s <= last; ++s) pieces_in_[s].push_back(i);
    }
  }

  std::pair<Vec2, Vec2> clipped(const Piece& piece, std::size_t strip) const {
    const double y0 = std::max(piece.low.y, low(strip)), y1 = std::min(piece.high.y, high(strip));
    const Vec2 a = y0 <= piece.low.y ? piece.low : Vec2{piece.x_at(y0), y0};
    const Vec2 b = y1 >= piece.high.y ? piece.high : Vec2{piece.x_at(y1), y1};
    return {a, b};
  }

  /// The x intervals of the horizontal line at y inside the region.
  std::vector<Interval> sections(std::size_t strip, double y) const {
    std::vector<double> crossings;
    for (const std::size_t i : pieces_in_[strip]) {
      const Piece& piece = pieces_[i];
      if ((piece.low.y <= y) != (piece.high.y <= y)) crossings.push_back(piece.x_at(y));
    }
    std::sort(crossings.begin(), crossings.end());
    std::vector<Interval> inside;
    for (std::size_t i = 1; i < crossings.size(); i += 2) inside.push_back({crossings[i - 1], crossings[i]});
    return inside;
  }

  static std::vector<Interval> merged(std::vector<Interval> parts) {
    std::sort(parts.begin(), parts.end(), [](const Interval& a, const Interval& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    });
    std::vector<Interval> whole;
    for (const Interval& part : parts) {
      if (!whole.empty() && part.from <= whole.back().to + 1e-9) {
        whole.back().to = std::max(whole.back().to, part.to);
      } else {
        whole.push_back(part);
      }
    }
    return whole;
  }

  /// Extends the line's ends as far as the piece in the strip needs to be cleared.
  void demand(const Piece& piece, std::size_t strip, std::vector<Need>& needs) const {
    const auto [a, b] = clipped(piece, strip);
    const double middle_x = (a.x + b.x) / 2, y = middle(strip);
    const auto need = std::find_if(needs.begin(), needs.end(),
                                   [&](const Need& n) { return middle_x <= n.reach.to + 1e-9; });
    if (need == needs.end()) return;
    const auto half_chord = [&](Vec2 p) {
      const double dy = p.y - y;
      return std::sqrt(std::max(0.0, radius_ * radius_ - dy * dy));
    };
    const auto place = [&](Vec2 p) {
      need->right_end = std::max(need->right_end, p.x - half_chord(p));
      need->left_end = std::min(need->left_end, p.x + half_chord(p));
    };
    place(a);
    place(b);
    if (!piece.arc || piece.radius >= radius_) return;
    // A disc just contains a small arc if the two centres and the point of contact are on one line.
    const double dy = piece.center.y - y, between = radius_ - piece.radius;
    if (std::abs(dy) > between) return;
    for (const double side : {-1.0, 1.0}) {
      const Vec2 m{piece.center.x + side * std::sqrt(between * between - dy * dy), y};
      const Vec2 u = piece.center - m;
      const Vec2 touch = norm(u) > 1e-12 ? piece.center + unit(u) * piece.radius : piece.center;
      const bool on = touch.y >= std::min(a.y, b.y) && touch.y <= std::max(a.y, b.y) &&
                      touch.x >= std::min(a.x, b.x) && touch.x <= std::max(a.x, b.x);
      if (on) place(touch);
    }
  }

  double radius_;
  std::vector<Piece> pieces_;
  std::size_t count_ = 1;
  double height_ = 0;
  double bottom_ = 0;
  std::vector<std::vector<std::size_t>> pieces_in_;
};

ZigzagLine line_of(const Need& need, double y) {
  // Both ends are satisfied by one point: any between them will do.
  const double middle = std::clamp((need.left_end + need.right_end) / 2, need.reach.from, need.reach.to);
  const bool place = need.right_end <= need.left_end;
  return {{place ? middle : std::max(need.left_end, need.reach.from), y},
          {place ? middle : std::min(need.right_end, need.reach.to), y}};
}

/// The extent of one connected part of a strip, and its cell.
struct Placed {
  Interval reach;
  std::size_t cell = 0;
};

bool touch(const Interval& a, const Interval& b) {
  return a.from <= b.to && b.from <= a.to;
}

}  // namespace

std::vector<ZigzagCell> zigzag_cells(const Region& rest, double radius, double widest_step) {
  const Strips strips(rest, radius, widest_step);
  std::vector<ZigzagCell> cells;
  std::vector<Placed> below;
  for (std::size_t strip = 0; strip < strips.count(); ++strip) {
    const auto needs = strips.needs(strip);
    std::vector<Placed> here;
    for (const Need& need : needs) {
      // A cell continues if exactly one part follows one part.
      std::optional<std::size_t> on;
      int neighbours = 0;
      for (const Placed& placed : below) {
        if (!touch(placed.reach, need.reach)) continue;
        ++neighbours;
        const auto above = std::count_if(needs.begin(), needs.end(),
                                         [&](const Need& other) { return touch(placed.reach, other.reach); });
        if (above == 1) on = placed.cell;
      }
      if (neighbours != 1 || !on) {
        on = cells.size();
        cells.emplace_back();
      }
      cells[*on].lines.push_back(line_of(need, strips.middle(strip)));
      here.push_back({need.reach, *on});
    }
    below = std::move(here);
  }
  return cells;
}

}  // namespace clearcut::plan::zigzag
