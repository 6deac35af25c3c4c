// The job's keys for options: read by the table of options.
#pragma once

#include "options/row.h"
#include "read/common/data_value.h"

namespace clearcut::read {

/// Selection of the rows of a table.
enum class OptionsOf : unsigned char {
  kOperations,  ///< rows permitted in an [[operation]]
  kWhole        ///< the others
};

/// Stores every option with a key in `section`, the job's table `table`, into `asked`. Throws InputError "file:line:
/// key: ..." for values refused by the row, in the words of the command line.
void take_options(DataSection& section, JobTable table, OptionsOf which, Asked& asked);

}  // namespace clearcut::read
