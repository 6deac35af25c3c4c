// Several set-ups in one job file ([[setup]]), and the job's keys for options, read by the table of options.
#pragma once

#include <vector>

#include "model/setup_place.h"
#include "options/row.h"
#include "read/common/data_value.h"
#include "read/job/job_file.h"

namespace clearcut::read {

/// Selection of the rows of a table.
enum class OptionsOf : unsigned char {
  kOperations,  ///< rows permitted in an [[operation]]
  kWhole        ///< the others
};

/// Stores every option with a key in `section`, the job's table `table`, into `asked`. Throws InputError "file:line:
/// key: ..." for values refused by the row, in the words of the command line.
void take_options(DataSection& section, JobTable table, OptionsOf which, Asked& asked);

/// Each [[setup]] of a job combined with the job's common settings, as a separate job: keys of the set-up in [part],
/// [plan], [stock] and [output], its layers before the common ones, its operations, clamps and holes. Throws
/// InputError "file:line: ..." for unknown keys, and for operations outside the set-ups.
std::vector<DataValue> jobs_of_setups(const DataValue& root, const std::string& file_name);

/// The part of one set-up (from 1) of a job, as from part_of_job, with the zero requested by the set-up. `place`:
/// transform from the coordinates of the block to those of the set-up, for all set-ups of the job alike. The block is
/// that of the first set-up; in later ones it is turned as stated. Throws InputError as part_of_job, and if the block
/// of a later set-up has another size.
Part part_of_setup(const JobFile& job, int number, const ReadOptions& over, SetupPlace& place,
                   StepSources& sources, StepChoices& published);

}  // namespace clearcut::read
