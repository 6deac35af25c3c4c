// Tiles the pocket until each tile is cut by one move or out of reach. Polygons are cycles of shared edges: splitting
// an edge splits it for both of its neighbours, so that all inner edges cancel regardless of rounding.
#include "pipeline/witness/find_witness.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>

#include "base/elementary.h"
#include "base/units.h"

// Program and part are read by the same code that will check them, and moves and walls have the checker's numbers.
#define CLEARCUT_CHECK_WITHOUT_MAIN
#include "checker/clearcut_check.cpp"
#undef CLEARCUT_CHECK_WITHOUT_MAIN

namespace clearcut::pipeline {
namespace {

namespace ccw = clearcut_check;
using ccw::Curve;
using ccw::Point;
using ccw::Points;
using ccw::Text;

constexpr double kSpare = 14;       // nm kept off every bound: neighbours insert corners into finished tiles
constexpr double kLegalSpare = 8;   // nm, likewise for places too near to a wall
constexpr double kOnLine = 1.5;     // nm within which a corner counts as on a cutting line
constexpr double kSliver = 4;       // nm; parts that are no wider are not cut off
constexpr int kMostWork = 300'000;  // pieces looked at and cuts of the centers' tiles, in all
constexpr int kMostCompared = 3'000'000;  // pieces with tiles of centers, in all
constexpr int kDeepest = 400;             // successive cuts leading to one tile

/// Why there is no witness.
struct NotFound {
  Text why;
};

struct Spot {
  double x = 0, y = 0;
};
Spot spot(Point p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}
Spot operator-(Spot a, Spot b) {
  return {a.x - b.x, a.y - b.y};
}
Spot operator+(Spot a, Spot b) {
  return {a.x + b.x, a.y + b.y};
}
Spot operator*(double f, Spot a) {
  return {f * a.x, f * a.y};
}
double inner(Spot a, Spot b) {
  return a.x * b.x + a.y * b.y;
}
double length(Spot a) {
  return base::hypot(a.x, a.y);
}
Point rounded(Spot a) {
  return {std::llround(a.x), std::llround(a.y)};
}
Text place(Spot a) {
  return "X" + ccw::mm(std::llround(a.x)) + " Y" + ccw::mm(std::llround(a.y));
}

/// Points whose `normal` . p is above, on or below `offset`; the normal has length 1.
struct Cut {
  Spot normal;
  double offset = 0;
  double side(Point p) const { return inner(normal, spot(p)) - offset; }
};

Spot nearest_on_segment(Spot p, Spot a, Spot b) {
  const Spot d = b - a;
  const double size = inner(d, d);
  const double t = size > 0 ? std::clamp(inner(p - a, d) / size, 0.0, 1.0) : 0;
  return a + t * d;
}

/// The curve's point nearest to p.
Spot nearest_on(const Curve& c, Spot p) {
  if (!c.arc) return nearest_on_segment(p, spot(c.a), spot(c.b));
  const Spot center = spot(c.center), v = p - center;
  const double rho = length(v), radius = 0.5 * (static_cast<double>(c.low) + static_cast<double>(c.high));
  const Point ray = rounded(rho > 0 ? (radius / rho) * v : Spot{radius, 0});
  if (c.sees(ray)) return center + spot(ray);
  return length(p - spot(c.a)) < length(p - spot(c.b)) ? spot(c.a) : spot(c.b);
}
/// Greatest distance of a curve from its middle, with the checker's deduction for its sector.
double spread_of(const Curve& c) {
  return c.arc ? 0.5 * static_cast<double>(c.high - c.low) + 2 * ccw::kEdge + 2 : 0;
}
double distance_to(const Curve& c, Spot p) {
  return length(p - nearest_on(c, p)) + spread_of(c);
}

/// An arc as chords deviating by no more than `sagitta`, from its start to its end.
Points chords(const Curve& c, double sagitta) {
  Points points{c.a};
  if (c.arc) {
    const Spot u = spot(c.a - c.center), v = spot(c.b - c.center);
    double turn = base::atan2(u.x * v.y - u.y * v.x, inner(u, v));
    if (c.clockwise) turn = -turn;
    if (turn <= 0) turn += 2 * kPi;
    const double radius = 0.5 * static_cast<double>(c.low + c.high);
    const int count =
        std::max(1 + static_cast<int>(turn / 2),
                 static_cast<int>(std::ceil(turn / (2 * base::acos(std::max(0.0, 1 - sagitta / radius))))));
    for (int i = 1; i < count; ++i) {
      const double angle = (c.clockwise ? -turn : turn) * i / count, co = base::cos(angle),
                   si = base::sin(angle);
      points.push_back(
          rounded(spot(c.center) + (radius / length(u)) * Spot{co * u.x - si * u.y, si * u.x + co * u.y}));
    }
  }
  points.push_back(c.b);
  return points;
}

/// A shared edge; split ones have two children.
struct Side {
  Point from, to;
  int wall = -1;
  int first = -1, second = -1;
};
struct Half {
  int side = 0;
  bool forward = true;
};
using Polygon = std::vector<Half>;

class Mesh {
 public:
  explicit Mesh(const std::vector<ccw::Wall>& walls) : walls_(walls) {}
  int add(Point from, Point to, int wall = -1) {
    sides_.push_back({from, to, wall});
    return static_cast<int>(sides_.size()) - 1;
  }
  Point start(Half h) const { return h.forward ? at(h).from : at(h).to; }
  Point end(Half h) const { return h.forward ? at(h).to : at(h).from; }

  /// The same polygon with the current splits of every edge, and without edges run forth and back.
  Polygon whole(const Polygon& polygon) const {
    Polygon out;
    for (const Half h : polygon) expand(h, out);
    std::size_t skip = 0;
    while (out.size() >= skip + 2 && cancels(out[skip], out.back())) out.pop_back(), ++skip;
    out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(skip));
    return out;
  }
  Points corners(const Polygon& polygon) const {
    Points out;
    out.reserve(polygon.size());
    for (const Half h : polygon) out.push_back(start(h));
    return out;
  }
  /// Distance of its parts of the boundary from their walls.
  double slack(const Polygon& polygon) const {
    double widest = 0;
    for (const Half h : polygon) {
      const Side& side = at(h);
      if (side.wall < 0) continue;
      const Curve& wall = walls_[static_cast<std::size_t>(side.wall)].curve;
      widest =
          std::max(widest, wall.arc ? static_cast<double>(ccw::slack_of(wall, side.from, side.to)) : 8.0);
    }
    return widest;
  }
  /// Joins a loop, by an edge there and back, to the first edge to the right of its first corner.
  void bridge(Polygon& all, const Polygon& loop);
  /// The parts above and below a line; one of the lists is empty if the polygon is on one side.
  std::pair<std::vector<Polygon>, std::vector<Polygon>> cut(const Polygon& polygon, const Cut& line);

