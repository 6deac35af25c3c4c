#include "read/gcode/sinumerik/language.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.h"
#include "read/gcode/macros/macro_run.h"
#include "read/gcode/sinumerik/formula.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

bool is_code_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_code_digit(char c) {
  return c >= '0' && c <= '9';
}

/// A line as the language sees it.
struct LanguageLine {
  std::string code;                 ///< in capitals but for texts; without number, label and comment
  std::string_view comment;         ///< behind ';'
  std::vector<std::string> labels;  ///< "N10", "LOOP1"
  bool is_optional = false;         ///< begins with '/'
};

void skip_line_blanks(std::string_view text, std::size_t& at) {
  while (at < text.size() && is_blank(text[at])) ++at;
}

/// "N10" and "LABEL:" at the begin of a line.
void take_labels(std::string_view line, std::size_t& at, LanguageLine& found) {
  skip_line_blanks(line, at);
  if (at + 1 < line.size() && (line[at] == 'N' || line[at] == 'n' || line[at] == ':') &&
      is_code_digit(line[at + 1])) {
    std::string number = "N";
    for (++at; at < line.size() && is_code_digit(line[at]); ++at)
      if (number != "N" || line[at] != '0') number += line[at];
    found.labels.push_back(number == "N" ? "N0" : number);
    skip_line_blanks(line, at);
  }
  std::size_t end = at;
  while (end < line.size() && (is_code_letter(line[end]) || is_code_digit(line[end]))) ++end;
  if (end < at + 2 || end >= line.size() || line[end] != ':' || !is_code_letter(line[at])) return;
  std::string label(line.substr(at, end - at));
  for (char& c : label) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  found.labels.push_back(std::move(label));
  at = end + 1;
}

LanguageLine language_line(std::string_view line) {
  LanguageLine found;
  std::size_t at = 0;
  skip_line_blanks(line, at);
  if (at < line.size() && line[at] == '%') return found;
  if (at < line.size() && line[at] == '/') {
    found.is_optional = true;
    ++at;
    if (at < line.size() && is_code_digit(line[at])) ++at;
  }
  take_labels(line, at, found);
  bool in_text = false;
  for (; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '"') in_text = !in_text;
    if (c == ';' && !in_text) {
      found.comment = line.substr(at + 1);
      break;
    }
    found.code += in_text ? c : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  while (!found.code.empty() && (is_blank(found.code.back()) || found.code.back() == '\r'))
    found.code.pop_back();
  std::size_t begin = 0;
  skip_line_blanks(found.code, begin);
  found.code.erase(0, begin);
  return found;
}

/// The letters, digits and '_' that a text begins with.
std::string first_name(std::string_view code) {
  std::size_t end = 0;
  while (end < code.size() && (is_code_letter(code[end]) || is_code_digit(code[end]))) ++end;
  return code.empty() || !is_code_letter(code[0]) ? "" : std::string(code.substr(0, end));
}

/// "%_N_PLATE_SPF", "%L100": the name that stands behind, without its ending.
std::string program_name_in(std::string_view line) {
  std::size_t at = 0;
  skip_line_blanks(line, at);
  if (at >= line.size() || line[at] != '%') return "";
  std::string name;
  for (++at; at < line.size() && (is_code_letter(line[at]) || is_code_digit(line[at])); ++at)
    name += static_cast<char>(std::toupper(static_cast<unsigned char>(line[at])));
  if (name.starts_with("_N_")) name.erase(0, 3);
  for (const std::string_view ending : {"_SPF", "_MPF"})
    if (name.ends_with(ending)) name.erase(name.size() - ending.size());
  return name;
}

enum class FlowWord : unsigned char {
  kNone,
  kIf,
  kElse,
  kEndIf,
  kWhile,
  kEndWhile,
  kFor,
  kEndFor,
  kLoop,
  kEndLoop,
  kRepeat,
  kUntil
};

struct FlowRow {
  std::string_view text;
  FlowWord word;
  FlowWord opened_by;  ///< of what ends or divides a structure
};
constexpr FlowRow kFlowRows[] = {{"IF", FlowWord::kIf, FlowWord::kNone},
                                 {"ELSE", FlowWord::kElse, FlowWord::kIf},
                                 {"ENDIF", FlowWord::kEndIf, FlowWord::kIf},
                                 {"WHILE", FlowWord::kWhile, FlowWord::kNone},
                                 {"ENDWHILE", FlowWord::kEndWhile, FlowWord::kWhile},
                                 {"FOR", FlowWord::kFor, FlowWord::kNone},
                                 {"ENDFOR", FlowWord::kEndFor, FlowWord::kFor},
                                 {"LOOP", FlowWord::kLoop, FlowWord::kNone},
                                 {"ENDLOOP", FlowWord::kEndLoop, FlowWord::kLoop},
                                 {"REPEAT", FlowWord::kRepeat, FlowWord::kNone},
                                 {"UNTIL", FlowWord::kUntil, FlowWord::kRepeat}};

