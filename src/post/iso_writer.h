// Word-address programs: LinuxCNC, Grbl, Fanuc, Haas, Mach, Marlin.
#pragma once

#include <string>

#include "model/move.h"
#include "model/options/post_options.h"
#include "model/part.h"
#include "post/words/iso_dialect.h"

namespace clearcut::post {

/// `toolpath` has been checked by post().
std::string write_iso(const Toolpath& toolpath, const Part& part, const PostOptions& options,
                      const IsoDialect& dialect);

}  // namespace clearcut::post
