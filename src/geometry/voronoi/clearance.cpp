// Symbol table and reasons: docs/offset.md.
#include "geometry/voronoi/clearance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <mutex>

#include "base/error.h"
#include "base/work_budget.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/axis.h"
#include "geometry/voronoi/level_curves.h"

namespace clearcut::inline geometry {
namespace {

/// mm. Distance of sites from the boundary if the diagram cannot prove its topology with coarser sites: half
/// of the promised 1 um.
constexpr double kFine = 0.0005;
constexpr double kRefinement = 0.1;
constexpr int kManyLines = 300;
/// mm. Greatest distance of a run of lines from the one line that replaces the run.
constexpr double kSimplify = 0.0004;
/// mm. Offsets smaller than this return the region: its own points are within the promise.
constexpr double kNoOffset = 0.0005;
/// mm. A place belongs to a level if its clearance exceeds the level by this margin: it is above the noise of the
/// grid, so that walls exactly 2d apart give a fit line and not slivers.
constexpr double kMargin = 0.0003;
/// Share of the fit tolerance by which the clearance on a fit line may fall short; the rest is kept for rounding in a
/// program.
constexpr double kFitShare = 0.9;
/// The same where stock is kept for coarse digits: these take up more of the smallest gouge. What counts as reachable (the fit
/// tolerance's half) is still reached, with the noise of the grid.
constexpr double kCoarseFitShare = 0.6;
/// Dead ends of fit lines shorter than this many times the fit tolerance are corners, not slots.
constexpr double kStubFactor = 100;

/// Loops of one level, nested: counter-clockwise ones hold the clockwise ones inside them.
Regions nested(std::vector<Loop> loops) {
  std::vector<std::pair<double, Loop>> outers;
  std::vector<Loop> islands;
  for (Loop& loop : loops) {
    const double area = signed_area(loop);
    if (area > 0)
      outers.emplace_back(area, std::move(loop));
    else if (area < 0)
      islands.push_back(std::move(loop));
  }
  // Smallest first: the first outer loop containing an island is the one around it.
  std::vector<std::size_t> by_area(outers.size());
  for (std::size_t i = 0; i < by_area.size(); ++i) by_area[i] = i;
  std::stable_sort(by_area.begin(), by_area.end(),
                   [&](std::size_t a, std::size_t b) { return outers[a].first < outers[b].first; });
  std::vector<Box> boxes;
  for (const auto& outer : outers) boxes.push_back(box(outer.second));
  std::vector<std::vector<Loop>> inside(outers.size());
  for (Loop& island : islands) {
    const Vec2 p = island.front().at(0.5);
    const auto holder = std::find_if(by_area.begin(), by_area.end(), [&](std::size_t i) {
      return outers.size() == 1 || (boxes[i].contains(p) && contains(outers[i].second, p));
    });
    if (holder != by_area.end()) inside[*holder].push_back(std::move(island));
  }
  Regions regions;
  for (std::size_t i = 0; i < outers.size(); ++i) {
    regions.push_back(Region::from_valid_loops(std::move(outers[i].second), std::move(inside[i])));
  }
  return regions;
}

using WallPair = std::pair<const voronoi::Element&, const voronoi::Element&>;

/// The place of equal distance to both walls beside p, by Newton's method across the bisector.
AxisPoint onto_bisector(const WallPair& walls, Vec2 p) {
  for (int i = 0; i < 8; ++i) {
    const double difference = voronoi::distance(walls.first, p) - voronoi::distance(walls.second, p);
    const Vec2 gradient = voronoi::away_from(walls.first, p) - voronoi::away_from(walls.second, p);
    if (std::abs(difference) < 1e-12 || norm_squared(gradient) < 1e-12) break;
    p = p - gradient * (difference / norm_squared(gradient));
  }
  return {p, voronoi::distance(walls.first, p)};
}

/// The bisector from a (left out) to b by halving; bisectors of lines, points and circles have no inflexion.
void append_axis_curve(const WallPair& walls, const AxisPoint& a, const AxisPoint& b, double chord,
                       int halvings, std::vector<AxisPoint>& out) {
  const Vec2 middle = lerp(a.point, b.point, 0.5);
  const AxisPoint on = onto_bisector(walls, middle);
  const double length = distance(a.point, b.point), off = distance(on.point, middle);
  const double bend = std::max(off, std::abs(on.clearance - (a.clearance + b.clearance) / 2));
  if (halvings > 0 && bend > chord && off < length) {
    append_axis_curve(walls, a, on, chord, halvings - 1, out);
    append_axis_curve(walls, on, b, chord, halvings - 1, out);
  } else {
    out.push_back(b);
  }
}

/// Requests finer sites for the arcs in doubt; false if no arc could be refined.
bool refine(const voronoi::Diagram& diagram, voronoi::SiteErrors& errors) {
  bool any = false;
  for (const int i : diagram.doubtful) {
    const double now = errors.of(i);
    if (now <= kFine || !diagram.element(i).edge.is_arc()) continue;
    errors.of_element[i] = std::max(kFine, now * kRefinement);
    any = true;
  }
  return any;
}

/// Doubt about one arc costs another diagram of all edges: among many lines, arcs start finer.
double usual_error(const Region& region, const Tolerances& tol) {
  const auto edges = region.edges();
  const auto lines = std::count_if(edges.begin(), edges.end(), [](const Edge& e) { return !e.is_arc(); });
  return lines < kManyLines ? tol.topology_chord : tol.topology_chord * kRefinement;
}

/// In a loop no thicker than the error of its arcs' tangents, the tangents may turn the loop inside out without
/// crossing each other: such loops start with fine sites.
voronoi::SiteErrors first_errors(const Region& region, const Tolerances& tol) {
  voronoi::SiteErrors errors{usual_error(region, tol), {}};
  std::vector<Edge> thin;
  for (const Loop& loop : loops_of({region})) {
    const double mean_width = 2 * std::abs(signed_area(loop)) / length(loop);
    if (mean_width < 2 * errors.usual) thin.insert(thin.end(), loop.begin(), loop.end());
  }
  std::erase_if(thin, [](const Edge& edge) { return !edge.is_arc(); });
  if (thin.empty()) return errors;
  const std::vector<voronoi::Element> elements = voronoi::make_sites(region, errors, kSimplify).elements;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (std::find(thin.begin(), thin.end(), elements[i].edge) != thin.end())
      errors.of_element[static_cast<int>(i)] = kFine;
  return errors;
}

voronoi::Diagram diagram_of(const Region& region, const Tolerances& tol) {
  voronoi::SiteErrors errors = first_errors(region, tol);
  for (;;) {
    auto diagram = voronoi::make_diagram(voronoi::make_sites(region, errors, kSimplify), region);
    if (!refine(diagram, errors)) return diagram;
  }
}

/// Ends the path at the place where the boundary is `least` mm away: the diagram's sites may be nearer or farther, by
/// the simplification of runs of lines.
void pull_back_end(Path& path, const Region& region, double least) {
  while (!path.empty() && region.boundary_distance(path.back().from) < least) path.pop_back();
  if (path.empty()) return;
  const Edge last = path.back();
  double good = 0, bad = 1;
  while ((bad - good) * last.length() > kFine) {
    const double middle = (good + bad) / 2;
    (region.boundary_distance(last.at(middle)) < least ? bad : good) = middle;
  }
  if (good > 0) {
    path.back() = last.part(0, good);
  } else {
    path.pop_back();
  }
}

}  // namespace

struct Clearance::Impl {
  Region region;
  Tolerances tol;
  voronoi::Diagram diagram;

