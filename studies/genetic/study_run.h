// One run of a study: the algorithm on a lattice, island by island.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "order/genetic/islands.h"
#include "studies/genetic/genetic_study.h"

namespace clearcut::studies {

inline const StudyLevel& level_of(const GeneticStudy& study, const StudyRun& run) {
  return study.levels[static_cast<std::size_t>(run.level)];
}

/// One epoch of one island of a run; see order::run_epoch. The state's seconds are processor time.
order::GeneticState study_epoch(const GeneticStudy& study, std::uint64_t seed, const StudyRun& run,
                                const order::Epoch& epoch, const order::GeneticState* own,
                                const order::GeneticState* before, const std::atomic<bool>& stop);

/// The rows of a run from its islands after their last epoch.
std::vector<StudyRow> rows_of_islands(const GeneticStudy& study, const StudyRun& run,
                                      std::vector<order::GeneticState> states);

}  // namespace clearcut::studies
