#include "support/definitions.h"

#include <algorithm>
#include <cctype>

namespace clearcut::test_support {
namespace {

using Tokens = std::vector<std::string>;

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Words and single signs, "::" as one; no comments, literals and preprocessor lines.
class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text) {}

  Tokens tokens() {
    for (bool line_start = true; at_ < text_.size();) {
      const char c = text_[at_];
      if (c == '\n' || std::isspace(static_cast<unsigned char>(c)) != 0) {
        line_start = line_start || c == '\n';
        ++at_;
        continue;
      }
      if (c == '#' && line_start) {
        skip_directive();
      } else if (!skip_comment() && !skip_literal()) {
        take();
      }
      line_start = false;
    }
    return std::move(tokens_);
  }

 private:
  bool starts(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  void skip_past(std::string_view end, std::size_t from) {
    const std::size_t found = text_.find(end, from);
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }
  void skip_directive() {
    do {
      skip_past("\n", at_);
    } while (at_ >= 2 && text_[at_ - 2] == '\\' && at_ < text_.size());
    --at_;  // the line break begins the next line
  }
  bool skip_comment() {
    if (starts("//")) return skip_past("\n", at_), --at_, true;
    if (starts("/*")) return skip_past("*/", at_ + 2), true;
    return false;
  }
  bool skip_literal() {
    if (starts("R\"")) {
      const std::size_t open = text_.find('(', at_);
      skip_past(")" + std::string(text_.substr(at_ + 2, open - at_ - 2)) + "\"", open);
      return true;
    }
    const char quote = text_[at_];
    if (quote != '"' && quote != '\'') return false;
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    ++at_;
    tokens_.emplace_back("\"");
    return true;
  }
  void take() {
    std::size_t end = at_ + 1;
    if (is_word(text_[at_])) {
      // Numbers may hold apostrophes between their digits.
      const bool number = std::isdigit(static_cast<unsigned char>(text_[at_])) != 0;
      while (end < text_.size() && (is_word(text_[end]) || (number && text_[end] == '\''))) ++end;
    } else if (starts("::")) {
      ++end;
    }
    tokens_.emplace_back(text_.substr(at_, end - at_));
    at_ = end;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Tokens tokens_;
};

std::string joined(const Tokens& tokens, std::size_t begin, std::size_t end, const char* between) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) text += (i > begin ? between : "") + tokens[i];
  return text;
}

/// Index behind the bracket that closes the one at `open`.
std::size_t behind(const Tokens& tokens, std::size_t open, const char* opens, const char* closes) {
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    if (tokens[i] == opens) ++depth;
    if (tokens[i] == closes && --depth == 0) return i + 1;
  }
  return tokens.size();
}

/// What stands before "{" without "template <...>" and attributes.
Tokens without_preamble(Tokens head) {
  for (std::size_t i = 0; i < head.size();) {
    std::size_t end = i;
    if (head[i] == "template") {
      end = i + 1 < head.size() && head[i + 1] == "<" ? behind(head, i + 1, "<", ">") : i + 1;
    } else if (head[i] == "[") {
      end = behind(head, i, "[", "]");
    }
    if (end == i) {
      ++i;
      continue;
    }
    head.erase(head.begin() + static_cast<std::ptrdiff_t>(i),
               head.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return head;
}

bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The name of the type that `head` defines, "" when it defines none. Specialisations keep their arguments.
std::string type_of(const Tokens& head) {
  if (head.empty() || !is_one_of(head[0], {"class", "struct", "union", "enum"})) return "";
  std::size_t name = 1;
  if (name < head.size() && is_one_of(head[name], {"class", "struct"})) ++name;
  if (name >= head.size() || !is_word(head[name][0])) return "";
  std::size_t end = name + 1;
  while (end < head.size() && head[end] == "::") end += 2;
  if (end < head.size() && head[end] == "<") end = behind(head, end, "<", ">");
  const bool defined = end >= head.size() || is_one_of(head[end], {":", "final"});
  return defined ? joined(head, name, std::min(end, head.size()), "") : "";
}

/// The function that `head` defines with its parameters, "" when it defines none, a static one, or a macro's.
std::string function_of(const Tokens& head) {
  const auto open = static_cast<std::size_t>(std::find(head.begin(), head.end(), "(") - head.begin());
  if (open == head.size() || open == 0) return "";
  const auto has = [&](const char* word) { return std::find(head.begin(), head.end(), word) != head.end(); };
  if (has("static") || (has("=") && !has("operator"))) return "";
  const std::size_t close = behind(head, open, "(", ")");
  std::size_t begin = open;
  while (begin > 0 && head[begin - 1] != "operator" && !is_word(head[begin - 1][0])) --begin;  // operator+
  if (begin > 0) --begin;
  while (begin >= 2 && head[begin - 1] == "::") begin -= 2;
  if (begin == 0) return "";  // TEST(...), a constructor's macro: no type before the name
  return joined(head, begin, open, "") + "(" + joined(head, open + 1, close - 1, " ") + ")";
}

class Scanner {
 public:
  std::vector<std::string> scan(const Tokens& tokens) {
    Tokens head;
    int parentheses = 0;  // braces within them are values
    for (const std::string& token : tokens) {
      if (token == "(") ++parentheses;
      if (token == ")") --parentheses;
      if (parentheses > 0) {
        head.push_back(token);
      } else if (token == "{") {
        open(head);
        head.clear();
      } else if (token == "}") {
        if (!scopes_.empty()) scopes_.pop_back();
        head.clear();
      } else if (token == ";") {
        head.clear();
      } else {
        head.push_back(token);
      }
    }
    return std::move(found_);
  }

 private:
  enum class Kind { kNamed, kOfOneFile, kOther };
  struct Scope {
    Kind kind = Kind::kOther;
    std::string name;
  };

  void open(const Tokens& whole) {
    Tokens head = without_preamble(whole);
    const bool shared = std::all_of(scopes_.begin(), scopes_.end(),
                                    [](const Scope& scope) { return scope.kind == Kind::kNamed; });
    const bool inlined = head.size() > 1 && head[0] == "inline" && head[1] == "namespace";
    if (inlined) head.erase(head.begin());
    if (!head.empty() && head[0] == "namespace") {
      std::erase(head, "inline");
      const std::string name = joined(head, 1, head.size(), "");
      scopes_.push_back({name.empty() ? Kind::kOfOneFile : Kind::kNamed, name});
      return;
    }
    if (shared && head == Tokens{"extern", "\""}) return scopes_.push_back({Kind::kNamed, ""});
    if (shared) {
      const std::string type = type_of(head);
      const std::string name = type.empty() ? function_of(head) : type;
      if (!name.empty()) found_.push_back(place() + name);
    }
    scopes_.push_back({});
  }

  std::string place() const {
    std::string text;
    for (const Scope& scope : scopes_) {
      if (!scope.name.empty()) text += scope.name + "::";
    }
    return text;
  }

  std::vector<Scope> scopes_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> shared_definitions(std::string_view text) {
  return Scanner().scan(Tokenizer(text).tokens());
}

}  // namespace clearcut::test_support
