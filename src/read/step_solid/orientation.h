// Whether a solid can be milled in the orientation of its file, with messages if not.
#pragma once

#include <functional>
#include <string>

#include "read/step_solid/solid_model.h"

namespace clearcut::read {

/// Whether anything can be milled with this side up: "+Z" is the orientation of the file.
using OffersFloors = std::function<bool(const std::string& side)>;

/// Throws  InputError naming the bodies of an assembly if none was chosen.
void refuse_assembly(const SolidModel& solid, const std::string& file_name);

/// Throws  InputError with both interpretations if a sheet is on its edge: thinner along X, Y or a direction between
///         them than a fifth of its height and its length, and flattest on that side. Sides without floors are not
///         proposed. Not to be called if the user stated the side up.
void refuse_sheet_on_edge(const SolidModel& solid, const std::string& file_name, const OffersFloors& offers);

/// Throws  InputError proposing the largest flat side if it is inclined and no flat face is upward: slightly inclined
///         floors do not count. Not to be called if the user stated the side up.
void refuse_askew(const SolidModel& solid, const std::string& file_name);

/// Throws  InputError proposing the largest flat side with something to mill, by trying the largest five with
///         `offers`; the message states if none has. `why`: the lack with this side up.
[[noreturn]] void refuse_without_floor(const SolidModel& solid, const std::string& file_name,
                                       const std::string& up, const std::string& why,
                                       const OffersFloors& offers);

}  // namespace clearcut::read
