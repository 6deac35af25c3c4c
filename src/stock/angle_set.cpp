#include "stock/angle_set.h"

#include <algorithm>
#include <cmath>

namespace clearcut {
namespace {

constexpr double kTurn = 2 * kPi;

}  // namespace

AngleSet::AngleSet(std::span<const AngleInterval> items) {
  for (const AngleInterval& item : items) append(item);
  if (empty()) return;
  from_ = items_[0].from;
  to_ = items_[count_ - 1].to;
}

AngleSet& AngleSet::operator=(const AngleSet& other) {
  from_ = other.from_;
  to_ = other.to_;
  count_ = other.count_;
  std::copy(other.items_, other.items_ + other.count_, items_);
  return *this;
}

double AngleSet::measure() const {
  double sum = 0;
  for (const AngleInterval& item : intervals()) sum += item.width();
  return sum;
}

/// A full set drops its narrowest item: less than is left is reported rather than none at all.
void AngleSet::append(AngleInterval item) {
  if (!(item.to > item.from)) return;
  if (count_ < kCapacity) {
    items_[count_++] = item;
    return;
  }
  AngleInterval* narrowest =
      std::min_element(items_, items_ + count_,
                       [](const AngleInterval& a, const AngleInterval& b) { return a.width() < b.width(); });
  if (narrowest->width() >= item.width()) return;
  std::move(narrowest + 1, items_ + count_, narrowest);
  items_[count_ - 1] = item;
}

void AngleSet::remove_linear(double from, double to) {
  if (to <= from_ || from >= to_) return;
  AngleInterval old[kCapacity];
  const int old_count = count_;
  std::copy(items_, items_ + count_, old);
  count_ = 0;
  for (int i = 0; i < old_count; ++i) {
    append({old[i].from, std::min(old[i].to, from)});
    append({std::max(old[i].from, to), old[i].to});
  }
}

void AngleSet::remove(double center, double half) {
  if (half <= 0 || count_ == 0) return;
  if (half >= kPi) {
    count_ = 0;
    return;
  }
  // The first copy of the interval that ends after the domain begins.
  const double shift = std::ceil((from_ - (center + half)) / kTurn) * kTurn;
  for (double from = center - half + shift; from < to_; from += kTurn) remove_linear(from, from + 2 * half);
}

void AngleSet::keep(std::span<const Arc> arcs) {
  AngleSet rest = *this;
  for (const Arc& arc : arcs) rest.remove(arc.center, arc.half);
  for (const AngleInterval& gone : rest.intervals()) remove_linear(gone.from, gone.to);
}

}  // namespace clearcut
