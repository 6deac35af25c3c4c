#include "support/sources/functions.h"

#include <algorithm>

#include "support/sources/tokens.h"

namespace clearcut::test_support {
namespace {

using Tokens = std::vector<Token>;

bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Walks over declarations; bodies of functions and values in braces are passed over.
class Walker {
 public:
  explicit Walker(std::string_view text) : tokens_(tokens_of(text)) {}

  void walk() {
    for (at_ = 0; at_ < tokens_.size();) {
      const std::string& word = tokens_[at_].text;
      if (word == "{") {
        open();
      } else if (word == "}") {
        if (!classes_.empty() && classes_.back().depth == depth_) close_class();
        --depth_;
        begin_ = ++at_;
      } else if (word == ";") {
        if (in_class() && parameters() < at_) ++classes_.back().size.methods;
        begin_ = ++at_;
      } else if (is_label()) {
        begin_ = ++at_;
      } else {
        at_ = word == "(" ? behind(at_, "(", ")") : at_ + 1;
      }
    }
  }
  std::vector<FunctionLength> functions;
  std::vector<ClassSize> classes;

 private:
  struct OpenClass {
    ClassSize size;
    int depth = 0;
  };

  /// "public:" and its like.
  bool is_label() const {
    return tokens_[at_].text == ":" && at_ == begin_ + 1 &&
           is_one_of(tokens_[begin_].text, {"public", "private", "protected"});
  }
  bool in_class() const { return !classes_.empty() && classes_.back().depth == depth_; }
  void close_class() {
    classes.push_back(classes_.back().size);
    classes_.pop_back();
  }
  std::size_t behind(std::size_t open, const char* opens, const char* closes) const {
    int depth = 0;
    for (std::size_t i = open; i < tokens_.size(); ++i) {
      if (tokens_[i].text == opens) ++depth;
      if (tokens_[i].text == closes && --depth == 0) return i + 1;
    }
    return tokens_.size();
  }
  /// The first word of the declaration behind "template <...>" and attributes.
  std::size_t first() const {
    std::size_t i = begin_;
    while (i < at_ && is_one_of(tokens_[i].text, {"template", "[", "inline", "typedef", "extern", "\""})) {
      if (tokens_[i].text == "template")
        i = behind(i + 1, "<", ">");
      else if (tokens_[i].text == "[")
        i = behind(i, "[", "]");
      else
        ++i;
    }
    return i;
  }
  /// Where the parameters of the function that is declared begin; at_ when it is none.
  std::size_t parameters() const {
    const std::size_t from = first();
    if (is_one_of(tokens_[from].text, {"using", "friend", "static_assert", "enum"})) return at_;
    for (std::size_t i = from; i < at_; ++i) {
      const std::string& word = tokens_[i].text;
      if (word == "=" && tokens_[i - 1].text != "operator") return at_;
      if (word == "<" && i > from && tokens_[i - 1].text != "operator" && is_word(tokens_[i - 1].text[0])) {
        i = std::min(behind(i, "<", ">"), at_) - 1;
      } else if (word == "(" && i > from) {
        const bool call = tokens_[i - 1].text == "operator";  // operator()(...)
        return call ? i + 2 : i;
      }
    }
    return at_;
  }
  bool is_type(std::size_t from) const {
    return is_one_of(tokens_[from].text, {"class", "struct", "union"}) && parameters() == at_;
  }
  /// Whether the brace gives a member its value: "C() : a_{1}, b_(2) {".
  bool is_initializer(std::size_t open) const {
    std::size_t i = behind(open, "(", ")");
    bool list = false;
    for (; i < at_; ++i) list = list || tokens_[i].text == ":";
    const std::string& last = tokens_[at_ - 1].text;
    return list && (is_word(last[0]) || last == ">") &&
           !is_one_of(last, {"const", "noexcept", "override", "final"});
  }
  void open() {
    const std::size_t from = first();
    if (from < at_ && tokens_[from].text == "namespace") return enter();
    if (from < at_ && is_type(from)) {
      classes_.push_back({{tokens_[from + 1].text, tokens_[from].line, 0}, depth_ + 1});
      return enter();
    }
    const std::size_t open = parameters();
    if (open < at_ && is_initializer(open)) {
      at_ = behind(at_, "{", "}");
      return;
    }
    const std::size_t end = behind(at_, "{", "}");
    if (open < at_) {
      if (in_class()) ++classes_.back().size.methods;
      const int line = tokens_[begin_].line;
      const std::string& name = tokens_[open - 1].text;
      functions.push_back({name == ")" ? "operator()" : name, line, tokens_[end - 1].line - line + 1});
      begin_ = at_ = end;
    } else {
      const bool linkage = from == at_ && from > begin_ && tokens_[from - 1].text == "\"";  // extern "C" {
      if (linkage) return enter();
      at_ = end;  // a value or an enumeration; its declaration goes on to the ";"
    }
  }
  void enter() {
    ++depth_;
    begin_ = ++at_;
  }

  Tokens tokens_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;  ///< of the declaration
  int depth_ = 0;
  std::vector<OpenClass> classes_;
};

}  // namespace

std::vector<FunctionLength> functions_of(std::string_view text) {
  Walker walker(text);
  walker.walk();
  return std::move(walker.functions);
}

std::vector<ClassSize> classes_of(std::string_view text) {
  Walker walker(text);
  walker.walk();
  return std::move(walker.classes);
}

}  // namespace clearcut::test_support
