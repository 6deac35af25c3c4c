// The keys of a job that are options: read by the options' table.
#pragma once

#include "options/row.h"
#include "read/common/data_value.h"

namespace clearcut::read {

/// Which rows of a table are meant.
enum class OptionsOf : unsigned char {
  kOperations,  ///< those that an [[operation]] may have
  kWhole        ///< the others
};

/// Puts every option whose key stands in `section`, the job's table `table`, into `asked`. Throws InputError "file:line: key: ..."
/// for values that the row refuses, in the words of the command line.
void take_options(DataSection& section, JobTable table, OptionsOf which, Asked& asked);

}  // namespace clearcut::read
