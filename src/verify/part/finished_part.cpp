#include "verify/part/finished_part.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "verify/part/trimmed_curve.h"

namespace clearcut::verify {
namespace {

/// mm. The height on both sides of an edge is computed this far beside it: more than the rounding differences of
/// coincident outlines.
constexpr double kBeside = 1e-8;
/// mm. A corner nearer to an edge than this is on it: the rounding of unions and intersections moves corners by up to a nanometre.
constexpr double kCornerOnEdge = kSamePlaceMm;
constexpr double kNothing = -std::numeric_limits<double>::infinity();
/// mm below the stock without any part: deeper than any through cut. The permitted depth of a cutter is checked with
/// the stock.
constexpr double kUnderStock = 1000;

double top_of(const Part& part) {
  if (part.stock) return part.stock->z_top;
  double top = kNothing;
  for (const Feature& feature : part.features) top = std::max(top, feature.top_z);
  return top;
}

Vec2 left_normal_at_middle(const Edge& edge) {
  return left_of(edge.tangent_at(0.5));
}

/// The edges of a chamfer's strip away from the wall to be chamfered: only there the strip's wall has draft.
EdgeTree drafted_edges(const Feature& feature) {
  const double half = feature.chamfer->depth * base::tan(feature.wall_slope.radians()) / 2;
  const EdgeTree line(std::vector<Edge>(feature.chamfer->line));
  std::vector<Edge> edges;
  for (const Region& region : feature.allowed) {
    for (const Edge& edge : region.edges()) {
      if (line.nearest(edge.at(0.5)).distance > half) edges.push_back(edge);
    }
  }
  return EdgeTree(std::move(edges));
}

bool is_cut(const Feature& feature, int number, const CutFeatures& cut) {
  if (feature.kind == FeatureKind::kExternalThread && !cut.threads) return false;
  if (feature.kind == FeatureKind::kTSlot && (!cut.undercuts_up_to || feature.top_z < *cut.undercuts_up_to))
    return false;
  return !cut.only_draft || *cut.only_draft == number || feature.wall_slope.radians() <= 0;
}

/// Whether there is no part material below the feature.
bool goes_through(const Feature& feature, const std::optional<Stock>& stock) {
  return stock && feature.through && feature.wall_slope.radians() == 0 &&
         feature.floor_z <= stock->z_bottom + kSamePlaceMm;
}

/// Removes repeated vertical walls from another feature with the same outline, all but the first; operations on one outline, such
/// as the cut-outs of a panel, would else multiply every query by their number.
void remove_repeats(std::vector<Wall>& walls) {
  const auto key = [&](std::uint32_t i) {
    const Wall& wall = walls[i];
    const Edge& e = wall.edge;
    const Vec2 center = e.is_arc() ? e.center : Vec2{};
    return std::make_tuple(e.from.x, e.from.y, e.to.x, e.to.y, center.x, center.y, e.turn, wall.z_low,
                           wall.z_high);
  };
  std::vector<std::uint32_t> order;
  order.reserve(walls.size());
  for (std::uint32_t i = 0; i < walls.size(); ++i)
    if (walls[i].slope <= 0) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto of_a = key(a), of_b = key(b);
    return of_a != of_b ? of_a < of_b : a < b;
  });
  std::vector<bool> is_repeat(walls.size(), false);
  for (std::size_t k = 1; k < order.size(); ++k) is_repeat[order[k]] = key(order[k - 1]) == key(order[k]);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < walls.size(); ++i)
    if (!is_repeat[i]) walls[kept++] = walls[i];
  walls.resize(kept);
}

double distance_of(const Edge& path, const Edge& wall) {
  return path.from == path.to ? distance(wall, path.from) : distance(path, wall);
}

}  // namespace

std::vector<Edge> Wall::flat_ends(double z) const {
  std::vector<Edge> ends;
  const double far = draft_offset(z);
  if (far <= 0) return ends;
  if (flat_from) ends.push_back(Edge::line(edge.from, edge.from + left_of(edge.tangent_at(0)) * far));
  if (flat_to) ends.push_back(Edge::line(edge.to + left_of(edge.tangent_at(1)) * far, edge.to));
  return ends;
}

