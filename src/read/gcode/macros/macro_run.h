// Runs of programs with macros, of Fanuc's Custom Macro (which Haas took over, and of which Mach has variables and
// M98) and of LinuxCNC: their files, how far they may go, who called whom.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "read/gcode/control/control.h"
#include "read/gcode/control/interpreter.h"
#include "read/gcode/macros/macro_line.h"

namespace clearcut::read::gcode {

/// A program or a file of subprograms, cut into lines.
struct MacroSource {
  std::string name;                     ///< as messages say it
  std::string text;                     ///< of other files; the program's own belongs to who reads it
  std::vector<std::string_view> lines;  ///< from 0

  std::string place(int line) const { return name + ":" + std::to_string(line + 1); }
};
std::vector<std::string_view> lines_of(std::string_view text);

/// Where a program goes on, of its main part or of a subprogram that was called.
struct MacroFrame {
  const MacroSource* source = nullptr;
  int next = 0;                    ///< line that is executed next, from 0
  int line = 0;                    ///< line that is executed
  int first = 0;                   ///< where a repeated call begins again
  int repeats = 0;                 ///< left of M98 L
  std::string called;              ///< as messages say it: "o100", "O1000"
  bool has_own_variables = false;  ///< else those of who called
};

/// A program that computes, loops and calls: counts what is executed, knows who called whom, and tells where things go wrong.
class ProgramRun {
 protected:
  ProgramRun(ToolpathBuilder& builder, const ReadControllerOptions& options)
      : builder_(builder), options_(options) {}

  /// Throws InputError where more is executed than any program needs.
  void count_step(std::size_t length);
  std::string place() const;
  [[noreturn]] void refuse(const std::string& what) const;
  /// The message of an error at the line that is executed, with the calls that led there.
  [[noreturn]] void rethrow(const std::string& message) const;
  /// Lines of other files are counted at the call in the program.
  int shown_line() const;
  /// The moves that follow come from the line that is executed.
  void tell_calls();
  /// Under the condition that the control has the same file.
  const MacroSource* other_file(const std::string& name);
  const MacroFrame& frame() const { return frames_.back(); }
  MacroFrame& frame() { return frames_.back(); }

  ToolpathBuilder& builder_;
  const ReadControllerOptions& options_;
  std::vector<MacroFrame> frames_;
  std::vector<std::unique_ptr<MacroSource>> sources_;

 private:
  /// "O1 called in part.nc:7, O2 called in part.nc:3"; at most a few.
  std::string calls() const;

  long long steps_ = 0;
  bool told_calls_ = false;
};

/// A run of a word-address program.
class MacroRun : protected ProgramRun {
 public:
  MacroRun(Interpreter& interpreter, ToolpathBuilder& builder, const DialectRules& rules,
           const ReadControllerOptions& options)
      : ProgramRun(builder, options), interpreter_(interpreter), rules_(rules) {}

 protected:
  /// Executes lines by `step`, which says whether the program goes on, until its end. Whether that was reached. Errors tell the calls.
  template <typename Step>
  bool run_steps(Step step) {
    try {
      while (!interpreter_.ended() && step()) {
      }
    } catch (const InputError& error) {
      rethrow(error.what());
    }
    return interpreter_.ended() || tape_ended_;
  }
  /// Executes the words of a block at the place where the program is.
  void execute(Block& block);

  Interpreter& interpreter_;
  const DialectRules& rules_;
  bool tape_ended_ = false;  ///< by the % that ends a tape
};

/// Executes the program as the control does; whether an end word was seen. Throws InputError("file:line", ...) for what the control would
/// not take, for what nothing states, and where the program does not end in a bounded number of lines.
bool run_fanuc(std::string_view text, const std::string& file_name, Interpreter& interpreter,
               ToolpathBuilder& builder, const DialectRules& rules, const ReadControllerOptions& options);

/// Executes the program as the control does; whether an end word was seen. Throws InputError("file:line", ...) for what the control would not take, for
/// what nothing states, and where the program does not end in a bounded number of lines.
bool run_linuxcnc(std::string_view text, const std::string& file_name, Interpreter& interpreter,
                  ToolpathBuilder& builder, const DialectRules& rules, const ReadControllerOptions& options);

}  // namespace clearcut::read::gcode
