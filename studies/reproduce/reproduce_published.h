// The published system on its own part, from the file to the checked program, beside ours.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "studies/reproduce/reproduction.h"
#include "studies/reproduce/table_runs.h"

namespace clearcut::studies {

inline constexpr std::size_t kFishheadSeeds = 3;

/// Mean, and half the width of its 95 % interval by Student's t.
std::pair<double, double> mean_of_seeds(const std::array<double, kFishheadSeeds>& values);

/// Every workingstep of the fishhead on the published grid, ordered by the published algorithm (three seeds: mean and its
/// 95 % interval) and by ours; the sums beside table 6.5. All figures are those of the program that was written and read back.
Reproduction published_fishhead_table(const TableWatch& watch);

}  // namespace clearcut::studies