FinishedPart::FinishedPart(const Part& part, const CutFeatures& cut) : top_z_(top_of(part)) {
  if (part.stock) add_stock(*part.stock);
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    const int number = static_cast<int>(i);
    if (!is_cut(part.features[i], number, cut)) continue;
    add_feature(part.features[i], number);
    if (goes_through(part.features[i], part.stock)) shapes_.back().floor = part.stock->z_bottom - kUnderStock;
  }
  find_walls();
  for (const Shape& shape : shapes_) {
    if (shape.feature < 0) continue;
    heights_.push_back(shape.floor);
    heights_.push_back(shape.top);
  }
  heights_.push_back(top_z_);
  std::sort(heights_.begin(), heights_.end());
  heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
}

void FinishedPart::add_feature(const Feature& feature, int index) {
  Shape shape;
  shape.feature = index;
  shape.outline = EdgeTree(feature.allowed);
  shape.box = shape.outline.box();
  shape.floor = feature.floor_z;
  shape.top = feature.top_z;
  shape.slope = base::tan(feature.wall_slope.radians());
  shape.fillet = feature.floor_fillet;
  greatest_fillet_ = std::max(greatest_fillet_, feature.floor_fillet);
  shape.single = feature.allowed.size() <= 1;
  if (feature.chamfer) shape.drafted = drafted_edges(feature);
  greatest_draft_offset_ = std::max(greatest_draft_offset_, (shape.top - shape.floor) * shape.slope);
  shapes_.push_back(std::move(shape));
}

void FinishedPart::add_stock(const Stock& stock) {
  stock_ = stock.plan;
  const Vec2 a = stock.plan.min, c = stock.plan.max, b{c.x, a.y}, d{a.x, c.y};
  Shape shape;
  shape.outline = EdgeTree({Edge::line(a, d), Edge::line(d, c), Edge::line(c, b), Edge::line(b, a)});
  shape.box = stock.plan;
  shape.floor = shape.top = kNothing;
  shapes_.push_back(std::move(shape));
}

bool FinishedPart::holds(const Shape& shape, Vec2 p) const {
  if (shape.feature < 0) return !shape.box.contains(p);
  return shape.box.contains(p) && shape.outline.winding(p) != 0;
}

bool FinishedPart::is_drafted_at(const Shape& shape, const Edge& piece) {
  if (shape.slope <= 0) return false;
  return shape.drafted.empty() || shape.drafted.nearest(piece.at(0.5)).distance < kProbe;
}

bool FinishedPart::is_inside(int feature, Vec2 p) const {
  const auto own =
      std::find_if(shapes_.begin(), shapes_.end(), [&](const Shape& s) { return s.feature == feature; });
  return own != shapes_.end() && holds(*own, p);
}

/// mm; height of the part at p, a point of this feature, if there were no other feature.
double FinishedPart::height_in(const Shape& shape, Vec2 p) const {
  if (shape.slope <= 0) return shape.floor;
  const double far = (shape.top - shape.floor) * shape.slope;
  const EdgeTree& edges = shape.drafted.empty() ? shape.outline : shape.drafted;
  const double d = std::min(far, edges.nearest(p, far).distance);
  return std::max(shape.floor, shape.top - d / shape.slope);
}

/// mm; distance of the wall inside its outline for a cutter at p. Beyond an end cut off square by the stock's side,
/// the value makes the distance of p from the wall equal to its distance from that end.
double FinishedPart::draft_offset_inside(const Wall& wall, double z, Vec2 p) const {
  const double draft = wall.draft_offset(z);
  if (!wall.flat_from && !wall.flat_to) return draft;
  const double from_outline = distance(wall.edge, p);
  for (const Edge& end : wall.flat_ends(z)) {
    const Vec2 corner = wall.flat_from && end.from == wall.edge.from ? end.from : end.to;
    const Vec2 outward = left_of(end.tangent_at(0));
    const bool beyond = dot(p - corner, outward) > 0 && from_outline >= distance(corner, p) - kProbe;
    if (beyond) return std::max(0.0, from_outline - distance(end, p));
  }
  return draft;
}