/// Whether the code has the word outside of texts.
bool has_code_word(std::string_view code, std::string_view word) {
  for (std::size_t at = code.find(word); at != std::string_view::npos; at = code.find(word, at + 1)) {
    const bool begins = at == 0 || !(is_code_letter(code[at - 1]) || is_code_digit(code[at - 1]));
    if (begins && std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '"') % 2 == 0)
      return true;
  }
  return false;
}

/// Of a line that opens, divides or closes a structure.
FlowWord flow_word(std::string_view code) {
  const std::string name = first_name(code);
  for (const FlowRow& row : kFlowRows) {
    if (name != row.text) continue;
    if (row.word == FlowWord::kIf && has_code_word(code, "GOTO")) return FlowWord::kNone;
    if (row.word == FlowWord::kIf && (has_code_word(code, "GOTOF") || has_code_word(code, "GOTOB") ||
                                      has_code_word(code, "GOTOC") || has_code_word(code, "GOTOS")))
      return FlowWord::kNone;
    if (row.word == FlowWord::kRepeat && code.size() > name.size()) return FlowWord::kNone;  // of a section
    return row.word;
  }
  return FlowWord::kNone;
}

/// Where programs, labels and structures of a source stand. Lines count from 0.
class LanguageIndex {
 public:
  explicit LanguageIndex(const MacroSource& source) {
    programs_.push_back({"", 0});
    for (std::size_t k = 0; k < source.lines.size(); ++k) {
      lines_.push_back(language_line(source.lines[k]));
      const int line = static_cast<int>(k);
      if (std::string name = program_name_in(source.lines[k]); !name.empty())
        programs_.push_back({std::move(name), line});
      for (const std::string& label : lines_.back().labels) labels_[label].push_back(line);
      enter_structure(line);
    }
  }

  const LanguageLine& line(int line) const { return lines_[static_cast<std::size_t>(line)]; }
  int size() const { return static_cast<int>(lines_.size()); }

  /// First line of the program of that name; -1.
  int program(const std::string& name) const {
    for (const auto& [known, line] : programs_)
      if (known == name) return line;
    return -1;
  }
  /// Lines of the program that `line` is part of: from the first to the one behind the last.
  std::pair<int, int> program_around(int line) const {
    std::pair<int, int> found{0, size()};
    for (const auto& [name, begin] : programs_) {
      if (begin <= line) found.first = begin;
      if (begin > line) {
        found.second = begin;
        break;
      }
    }
    return found;
  }
  /// Line of the label forwards or backwards of `line`, within its program; -1.
  int label(const std::string& name, int line, bool forwards) const {
    const auto found = labels_.find(name);
    if (found == labels_.end()) return -1;
    const auto [first, behind] = program_around(line);
    int best = -1;
    for (const int at : found->second) {
      if (at < first || at >= behind) continue;
      if (forwards && at > line && best < 0) best = at;
      if (!forwards && at <= line) best = at;
    }
    return best;
  }
  /// Of IF its ELSE or ENDIF, of ELSE its ENDIF, of others the other end; -1 where it is missing.
  int partner(int line) const {
    const auto found = partners_.find(line);
    return found == partners_.end() ? -1 : found->second;
  }

 private:
  void enter_structure(int line) {
    const FlowWord word = flow_word(lines_.back().code);
    if (word == FlowWord::kNone) return;
    const auto* const row = std::find_if(std::begin(kFlowRows), std::end(kFlowRows),
                                         [&](const FlowRow& one) { return one.word == word; });
    if (row->opened_by == FlowWord::kNone) {
      open_.push_back({word, line});
      return;
    }
    if (open_.empty()) return;
    const FlowWord opened = open_.back().first == FlowWord::kElse ? FlowWord::kIf : open_.back().first;
    if (opened != row->opened_by || (word == FlowWord::kElse && open_.back().first == FlowWord::kElse))
      return;
    partners_[open_.back().second] = line;
    partners_[line] = open_.back().second;
    open_.pop_back();
    if (word == FlowWord::kElse) open_.push_back({word, line});
  }

  std::vector<LanguageLine> lines_;
  std::vector<std::pair<std::string, int>> programs_;
  std::map<std::string, std::vector<int>> labels_;
  std::map<int, int> partners_;
  std::vector<std::pair<FlowWord, int>> open_;
};

/// Lines that REPEAT runs again.
struct RepeatedLines {
  int first = 0, last = 0;
  int left = 0;  ///< times
  int back = 0;  ///< where the program goes on
};