 private:
  const Side& at(Half h) const { return sides_[static_cast<std::size_t>(h.side)]; }
  static bool cancels(Half a, Half b) { return a.side == b.side && a.forward != b.forward; }
  void expand(Half h, Polygon& out) const {
    const Side& side = at(h);
    if (side.first < 0) {
      if (!out.empty() && cancels(out.back(), h)) return out.pop_back();
      return out.push_back(h);
    }
    expand({h.forward ? side.first : side.second, h.forward}, out);
    expand({h.forward ? side.second : side.first, h.forward}, out);
  }
  void split(int index, Point middle) {
    const Side side = sides_[static_cast<std::size_t>(index)];
    const int first = add(side.from, middle, side.wall), second = add(middle, side.to, side.wall);
    sides_[static_cast<std::size_t>(index)].first = first;
    sides_[static_cast<std::size_t>(index)].second = second;
  }
  /// A place on a wall that no other wall has, at most 1 nm from p: beside a sharp corner the crossings of both walls may
  /// be rounded to one place, and the pieces from there to the corner and back would cancel.
  Point own_place(int wall, Point p, const Cut& line) {
    if (wall < 0 || on_walls_.try_emplace(p, wall).first->second == wall) return p;
    Point best = p;
    for (const Point near : {p + Point{1, 0}, p + Point{-1, 0}, p + Point{0, 1}, p + Point{0, -1}}) {
      const auto other = on_walls_.find(near);
      const bool is_free = other == on_walls_.end() || other->second == wall;
      if (is_free && (best == p || std::abs(line.side(near)) < std::abs(line.side(best)))) best = near;
    }
    on_walls_.try_emplace(best, wall);
    return best;
  }
  struct Run {
    Polygon halves;
    int side = 0;
    std::size_t first = 0, last = 0;  // numbers of its ends along the line
  };
  std::vector<Polygon> joined(const std::vector<Run>& runs, int side, const Points& along,
                              std::vector<int>& links);

  const std::vector<ccw::Wall>& walls_;
  std::vector<Side> sides_;
  std::map<Point, int> on_walls_;  // corners made by cuts, with their wall
};

void Mesh::bridge(Polygon& all, const Polygon& loop) {
  const Point from = start(loop[0]);
  double best = std::numeric_limits<double>::infinity();
  int hit = -1;
  for (const Half h : all) {
    const Side& side = at(h);
    if (side.wall < 0 || (side.from.y <= from.y) == (side.to.y <= from.y)) continue;
    const Spot a = spot(side.from), b = spot(side.to);
    const double x = a.x + (static_cast<double>(from.y) - a.y) / (b.y - a.y) * (b.x - a.x);
    if (x > static_cast<double>(from.x) && x < best) best = x, hit = h.side;
  }
  if (hit < 0) throw NotFound{"an island lies outside"};
  const Side side = sides_[static_cast<std::size_t>(hit)];
  const Point to = rounded({best, static_cast<double>(from.y)});
  if (to != side.from && to != side.to) split(hit, to);
  all = whole(all);
  const auto half =
      std::find_if(all.begin(), all.end(), [&](Half h) { return start(h) == to && at(h).wall >= 0; });
  const int link = add(to, from);
  Polygon way{{link, true}};
  way.insert(way.end(), loop.begin(), loop.end());
  way.push_back({link, false});
  all.insert(half, way.begin(), way.end());
}

std::pair<std::vector<Polygon>, std::vector<Polygon>> on_one_side(const Polygon& polygon, bool above) {
  std::pair<std::vector<Polygon>, std::vector<Polygon>> out;
  (above ? out.first : out.second).push_back(polygon);
  return out;
}

std::pair<std::vector<Polygon>, std::vector<Polygon>> Mesh::cut(const Polygon& given, const Cut& line) {
  const auto sign = [&](Point p) {
    const double s = line.side(p);
    return s > kOnLine ? 1 : s < -kOnLine ? -1 : 0;
  };
  bool above = false, below = false;
  for (const Half h : given) {
    const Point a = start(h), b = end(h);
    const int sa = sign(a), sb = sign(b);
    above = above || sa > 0;
    below = below || sa < 0;
    if (sa * sb >= 0) continue;
    const double da = line.side(a), db = line.side(b);
    split(h.side, own_place(at(h).wall, rounded(spot(a) + (da / (da - db)) * (spot(b) - spot(a))), line));
  }
  if (!above || !below) return on_one_side(given, above);
  const Polygon polygon = whole(given);
  std::vector<int> of(polygon.size(), 0);
  std::size_t known = polygon.size();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    // The new corners are on the line by construction, the others are far enough away to be distinguished.
    const int sa = sign(start(polygon[i])), sb = sign(end(polygon[i]));
    of[i] = sa != 0 ? sa : sb;
    if (of[i] != 0 && known == polygon.size()) known = i;
  }
  if (known == polygon.size()) return on_one_side(polygon, true);
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    const std::size_t i = (known + k) % polygon.size();
    if (of[i] == 0) of[i] = of[(i + polygon.size() - 1) % polygon.size()];
  }
  std::size_t turn = polygon.size();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (of[i] != of[(i + polygon.size() - 1) % polygon.size()]) turn = i;
  if (turn == polygon.size()) return on_one_side(polygon, of[0] > 0);
  std::vector<Run> runs;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t i = (turn + k) % polygon.size();
    if (k == 0 || of[i] != runs.back().side) runs.push_back({{}, of[i]});
    runs.back().halves.push_back(polygon[i]);
  }
  const Spot direction{-line.normal.y, line.normal.x};
  Points along;
  for (const Run& run : runs) along.push_back(start(run.halves.front()));
  std::sort(along.begin(), along.end(), [&](Point a, Point b) {
    const double da = inner(direction, spot(a)), db = inner(direction, spot(b));
    return da != db ? da < db : a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  along.erase(std::unique(along.begin(), along.end()), along.end());
  const auto number = [&](Point p) {
    return static_cast<std::size_t>(std::find(along.begin(), along.end(), p) - along.begin());
  };
  for (Run& run : runs)
    run.first = number(start(run.halves.front())), run.last = number(end(run.halves.back()));
  std::vector<int> links(along.size(), -1);
  auto upper = joined(runs, 1, along, links);
  return {std::move(upper), joined(runs, -1, along, links)};
}

/// Closes the runs of one side along the line. Links between neighbouring points of the line are shared by both
/// sides.
std::vector<Polygon> Mesh::joined(const std::vector<Run>& runs, int side, const Points& along,
                                  std::vector<int>& links) {
  struct End {
    std::size_t at;
    bool closes;  // a run ends here
    std::size_t run;
  };
  std::vector<End> ends;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].side != side) continue;
    ends.push_back({runs[i].last, true, i});
    ends.push_back({runs[i].first, false, i});
  }
  std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.at < b.at; });
  std::vector<std::size_t> next(runs.size());
  std::vector<End> open;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    // Of the ends at one point, first the one joining the open run: otherwise an island connected by its bridge would
    // be cut off by itself.
    for (std::size_t k = i; k < ends.size() && ends[k].at == ends[i].at && !open.empty(); ++k) {
      if (ends[k].closes == open.back().closes) continue;
      std::swap(ends[i], ends[k]);
      break;
    }
    const End one = ends[i];
    if (open.empty() || open.back().closes == one.closes) {
      open.push_back(one);
      continue;
    }
    const End other = open.back();
    open.pop_back();
    next[one.closes ? one.run : other.run] = one.closes ? other.run : one.run;
  }
  std::vector<Polygon> out;
  std::vector<bool> done(runs.size(), false);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].side != side || done[i]) continue;
    Polygon polygon;
    for (std::size_t k = i; !done[k]; k = next[k]) {
      done[k] = true;
      polygon.insert(polygon.end(), runs[k].halves.begin(), runs[k].halves.end());
      const std::size_t to = runs[next[k]].first;
      for (std::size_t at = runs[k].last; at != to;) {
        const bool forward = at < to;
        const std::size_t link = forward ? at : at - 1;
        if (links[link] < 0) links[link] = add(along[link], along[link + 1]);
        polygon.push_back({links[link], forward});
        at = forward ? at + 1 : at - 1;
      }
    }
    polygon = whole(polygon);
    if (polygon.size() > 1) out.push_back(std::move(polygon));
  }
  return out;
}

