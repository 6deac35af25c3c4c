#include "stock/angle_set.h"

#include <algorithm>

#include "base/error.h"

namespace clearcut::stock {

AngleSet::AngleSet(std::span<const AngleInterval> items) {
  CLEARCUT_ASSERT(items.size() <= kCapacity);
  for (const AngleInterval& item : items) {
    if (item.to > item.from) items_[count_++] = item;
  }
}

AngleSet& AngleSet::operator=(const AngleSet& other) {
  count_ = other.count_;
  std::copy(other.items_, other.items_ + other.count_, items_);
  return *this;
}

double AngleSet::measure() const {
  double sum = 0;
  for (const AngleInterval& item : intervals()) sum += item.width();
  return sum;
}

}  // namespace clearcut::stock
