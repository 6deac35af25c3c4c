#include "read/repair/duplicates.h"

#include <algorithm>
#include <cmath>

#include "read/repair/edge_index.h"
#include "read/repair/mends.h"
#include "read/repair/near_grid.h"

namespace clearcut {
namespace {

bool same_edge(const Edge& a, const Edge& b, double gap) {
  const auto near = [gap](Vec2 p, Vec2 q) { return distance(p, q) <= gap; };
  return a.is_arc() == b.is_arc() && near(a.at(0.5), b.at(0.5)) &&
         ((near(a.from, b.from) && near(a.to, b.to)) || (near(a.from, b.to) && near(a.to, b.from)));
}

/// Every vertex and middle of `a` lies within `gap` of `b`.
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

}  // namespace

std::vector<RawCurve> without_double_curves(std::vector<RawCurve> curves, double gap,
                                            const std::string& where, Diagnostics& diagnostics) {
  Mends doubles("a curve drawn twice counts once: length");
  NearGrid grid(gap);
  std::vector<RawCurve> kept;
  for (RawCurve& curve : curves) {
    const Edge& edge = curve.edges.front();
    const bool single = curve.edges.size() == 1 && edge.length() > 3 * gap;
    bool doubled = false;
    if (single) {
      grid.for_near(edge.at(0.5), [&](int i) {
        doubled = doubled || same_edge(edge, kept[static_cast<std::size_t>(i)].edges.front(), gap);
      });
    }
    if (doubled) {
      doubles.add(edge.from, edge.length());
      continue;
    }
    if (single) grid.add(edge.at(0.5), static_cast<int>(kept.size()));
    kept.push_back(std::move(curve));
  }
  doubles.report(where, diagnostics);
  return kept;
}

std::vector<RawLoop> without_double_loops(std::vector<RawLoop> loops, double gap, const std::string& where,
                                          Diagnostics& diagnostics) {
  Mends doubles("an outline drawn twice counts once: length");
  NearGrid grid(2 * gap);
  std::vector<RawLoop> kept;
  for (RawLoop& raw : loops) {
    const Vec2 corner = box(raw.loop).min;
    bool doubled = false;
    grid.for_near(corner, [&](int i) {
      doubled = doubled || same_loop(raw.loop, kept[static_cast<std::size_t>(i)].loop, gap);
    });
    if (doubled) {
      doubles.add(raw.loop.front().from, length(raw.loop));
      continue;
    }
    grid.add(corner, static_cast<int>(kept.size()));
    kept.push_back(std::move(raw));
  }
  doubles.report(where, diagnostics);
  return kept;
}

}  // namespace clearcut