class SinumerikRun : private ProgramRun {
 public:
  SinumerikRun(const SinumerikBlocks& blocks, const DialectRules& rules, const ReadControllerOptions& options,
               ToolpathBuilder& builder)
      : ProgramRun(builder, options), blocks_(blocks), rules_(rules) {}

  bool run(std::string_view text, const std::string& file_name) {
    MacroSource main;
    main.name = file_name;
    main.lines = lines_of(text);
    indices_.emplace(&main, LanguageIndex(main));
    const LanguageIndex& own = indices_.at(&main);
    // A header in the first lines names the program itself.
    int first = 0;
    while (first < own.size() && own.line(first).code.empty()) ++first;
    const int begin = own.program_around(first).first;
    frames_.push_back({.source = &main, .next = begin, .line = begin, .first = begin, .called = file_name});
    repeated_.emplace_back();
    arguments_.emplace_back();
    try {
      while (!blocks_.ended() && step()) {
      }
    } catch (const InputError& error) {
      rethrow(error.what());
    }
    return blocks_.ended();
  }

 private:
  const LanguageIndex& index() const { return indices_.at(frame().source); }

  /// Executes one line; false at the end of the program.
  bool step() {
    MacroFrame& now = frame();
    if (now.next >= index().program_around(now.line).second) {
      if (frames_.size() == 1) return false;
      refuse("the subprogram has no M17 or RET; add one at its end");
    }
    now.line = now.next++;
    const int executed = now.line;
    const LanguageLine& line = index().line(now.line);
    count_step(frame().source->lines[static_cast<std::size_t>(now.line)].size());
    const std::size_t depth = frames_.size();
    if (line.is_optional && !line.code.empty())
      builder_.condition("block-delete", shown_line(), "blocks marked '/' are executed; block delete is off");
    execute(line);
    if (frames_.size() == depth && !repeated_.back().empty()) end_of_repeated(executed);
    return true;
  }

  void end_of_repeated(int executed) {
    RepeatedLines& section = repeated_.back().back();
    if (executed != section.last || frame().next != executed + 1) return;
    if (section.left > 0) {
      --section.left;
      frame().next = section.first;
      return;
    }
    frame().next = section.back;
    repeated_.back().pop_back();
  }

  void execute(const LanguageLine& line) {
    const std::string& code = line.code;
    if (code.empty()) {
      if (!line.comment.empty()) blocks_.execute(";" + std::string(line.comment), shown_line());
      return;
    }
    const std::string name = first_name(code);
    const FlowWord word = flow_word(code);
    if (word != FlowWord::kNone) return flow(word, code);
    std::size_t at = name.size();
    if (name == "IF") return conditional_jump(code, at);
    if (name == "GOTO" || name == "GOTOF" || name == "GOTOB" || name == "GOTOC" || name == "GOTOS")
      return jump(name, code, at);
    if (name == "CASE") return choose(code, at);
    if (name == "REPEAT" || name == "REPEATB") return repeat_lines(name == "REPEATB", code, at);
    if (name == "DEF") return define(code, at);
    if (name == "PROC") return take_arguments(code, at);
    if (name == "EXTERN") return;
    if (name == "SETAL")
      refuse("SETAL is reached, at which the control stops with an alarm; correct what leads there");
    if (name == "DEFINE" || name == "PCALL") refuse(name + " is not read; post the program without it");
    if (name == "CALL" || name == "EXTCALL") return call_by_text(code, at);
    if (assignments(code)) return;
    if (call(name, code)) return;
    plain(line);
  }

  // ------------------------------------------------------------------------------------------ jumps and loops

  SinumerikFormula formula(const std::string& code, std::size_t& at) {
    return SinumerikFormula(code, at, memory_, refuse_);
  }

  void require_end(const std::string& code, std::size_t at) {
    skip_line_blanks(code, at);
    if (at < code.size()) refuse("'" + code.substr(at, 12) + "' is too much in its block; correct it");
  }

  int partner_of(const char* missing) {
    const int line = index().partner(frame().line);
    if (line < 0) refuse(std::string("a structure lacks its ") + missing + "; add it");
    return line;
  }

  bool holds(const std::string& code, std::size_t at) {
    const double value = formula(code, at).number();
    require_end(code, at);
    return value != 0;
  }

