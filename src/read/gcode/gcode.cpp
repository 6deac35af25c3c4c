#include "read/gcode/gcode.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "read/gcode/control/interpreter.h"
#include "read/gcode/klartext/klartext.h"
#include "read/gcode/klartext/words.h"
#include "read/gcode/macros/macro_run.h"
#include "read/gcode/program/program.h"
#include "read/gcode/recognise.h"
#include "read/gcode/sinumerik/sinumerik.h"
#include "read/gcode/sinumerik/words.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {

namespace {

using read::gcode::Block;

/// s; likewise.
constexpr double kSameWait = 1e-6;

/// The line of the first block after an end, 0 where there is none: also behind the percent sign that ends the tape, where
/// another program may follow. What is no code there matters to nobody.
int next_block(read::gcode::BlockReader& reader) {
  Block block;
  try {
    while (reader.next(block)) {
      if (block.has_words()) return block.line;
    }
  } catch (const InputError&) {
    return 0;
  }
  return 0;
}

/// What a control never runs may be what somebody wanted to be cut.
void warn_of_blocks_behind(int end, read::gcode::BlockReader& reader, read::gcode::ToolpathBuilder& builder) {
  const int line = next_block(reader);
  if (line == 0) return;
  builder.warn(line, "what follows the end word in line " + std::to_string(end) + " is not run");
}

/// Returns whether an end was seen.
bool read_words(std::string_view text, const std::string& file_name, read::gcode::Interpreter& interpreter,
                read::gcode::ToolpathBuilder& builder) {
  read::gcode::BlockReader reader(text, file_name);
  TapeMarks marks;
  Block block;
  while (!interpreter.ended() && reader.next(block)) {
    for (const std::string_view comment : block.comments) read::gcode::read_marker(comment, builder);
    if (marks.ends(block.percent, block.has_words())) return true;
    if (block.has_words()) interpreter.execute(block);
  }
  if (interpreter.ended()) warn_of_blocks_behind(block.line, reader, builder);
  return interpreter.ended();
}

int last_line(std::string_view text) {
  const auto ends = std::count(text.begin(), text.end(), '\n');
  return static_cast<int>(ends) + (text.empty() || text.back() == '\n' ? 0 : 1);
}

/// Where the cutter stays at the end of the program.
void note_low_end(read::gcode::ToolpathBuilder& builder, int line) {
  const auto& z = builder.position()[2];
  if (!z || *z >= builder.safe_z()) return;
  builder.condition("ends-low", line,
                    "the program ends with the cutter at Z " + trimmed(*z, 3) +
                        " mm, below the top of the work; it is taken out before anything else moves");
}

struct Reading {
  Program program;
  bool depends_on_dialect = false;
};

/// How a program of words is read: as plain blocks, or with all that a control's macros can do.
enum class Depth : unsigned char { kPlain, kMacros };

/// Returns whether an end was seen.
bool run_words(std::string_view text, const std::string& file_name, Depth depth, Interpreter& interpreter,
               ToolpathBuilder& builder, const DialectRules& rules, const ReadControllerOptions& options) {
  if (depth == Depth::kPlain) return read_words(text, file_name, interpreter, builder);
  if (rules.macros == MacroLanguage::kLinuxCnc)
    return run_linuxcnc(text, file_name, interpreter, builder, rules, options);
  return run_fanuc(text, file_name, interpreter, builder, rules, options);
}

Reading read_to_depth(Dialect dialect, std::string_view text, const std::string& file_name,
                      const ReadControllerOptions& options, Depth depth) {
  Reading reading;
  Program& program = reading.program;
  program.dialect = dialect;
  program.dialect_stated = options.dialect.has_value();
  read::gcode::ToolpathBuilder builder({file_name, options.home_z, options.safe_z}, program.diagnostics,
                                       program.conditions);
  const DialectRules& rules = rules_of(dialect);
  switch (rules.language) {
    case Language::kKlartext:
      program.ended = read::gcode::read_klartext(text, options.compensation, builder);
      break;
    case Language::kSinumerik:
      program.ended = read_sinumerik(
          text, file_name, depth == Depth::kPlain ? SinumerikDepth::kPlain : SinumerikDepth::kLanguage, rules,
          options, builder);
      break;
    case Language::kWordAddress: {
      read::gcode::Interpreter interpreter(builder, rules, options);
      program.ended = run_words(text, file_name, depth, interpreter, builder, rules, options);
      reading.depends_on_dialect = interpreter.depends_on_dialect();
    }
  }
  builder.require_nothing_open(last_line(text));
  program.ended = program.ended || rules.end == ProgramEnd::kText;
  if (!program.ended) {
    program.diagnostics.warn(file_name, "the program has no end word (M2, M30, END PGM)");
    if (rules.end == ProgramEnd::kWord)
      program.conditions.push_back({"program-end",
                                    "the program has no end word and is whole; it may have been cut short",
                                    last_line(text)});
  }
  note_low_end(builder, last_line(text));
  program.toolpath = builder.take();
  program.compensated_tools.assign(builder.compensated_tools().begin(), builder.compensated_tools().end());
  program.control = builder.take_control();
  program.control.planner = rules.planner;
  return reading;
}

/// Plain programs are read as they stand; at the first word of a macro the program is executed from its start.
Reading read_as(Dialect dialect, std::string_view text, const std::string& file_name,
                const ReadControllerOptions& options) {
  try {
    return read_to_depth(dialect, text, file_name, options, Depth::kPlain);
  } catch (const MacroError&) {
    if (rules_of(dialect).macros == MacroLanguage::kNone) throw;
  }
  return read_to_depth(dialect, text, file_name, options, Depth::kMacros);
}

bool same(const Move& a, const Move& b) {
  const auto near = [](Vec2 p, Vec2 q) { return distance(p, q) <= kSamePlaceMm; };
  return is_rapid(a.kind) == is_rapid(b.kind) && a.path.turn == b.path.turn &&
         near(a.path.from, b.path.from) && near(a.path.to, b.path.to) &&
         (!a.path.is_arc() || near(a.path.center, b.path.center)) &&
         std::abs(a.z_from - b.z_from) <= kSamePlaceMm && std::abs(a.z_to - b.z_to) <= kSamePlaceMm;
}

std::vector<const Move*> moves_of(const Toolpath& toolpath) {
  std::vector<const Move*> moves;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) moves.push_back(&move);
  }
  return moves;
}

