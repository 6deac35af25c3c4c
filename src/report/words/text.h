// Words and numbers as every report writes them: no locale, no NaN, no markup.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::report {

/// `value` with exactly `decimals` digits, never "-0"; "?" if not finite.
std::string fixed(double value, int decimals);

/// Hours, minutes and seconds: "0:07", "12:34", "1:02:03"; "?" when not finite or negative.
std::string clock_time(double seconds);

/// Printable ASCII only: any other code point becomes '?', line breaks and tabs a blank.
std::string ascii(std::string_view text);

/// At most `width` characters; longer text ends in "..".
std::string shortened(const std::string& text, std::size_t width);

}  // namespace clearcut::report
