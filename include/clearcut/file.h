// Files read whole and written all or nothing: read_file(), write_files(), content_hash(); never over what was read (InputGuard).
#pragma once

#include "base/files/file.h"
#include "base/files/file_guard.h"
