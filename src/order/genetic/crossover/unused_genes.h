// Genes that a growing child does not have yet.
#pragma once

#include <vector>

#include "base/random.h"
#include "order/problem.h"

namespace clearcut::order {

/// Drawn and taken out in O(1).
class UnusedGenes {
 public:
  /// Those of a genome: 0..n-1, each once.
  void fill(const Tour& genes) {
    genes_ = genes;
    places_.resize(genes.size());
    for (std::size_t i = 0; i < genes.size(); ++i)
      places_[static_cast<std::size_t>(genes[i])] = static_cast<int>(i);
  }
  bool has(int gene) const { return places_[static_cast<std::size_t>(gene)] >= 0; }
  int any(Random& random) const { return genes_[random.below(genes_.size())]; }
  void take(int gene) {
    const auto place = static_cast<std::size_t>(places_[static_cast<std::size_t>(gene)]);
    genes_[place] = genes_.back();
    places_[static_cast<std::size_t>(genes_[place])] = static_cast<int>(place);
    places_[static_cast<std::size_t>(gene)] = -1;
    genes_.pop_back();
  }

 private:
  Tour genes_;
  std::vector<int> places_;
};

}  // namespace clearcut::order