double FinishedPart::apart(const Wall& wall, double z, const Edge& path) const {
  double least = distance_of(path, wall.edge);
  const double draft = wall.draft_offset(z);
  if (draft <= 0) return least;
  for (const Edge& top : parallel(wall.edge, draft, 0)) {
    if (top.from != top.to) least = std::min(least, distance_of(path, top));
  }
  for (const Edge& end : wall.flat_ends(z)) least = std::min(least, distance_of(path, end));
  const auto round = [&](Vec2 corner) {
    const double d = path.from == path.to ? distance(path.from, corner) : distance(path, corner);
    least = std::min(least, d - draft);
  };
  if (!wall.flat_from) round(wall.edge.from);
  if (!wall.flat_to) round(wall.edge.to);
  return least;
}

double FinishedPart::height(Vec2 p) const {
  double height = top_z_;
  for (const Shape& shape : shapes_) {
    if (shape.floor < height && holds(shape, p)) height = std::min(height, height_in(shape, p));
  }
  return height;
}

/// mm; as cleared_by(), for only one shape, with its floor at z or below.
double FinishedPart::cleared_in(const Shape& shape, Vec2 p, double z) const {
  const double from_outline = shape.outline.distance_to(p);
  if (!holds(shape, p)) return -from_outline;
  if (shape.slope <= 0 || z >= shape.top) return from_outline;
  const double from_drafted = shape.drafted.empty() ? from_outline : shape.drafted.distance_to(p);
  return std::min(from_outline, from_drafted - (shape.top - z) * shape.slope);
}

double FinishedPart::cleared_by(Vec2 p, double z) const {
  if (z >= top_z_) return std::numeric_limits<double>::infinity();
  double most = kNothing;
  for (const Shape& shape : shapes_)
    if (shape.floor <= z) most = std::max(most, cleared_in(shape, p, z));
  return most;
}

bool FinishedPart::is_sliver(Vec2 p, double z) const {
  return sliver_tree_.nearest(p, kThinSliver, [&](int i) { return slivers_[i].stands_at(z); }).edge >= 0;
}

/// mm; height near a piece of the outline of shape `own`. Walls with draft are taken as upright, because they
/// are added as walls of their own.
double FinishedPart::height_beside(Vec2 p, int own, bool inside_own) const {
  double height = top_z_;
  for (int i = 0; i < static_cast<int>(shapes_.size()); ++i) {
    const Shape& shape = shapes_[i];
    if (shape.floor >= height) continue;
    const bool inside = i == own && (shape.single || inside_own) ? inside_own : holds(shape, p);
    if (inside) height = shape.floor;
  }
  return height;
}

/// mm; radius of the fillet at the foot of a wall, over the floor at p, just inside shape `own` or one that reaches as deep: none where one
/// of those asks for none. Material that ends where the fillet would end is no wall with a fillet: it stands beside the fillet's end.
double FinishedPart::fillet_at(const Wall& wall, Vec2 p, int own) const {
  double fillet = greatest_fillet_;
  for (int i = 0; i < static_cast<int>(shapes_.size()) && fillet > 0; ++i) {
    const Shape& shape = shapes_[static_cast<std::size_t>(i)];
    if (shape.floor == wall.z_low && (i == own || holds(shape, p))) fillet = std::min(fillet, shape.fillet);
  }
  const double highest = wall.z_low + wall.height_of_touching(fillet);
  const bool ends_with_it = wall.z_high <= highest + kSamePlaceMm && wall.z_high < top_z_;
  return ends_with_it ? 0 : fillet;
}

