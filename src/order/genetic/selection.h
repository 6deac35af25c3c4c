// Selection of the parents (Tour 4.3.3 i).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/random.h"

namespace clearcut::order {

class Selection {
 public:
  virtual ~Selection() = default;
  /// Place in `ranked`, the values of the selection pool, smallest (best) first; not empty.
  virtual int pick(std::span<const double> ranked, Random& random) const = 0;
};

/// All with equal chances.
std::unique_ptr<Selection> random_selection();
/// Chances reduced by a constant from rank to rank: N, N - 1, ..., 1.
std::unique_ptr<Selection> rank_selection();
/// p_i = f_i / sum f_j (eq. 4.12) with the fitness f = 1 / value (eq. 4.15); the published choice.
std::unique_ptr<Selection> roulette_selection();
/// The best of `size` drawn with equal chances.
std::unique_ptr<Selection> tournament_selection(int size = 3);
/// Equal chances among the best `share` of the pool, at least one.
std::unique_ptr<Selection> truncation_selection(double share = 0.5);

const std::vector<std::string>& selection_names();
/// Throws InputError for an unknown name.
std::unique_ptr<Selection> selection_named(const std::string& name);

}  // namespace clearcut::order
