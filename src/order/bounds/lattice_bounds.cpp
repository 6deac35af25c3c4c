#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "order/bounds/bounds.h"

namespace clearcut::order {

double lattice_length_bound(const Lattice& lattice, bool closed) {
  const int n = lattice.size();
  if (n < 2) return 0;
  int balance = 0;
  for (int v = 0; v < n; ++v) balance += (lattice.column_of(v) + lattice.row_of(v)) % 2 == 0 ? 1 : -1;
  // A walk alternating colours has |B - W| <= 1 (closed: 0); each other step is at least a diagonal.
  const int diagonals = closed ? std::abs(balance) : std::max(0, std::abs(balance) - 1);
  const int steps = closed ? n : n - 1;
  return (steps + diagonals * (std::sqrt(2.0) - 1)) * lattice.pitch();
}

int lattice_turns_bound_any_moves(const Lattice& lattice, bool closed) {
  const int longest = std::max(lattice.columns(), lattice.rows());
  const int n = lattice.size();
  if (n < 3 || longest < 2) return 0;
  const int runs = (n - 1 + longest - 2) / (longest - 1);
  return closed ? std::max(2, runs) : runs - 1;
}

namespace {

/// Maximal horizontal and vertical strips; each point is in one of either kind.
struct Strips {
  /// By kind (0 horizontal) and strip: the crossing strips of the other kind.
  std::vector<std::vector<int>> crossing[2];
};

Strips strips_of(const Lattice& lattice) {
  std::vector<int> strip_of[2];
  int count[2] = {0, 0};
  for (int kind = 0; kind < 2; ++kind) {
    strip_of[kind].assign(static_cast<std::size_t>(lattice.size()), -1);
    const int lines = kind == 0 ? lattice.rows() : lattice.columns();
    const int places = kind == 0 ? lattice.columns() : lattice.rows();
    for (int line = 0; line < lines; ++line) {
      bool open = false;
      for (int i = 0; i < places; ++i) {
        const int v = kind == 0 ? lattice.at(i, line) : lattice.at(line, i);
        if (v >= 0) strip_of[kind][v] = open ? count[kind] - 1 : count[kind]++;
        open = v >= 0;
      }
    }
  }
  Strips strips;
  for (int kind = 0; kind < 2; ++kind) {
    strips.crossing[kind].resize(static_cast<std::size_t>(count[kind]));
    for (int v = 0; v < lattice.size(); ++v)
      strips.crossing[kind][strip_of[kind][v]].push_back(strip_of[1 - kind][v]);
  }
  return strips;
}

/// The smallest max(h, v) and the smallest h + v over covers of all points by h horizontal and v vertical
/// strips: by branching on a strip (in, or out: out forces all crossing strips in). Remains a lower bound if the
/// branching is stopped early.
class Covers {
 public:
  explicit Covers(const Strips& strips) : strips_(strips) {
    for (int kind = 0; kind < 2; ++kind) state_[kind].assign(strips.crossing[kind].size(), kOpen);
  }
  /// Lower bound of max(h, v).
  int smallest_larger() {
    best_ = static_cast<int>(std::min(state_[0].size(), state_[1].size()));
    return explore(kBranches);
  }
  /// Size of the smallest cover: the largest matching of the points (König).
  int smallest_sum() { return matching(); }

 private:
  enum State : char { kOpen, kIn, kOut };
  static constexpr int kBranches = 400;

  int explore(int branches) {
    const int bound = std::max({in_[0], in_[1], (in_[0] + in_[1] + matching() + 1) / 2});
    if (bound >= best_) return best_;
    const auto [kind, strip] = widest();
    if (strip < 0) return best_ = bound;
    if (branches_ >= branches) return bound;
    ++branches_;
    const auto in_before = in_[kind];
    set(kind, strip, kIn);
    const int with = explore(branches);
    set(kind, strip, kOpen);
    in_[kind] = in_before;

    const auto saved = state_[1 - kind];
    const int others_before = in_[1 - kind];
    set(kind, strip, kOut);
    for (const int other : strips_.crossing[kind][strip]) {
      if (state_[1 - kind][other] == kOpen) set(1 - kind, other, kIn);
    }
    const int without = explore(branches);
    set(kind, strip, kOpen);
    state_[1 - kind] = saved;
    in_[1 - kind] = others_before;
    return std::min(with, without);
  }
  void set(int kind, int strip, State state) {
    state_[kind][strip] = state;
    if (state == kIn) ++in_[kind];
  }
  int open_crossings(int kind, int strip) const {
    return static_cast<int>(std::count_if(strips_.crossing[kind][strip].begin(),
                                          strips_.crossing[kind][strip].end(),
                                          [&](int other) { return state_[1 - kind][other] == kOpen; }));
  }
  /// The open strip crossing the most open strips; -1 if every point is covered.
  std::pair<int, int> widest() const {
    std::pair<int, int> best{0, -1};
    int most = 0;
    for (int kind = 0; kind < 2; ++kind) {
      for (int s = 0; s < static_cast<int>(state_[kind].size()); ++s) {
        if (state_[kind][s] != kOpen) continue;
        const int crossings = open_crossings(kind, s);
        if (crossings > most) {
          most = crossings;
          best = {kind, s};
        }
      }
    }
    return best;
  }
  /// Largest matching among open strips (augmenting paths).
  int matching() {
    match_.assign(state_[1].size(), -1);
    int size = 0;
    for (int s = 0; s < static_cast<int>(state_[0].size()); ++s) {
      if (state_[0][s] != kOpen) continue;
      seen_.assign(state_[1].size(), 0);
      size += augment(s) ? 1 : 0;
    }
    return size;
  }
  bool augment(int s) {
    for (const int other : strips_.crossing[0][s]) {
      if (state_[1][other] != kOpen || seen_[other]) continue;
      seen_[other] = 1;
      if (match_[other] < 0 || augment(match_[other])) {
        match_[other] = s;
        return true;
      }
    }
    return false;
  }

  const Strips& strips_;
  std::vector<State> state_[2];
  int in_[2] = {0, 0};
  int best_ = 0;
  int branches_ = 0;
  std::vector<int> match_;
  std::vector<char> seen_;
};

}  // namespace

int lattice_turns_bound(const Lattice& lattice, bool closed) {
  if (lattice.size() < 3) return 0;
  const Strips strips = strips_of(lattice);
  Covers covers(strips);
  const int sum = covers.smallest_sum();
  const int larger = covers.smallest_larger();
  return closed ? std::max({2 * larger, sum, 0}) : std::max({2 * larger - 2, sum - 1, 0});
}

}  // namespace clearcut::order