/// Nearest points of two convex hulls: the point of the second, and of the first.
std::pair<Spot, Spot> nearest_between(const Points& a, const Points& b) {
  double best = std::numeric_limits<double>::infinity();
  std::pair<Spot, Spot> out;
  const auto offer = [&](Spot in_a, Spot in_b) {
    const double d = length(in_a - in_b);
    if (d < best) best = d, out = {in_a, in_b};
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      const Spot p = spot(a[i]), q = spot(b[k]);
      offer(p, nearest_on_segment(p, q, spot(b[(k + 1) % b.size()])));
      offer(nearest_on_segment(q, p, spot(a[(i + 1) % a.size()])), q);
    }
  }
  return out;
}

/// A possible cut of a tile: the sufficiently low part of a move.
struct Swath {
  std::size_t move = 0;
  Curve curve;
  double radius = 0;  // radius of its tool
  ccw::Int point = 0;
  ccw::Box box;
};

Swath swath_of(std::size_t move, const Curve& curve, const ccw::Tool& tool) {
  Swath one{move, curve, static_cast<double>(tool.radius), tool.point, ccw::box_of({curve.a, curve.b})};
  if (curve.arc) {
    one.box.add({curve.center.x - curve.high, curve.center.y - curve.high});
    one.box.add({curve.center.x + curve.high, curve.center.y + curve.high});
  }
  one.box = one.box.grown(tool.radius);
  return one;
}

struct Piece {
  Polygon polygon;
  int level = 0;        // nearness of cuts to the bound
  bool beyond = false;  // cut off as out of a move's reach
  int depth = 0;
};
struct Labelled {
  ccw::Int label = 0;
  std::size_t of = 0;
  Polygon polygon;
};

/// Data common to all tilings of a witness.
struct Setting {
  const ccw::Part& part;
  const ccw::Program& program;
  const ccw::Question& asked;
  std::vector<ccw::Tool> tools;
  const ccw::Tool* tool_of(const ccw::Move& move) const {
    for (const ccw::Tool& tool : tools)
      if (tool.number == move.tool) return &tool;
    return nullptr;
  }
  double blend() const { return static_cast<double>(program.blending); }
};

/// Tiles one polygon by the cuts of moves: for a claimed feature, or around a rapid.
class Tiling {
 public:
  /// Tiling of a feature; walls as chords within `sagitta` nm of them.
  Tiling(const Setting& setting, const ccw::Claim& claim, double sagitta);
  /// Tiling around a rapid.
  Tiling(const Setting& setting, std::size_t move);

  /// The tiles with their corners; `centre` is empty if nothing is out of reach.
  struct Tile {
    ccw::Int label = 0;
    std::size_t of = 0;
    Points corners;
  };
  std::vector<Tile> cover() const { return written(cover_, tiles_); }
  std::vector<Tile> centre() const;
  bool any_cut() const {
    return std::any_of(tiles_.begin(), tiles_.end(), [](const Labelled& tile) { return tile.label == 0; });
  }

 private:
  static std::vector<Tile> written(const Mesh& mesh, const std::vector<Labelled>& tiles);
  Polygon region(Mesh& mesh, const std::vector<ccw::Wall>& walls, double sagitta) const;
  std::vector<Swath> swaths(std::size_t before, ccw::Int level) const;
  void settle(const Polygon& whole, const std::vector<Swath>& swaths, ccw::Int level);
  std::optional<Cut> at_stock(const ccw::Box& box) const;
  std::optional<Cut> cut_for(const Points& hull, double beyond, const std::vector<Swath>& near, Piece& piece,
                             bool& out) const;
  bool out_of_reach(const Polygon& polygon, const Points& hull);
  bool trim(std::size_t index, Spot at);
  void replace(std::size_t index, std::vector<Polygon>& above, std::vector<Polygon>& below);
  /// Permitted excess of a tile beyond the radius of its cut, nm.
  double beyond_of(const Polygon& polygon) const {
    return (is_rapid_ ? 0 : static_cast<double>(setting_.asked.uncut) - cover_.slack(polygon)) -
           setting_.blend() - kSpare;
  }

  const Setting& setting_;
  bool is_rapid_;
  std::vector<ccw::Wall> target_, allowed_;
  double radius_, legal_ = 0;
  ccw::Int largest_;  // nm; larger tiles are halved
  Mesh cover_, centre_;
  std::vector<Labelled> tiles_, illegal_;
  int work_ = 0, compared_ = 0;
  struct Maybe {
    Polygon polygon;
    Points hull;
    ccw::Box box;
  };
  std::vector<Maybe> maybe_;
};

/// The outlines as one polygon, islands joined by cancelling bridges; arcs as chords within `sagitta`.
Polygon Tiling::region(Mesh& mesh, const std::vector<ccw::Wall>& walls, double sagitta) const {
  std::vector<Polygon> loops;
  for (std::size_t wall = 0; wall < walls.size(); ++wall) {
    if (wall == 0 || walls[wall].outline != walls[wall - 1].outline) loops.emplace_back();
    const Points points = chords(walls[wall].curve, sagitta);
    for (std::size_t i = 1; i < points.size(); ++i)
      loops.back().push_back({mesh.add(points[i - 1], points[i], static_cast<int>(wall)), true});
  }
  const auto rightmost = [&](const Polygon& loop) {
    std::size_t most = 0;
    for (std::size_t i = 1; i < loop.size(); ++i)
      if (mesh.start(loop[i]).x > mesh.start(loop[most]).x) most = i;
    return most;
  };
  for (std::size_t i = 1; i < loops.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(rightmost(loops[i]));
    std::rotate(loops[i].begin(), loops[i].begin() + at, loops[i].end());
  }
  // From right to left: loops met by a ray to the right of an island are already joined.
  std::sort(loops.begin() + 1, loops.end(),
            [&](const Polygon& a, const Polygon& b) { return mesh.start(a[0]).x > mesh.start(b[0]).x; });
  Polygon all = loops[0];
  for (std::size_t i = 1; i < loops.size(); ++i) mesh.bridge(all, loops[i]);
  return all;
}

/// Swaths of feed moves before a move, no higher than `level`.
std::vector<Swath> Tiling::swaths(std::size_t before, ccw::Int level) const {
  std::vector<Swath> out;
  for (std::size_t i = 0; i < before; ++i) {
    const ccw::Move& move = setting_.program.moves[i];
    const ccw::Tool* tool = setting_.tool_of(move);
    const ccw::Int point = tool && is_rapid_ ? tool->point : 0;
    if (move.rapid || !tool || move.lowest() + point > level) continue;
    const Curve curve = ccw::low_part(move, point, level);
    out.push_back(swath_of(i, curve, *tool));
    out.back().point = point;
  }
  return out;
}

