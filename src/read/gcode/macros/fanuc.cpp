#include <algorithm>
#include <cctype>
#include <map>

#include "base/error.h"
#include "base/text.h"
#include "read/gcode/macros/fanuc_variables.h"
#include "read/gcode/macros/macro_run.h"
#include "read/gcode/words/block.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {

namespace {

/// Macros that G65 calls within each other: there are five levels of local variables.
constexpr std::size_t kMostMacros = 4;

/// Where programs, block numbers and loops of a source stand. Lines count from 0.
class FanucIndex {
 public:
  explicit FanucIndex(const MacroSource& source) {
    for (std::size_t k = 0; k < source.lines.size(); ++k) enter(static_cast<int>(k), source.lines[k]);
    program_lines_.push_back(static_cast<int>(source.lines.size()));
  }

  /// Line of "O1234", -1 where there is none.
  int program(int number) const {
    const auto found = programs_.find(number);
    return found == programs_.end() ? -1 : found->second;
  }
  bool begins_program(int line) const {
    return std::binary_search(program_lines_.begin(), program_lines_.end() - 1, line);
  }
  /// Line of block `number` in the program that `line` is part of: the next one behind it, else the first; -1.
  int block(int number, int line) const {
    const auto end = std::upper_bound(program_lines_.begin(), program_lines_.end(), line);
    const int behind = end == program_lines_.end() ? program_lines_.back() : *end;
    const int first = end == program_lines_.begin() ? 0 : *(end - 1);
    const auto found = blocks_.find(number);
    if (found == blocks_.end()) return -1;
    const std::vector<int>& lines = found->second;
    const auto next = std::lower_bound(lines.begin(), lines.end(), line);
    if (next != lines.end() && *next < behind) return *next;
    const auto earlier = std::lower_bound(lines.begin(), lines.end(), first);
    return earlier != lines.end() && *earlier < behind ? *earlier : -1;
  }
  /// The other end of the loop that begins or ends at `line`; -1.
  int partner(int line) const {
    const auto found = partners_.find(line);
    return found == partners_.end() ? -1 : found->second;
  }

 private:
  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  void enter(int line, std::string_view text) {
    std::size_t at = 0;
    const auto next = [&]() -> char {
      while (at < text.size() && (is_blank(text[at]) || text[at] == '/')) ++at;
      return at < text.size() ? static_cast<char>(std::toupper(static_cast<unsigned char>(text[at]))) : '\0';
    };
    char c = next();
    if (c == 'N') {
      ++at;
      blocks_[number_at(text, at)].push_back(line);
      c = next();
    }
    if (c == 'O' || c == ':') {
      ++at;
      if (!is_digit(next())) return;
      const int number = number_at(text, at);
      programs_.emplace(number, line);
      program_lines_.push_back(line);
      open_.clear();
    } else if (c == 'D' || c == 'W' || c == 'E') {
      enter_loop(line, text);
    }
  }

  static int number_at(std::string_view text, std::size_t& at) {
    int number = 0;
    for (; at < text.size() && (is_digit(text[at]) || is_blank(text[at])); ++at)
      if (is_digit(text[at]) && number < 100'000'000) number = number * 10 + (text[at] - '0');
    return number;
  }

  void enter_loop(int line, std::string_view text) {
    std::string clean;
    try {
      clean = cleaned(text, "").text;
    } catch (const InputError&) {
      return;  // reported when the line is executed
    }
    if (clean.size() < 3) return;
    const bool ends = clean.rfind("END", 0) == 0;
    const bool begins = clean.rfind("DO", 0) == 0 || clean.rfind("WHILE", 0) == 0;
    if (!is_digit(clean.back()) || (!ends && !begins)) return;
    const char label = clean.back();
    if (begins) {
      open_[label] = line;
      return;
    }
    const auto start = open_.find(label);
    if (start == open_.end()) return;
    partners_[line] = start->second;
    partners_[start->second] = line;
    open_.erase(start);
  }

