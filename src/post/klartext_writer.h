// Heidenhain conversational programs.
#pragma once

#include <string>

#include "post/post.h"

namespace clearcut {

/// `toolpath` has been checked by post().
std::string write_klartext(const Toolpath& toolpath, const Part& part, const PostOptions& options);

}  // namespace clearcut
