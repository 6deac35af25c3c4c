#include "pipeline/resume/resume.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/text.h"
#include "model/section_names.h"
#include "pipeline/program_feeds.h"
#include "pipeline/resume/begin_again.h"
#include "pipeline/steps/certify.h"
#include "read/gcode/control/held_state.h"
#include "read/gcode/klartext/klartext.h"
#include "read/gcode/klartext/words.h"
#include "read/gcode/sinumerik/sinumerik.h"
#include "read/gcode/words/lines.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

using read::gcode::BlockReader;
using read::gcode::Hindrance;
using read::gcode::StopBlock;
using read::gcode::StopScan;

/// mm. A place read off the machine's display lies within this of the path.
constexpr double kBesidePath = 1;
/// mm. Moves that pass a place within this of the nearest pass it, too.
constexpr double kSamePass = 0.01;
/// mm. Two readings of one place agree to this, whatever digits were written.
constexpr double kSamePlaceAgain = 1e-4;
/// Share by which two readings of one feed may differ.
constexpr double kSameFeedAgain = 1e-6;
/// mm above the material, down to which the cutter comes by a rapid, and above which it crosses where the program never does.
constexpr double kEntryHeight = 2, kCrossingHeight = 5;
/// Places on an arc that are compared with the one where the machine stopped.
constexpr int kPlacesOnArc = 256;

CheckResult checked_for_stop(const ProgramQuestion& question, const std::string& program,
                             const std::string& name, const PlanOptions& options) {
  return question.part
             ? check_program(*question.part, program, name, options, question.dialect)
             : check_program_alone(question.stock, program, name, options, question.dialect, question.top);
}

/// How check_program() reads the program.
read::gcode::ReadControllerOptions reading_again(const CheckResult& result, const std::string& program,
                                                 const std::string& name, const PlanOptions& options) {
  read::gcode::ReadControllerOptions reading = reading_of(options, result.part.tools, name);
  reading.dialect = result.dialect;
  reading.safe_z = result.part.top_z();
  HandTools by_hand;
  if (read::gcode::rules_of(result.dialect).names_no_tools)
    for (const Section& section : result.toolpath.sections) by_hand.numbers.push_back(section.tool_number);
  reading.hand_tools = hand_tools_of(program, by_hand).numbers;
  return reading;
}

/// mm, in space.
double distance_to(const Move& move, const std::array<double, 3>& place) {
  const auto at = [&](double t) {
    const Vec2 p = move.is_vertical() ? move.path.from : move.path.at(t);
    const double dx = p.x - place[0], dy = p.y - place[1];
    const double dz = std::lerp(move.z_from, move.z_to, t) - place[2];
    return std::sqrt(dx * dx + dy * dy + dz * dz);
  };
  if (move.path.is_arc()) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kPlacesOnArc; ++i)
      least = std::min(least, at(static_cast<double>(i) / kPlacesOnArc));
    return least;
  }
  const Vec2 along = move.path.to - move.path.from;
  const double dz = move.z_to - move.z_from, square = dot(along, along) + dz * dz;
  const double t =
      square > 0
          ? (dot(Vec2{place[0], place[1]} - move.path.from, along) + (place[2] - move.z_from) * dz) / square
          : 0;
  return at(std::clamp(t, 0.0, 1.0));
}

/// The line of the first feed move that passes the place.
void find_line_at(const std::array<double, 3>& place, const Toolpath& toolpath, const std::string& name,
                  ResumedProgram& resumed) {
  double least = std::numeric_limits<double>::infinity();
  int nearest = 0;
  const auto for_feeds = [&](auto visit) {
    for (const Section& section : toolpath.sections)
      for (const Move& move : section.moves)
        if (!is_rapid(move.kind)) visit(move, distance_to(move, place));
  };
  for_feeds([&](const Move& move, double beside) {
    if (beside < least) nearest = move.line;
    least = std::min(least, beside);
  });
  if (!(least <= kBesidePath))
    throw InputError("--place", fmt::format("no feed move of {} passes within {} mm of there{}; read the "
                                            "place off the display in the work's own coordinates, or name "
                                            "the --line",
                                            name, trimmed(kBesidePath, 3),
                                            nearest > 0 ? fmt::format(": line {} comes nearest, {} mm beside",
                                                                      nearest, trimmed(least, 3))
                                                        : ""));
  resumed.passes = 0;
  int last = 0;
  for_feeds([&](const Move& move, double beside) {
    if (beside > least + kSamePass || move.line == last) return;
    last = move.line;
    if (resumed.passes++ == 0) resumed.line = move.line;
  });
  resumed.beside_mm = least;
}

