#include "read/repair/duplicates.h"

#include <algorithm>
#include <cmath>

#include "geometry/spatial/cell_grid.h"
#include "read/repair/clean.h"
#include "read/repair/edge_index.h"
#include "read/repair/mends.h"

namespace clearcut::read {
namespace {

constexpr long long kMostTests = 50'000'000;

bool same_edge(const Edge& a, const Edge& b, double gap) {
  const auto near = [gap](Vec2 p, Vec2 q) { return distance(p, q) <= gap; };
  return a.is_arc() == b.is_arc() && near(a.at(0.5), b.at(0.5)) &&
         ((near(a.from, b.from) && near(a.to, b.to)) || (near(a.from, b.to) && near(a.to, b.from)));
}

/// Whether every vertex and middle of `a` is within `gap` of `b`.
bool lies_on(const Loop& a, const std::vector<Loop>& b, double gap) {
  const EdgeIndex index(b);
  const auto is_near = [&](Vec2 p) {
    bool near = false;
    index.visit(Box{p, p}.grown(gap), [&](EdgeId id) {
      near = distance(index.edge(id), p) <= gap;
      return !near;
    });
    return near;
  };
  return std::all_of(a.begin(), a.end(),
                     [&](const Edge& e) { return is_near(e.from) && is_near(e.at(0.5)); });
}

bool same_loop(const Loop& a, const Loop& b, double gap) {
  const double difference = std::abs(std::abs(signed_area(a)) - std::abs(signed_area(b)));
  if (difference > 2 * gap * (length(a) + length(b))) return false;
  const Box one = box(a), other = box(b);
  if (distance(one.max, other.max) > 2 * gap) return false;
  return lies_on(a, {b}, gap) && lies_on(b, {a}, gap);
}

/// Single edges, each a curve.
std::vector<RawCurve> single_edges(const std::vector<RawCurve>& curves) {
  std::vector<RawCurve> edges;
  for (const RawCurve& curve : curves)
    for (const Edge& edge : curve.edges) edges.push_back({{edge}, false, curve.source, curve.compound});
  return edges;
}

std::vector<Loop> edges_as_loops(const std::vector<RawCurve>& curves) {
  std::vector<Loop> loops;
  loops.reserve(curves.size());
  for (const RawCurve& curve : curves) loops.push_back(curve.edges);
  return loops;
}

bool runs_along(const Edge& edge, const Edge& other, double gap) {
  const auto is_near = [&](double t) { return distance(other, edge.at(t)) <= gap; };
  return edge.is_arc() == other.is_arc() && is_near(0) && is_near(0.25) && is_near(0.5) && is_near(0.75) &&
         is_near(1);
}

/// The union of two edges overlapping at an end of each by more than a gap; smaller overlaps are joined elsewhere.
std::optional<Edge> united(const Edge& a, const Edge& b, double gap) {
  if (a.is_arc() != b.is_arc()) return std::nullopt;
  for (const bool a_end : {false, true}) {
    for (const bool b_end : {false, true}) {
      const Vec2 inner_a = a_end ? a.to : a.from, outer_a = a_end ? a.from : a.to;
      const Vec2 inner_b = b_end ? b.to : b.from, outer_b = b_end ? b.from : b.to;
      const bool overlap =
          distance(inner_a, inner_b) > gap && distance(b, inner_a) <= gap && distance(a, inner_b) <= gap;
      if (!overlap) continue;
      const Edge whole = a.is_arc() ? arc_through(outer_a, inner_a, outer_b) : Edge::line(outer_a, outer_b);
      if (runs_along(a, whole, gap) && runs_along(b, whole, gap)) return whole;
    }
  }
  return std::nullopt;
}

/// One round of removing shared parts; to be called until nothing changes. `tests_left` counts down: knots of
/// overlapping edges are no drawing, and are unchanged.
class OverlapRound {
 public:
  OverlapRound(std::vector<RawCurve>& edges, const EdgeIndex& outlines, double gap, Mends& mends,
               long long& tests_left)
      : edges_(edges),
        outlines_(outlines),
        gap_(gap),
        mends_(mends),
        tests_left_(tests_left),
        ends_(gap),
        used_(edges.size()) {}

  bool run() {
    tests_left_ -= static_cast<long long>(edges_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      ends_.add(at(i).from, static_cast<std::uint32_t>(2 * i));
      ends_.add(at(i).to, static_cast<std::uint32_t>(2 * i + 1));
    }
    const std::vector<Loop> loops = edges_as_loops(edges_);
    const EdgeIndex index(loops);
    bool changed = false;
    for (std::size_t i = 0; i < edges_.size() && tests_left_ > 0; ++i) {
      if (used_[i] || !(dangles(at(i).from) || dangles(at(i).to))) continue;
      changed = on_outline(i) || on_another(i, index) || changed;
    }
    apply();
    return changed;
  }

 private:
  const Edge& at(std::size_t i) const { return edges_[i].edges.front(); }

