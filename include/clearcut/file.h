// Files read whole and written all or nothing: read_file(), write_files(), content_hash().
#pragma once

#include "base/file.h"