  std::map<int, int> programs_;
  std::vector<int> program_lines_;
  std::map<int, std::vector<int>> blocks_;
  std::map<int, int> partners_;
  std::map<char, int> open_;
};

class FanucRun : private MacroRun {
 public:
  FanucRun(Interpreter& interpreter, ToolpathBuilder& builder, const DialectRules& rules,
           const ReadControllerOptions& options)
      : MacroRun(interpreter, builder, rules, options),
        variables_(interpreter.control()),
        style_(rules.macros == MacroLanguage::kMach ? MacroStyle::kLinuxCnc : MacroStyle::kFanuc) {}

  bool run(std::string_view text, const std::string& file_name) {
    MacroSource main;
    main.name = file_name;
    main.lines = lines_of(text);
    indices_.emplace(&main, FanucIndex(main));
    frames_.push_back({.source = &main, .called = file_name});
    return run_steps([this] { return step(); });
  }

 private:
  const FanucIndex& index() const { return indices_.at(frame().source); }

  /// Executes one line; false at the end of the program.
  bool step() {
    MacroFrame& now = frame();
    const auto& lines = now.source->lines;
    const bool is_out = now.next >= static_cast<int>(lines.size()) ||
                        (now.next > now.first && program_seen_ && index().begins_program(now.next));
    if (is_out) {
      if (frames_.size() == 1) return false;
      refuse("the subprogram has no M99; add it at its end");
    }
    now.line = now.next++;
    interpreter_.control().line = shown_line();
    const std::string_view line = lines[static_cast<std::size_t>(now.line)];
    count_step(line.size());
    const std::string at = place();
    const CleanLine clean = cleaned(line, at);
    program_seen_ = program_seen_ || index().begins_program(now.line);
    if (frames_.size() == 1 && marks_.ends(clean.is_percent, !clean.text.empty() && !clean.is_percent)) {
      tape_ended_ = true;
      return false;
    }
    if (!prints(clean) && !flow(clean, at)) words(clean, 0, at);
    return true;
  }

  /// POPEN, DPRNT[..], BPRNT[..] and PCLOS write to a file or a serial line: nothing of it moves or is kept.
  bool prints(const CleanLine& clean) {
    const auto begins = [&](std::string_view word) { return clean.text.rfind(word, 0) == 0; };
    if (!begins("POPEN") && !begins("PCLOS") && !begins("DPRNT") && !begins("BPRNT")) return false;
    if (clean.is_optional) interpreter_.note_block_delete();
    const std::string word = clean.text.substr(0, 5);
    if (rules_.macros == MacroLanguage::kMach)
      refuse(word + " is no word of " + std::string(rules_.title) + "; post the program without it");
    builder_.note(shown_line(), "POPEN, DPRNT, BPRNT and PCLOS print, which moves nothing");
    return true;
  }

  // ------------------------------------------------------------------------------------------ jumps and loops

  /// Whether the line jumps or loops.
  bool flow(const CleanLine& clean, const std::string& at) {
    const auto begins = [&](std::string_view word) { return clean.text.rfind(word, 0) == 0; };
    const bool is_flow = begins("IF") || begins("GOTO") || begins("WHILE") || begins("DO") || begins("END");
    if (!is_flow) return false;
    if (clean.is_optional) interpreter_.note_block_delete();
    if (rules_.macros == MacroLanguage::kMach)
      refuse("jumps and loops are no words of " + std::string(rules_.title) +
             "; name --dialect fanuc or haas, or post without them");
    std::size_t from = 0;
    Expression expression(clean.text, from, style_, variables_, at);
    if (expression.skip("IF")) {
      branch(expression, clean, from, at);
    } else if (expression.skip("GOTO")) {
      jump(expression);
    } else if (expression.skip("WHILE")) {
      const bool holds = condition_of(expression);
      if (!expression.skip("DO")) refuse("WHILE without its DO; add it");
      if (!holds) leave_loop();
    } else if (expression.skip("END")) {
      const int start = index().partner(frame().line);
      if (start < 0) refuse("END without its DO before; correct its number");
      frame().next = start;
    } else if (index().partner(frame().line) < 0) {
      refuse("DO without its END; add it");
    }
    return true;
  }

