// STEP-NC: ISO 14649-10/-11 programs in an ISO 10303-21 file, and what such a file says and nobody used.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "model/part.h"
#include "model/setup_place.h"
#include "read/stepnc/file/node.h"

namespace clearcut::read::stepnc {

/// What it means that an attribute is not used.
enum class Weight {
  kAnnotation,  ///< it bears on nothing that is cut: a note
  kManner,      ///< how something is cut, not what: a warning
  kPart         ///< what is cut, or in which order: the condition "not-followed"
};

/// The attributes of one kind of entity in their order, separated by blanks; annotations begin with ~, manners with ?.
struct EntityRow {
  std::string_view keyword;
  std::string_view attributes;
};

/// All kinds whose attributes are known by name, in the order of the documentation.
std::span<const EntityRow> entity_rows();

/// Walks from the PROJECT (else from `start`) over all that it refers to and names each attribute that is set and not used, with entity and
/// line: in the diagnostics of `context`, by its weight; alike ones once. Numbers of zero and flags of .F. ask for nothing. What Context::said
/// has spoken of is passed over. Call it when everything has been read.
void name_what_is_not_used(const Node& start, Context& context);

/// A program's part, tools and order of work, in workpiece coordinates.
///
/// Shape   one Feature per feature that a workingstep machines, in the order of the workplan (nested
/// workplans in
///         place); one Workingstep per MACHINING_WORKINGSTEP that can be machined, the others reported as
///         skipped.
/// Units   feeds m/s to mm/min, spindle 1/s to rpm, angles to radians; files that write rpm or degrees are
/// recognised
///         by size, and it is reported. Lengths are mm in ISO 14649.
/// Depths  the standard's: relative to the feature. Where a floor would then lie below the stock, and all
/// floors lie
///         inside it when read as absolute z, they are; tops come from stacking (stack_tops) in both cases.
/// Throws  InputError("file:line") for syntax, for other schemas (AP238, STEP solids), tilted set-ups, and
/// where no
///         workingstep is left that can be machined.
/// Cost    O(text), plus the booleans of features that cross the stock's edge.
/// Source  ISO 14649-10, ISO 14649-11; see docs/stepnc.md for every default and reading.
Part read_stepnc(std::string_view text, const std::string& file_name, const Tolerances& tol);

/// In how many set-ups the program is cut: at least 1. Throws as read_stepnc().
int count_setups(std::string_view text, const std::string& file_name);

/// The part of set-up `number` (from 1) in its axes, with the workpiece's origin as zero; `place`: from the coordinates of the workpiece to
/// those. Throws as read_stepnc().
Part read_setup(std::string_view text, const std::string& file_name, const Tolerances& tol, int number,
                SetupPlace& place);

}  // namespace clearcut::read::stepnc
