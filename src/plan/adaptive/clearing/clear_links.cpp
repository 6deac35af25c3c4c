#include "plan/adaptive/clearing/clear_links.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace clearcut::plan::adaptive {
namespace {

/// Number of axis points near each end of a link that are tried as the first and last of its path.
constexpr int kMostAccessNodes = 3;
constexpr double kNoLink = 1e300;
/// Number of bisections that move a corner of a link towards the straight line past it.
constexpr int kCornerHalvings = 4;

/// Bulges of arcs that are tried, and number of bisections towards a flatter one.
constexpr double kBulges[] = {0.2, 0.5, 0.9};
constexpr double kShortestArc = 1e-3;  // mm from end to end
constexpr int kFlatter = 3;

LinkPath straight_moves(const std::vector<Vec2>& stations) {
  LinkPath link;
  for (const Vec2 station : stations) link.push_back({station});
  return link;
}

}  // namespace

ClearLinks::ClearLinks(const MedialAxis& axis, double least, double pitch) {
  for (const AxisPoint& point : axis.points) nodes_.push_back(point.point);
  steps_.resize(nodes_.size());
  for (const AxisEdge& edge : axis.edges) {
    const AxisPoint *a = &axis.points[static_cast<std::size_t>(edge.a)],
                    *b = &axis.points[static_cast<std::size_t>(edge.b)];
    int first = edge.a, last = edge.b;
    if (a->clearance < b->clearance) std::swap(a, b), std::swap(first, last);
    if (a->clearance < least) continue;
    const bool whole = b->clearance >= least;
    const double until = whole ? 1 : (a->clearance - least) / (a->clearance - b->clearance);
    const int parts = static_cast<int>(until * distance(a->point, b->point) / pitch) + 1;
    for (int i = 1; i <= parts; ++i) {
      const int next = whole && i == parts ? last : add_node(lerp(a->point, b->point, until * i / parts));
      join(first, next);
      first = next;
    }
  }
}

int ClearLinks::add_node(Vec2 p) {
  nodes_.push_back(p);
  steps_.emplace_back();
  return static_cast<int>(nodes_.size()) - 1;
}

void ClearLinks::join(int a, int b) {
  steps_[static_cast<std::size_t>(a)].push_back({b});
  steps_[static_cast<std::size_t>(b)].push_back({a});
}

std::optional<LinkPath> ClearLinks::find(Vec2 from, Vec2 to, const RemainingStock& remaining,
                                         double residual) const {
  if (remaining.is_free(from, to, residual)) return LinkPath{{to}};
  if (const auto arc = one_arc(from, to, remaining, residual)) return LinkPath{*arc};
  const auto& sources = sources_of(from, remaining, residual);
  if (sources.empty()) return std::nullopt;
  const auto targets = nearest_free(to, remaining, residual);
  if (targets.empty()) return std::nullopt;
  const auto stations = shortest(sources, targets, from, to, remaining, residual);
  if (stations.empty()) return std::nullopt;
  // Shortens the path: from each point straight to the farthest point that can be reached so.
  std::vector<Vec2> link;
  Vec2 at = from;
  for (std::size_t next = 0; next < stations.size();) {
    std::size_t farthest = next;
    for (std::size_t jump = stations.size() - 1; jump > next; jump = next + (jump - next) / 2) {
      if (!remaining.is_free(at, stations[jump], residual)) continue;
      farthest = jump;
      break;
    }
    link.push_back(at = stations[farthest]);
    next = farthest + 1;
  }
  straighten(link, from, remaining, residual);
  return straight_moves(link);
}

/// The flattest clear arc found.
std::optional<LinkMove> ClearLinks::one_arc(Vec2 from, Vec2 to, const RemainingStock& remaining,
                                            double residual) {
  if (distance(from, to) < kShortestArc) return std::nullopt;
  const auto is_free = [&](double bulge) {
    return remaining.is_free(LinkMove{to, bulge}.edge(from), residual);
  };
  for (const double side : {1.0, -1.0}) {
    double bad = 0;
    for (double good : kBulges) {
      if (!is_free(side * good)) {
        bad = good;
        continue;
      }
      for (int i = 0; i < kFlatter; ++i) {
        const double middle = (good + bad) / 2;
        (is_free(side * middle) ? good : bad) = middle;
      }
      return LinkMove{to, side * good};
    }
  }
  return std::nullopt;
}

