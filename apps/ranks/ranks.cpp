#include "ranks/ranks.h"

#include <clearcut/error.h>
#include <fmt/format.h>

namespace clearcut::ranks {

std::string pack(const std::vector<std::string>& texts) {
  std::string packed;
  for (const std::string& text : texts) packed += fmt::format("{}:{}", text.size(), text);
  return packed;
}

std::vector<std::string> unpack(const std::string& packed) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < packed.size();) {
    const std::size_t colon = packed.find(':', at);
    const bool is_length = colon != std::string::npos && colon > at && colon - at < 12 &&
                           packed.find_first_not_of("0123456789", at) == colon;
    const std::size_t length = is_length ? std::stoull(packed.substr(at, colon - at)) : packed.size();
    if (!is_length || length > packed.size() - colon - 1)
      throw InputError("a message", "of another process cannot be read; all have to be of one version");
    texts.push_back(packed.substr(colon + 1, length));
    at = colon + 1 + length;
  }
  return texts;
}

}  // namespace clearcut::ranks
