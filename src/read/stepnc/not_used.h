// What a file says and nobody used.
#pragma once

#include <span>
#include <string_view>

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

}  // namespace clearcut::read::stepnc
