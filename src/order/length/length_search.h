// The best known method for short tours: populations of greedy tours with local search, combined by edge assembly; if
// time or size forbid this, chained local search [martin1991], on large instances window by window.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/random.h"
#include "order/length/k_opt.h"
#include "order/length/length_model.h"
#include "order/stop.h"

namespace clearcut::order {

/// Shortest candidate edges first, as long as they close no early circle and leave no branching; the
/// fragments are then joined end to nearest end [bentley1992]. About 16-20 % above the optimum. O(n log n).
/// `noise` > 0 multiplies each edge by a random factor in [1, 1 + noise].
std::vector<int> greedy_tour(const LengthModel& model, double noise, Random& random);

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

struct LengthSearchOptions {
  StopRule stop;
  std::uint64_t seed = 1;
  double enough = 0;  ///< a tour of at most this length ends the search (a proven bound)
  std::function<void(const Tour&, double length)> improved;  ///< each new best tour, on the calling thread
};

struct LengthSearchResult {
  Tour tour;
  double length = 0;
  long long rounds = 0;  ///< populations completed, or passes over all windows
  std::string method;
};

/// A first tour: greedy with local search, or along the Hilbert curve when there are very many points.
std::vector<int> first_tour(const LengthModel& model, const StopWatch& watch);

/// Improves `first`. Runs on the caller's TBB arena. The plan depends on the size and on stop.seconds, never
/// on the clock or the number of threads: with stop.rounds reached before stop.seconds the result repeats
/// exactly. Stops by itself when a second population ends at the best length of the ones before, or three in
/// a row found nothing shorter. Keeps fixed ends, not precedence. `model` must be made for `problem`, of at least 8
/// points.
LengthSearchResult search_length(const Problem& problem, const LengthModel& model, std::vector<int> first,
                                 const LengthSearchOptions& options);

}  // namespace clearcut::order
