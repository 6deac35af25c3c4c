#include "read/repair/mends.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/format.h"

namespace clearcut::read {

std::string short_number(double value) {
  return fmt::format("{:.3g}", value);
}

std::string place_text(Vec2 p) {
  return "(" + trimmed(p.x, 4) + ", " + trimmed(p.y, 4) + ")";
}

void Mends::report(const std::string& where, Diagnostics& diagnostics) const {
  constexpr std::size_t kListed = 100;
  const std::size_t listed = std::min(kListed, mends_.size());
  for (std::size_t i = 0; i < listed; ++i) {
    diagnostics.repair(where + " at " + place_text(mends_[i].place),
                       what_ + " of " + short_number(mends_[i].size) + " mm");
  }
  if (listed == mends_.size()) return;
  const auto largest = std::max_element(mends_.begin() + kListed, mends_.end(),
                                        [](const Mend& a, const Mend& b) { return a.size < b.size; });
  diagnostics.repair(where + " at " + place_text(largest->place),
                     what_ + ": " + std::to_string(mends_.size() - listed) + " more, the largest here, " +
                         short_number(largest->size) + " mm");
}

}  // namespace clearcut::read
