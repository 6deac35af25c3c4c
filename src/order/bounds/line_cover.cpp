// symbol     here             what
// w_v        weight_          weight of a point
// M1, M2     Heaviest         weight of the heaviest line, and of the heaviest of another direction
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "base/elementary.h"
#include "order/bounds/bounds.h"

namespace clearcut::order {

namespace {

/// Legality is tested for moves up to this many columns and rows; longer moves count as legal, and this only weakens
/// the bound.
constexpr int kAskedReach = 2;
constexpr long long kMembersSeen = 40'000'000;
constexpr long long kMostMembers = 400'000;

struct Heaviest {
  double first = 0, second = 0;  ///< weights of two directions
  void add(double weight) {
    if (weight > first) {
      second = first;
      first = weight;
    } else {
      second = std::max(second, weight);
    }
  }
};

class LineCover {
 public:
  LineCover(const Lattice& lattice, const std::function<bool(int, int)>& is_legal)
      : lattice_(lattice),
        is_legal_(is_legal),
        weight_(static_cast<std::size_t>(lattice.size()), 1.0),
        load_(weight_.size()) {
    find_lines();
  }

  /// The largest bound of R found.
  double ascend(bool closed) {
    const auto members = std::max<long long>(1, static_cast<long long>(members_.size()));
    const int iterations = static_cast<int>(std::clamp(kMembersSeen / members, 30LL, 1500LL));
    double best = 0;
    for (int i = 0; i < iterations; ++i) {
      best = std::max(best, pieces(closed));
      lighten(3.0 / (1 + 0.02 * i), 40.0 + 0.3 * i);
    }
    return best;
  }

 private:
  struct Line {
    std::size_t first = 0, end = 0;  ///< range of members_
  };
  struct Direction {
    std::size_t first = 0, end = 0;  ///< range of lines_
  };

  void find_lines() {
    const int longest = std::max(lattice_.columns(), lattice_.rows());
    int reach = 1;
    add_direction(1, 0);
    add_direction(0, 1);
    add_direction(1, 1);
    add_direction(1, -1);
    for (; reach + 1 < longest; ++reach) {
      const int far = reach + 1;
      const long long wanted = 4LL * far * lattice_.size();
      if (static_cast<long long>(members_.size()) + wanted > kMostMembers) break;
      for (int other = 1; other < far; ++other) {
        if (std::gcd(far, other) > 1) continue;
        for (const int sign : {1, -1}) add_direction(far, sign * other), add_direction(other, sign * far);
      }
    }
    left_out_ = std::max(reach + 1 < longest ? (longest - 1) / (reach + 1) + 1 : 0, most_on_bent());
  }

  /// Bends below the threshold are no turns. Two directions p, q of a lattice are at least 1 / (|p| |q|) apart, so
  /// |p| |q| > 572 if a piece bends. Among D pitches this leaves D / sqrt 572 points with long steps, and x (D - x) /
  /// 572 on x pitches with shorter steps, since those need a step of 572 / |p| beside them.
  int most_on_bent() const {
    constexpr double kProduct = 572;  // 1 / 0.1 degrees
    const double across = base::hypot(lattice_.columns() - 1, lattice_.rows() - 1);
    if (across * across < kProduct) return 0;
    return static_cast<int>(across / std::sqrt(kProduct) + across * across / (4 * kProduct)) + 2;
  }

  void add_direction(int dx, int dy) {
    Direction direction{lines_.size(), 0};
    for (int v = 0; v < lattice_.size(); ++v) {
      if (!begins(v, dx, dy)) continue;
      const std::size_t first = members_.size();
      for (int at = v; at >= 0; at = next(at, dx, dy)) members_.push_back(at);
      lines_.push_back({first, members_.size()});
    }
    direction.end = lines_.size();
    directions_.push_back(direction);
  }
  /// The next point in this direction, across holes if the straight move is legal; -1 for none.
  int next(int v, int dx, int dy) const {
    int column = lattice_.column_of(v) + dx, row = lattice_.row_of(v) + dy;
    while (column >= 0 && row >= 0 && column < lattice_.columns() && row < lattice_.rows()) {
      const int w = lattice_.at(column, row);
      if (w >= 0) return joins(v, w) ? w : -1;
      column += dx, row += dy;
    }
    return -1;
  }
  bool begins(int v, int dx, int dy) const { return next(v, -dx, -dy) < 0; }
  bool joins(int v, int w) const {
    const int dx = std::abs(lattice_.column_of(v) - lattice_.column_of(w));
    const int dy = std::abs(lattice_.row_of(v) - lattice_.row_of(w));
    const int reach = std::max(dx, dy) / std::max(1, std::gcd(dx, dy));
    return reach > kAskedReach || is_legal_(std::min(v, w), std::max(v, w));
  }