/// Whether a cut leaves more than a sliver on both sides. Cutting slivers off would not end: their corners get into the
/// neighbours' edges, off the line by their rounding.
bool divides(const Cut& line, const Points& hull) {
  double low = 0, high = 0;
  for (const Point p : hull) low = std::min(low, line.side(p)), high = std::max(high, line.side(p));
  return low < -kSliver && high > kSliver;
}

Cut halving(const ccw::Box& box) {
  const bool wide = box.x1 - box.x0 > box.y1 - box.y0;
  return wide ? Cut{{1, 0}, 0.5 * static_cast<double>(box.x0 + box.x1)}
              : Cut{{0, 1}, 0.5 * static_cast<double>(box.y0 + box.y1)};
}

/// A cut along a side of the stock through a tile of a rapid: there is no material outside.
std::optional<Cut> Tiling::at_stock(const ccw::Box& box) const {
  if (!is_rapid_ || !setting_.part.stock) return std::nullopt;
  const ccw::Box& stock = *setting_.part.stock;
  const ccw::Int off = 3;
  for (const auto& [at, low, high, normal] : {std::tuple{stock.x0 - off, box.x0, box.x1, Spot{1, 0}},
                                              {stock.x1 + off, box.x0, box.x1, Spot{1, 0}},
                                              {stock.y0 - off, box.y0, box.y1, Spot{0, 1}},
                                              {stock.y1 + off, box.y0, box.y1, Spot{0, 1}}}) {
    if (low + off < at && at + off < high) return Cut{normal, static_cast<double>(at)};
  }
  return std::nullopt;
}

void Tiling::settle(const Polygon& whole, const std::vector<Swath>& swaths, ccw::Int level) {
  std::vector<Piece> todo{{whole}};
  while (!todo.empty()) {
    Piece piece = std::move(todo.back());
    todo.pop_back();
    piece.polygon = cover_.whole(piece.polygon);
    if (piece.polygon.size() < 2) continue;
    const Points hull = ccw::hull_of(cover_.corners(piece.polygon));
    if (++work_ > kMostWork || piece.depth > kDeepest)
      throw NotFound{"no tiling was found near " + place(spot(hull[0]))};
    const ccw::Box box = box_of(hull);
    if (is_rapid_ && setting_.part.stock && !setting_.part.stock->meets(box)) {
      tiles_.push_back({2, 0, piece.polygon});
      continue;
    }
    std::optional<Cut> cut = at_stock(box);
    bool beyond = false;
    if (!cut && std::max(box.x1 - box.x0, box.y1 - box.y0) > largest_) cut = halving(box);
    if (!cut) {
      const double bound = beyond_of(piece.polygon);
      std::vector<Swath> near;
      for (const Swath& one : swaths)
        if (one.box.meets(box.grown(std::max<ccw::Wide>(0, ccw::Wide(bound) + 1)))) near.push_back(one);
      bool done = false;
      if (piece.beyond && !is_rapid_ && out_of_reach(piece.polygon, hull)) {
        tiles_.push_back({1, 0, piece.polygon});
        continue;
      }
      if (piece.beyond) piece.beyond = false, ++piece.level;
      for (const Swath& one : near) {
        if (!ccw::cut_by(setting_.program.moves[one.move], one.point, hull, ccw::Wide(one.radius + bound),
                         level))
          continue;
        tiles_.push_back({0, one.move, piece.polygon});
        done = true;
        break;
      }
      if (done) continue;
      cut = cut_for(hull, bound, near, piece, beyond);
    }
    std::pair<std::vector<Polygon>, std::vector<Polygon>> parts;
    if (cut && divides(*cut, hull)) parts = cover_.cut(piece.polygon, *cut);
    if (parts.first.empty() || parts.second.empty()) {
      if (!is_rapid_ && out_of_reach(piece.polygon, hull)) {
        tiles_.push_back({1, 0, piece.polygon});
        continue;
      }
      beyond = false;
      parts = cover_.cut(piece.polygon, halving(box));
      const bool tiny = std::max(box.x1 - box.x0, box.y1 - box.y0) < 50;
      if (tiny || parts.first.empty() || parts.second.empty())
        throw NotFound{"a place seems to be left near " + place(spot(hull[0]))};
    }
    auto& [above, below] = parts;
    for (Polygon& one : above) todo.push_back({std::move(one), piece.level, beyond, piece.depth + 1});
    for (Polygon& one : below) todo.push_back({std::move(one), piece.level, false, piece.depth + 1});
  }
}

/// A cut along the edge of the swath that contains most of the tile, towards the corner outside. `beyond` is the
/// excess of the radius.
std::optional<Cut> Tiling::cut_for(const Points& hull, double beyond, const std::vector<Swath>& near,
                                   Piece& piece, bool& out) const {
  const Swath* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  Spot corner;
  for (const Swath& one : near) {
    double most = -std::numeric_limits<double>::infinity(), fewest = -most;
    Spot at;
    for (const Point p : hull) {
      const double d = distance_to(one.curve, spot(p)) - one.radius;
      if (d > most) most = d, at = spot(p);
      fewest = std::min(fewest, d);
    }
    if (fewest < beyond && most < least) least = most, best = &one, corner = at;
  }
  if (!best) return std::nullopt;
  const Curve& c = best->curve;
  if (least <=
      beyond) {  // all corners are near, but the tile is not in one sector, or it surrounds an inner circle
    for (const Point ray : {c.first, c.last}) {
      if (c.full()) break;
      const Spot r = spot(ray), n{-r.y / length(r), r.x / length(r)};
      const Cut line{n, inner(n, spot(c.center))};
      double low = 0, high = 0;
      for (const Point p : hull) low = std::min(low, line.side(p)), high = std::max(high, line.side(p));
      if (low < -4 && high > 4) return line;
    }
    Spot middle;
    for (const Point p : hull) middle = middle + (1.0 / static_cast<double>(hull.size())) * spot(p);
    const Spot v = middle - spot(c.center);
    if (length(v) < 1) return std::nullopt;
    const Spot n{-v.y / length(v), v.x / length(v)};
    return Cut{n, inner(n, middle)};  // a narrower part of the ring
  }
  const double radius = best->radius, bound = radius + beyond, blend = setting_.blend();
  const double far = least + radius;
  const Spot foot = nearest_on(c, corner);
  const Spot n = (1 / length(corner - foot)) * (corner - foot);
  double at = -1;
  for (const Swath& one : near) {  // the middle of the part shared with a move that cuts the corner
    if (&one == best || distance_to(one.curve, corner) > one.radius - blend) continue;
    double start = far;
    for (int i = 1; i <= 24; ++i) {
      const double s = far * (24 - i) / 24;
      if (distance_to(one.curve, foot + s * n) > one.radius - blend) break;
      start = s;
    }
    if (start < bound - 100) at = std::max(at, 0.5 * (std::max(start, 0.0) + std::min(bound, radius)));
  }
  out = at < 0 && !is_rapid_;
  if (at < 0) {
    constexpr std::array kShares{0.4, 0.75, 0.93};
    if (piece.level >= static_cast<int>(kShares.size()) * 8)
      throw NotFound{"a place seems to be left near " + place(corner)};
    const double share = kShares[std::min(static_cast<std::size_t>(piece.level), kShares.size() - 1)];
    at = is_rapid_ ? bound - 50 : radius + share * beyond;
  }
  return Cut{n, inner(n, foot) + std::min(at, bound - 20) - spread_of(c)};
}

