// Text for XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::inline base {

/// For XML and HTML text and attributes: & < > " ' escaped, characters forbidden by XML and broken UTF-8
/// replaced by '?'.
std::string xml_escaped(std::string_view text);

}  // namespace clearcut::inline base
