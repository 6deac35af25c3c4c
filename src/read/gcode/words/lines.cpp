#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {

Lines::Lines(std::string_view text) : rest_(text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.substr(0, kByteOrderMark.size()) == kByteOrderMark) rest_.remove_prefix(kByteOrderMark.size());
}

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  line = rest_.substr(0, rest_.find_first_of("\n\r"));
  std::size_t used = line.size();
  if (used < rest_.size()) used += rest_.substr(used, 2) == "\r\n" ? 2 : 1;
  rest_.remove_prefix(used);
  ++number_;
  return true;
}

}  // namespace clearcut::read::gcode