/// Whether no legal center is near; cuts off illegal parts of the centers' tiles as far as needed.
bool Tiling::out_of_reach(const Polygon& polygon, const Points& hull) {
  const double reach = radius_ + cover_.slack(polygon) + kSpare;
  const ccw::Box box = box_of(hull).grown(ccw::Wide(reach));
  int trims = 0;
  for (std::size_t i = 0; i < maybe_.size();) {
    if (!maybe_[i].box.meets(box)) {
      ++i;
      continue;
    }
    if (++compared_ > kMostCompared) throw NotFound{"no tiling was found near " + place(spot(hull[0]))};
    if (ccw::apart(hull, maybe_[i].hull, ccw::Wide(reach))) {
      ++i;
      continue;
    }
    auto [mine, at] = nearest_between(hull, maybe_[i].hull);
    // One inside of the other, or both on one wall.
    if (const double far = length(mine - at); far < 2 || far >= reach) {
      at = {};
      for (const Point p : hull) at = at + (1.0 / static_cast<double>(hull.size())) * spot(p);
    }
    if (++trims > 2000 || ++work_ > kMostWork || !trim(i, at)) return false;
  }
  return true;
}

/// Cuts the illegal area near `at` off a tile of the centers; the tile is replaced by its parts. False if nothing is
/// illegal there.
bool Tiling::trim(std::size_t index, Spot at) {
  const Polygon polygon = centre_.whole(maybe_[index].polygon);
  const Points hull = ccw::hull_of(centre_.corners(polygon));
  const ccw::Box box = box_of(hull);
  if (std::max(box.x1 - box.x0, box.y1 - box.y0) > largest_) {
    auto [above, below] = centre_.cut(polygon, halving(box));
    return replace(index, above, below), true;
  }
  const double bound = legal_ - 1 - kLegalSpare;
  std::size_t wall = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t w = 0; w < allowed_.size(); ++w) {
    const double d = distance_to(allowed_[w].curve, at);
    if (d < bound && ccw::near_curve(allowed_[w].curve, hull, ccw::Wide(bound))) {
      illegal_.push_back({0, w, polygon});
      maybe_.erase(maybe_.begin() + static_cast<std::ptrdiff_t>(index));
      return true;
    }
    if (d < least) least = d, wall = w;
  }
  if (least < 2) {  // on a wall, without a direction leading away: a little inwards
    Spot middle;
    for (const Point p : hull) middle = middle + (1.0 / static_cast<double>(hull.size())) * spot(p);
    const double far = length(middle - at);
    if (far > 10) at = at + (std::min(1000.0, 0.5 * far) / far) * (middle - at);
    least = std::numeric_limits<double>::infinity();
    for (std::size_t w = 0; w < allowed_.size(); ++w) {
      const double d = distance_to(allowed_[w].curve, at);
      if (d < least) least = d, wall = w;
    }
  }
  const bool tiny = std::max(box.x1 - box.x0, box.y1 - box.y0) < 12;
  if (least > bound - 4 || tiny) return false;
  const Curve& c = allowed_[wall].curve;
  const Spot foot = nearest_on(c, at);
  Cut line{{}, 0};
  bool round = !c.arc && (length(foot - spot(c.a)) < 1 || length(foot - spot(c.b)) < 1);
  Spot center = foot;
  double disc = bound;
  if (c.arc) {
    center = spot(c.center);
    const bool outside = length(at - center) > static_cast<double>(c.high);
    round = outside || !c.sees(rounded(at - center));
    if (outside) disc = static_cast<double>(c.low) + bound - 2 * ccw::kEdge;
    if (!c.sees(rounded(at - center))) center = foot, disc = bound;
  }
  if (!round) {
    const Spot n = least > 1 ? (1 / least) * (at - foot)
                             : (1 / length(spot(c.b) - spot(c.a))) *
                                   Spot{spot(c.a).y - spot(c.b).y, spot(c.b).x - spot(c.a).x};
    line = {n, inner(n, foot) + bound - (c.arc ? 2 * ccw::kEdge : 0)};
    if (c.arc && static_cast<double>(c.high) - bound < 0)
      round = true, center = spot(c.center), disc = static_cast<double>(c.low) + bound;
  }
  std::vector<Polygon> parts;
  if (round) {  // a wedge, then its chord: legal is outside of a disc
    const Spot v = at - center;
    if (length(v) < 1) return false;
    const Spot n = (1 / length(v)) * v, across{-n.y, n.x};
    const double depth = std::max(6.0, 0.25 * (disc - length(v)));
    const double half = std::sqrt(2 * disc * depth);
    double widest = 0;
    int side = 0;
    for (const Point p : hull) {
      const double a = inner(across, spot(p) - center);
      if (std::abs(a) > widest && inner(n, spot(p) - center) > 0) widest = std::abs(a), side = a > 0 ? 1 : -1;
    }
    line = widest > half + 10 ? Cut{across, inner(across, center) + side * half}
                              : Cut{n, inner(n, center) + disc - 1.05 * depth};
  }
  auto [above, below] = centre_.cut(polygon, line);
  if (above.empty() || below.empty()) {
    std::tie(above, below) = centre_.cut(polygon, halving(box));
    if (above.empty() || below.empty()) return false;
  }
  replace(index, above, below);
  return true;
}

/// Puts two parts in the place of a tile of the centers.
void Tiling::replace(std::size_t index, std::vector<Polygon>& above, std::vector<Polygon>& below) {
  maybe_.erase(maybe_.begin() + static_cast<std::ptrdiff_t>(index));
  for (auto* list : {&above, &below}) {
    for (Polygon& one : *list) {
      Points own = ccw::hull_of(centre_.corners(one));
      const ccw::Box own_box = box_of(own);
      maybe_.insert(maybe_.begin() + static_cast<std::ptrdiff_t>(index),
                    {std::move(one), std::move(own), own_box});
    }
  }
}