  void flow(FlowWord word, const std::string& code) {
    std::size_t at = first_name(code).size();
    switch (word) {
      case FlowWord::kIf:
        if (const int other = partner_of("ENDIF"); !holds(code, at)) go_behind(other);
        return;
      case FlowWord::kElse:
        // Reached from the part before, whose end it is; its own end is the partner that was entered last.
        return go_behind(end_of_else());
      case FlowWord::kWhile:
        if (const int end = partner_of("ENDWHILE"); !holds(code, at)) go_behind(end);
        return;
      case FlowWord::kEndWhile:
        frame().next = partner_of("WHILE");
        return;
      case FlowWord::kFor:
        return begin_for(code, at);
      case FlowWord::kEndFor:
        return go_on_with_for();
      case FlowWord::kLoop:
        partner_of("ENDLOOP");
        return;
      case FlowWord::kEndLoop:
        frame().next = partner_of("LOOP") + 1;
        return;
      case FlowWord::kRepeat:
        partner_of("UNTIL");
        return;
      case FlowWord::kUntil:
        if (const int begin = partner_of("REPEAT"); !holds(code, at)) frame().next = begin + 1;
        return;
      case FlowWord::kEndIf:
      case FlowWord::kNone:
        return;
    }
  }

  int end_of_else() {
    const int line = index().partner(frame().line);
    if (line < frame().line) refuse("ELSE without its IF or its ENDIF; add it");
    return line;
  }

  void go_behind(int line) { frame().next = line + 1; }

  /// "FOR NAME = 1 TO 5": sets the variable where `begins`, else counts it on. Whether the loop runs.
  bool for_runs(const std::string& code, std::size_t at, bool begins) {
    skip_line_blanks(code, at);
    const std::size_t variable = at;
    const std::size_t to = to_of_for(code);
    const std::string head = code.substr(0, to);
    std::size_t read = variable;
    if (begins) {
      if (!formula(head, read).assignment())
        refuse("FOR without a variable that the program defines; correct it");
    } else {
      const std::string name = head.substr(variable, head.find('=') - variable);
      const std::string step = name + "=" + name + "+1";
      std::size_t from = 0;
      if (!formula(step, from).assignment())
        refuse("FOR without a variable that the program defines; correct it");
    }
    const std::string name = head.substr(variable, head.find('=') - variable);
    std::size_t from = 0;
    const double now = formula(name, from).number();
    std::size_t limit = to + 2;
    const double last = formula(code, limit).number();
    require_end(code, limit);
    return now <= last;
  }

  std::size_t to_of_for(const std::string& code) {
    for (std::size_t at = code.find("TO"); at != std::string::npos; at = code.find("TO", at + 1)) {
      const bool begins = at > 0 && !is_code_letter(code[at - 1]);
      const bool ends =
          at + 2 >= code.size() || !(is_code_letter(code[at + 2]) || is_code_digit(code[at + 2]));
      if (begins && ends) return at;
    }
    refuse("FOR without its TO; add it");
  }

  void begin_for(const std::string& code, std::size_t at) {
    const int end = partner_of("ENDFOR");
    if (!for_runs(code, at, true)) go_behind(end);
  }

  void go_on_with_for() {
    const int begin = partner_of("FOR");
    const std::string& code = index().line(begin).code;
    if (for_runs(code, first_name(code).size(), false)) frame().next = begin + 1;
  }

  void conditional_jump(const std::string& code, std::size_t at) {
    const bool jumps = formula(code, at).number() != 0;
    skip_line_blanks(code, at);
    const std::string word = first_name(std::string_view(code).substr(at));
    if (!word.starts_with("GOTO")) refuse("IF without its GOTOF or GOTOB; correct it");
    if (jumps) return jump(word, code, at + word.size());
  }

  /// A label, or a block's number.
  std::string target_in(const std::string& code, std::size_t& at) {
    skip_line_blanks(code, at);
    std::string label = first_name(std::string_view(code).substr(at));
    if (label.empty()) refuse("a jump without its label; add it");
    at += label.size();
    if (label[0] == 'N' && label.size() > 1 && std::all_of(label.begin() + 1, label.end(), is_code_digit)) {
      label.erase(1, std::min(label.find_first_not_of('0', 1), label.size() - 1) - 1);
    }
    return label;
  }

  void jump(const std::string& word, const std::string& code, std::size_t at) {
    if (word == "GOTOS") {
      require_end(code, at);
      return go_to(index().program_around(frame().line).first, "its start");
    }
    const std::string label = target_in(code, at);
    require_end(code, at);
    go_to_label(word, label);
  }

  void go_to_label(const std::string& word, const std::string& label) {
    const int here = frame().line;
    int line = word == "GOTOB" ? -1 : index().label(label, here, true);
    if (line < 0 && word != "GOTOF") line = index().label(label, here, false);
    if (line < 0 && word == "GOTOC") return;
    if (line < 0) refuse("there is no " + label + " where " + word + " looks for it; correct the jump");
    go_to(line, label);
  }

  void go_to(int line, const std::string& label) {
    if (!repeated_.back().empty()) {
      const RepeatedLines& section = repeated_.back().back();
      if (line < section.first || line > section.last)
        refuse("the jump to " + label +
               " leaves lines that REPEAT runs again, which is not read; post the program without it");
    }
    frame().next = line;
  }