/// Parameters at which the outlines of other shapes meet this edge, or turn beside it, with 0 and 1, ascending: at
/// points where they turn away from the edge without a crossing, the height changes.
std::vector<double> FinishedPart::cuts_of(const Edge& edge, int shape, const EdgeTree& all,
                                          const std::vector<int>& owner) const {
  std::vector<double> cuts{0, 1};
  all.overlapping(edge.box().grown(kCornerOnEdge), [&](int other) {
    if (owner[other] == shape) return;
    for (const Vec2 p : intersections(edge, all.edges()[other])) cuts.push_back(nearest(edge, p).t);
    const auto corner = nearest(edge, all.edges()[other].from);
    if (corner.distance < kCornerOnEdge && corner.t > 0 && corner.t < 1) cuts.push_back(corner.t);
  });
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

void FinishedPart::find_walls() {
  add_walls();
  // Before removal of repeats: thin slivers are between walls of different features.
  Slivers parts = parted(walls_);
  walls_ = std::move(parts.walls);
  slivers_ = std::move(parts.slivers);
  remove_repeats(walls_);
  remove_repeats(slivers_);
  tree_ = tree_of(walls_);
  sliver_tree_ = tree_of(slivers_);
}

void FinishedPart::add_walls() {
  std::vector<Edge> edges;
  std::vector<int> owner;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const std::vector<Edge>& own = shapes_[i].outline.edges();
    edges.insert(edges.end(), own.begin(), own.end());
    owner.insert(owner.end(), own.size(), static_cast<int>(i));
  }
  const EdgeTree all(std::move(edges));
  walls_.reserve(owner.size());
  for (std::size_t k = 0; k < owner.size(); ++k) {
    const Edge& edge = all.edges()[k];
    const std::vector<double> cuts =
        shapes_.size() == 1 ? std::vector<double>{0, 1} : cuts_of(edge, owner[k], all, owner);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      // For nearly coincident outlines, crossings cut off pieces too short to find walls: heights are computed at the
      // distance kBeside.
      if (cuts.size() > 2 && (cuts[i + 1] - cuts[i]) * edge.length() < kBeside) continue;
      add_wall(cuts.size() == 2 ? edge : edge.part(cuts[i], cuts[i + 1]), shapes_[owner[k]], owner[k]);
    }
  }
}

void FinishedPart::add_wall(const Edge& piece, const Shape& shape, int index) {
  const Vec2 middle = piece.at(0.5), aside = left_normal_at_middle(piece) * kBeside;
  const double left = height_beside(middle + aside, index, true);
  const double right = height_beside(middle - aside, index, false);
  if (is_drafted_at(shape, piece)) return add_drafted_wall(piece, index, left, right);
  if (left == kNothing && right == kNothing && shape.feature >= 0)
    beyond_.push_back({piece, shape.floor, shape.top, shape.feature});
  if (left == right) return;
  Wall wall{left < right ? piece : piece.reversed(), std::min(left, right), std::max(left, right),
            shape.feature};
  if (greatest_fillet_ > 0)
    wall.fillet = left < right ? fillet_at(wall, middle + aside, index) : fillet_at(wall, middle - aside, -1);
  walls_.push_back(wall);
}

void FinishedPart::add_drafted_wall(const Edge& piece, int index, double left, double right) {
  const Shape& shape = shapes_[static_cast<std::size_t>(index)];
  // Beside the stock there are no walls with draft, and the stock's own sides are upright.
  if (left == kNothing && right == kNothing) return;
  if (left == kNothing) return walls_.push_back({piece, left, right, shape.feature});
  const double upright = std::min(right, shape.floor);
  if (left < upright) walls_.push_back({piece, left, upright, shape.feature});
  Wall wall{piece, shape.floor, left < right ? right : shape.top, shape.feature, shape.top, shape.slope};
  wall.flat_from = is_beside_stock(piece.from - piece.tangent_at(0) * kProbe);
  wall.flat_to = is_beside_stock(piece.to + piece.tangent_at(1) * kProbe);
  if (greatest_fillet_ > 0) {
    const double foot = wall.draft_offset(wall.z_low) + kBeside;
    wall.fillet = fillet_at(wall, piece.at(0.5) + left_normal_at_middle(piece) * foot, index);
  }
  walls_.push_back(wall);
}

bool FinishedPart::is_beside_stock(Vec2 p) const {
  return stock_ && !stock_->contains(p);
}

namespace {

/// Accuracy of the end of a thin sliver as a share of the wall's length; places nearer to each other are one.
constexpr double kEndOfSliver = 1e-6;
constexpr double kNoSliver = std::numeric_limits<double>::infinity();

class SliverFinder {
 public:
  SliverFinder(const std::vector<Wall>& walls, const EdgeTree& tree) : walls_(walls), tree_(tree) {}

