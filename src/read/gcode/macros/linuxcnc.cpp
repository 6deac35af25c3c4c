#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "read/gcode/macros/linuxcnc_parameters.h"
#include "read/gcode/macros/macro_run.h"
#include "read/gcode/macros/o_words.h"
#include "read/gcode/words/block.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {

namespace {

/// INTERP_SUB_ROUTINE_LEVELS of its sources, without the main program.
constexpr std::size_t kMostCalls = 9;
constexpr std::size_t kMostArguments = 30;
constexpr double kMostRepeats = 1e9;
constexpr std::size_t kLongestLine = 252;

class LinuxCncRun : private MacroRun {
 public:
  LinuxCncRun(Interpreter& interpreter, ToolpathBuilder& builder, const DialectRules& rules,
              const ReadControllerOptions& options)
      : MacroRun(interpreter, builder, rules, options), parameters_(interpreter.control()) {}

  bool run(std::string_view text, const std::string& file_name) {
    MacroSource main;
    main.name = file_name;
    main.lines = lines_of(text);
    words_.emplace(&main, OWords(main));
    frames_.push_back({.source = &main, .called = file_name});
    loops_.emplace_back();
    return run_steps([this] { return step(); });
  }

 private:
  const OWords& words() const { return words_.at(frame().source); }

  /// Executes one line; false at the end of the text.
  bool step() {
    MacroFrame& now = frame();
    const auto& lines = now.source->lines;
    if (now.next >= static_cast<int>(lines.size())) {
      if (frames_.size() == 1) return false;
      refuse("the file ends within the subroutine; add its endsub, or M99");
    }
    now.line = now.next++;
    interpreter_.control().line = shown_line();
    const std::string_view line = lines[static_cast<std::size_t>(now.line)];
    count_step(line.size());
    if (line.size() > kLongestLine)
      refuse("a line of over 252 characters, at which the control stops; split it");
    const std::string at = place();
    const CleanLine clean = cleaned(line, at);
    if (frames_.size() == 1 && marks_.ends(clean.is_percent, !clean.text.empty() && !clean.is_percent)) {
      tape_ended_ = true;
      return false;
    }
    if (const OLine* const word = words().at(now.line)) {
      if (clean.is_optional) interpreter_.note_block_delete();
      control_flow(*word, clean);
      return true;
    }
    plain(clean, at);
    return true;
  }

  void plain(const CleanLine& clean, const std::string& at) {
    block_.clear();
    compute_words(clean, 0, MacroStyle::kLinuxCnc, parameters_, at, block_);
    const auto has_m = [&](int code) {
      return std::find(block_.m.begin(), block_.m.end(), code) != block_.m.end();
    };
    if (has_m(980) && block_.has('P')) return call_program();
    if (has_m(990) && frames_.size() > 1) return return_from_program();
    if (has_m(730)) restores_.back() = true;
    execute(block_);
  }

  // ------------------------------------------------------------------------------------------ O words

  double value_at(const CleanLine& clean, std::size_t& at) {
    const std::string where = place();
    Expression expression(clean.text, at, MacroStyle::kLinuxCnc, parameters_, where);
    if (expression.next() != '[') refuse("a value in brackets is missing behind the O word; add it");
    return expression.value().number;
  }
  bool holds(const OLine& word, const CleanLine& clean) {
    std::size_t at = word.rest;
    return value_at(clean, at) != 0;
  }
  CleanLine clean_at(int line) const {
    return cleaned(frame().source->lines[static_cast<std::size_t>(line)], frame().source->place(line));
  }
  const OLine& first_of(const OLine& word) const {
    if (word.start < 0) refuse("o" + word.name + " has no beginning before this line; correct its label");
    return *words().at(word.start);
  }
  int end_of(const OLine& first) const {
    if (first.end < 0) refuse("o" + first.name + " has no end; add its line");
    return first.end;
  }

