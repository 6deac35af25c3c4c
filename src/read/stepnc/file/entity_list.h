// Every kind of entity that ISO 14649-10, -11 and -111 have for 2.5-D milling, and what becomes of it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "read/stepnc/file/node.h"

namespace clearcut::read::stepnc {

enum class Treatment {
  kPlanned,  ///< read, and in the program
  kSaid,     ///< not in the program; named in the diagnostics or in the verdict
  kRefused   ///< leaves out the workingstep that needs it
};

struct ListedEntity {
  std::string_view keyword;
  Treatment treatment = Treatment::kPlanned;
  const char* reason = "";  ///< what is said of it, or what to do instead
};

/// In the order of the documentation.
std::span<const ListedEntity> listed_entities();

/// Throws what is listed for the kind of `node` where that is refused; returns where it is not.
void refuse_listed(const Node& node);

/// The tables of the documentation, as Markdown.
std::string entity_tables();

}  // namespace clearcut::read::stepnc
