// Chained local search: kick a few neighbouring segments out of place, repair, keep results that are no worse
// [martin1991].
#pragma once

#include <functional>
#include <vector>

#include "base/random.h"
#include "order/length/k_opt.h"
#include "order/stop.h"

namespace clearcut::order {

class ChainedSearch {
 public:
  using Cost = LengthModel::Cost;

  ChainedSearch(const LengthModel& model, std::vector<int> start, KOptBreadth breadth, std::uint64_t seed);

  /// Local search from the start tour.
  void descend(const StopWatch& watch);
  /// Up to `kicks` kicks with repair; fewer when `watch` ends. Each takes a few microseconds at any size,
  /// because only segments near the kick are rewritten.
  void run(long long kicks, const StopWatch& watch);

  Cost cost() const { return cost_; }
  const std::vector<int>& nodes() const { return search_.tour().nodes(); }

 private:
  Cost kick();

  const LengthModel& model_;
  KOpt search_;
  Random random_;
  Cost cost_ = 0;
  std::vector<int> segments_;
};

}  // namespace clearcut::order
