// The list of mends of one kind: each with place and size, long lists cut short with their largest.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "geometry/vec2.h"

namespace clearcut::read {

/// Lengths with enough digits for small values: "0.0125", "1.3e-09".
std::string short_number(double value);
/// "(10.5, -3)".
std::string place_text(Vec2 p);

/// Collects mends of one kind and reports them in order of happening.
class Mends {
 public:
  explicit Mends(std::string what) : what_(std::move(what)) {}
  void add(Vec2 place, double size) { mends_.push_back({place, size}); }
  bool empty() const { return mends_.empty(); }
  /// One diagnostic each, "<where> at (x, y)": "<what> of <size> mm"; after the first 100 a single one for the rest.
  void report(const std::string& where, Diagnostics& diagnostics) const;

 private:
  struct Mend {
    Vec2 place;
    double size = 0;
  };
  std::string what_;
  std::vector<Mend> mends_;
};

}  // namespace clearcut::read
