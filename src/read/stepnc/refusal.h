// Kinds of entities that are known and not machined, each with what to do instead.
#pragma once

#include <span>
#include <string_view>

#include "read/stepnc/node.h"

namespace clearcut::read::stepnc {

struct Refusal {
  std::string_view keyword;
  const char* reason;
};

/// Throws what is listed for the kind of `node`; returns where nothing is.
inline void refuse_listed(const Node& node, std::span<const Refusal> refusals) {
  for (const Refusal& refusal : refusals)
    if (node.is(refusal.keyword)) node.fail(refusal.reason);
}

}  // namespace clearcut::read::stepnc