  bool condition_of(Expression& expression) {
    if (expression.next() != '[') refuse("a condition in brackets is missing; add it");
    return expression.sum().number != 0;
  }

  void branch(Expression& expression, const CleanLine& clean, const std::size_t& from,
              const std::string& at) {
    const bool holds = condition_of(expression);
    if (expression.skip("THEN")) {
      if (holds) words(clean, from, at);
    } else if (expression.skip("GOTO")) {
      if (holds) jump(expression);
    } else {
      refuse("IF without GOTO or THEN; add it");
    }
  }

  void leave_loop() {
    const int end = index().partner(frame().line);
    if (end < 0) refuse("WHILE without its END; add it");
    frame().next = end + 1;
  }

  void jump(Expression& expression) {
    go_to(whole_number(expression.value().number, "the block to which GOTO jumps", place()));
  }

  void go_to(int number) {
    const int line = index().block(number, frame().line + 1);
    if (line < 0)
      refuse("there is no block N" + std::to_string(number) + " in this program; correct the jump");
    frame().next = line;
  }

  // ------------------------------------------------------------------------------------------ words and calls

  bool has_m(int code) const { return std::find(block_.m.begin(), block_.m.end(), code) != block_.m.end(); }
  void drop_m(int code) {
    block_.m.erase(std::remove(block_.m.begin(), block_.m.end(), code), block_.m.end());
  }

  void words(const CleanLine& clean, std::size_t from, const std::string& at) {
    block_.clear();
    const std::size_t call = clean.text.find("G65", from);
    const bool is_call =
        call != std::string::npos &&
        !std::isdigit(static_cast<unsigned char>(call + 3 < clean.text.size() ? clean.text[call + 3] : ' '));
    if (is_call && rules_.macros == MacroLanguage::kFanuc) {
      arguments_.clear();
      compute_words(clean, call + 3, style_, variables_, at, block_, &arguments_);
      return call_macro();
    }
    compute_words(clean, from, style_, variables_, at, block_);
    if (has_g(block_, 660)) refuse("G66 calls a macro after every move, which is not read; call it by G65");
    if (has_m(980) || (has_m(970) && rules_.calls_blocks)) return call_program();
    if (has_m(990)) return return_or_again();
    execute(block_);
  }

  int whole_word(char letter, int other) const {
    if (!block_.has(letter)) return other;
    return whole_number(block_.value(letter), std::string("the ") + letter + " word of a call", place());
  }

  void execute_rest() {
    block_.unset('P');
    block_.unset('L');
    execute(block_);
  }

  void call_program() {
    const bool is_local = has_m(970) && rules_.calls_blocks;
    if (!block_.has('P')) refuse("a call without its P word; give the number of the subprogram");
    if (block_.has('Q') || block_.has('H'))
      refuse("a call that begins within a subprogram is not read; call it from its start");
    int number = whole_word('P', 0), repeats = whole_word('L', 1);
    constexpr int kNumbers = 10000;  // O0000 to O9999
    if (!is_local && rules_.count_in_program_number && number >= kNumbers && !block_.has('L')) {
      repeats = number / kNumbers;
      number %= kNumbers;
    }
    drop_m(is_local ? 970 : 980);
    execute_rest();
    if (interpreter_.ended() || repeats < 1) return;
    if (is_local) {
      const int line = index().block(number, frame().line + 1);
      if (line < 0)
        refuse("there is no block N" + std::to_string(number) + " in this program; correct the call");
      return enter(frame().source, line, repeats, "N" + std::to_string(number));
    }
    call(number, repeats);
  }

