// Number of occurrences of each edge in a population: the measure of diversity.
#pragma once

#include <vector>

#include "order/length/ab_cycles.h"
#include "order/length/assembly.h"

namespace clearcut::order {

/// Lists per node; a node has few different neighbours in a population of good tours.
class EdgeCounts {
 public:
  explicit EdgeCounts(int nodes) : at_(static_cast<std::size_t>(nodes)) {}

  void add(const Links& tour);
  int count(int a, int b) const;
  void apply(const std::vector<EdgeChange>& changes);
  /// Change of the edge entropy -sum (F/N) ln(F/N) by the changes, N tours in the population (times N).
  double entropy_change(const std::vector<EdgeChange>& changes, int population) const;

 private:
  struct Entry {
    int other;
    int count;
  };
  void change(int a, int b, int by);
  std::vector<std::vector<Entry>> at_;  // at the smaller node of the edge
};

}  // namespace clearcut::order
