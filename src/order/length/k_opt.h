// Sequential k-exchanges over candidate lists: the local search of all methods that minimise length.
//
// Lin and Kernighan's search [lin1973] in the form of [helsgaun2009]: alternately remove an edge and add one
// to a near candidate as long as the sum stays positive, up to k edges; intermediate states need not be
// tours, only the closing step is tested for a tour. Depth 2 and 3 with one and two kept pieces contain
// 2-opt and Or-opt. Nodes whose surroundings did not change are not examined again (don't-look bits as a
// queue) [bentley1992].
#pragma once

#include <array>
#include <vector>

#include "order/length/array_tour.h"
#include "order/length/length_model.h"
#include "order/stop.h"

namespace clearcut::order {

/// Number of candidates tried at each depth; 0 ends the search there.
struct KOptBreadth {
  std::array<int, kMostExchanged> at{};
};
KOptBreadth two_opt_breadth();
KOptBreadth default_breadth();

class KOpt {
 public:
  using Cost = LengthModel::Cost;

  KOpt(const LengthModel& model, std::vector<int> nodes, KOptBreadth breadth);

  /// Improves until no queued node has a gain, or the watch (if given) ends; the sum of gains. Nodes join the
  /// queue by `touch` and by taking part in an improving exchange.
  Cost improve(const StopWatch* watch = nullptr);
  void touch(int node) {
    if (!queued_[node]) {
      queued_[node] = true;
      queue_.push_back(node);
    }
  }
  /// Exchanges rewriting more places of the array are left out: on very large tours they cost more than
  /// they gain [johnson1997].
  void rewrite_at_most(int places) { most_rewritten_ = places; }
  ArrayTour& tour() { return tour_; }
  const ArrayTour& tour() const { return tour_; }

 private:
  bool improve_node(int t0);
  bool extend(int depth, Cost gain);
  bool is_removed(int a, int b, int depth) const;
  bool close(Cost gain);

  const LengthModel& model_;
  ArrayTour tour_;
  KOptBreadth breadth_;
  Exchange exchange_;
  Cost gained_ = 0;
  int most_rewritten_ = std::numeric_limits<int>::max();
  std::vector<int> queue_;
  std::size_t head_ = 0;
  std::vector<char> queued_;
};

}  // namespace clearcut::order
