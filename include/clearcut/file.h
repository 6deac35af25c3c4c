// Files read whole and written all or nothing: read_file(), write_files(), content_hash(), sha256_hex(); never over what was
// read for them (check_outputs()).
#pragma once

#include "base/file.h"
