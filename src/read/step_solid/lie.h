// Whether a solid can be milled as it lies in its file, and if not, what to say.
#pragma once

#include <functional>
#include <string>

#include "read/step_solid/solid_model.h"

namespace clearcut::read {

/// Whether something can be milled with this side up: "+Z" is the solid as it lies.
using OffersFloors = std::function<bool(const std::string& side)>;

/// Throws  InputError naming the bodies of an assembly of which none was chosen.
void refuse_assembly(const SolidModel& solid, const std::string& file_name);

/// Throws  InputError with both readings where a sheet stands on its edge: thinner along X, Y or a direction between them than a
///         fifth of its height and its length, and flattest on that side. Sides that offer nothing are not proposed. Not to be asked
///         where the user said which side is up.
void refuse_sheet_on_edge(const SolidModel& solid, const std::string& file_name, const OffersFloors& offers);

/// Throws  InputError that proposes the largest flat side where that leans and nothing flat looks up: floors that are a hair askew are
///         none. Not to be asked where the user said which side is up.
void refuse_askew(const SolidModel& solid, const std::string& file_name);

/// Throws  InputError that proposes the largest flat side from which something can be milled, by trying: `offers` says
///         whether a side does. Of the largest three; where none does, it says so. `why`: what there is not with this side up.
[[noreturn]] void refuse_without_floor(const SolidModel& solid, const std::string& file_name,
                                       const std::string& up, const std::string& why,
                                       const OffersFloors& offers);

}  // namespace clearcut::read