/// Line of the first move that differs; nothing where all are alike.
std::optional<int> first_difference(const Toolpath& a, const Toolpath& b) {
  const auto first = moves_of(a), second = moves_of(b);
  for (std::size_t k = 0; k < std::max(first.size(), second.size()); ++k) {
    if (k >= first.size()) return second[k]->line;
    if (k >= second.size() || !same(*first[k], *second[k])) return first[k]->line;
  }
  return std::nullopt;
}

/// Other controls whose words these could be, too: where one of them moves otherwise, somebody has to say which it is.
void compare_dialects(Program& program, std::string_view text, const std::string& file_name,
                      const ReadControllerOptions& options) {
  for (const Dialect other : read::gcode::word_address_dialects()) {
    if (other == program.dialect) continue;
    try {
      const Program read = read_as(other, text, file_name, options).program;
      const auto line = first_difference(program.toolpath, read.toolpath);
      if (!line) continue;
      const std::string mine(name_of(program.dialect)), others(name_of(other));
      program.conditions.push_back(
          {"dialect", "the control is a " + mine + "; as a " + others + " it would move otherwise from here",
           *line});
      return;
    } catch (const InputError&) {
      continue;  // that control would not take it
    }
  }
}

std::vector<const ControlEvent*> waits_of(const ControlTable& control) {
  std::vector<const ControlEvent*> waits;
  for (const ControlEvent& event : control.events)
    if (event.kind == ControlEventKind::kDwell) waits.push_back(&event);
  return waits;
}

/// Says which other control's words these are as well, where that one would move or wait otherwise.
void compare_rival(Program& program, Dialect rival, std::string_view text, const std::string& file_name,
                   const ReadControllerOptions& options) {
  Program other;
  try {
    other = read_as(rival, text, file_name, options).program;
  } catch (const InputError&) {
    return;  // that control would not take it
  }
  const std::string mine(name_of(program.dialect)), others(name_of(rival));
  const std::string is_mine = "the control is a " + mine + ", as all of its words could be of a " + others;
  if (const auto line = first_difference(program.toolpath, other.toolpath)) {
    program.conditions.push_back({"dialect", is_mine + ", which would move otherwise from here", *line});
    return;
  }
  const auto own_waits = waits_of(program.control), other_waits = waits_of(other.control);
  for (std::size_t k = 0; k < std::min(own_waits.size(), other_waits.size()); ++k) {
    if (std::abs(own_waits[k]->seconds - other_waits[k]->seconds) < kSameWait) continue;
    program.conditions.push_back({"dialect",
                                  is_mine + ", which would wait " + trimmed(other_waits[k]->seconds, 3) +
                                      " s here and not " + trimmed(own_waits[k]->seconds, 3) + " s",
                                  own_waits[k]->line});
    return;
  }
}

Program read_unnamed(std::string_view text, const std::string& file_name,
                     const ReadControllerOptions& options) {
  const Recognised likely = read::gcode::recognised(text, file_name);
  Reading reading = read_as(likely.dialect, text, file_name, options);
  if (likely.rival)
    compare_rival(reading.program, *likely.rival, text, file_name, options);
  else if (reading.depends_on_dialect && !likely.is_certain)
    compare_dialects(reading.program, text, file_name, options);
  return std::move(reading.program);
}

}  // namespace

Program read_gcode(std::string_view text, const std::string& file_name,
                   const ReadControllerOptions& options) {
  refuse_what_is_no_program(text, file_name);
  const bool klartext = read::gcode::is_klartext(text);
  if (options.dialect && klartext != (rules_of(*options.dialect).language == Language::kKlartext)) {
    throw InputError(file_name,
                     klartext ? "the program is Klartext; name the dialect " +
                                    std::string(name_of(dialect_of(Language::kKlartext)))
                              : "the program is no Klartext (BEGIN PGM is missing); name another dialect");
  }
  if (options.dialect || klartext) {
    return read_as(options.dialect.value_or(dialect_of(Language::kKlartext)), text, file_name, options)
        .program;
  }
  if (is_sinumerik(text)) return read_as(dialect_of(Language::kSinumerik), text, file_name, options).program;
  return read_unnamed(text, file_name, options);
}

Program read_gcode(std::string_view text, const std::string& file_name, double home_z) {
  ReadControllerOptions options;
  options.home_z = home_z;
  return read_gcode(text, file_name, options);
}

}  // namespace clearcut::read::gcode
