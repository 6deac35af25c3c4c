// Several set-ups in one job file: [[setup]].
#pragma once

#include <vector>

#include "model/setup_place.h"
#include "read/common/data_value.h"
#include "read/job/job_file.h"

namespace clearcut::read {

/// What each [[setup]] of a job says, put over what the job says for all, as the text of a job of its own: keys of the set-up in
/// [part], [plan], [stock] and [output], its layers before the common ones, its operations, clamps and holes. Throws InputError
/// "file:line: ..." for keys that nobody knows, and for operations outside the set-ups.
std::vector<DataValue> jobs_of_setups(const DataValue& root, const std::string& file_name);

/// The part of one set-up (from 1) of a job, as part_of_job gives it, with its zero where the set-up wants it. `place`: from the
/// coordinates of the block to those of the set-up, for all set-ups of the job alike. The block is that of the first set-up; in
/// later ones it is turned as they say. Throws InputError as part_of_job, and where the block of a later set-up has another size.
Part part_of_setup(const JobFile& job, int number, const ReadOptions& over, SetupPlace& place,
                   StepSources& sources, StepChoices& published);

}  // namespace clearcut::read
