// What the server's answers hold, as JSON Schema, for its description.
#pragma once

#include "serve/works/work_list.h"

namespace clearcut::serve {

/// By their names, which routes refer to: Route::schema.
Json schemas();

}  // namespace clearcut::serve
