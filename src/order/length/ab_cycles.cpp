#include "order/length/ab_cycles.h"

namespace clearcut::order {

Links links_of(std::span<const int> nodes) {
  Links links(nodes.size());
  const std::size_t n = nodes.size();
  for (std::size_t i = 0; i < n; ++i)
    links[nodes[i]] = {nodes[i == 0 ? n - 1 : i - 1], nodes[i + 1 == n ? 0 : i + 1]};
  return links;
}

std::vector<int> nodes_of(const Links& links) {
  std::vector<int> nodes;
  nodes.reserve(links.size());
  int previous = links[0][0], at = 0;
  do {
    nodes.push_back(at);
    const int next = links[at][0] == previous ? links[at][1] : links[at][0];
    previous = at;
    at = next;
  } while (at != 0);
  return nodes;
}

AbCycles::AbCycles(int nodes)
    : rest_(static_cast<std::size_t>(nodes)), on_path_(static_cast<std::size_t>(nodes), {-1, -1}) {}

void AbCycles::collect(const Links& a, const Links& b) {
  active_.clear();
  for (std::size_t v = 0; v < a.size(); ++v) {
    Rest& rest = rest_[v];
    rest.count = {0, 0};
    for (int i = 0; i < 2; ++i) {
      if (a[v][i] != b[v][0] && a[v][i] != b[v][1]) rest.end[0][rest.count[0]++] = a[v][i];
      if (b[v][i] != a[v][0] && b[v][i] != a[v][1]) rest.end[1][rest.count[1]++] = b[v][i];
    }
    if (rest.count[0] > 0) active_.push_back(static_cast<int>(v));
  }
}

void AbCycles::take_out(int v, int w, int kind) {
  Rest& rest = rest_[v];
  if (rest.end[kind][0] == w) rest.end[kind][0] = rest.end[kind][1];
  --rest.count[kind];
}

int AbCycles::take_edge(int v, int kind, Random& random) {
  const Rest& rest = rest_[v];
  const int which = rest.count[kind] == 2 ? static_cast<int>(random.next() >> 63) : 0;
  const int w = rest.end[kind][which];
  take_out(v, w, kind);
  take_out(w, v, kind);
  return w;
}

/// The path from place `first` to its end has closed: the path becomes a cycle, rotated to begin with an edge of A.
void AbCycles::extract(int first) {
  const int last = static_cast<int>(path_.size()) - 1;  // the same node as `first`
  const int begin = first + first % 2;
  for (int i = begin; i < last; ++i) flat_.push_back(path_[i]);
  if (begin != first) flat_.push_back(path_[first]);
  begins_.push_back(static_cast<int>(flat_.size()));
  for (int i = first + 1; i < last; ++i) on_path_[path_[i]][i % 2] = -1;
  path_.resize(static_cast<std::size_t>(first) + 1);
}

void AbCycles::split(const Links& a, const Links& b, Random& random) {
  collect(a, b);
  flat_.clear();
  begins_.assign(1, 0);
  path_.clear();
  while (true) {
    if (path_.empty()) {
      while (!active_.empty() && rest_[active_.back()].count[0] == 0) active_.pop_back();
      if (active_.empty()) return;
      const auto pick = random.below(active_.size());
      const int v = active_[pick];
      if (rest_[v].count[0] == 0) {
        active_[pick] = active_.back();
        active_.pop_back();
        continue;
      }
      path_.push_back(v);
      on_path_[v][0] = 0;
    }
    const int kind = static_cast<int>(path_.size() + 1) % 2;  // even places leave by A
    const int w = take_edge(path_.back(), kind, random);
    path_.push_back(w);
    const int place = static_cast<int>(path_.size()) - 1;
    const int seen = on_path_[w][place % 2];
    if (seen < 0) {
      on_path_[w][place % 2] = place;
      continue;
    }
    extract(seen);
    if (seen == 0) {
      on_path_[w][0] = -1;
      path_.clear();
    }
  }
}

}  // namespace clearcut::order