Tiling::Tiling(const Setting& setting, const ccw::Claim& claim, double sagitta)
    : setting_(setting),
      is_rapid_(false),
      target_(setting.part.features[claim.feature].target.walls),
      allowed_(setting.part.features[claim.feature].allowed.walls),
      radius_(static_cast<double>(claim.radius)),
      legal_(radius_ + static_cast<double>(claim.wall_stock + setting.asked.beyond)),
      largest_(3 * claim.radius),
      cover_(target_),
      centre_(allowed_) {
  const Polygon whole = region(centre_, allowed_, std::min(20'000.0, radius_ / 10));
  const Points hull = ccw::hull_of(centre_.corners(whole));
  maybe_.push_back({whole, hull, box_of(hull)});
  const ccw::Int floor = setting.part.features[claim.feature].floor + claim.floor_stock +
                         setting.asked.level - setting.program.lift;
  settle(region(cover_, target_, sagitta), swaths(setting.program.moves.size(), floor), floor);
}

/// A polygon around the area that must be cut for the rapid.
Tiling::Tiling(const Setting& setting, std::size_t index)
    : setting_(setting), is_rapid_(true), radius_(0), largest_(0), cover_(target_), centre_(allowed_) {
  const ccw::Move& move = setting.program.moves[index];
  const ccw::Int radius = setting.tool_of(move)->radius;
  radius_ = static_cast<double>(radius);
  largest_ = 3 * radius;
  const double inner_radius = radius_ - static_cast<double>(setting.asked.rapid) + setting.blend() + 10,
               outer = radius_ - setting.blend() - 2 * kSpare;
  if (outer <= inner_radius) throw NotFound{"the rim of rapids is too narrow for the blending"};
  const int count = 4 + static_cast<int>(std::ceil(
                            kPi / base::acos(inner_radius / (inner_radius + 0.5 * (outer - inner_radius)))));
  const double size = inner_radius / base::cos(kPi / count);
  const Spot a = spot(move.path.a), b = spot(move.path.b);
  Points points;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * kPi * (k + 0.5) / count;
    for (const Spot end :
         setting.program.dogleg ? std::vector{a, b, Spot{a.x, b.y}, Spot{b.x, a.y}} : std::vector{a, b})
      points.push_back(rounded(end + size * Spot{base::cos(angle), base::sin(angle)}));
  }
  points = ccw::hull_of(points);
  Polygon polygon;
  for (std::size_t k = 0; k < points.size(); ++k)
    polygon.push_back({cover_.add(points[k], points[(k + 1) % points.size()]), true});
  const ccw::Int level = move.lowest() - 2 * setting.program.lift;
  try {
    settle(polygon, swaths(index, level), level);
  } catch (const NotFound& at) {
    Text why = at.why;
    if (setting.program.lift > 0 && swaths(index, move.lowest()).size() > swaths(index, level).size())
      why += "; feeds as low as the rapid do not count, because the control may keep either of them " +
             ccw::mm(setting.program.lift) + " mm off its height";
    throw NotFound{"the rapid of line " + std::to_string(move.line) + ": " + why};
  }
}

std::vector<Tiling::Tile> Tiling::written(const Mesh& mesh, const std::vector<Labelled>& tiles) {
  std::vector<Tile> out;
  for (const Labelled& tile : tiles) {
    const Polygon polygon = mesh.whole(tile.polygon);
    if (!polygon.empty()) out.push_back({tile.label, tile.of, mesh.corners(polygon)});
  }
  return out;
}

std::vector<Tiling::Tile> Tiling::centre() const {
  const bool needed =
      std::any_of(tiles_.begin(), tiles_.end(), [](const Labelled& tile) { return tile.label == 1; });
  std::vector<Labelled> all = needed ? illegal_ : std::vector<Labelled>{};
  for (const Maybe& tile : maybe_)
    if (needed) all.push_back({1, 0, tile.polygon});
  return written(centre_, all);
}

/// Divides level feeds into pieces, and finds directions in which their rims are in earlier cuts. Directions are tenths of a degree.
class RimFinder {
 public:
  explicit RimFinder(const Setting& setting)
      : setting_(setting), rim_(setting.part, setting.program, setting.tools) {
    for (int k = 0; k < 3600; ++k) {
      const double angle = 2 * kPi * k / 3600;
      directions_.push_back({base::cos(angle), base::sin(angle)});
    }
  }
  /// Moves that are engaged in full, or nearly, have none.
  std::vector<ccw::RimMove> all() {
    std::vector<ccw::RimMove> out;
    for (std::size_t i = 0; i < setting_.program.moves.size() && work_ < kMostRims; ++i) {
      if (!rim_.concerns(setting_.program.moves[i])) continue;
      ccw::RimMove one{i, pieces(i)};
      if (!one.pieces.empty()) out.push_back(std::move(one));
    }
    return out;
  }

 private:
  static constexpr int kMostRims = 200'000;  // rims looked at, in all
  static constexpr int kSlot = 1750;         // engagement above which nothing is claimed
  static constexpr int kSpareTicks =
      8;                              // by how much a piece may exceed the engagement at places of its move
  static constexpr int kCoarse = 20;  // between directions looked at first
  struct Cuts {
    std::vector<Swath> swaths;
    ccw::Grid grid;
  };
  struct Interval {
    int from, to;
    std::size_t by;
  };
  struct Move {
    std::size_t index = 0;
    const Cuts* cuts = nullptr;
    Points steps;
    int least = 0;  // the greatest engagement at places of it
    std::vector<ccw::RimPiece> pieces;
  };

  const Cuts& cuts_at(ccw::Int z) {
    const auto [at, is_new] = cuts_.try_emplace(z);
    if (!is_new) return at->second;
    std::vector<ccw::Box> boxes;
    for (std::size_t k = 0; k < setting_.program.moves.size(); ++k) {
      const ccw::Move& move = setting_.program.moves[k];
      const ccw::Tool* tool = setting_.tool_of(move);
      if (move.rapid || !tool || move.lowest() + tool->point > z) continue;
      Swath one = swath_of(k, ccw::low_part(move, tool->point, z), *tool);
      boxes.push_back(one.box);
      at->second.swaths.push_back(one);
    }
    at->second.grid = ccw::Grid(std::move(boxes));
    return at->second;
  }
  std::vector<ccw::RimPiece> pieces(std::size_t index) {
    const ccw::Move& move = setting_.program.moves[index];
    Move one{index, &cuts_at(move.z0), ccw::steps_of(move.path), 0, {}};
    const std::size_t last = one.steps.size() - 1;
    for (const std::size_t at : {std::size_t{0}, last / 2, last}) look(one, at);
    if (one.least >= kSlot) return {};
    divide(one, 0, last);
    return one.least >= kSlot ? std::vector<ccw::RimPiece>{} : one.pieces;
  }
  void look(Move& one, std::size_t at) {
    const auto [first, size] = window(one, at, at);
    int covered = 0, end = first;
    for (const Interval& free : intervals(one, at, at, first, size)) {
      covered += std::max(0, free.to - std::max(end, free.from));
      end = std::max(end, free.to);
    }
    one.least = std::max(one.least, size - covered);
  }
  void divide(Move& one, std::size_t a, std::size_t b) {
    if (turns_far(one, a, b)) return halves(one, a, b);
    const auto [first, size] = window(one, a, b);
    std::vector<ccw::FreeSector> sectors;
    int covered = 0, at = first;
    const std::vector<Interval> found = intervals(one, a, b, first, size);
    for (std::size_t k = 0; k < found.size();) {  // of those that begin before, the one that ends last
      std::size_t best = k;
      for (at = std::max(at, found[k].from); k < found.size() && found[k].from <= at; ++k)
        if (found[k].to > found[best].to) best = k;
      if (found[best].to <= at) continue;
      covered += add(one, a, b, {at, found[best].to, found[best].by}, sectors);
      at = found[best].to;
    }
    if (size - covered > one.least + kSpareTicks && b > a + 1) {
      look(one, (a + b) / 2);
      if (one.least >= kSlot) return;
      if (size - covered > one.least + kSpareTicks) return halves(one, a, b);
    }
    one.pieces.push_back({static_cast<ccw::Int>(b - a), std::move(sectors)});
  }
  void halves(Move& one, std::size_t a, std::size_t b) {
    divide(one, a, (a + b) / 2);
    divide(one, (a + b) / 2, b);
  }
  /// Adds the interval as sectors that the checker accepts; their size.
  int add(const Move& one, std::size_t a, std::size_t b, Interval free,
          std::vector<ccw::FreeSector>& sectors) {
    const int size = free.to - free.from;
    const ccw::FreeSector sector{(free.from + 7200) % 3600, size, free.by};
    if (rim_.is_free(one.index, one.steps[a], one.steps[b], sector)) return sectors.push_back(sector), size;
    if (size < 2) return 0;
    const int middle = free.from + size / 2;
    const int before = add(one, a, b, {free.from, middle, free.by}, sectors);
    return before + add(one, a, b, {middle, free.to, free.by}, sectors);
  }
  const Curve& path_of(const Move& one) const { return setting_.program.moves[one.index].path; }
  bool turns_far(const Move& one, std::size_t a, std::size_t b) const {
    const Curve& path = path_of(one);
    for (std::size_t k = a + 1; k <= b && path.arc; ++k) {
      const Point u = one.steps[a] - path.center, v = one.steps[k] - path.center;
      if (dot(u, v) <= 0 || (cross(u, v) > 0) == path.clockwise) return true;
    }
    return false;
  }
  /// The directions in front of the cutter between two places, in tenths of a degree: the first one and their number.
  std::pair<int, int> window(const Move& one, std::size_t a, std::size_t b) const {
    const Curve& path = path_of(one);
    Point u = path.b - path.a, v = u;
    if (path.arc) {
      u = (one.steps[a] - path.center).left(), v = (one.steps[b] - path.center).left();
      if (path.clockwise) u = Point{} - u, v = Point{} - v, std::swap(u, v);
    }
    const int first = static_cast<int>(rim_.tick_of(u)), last = static_cast<int>(rim_.tick_of(v));
    return {first - 900, 1801 + (last - first + 3600) % 3600};
  }
  /// Directions in which the rim is free from place a to b, one move each, by their beginnings.
  std::vector<Interval> intervals(const Move& one, std::size_t a, std::size_t b, int first, int size) {
    ++work_;
    const ccw::Tool& tool = *setting_.tool_of(setting_.program.moves[one.index]);
    const double blend = setting_.blend(), radius = static_cast<double>(tool.radius) - 1000 - 2 * blend;
    const Points ends = a == b ? Points{one.steps[a]} : Points{one.steps[a], one.steps[b]};
    const Curve& path = path_of(one);
    const double bend = path.arc ? static_cast<double>(ccw::chord_error(path, one.steps[a] - path.center,
                                                                        one.steps[b] - path.center))
                                 : 1;
    const double off = bend + 2 * blend + 13;
    std::vector<Interval> out;
    const auto offer = [&](std::size_t by, const auto& is_free) {
      const auto every = [&](int k) {
        const Spot v = radius * directions_[static_cast<std::size_t>((k + 7200) % 3600)];
        return std::all_of(ends.begin(), ends.end(), [&](Point p) { return is_free(spot(p) + v); });
      };
      bool was = false;
      for (int k = first, last = first;; last = k, k = std::min(k + kCoarse, first + size)) {
        const bool is = every(k);
        int low = last, high = k;  // the change lies between them
        while (is != was && high - low > 1) {
          const int middle = (low + high) / 2;
          (every(middle) == is ? high : low) = middle;
        }
        if (is && !was) out.push_back({high, high, by});
        if (was) out.back().to = is ? k : low;
        was = is;
        if (k == first + size) break;
      }
    };
    const ccw::Box box = ccw::box_of(ends).grown(tool.radius);
    std::set<std::size_t> near;
    one.cuts->grid.visit_all(box, [&](std::size_t k) {
      if (one.cuts->swaths[k].move < one.index) near.insert(k);
      return true;
    });
    for (const std::size_t k : near) {
      const Swath& swath = one.cuts->swaths[k];
      const double bound = swath.radius - off;
      offer(swath.move, [&](Spot p) { return distance_to(swath.curve, p) <= bound; });
    }
    if (const auto& stock = setting_.part.stock;
        stock && !(stock->x0 <= box.x0 && box.x1 <= stock->x1 && stock->y0 <= box.y0 && box.y1 <= stock->y1))
      offer(one.index, [&](Spot p) {
        return p.x + off < static_cast<double>(stock->x0) || p.x - off > static_cast<double>(stock->x1) ||
               p.y + off < static_cast<double>(stock->y0) || p.y - off > static_cast<double>(stock->y1);
      });
    std::erase_if(out, [](const Interval& i) { return i.to <= i.from; });
    std::sort(out.begin(), out.end(), [](const Interval& i, const Interval& k) { return i.from < k.from; });
    return out;
  }

  const Setting& setting_;
  ccw::Rim rim_;
  std::vector<Spot> directions_;
  std::map<ccw::Int, Cuts> cuts_;
  int work_ = 0;
};

/// Counts of any width, which differs between machines, and the checker's integers.
template <typename Number>
void put_number(Text& out, Number number) {
  auto value = static_cast<std::uint64_t>(number);
  for (; value >= 128; value >>= 7) out += static_cast<char>(value | 128);
  out += static_cast<char>(value);
}
void put_signed(Text& out, ccw::Int value) {
  put_number(out, value < 0 ? static_cast<std::uint64_t>(-(value + 1)) * 2 + 1
                            : static_cast<std::uint64_t>(value) * 2);
}

/// Tilings with their data for the file.
struct Claimed {
  ccw::Claim claim;
  std::vector<Tiling::Tile> cover, centre;
};
struct Travelled {
  std::size_t move;
  std::vector<Tiling::Tile> tiles;
};

/// The witness's bytes after the hashes.
class WitnessWriter {
 public:
  WitnessWriter(const std::vector<ccw::Tool>& tools, const std::vector<Claimed>& claims,
                const std::vector<Travelled>& rapids, const std::vector<ccw::RimMove>& rims) {
    for (const Claimed& one : claims) collect(one.cover), collect(one.centre);
    for (const Travelled& one : rapids) collect(one.tiles);
    put_number(out_, tools.size());
    for (const ccw::Tool& tool : tools)
      for (const ccw::Int one : {tool.number, tool.radius, tool.point}) put_number(out_, one);
    put_vertices();
    put_number(out_, claims.size());
    for (const Claimed& one : claims) {
      put_number(out_, one.claim.feature);
      for (const ccw::Int length : {one.claim.radius, one.claim.wall_stock, one.claim.floor_stock})
        put_number(out_, length);
      put_tiles(one.cover);
      put_tiles(one.centre);
    }
    put_number(out_, rapids.size());
    for (const Travelled& one : rapids) {
      put_number(out_, one.move);
      put_tiles(one.tiles);
    }
    put_number(out_, rims.size());
    for (const ccw::RimMove& rim : rims) {
      put_number(out_, rim.move);
      put_number(out_, rim.pieces.size());
      for (const ccw::RimPiece& piece : rim.pieces) {
        put_number(out_, piece.steps);
        put_number(out_, piece.sectors.size());
        for (const ccw::FreeSector& sector : piece.sectors) {
          put_number(out_, sector.from), put_number(out_, sector.size);
          put_number(out_, rim.move - sector.by);
        }
      }
    }
  }
  const Text& bytes() const { return out_; }

 private:
  void collect(const std::vector<Tiling::Tile>& tiles) {
    for (const Tiling::Tile& tile : tiles)
      for (const Point p : tile.corners) numbers_[p] = 0;
  }
  void put_vertices() {
    put_number(out_, numbers_.size());
    Point last{-ccw::kLargest, -ccw::kLargest};
    ccw::Int count = 0;
    for (auto& [p, number] : numbers_) {
      number = count++;
      put_number(out_, p.x - last.x);
      if (p.x > last.x) {
        put_signed(out_, p.y - last.y);
      } else {
        put_number(out_, p.y - last.y - 1);
      }
      last = p;
    }
  }
  void put_tiles(const std::vector<Tiling::Tile>& tiles) {
    put_number(out_, tiles.size());
    ccw::Int of = 0, index = 0;
    for (const Tiling::Tile& tile : tiles) {
      put_number(out_, tile.label);
      if (tile.label == 0)
        put_signed(out_, static_cast<ccw::Int>(tile.of) - of), of = static_cast<ccw::Int>(tile.of);
      put_number(out_, tile.corners.size());
      for (const Point p : tile.corners) put_signed(out_, numbers_.at(p) - index), index = numbers_.at(p);
    }
  }
  std::map<Point, ccw::Int> numbers_;
  Text out_;
};

ccw::Int to_nm(double mm) {
  return std::llround(mm * 1e6);
}

/// The tools by the program's numbers; the tool in the spindle before any call has number 0.
std::vector<ccw::Tool> tools_of(const ccw::Program& program, const WitnessQuestion& question) {
  std::vector<ccw::Tool> tools;
  const auto offer = [&](ccw::Int number, int called) {
    for (const WitnessTool& tool : question.tools)
      if (tool.number == called)
        return tools.push_back({number, to_nm(tool.diameter / 2), to_nm(tool.point)});
  };
  std::set<ccw::Int> numbers;
  for (const ccw::Move& move : program.moves) numbers.insert(move.tool);
  for (const ccw::Int number : numbers)
    offer(number, number == 0 ? question.first_tool : static_cast<int>(number));
  return tools;
}

/// The plan's data of feature number `index` of the file.
const WitnessFeature& planned(const WitnessQuestion& question, const ccw::Part& part, std::size_t index) {
  const auto& all = question.features;
  if (all.size() == part.features.size()) return all[index];
  const auto same = [&](const WitnessFeature& one) { return one.name == part.features[index].name; };
  const auto found = std::find_if(all.begin(), all.end(), same);
  if (found == all.end()) throw NotFound{"the plan has no feature of that name"};
  return *found;
}

/// Chords along bulged walls take their sagitta from what may be left there. Where that is too much, shorter ones take less.
Tiling tiling_of(const Setting& setting, const ccw::Claim& claim) {
  constexpr double kSagitta = 1.0 / 12, kFineSagitta = 1.0 / 100;
  const double uncut = static_cast<double>(setting.asked.uncut);
  const auto& walls = setting.part.features[claim.feature].target.walls;
  const bool bulged =
      std::any_of(walls.begin(), walls.end(), [](const ccw::Wall& wall) { return wall.curve.arc; });
  if (!bulged) return {setting, claim, kSagitta * uncut};
  try {
    return {setting, claim, kSagitta * uncut};
  } catch (const NotFound&) {
    return {setting, claim, kFineSagitta * uncut};
  }
}

Claimed claimed(const Setting& setting, const WitnessQuestion& question, std::size_t index) {
  const ccw::Feature& feature = setting.part.features[index];
  const WitnessFeature& asked = planned(question, setting.part, index);
  if (!asked.why_not.empty()) throw NotFound{asked.why_not};
  if (!feature.why_not.empty()) throw NotFound{feature.why_not};
  if (feature.floor != to_nm(asked.floor))
    throw NotFound{
        "the part's file has other heights than what was planned; write the part as it is with clearcut "
        "convert"};
  ccw::Claim claim;
  claim.feature = index;
  claim.radius = to_nm(asked.diameter / 2);
  claim.wall_stock = to_nm(asked.wall_stock);
  claim.floor_stock = to_nm(asked.floor_stock);
  const Tiling tiling = tiling_of(setting, claim);
  if (!tiling.any_cut()) throw NotFound{"the cutter reaches nothing of it down to its floor"};
  return {claim, tiling.cover(), tiling.centre()};
}

void find(const Setting& setting, const WitnessQuestion& question, std::vector<Claimed>& claims,
          std::vector<Travelled>& rapids, std::vector<Text>& missing) {
  const ccw::Part& part = setting.part;
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    try {
      claims.push_back(claimed(setting, question, i));
    } catch (const NotFound& reason) {
      missing.push_back((part.features[i].name.empty() ? "the pocket" : part.features[i].name) + ": " +
                        reason.why);
    }
  }
  for (std::size_t i = 0; i < setting.program.moves.size(); ++i) {
    const ccw::Move& move = setting.program.moves[i];
    if (!move.rapid || !setting.tool_of(move) || move.lowest() >= part.top || move.only_rises()) continue;
    rapids.push_back({i, Tiling(setting, i).cover()});
  }
}

}  // namespace

