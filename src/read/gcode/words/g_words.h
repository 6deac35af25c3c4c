// G words by what they have to do with each other. Codes are in tenths: 911 is G91.1.
#pragma once

#include <string>

#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

/// Two words of one modal group contradict each other within a block.
enum class Group {
  kUnknown,
  kMotion,
  kPlane,
  kDistance,
  kCenters,
  kFeedMode,
  kUnits,
  kReturn,
  kOffset,
  kOnce,  ///< words that use the axis words for something else than motion
  kCompensation,
  kSilent  ///< no effect on the path that is checked
};
Group group_of(int code);
/// Modal groups, whose words exclude each other.
bool is_modal(Group group);

/// "G91.1".
std::string g_word(int code);
bool has_g(const Block& block, int code);
/// The block's motion word, -1 without one. G80 gives way to any other.
int motion_in(const Block& block);

}  // namespace clearcut::read::gcode
