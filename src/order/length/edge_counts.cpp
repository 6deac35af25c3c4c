#include "order/length/edge_counts.h"

#include <algorithm>

#include "base/elementary.h"

namespace clearcut::order {

void EdgeCounts::add(const Links& tour) {
  for (int v = 0; v < static_cast<int>(tour.size()); ++v) {
    for (const int w : tour[v]) {
      if (v < w) change(v, w, 1);
    }
  }
}

int EdgeCounts::count(int a, int b) const {
  for (const Entry& entry : at_[std::min(a, b)]) {
    if (entry.other == std::max(a, b)) return entry.count;
  }
  return 0;
}

void EdgeCounts::change(int a, int b, int by) {
  auto& entries = at_[std::min(a, b)];
  const int other = std::max(a, b);
  for (Entry& entry : entries) {
    if (entry.other != other) continue;
    entry.count += by;
    if (entry.count == 0) {
      entry = entries.back();
      entries.pop_back();
    }
    return;
  }
  entries.push_back({other, by});
}

void EdgeCounts::apply(const std::vector<EdgeChange>& changes) {
  for (const EdgeChange& c : changes) {
    if (c.added) change(c.a, c.b, 1);
  }
  for (const EdgeChange& c : changes) {
    if (!c.added) change(c.a, c.b, -1);
  }
}

double EdgeCounts::entropy_change(const std::vector<EdgeChange>& changes, int population) const {
  const auto term = [population](int count) {
    return count <= 0 ? 0.0 : -count * base::log(static_cast<double>(count) / population);
  };
  double sum = 0;
  for (const EdgeChange& c : changes) {
    const int now = count(c.a, c.b);
    sum += term(now + (c.added ? 1 : -1)) - term(now);
  }
  return sum;
}

}  // namespace clearcut::order