/// Whether the tool, standing at a place that it has cut, comes there straight from above.
bool comes_straight_down(const Tool& tool) {
  return tool.kind != ToolKind::kThreadMill && tool.kind != ToolKind::kTSlot && tool.kind != ToolKind::kTap;
}

/// Why the program cannot be begun anew at one of its blocks.
class Refusals {
 public:
  /// `wears`: the control compensates for wear, and how much that was in passes that it has run is not known.
  Refusals(const StopScan& scan, const Part& part, bool wears) : scan_(scan), part_(part) {
    const auto first = std::find_if(scan.blocks.begin(), scan.blocks.end(), [](const StopBlock& block) {
      return block.hindrance == Hindrance::kCompensation;
    });
    if (wears && first != scan.blocks.end()) worn_from_ = first->line;
  }

  /// "" where it can.
  std::string at(const StopBlock& block) const {
    if (scan_.macro_line > 0 && block.line > scan_.macro_line) return text_of(Hindrance::kMacro);
    if (block.hindrance != Hindrance::kNone) return text_of(block.hindrance);
    if (block.line > worn_from_)
      return fmt::format(
          "behind line {}, from which on it compensates for wear: what D held there is not known",
          worn_from_);
    const Tool* const tool = tool_numbered(part_.tools, block.tool);
    if (tool && !comes_straight_down(*tool) && block.is_placed && block.z < part_.top_z())
      return fmt::format(
          "while a {} stands below the top of the work, which it cannot leave or reach straight "
          "up",
          name_of(tool->kind));
    return "";
  }

  /// The last line before `line` at which the program can be begun anew, else the first behind it; 0: there is none.
  int nearest(int line) const {
    int found = 0;
    for (const StopBlock& block : scan_.blocks) {
      if (block.line >= line && found > 0) break;
      if (at(block).empty()) found = block.line;
      if (block.line >= line && found > 0) break;
    }
    return found;
  }

 private:
  const StopScan& scan_;
  const Part& part_;
  int worn_from_ = std::numeric_limits<int>::max();
};

void refuse_stop(const StopScan& scan, const Part& part, bool wears, int line, const std::string& name) {
  const Refusals refusals(scan, part, wears);
  const auto block = std::find_if(scan.blocks.begin(), scan.blocks.end(),
                                  [&](const StopBlock& one) { return one.line >= line; });
  const bool is_behind_macros = block == scan.blocks.end() && scan.macro_line > 0;
  if (block == scan.blocks.end() && !is_behind_macros)
    throw InputError(fmt::format("{}:{}", name, line), "nothing is run from here on; name an earlier --line");
  const std::string why = is_behind_macros ? text_of(Hindrance::kMacro) : refusals.at(*block);
  if (why.empty()) return;
  const int nearest = refusals.nearest(line);
  throw InputError(fmt::format("{}:{}", name, line),
                   fmt::format("the program cannot be begun anew {}; {}", why,
                               nearest > 0 ? fmt::format("the nearest line that serves is --line {}", nearest)
                                           : "no line of it serves"));
}

/// The moves of the lines before `line`, and what the control held at them.
FirstPart first_part(const CheckResult& whole, int line) {
  FirstPart cut;
  ControlTable& control = cut.state.control;
  std::size_t count = 0;
  for (const Section& section : whole.toolpath.sections) {
    const auto end = std::find_if(section.moves.begin(), section.moves.end(),
                                  [&](const Move& move) { return move.line >= line; });
    if (end == section.moves.begin()) continue;
    Section kept = section;
    kept.moves.assign(section.moves.begin(), end);
    std::erase_if(kept.dwells, [&](const Dwell& dwell) { return dwell.after >= kept.moves.size(); });
    count += kept.moves.size();
    cut.toolpath.sections.push_back(std::move(kept));
  }
  control = whole.control;
  std::erase_if(control.spans, [&](const ControlSpan& span) { return span.first_move >= count; });
  std::erase_if(control.events, [&](const ControlEvent& event) { return event.line >= line; });
  std::erase_if(control.arcs, [&](const ArcDoubt& arc) { return arc.move >= count; });
  return cut;
}