  void control_flow(const OLine& word, const CleanLine& clean) {
    if (word.twin >= 0)
      refuse("label o" + word.name + " stands for another structure in line " +
             std::to_string(word.twin + 1) + ", at which the control stops; give it a number of its own");
    switch (word.keyword) {
      case OKeyword::kProgram:
        return;
      case OKeyword::kSub:
        frame().next = end_of(word) + 1;
        return;
      case OKeyword::kCall:
        return call(word.name, clean, word.rest);
      case OKeyword::kComputed:
        return computed_call(clean, word.rest);
      case OKeyword::kEndSub:
      case OKeyword::kReturn:
        return return_from_sub(word, clean);
      case OKeyword::kIf:
        return branch(&word, clean);
      case OKeyword::kElseIf:
      case OKeyword::kElse:
      case OKeyword::kEndIf:
        frame().next = end_of(first_of(word)) + 1;
        return;
      default:
        return loop(word, clean);
    }
  }

  /// From IF on to the first branch that holds.
  void branch(const OLine* word, const CleanLine& clean) {
    const int end = end_of(*word);
    if (holds(*word, clean)) return;
    while (word->next >= 0 && word->next != end) {
      frame().line = word->next;
      word = words().at(word->next);
      const CleanLine next = clean_at(frame().line);
      count_step(next.text.size());
      if (word->keyword == OKeyword::kElse || holds(*word, next)) {
        frame().next = frame().line + 1;
        return;
      }
    }
    frame().next = end + 1;
  }

  void loop(const OLine& word, const CleanLine& clean) {
    MacroFrame& now = frame();
    std::map<int, long long>& counts = loops_.back();
    const OLine& first = first_of(word);
    const int end = end_of(first);
    switch (word.keyword) {
      case OKeyword::kWhile:
        if (!holds(word, clean)) now.next = end + 1;
        return;
      case OKeyword::kEndWhile:
        now.next = word.start;
        return;
      case OKeyword::kDoWhile:
        if (holds(word, clean) && !ends_by_earlier_break()) now.next = word.start + 1;
        left_while_ = false;
        return;
      case OKeyword::kRepeat: {
        std::size_t at = word.rest;
        const double count = std::clamp(value_at(clean, at), -kMostRepeats, kMostRepeats);
        counts[now.line] = static_cast<long long>(std::nearbyint(count));  // halves to the even number
        if (counts[now.line] < 1) now.next = end + 1;
        return;
      }
      case OKeyword::kEndRepeat:
        if (--counts[word.start] > 0) now.next = word.start + 1;
        return;
      case OKeyword::kBreak:
        refuse_in_repeat(first);
        left_while_ = first.keyword == OKeyword::kWhile;
        now.next = end + 1;
        return;
      case OKeyword::kContinue:
        refuse_in_repeat(first);
        now.next = first.keyword == OKeyword::kWhile ? word.start : end;
        return;
      default:
        return;
    }
  }

  /// The interpreter remembers a break until the end of the next do loop, whichever loop it left.
  bool ends_by_earlier_break() {
    if (left_while_)
      builder_.condition(
          "do-after-break", shown_line(),
          "LinuxCNC ends a do loop after its first pass where a while loop was left by break before "
          "it, as version 2.9 does");
    return left_while_;
  }

  void refuse_in_repeat(const OLine& first) const {
    if (first.keyword == OKeyword::kRepeat)
      refuse("break and continue within repeat stop the control; use while");
  }

  // ------------------------------------------------------------------------------------------ calls

  void computed_call(const CleanLine& clean, std::size_t at) {
    const std::string where = place();
    Expression expression(clean.text, at, MacroStyle::kLinuxCnc, parameters_, where);
    const int number = whole_number(expression.value().number, "the number of an O word", where);
    if (!expression.skip("CALL"))
      refuse("of O words with a computed number only calls are read; write the number");
    call(std::to_string(number), clean, at);
  }

  void call(const std::string& name, const CleanLine& clean, std::size_t at) {
    LocalParameters locals;
    locals.all_stated = true;
    int number = 0;
    while (at < clean.text.size()) {
      if (number == static_cast<int>(kMostArguments)) refuse("a call takes at most 30 arguments; pass fewer");
      locals.numbered[++number] = value_at(clean, at);
    }
    const auto [source, line] = find_sub(name);
    enter({.source = source, .next = line + 1, .line = line, .first = line + 1, .called = "o" + name});
    parameters_.enter(std::move(locals));
    frame().has_own_variables = true;
    parameters_.set_returned(std::nullopt);
  }