  /// "CASE R1 OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C"
  void choose(const std::string& code, std::size_t at) {
    const double value = formula(code, at).number();
    const auto word = [&] {
      skip_line_blanks(code, at);
      std::string found = first_name(std::string_view(code).substr(at));
      at += found.size();
      return found;
    };
    if (word() != "OF") refuse("CASE without its OF; add it");
    while (skip_line_blanks(code, at), at < code.size()) {
      bool fits = true;
      if (code.compare(at, 7, "DEFAULT") == 0)
        at += 7;
      else
        fits = formula(code, at).number() == value;
      const std::string jump_word = word();
      if (!jump_word.starts_with("GOTO")) refuse("CASE without its GOTOF or GOTOB; correct it");
      const std::string label = target_in(code, at);
      if (fits) return go_to_label(jump_word, label);
    }
  }

  /// "REPEAT A P=3" from the label to here, "REPEAT A B P=3" from label to label, "REPEATB A P=3" one block.
  void repeat_lines(bool one_block, const std::string& code, std::size_t at) {
    const std::string first = target_in(code, at);
    std::string last;
    int times = 1;
    skip_line_blanks(code, at);
    if (at < code.size() && !(code[at] == 'P' && !is_code_letter(code[std::min(at + 1, code.size() - 1)]))) {
      last = target_in(code, at);
      skip_line_blanks(code, at);
    }
    if (at < code.size()) times = count_of_calls(code, at);
    require_end(code, at);
    const auto line_of = [&](const std::string& label) {
      int line = index().label(label, frame().line, false);
      if (line < 0) line = index().label(label, frame().line, true);
      if (line < 0) refuse("there is no " + label + " in this program; correct REPEAT");
      return line;
    };
    RepeatedLines section{line_of(first), frame().line - 1, times - 1, frame().line + 1};
    if (one_block) section.last = section.first;
    if (!last.empty()) section.last = line_of(last);
    if (last.empty() && !one_block)
      if (const int end = index().label("ENDLABEL", section.first, true); end >= 0 && end < frame().line)
        section.last = end;
    if (section.last < section.first || (section.first <= frame().line && frame().line <= section.last))
      refuse("REPEAT of lines that it is part of, or that end before they begin; correct its labels");
    if (times < 1) return;
    constexpr std::size_t kMostRepeats = 32;
    if (repeated_.back().size() >= kMostRepeats) refuse("REPEAT within REPEAT without end; correct it");
    repeated_.back().push_back(section);
    frame().next = section.first;
  }

  /// "P3", "P=R1".
  int count_of_calls(const std::string& code, std::size_t& at) {
    skip_line_blanks(code, at);
    if (at >= code.size() || code[at] != 'P')
      refuse("'" + code.substr(at, 12) + "' is too much in its block; correct it");
    ++at;
    skip_line_blanks(code, at);
    if (at < code.size() && code[at] == '=') ++at;
    const double value = formula(code, at).number();
    if (!(value >= 0 && value <= 9999) || value != std::floor(value))
      refuse("P is no number of times from 0 to 9999; correct it");
    return static_cast<int>(value);
  }

  // ------------------------------------------------------------------------------------------ variables

  struct TypeRow {
    std::string_view name;
    SinumerikType type;
  };
  static constexpr TypeRow kTypes[] = {{"REAL", SinumerikType::kReal},
                                       {"INT", SinumerikType::kInt},
                                       {"BOOL", SinumerikType::kBool},
                                       {"STRING", SinumerikType::kText},
                                       {"CHAR", SinumerikType::kText}};

  SinumerikType type_in(const std::string& code, std::size_t& at) {
    skip_line_blanks(code, at);
    const std::string name = first_name(std::string_view(code).substr(at));
    at += name.size();
    for (const TypeRow& row : kTypes)
      if (row.name == name) {
        if (row.type == SinumerikType::kText && at < code.size() && code[at] == '[')
          at = code.find(']', at) == std::string::npos ? code.size() : code.find(']', at) + 1;
        return row.type;
      }
    refuse((name.empty() ? std::string("DEF") : name) +
           " is no type of variables that is read; use REAL, INT, BOOL or STRING");
  }

  std::string variable_in(const std::string& code, std::size_t& at) {
    skip_line_blanks(code, at);
    std::string name = first_name(std::string_view(code).substr(at));
    if (name.size() < 2) refuse("a variable's name has two letters or more; correct it");
    at += name.size();
    skip_line_blanks(code, at);
    return name;
  }

  static SinumerikResult unset(SinumerikType type) { return {0, "", type == SinumerikType::kText}; }

