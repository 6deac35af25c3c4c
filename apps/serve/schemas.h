// JSON Schemas of the server's answers, for its description.
#pragma once

#include "serve/works/work_list.h"

namespace clearcut::serve {

/// Schemas by name, referenced by routes: Route::schema.
Json schemas();

}  // namespace clearcut::serve
