// The best known method for short tours: populations of greedy tours with local search, combined by edge assembly; if
// time or size forbid this, chained local search, on large instances window by window.
#pragma once

#include <functional>
#include <string>

#include "order/length/length_model.h"
#include "order/stop.h"

namespace clearcut::order {

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