  /// "DEF REAL A=5, B[3]"; what is not said begins with 0, as the control has it.
  void define(const std::string& code, std::size_t at) {
    const SinumerikType type = type_in(code, at);
    constexpr std::size_t kLargestArray = 10000;
    while (true) {
      const std::string name = variable_in(code, at);
      std::size_t size = 1;
      if (at < code.size() && code[at] == '[') {
        const double asked = formula(code, ++at).number();
        if (at >= code.size() || code[at] != ']') refuse("arrays of one place are read alone; correct DEF");
        ++at;
        if (!(asked >= 1 && asked <= kLargestArray)) refuse("an array of that size is not read; correct DEF");
        size = static_cast<std::size_t>(asked);
      }
      SinumerikVariable variable{type, std::vector<SinumerikResult>(size, unset(type))};
      skip_line_blanks(code, at);
      if (at < code.size() && code[at] == '=') {
        const SinumerikResult value = as_type(type, formula(code, ++at).value(), refuse_);
        for (SinumerikResult& one : variable.values) one = value;
      }
      memory_.variables.back()[name] = std::move(variable);
      skip_line_blanks(code, at);
      if (at >= code.size()) return;
      if (code[at++] != ',') refuse("DEF has something behind its variables; correct it");
    }
  }

  /// "PROC NAME(REAL A, INT B=2)" at the begin of a subprogram.
  void take_arguments(const std::string& code, std::size_t at) {
    variable_in(code, at);
    std::vector<SinumerikResult>& given = arguments_.back();
    std::size_t taken = 0;
    if (at < code.size() && code[at] == '(') {
      ++at;
      skip_line_blanks(code, at);
      while (at < code.size() && code[at] != ')') {
        if (code.compare(at, 4, "VAR ") == 0)
          refuse("VAR of PROC hands values back, which is not read; post the program without it");
        const SinumerikType type = type_in(code, at);
        const std::string name = variable_in(code, at);
        std::optional<SinumerikResult> value;
        if (at < code.size() && code[at] == '=') value = formula(code, ++at).value();
        if (taken < given.size() && (given[taken].is_text || !std::isnan(given[taken].number)))
          value = given[taken];
        ++taken;
        if (!value) refuse("the call states no value for " + name + "; add it");
        memory_.variables.back()[name] = {type, {as_type(type, *value, refuse_)}};
        skip_line_blanks(code, at);
        if (at < code.size() && code[at] == ',') ++at;
        skip_line_blanks(code, at);
      }
      if (at < code.size()) ++at;
    }
    if (given.size() > taken) refuse("the call has more values than PROC takes; correct it");
    for (skip_line_blanks(code, at); at < code.size(); skip_line_blanks(code, at)) {
      const std::string word = first_name(std::string_view(code).substr(at));
      if (word == "SAVE")
        refuse(
            "SAVE brings the modes back behind a subprogram, which is not read; post the program without it");
      if (word != "DISPLOF" && word != "DISPLON" && word != "SBLOF" && word != "SBLON" && word != "ACTBLOCNO")
        refuse("'" + code.substr(at, 12) + "' behind PROC is not read; post the program without it");
      at += word.size();
    }
  }

  /// "R1=5 R2=R1+3": whether the block sets anything. What it sets stands in a block of its own, as the control asks.
  bool assignments(const std::string& code) {
    std::size_t at = 0;
    if (!formula(code, at).assignment()) return false;
    while (skip_line_blanks(code, at), at < code.size())
      if (!formula(code, at).assignment())
        refuse("what sets a parameter stands in a block of its own; split the block at '" +
               code.substr(at, 12) + "'");
    return true;
  }

  // ------------------------------------------------------------------------------------------ subprograms

  /// "L100 P3", "NAME", "NAME(1,2) P2".
  bool call(const std::string& name, const std::string& code) {
    if (name.size() < 2) return false;
    const bool is_number = name[0] == 'L' && std::all_of(name.begin() + 1, name.end(), is_code_digit);
    const bool is_letter_word = !is_number && std::all_of(name.begin() + 1, name.end(), is_code_digit);
    if (is_letter_word || !starts_call(name, is_number, code)) return false;
    std::size_t at = name.size();
    std::vector<SinumerikResult> arguments;
    skip_line_blanks(code, at);
    if (at < code.size() && code[at] == '(') arguments = arguments_in(code, at);
    skip_line_blanks(code, at);
    const int times = at < code.size() ? count_of_calls(code, at) : 1;
    require_end(code, at);
    enter(name, std::move(arguments), times);
    return true;
  }

  /// Letters that are followed at once by another word ("G1X10") are no name; '=' belongs to a word.
  bool starts_call(const std::string& name, bool is_number, const std::string& code) {
    std::size_t at = name.size();
    skip_line_blanks(code, at);
    if (at < code.size() && code[at] == '=') return false;
    if (is_number) return true;
    const bool mixes = name.size() > 1 && is_code_digit(name[1]);
    return !mixes && !blocks_.is_word(name);
  }