  double weight_of(const Line& line) const {
    double sum = 0;
    for (std::size_t i = line.first; i < line.end; ++i) sum += weight_[static_cast<std::size_t>(members_[i])];
    return sum;
  }

  /// R by the present weights; leaves the weights of all lines behind.
  double pieces(bool closed) {
    Heaviest heaviest;
    line_weight_.resize(lines_.size());
    direction_weight_.assign(directions_.size(), 0);
    for (std::size_t d = 0; d < directions_.size(); ++d) {
      for (std::size_t l = directions_[d].first; l < directions_[d].end; ++l) {
        line_weight_[l] = weight_of(lines_[l]);
        direction_weight_[d] = std::max(direction_weight_[d], line_weight_[l]);
      }
      heaviest.add(direction_weight_[d]);
    }
    heaviest.add(heaviest_left_out());
    heaviest.add(heaviest_left_out());
    heaviest_ = heaviest.first;
    const double total = std::accumulate(weight_.begin(), weight_.end(), 0.0);
    const double ends = closed ? 0 : heaviest.first - heaviest.second;
    return (2 * total - ends) / (heaviest.first + heaviest.second);
  }
  /// Weight of pieces on no listed line; two may follow each other.
  double heaviest_left_out() const {
    if (left_out_ == 0) return 0;
    std::vector<double> sorted = weight_;
    const auto count = std::min(sorted.size(), static_cast<std::size_t>(left_out_));
    std::partial_sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count), sorted.end(),
                      std::greater<>());
    return std::accumulate(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count), 0.0);
  }

  /// Points on heavy lines lose weight, the more the heavier; no direction counts for more than half.
  void lighten(double step, double sharpness) {
    std::fill(load_.begin(), load_.end(), 0.0);
    std::vector<double> share(lines_.size()), sum(directions_.size(), 0.0);
    for (std::size_t d = 0; d < directions_.size(); ++d) {
      for (std::size_t l = directions_[d].first; l < directions_[d].end; ++l)
        sum[d] += share[l] = base::exp(sharpness * (line_weight_[l] / heaviest_ - 1));
    }
    const double total = std::accumulate(sum.begin(), sum.end(), 0.0);
    for (std::size_t d = 0; d < directions_.size(); ++d) {
      const double scale = 1 / std::max({total, 2 * sum[d], 1e-300});
      for (std::size_t l = directions_[d].first; l < directions_[d].end; ++l) {
        for (std::size_t i = lines_[l].first; i < lines_[l].end; ++i)
          load_[static_cast<std::size_t>(members_[i])] += share[l] * scale;
      }
    }
    const double most = *std::max_element(load_.begin(), load_.end());
    if (most <= 0) return;
    double largest = 0;
    for (std::size_t v = 0; v < weight_.size(); ++v) {
      weight_[v] *= base::exp(-0.1 * step * load_[v] / most);
      largest = std::max(largest, weight_[v]);
    }
    for (double& weight : weight_) weight /= largest;
  }

  const Lattice& lattice_;
  const std::function<bool(int, int)>& is_legal_;
  std::vector<int> members_;
  std::vector<Line> lines_;
  std::vector<Direction> directions_;
  std::vector<double> weight_, load_, line_weight_, direction_weight_;
  double heaviest_ = 1;
  int left_out_ = 0;  ///< greatest number of points of a piece on no listed line; 0: there are none
};

}  // namespace

int line_cover_bound(const Lattice& lattice, bool closed, const std::function<bool(int, int)>& is_legal) {
  constexpr int kMostPoints = 20000;
  if (lattice.size() < 3 || lattice.size() > kMostPoints) return 0;
  const int pieces = static_cast<int>(std::ceil(LineCover(lattice, is_legal).ascend(closed) - 1e-6));
  return std::max(0, closed ? pieces : pieces - 1);
}

}  // namespace clearcut::order
