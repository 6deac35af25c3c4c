#include "order/lattice.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "geometry/box.h"

namespace clearcut::order {

namespace {

constexpr int kLargestSide = 10000;

int take_side(std::string_view text) {
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  return error == std::errc() && end == text.data() + text.size() && side >= 1 && side <= kLargestSide ? side
                                                                                                       : 0;
}

/// Smallest difference above `same` between sorted values; infinity when all are equal.
double smallest_step(std::vector<double> values, double same) {
  std::sort(values.begin(), values.end());
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double d = values[i] - values[i - 1];
    if (d > same) step = std::min(step, d);
  }
  return step;
}

/// Whole number of steps, or -1 if `value` is between two crossings.
int whole_steps(double value, double pitch) {
  const double steps = value / pitch;
  const double whole = std::round(steps);
  return std::abs(steps - whole) <= 1e-6 && whole < 1e9 ? static_cast<int>(whole) : -1;
}

}  // namespace

Problem lattice_problem(int columns, int rows, double pitch) {
  if (columns < 1 || rows < 1 || !(pitch > 0)) {
    throw InputError("lattice", "needs at least one column, one row and a pitch above 0");
  }
  Problem problem;
  problem.name = std::to_string(columns) + "x" + std::to_string(rows);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) problem.points.push_back({column * pitch, row * pitch});
  }
  return problem;
}

std::optional<LatticeSize> parse_lattice(std::string_view text) {
  const auto cross_sign = text.find('x');
  if (cross_sign == std::string_view::npos) return std::nullopt;
  const LatticeSize size{take_side(text.substr(0, cross_sign)), take_side(text.substr(cross_sign + 1))};
  if (size.columns == 0 || size.rows == 0) return std::nullopt;
  return size;
}

bool is_like_lattice(std::string_view text) {
  return text.size() > 1 && std::count(text.begin(), text.end(), 'x') == 1 &&
         text.find_first_not_of("0123456789x") == std::string_view::npos;
}

std::optional<Lattice> Lattice::recognise(const std::vector<Vec2>& points) {
  if (points.empty()) return std::nullopt;
  Box box;
  std::vector<double> xs, ys;
  for (const Vec2 p : points) {
    box.add(p);
    xs.push_back(p.x);
    ys.push_back(p.y);
  }
  const double same = 1e-9 * std::max(box.width(), box.height());
  Lattice lattice;
  lattice.pitch_ = std::min(smallest_step(std::move(xs), same), smallest_step(std::move(ys), same));
  if (!std::isfinite(lattice.pitch_)) lattice.pitch_ = 1;
  const double columns = box.width() / lattice.pitch_ + 1, rows = box.height() / lattice.pitch_ + 1;
  if (columns * rows > 16.0 * static_cast<double>(points.size()) + 1000) return std::nullopt;
  lattice.columns_ = static_cast<int>(std::lround(columns));
  lattice.rows_ = static_cast<int>(std::lround(rows));
  lattice.point_.assign(static_cast<std::size_t>(lattice.columns_) * lattice.rows_, -1);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const int column = whole_steps(points[v].x - box.min.x, lattice.pitch_);
    const int row = whole_steps(points[v].y - box.min.y, lattice.pitch_);
    if (column < 0 || row < 0) return std::nullopt;
    int& place = lattice.point_[static_cast<std::size_t>(row) * lattice.columns_ + column];
    if (place != -1) return std::nullopt;
    place = static_cast<int>(v);
    lattice.column_.push_back(column);
    lattice.row_.push_back(row);
  }
  return lattice;
}

namespace {

/// A lattice seen turned or mirrored, so that each construction is written only once.
class View {
 public:
  View(const Lattice& lattice, bool transposed, bool flip_columns, bool flip_rows)
      : lattice_(lattice), transposed_(transposed), flip_columns_(flip_columns), flip_rows_(flip_rows) {}
  int columns() const { return transposed_ ? lattice_.rows() : lattice_.columns(); }
  int rows() const { return transposed_ ? lattice_.columns() : lattice_.rows(); }
  int at(int column, int row) const {
    if (flip_columns_) column = columns() - 1 - column;
    if (flip_rows_) row = rows() - 1 - row;
    return transposed_ ? lattice_.at(row, column) : lattice_.at(column, row);
  }

