#include "post/part/p21_text.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "base/error.h"

namespace clearcut::post {

namespace {

/// Takes one code point from the front of `text`; bytes outside of UTF-8 represent themselves.
std::uint32_t take_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 1;
  std::uint32_t code = length == 1 ? lead : lead & (0x7FU >> length);
  bool valid = length <= text.size();
  for (std::size_t i = 1; valid && i < length; ++i) {
    valid = (byte(i) & 0xC0) == 0x80;
    code = (code << 6) | (byte(i) & 0x3FU);
  }
  text.remove_prefix(valid ? length : 1);
  return valid ? code : lead;
}

std::string hex(std::uint32_t code, int digits) {
  char buffer[16];
  std::snprintf(buffer, sizeof buffer, "%0*X", digits, code);
  return buffer;
}

}  // namespace

std::string p21_real(double value) {
  if (!std::isfinite(value)) throw InputError("", "a number of the part is not finite; it cannot be written");
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value == 0 ? 0.0 : value).ptr;
  std::string text(buffer, end);
  const auto exponent = text.find('e');
  std::string mantissa = text.substr(0, exponent);
  if (mantissa.find('.') == std::string::npos) mantissa += ".0";
  return exponent == std::string::npos ? mantissa : mantissa + "E" + text.substr(exponent + 1);
}

std::string p21_string(std::string_view utf8) {
  std::string out = "'";
  while (!utf8.empty()) {
    const std::uint32_t code = take_code_point(utf8);
    if (code == '\'')
      out += "''";
    else if (code == '\\')
      out += "\\\\";
    else if (code >= 0x20 && code < 0x7F)
      out += static_cast<char>(code);
    else if (code < 0x10000)
      out += "\\X2\\" + hex(code, 4) + "\\X0\\";
    else
      out += "\\X4\\" + hex(code, 8) + "\\X0\\";
  }
  return out + "'";
}

std::string p21_reference(int id) {
  return "#" + std::to_string(id);
}

std::string p21_list(const std::vector<std::string>& items) {
  std::string out = "(";
  for (std::size_t i = 0; i < items.size(); ++i) out += (i == 0 ? "" : ",") + items[i];
  return out + ")";
}

int P21Writer::reserve() {
  lines_.emplace_back();
  return static_cast<int>(lines_.size());
}

void P21Writer::put(int id, const std::string& keyword, const std::vector<std::string>& arguments) {
  lines_[static_cast<std::size_t>(id) - 1] = keyword + p21_list(arguments);
}

std::string P21Writer::add(const std::string& keyword, const std::vector<std::string>& arguments) {
  const int id = reserve();
  put(id, keyword, arguments);
  return p21_reference(id);
}

std::string P21Writer::text() const {
  std::string out;
  for (std::size_t i = 0; i < lines_.size(); ++i)
    out += p21_reference(static_cast<int>(i) + 1) + "=" + lines_[i] + ";\n";
  return out;
}

}  // namespace clearcut::post