  struct Place {
    const MacroSource* source;
    int line;
  };
  Place find_sub(const std::string& name) {
    for (const MacroSource* source : {frame().source, frames_.front().source})
      if (const int line = words_.at(source).sub(name); line >= 0) return {source, line};
    const std::string file = name + ".ngc";
    const MacroSource* const source = other_file(file);
    if (!source)
      refuse("subroutine o" + shown(name) + " is neither in the program nor in a file " + file +
             " beside it; put the file there");
    if (words_.find(source) == words_.end()) words_.emplace(source, OWords(*source));
    const int line = words_.at(source).sub(name);
    if (line < 0) refuse("the file " + file + " has no line 'o" + shown(name) + " sub'; correct it");
    return {source, line};
  }
  static std::string shown(const std::string& name) {
    const bool is_number = name.find_first_not_of("0123456789") == std::string::npos;
    return is_number ? name : "<" + name + ">";
  }

  void enter(MacroFrame next) {
    if (frames_.size() > kMostCalls)
      refuse(
          "over " + std::to_string(kMostCalls) +
          " calls within each other, at which the control stops; a subroutine may call itself without end");
    frames_.push_back(std::move(next));
    loops_.emplace_back();
    restores_.push_back(false);
    saved_.push_back(interpreter_.mode_words().exchange_saved(std::nullopt));
    parameters_.level = static_cast<int>(frames_.size()) - 1;
  }

  void leave() {
    if (restores_.back()) interpreter_.mode_words().save_or_restore(720);
    interpreter_.mode_words().exchange_saved(std::move(saved_.back()));
    saved_.pop_back();
    restores_.pop_back();
    if (frame().has_own_variables) parameters_.leave();
    frames_.pop_back();
    loops_.pop_back();
    parameters_.level = static_cast<int>(frames_.size()) - 1;
  }

  void return_from_sub(const OLine& word, const CleanLine& clean) {
    if (frames_.size() == 1) refuse("a return outside of any subroutine; take it out");
    std::optional<double> value;
    std::size_t at = word.rest;
    if (at < clean.text.size()) value = value_at(clean, at);
    leave();
    parameters_.set_returned(value);
  }

  /// M98 P L; the subprogram has the parameters of who calls it.
  void call_program() {
    const std::string where = place();
    const int number = whole_number(block_.value('P'), "the P word of M98", where);
    const int repeats = block_.has('L') ? whole_number(block_.value('L'), "the L word of M98", where) : 1;
    if (repeats < 1) return;
    const std::string name = std::to_string(number);
    const MacroSource* source = frame().source;
    int line = words_.at(source).program(name);
    if (line < 0) {
      source = frames_.front().source;
      line = words_.at(source).program(name);
    }
    if (line < 0)
      if (const MacroSource* const other = other_file(name + ".ngc")) {
        source = other;
        if (words_.find(source) == words_.end()) words_.emplace(source, OWords(*source));
        line = words_.at(source).program(name);
      }
    if (line < 0)
      refuse("subprogram O" + name + " is neither in the program nor in a file " + name +
             ".ngc beside it; put the file there");
    enter({.source = source,
           .next = line + 1,
           .line = line,
           .first = line + 1,
           .repeats = repeats - 1,
           .called = "O" + name});
  }

  void return_from_program() {
    if (frame().repeats > 0) {
      --frame().repeats;
      frame().next = frame().first;
      return;
    }
    leave();
  }

  LinuxCncParameters parameters_;
  std::map<const MacroSource*, OWords> words_;
  bool left_while_ = false;                      ///< by break, and no do loop ended since
  std::vector<std::map<int, long long>> loops_;  ///< turns left of REPEAT by its line, of each call
  std::vector<bool> restores_{false};            ///< M73 was seen, of each call
  std::vector<std::optional<Modes>> saved_;      ///< by M70 before each call
  Block block_;
  TapeMarks marks_;
};

}  // namespace

bool run_linuxcnc(std::string_view text, const std::string& file_name, Interpreter& interpreter,
                  ToolpathBuilder& builder, const DialectRules& rules, const ReadControllerOptions& options) {
  return LinuxCncRun(interpreter, builder, rules, options).run(text, file_name);
}

}  // namespace clearcut::read::gcode