  void apply() {
    for (const auto& [i, edge] : replaced_) edges_[i].edges = {edge};
    for (const std::size_t i : dropped_) edges_[i].edges.clear();
    std::erase_if(edges_, [](const RawCurve& curve) { return curve.edges.empty(); });
  }

  bool dangles(Vec2 end) const {
    int count = 0;
    for (const std::uint32_t other : ends_.near(end)) {
      const Edge& edge = at(other / 2);
      count += distance(other % 2 == 0 ? edge.from : edge.to, end) <= gap_ ? 1 : 0;
    }
    return count % 2 == 1;
  }

  void drop(std::size_t i, double shared) {
    mends_.add(at(i).from, shared);
    dropped_.push_back(i);
    used_[i] = true;
  }

  bool on_outline(std::size_t i) {
    bool found = false;
    outlines_.visit(at(i).box().grown(gap_), [&](EdgeId id) {
      found = runs_along(at(i), outlines_.edge(id), gap_);
      return !found && --tests_left_ > 0;
    });
    if (found) drop(i, at(i).length());
    return found;
  }

  bool on_another(std::size_t i, const EdgeIndex& index) {
    int other = -1;
    std::optional<Edge> whole;
    index.visit(at(i).box().grown(gap_), [&](EdgeId id) {
      const auto j = static_cast<std::size_t>(id.loop);
      if (j == i || used_[j]) return --tests_left_ > 0;
      if (runs_along(at(i), at(j), gap_)) {
        whole = at(j);
      } else if (runs_along(at(j), at(i), gap_)) {
        whole = at(i);
      } else {
        whole = united(at(i), at(j), gap_);
      }
      if (whole) other = id.loop;
      return other < 0 && --tests_left_ > 0;
    });
    if (other < 0) return false;
    const auto j = static_cast<std::size_t>(other);
    drop(i, at(i).length() + at(j).length() - whole->length());
    used_[j] = true;
    replaced_.emplace_back(j, *whole);
    return true;
  }

  std::vector<RawCurve>& edges_;
  const EdgeIndex& outlines_;
  double gap_;
  Mends& mends_;
  long long& tests_left_;
  BoxIndex ends_;
  std::vector<bool> used_;
  std::vector<std::size_t> dropped_;
  std::vector<std::pair<std::size_t, Edge>> replaced_;
};

}  // namespace

std::optional<std::vector<RawCurve>> without_overlaps(const std::vector<RawCurve>& curves,
                                                      const std::vector<RawLoop>& loops, double gap,
                                                      const std::string& where, Diagnostics& diagnostics) {
  Mends shared("curves that run along each other count once: length");
  std::vector<Loop> outlines;
  for (const RawLoop& loop : loops) outlines.push_back(loop.loop);
  const EdgeIndex index(outlines);
  std::vector<RawCurve> edges = single_edges(curves);
  long long tests_left = kMostTests;
  while (OverlapRound(edges, index, gap, shared, tests_left).run()) {
  }
  if (shared.empty()) return std::nullopt;
  shared.report(where, diagnostics);
  return edges;
}

std::vector<RawCurve> without_double_curves(std::vector<RawCurve> curves, double gap,
                                            const std::string& where, Diagnostics& diagnostics) {
  Mends doubles("a curve drawn twice counts once: length");
  BoxIndex index(gap);
  std::vector<RawCurve> kept;
  for (RawCurve& curve : curves) {
    const Edge& edge = curve.edges.front();
    const bool single = curve.edges.size() == 1 && edge.length() > 3 * gap;
    bool doubled = false;
    if (single) {
      for (const std::uint32_t i : index.near(edge.at(0.5)))
        doubled = doubled || same_edge(edge, kept[i].edges.front(), gap);
    }
    if (doubled) {
      doubles.add(edge.from, edge.length());
      continue;
    }
    if (single) index.add(edge.at(0.5), static_cast<std::uint32_t>(kept.size()));
    kept.push_back(std::move(curve));
  }
  doubles.report(where, diagnostics);
  return kept;
}

std::vector<RawLoop> without_double_loops(std::vector<RawLoop> loops, double gap, const std::string& where,
                                          Diagnostics& diagnostics) {
  Mends doubles("an outline drawn twice counts once: length");
  BoxIndex index(2 * gap);
  std::vector<RawLoop> kept;
  for (RawLoop& raw : loops) {
    const Vec2 corner = box(raw.loop).min;
    bool doubled = false;
    for (const std::uint32_t i : index.near(corner))
      doubled = doubled || same_loop(raw.loop, kept[i].loop, gap);
    if (doubled) {
      doubles.add(raw.loop.front().from, length(raw.loop));
      continue;
    }
    index.add(corner, static_cast<std::uint32_t>(kept.size()));
    kept.push_back(std::move(raw));
  }
  doubles.report(where, diagnostics);
  return kept;
}

}  // namespace clearcut::read
