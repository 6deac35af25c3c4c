#include "read/gcode/macros/o_words.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"

namespace clearcut::read::gcode {

namespace {

struct KeywordRow {
  std::string_view text;
  OKeyword keyword;
};
/// Longer words before those that they begin with.
constexpr KeywordRow kKeywords[] = {{"SUB", OKeyword::kSub},
                                    {"ENDSUB", OKeyword::kEndSub},
                                    {"CALL", OKeyword::kCall},
                                    {"RETURN", OKeyword::kReturn},
                                    {"WHILE", OKeyword::kWhile},
                                    {"ENDWHILE", OKeyword::kEndWhile},
                                    {"DO", OKeyword::kDo},
                                    {"IF", OKeyword::kIf},
                                    {"ELSEIF", OKeyword::kElseIf},
                                    {"ELSE", OKeyword::kElse},
                                    {"ENDIF", OKeyword::kEndIf},
                                    {"REPEAT", OKeyword::kRepeat},
                                    {"ENDREPEAT", OKeyword::kEndRepeat},
                                    {"BREAK", OKeyword::kBreak},
                                    {"CONTINUE", OKeyword::kContinue}};

bool may_have_o(std::string_view line) {
  std::size_t at = 0;
  while (at < line.size() && (is_blank(line[at]) || line[at] == '/')) ++at;
  if (at < line.size() && (line[at] == 'N' || line[at] == 'n')) {
    ++at;
    while (at < line.size() && (is_blank(line[at]) || std::isdigit(static_cast<unsigned char>(line[at]))))
      ++at;
  }
  return at < line.size() && (line[at] == 'O' || line[at] == 'o');
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The label behind the O; moves `at` behind it. "" where it is computed or none.
std::string label_of(const std::string& text, std::size_t& at) {
  if (at < text.size() && text[at] == '<') {
    const std::size_t close = text.find('>', at);
    if (close == std::string::npos) return "";
    const std::string name = lower_case(text.substr(at + 1, close - at - 1));
    at = close + 1;
    return name;
  }
  const std::size_t begin = at;
  while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]))) ++at;
  std::string digits = text.substr(begin, at - begin);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.empty() ? 0 : digits.size() - 1));
  return digits;
}

bool parse(std::string_view line, OLine& word) {
  CleanLine clean;
  try {
    clean = cleaned(line, "");
  } catch (const InputError&) {
    return false;  // reported when the line is executed
  }
  if (clean.text.empty() || clean.text[0] != 'O') return false;
  std::size_t at = 1;
  word.name = label_of(clean.text, at);
  if (word.name.empty()) {
    word.keyword = OKeyword::kComputed;
    word.rest = 1;
    return true;
  }
  const std::string_view rest = std::string_view(clean.text).substr(at);
  for (const KeywordRow& row : kKeywords) {
    if (rest.substr(0, row.text.size()) != row.text) continue;
    word.keyword = row.keyword;
    at += row.text.size();
    break;
  }
  word.rest = at;
  return true;
}

}  // namespace

int OWords::found(const Places& places, const std::string& name) {
  const auto place = places.find(name);
  return place == places.end() ? -1 : place->second;
}

OWords::OWords(const MacroSource& source) {
  for (std::size_t k = 0; k < source.lines.size(); ++k) {
    OLine word;
    if (!may_have_o(source.lines[k]) || !parse(source.lines[k], word)) continue;
    const int line = static_cast<int>(k);
    enter(line, word);
    words_[line] = word;
  }
}

const OLine* OWords::at(int line) const {
  const auto place = words_.find(line);
  return place == words_.end() ? nullptr : &place->second;
}

void OWords::enter(int line, OLine& word) {
  switch (word.keyword) {
    case OKeyword::kProgram:
      programs_.emplace(word.name, line);
      break;
    case OKeyword::kSub:
      word.twin = found(subs_, word.name);
      subs_.emplace(word.name, line);
      sub_ = word.name;
      open_["sub " + word.name] = line;
      break;
    case OKeyword::kEndSub: {
      const int start = found(open_, "sub " + word.name);
      if (start >= 0) words_[start].end = line;
      sub_.clear();
      break;
    }
    case OKeyword::kIf:
    case OKeyword::kDo:
    case OKeyword::kRepeat:
      open(line, word);
      break;
    case OKeyword::kWhile:
      if (const int start = found(open_, sub_ + " " + word.name);
          start >= 0 && words_[start].keyword == OKeyword::kDo) {
        word.keyword = OKeyword::kDoWhile;
        return close(line, word);
      }
      open(line, word);
      break;
    case OKeyword::kElseIf:
    case OKeyword::kElse:
    case OKeyword::kEndIf:
    case OKeyword::kEndWhile:
    case OKeyword::kEndRepeat:
    case OKeyword::kBreak:
    case OKeyword::kContinue:
      close(line, word);
      break;
    default:
      break;
  }
}

void OWords::open(int line, OLine& word) {
  const std::string label = sub_ + " " + word.name;
  word.start = line;
  word.twin = found(seen_, label);
  seen_.emplace(label, line);
  open_[label] = line;
}

/// A line within a structure or at its end.
void OWords::close(int line, OLine& word) {
  const std::string label = sub_ + " " + word.name;
  const int start = found(open_, label);
  if (start < 0) return;
  word.start = start;
  if (word.keyword == OKeyword::kBreak || word.keyword == OKeyword::kContinue) return;
  OLine& first = words_[start];
  if (first.keyword == OKeyword::kIf) {
    words_[first.last >= 0 ? first.last : start].next = line;
    first.last = line;
  }
  if (word.keyword == OKeyword::kElseIf || word.keyword == OKeyword::kElse) return;
  first.end = line;
  open_.erase(label);
}

}  // namespace clearcut::read::gcode