/// The greatest height that the program itself goes to below the machine's own zero, mm.
double crossing_height(const Toolpath& toolpath, double home, double top) {
  double height = top + kCrossingHeight;
  for (const Section& section : toolpath.sections)
    for (const Move& move : section.moves)
      for (const double z : {move.z_from, move.z_to})
        if (is_rapid(move.kind) && z < home) height = std::max(height, z);
  return height;
}

/// The slowest feed at which the program goes down with the tool; else its first feed with it. mm/min.
double plunge_feed_of(const Toolpath& toolpath, int tool) {
  double slowest = 0, first = 0;
  for (const Section& section : toolpath.sections) {
    if (section.tool_number != tool) continue;
    for (const Move& move : section.moves) {
      const double feed = move.feed.mm_per_min();
      if (is_rapid(move.kind) || feed <= 0) continue;
      if (first <= 0) first = feed;
      if (move.z_to < move.z_from && (slowest <= 0 || feed < slowest)) slowest = feed;
    }
  }
  return slowest > 0 ? slowest : first;
}

/// Whether the tool is changed before anything moves.
bool changes_tool_first(const StopScan& scan, int line) {
  for (const StopBlock& block : scan.blocks) {
    if (block.line < line) continue;
    if (block.changes_tool) return true;
    if (block.moves) return false;
  }
  return false;
}

/// The tape's mark and the number of the program, as they stand at its beginning.
std::string head_of(std::string_view program, const std::string& name) {
  BlockReader blocks(program, name);
  read::gcode::Lines lines(program);
  read::gcode::Block block;
  std::string_view line;
  std::string head;
  while (lines.next(line) && blocks.next(block)) {
    const bool is_number =
        (block.has('O') || block.names_program) && block.g.empty() && block.m.empty() && !block.has_axis();
    if (block.percent || block.names_file || is_number) head += std::string(line) + "\n";
    if (block.has_words() && !is_number) break;
  }
  return head;
}

std::string_view rest_from(std::string_view program, int number) {
  read::gcode::Lines lines(program);
  std::string_view line;
  while (lines.next(line))
    if (lines.number() == number)
      return {line.data(), static_cast<std::size_t>(program.data() + program.size() - line.data())};
  return {};
}

/// Whether comments of the program begin with ';' and none with '('.
bool uses_semicolons(std::string_view program) {
  return program.find('(') == std::string_view::npos && program.find(';') != std::string_view::npos;
}

/// One move with the tool that makes it.
struct ToolMove {
  const Move* move = nullptr;
  int tool = 0;
};

std::vector<ToolMove> moves_from(const Toolpath& toolpath, int line) {
  std::vector<ToolMove> moves;
  for (const Section& section : toolpath.sections)
    for (const Move& move : section.moves)
      if (move.line >= line) moves.push_back({&move, section.tool_number});
  return moves;
}

bool is_near(Vec2 a, Vec2 b) {
  return distance(a, b) <= kSamePlaceAgain;
}

/// Whether a move of the old text is the same in the new program. `first`: it begins where the lines in front ended.
bool is_same_move(const ToolMove& was, const ToolMove& is, int lines_more, bool first) {
  const Move &a = *was.move, &b = *is.move;
  const bool same_begin =
      first || (is_near(a.path.from, b.path.from) && std::abs(a.z_from - b.z_from) <= kSamePlaceAgain);
  const double feed = a.feed.mm_per_min();
  return same_begin && was.tool == is.tool && is_rapid(a.kind) == is_rapid(b.kind) &&
         is_near(a.path.to, b.path.to) && a.path.turn == b.path.turn &&
         (!a.path.is_arc() || is_near(a.path.center, b.path.center)) &&
         std::abs(a.z_to - b.z_to) <= kSamePlaceAgain &&
         std::abs(feed - b.feed.mm_per_min()) <= kSameFeedAgain * feed && a.line + lines_more == b.line;
}