  Impl(const Region& of, const Tolerances& with) : region(of), tol(with), diagram(diagram_of(of, with)) {}

  /// Made at the first question for it: offsets need none.
  const voronoi::Axis& axis() const {
    std::call_once(axis_is_made_, [&] { axis_ = voronoi::make_axis(diagram); });
    return axis_;
  }

  const std::vector<AxisPoint>& centers() const {
    std::call_once(centers_are_found_, [&] { centers_ = voronoi::find_centers(axis(), diagram, tol.fit); });
    return centers_;
  }

  std::vector<Regions> insets(const std::vector<double>& ascending) const {
    std::vector<double> levels;
    for (const double d : ascending) {
      CLEARCUT_ASSERT(d >= 0 && (levels.empty() || d >= levels.back()));
      if (d >= kNoOffset) levels.push_back(d);
    }
    const std::size_t unchanged = ascending.size() - levels.size();
    std::vector<std::vector<Loop>> loops(levels.size());
    if (levels.empty()) return std::vector<Regions>(unchanged, Regions{region});
    std::call_once(reaching_is_listed_, [&] {
      listed_from_ = levels.front();
      reaching_ = voronoi::edges_reaching(diagram, listed_from_, kMargin);
    });
    std::vector<int> nearer_the_wall;
    if (levels.front() < listed_from_)
      nearer_the_wall = voronoi::edges_reaching(diagram, levels.front(), kMargin);
    const auto& reaching = levels.front() < listed_from_ ? nearer_the_wall : reaching_;
    for (const auto& curve : voronoi::level_curves(diagram, reaching, levels, kMargin)) {
      const auto level = static_cast<std::size_t>(curve.level);
      auto loop = voronoi::offset_loop(diagram, curve, levels[level], kFine);
      if (loop) loops[level].push_back(std::move(*loop));
    }
    std::vector<Regions> result(unchanged, Regions{region});
    for (auto& of_level : loops) result.push_back(nested(std::move(of_level)));
    return result;
  }

 private:
  mutable std::once_flag axis_is_made_, centers_are_found_, reaching_is_listed_;
  mutable voronoi::Axis axis_;
  mutable std::vector<AxisPoint> centers_;
  /// Edges that curves reach at the distance that was asked for first, mostly the least: a list for all later ones.
  mutable double listed_from_ = 0;
  mutable std::vector<int> reaching_;
};

namespace {

/// Greatest number of sites of all kept clearances, some 15 MB; the last one used is kept however large it is.
constexpr std::size_t kMostKept = 15000;

bool are_equal(const Tolerances& a, const Tolerances& b) {
  return a.topology_chord == b.topology_chord && a.fit == b.fit;
}

bool are_equal(const Region& a, const Region& b) {
  return a.outer() == b.outer() && a.islands() == b.islands();
}

}  // namespace

/// The clearances kept at the moment, the last one used at the end.
class Clearance::Store {
 public:
  static Store& all() {
    static Store store;
    return store;
  }

