// Files read whole and written all or nothing: read_file(), write_files(), content_hash(); never over what was read for them
// (check_outputs()).
#pragma once

#include "base/files/file.h"
#include "base/files/output_names.h"
