// Words for setting up the control and for its places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/coolant.h"
#include "model/options/work_offset.h"
#include "post/words/iso_dialect.h"

namespace clearcut::post {

/// Words for changing from `held` to `wanted`, each in its own block: Grbl accepts one of them per block.
std::vector<std::string_view> coolant_words(Coolant held, Coolant wanted, const MistWords& mist);

bool has_work_offset(const IsoDialect& dialect, const WorkOffset& offset);
/// For messages: "G54 to G59, G54.1 P1 to P300"; "" if its programs have none.
std::string work_offsets_of(const IsoDialect& dialect);

/// Mode blocks with the requested work offset in place of the first one; an offset with a P word has its own block,
/// the second.
std::vector<std::string> mode_blocks(const IsoDialect& dialect, const WorkOffset& offset);
/// The same at later tools. Without G49, which by itself may move Z by the active length; the next G43 replaces the
/// length.
std::vector<std::string> later_mode_blocks(const IsoDialect& dialect, const WorkOffset& offset);

/// To the home of all axes, Z first; G28 starts at the tool's position, without an intermediate point.
std::vector<std::string> home_blocks(const IsoDialect& dialect);

}  // namespace clearcut::post
