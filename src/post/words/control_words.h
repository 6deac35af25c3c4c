// Words that set up the control, and those for its places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/coolant.h"
#include "model/options/work_offset.h"
#include "post/words/iso_dialect.h"

namespace clearcut::post {

/// What leads from `held` to `wanted`, each word in a block of its own: Grbl takes one of them in a block.
std::vector<std::string_view> coolant_words(Coolant held, Coolant wanted, const MistWords& mist);

bool has_work_offset(const IsoDialect& dialect, const WorkOffset& offset);
/// For messages: "G54 to G59, G54.1 P1 to P300"; "" where its programs have none.
std::string work_offsets_of(const IsoDialect& dialect);

/// With the work offset that is asked for in place of the first; one with a P word has a block of its own, the second.
std::vector<std::string> mode_blocks(const IsoDialect& dialect, const WorkOffset& offset);
/// The same at later tools. Not G49, which on its own may move Z by the length in force; the next G43 replaces that.
std::vector<std::string> later_mode_blocks(const IsoDialect& dialect, const WorkOffset& offset);

/// To the home of all axes, Z first; G28 goes from where the tool is, without a way.
std::vector<std::string> home_blocks(const IsoDialect& dialect);

}  // namespace clearcut::post