 private:
  const Lattice& lattice_;
  bool transposed_, flip_columns_, flip_rows_;
};

Tour boustrophedon(const View& view) {
  Tour tour;
  for (int row = 0; row < view.rows(); ++row) {
    for (int i = 0; i < view.columns(); ++i) {
      const int v = view.at(row % 2 == 0 ? i : view.columns() - 1 - i, row);
      if (v >= 0) tour.push_back(v);
    }
  }
  return tour;
}

Tour spiral(const View& view) {
  Tour tour;
  const auto add = [&](int column, int row) {
    const int v = view.at(column, row);
    if (v >= 0) tour.push_back(v);
  };
  int left = 0, bottom = 0, right = view.columns() - 1, top = view.rows() - 1;
  while (left <= right && bottom <= top) {
    for (int c = left; c <= right; ++c) add(c, bottom);
    for (int r = bottom + 1; r <= top; ++r) add(right, r);
    if (top > bottom) {
      for (int c = right - 1; c >= left; --c) add(c, top);
    }
    if (right > left) {
      for (int r = top - 1; r > bottom; --r) add(left, r);
    }
    ++left, ++bottom, --right, --top;
  }
  return tour;
}

/// Closed tour: along row 0, back through teeth of columns. With an odd number of columns the last three
/// are closed by two-point rows and one diagonal move (length nm - 1 + sqrt 2 when both sides are odd).
Tour comb(const View& view) {
  Tour tour;
  const int columns = view.columns(), rows = view.rows();
  for (int c = 0; c < columns; ++c) tour.push_back(view.at(c, 0));
  const int teeth_end = columns % 2 == 0 ? 0 : 2;
  bool up = true;
  for (int c = columns - 1; c >= teeth_end; --c, up = !up) {
    for (int r = 1; r < rows; ++r) tour.push_back(view.at(c, up ? r : rows - r));
  }
  bool leftwards = true;
  for (int r = rows - 1; teeth_end > 0 && r >= 1; --r, leftwards = !leftwards) {
    tour.push_back(view.at(leftwards ? 1 : 0, r));
    tour.push_back(view.at(leftwards ? 0 : 1, r));
  }
  return tour;
}

using Run = std::vector<int>;

std::vector<Run> runs_of(const View& view) {
  std::vector<Run> runs;
  for (int row = 0; row < view.rows(); ++row) {
    bool open = false;
    for (int column = 0; column < view.columns(); ++column) {
      const int v = view.at(column, row);
      if (v >= 0 && !open) runs.emplace_back();
      if (v >= 0) runs.back().push_back(v);
      open = v >= 0;
    }
  }
  return runs;
}

/// Runs one after the other, each next the one with the nearest end. O(runs^2).
Tour run_by_run(const Lattice& lattice, const View& view) {
  std::vector<Run> runs = runs_of(view);
  const auto distance2 = [&](int a, int b) {
    const long long dx = lattice.column_of(a) - lattice.column_of(b),
                    dy = lattice.row_of(a) - lattice.row_of(b);
    return dx * dx + dy * dy;
  };
  Tour tour = runs.front();
  std::vector<bool> used(runs.size(), false);
  used[0] = true;
  for (std::size_t count = 1; count < runs.size(); ++count) {
    std::size_t best = 0;
    bool best_forward = true;
    long long best_distance = std::numeric_limits<long long>::max();
    for (std::size_t i = 1; i < runs.size(); ++i) {
      if (used[i]) continue;
      const long long forward = distance2(tour.back(), runs[i].front());
      const long long backward = distance2(tour.back(), runs[i].back());
      if (std::min(forward, backward) < best_distance) {
        best = i;
        best_distance = std::min(forward, backward);
        best_forward = forward <= backward;
      }
    }
    used[best] = true;
    if (!best_forward) std::reverse(runs[best].begin(), runs[best].end());
    tour.insert(tour.end(), runs[best].begin(), runs[best].end());
  }
  return tour;
}

constexpr std::size_t kMostRunsForGreedy = 4000;

}  // namespace

std::vector<Tour> sweeps(const Lattice& lattice, bool closed) {
  std::vector<Tour> tours;
  const bool flat = lattice.columns() < 2 || lattice.rows() < 2;
  for (int k = 0; k < 8; ++k) {
    const View view(lattice, k >= 4, k % 2 == 1, k / 2 % 2 == 1);
    tours.push_back(boustrophedon(view));
    tours.push_back(spiral(view));
    if (closed && lattice.full() && !flat) tours.push_back(comb(view));
    if (!lattice.full() && runs_of(view).size() <= kMostRunsForGreedy)
      tours.push_back(run_by_run(lattice, view));
  }
  return tours;
}

}  // namespace clearcut::order
