// A study on the processes of an MPI job.
#pragma once

#include <functional>
#include <vector>

#include "study_files.h"

namespace clearcut::cli {

/// Runs all rows missing in the file, and calls `write`, which returns the exit code, with all rows on the process
/// with the file; returns the exit code of this process. Throws InputError if there is no file or no MPI.
int run_study_on_ranks(StudyCommand& command, const studies::GeneticStudy& study,
                       const std::function<int(const std::vector<studies::StudyRow>& rows)>& write);

}  // namespace clearcut::cli
