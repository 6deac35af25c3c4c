// SHA-256, by OpenSSL.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::inline base {

/// 64 hexadecimal digits, lower case.
std::string sha256_hex(std::string_view bytes);

}  // namespace clearcut::inline base
