#include "link/work.h"

#include <algorithm>
#include <limits>

#include "geometry/voronoi/clearance.h"

namespace clearcut::link {

Path rotated_to(const Path& path, const PassStart& start) {
  const Edge& edge = path[start.edge];
  const double margin = 1e-6 / edge.length();
  Path out;
  std::size_t first = start.edge;
  const bool split = start.t > margin && start.t < 1 - margin;
  if (split) out.push_back(edge.part(start.t, 1));
  if (split || start.t >= 1 - margin) ++first;
  const std::size_t whole = split ? path.size() - 1 : path.size();
  for (std::size_t i = 0; i < whole; ++i) out.push_back(path[(first + i) % path.size()]);
  if (split) out.push_back(edge.part(0, start.t));
  return out;
}

PassStart nearest_start(const Pass& pass, Vec2 p) {
  PassStart best;
  if (!pass.closed) {
    best.backwards =
        pass.reversible && distance(pass.path.back().to, p) < distance(pass.path.front().from, p);
    best.point = best.backwards ? pass.path.back().to : pass.path.front().from;
    return best;
  }
  double nearest_distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    const auto on = nearest(pass.path[i], p);
    if (on.distance >= nearest_distance) continue;
    nearest_distance = on.distance;
    best = {on.point, i, on.t, false};
  }
  return best;
}

namespace {

/// Share of the tool's radius: how far from a pass its entry or lead may sweep.
constexpr double kBeside = 3;
/// More pairs of edges than this are not compared: the passes are taken to be near each other.
constexpr std::size_t kMostPairs = 10000;
/// More passes than this are not compared with each other, because the comparison would take too long.
constexpr std::size_t kMostMixed = 2000;

/// mm. Places nearer than this to the target are not taken to be cleared.
constexpr double kSpare = 0.05;

/// Factor by which distances to boxes are taken to be less, for their rounding.
constexpr double kRoundedDown = 1 - 1e-9;

bool reaches_out(const LayerPasses& layer, const LegalArea& legal, double tool_radius) {
  const Box target = box(layer.target);
  if (target.empty()) return false;
  const Box inner = target.grown(-tool_radius / 2);
  return !inner.contains(legal.box().min) || !inner.contains(legal.box().max);
}

/// Whether the areas swept along both paths may overlap; true in doubt.
bool sweeps_meet(const Path& a, const Path& b, double tool_radius) {
  if (a.size() * b.size() > kMostPairs) return true;
  std::vector<Box> boxes;
  for (const Edge& edge : b) boxes.push_back(edge.box().grown(tool_radius));
  return std::any_of(a.begin(), a.end(), [&](const Edge& edge) {
    const Box swept = edge.box().grown(tool_radius);
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& other) { return swept.overlaps(other); });
  });
}

}  // namespace

LayerWork::LayerWork(const LayerPasses& layer, double tool_radius)
    : layer_(&layer),
      legal_(layer.legal),
      tool_radius_(tool_radius),
      open_(reaches_out(layer, legal_, tool_radius)) {}

const LegalRoutes& LayerWork::routes() const {
  if (!routes_) routes_ = std::make_unique<LegalRoutes>(layer_->legal, legal_);
  return *routes_;
}

const LegalArea& LayerWork::target_area() const {
  if (!target_area_) target_area_.emplace(layer_->target);
  return *target_area_;
}

const Regions& LayerWork::within_target() const {
  if (!within_target_) within_target_ = inset(layer_->target, tool_radius_, Tolerances{});
  return *within_target_;
}

bool LayerWork::reaches_beside() const {
  if (!reaches_beside_) {
    // The legal area lies to the left of its edges.
    const double reach = tool_radius_ - kSpare;
    const auto leads_beside = [&](const Edge& edge) {
      constexpr double kLookedAt[] = {0, 0.5, 1};
      return std::any_of(std::begin(kLookedAt), std::end(kLookedAt), [&](double t) {
        return !target_area().contains(edge.at(t) - left_of(edge.tangent_at(t)) * reach);
      });
    };
    reaches_beside_ =
        open_ || std::any_of(layer_->legal.begin(), layer_->legal.end(), [&](const Region& region) {
          const std::vector<Edge> edges = region.edges();
          return std::any_of(edges.begin(), edges.end(), leads_beside);
        });
  }
  return *reaches_beside_;
}

const Regions& LayerWork::touching() const {
  if (!touching_) touching_ = dilate(layer_->target, tool_radius_ + kSpare, Tolerances{});
  return *touching_;
}

std::vector<Vec2> LayerWork::nearest_on_rim(Vec2 p, std::size_t most) const {
  if (!rim_) {
    rim_.emplace();
    for (const Region& region : touching()) {
      const std::vector<Edge> edges = region.edges();
      rim_->edges.insert(rim_->edges.end(), edges.begin(), edges.end());
    }
    rim_->tree.build(static_cast<std::uint32_t>(rim_->edges.size()),
                     [&](std::uint32_t i) { return rim_->edges[i].box(); });
  }
  struct Place {
    double squared = 0;
    std::uint32_t edge = 0;
    Vec2 point;
    bool operator<(const Place& other) const {
      return squared < other.squared || (squared == other.squared && edge < other.edge);
    }
  };
  std::vector<Place> nearest_ones;  // a heap, the farthest on top
  const auto may_be_nearer = [&](const Box& box) {
    if (nearest_ones.size() < most) return true;
    const double reach = box.distance_to(p) * kRoundedDown;
    return reach * reach <= nearest_ones.front().squared;
  };
  rim_->tree.descend_nearest_first(p, may_be_nearer, [&](std::uint32_t i) {
    const Vec2 point = nearest(rim_->edges[i], p).point;
    const Place place{norm_squared(point - p), i, point};
    if (nearest_ones.size() == most && !(place < nearest_ones.front())) return;
    if (nearest_ones.size() == most) {
      std::pop_heap(nearest_ones.begin(), nearest_ones.end());
      nearest_ones.pop_back();
    }
    nearest_ones.push_back(place);
    std::push_heap(nearest_ones.begin(), nearest_ones.end());
  });
  std::sort_heap(nearest_ones.begin(), nearest_ones.end());
  std::vector<Vec2> points;
  for (const Place& place : nearest_ones) points.push_back(place.point);
  return points;
}

