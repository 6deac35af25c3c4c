#include "order/length/assembly.h"

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace clearcut::order {

Assembly::Assembly(const LengthModel& model)
    : model_(model),
      position_(static_cast<std::size_t>(model.size())),
      stamp_(static_cast<std::size_t>(model.size()), 0),
      cycles_at_(static_cast<std::size_t>(model.size()), {-1, -1}) {}

void Assembly::set_parent(const Links& a) {
  links_ = a;
  order_ = nodes_of(a);
  for (std::size_t i = 0; i < order_.size(); ++i) position_[order_[i]] = static_cast<int>(i);
}

void Assembly::replace_link(int node, int old_end, int new_end) {
  const int slot = links_[node][0] == old_end ? 0 : 1;
  undo_.push_back({node, slot, links_[node][slot]});
  links_[node][slot] = new_end;
}

void Assembly::restore() {
  for (; !undo_.empty(); undo_.pop_back())
    links_[undo_.back().node][undo_.back().slot] = undo_.back().old_end;
}

/// Takes the A-edges of the chosen cycles out (leaving -1) and puts their B-edges in.
void Assembly::exchange(const AbCycles& cycles, std::span<const int> chosen, Child& child) {
  const int n = static_cast<int>(order_.size());
  child.gain = 0;
  child.changes.clear();
  cuts_.clear();
  for (const int i : chosen) {
    const auto cycle = cycles.cycle(i);
    for (std::size_t k = 0; k < cycle.size(); k += 2) {
      const int a = cycle[k], b = cycle[k + 1];
      child.gain += model_.cost(a, b);
      child.changes.push_back({a, b, false});
      replace_link(a, b, -1);
      replace_link(b, a, -1);
      const int low = std::min(position_[a], position_[b]), high = std::max(position_[a], position_[b]);
      cuts_.push_back(high == low + 1 ? low : n - 1);
    }
  }
  for (const int i : chosen) {
    const auto cycle = cycles.cycle(i);
    for (std::size_t k = 1; k < cycle.size(); k += 2) {
      const int a = cycle[k], b = cycle[k + 1 == cycle.size() ? 0 : k + 1];
      child.gain -= model_.cost(a, b);
      child.changes.push_back({a, b, true});
      replace_link(a, -1, b);
      replace_link(b, -1, a);
    }
  }
}

void Assembly::cut_into_pieces() {
  const int n = static_cast<int>(order_.size());
  std::sort(cuts_.begin(), cuts_.end());
  pieces_.clear();
  // Piece i ends at cut i; the first begins after the last cut, round the end of the array.
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    const int before = i == 0 ? cuts_.back() : cuts_[i - 1];
    pieces_.push_back({before + 1 == n ? 0 : before + 1, cuts_[i], -1});
  }
}

int Assembly::piece_at(int position) const {
  const auto it = std::lower_bound(cuts_.begin(), cuts_.end(), position);
  return it == cuts_.end() ? 0 : static_cast<int>(it - cuts_.begin());
}

int Assembly::piece_of(int node) const {
  return piece_at(position_[node]);
}

void Assembly::find_subtours() {
  const int n = static_cast<int>(order_.size());
  subtour_count_ = 0;
  for (std::size_t start = 0; start < pieces_.size(); ++start) {
    if (pieces_[start].subtour >= 0) continue;
    if (subtour_count_ == static_cast<int>(subtours_.size())) subtours_.emplace_back();
    Subtour& subtour = subtours_[subtour_count_];
    subtour.size = 0;
    subtour.pieces.clear();
    int piece = static_cast<int>(start);
    bool forward = true;
    int came_from = -1;
    while (pieces_[piece].subtour < 0) {
      Piece& p = pieces_[piece];
      p.subtour = subtour_count_;
      const int length = p.last >= p.first ? p.last - p.first + 1 : p.last - p.first + 1 + n;
      subtour.size += length;
      subtour.pieces.push_back(piece);
      const int exit = order_[forward ? p.last : p.first];
      if (length > 1) {
        const int inside = forward ? p.last - 1 : p.first + 1;
        came_from = order_[inside < 0 ? n - 1 : inside == n ? 0 : inside];
      }
      const int next = links_[exit][0] == came_from ? links_[exit][1] : links_[exit][0];
      came_from = exit;
      piece = piece_of(next);
      forward = order_[pieces_[piece].first] == next;
    }
    ++subtour_count_;
  }
}

int Assembly::smallest_subtour() const {
  int best = -1;
  for (int i = 0; i < subtour_count_; ++i) {
    if (subtours_[i].size > 0 && (best < 0 || subtours_[i].size < subtours_[best].size)) best = i;
  }
  return best;
}