FoundWitness find_witness(const std::string& program_text, const std::string& program_name,
                          const std::string& part_text, const std::string& part_name,
                          const WitnessQuestion& question) {
  FoundWitness found;
  ccw::Question asked;
  asked.uncut = to_nm(question.uncut);
  asked.straight = question.straight;
  asked.partial = true;  // what is missing is named in the result
  try {
    const ccw::Part part = ccw::read_part(part_text, part_name);
    ccw::Program program = ccw::read_program(program_text, program_name, part.top);
    program.dogleg = program.dogleg && !question.straight;
    const Setting setting{part, program, asked, tools_of(program, question)};
    std::vector<Claimed> claims;
    std::vector<Travelled> rapids;
    find(setting, question, claims, rapids, found.missing);
    if (claims.empty())
      throw NotFound{found.missing.empty() ? "no feature can be claimed" : found.missing.front()};
    const std::vector<ccw::RimMove> rims =
        question.engagement ? RimFinder(setting).all() : std::vector<ccw::RimMove>{};
    Text bytes = "CCW3" + ccw::sha256(program_text) + ccw::sha256(part_text) +
                 WitnessWriter(setting.tools, claims, rapids, rims).bytes();
    found.claims = ccw::check(asked, program_text, program_name, part_text, part_name, bytes);
    found.bytes = std::move(bytes);
    for (const Claimed& one : claims) {
      found.proved.push_back(part.features[one.claim.feature].name);
      found.tiles += static_cast<int>(one.cover.size() + one.centre.size());
    }
    for (const Travelled& one : rapids) found.tiles += static_cast<int>(one.tiles.size());
  } catch (const ccw::Refusal& refusal) {
    found.why_not = refusal.what;
  } catch (const NotFound& reason) {
    found.why_not = reason.why;
  }
  return found;
}

WitnessAnswer check_witness(const std::string& program_text, const std::string& part_text,
                            const std::string& witness, double uncut, bool straight, bool partial) {
  ccw::Question asked;
  asked.uncut = to_nm(uncut);
  asked.straight = straight;
  asked.partial = partial;
  try {
    return {true, ccw::check(asked, program_text, "program", part_text, "part", witness)};
  } catch (const ccw::Refusal& refusal) {
    return {false, refusal.what};
  }
}

}  // namespace clearcut::pipeline
