#include "read/gcode/klartext/words.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

bool is_number(const std::string& word) {
  return std::all_of(word.begin(), word.end(), is_digit);
}

}  // namespace

Words words_of(std::string_view line) {
  Words found;
  const std::size_t mark = line.find(';');
  if (mark != std::string_view::npos) found.comment = line.substr(mark + 1);
  std::string word;
  for (const char c : line.substr(0, mark)) {
    if (!is_blank(c) && c != '~') {
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    } else if (!word.empty()) {
      found.words.push_back(std::move(word));
      word.clear();
    }
  }
  if (!word.empty()) found.words.push_back(std::move(word));
  if (!found.words.empty() && is_number(found.words[0])) found.words.erase(found.words.begin());
  return found;
}

bool is_klartext(std::string_view text) {
  Lines lines(text);
  std::string_view line;
  while (lines.next(line)) {
    const Words found = words_of(line);
    if (!found.words.empty())
      return found.words.size() > 1 && found.words[0] == "BEGIN" && found.words[1] == "PGM";
  }
  return false;
}

}  // namespace clearcut::read::gcode
