#include "plan/cover/cover_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clearcut::plan::cover {
namespace {

/// Room round the first path within which moves are distinguished by place, in radii.
constexpr double kRoom = 6;
/// Side of the cells for finding moves, in radii.
constexpr double kMoveCell = 1.5;

}  // namespace

CoverPath::CoverPath(const std::vector<Vec2>& points, bool closed, Witnesses& witnesses)
    : witnesses_(witnesses), closed_(closed), cell_(kMoveCell * witnesses.radius()) {
  Box box;
  for (const Vec2 p : points) box.add(p);
  box = box.grown(kRoom * witnesses.radius());
  corner_ = box.min;
  columns_ = static_cast<std::ptrdiff_t>(box.width() / cell_) + 1;
  rows_ = static_cast<std::ptrdiff_t>(box.height() / cell_) + 1;
  cells_.resize(static_cast<std::size_t>(columns_ * rows_));
  if (!closed) new_node({});
  for (const Vec2 p : points) {
    new_node(p);
    ++corners_;
  }
  const int count = static_cast<int>(nodes_.size());
  for (Corner c = 0; c < count; ++c) {
    nodes_[index(c)].next = (c + 1) % count;
    nodes_[index(c)].previous = (c + count - 1) % count;
  }
  for (Corner c = 0; c < count; ++c) put(c, next(c));
}

Corner CoverPath::new_node(Vec2 p) {
  Corner c = static_cast<Corner>(nodes_.size());
  if (!free_.empty()) {
    c = free_.back();
    free_.pop_back();
  } else {
    nodes_.emplace_back();
  }
  nodes_[index(c)].at = p;
  nodes_[index(c)].alive = true;
  return c;
}

std::vector<Vec2> CoverPath::points() const {
  std::vector<Vec2> points;
  Corner first = 0;
  while (!is_alive(first)) ++first;
  for (Corner c = first;;) {
    if (!is_nowhere(c)) points.push_back(at(c));
    c = next(c);
    if (c == first) return points;
  }
}

template <typename F>
void CoverPath::for_cells(Corner a, Corner b, const F& f) {
  Vec2 low = at(a), high = at(b);
  if (low.y > high.y || (low.y == high.y && low.x > high.x)) std::swap(low, high);
  const auto row_of = [&](double y) {
    return std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(std::floor((y - corner_.y) / cell_)), 0,
                                      rows_ - 1);
  };
  const auto column_of = [&](double x) {
    return std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(std::floor((x - corner_.x) / cell_)), 0,
                                      columns_ - 1);
  };
  const auto bottom = row_of(low.y), top = row_of(high.y);
  for (auto row = bottom; row <= top; ++row) {
    // The part of the move in this row of cells.
    double from = low.x, to = high.x;
    if (bottom != top) {
      const double y0 = std::clamp(corner_.y + static_cast<double>(row) * cell_, low.y, high.y);
      const double y1 = std::clamp(corner_.y + static_cast<double>(row + 1) * cell_, low.y, high.y);
      const double slope = (high.x - low.x) / (high.y - low.y);
      from = row == bottom ? low.x : low.x + slope * (y0 - low.y);
      to = row == top ? high.x : low.x + slope * (y1 - low.y);
    }
    const auto left = column_of(std::min(from, to)), right = column_of(std::max(from, to));
    for (auto column = left; column <= right; ++column)
      f(cells_[static_cast<std::size_t>(row * columns_ + column)]);
  }
}

void CoverPath::put(Corner a, Corner b) {
  if (is_nowhere(a) || is_nowhere(b)) return;
  witnesses_.add(at(a), at(b));
  length_ += distance(at(a), at(b));
  for_cells(a, b, [&](std::vector<Move>& moves) { moves.push_back({a, b}); });
}

void CoverPath::take(Corner a, Corner b, std::vector<Vec2>* bare) {
  if (is_nowhere(a) || is_nowhere(b)) return;
  if (bare != nullptr)
    witnesses_.remove(at(a), at(b), *bare);
  else
    witnesses_.remove(at(a), at(b));
  length_ -= distance(at(a), at(b));
  for_cells(a, b, [&](std::vector<Move>& moves) {
    for (Move& move : moves) {
      if ((move.a == a && move.b == b) || (move.a == b && move.b == a)) {
        move = moves.back();
        moves.pop_back();
        return;
      }
    }
  });
}

void CoverPath::erase_now(Corner c, std::vector<Vec2>* bare) {
  const Corner a = previous(c), b = next(c);
  take(a, c, bare);
  take(c, b, bare);
  nodes_[index(a)].next = b;
  nodes_[index(b)].previous = a;
  nodes_[index(c)].alive = false;
  --corners_;
  put(a, b);
}

