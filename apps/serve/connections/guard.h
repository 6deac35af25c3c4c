// Whom the server answers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace clearcut::serve {

/// Headers of a request; "" if there is none.
struct Caller {
  std::string host;
  std::string origin;
  std::string site;       ///< Sec-Fetch-Site
  bool is_page = false;   ///< requests the page itself, which any site may link to
  std::size_t hosts = 1;  ///< number of Host lines
};

/// The reason for refusal, null if there is none. A foreign page using this machine's address under its own name is
/// recognised by Host; one sending from a browser, by Origin. `names`: further valid hosts. `is_open`: the server
/// listens to other machines, which may use any address.
std::optional<std::string> refusal_of(const Caller& caller, const std::vector<std::string>& names,
                                      bool is_open);

}  // namespace clearcut::serve
