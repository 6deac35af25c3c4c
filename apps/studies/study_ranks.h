// A study on the processes of an MPI job.
#pragma once

#include <functional>
#include <vector>

#include "study_files.h"

namespace clearcut::cli {

/// Runs what the file does not hold yet, and calls `write`, which gives the exit code, with all rows on the process that has the file; gives
/// the exit code of this process. Throws InputError where there is no file or no MPI.
int run_study_on_ranks(StudyCommand& command, const studies::GeneticStudy& study,
                       const std::function<int(const std::vector<studies::StudyRow>& rows)>& write);

}  // namespace clearcut::cli