  std::vector<SinumerikResult> arguments_in(const std::string& code, std::size_t& at) {
    std::vector<SinumerikResult> found;
    ++at;
    while (true) {
      skip_line_blanks(code, at);
      if (at >= code.size()) refuse("call without its closing ')'; close it");
      if (code[at] == ')' && found.empty()) break;
      if (code[at] == ',' || code[at] == ')')
        found.push_back({std::nan(""), "", false});
      else
        found.push_back(formula(code, at).value());
      skip_line_blanks(code, at);
      if (at >= code.size()) refuse("call without its closing ')'; close it");
      if (code[at] == ')') break;
      if (code[at++] != ',') refuse("call with something between its values; correct it");
    }
    ++at;
    return found;
  }

  /// CALL "NAME", EXTCALL "NAME.SPF".
  void call_by_text(const std::string& code, std::size_t at) {
    skip_line_blanks(code, at);
    const bool in_parentheses = at < code.size() && code[at] == '(';
    if (in_parentheses) ++at;
    if (code.compare(at, 5, "BLOCK") == 0) refuse("CALL BLOCK is not read; post the program without it");
    const SinumerikResult name = formula(code, at).value();
    if (!name.is_text || name.text.empty()) refuse("CALL without the name of a subprogram in quotes; add it");
    if (in_parentheses && (at >= code.size() || code[at++] != ')'))
      refuse("call without its closing ')'; close it");
    require_end(code, at);
    std::string text = name.text;
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    for (const std::string_view ending : {".SPF", ".MPF", "_SPF", "_MPF"})
      if (text.ends_with(ending)) text.erase(text.size() - ending.size());
    if (text.starts_with("_N_")) text.erase(0, 3);
    enter(text, {}, 1);
  }

  void enter(const std::string& name, std::vector<SinumerikResult> arguments, int times) {
    if (static_cast<int>(frames_.size()) > rules_.most_calls)
      refuse(
          "over " + std::to_string(rules_.most_calls) +
          " calls within each other, at which the control stops; a subprogram may call itself without end");
    const auto [source, line] = place_of(name);
    if (times < 1) return;
    frames_.push_back(
        {.source = source, .next = line, .line = line, .first = line, .repeats = times - 1, .called = name});
    memory_.variables.emplace_back();
    repeated_.emplace_back();
    arguments_.push_back(std::move(arguments));
  }

