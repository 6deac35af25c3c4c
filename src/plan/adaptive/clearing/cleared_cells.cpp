#include "plan/adaptive/clearing/cleared_cells.h"

#include <algorithm>
#include <cmath>

namespace clearcut::plan::adaptive {
namespace {

constexpr double kMostCells = 3e7;
constexpr double kFar = 1e300;
constexpr int kWord = 64;
/// mm, against rounding: a cell is marked only if the cut reaches this far beyond it, and asked for if the
/// disc comes this near.
constexpr double kSlack = 1e-6;
/// Radians. Arcs are marked in pieces of at most this turn, so that each is the part of a ring between two
/// straight borders.
constexpr double kPieceSweep = 2.0;

double half_chord(double radius, double off) {
  return std::sqrt(std::max(0.0, radius * radius - off * off));
}

/// x rounded up (a whole number to the next one) and down; 0 for negative x.
long up(double x) {
  return x > 0 ? static_cast<long>(x) + 1 : 0;
}
long down(double x) {
  return x > 0 ? static_cast<long>(x) : 0;
}

/// A word with the bits from `first` to `last` set.
std::uint64_t mask(long first, long last) {
  return (~std::uint64_t{0} << first) & (~std::uint64_t{0} >> (kWord - 1 - last));
}

}  // namespace

ClearedCells::ClearedCells(const Box& where, double cell) : cell_(cell) {
  if (where.empty()) return;
  cell_ = std::max(cell, std::sqrt(where.width() * where.height() / kMostCells));
  origin_ = where.min;
  columns_ = static_cast<long>(where.width() / cell_) + 1;
  rows_ = static_cast<long>(where.height() / cell_) + 1;
  words_ = static_cast<std::size_t>(columns_ / kWord) + 1;
  cells_.assign(words_ * static_cast<std::size_t>(rows_), 0);
}

void ClearedCells::add(const Edge& path, double radius) {
  cuts_.push_back({path, radius - kSlack});
}

void ClearedCells::forget_beyond(std::size_t cuts) {
  if (cuts >= cuts_.size()) return;
  cuts_.resize(cuts);
  if (marked_ <= cuts) return;
  std::fill(cells_.begin(), cells_.end(), 0);
  marked_ = 0;
}

bool ClearedCells::holds(Vec2 center, double radius) const {
  mark_new();
  const Vec2 at = center - origin_;
  const double reach = radius + kSlack;
  if (at.x < reach || at.y < reach) return false;
  const long low = static_cast<long>((at.y - reach) / cell_),
             high = static_cast<long>((at.y + reach) / cell_),
             last = static_cast<long>((at.x + reach) / cell_);
  if (high >= rows_ || last >= columns_) return false;
  for (long row = low; row <= high; ++row) {
    const double y = static_cast<double>(row) * cell_;
    const double off = std::max({y - at.y, at.y - y - cell_, 0.0}), half = half_chord(reach, off);
    if (!all_marked(static_cast<std::size_t>(row), static_cast<long>((at.x - half) / cell_),
                    static_cast<long>((at.x + half) / cell_)))
      return false;
  }
  return true;
}

bool ClearedCells::all_marked(std::size_t row, long first, long last) const {
  const std::uint64_t* words = cells_.data() + row * words_;
  for (long word = first / kWord; word <= last / kWord; ++word) {
    const std::uint64_t wanted =
        mask(std::max(first - word * kWord, 0L), std::min(last - word * kWord, kWord - 1L));
    if ((words[word] & wanted) != wanted) return false;
  }
  return true;
}

void ClearedCells::mark_new() const {
  for (; marked_ < cuts_.size(); ++marked_) mark(cuts_[marked_]);
}

void ClearedCells::mark(const Cut& cut) const {
  const Edge& path = cut.path;
  const bool goes_on = marked_ > 0 && cuts_[marked_ - 1].path.to == path.from;
  if (!goes_on || cuts_[marked_ - 1].radius < cut.radius) mark_disc(path.from, cut.radius);
  if (path.from == path.to) return;
  const int pieces = path.is_arc() ? static_cast<int>(std::abs(path.sweep()) / kPieceSweep) + 1 : 1;
  for (int i = 0; i < pieces; ++i) {
    const Edge piece = pieces == 1 ? path : path.part(static_cast<double>(i) / pieces, (i + 1.0) / pieces);
    if (piece.is_arc()) {
      mark_arc(piece, cut.radius);
    } else {
      mark_line(piece, cut.radius);
    }
    mark_disc(piece.to, cut.radius);
  }
}

template <typename F>
void ClearedCells::for_rows(double low, double high, F&& f) const {
  const long first = std::max(0L, up((low - origin_.y) / cell_)),
             end = std::min(rows_, down((high - origin_.y) / cell_));
  for (long row = first; row < end; ++row) {
    const double y = origin_.y + static_cast<double>(row) * cell_;
    f(row, y, y + cell_);
  }
}

void ClearedCells::mark_span(long row, Span span) const {
  const long first = std::max(0L, up((span.from - origin_.x) / cell_)),
             last = std::min(columns_, down((span.to - origin_.x) / cell_)) - 1;
  std::uint64_t* words = cells_.data() + static_cast<std::size_t>(row) * words_;
  for (long word = first / kWord; first <= last && word <= last / kWord; ++word)
    words[word] |= mask(std::max(first - word * kWord, 0L), std::min(last - word * kWord, kWord - 1L));
}

/// Shortens the span to what lies inside the border at all heights from `low` to `high`.
void ClearedCells::clip(Span& span, const Border& border, double low, double high) {
  const Vec2 n = border.normal;
  const double most = std::max(n.y * low, n.y * high);
  if (n.x > 0) {
    span.to = std::min(span.to, (border.q - most) / n.x);
  } else if (n.x < 0) {
    span.from = std::max(span.from, (border.q - most) / n.x);
  } else if (most > border.q) {
    span.to = span.from;
  }
}

void ClearedCells::mark_disc(Vec2 center, double radius) const {
  for_rows(center.y - radius, center.y + radius, [&](long row, double low, double high) {
    const double half = half_chord(radius, std::max(center.y - low, high - center.y));
    mark_span(row, {center.x - half, center.x + half});
  });
}

/// Marks the rectangle between the discs at the line's ends.
void ClearedCells::mark_line(const Edge& line, double radius) const {
  const Vec2 along = unit(line.to - line.from), aside = left_of(along);
  const Border borders[] = {{along, dot(along, line.to)},
                            {-along, -dot(along, line.from)},
                            {aside, dot(aside, line.from) + radius},
                            {-aside, -dot(aside, line.from) + radius}};
  const Box reach = line.box().grown(radius);
  for_rows(reach.min.y, reach.max.y, [&](long row, double low, double high) {
    Span span{-kFar, kFar};
    for (const Border& border : borders) clip(span, border, low, high);
    if (span.from < span.to) mark_span(row, span);
  });
}

/// Marks the part of the arc's ring between the discs at its ends.
void ClearedCells::mark_arc(const Edge& arc, double radius) const {
  const double ring = arc.radius(), inner = std::max(0.0, ring - radius),
               side = arc.turn == Turn::kCounterClockwise ? 1 : -1;
  const Vec2 c = arc.center, before = left_of(unit(arc.from - c)) * -side,
             after = left_of(unit(arc.to - c)) * side;
  const Border borders[] = {{before, dot(before, c)}, {after, dot(after, c)}};
  const Box reach = arc.box().grown(radius);
  for_rows(reach.min.y, reach.max.y, [&](long row, double low, double high) {
    const double far = half_chord(ring + radius, std::max(std::abs(c.y - low), std::abs(high - c.y))),
                 off = std::max({low - c.y, c.y - high, 0.0}),
                 near = off < inner ? half_chord(inner, off) : 0;
    for (Span span : {Span{c.x - far, c.x - near}, Span{c.x + near, c.x + far}}) {
      if (near == 0) span = {c.x - far, c.x + far};
      for (const Border& border : borders) clip(span, border, low, high);
      if (span.from < span.to) mark_span(row, span);
    }
  });
}

}  // namespace clearcut::plan::adaptive
