// symbol     here              what
// pi_v       degree_price_     multiplier of "v has two edges"
// mu_v       row_share_        share of v's turn assigned to its row, 0..1; the rest to its column
// x_e        taken             whether an edge is used
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "order/bounds/bounds.h"

namespace clearcut::order {

namespace {

constexpr int kRow = 0, kColumn = 1;

class RunCover {
 public:
  RunCover(const Lattice& lattice, bool closed)
      : closed_(closed),
        degree_price_(static_cast<std::size_t>(lattice.size()), 0.1),
        row_share_(static_cast<std::size_t>(lattice.size()), 0.5),
        degree_(static_cast<std::size_t>(lattice.size())),
        turned_{std::vector<int>(static_cast<std::size_t>(lattice.size())),
                std::vector<int>(static_cast<std::size_t>(lattice.size()))} {
    for (const int kind : {kRow, kColumn}) find_strips(lattice, kind);
  }

  double ascend(int iterations) {
    constexpr int kPatience = 20;
    double best = 0, step_share = 1;
    int idle = 0;
    for (int i = 0; i < iterations && step_share > 1e-3; ++i) {
      const double bound = evaluate();
      idle = bound > best + 1e-3 ? 0 : idle + 1;
      best = std::max(best, bound);
      if (idle == kPatience) step_share /= 2, idle = 0;
      move(step_share * (best + std::max(1.0, 0.05 * best) - bound));
    }
    return best;
  }

 private:
  void find_strips(const Lattice& lattice, int kind) {
    const int lines = kind == kRow ? lattice.rows() : lattice.columns();
    const int places = kind == kRow ? lattice.columns() : lattice.rows();
    for (int line = 0; line < lines; ++line) {
      bool open = false;
      for (int i = 0; i < places; ++i) {
        const int v = kind == kRow ? lattice.at(i, line) : lattice.at(line, i);
        if (v >= 0 && !open) strips_[kind].emplace_back();
        if (v >= 0) strips_[kind].back().push_back(v);
        open = v >= 0;
      }
    }
  }
  double turn_price(int v, int kind) const {
    return kind == kRow ? row_share_[static_cast<std::size_t>(v)]
                        : 1 - row_share_[static_cast<std::size_t>(v)];
  }

  /// The relaxed minimum under the present multipliers; leaves degrees and turns behind.
  double evaluate() {
    std::fill(degree_.begin(), degree_.end(), 0);
    double value = 0;
    for (const double price : degree_price_) value += 2 * price;
    for (const int kind : {kRow, kColumn}) {
      std::fill(turned_[kind].begin(), turned_[kind].end(), 0);
      for (const auto& strip : strips_[kind]) value += cheapest(strip, kind);
    }
    if (!closed_) value -= free_ends();
    return value;
  }

  /// The best choice of a strip's edges: two states at each edge, and backtracking.
  double cheapest(const std::vector<int>& strip, int kind) {
    const std::size_t edges = strip.size() - 1;
    cost_ = {0, kNever};
    came_.assign(edges, {});
    for (std::size_t i = 0; i < edges; ++i) {
      const double turn = turn_price(strip[i], kind);
      const double price = degree_price_[static_cast<std::size_t>(strip[i])] +
                           degree_price_[static_cast<std::size_t>(strip[i + 1])];
      std::array<double, 2> next{};
      for (const int taken : {0, 1}) {
        const double stay = cost_[static_cast<std::size_t>(taken)];
        const double change = cost_[static_cast<std::size_t>(1 - taken)] + turn;
        came_[i][static_cast<std::size_t>(taken)] = stay <= change ? taken : 1 - taken;
        next[static_cast<std::size_t>(taken)] = std::min(stay, change) - (taken == 1 ? price : 0);
      }
      cost_ = next;
    }
    const double taken_last = cost_[1] + turn_price(strip.back(), kind);
    mark(strip, kind, taken_last < cost_[0] ? 1 : 0);
    return std::min(cost_[0], taken_last);
  }

  void mark(const std::vector<int>& strip, int kind, int last) {
    int after = 0;
    for (std::size_t i = strip.size() - 1; i-- > 0;) {
      const int taken = i + 2 == strip.size() ? last : came_[i + 1][static_cast<std::size_t>(after)];
      degree_[static_cast<std::size_t>(strip[i])] += taken;
      degree_[static_cast<std::size_t>(strip[i + 1])] += taken;
      turned_[kind][static_cast<std::size_t>(strip[i + 1])] = taken != after ? 1 : 0;
      after = taken;
    }
    turned_[kind][static_cast<std::size_t>(strip.front())] = after;
  }

  /// Greatest saving by the two ends of a path, at any points: an edge and a turn each.
  double free_ends() {
    double sum = 0;
    ends_ = {-1, -1};
    for (int& end : ends_) {
      double most = -kNever;
      for (int v = 0; v < static_cast<int>(degree_.size()); ++v) {
        if (v != ends_[0] && spared(v) > most) most = spared(v), end = v;
      }
      sum += end < 0 ? 0 : most;
    }
    return sum;
  }
  double spared(int v) const {
    return degree_price_[static_cast<std::size_t>(v)] + std::max(turn_price(v, kRow), turn_price(v, kColumn));
  }

  /// Along the subgradient, as far as closes a gap of `wanted`.
  void move(double wanted) {
    std::vector<double> degree_slope(degree_.size()), share_slope(degree_.size());
    double norm = 0;
    for (std::size_t v = 0; v < degree_.size(); ++v) {
      const bool is_end = static_cast<int>(v) == ends_[0] || static_cast<int>(v) == ends_[1];
      degree_slope[v] = 2 - degree_[v] - (is_end ? 1 : 0);
      share_slope[v] = turned_[kRow][v] - turned_[kColumn][v];
      if (is_end) share_slope[v] -= row_share_[v] > 0.5 ? 1 : -1;
      norm += degree_slope[v] * degree_slope[v] + share_slope[v] * share_slope[v];
    }
    if (norm == 0) return;
    const double step = wanted / norm;
    for (std::size_t v = 0; v < degree_.size(); ++v) {
      degree_price_[v] += step * degree_slope[v];
      row_share_[v] = std::clamp(row_share_[v] + step * share_slope[v], 0.0, 1.0);
    }
  }

  static constexpr double kNever = 1e18;
  bool closed_;
  std::array<std::vector<std::vector<int>>, 2> strips_;  ///< points of maximal rows and columns, in order
  std::vector<double> degree_price_, row_share_;
  std::vector<int> degree_;
  std::array<std::vector<int>, 2> turned_;
  std::array<int, 2> ends_{-1, -1};
  std::array<double, 2> cost_{};
  std::vector<std::array<int, 2>> came_;
};

}  // namespace

int run_cover_bound(const Lattice& lattice, bool closed) {
  constexpr int kMostPoints = 20000, kPointsSeen = 1000000;
  const int n = lattice.size();
  if (n < 3 || n > kMostPoints) return 0;
  const double bound = RunCover(lattice, closed).ascend(std::clamp(kPointsSeen / n, 100, 2000));
  return std::max(0, static_cast<int>(std::ceil(bound - 1e-6)));
}

}  // namespace clearcut::order
