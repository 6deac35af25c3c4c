// Whom the server answers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace clearcut::serve {

/// Headers of a request; "" where there is none.
struct Caller {
  std::string host;
  std::string origin;
  std::string site;       ///< Sec-Fetch-Site
  bool is_page = false;   ///< asks for the page itself, which anybody may link to
  std::size_t hosts = 1;  ///< lines that say Host
};

/// What is wrong, null where nothing is. A page of somebody else that has this machine's address under its own name is told by
/// Host; one that sends from a browser, by Origin. `names`: further hosts that are right. `is_open`: listens to other
/// machines, which call it by any address.
std::optional<std::string> refusal_of(const Caller& caller, const std::vector<std::string>& names,
                                      bool is_open);

}  // namespace clearcut::serve
