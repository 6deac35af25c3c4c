// Files read whole and written all or nothing: read_file(), write_files(), content_hash(), sha256_hex(); never over what was
// read for them (check_outputs()).
#pragma once

#include "base/files/digest.h"
#include "base/files/file.h"
#include "base/files/output_names.h"
#include "base/files/project_entry.h"
