#include "read/gcode/macros/macro_run.h"

#include "base/error.h"
#include "base/file.h"
#include "read/gcode/program/program.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {

namespace {

/// Characters; longer lines count as several.
constexpr std::size_t kLengthOfStep = 128;

}  // namespace

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  Lines reader(text);
  for (std::string_view line; reader.next(line);) lines.push_back(line);
  return lines;
}

void ProgramRun::count_step(std::size_t length) {
  steps_ += 1 + static_cast<long long>(length / kLengthOfStep);
  if (steps_ > options_.most_lines)
    refuse("over " + std::to_string(options_.most_lines) +
           " lines are executed up to here; a loop that never ends, or too long a program for macros");
}

std::string ProgramRun::place() const {
  return frame().source->place(frame().line);
}

void ProgramRun::refuse(const std::string& what) const {
  throw InputError(place(), what);
}

int ProgramRun::shown_line() const {
  for (std::size_t k = frames_.size(); k-- > 0;)
    if (frames_[k].source == frames_.front().source) return frames_[k].line + 1;
  return frames_.front().line + 1;
}

void ProgramRun::rethrow(const std::string& message) const {
  if (frames_.size() == 1) throw InputError("", message);
  std::string text = message;
  const std::string shown = builder_.place(shown_line()) + ": ";
  if (text.rfind(shown, 0) == 0) text = place() + ": " + text.substr(shown.size());
  throw InputError("", text + " (" + calls() + ")");
}

std::string ProgramRun::calls() const {
  std::string calls;
  constexpr std::size_t kMostCallsTold = 3;
  for (std::size_t k = frames_.size() - 1; k > 0 && frames_.size() - k <= kMostCallsTold; --k)
    calls += (calls.empty() ? "" : ", ") + frames_[k].called + " called in " +
             frames_[k - 1].source->place(frames_[k - 1].line);
  return calls;
}

void ProgramRun::tell_calls() {
  const bool is_called = frames_.size() > 1;
  if (!is_called && !told_calls_) return;
  told_calls_ = is_called;
  builder_.set_calls(is_called ? place() + ", " + calls() : "");
}

void MacroRun::execute(Block& block) {
  block.line = shown_line();
  for (const std::string_view comment : block.comments) read_marker(comment, builder_);
  if (!block.has_words()) return;
  tell_calls();
  interpreter_.execute(block);
}

const MacroSource* ProgramRun::other_file(const std::string& name) {
  for (const auto& source : sources_)
    if (source->name == name) return source.get();
  if (!options_.subprograms) return nullptr;
  std::optional<std::string> text = options_.subprograms(name);
  if (!text) return nullptr;
  auto source = std::make_unique<MacroSource>();
  source->name = name;
  source->text = std::move(*text);
  source->lines = lines_of(source->text);
  builder_.condition("subprogram-" + std::to_string(sources_.size() + 1), shown_line(),
                     "the control runs the file " + name + " that is read here, SHA-256 " +
                         sha256_hex(source->text).substr(0, 16));
  sources_.push_back(std::move(source));
  return sources_.back().get();
}

}  // namespace clearcut::read::gcode
