// Words that set up the control and move nothing.
#pragma once

#include <string_view>
#include <vector>

#include "model/coolant.h"
#include "post/iso_dialect.h"

namespace clearcut::post {

/// What leads from `held` to `wanted`, each word in a block of its own: Grbl takes one of them in a block.
std::vector<std::string_view> coolant_words(Coolant held, Coolant wanted, const MistWords& mist);

}  // namespace clearcut::post