  void add_user() {
    const std::lock_guard lock(mutex_);
    ++users_;
  }
  void remove_user() {
    const std::lock_guard lock(mutex_);
    if (--users_ > 0) return;
    kept_.clear();
    sites_ = 0;
  }

  /// A task is charged the same whether the clearance is kept or made for it: what it may still do must not depend on the other tasks.
  std::shared_ptr<const Impl> clearance_of(const Region& region, const Tolerances& tol) {
    Kept found = find(region, tol);
    if (!found.impl) {
      found = made(region, tol);
      keep(found);
    }
    WorkBudget::spend(found.steps);
    return found.impl;
  }

 private:
  struct Kept {
    std::shared_ptr<const Impl> impl;
    std::uint64_t steps = 0;  ///< of work that making it took
    std::size_t sites() const { return impl->diagram.sites.segments.size(); }
  };

  static Kept made(const Region& region, const Tolerances& tol) {
    const WorkBudget counted = WorkBudget::unlimited();
    const std::uint64_t before = counted.left();
    auto impl = std::make_shared<const Impl>(region, tol);
    return {std::move(impl), before - counted.left()};
  }

  Kept find(const Region& region, const Tolerances& tol) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(kept_.rbegin(), kept_.rend(), [&](const auto& one) {
      return are_equal(one.impl->tol, tol) && are_equal(one.impl->region, region);
    });
    if (found == kept_.rend()) return {};
    std::rotate(found.base() - 1, found.base(), kept_.end());
    return kept_.back();
  }

  void keep(const Kept& made) {
    const std::lock_guard lock(mutex_);
    if (users_ == 0) return;
    kept_.push_back(made);
    for (sites_ += made.sites(); sites_ > kMostKept && kept_.size() > 1; kept_.pop_front())
      sites_ -= kept_.front().sites();
  }

  std::mutex mutex_;
  int users_ = 0;
  std::size_t sites_ = 0;
  std::deque<Kept> kept_;
};

KeptClearances::KeptClearances() {
  Clearance::Store::all().add_user();
}
KeptClearances::~KeptClearances() {
  Clearance::Store::all().remove_user();
}

Clearance::Clearance(const Region& region, const Tolerances& tol)
    : impl_(Store::all().clearance_of(region, tol)) {}
Clearance::~Clearance() = default;
Clearance::Clearance(Clearance&&) noexcept = default;
Clearance& Clearance::operator=(Clearance&&) noexcept = default;

Regions Clearance::inset(double d) const {
  return std::move(impl_->insets({d}).front());
}

std::vector<Regions> Clearance::insets(const std::vector<double>& ascending) const {
  return impl_->insets(ascending);
}

std::vector<Path> Clearance::fit_lines(double d, double reserve) const {
  const double least = d - reserve - (reserve > 0 ? kCoarseFitShare : kFitShare) * impl_->tol.fit;
  auto lines = voronoi::fit_lines(impl_->axis(), impl_->diagram, {least, d - reserve, d + kMargin},
                                  kStubFactor * impl_->tol.fit);
  for (Path& line : lines) {
    if (line.front().from == line.back().to) continue;
    for (int end = 0; end < 2; ++end) {
      line = reversed(line);
      if (!line.empty() && impl_->region.boundary_distance(line.back().to) < d - reserve - impl_->tol.fit)
        pull_back_end(line, impl_->region, least);
    }
  }
  std::erase_if(lines, [](const Path& line) { return line.empty(); });
  return lines;
}

const MedialAxis& Clearance::axis() const {
  return impl_->axis().graph;
}
std::vector<AxisPoint> Clearance::axis_curve(int edge, double chord) const {
  const auto& graph = impl_->axis().graph;
  const AxisEdge ends = graph.edges.at(static_cast<std::size_t>(edge));
  const voronoi::Walls walls = impl_->axis().walls[static_cast<std::size_t>(edge)];
  const AxisPoint a = graph.points[static_cast<std::size_t>(ends.a)];
  const AxisPoint b = graph.points[static_cast<std::size_t>(ends.b)];
  std::vector<AxisPoint> curve{a};
  append_axis_curve({impl_->diagram.element(walls.a), impl_->diagram.element(walls.b)}, a, b, chord, 12,
                    curve);
  return curve;
}

const std::vector<AxisPoint>& Clearance::centers() const {
  return impl_->centers();
}
double Clearance::max() const {
  return impl_->diagram.largest;
}

Regions inset(const Region& region, double d, const Tolerances& tol) {
  return Clearance(region, tol).inset(d);
}

Regions inset(const Regions& regions, double d, const Tolerances& tol) {
  Regions out;
  for (const Region& region : regions) {
    for (Region& inside : inset(region, d, tol)) out.push_back(std::move(inside));
  }
  return out;
}

}  // namespace clearcut::inline geometry