  /// Adds the wall in pieces with a thin sliver behind them along their whole length, or nowhere.
  void divide(const Wall& wall, Slivers& parts) {
    find_near(wall);
    if (near_.empty()) return parts.walls.push_back(wall);
    std::vector<double> cuts{0};
    const std::vector<double> places = places_along(wall.edge);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if (has_sliver(wall, places[i]) != has_sliver(wall, places[i + 1]))
        cuts.push_back(change_between(wall, places[i], places[i + 1]));
    }
    cuts.push_back(1);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      Wall piece = wall;
      if (cuts.size() > 2) piece.edge = wall.edge.part(cuts[i], cuts[i + 1]);
      piece.flat_from = wall.flat_from && i == 0;
      piece.flat_to = wall.flat_to && i + 2 == cuts.size();
      add(piece, sliver_z(wall, (cuts[i] + cuts[i + 1]) / 2), parts);
    }
  }

 private:
  /// Adds a wall with a thin sliver behind it from sliver_z up.
  static void add(Wall piece, double sliver_z, Slivers& parts) {
    if (sliver_z < piece.z_high) {
      parts.slivers.push_back(piece);
      parts.slivers.back().z_low = sliver_z;
      piece.z_high = sliver_z;
    }
    if (piece.z_low < piece.z_high) parts.walls.push_back(piece);
  }

  void find_near(const Wall& wall) {
    near_.clear();
    if (wall.slope > 0) return;
    tree_.overlapping(wall.edge.box().grown(kThinSliver), [&](int i) {
      const Wall& other = walls_[static_cast<std::size_t>(i)];
      const bool may_leave_sliver =
          other.feature != wall.feature && other.slope <= 0 && !(other.edge == wall.edge);
      if (may_leave_sliver && distance(wall.edge, other.edge) <= kThinSliver) near_.push_back(&other);
    });
  }

  /// Ascending; between two of them the distance of the other walls is monotone, if all are straight.
  std::vector<double> places_along(const Edge& edge) const {
    std::vector<double> places{0, 1};
    for (const Wall* other : near_) {
      for (const Vec2 end : {other->edge.from, other->edge.to}) places.push_back(nearest(edge, end).t);
    }
    std::sort(places.begin(), places.end());
    const auto same = [](double a, double b) { return b - a < kEndOfSliver; };
    places.erase(std::unique(places.begin(), places.end() - 1, same), places.end() - 1);
    for (std::size_t i = places.size() - 1; i > 0; --i) places.push_back((places[i - 1] + places[i]) / 2);
    std::sort(places.begin(), places.end());
    return places;
  }

  double sliver_z(const Wall& wall, double t) const {
    const Vec2 p = wall.edge.at(t), heading = wall.edge.tangent_at(t);
    double lowest = kNoSliver;
    for (const Wall* other : near_) {
      const auto there = nearest(other->edge, p);
      const Vec2 back = other->edge.tangent_at(there.t);
      const bool is_behind =
          dot(left_of(back), p - other->edge.at(there.t)) <= kRoundingMm && dot(heading, back) < 0;
      if (is_behind && there.distance <= kThinSliver)
        lowest = std::min(lowest, std::max(wall.z_low, other->z_low));
    }
    return lowest;
  }
  bool has_sliver(const Wall& wall, double t) const { return sliver_z(wall, t) < kNoSliver; }

  double change_between(const Wall& wall, double low, double high) const {
    const bool first = has_sliver(wall, low);
    while (high - low > kEndOfSliver) {
      const double middle = (low + high) / 2;
      (has_sliver(wall, middle) == first ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  const std::vector<Wall>& walls_;
  const EdgeTree& tree_;
  std::vector<const Wall*> near_;
};

}  // namespace

EdgeTree tree_of(const std::vector<Wall>& walls) {
  std::vector<Edge> edges;
  edges.reserve(walls.size());
  for (const Wall& wall : walls) edges.push_back(wall.edge);
  return EdgeTree(std::move(edges));
}

Slivers parted(const std::vector<Wall>& walls) {
  const EdgeTree tree = tree_of(walls);
  SliverFinder finder(walls, tree);
  Slivers parts;
  parts.walls.reserve(walls.size());
  for (const Wall& wall : walls) finder.divide(wall, parts);
  return parts;
}

}  // namespace clearcut::verify