  /// In the program's file, or in one beside it.
  std::pair<const MacroSource*, int> place_of(const std::string& name) {
    for (const MacroSource* source : {frame().source, frames_.front().source})
      if (const int line = indices_.at(source).program(name); line >= 0) return {source, line};
    std::string small = name;
    for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const std::string& stem : {name, small})
      for (const char* ending : {".SPF", ".spf", ".MPF", ".mpf"})
        if (const MacroSource* const source = other_file(stem + ending)) {
          if (indices_.find(source) == indices_.end()) indices_.emplace(source, LanguageIndex(*source));
          return {source, std::max(indices_.at(source).program(name), 0)};
        }
    refuse(name + " is neither a word that is read nor a subprogram, in the program or as " + name +
           ".SPF beside it; put the file there, or post without it");
  }

  void leave_subprogram() {
    blocks_.go_on();
    if (frame().repeats > 0) {
      --frame().repeats;
      frame().next = frame().first;
      memory_.variables.back().clear();
      repeated_.back().clear();
      return;
    }
    frames_.pop_back();
    memory_.variables.pop_back();
    repeated_.pop_back();
    arguments_.pop_back();
    if (!repeated_.back().empty()) end_of_repeated(frame().line);
  }

  // ------------------------------------------------------------------------------------------ plain blocks

  void plain(const LanguageLine& line) {
    const std::string text = plain_words(line.code);
    tell_calls();
    blocks_.execute(line.comment.empty() ? text : text + ";" + std::string(line.comment), shown_line());
    if (!blocks_.ended() || frames_.size() == 1) return;
    if (!has_code_word(line.code, "M17") && !has_code_word(line.code, "RET"))
      refuse("M2 or M30 ends a subprogram; end it by M17 or RET");
    leave_subprogram();
  }

  /// The block with numbers in place of its expressions.
  std::string plain_words(const std::string& code) {
    std::string out;
    std::size_t at = 0;
    while (skip_line_blanks(code, at), at < code.size()) {
      out += out.empty() ? "" : " ";
      if (code[at] == '$') {
        std::size_t end = at + 1;
        while (end < code.size() && (is_code_letter(code[end]) || is_code_digit(code[end]))) ++end;
        refuse(code.substr(at, end - at) +
               " is a value of the control, which is not read; post the program without it");
      }
      if (is_code_letter(code[at]))
        word(code, at, out);
      else
        out += code[at++];
    }
    return out;
  }

  void word(const std::string& code, std::size_t& at, std::string& out) {
    const bool is_letter = at + 1 >= code.size() || !is_code_letter(code[at + 1]);
    const std::size_t begin = at++;
    if (is_letter)
      while (at < code.size() && is_code_digit(code[at])) ++at;
    else
      while (at < code.size() && (is_code_letter(code[at]) || is_code_digit(code[at]))) ++at;
    std::size_t next = at;
    skip_line_blanks(code, next);
    const char follows = next < code.size() ? code[next] : '\0';
    const bool sets = follows == '=' && (next + 1 >= code.size() || code[next + 1] != '=');
    const std::string name = code.substr(begin, at - begin);
    const bool is_parameter = name.size() > 1 && name[0] == 'R' && is_letter;
    if (sets && (is_parameter || memory_.named(name)))
      refuse("what sets a parameter stands in a block of its own; split the block at '" + name + "='");
    out += name;
    if (sets) {
      out += '=';
      at = next + 1;
      return append_value(code, at, out);
    }
    if (!is_letter && follows == '(') {
      at = next;
      return append_call(code.substr(begin, next - begin), code, at, out);
    }
    // The rest of a number: a sign, a point.
    if (is_letter)
      while (at < code.size() &&
             (is_code_digit(code[at]) || code[at] == '.' || code[at] == '+' || code[at] == '-'))
        out += code[at++];
  }

  void append_value(const std::string& code, std::size_t& at, std::string& out) {
    skip_line_blanks(code, at);
    const std::string name = first_name(std::string_view(code).substr(std::min(at, code.size())));
    std::size_t next = at + name.size();
    skip_line_blanks(code, next);
    constexpr std::string_view kModes[] = {"AC", "IC", "DC", "ACP", "ACN"};
    const bool is_mode = std::find(std::begin(kModes), std::end(kModes), name) != std::end(kModes);
    if (is_mode && next < code.size() && code[next] == '(') {
      at = next + 1;
      out += name + "(" + sinumerik_number(formula(code, at).number()) + ")";
      skip_line_blanks(code, at);
      if (at >= code.size() || code[at++] != ')') refuse(name + "( lacks its ')'; close it");
      return;
    }
    const SinumerikResult value = formula(code, at).value();
    out += value.is_text ? "\"" + value.text + "\"" : sinumerik_number(value.number);
  }

  /// The values of a cycle; texts of messages stay as they are.
  void append_call(std::string name, const std::string& code, std::size_t& at, std::string& out) {
    while (!name.empty() && is_blank(name.back())) name.pop_back();
    if (name == "MSG" || name == "WORKPIECE" || name == "GROUP_BEGIN" || name == "GROUP_END" ||
        name == "CYCLE800") {
      const std::size_t close = code.rfind(')');
      const std::size_t end = close == std::string::npos ? code.size() : close + 1;
      out += name == "MSG" ? "(\"\")" : code.substr(at, end - at);
      at = end;
      return;
    }
    out += '(';
    ++at;
    for (bool first = true;; first = false) {
      skip_line_blanks(code, at);
      if (at >= code.size()) refuse("call without its closing ')'; close it");
      if (code[at] == ')') break;
      if (!first || code[at] == ',') {
        if (code[at] != ',') refuse("call with something between its values; correct it");
        if (first) {
          out += ',';
          ++at;
          append_argument(code, at, out);
          continue;
        }
        out += ',';
        ++at;
      }
      append_argument(code, at, out);
    }
    ++at;
    out += ')';
  }

  void append_argument(const std::string& code, std::size_t& at, std::string& out) {
    skip_line_blanks(code, at);
    if (at >= code.size() || code[at] == ',' || code[at] == ')') return;
    if (code[at] == '_') {  // _FINISH and its like stand for numbers
      const std::string name = first_name(std::string_view(code).substr(at));
      out += name;
      at += name.size();
      return;
    }
    const SinumerikResult value = formula(code, at).value();
    out += value.is_text ? "\"" + value.text + "\"" : sinumerik_number(value.number);
  }

  const SinumerikBlocks& blocks_;
  const DialectRules& rules_;
  RefuseBlock refuse_ = [this](const std::string& why) { refuse(why); };
  SinumerikMemory memory_;
  std::map<const MacroSource*, LanguageIndex> indices_;
  std::vector<std::vector<RepeatedLines>> repeated_;     ///< of each frame
  std::vector<std::vector<SinumerikResult>> arguments_;  ///< of each frame's call
};

}  // namespace

bool run_sinumerik(std::string_view text, const std::string& file_name, const SinumerikBlocks& blocks,
                   const DialectRules& rules, const ReadControllerOptions& options,
                   ToolpathBuilder& builder) {
  return SinumerikRun(blocks, rules, options, builder).run(text, file_name);
}

}  // namespace clearcut::read::gcode