void CoverPath::insert_now(Corner c, Corner after, std::vector<Vec2>* bare) {
  const Corner b = next(after);
  take(after, b, bare);
  nodes_[index(c)].previous = after;
  nodes_[index(c)].next = b;
  nodes_[index(c)].alive = true;
  nodes_[index(after)].next = c;
  nodes_[index(b)].previous = c;
  ++corners_;
  put(after, c);
  put(c, b);
}

void CoverPath::reverse_now(Corner b, Corner c, std::vector<Vec2>* bare) {
  const Corner a = previous(b), d = next(c);
  take(a, b, bare);
  take(c, d, bare);
  for (Corner i = b;;) {
    const Corner following = next(i);
    std::swap(nodes_[index(i)].next, nodes_[index(i)].previous);
    if (i == c) break;
    i = following;
  }
  nodes_[index(a)].next = c;
  nodes_[index(c)].previous = a;
  nodes_[index(b)].next = d;
  nodes_[index(d)].previous = b;
  put(a, c);
  put(b, d);
}

void CoverPath::erase(Corner c, std::vector<Vec2>& bare) {
  changes_.push_back({Change::Kind::kErased, c, previous(c), at(c)});
  waiting_.push_back(c);
  erase_now(c, &bare);
}

Corner CoverPath::insert_after(Corner after, Vec2 p, std::vector<Vec2>& bare) {
  const Corner c = new_node(p);
  changes_.push_back({Change::Kind::kInserted, c, after, p});
  insert_now(c, after, &bare);
  return c;
}

void CoverPath::reverse(Corner b, Corner c, std::vector<Vec2>& bare) {
  changes_.push_back({Change::Kind::kReversed, b, c, {}});
  reverse_now(b, c, &bare);
}

void CoverPath::lift(Corner first, Corner last, std::vector<Vec2>& bare) {
  for (Corner c = previous(first);; c = next(c)) {
    take(c, next(c), &bare);
    if (c == last) break;
  }
}

void CoverPath::place(Corner c, Vec2 p) {
  changes_.push_back({Change::Kind::kPlaced, c, -1, at(c)});
  nodes_[index(c)].at = p;
}

void CoverPath::lay(Corner first, Corner last) {
  for (Corner c = previous(first);; c = next(c)) {
    put(c, next(c));
    if (c == last) break;
  }
}

void CoverPath::undo(std::size_t mark) {
  while (changes_.size() > mark) {
    const Change change = changes_.back();
    changes_.pop_back();
    switch (change.kind) {
      case Change::Kind::kErased:
        nodes_[index(change.corner)].at = change.was;
        insert_now(change.corner, change.other, nullptr);
        waiting_.pop_back();
        break;
      case Change::Kind::kInserted:
        erase_now(change.corner, nullptr);
        free_.push_back(change.corner);
        break;
      case Change::Kind::kPlaced: {
        const Corner c = change.corner;
        take(previous(c), c, nullptr);
        take(c, next(c), nullptr);
        nodes_[index(c)].at = change.was;
        put(previous(c), c);
        put(c, next(c));
        break;
      }
      case Change::Kind::kReversed:
        reverse_now(change.other, change.corner, nullptr);
        break;
    }
  }
}

void CoverPath::forget() {
  changes_.clear();
  free_.insert(free_.end(), waiting_.begin(), waiting_.end());
  waiting_.clear();
}

int CoverPath::moves_within(Vec2 p, double reach) const {
  std::vector<std::pair<Corner, Corner>> near;
  for_moves_near(p, reach, [&](Corner a, Corner b) {
    const Vec2 foot = at(a) == at(b) ? at(a) : nearest_point(Edge::line(at(a), at(b)), p);
    if (distance(foot, p) <= reach) near.push_back({a, b});
  });
  std::sort(near.begin(), near.end());
  return static_cast<int>(std::unique(near.begin(), near.end()) - near.begin());
}

std::vector<Corner> CoverPath::changed_since(std::size_t mark) const {
  std::vector<Corner> found;
  const auto add = [&](Corner c) {
    if (c >= 0 && is_alive(c)) found.push_back(c);
  };
  for (std::size_t i = mark; i < changes_.size(); ++i) {
    add(changes_[i].corner);
    add(changes_[i].other);
    if (changes_[i].corner >= 0 && is_alive(changes_[i].corner)) add(next(changes_[i].corner));
    if (changes_[i].other >= 0 && is_alive(changes_[i].other)) add(next(changes_[i].other));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace clearcut::plan::cover