bool LayerWork::turned_round(std::size_t pass) const {
  return open_ && layer_->passes[pass].closed && signed_area(layer_->passes[pass].path) > 0;
}

int LayerWork::later_of_tree_edge(std::size_t pass) const {
  const int parent = layer_->passes[pass].parent;
  if (parent < 0) return -1;
  const bool outer_first = layer_->outside_in || turned_round(static_cast<std::size_t>(parent));
  return outer_first ? static_cast<int>(pass) : parent;
}

int LayerWork::part_around(Vec2 p) const {
  const Regions& legal = layer_->legal;
  for (std::size_t i = 0; i < legal.size(); ++i) {
    if (legal[i].contains(p) || legal[i].boundary_distance(p) <= LegalArea::kSlack)
      return static_cast<int>(i);
  }
  return -1;
}

Work::Work(const std::vector<LayerPasses>& layers, double tool_radius) : tool_radius_(tool_radius) {
  for (const LayerPasses& layer : layers) layers_.emplace_back(layer, tool_radius);
  for (std::size_t l = 0; l < layers.size(); ++l) {
    for (std::size_t p = 0; p < layers[l].passes.size(); ++p) {
      const Box path = box(layers[l].passes[p].path);
      items_.push_back({l, p, path, path.grown(tool_radius)});
    }
  }
  before_.resize(items_.size());
  after_.resize(items_.size());
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (items_[i].pass == 0) add_layer(i);
  }
  layers_may_mix_ = items_.size() <= kMostMixed;
  if (layers_may_mix_) add_depths();
}

void Work::add(std::size_t before, std::size_t after) {
  before_[after].push_back(before);
  after_[before].push_back(after);
}

/// Adds the precedence within the layer whose first pass is item `first`: stated by passes, and of rings.
void Work::add_layer(std::size_t first) {
  const LayerWork& layer = layer_of(first);
  for (std::size_t p = 0; p < layer.layer().passes.size(); ++p) {
    for (const int before : layer.layer().passes[p].after)
      add(first + static_cast<std::size_t>(before), first + p);
    const int later = layer.later_of_tree_edge(p);
    if (later < 0) continue;
    const auto parent = static_cast<std::size_t>(layer.layer().passes[p].parent);
    const bool parent_waits = static_cast<std::size_t>(later) == parent;
    add(first + (parent_waits ? p : parent), first + (parent_waits ? parent : p));
  }
}

void Work::add_depths() {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    for (std::size_t k = 0; k < i && items_[k].layer < items_[i].layer; ++k) {
      if (is_above(k, i)) add(k, i);
    }
  }
}

/// LayerWork::part_around of the start of a pass. Kept, because it is needed for many pairs of passes.
int Work::part_of_start(std::size_t layer, std::size_t item) {
  const auto found = part_of_start_.find({layer, item});
  if (found != part_of_start_.end()) return found->second;
  const int part = layers_[layer].part_around(pass(item).path.front().from);
  part_of_start_.emplace(std::pair{layer, item}, part);
  return part;
}

/// Whether `low` must wait for `high`. Entries and leads stay beside their pass, in the connected part of
/// the legal area of its beginning.
bool Work::is_above(std::size_t high, std::size_t low) {
  if (!items_[high].swept.overlaps(items_[low].path.grown(kBeside * tool_radius_))) return false;
  if (layer_of(high).parts() < 2) return true;
  const int part = part_of_start(items_[high].layer, high);
  if (part < 0 || part == part_of_start(items_[high].layer, low)) return true;
  return sweeps_meet(pass(high).path, pass(low).path, tool_radius_);
}

bool Work::has_one_order() const {
  for (std::size_t i = 1; i < items_.size(); ++i) {
    if (std::find(before_[i].begin(), before_[i].end(), i - 1) == before_[i].end()) return false;
  }
  return true;
}

Progress::Progress(const Work& work, Layers layers)
    : work_(work),
      layers_(layers),
      done_(work.items().size(), false),
      waiting_for_(work.items().size()),
      left_(work.items().size()) {
  for (std::size_t i = 0; i < left_; ++i) waiting_for_[i] = work.before(i).size();
}

bool Progress::available(std::size_t item) const {
  if (done_[item] || waiting_for_[item] > 0) return false;
  return layers_ == Layers::kMixed || work_.items()[item].layer == work_.items()[first_undone_].layer;
}

void Progress::mark_done(std::size_t item) {
  done_[item] = true;
  --left_;
  for (const std::size_t later : work_.after(item)) --waiting_for_[later];
  while (first_undone_ < done_.size() && done_[first_undone_]) ++first_undone_;
}

bool Progress::clear_above(std::size_t layer, const Box& travel) const {
  if (finished()) return true;
  const Box swept = travel.grown(work_.tool_radius());
  const auto& items = work_.items();
  for (std::size_t i = first_undone_; i < items.size() && items[i].layer < layer; ++i) {
    if (!done_[i] && items[i].swept.overlaps(swept)) return false;
  }
  return true;
}

}  // namespace clearcut::link