/// A rapid to where the cutter stands already is none.
void require_same_moves(const ResumedProgram& resumed, const std::string& name) {
  auto was = moves_from(resumed.before.toolpath, resumed.line);
  const auto is = moves_from(resumed.after.toolpath, resumed.line + resumed.new_lines);
  // The first may begin elsewhere, and then may also be no move at all: at most that one differs.
  if (was.size() == is.size() + 1 && is_rapid(was.front().move->kind)) was.erase(was.begin());
  for (std::size_t i = 0; i < std::max(was.size(), is.size()); ++i) {
    const bool both = i < was.size() && i < is.size();
    if (both && is_same_move(was[i], is[i], resumed.new_lines, i == 0)) continue;
    const int line = i < was.size() ? was[i].move->line : is[i].move->line - resumed.new_lines;
    throw InputError(
        fmt::format("{}:{}", name, line),
        fmt::format("does not move as before after a start at line {}; name another --line, such "
                    "as that of a tool change",
                    resumed.line));
  }
}

/// What has to hold for what was cut before, unless the rest says so, too. Lines of the old text become those of the new one.
void add_conditions_of_cut(ResumedProgram& resumed) {
  std::vector<Condition>& now = resumed.after.findings.conditions;
  for (Condition one : resumed.before.findings.conditions) {
    const bool is_known =
        std::any_of(now.begin(), now.end(), [&](const Condition& other) { return other.name == one.name; });
    const bool is_of_rest = one.line >= resumed.line && one.name != "dialect";
    if (is_known || is_of_rest) continue;
    if (one.line > 0 && one.line < resumed.line) {
      one.text += fmt::format(" (line {} of the program that was stopped)", one.line);
      one.line = 0;
    } else if (one.line > 0) {
      one.line += resumed.new_lines;
    }
    now.push_back(std::move(one));
  }
}

int count_lines(std::string_view text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

StopScan stops_of(std::string_view program, const std::string& name,
                  const read::gcode::ReadControllerOptions& reading, int line) {
  switch (read::gcode::rules_of(*reading.dialect).language) {
    case read::gcode::Language::kKlartext:
      return read::gcode::scan_klartext_stops(program, name, reading, line);
    case read::gcode::Language::kSinumerik:
      return read::gcode::scan_sinumerik_stops(program, name, reading, line);
    default:
      return read::gcode::scan_stops(program, name, reading, line);
  }
}

/// The name and the block of a Klartext program, as they stand at its beginning, and `begin` behind them, numbered as they are.
std::string klartext_head(std::string_view program, const std::string& begin) {
  read::gcode::Lines lines(program);
  std::string head;
  bool is_numbered = false;
  for (std::string_view line; lines.next(line);) {
    const std::vector<std::string> words = read::gcode::words_of(line).words;
    if (words.empty()) continue;
    if (words[0] != "BEGIN" && words[0] != "BLK") break;
    head += std::string(line) + "\n";
    is_numbered = is_numbered || read::gcode::is_digit(line[line.find_first_not_of(" \t")]);
  }
  int number = count_lines(head);
  read::gcode::Lines new_lines(begin);
  for (std::string_view line; new_lines.next(line);) {
    const bool is_block = line.front() != ' ' && line.front() != 'Q';
    head += (is_numbered && is_block ? fmt::format("{} {}", number++, line) : std::string(line)) + "\n";
  }
  return head;
}

/// The lines in front of which a Sinumerik takes no block: "%_N_PART_MPF" and ";$PATH=".
std::string sinumerik_head(std::string_view program) {
  read::gcode::Lines lines(program);
  std::string head;
  for (std::string_view line; lines.next(line) && (line.starts_with('%') || line.starts_with(";$"));)
    head += std::string(line) + "\n";
  return head;
}

/// `begin` behind what has to stand at the beginning of the program.
std::string head_before(std::string_view program, const std::string& name, read::gcode::Language language,
                        const std::string& begin) {
  switch (language) {
    case read::gcode::Language::kKlartext:
      return klartext_head(program, begin);
    case read::gcode::Language::kSinumerik:
      return sinumerik_head(program) + begin;
    default:
      return head_of(program, name) + begin;
  }
}

/// The first line behind the block in front of `line`: comments between both belong to what follows.
int first_comment_before(const StopScan& scan, int line) {
  int first = line;
  for (const StopBlock& block : scan.blocks)
    if (block.line < line) first = block.line + 1;
  return first;
}

void require_same_state(const StopScan& was, const std::string& name,
                        const read::gcode::ReadControllerOptions& reading, const ResumedProgram& resumed) {
  const StopScan is = stops_of(resumed.program, name, reading, was.moving_line + resumed.new_lines);
  std::string differs = "end of the program";
  if (is.moving && is.moving_line == was.moving_line + resumed.new_lines) {
    read::gcode::HeldState then = *was.moving, now = *is.moving;
    if (then.at_home) then.position[2].reset();
    differs = difference(then, now);
  }
  if (differs.empty()) return;
  throw InputError(fmt::format("{}:{}", name, resumed.line),
                   fmt::format("the control cannot be brought into the state that it has there ({}); name "
                               "another --line, such as that of a tool change",
                               differs));
}

/// Whether the cutter has to come down by a feed.
bool is_below(const read::gcode::HeldState& held, double height) {
  return held.position[0] && held.position[1] && held.position[2] && *held.position[2] < height;
}

}  // namespace

