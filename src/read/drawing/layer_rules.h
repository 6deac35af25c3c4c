// Options for a drawing's layers and outlines, in the form used by readers.
#pragma once

#include <string>

#include "options/plan_options.h"
#include "options/read_options.h"

namespace clearcut::read {

/// "pocket", "profile", ...: as in `--op`.
const char* name_of(LayerRole role);

/// Meaning of "pocket", "PROFILE_D6", ... for outlines: their role, and a depth if stated. Throws InputError at
/// `place` for words without a role.
LayerRule rule_named(const std::string& kind, const std::string& place);

/// "KIND:SELECTION", as in "profile:outer", "drill_d6:HOLES", "inside:2,5". Throws InputError at `place`.
LayerRule rule_of_option(const std::string& text, const std::string& place);

/// Options for the file, in the form used by readers. Throws InputError at "--op" for unknown operations.
ReadOptions read_options_of(const InputOptions& input);

}  // namespace clearcut::read