  void call_macro() {
    const std::string at = place();
    if (!block_.has('P')) refuse("G65 without its P word; give the number of the macro");
    const int number = whole_word('P', 0), repeats = whole_word('L', 1);
    if (repeats < 1) return;
    if (variables_.macros() >= kMostMacros)
      refuse(
          "over " + std::to_string(kMostMacros) +
          " macros call each other by G65, at which the control stops; a macro may call itself without end");
    FanucVariables::Locals locals = arguments_of(arguments_, at);
    call(number, repeats);
    calls_.push_back(locals);
    variables_.enter(std::move(locals));
    frame().has_own_variables = true;
  }

  void call(int number, int repeats) {
    const std::string name = "O" + std::to_string(number);
    for (const MacroSource* source : {frame().source, frames_.front().source})
      if (const int line = indices_.at(source).program(number); line >= 0)
        return enter(source, line, repeats, name);
    const MacroSource* const source = file_of(number);
    if (!source)
      refuse("subprogram " + name +
             " is neither in the program nor in a file of that name beside it; put the file there");
    if (indices_.find(source) == indices_.end()) indices_.emplace(source, FanucIndex(*source));
    enter(source, std::max(indices_.at(source).program(number), 0), repeats, name);
  }

  /// O1234, O01234.nc, 1234.nc and so on.
  const MacroSource* file_of(int number) {
    const std::string digits = std::to_string(number);
    for (const std::size_t width : {std::size_t{4}, std::size_t{5}, digits.size()}) {
      const std::string padded = std::string(width > digits.size() ? width - digits.size() : 0, '0') + digits;
      for (const char* start : {"O", "o", ""})
        for (const char* ending : {".nc", ".NC", ".tap", ".cnc", ""}) {
          if (*start == '\0' && *ending == '\0') continue;
          if (const MacroSource* const source = other_file(start + padded + ending)) return source;
        }
    }
    return nullptr;
  }

  void enter(const MacroSource* source, int line, int repeats, const std::string& name) {
    if (static_cast<int>(frames_.size()) > rules_.most_calls)
      refuse(
          "over " + std::to_string(rules_.most_calls) +
          " calls within each other, at which the control stops; a subprogram may call itself without end");
    frames_.push_back({.source = source,
                       .next = line,
                       .line = line,
                       .first = line,
                       .repeats = repeats - 1,
                       .called = name});
  }

  /// M99: back to the call, or to a block of it; in the main program to its start.
  void return_or_again() {
    const bool has_place = block_.has('P');
    const int number = whole_word('P', 0);
    if (frames_.size() == 1) {
      if (!has_place) return execute(block_);
      drop_m(990);
      execute_rest();
      return go_to(number);
    }
    drop_m(990);
    execute_rest();
    if (interpreter_.ended()) return;
    if (frame().repeats > 0 && !has_place) {
      --frame().repeats;
      frame().next = frame().first;
      if (frame().has_own_variables) {
        variables_.leave();
        variables_.enter(calls_.back());
      }
      return;
    }
    if (frame().has_own_variables) {
      variables_.leave();
      calls_.pop_back();
    }
    frames_.pop_back();
    if (has_place) go_to(number);
  }

  FanucVariables variables_;
  MacroStyle style_;
  std::map<const MacroSource*, FanucIndex> indices_;
  std::vector<ArgumentWord> arguments_;
  std::vector<FanucVariables::Locals> calls_;  ///< arguments of the macros that run
  Block block_;
  TapeMarks marks_;
  bool program_seen_ = false;
};

}  // namespace

bool run_fanuc(std::string_view text, const std::string& file_name, Interpreter& interpreter,
               ToolpathBuilder& builder, const DialectRules& rules, const ReadControllerOptions& options) {
  return FanucRun(interpreter, builder, rules, options).run(text, file_name);
}

}  // namespace clearcut::read::gcode