/// The cheapest exchange of an edge u-u2 of the subtour and an edge w-w2 outside it for u-w and u2-w2.
Assembly::Join Assembly::best_join(int subtour) {
  const int n = static_cast<int>(order_.size());
  ++stamp_value_;
  const auto each_node = [&](auto&& visit) {
    for (const int piece : subtours_[subtour].pieces) {
      int p = pieces_[piece].first;
      while (true) {
        visit(order_[p]);
        if (p == pieces_[piece].last) break;
        p = p + 1 == n ? 0 : p + 1;
      }
    }
  };
  each_node([&](int u) { stamp_[u] = stamp_value_; });
  Join best;
  best.gain = std::numeric_limits<Cost>::min();
  each_node([&](int u) {
    const auto candidates = model_.candidates(u);
    const auto costs = model_.candidate_costs(u);
    const Cost longer = std::max(model_.cost(u, links_[u][0]), model_.cost(u, links_[u][1]));
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const int w = candidates[i];
      if (stamp_[w] == stamp_value_) continue;
      for (const int w2 : links_[w]) {
        const Cost outside = model_.cost(w, w2) - costs[i];
        if (!model_.has_premium() && outside + longer <= best.gain) continue;  // u2-w2 costs at least 0
        for (const int u2 : links_[u]) {
          const Cost gain = outside + model_.cost(u, u2) - model_.cost(u2, w2);
          if (gain > best.gain) best = {gain, u, u2, w, w2};
        }
      }
    }
  });
  return best;
}

namespace {

/// Notes a change, or strikes out its opposite.
void note(std::vector<EdgeChange>& changes, int a, int b, bool added) {
  for (EdgeChange& c : changes) {
    if (c.added != added && ((c.a == a && c.b == b) || (c.a == b && c.b == a))) {
      c = changes.back();
      changes.pop_back();
      return;
    }
  }
  changes.push_back({a, b, added});
}

}  // namespace

void Assembly::make_join(const Join& join, Child& child) {
  child.gain += join.gain;
  note(child.changes, join.u, join.u2, false);
  note(child.changes, join.w, join.w2, false);
  note(child.changes, join.u, join.w, true);
  note(child.changes, join.u2, join.w2, true);
  replace_link(join.u, join.u2, join.w);
  replace_link(join.u2, join.u, join.w2);
  replace_link(join.w, join.w2, join.u);
  replace_link(join.w2, join.w, join.u2);
  const int from = pieces_[piece_of(join.u)].subtour, into = pieces_[piece_of(join.w)].subtour;
  for (const int piece : subtours_[from].pieces) {
    pieces_[piece].subtour = into;
    subtours_[into].pieces.push_back(piece);
  }
  subtours_[into].size += subtours_[from].size;
  subtours_[from].size = 0;
}

bool Assembly::build(const AbCycles& cycles, std::span<const int> chosen, Child& child) {
  exchange(cycles, chosen, child);
  cut_into_pieces();
  find_subtours();
  bool joined = true;
  for (int left = subtour_count_; left > 1 && joined; --left) {
    const Join join = best_join(smallest_subtour());
    joined = join.u >= 0;
    if (joined) make_join(join, child);
  }
  restore();
  return joined;
}

void Assembly::index_cycles(const AbCycles& cycles) {
  for (const int v : touched_nodes_) cycles_at_[v] = {-1, -1};
  touched_nodes_.clear();
  for (int i = 0; i < cycles.count(); ++i) {
    for (const int v : cycles.cycle(i)) {
      touched_nodes_.push_back(v);
      auto& at = cycles_at_[v];
      if (at[0] == i || at[1] == i) continue;
      (at[0] < 0 ? at[0] : at[1]) = i;
    }
  }
}

void Assembly::block_around(const AbCycles& cycles, int centre, std::vector<int>& chosen) {
  const int n = static_cast<int>(order_.size());
  chosen.assign(1, centre);
  Child unused;
  exchange(cycles, chosen, unused);
  cut_into_pieces();
  find_subtours();
  int largest = 0;
  for (int i = 1; i < subtour_count_; ++i) {
    if (subtours_[i].size > subtours_[largest].size) largest = i;
  }
  for (const Piece& piece : pieces_) {
    if (piece.subtour == largest) continue;
    for (int p = piece.first;; p = p + 1 == n ? 0 : p + 1) {
      for (const int i : cycles_at_[order_[p]]) {
        if (i >= 0 && i != centre && cycles.cycle(i).size() < cycles.cycle(centre).size())
          chosen.push_back(i);
      }
      if (p == piece.last) break;
    }
  }
  std::sort(chosen.begin() + 1, chosen.end());
  chosen.erase(std::unique(chosen.begin() + 1, chosen.end()), chosen.end());
  restore();
}

}  // namespace clearcut::order