ResumedProgram resume_program(const ProgramQuestion& question, const Stop& stop, const std::string& program,
                              const std::string& program_name, const PlanOptions& options) {
  if (options.earlier)
    throw InputError("--after", "what ran before a program that is resumed is not read; leave it out");
  return resume_checked(checked_for_stop(question, program, program_name, options), question, stop, program,
                        program_name, options);
}

ResumedProgram resume_checked(CheckResult checked, const ProgramQuestion& question, const Stop& stop,
                              const std::string& program, const std::string& program_name,
                              const PlanOptions& options) {
  ResumedProgram resumed;
  resumed.before = std::move(checked);
  const CheckResult& before = resumed.before;
  const read::gcode::DialectRules& rules = read::gcode::rules_of(before.dialect);
  if (stop.place) find_line_at(*stop.place, before.toolpath, program_name, resumed);
  const auto reading = reading_again(before, program, program_name, options);
  const int asked = stop.line.value_or(resumed.line);
  const StopScan scan = stops_of(program, program_name, reading, asked);
  refuse_stop(scan, before.part, resolve::writes_wear(options.shop), asked, program_name);
  if (!scan.moving)
    throw InputError(fmt::format("{}:{}", program_name, asked),
                     "nothing moves from here on; name an earlier --line");
  resumed.line = scan.held_line;
  const read::gcode::HeldState& held = *scan.held;
  resumed.tool = held.tool;
  resumed.begin = {{held.position[0].value_or(0), held.position[1].value_or(0)},
                   held.position[2].value_or(0),
                   resumed.line};

  WayIn way;
  const double top = before.part.top_z() + options.shop.stock_oversize.value_or(0);
  way.safe_z = crossing_height(before.toolpath, reading.home_z, top);
  way.entry_z = std::min(way.safe_z, top + kEntryHeight);
  way.plunge = plunge_feed_of(before.toolpath, held.tool);
  const FirstPart first = first_part(before, resumed.line);
  const Tool* const tool = tool_numbered(before.part.tools, held.tool);
  if (tool && is_below(held, way.entry_z))
    way.beside = lead_place(before.part, first, *tool, resumed.begin.point, resumed.begin.z);
  way.is_needed = !changes_tool_first(scan, resumed.line);
  way.semicolons = uses_semicolons(program);
  way.tools_by_comments = rules.names_no_tools;
  const std::string begin = lines_that_begin_again(held, rules, way, resumed.line);
  const std::string head = head_before(program, program_name, rules.language, begin);
  // Where comments name the tools, the one in front of a pause names the tool that is put in at it.
  const int rest_line = rules.names_no_tools ? first_comment_before(scan, resumed.line) : resumed.line;
  resumed.new_lines = count_lines(head) + 1 - rest_line;
  resumed.program = head + std::string(rest_from(program, rest_line));
  require_same_state(scan, program_name, reading_again(before, resumed.program, program_name, options),
                     resumed);

  resumed.after = question.part ? check_rest(*question.part, first, resumed.program, program_name, options,
                                             before.dialect)
                                : check_rest_alone(*before.part.stock, first, resumed.program, program_name,
                                                   options, before.dialect);
  require_same_moves(resumed, program_name);
  add_conditions_of_cut(resumed);
  return resumed;
}

}  // namespace clearcut::pipeline