/// Moves every corner of a link towards the straight line past it, as far as both sides stay clear.
void ClearLinks::straighten(std::vector<Vec2>& link, Vec2 from, const RemainingStock& remaining,
                            double residual) {
  for (std::size_t i = 0; i + 1 < link.size(); ++i) {
    const Vec2 before = i == 0 ? from : link[i - 1], after = link[i + 1];
    const Vec2 straight = nearest(Edge::line(before, after), link[i]).point;
    double good = 1, bad = 0;
    for (int k = 0; k < kCornerHalvings; ++k) {
      const double share = (good + bad) / 2;
      const Vec2 corner = lerp(straight, link[i], share);
      const bool free =
          remaining.is_free(before, corner, residual) && remaining.is_free(corner, after, residual);
      (free ? good : bad) = share;
    }
    link[i] = lerp(straight, link[i], good);
  }
}

const std::vector<int>& ClearLinks::sources_of(Vec2 from, const RemainingStock& remaining,
                                               double residual) const {
  if (sources_.from != from || sources_.residual != residual)
    sources_ = {from, residual, nearest_free(from, remaining, residual)};
  return sources_.nodes;
}

bool ClearLinks::is_free(const Step& step, Vec2 from, Vec2 to, const RemainingStock& remaining,
                         double residual) {
  if (residual >= step.free_beyond) return true;
  if (!remaining.is_free(from, to, residual)) return false;
  step.free_beyond = residual;
  return true;
}

std::vector<int> ClearLinks::nearest_free(Vec2 p, const RemainingStock& remaining, double residual) const {
  std::vector<std::pair<double, int>> by_distance;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!steps_[i].empty()) by_distance.push_back({distance(nodes_[i], p), static_cast<int>(i)});
  }
  std::sort(by_distance.begin(), by_distance.end());
  std::vector<int> found;
  int visited = 0;
  for (const auto& [far, node] : by_distance) {
    if (static_cast<int>(found.size()) >= kMostAccessNodes || ++visited > 5 * kMostAccessNodes) break;
    if (remaining.is_free(p, nodes_[static_cast<std::size_t>(node)], residual)) found.push_back(node);
  }
  return found;
}

std::vector<Vec2> ClearLinks::shortest(const std::vector<int>& sources, const std::vector<int>& targets,
                                       Vec2 from, Vec2 to, const RemainingStock& remaining,
                                       double residual) const {
  const auto at = [&](int node) { return nodes_[static_cast<std::size_t>(node)]; };
  std::vector<double> cost(nodes_.size(), kNoLink);
  std::vector<int> before(nodes_.size(), -1);
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  for (const int node : sources) {
    cost[static_cast<std::size_t>(node)] = distance(from, at(node));
    open.push({cost[static_cast<std::size_t>(node)], node});
  }
  int end = -1;
  double best = kNoLink;
  while (!open.empty() && open.top().first < best) {
    const auto [spent, node] = open.top();
    open.pop();
    if (spent > cost[static_cast<std::size_t>(node)]) continue;
    if (std::find(targets.begin(), targets.end(), node) != targets.end() &&
        spent + distance(at(node), to) < best) {
      best = spent + distance(at(node), to);
      end = node;
    }
    for (const Step& step : steps_[static_cast<std::size_t>(node)]) {
      const int next = step.to;
      const double sum = spent + distance(at(node), at(next));
      if (sum >= cost[static_cast<std::size_t>(next)] ||
          !is_free(step, at(node), at(next), remaining, residual))
        continue;
      cost[static_cast<std::size_t>(next)] = sum;
      before[static_cast<std::size_t>(next)] = node;
      open.push({sum, next});
    }
  }
  std::vector<Vec2> stations;
  for (int node = end; node >= 0; node = before[static_cast<std::size_t>(node)]) stations.push_back(at(node));
  std::reverse(stations.begin(), stations.end());
  if (end >= 0) stations.push_back(to);
  return stations;
}

}  // namespace clearcut::plan::adaptive
