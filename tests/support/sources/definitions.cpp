#include "support/sources/definitions.h"

#include <algorithm>

#include "support/sources/tokens.h"

namespace clearcut::test_support {
namespace {

using Words = std::vector<std::string>;

std::string joined(const Words& words, std::size_t begin, std::size_t end, const char* between) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) text += (i > begin ? between : "") + words[i];
  return text;
}

/// Index behind the bracket that closes the one at `open`.
std::size_t behind(const Words& words, std::size_t open, const char* opens, const char* closes) {
  int depth = 0;
  for (std::size_t i = open; i < words.size(); ++i) {
    if (words[i] == opens) ++depth;
    if (words[i] == closes && --depth == 0) return i + 1;
  }
  return words.size();
}

/// What stands before "{" without "template <...>" and attributes.
Words without_preamble(Words head) {
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
std::string type_of(const Words& head) {
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
std::string function_of(const Words& head) {
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
  std::vector<std::string> scan(const Words& words) {
    Words head;
    int parentheses = 0;  // braces within them are values
    for (const std::string& word : words) {
      if (word == "(") ++parentheses;
      if (word == ")") --parentheses;
      if (parentheses > 0) {
        head.push_back(word);
      } else if (word == "{") {
        open(head);
        head.clear();
      } else if (word == "}") {
        if (!scopes_.empty()) scopes_.pop_back();
        head.clear();
      } else if (word == ";") {
        add_alias(head);
        head.clear();
      } else {
        head.push_back(word);
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

  void open(const Words& whole) {
    Words head = without_preamble(whole);
    const bool shared = is_shared();
    const bool inlined = head.size() > 1 && head[0] == "inline" && head[1] == "namespace";
    if (inlined) head.erase(head.begin());
    if (!head.empty() && head[0] == "namespace") {
      std::erase(head, "inline");
      const std::string name = joined(head, 1, head.size(), "");
      scopes_.push_back({name.empty() ? Kind::kOfOneFile : Kind::kNamed, name});
      return;
    }
    if (shared && head == Words{"extern", "\""}) return scopes_.push_back({Kind::kNamed, ""});
    if (shared) {
      const std::string type = type_of(head);
      const std::string name = type.empty() ? function_of(head) : type;
      if (!name.empty()) found_.push_back(place() + name);
    }
    scopes_.push_back({});
  }

  /// Whether what stands here belongs to the whole program.
  bool is_shared() const {
    return std::all_of(scopes_.begin(), scopes_.end(),
                       [](const Scope& scope) { return scope.kind == Kind::kNamed; });
  }

  void add_alias(const Words& whole) {
    const Words head = without_preamble(whole);
    if (is_shared() && head.size() > 2 && head[0] == "using" && head[2] == "=")
      found_.push_back(place() + head[1] + " =");
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
  Words words;
  for (Token& token : tokens_of(text)) words.push_back(std::move(token.text));
  return Scanner().scan(words);
}

}  // namespace clearcut::test_support
