// What options say of a drawing's layers and outlines, as its readers take it.
#pragma once

#include <string>

#include "options/input_options.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// "pocket", "profile", ...: as in `--op`.
const char* name_of(LayerRole role);

/// What "pocket", "PROFILE_D6", ... say of outlines: their role, and a depth where there is one. Throws InputError at
/// `place` for words that say no role.
LayerRule rule_named(const std::string& kind, const std::string& place);

/// "KIND:SELECTION", as in "profile:outer", "drill_d6:HOLES", "inside:2,5". Throws InputError at `place`.
LayerRule rule_of_option(const std::string& text, const std::string& place);

/// What is said of the file, as its readers take it. Throws InputError at "--op" for operations that mean nothing.
ReadOptions read_options_of(const InputOptions& input);

}  // namespace clearcut::read
