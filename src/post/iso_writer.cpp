#include "post/iso_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>

#include "base/format.h"
#include "post/comment.h"
#include "post/heights.h"
#include "post/steps.h"

namespace clearcut {

namespace {

constexpr double kMmPerInch = 25.4;

class IsoWriter {
 public:
  IsoWriter(const Part& part, const PostOptions& options, const IsoDialect& dialect, double safe_z)
      : part_(part),
        options_(options),
        dialect_(dialect),
        rules_{PrintGrid(options.inch, options.decimals.value_or(options.inch ? dialect.inch_decimals
                                                                              : dialect.mm_decimals)),
               options.arcs, dialect.largest_radius, options.tol.chord},
        feed_grid_(options.inch, options.inch ? 3 : 2),
        safe_z_(rules_.grid.ticks(safe_z)) {}

  std::string program(const Toolpath& toolpath) {
    begin_program();
    for (const Section& section : toolpath.sections) {
      if (!section.moves.empty()) write_section(section);
    }
    end_program();
    return std::move(out_);
  }

 private:
  void begin_program();
  void write_section(const Section& section);
  void end_program();

  void change_tool(int number);
  void set_spindle(const Section& section);
  void set_coolant(bool on);
  void approach(const Move& first);
  void write_move(const Move& move);
  void write_step(const Step& step, bool rapid, MmPerMin feed);
  void retract();

  void rapid_to(std::optional<Ticks> plan, std::optional<long long> z);
  void motion_word(int code);
  void word(char letter, long long ticks, const PrintGrid& grid);
  void feed_word(MmPerMin feed);
  void end_block();
  void line(std::string_view text);
  void comment(std::string_view text);
  std::string tool_comment(int number) const;

  const Part& part_;
  const PostOptions& options_;
  const IsoDialect& dialect_;
  StepRules rules_;
  PrintGrid feed_grid_;
  long long safe_z_;

  std::string out_;
  std::string block_;
  std::vector<Step> steps_;
  // What the control holds; forgotten at a tool change, so that everything is said again.
  Ticks at_;
  bool plan_known_ = false;
  bool height_known_ = false;
  int motion_ = -1;
  long long feed_ = -1;
  int tool_ = 0;
  double spindle_ = 0;  ///< rpm, negative counter-clockwise, 0 stopped
  bool coolant_ = false;
};

void IsoWriter::begin_program() {
  if (!options_.program_name.empty()) comment(options_.program_name);
  for (const std::string& text : options_.header) comment(text);
  comment(options_.inch ? "UNITS: INCH" : "UNITS: MM");
  line(fmt::format("{} {}", options_.inch ? "G20" : "G21", dialect_.safe_start));
  if (dialect_.path_tolerance) {
    // Blending may use half of the gouge tolerance; rounding the words needs less than the rest. Q0: no
    // merging.
    const double blend = options_.tol.gouge / 2;
    line(fmt::format("G64 P{} Q0", trimmed(options_.inch ? blend / kMmPerInch : blend, 6)));
  }
}

void IsoWriter::write_section(const Section& section) {
  const bool new_tool = section.tool_number > 0 && section.tool_number != tool_;
  // Without a tool length in force a height means nothing: the first tool change comes before any motion.
  if (new_tool && height_known_) retract();
  comment(operation_comment(section.workingstep, section.label));
  if (new_tool) change_tool(section.tool_number);
  set_spindle(section);
  set_coolant(section.coolant);
  approach(section.moves.front());
  for (const Move& move : section.moves) write_move(move);
}

void IsoWriter::end_program() {
  retract();
  set_spindle({});
  set_coolant(false);
  line(dialect_.program_end);
}

void IsoWriter::change_tool(int number) {
  set_spindle({});
  set_coolant(false);
  comment(tool_comment(number));
  line(fmt::format("T{} M6", number));
  line("G43");
  tool_ = number;
  plan_known_ = height_known_ = false;
  motion_ = -1;
  feed_ = -1;
}

void IsoWriter::set_spindle(const Section& section) {
  const double rpm = section.spindle_clockwise ? section.spindle_rpm : -section.spindle_rpm;
  if (rpm == spindle_) return;
  spindle_ = rpm;
  if (rpm == 0) return line("M5");
  line(fmt::format("S{} M{}", std::max(1LL, std::llround(std::abs(rpm))), rpm > 0 ? 3 : 4));
}

void IsoWriter::set_coolant(bool on) {
  if (on == coolant_) return;
  coolant_ = on;
  line(on ? "M8" : "M9");
}

/// Over the first move's start at the safe height, then down to it.
void IsoWriter::approach(const Move& first) {
  const Ticks start = rules_.grid.ticks(first.path.from, first.z_from);
  const bool above = plan_known_ && at_.same_plan(start);
  if (above && height_known_ && at_.z == start.z) return;
  if (!above) {
    retract();
    rapid_to(start, std::nullopt);
  }
  rapid_to(std::nullopt, start.z);
}

void IsoWriter::retract() {
  if (!height_known_ || at_.z < safe_z_) rapid_to(std::nullopt, safe_z_);
}

void IsoWriter::rapid_to(std::optional<Ticks> plan, std::optional<long long> z) {
  if (z && height_known_ && at_.z == *z) return;
  motion_word(0);
  if (plan) {
    word('X', plan->x, rules_.grid);
    word('Y', plan->y, rules_.grid);
    at_.x = plan->x;
    at_.y = plan->y;
    plan_known_ = true;
  }
  if (z) {
    word('Z', *z, rules_.grid);
    at_.z = *z;
    height_known_ = true;
  }
  feed_ = -1;
  end_block();
}

void IsoWriter::write_move(const Move& move) {
  steps_.clear();
  StepRules rules = rules_;
  const bool rapid = is_rapid(move.kind);
  if (rapid) rules.arcs = false;
  append_steps(move, at_, rules, steps_);
  for (const Step& step : steps_) write_step(step, rapid, move.feed);
}

void IsoWriter::write_step(const Step& step, bool rapid, MmPerMin feed) {
  const bool arc = step.turn != Turn::kStraight;
  motion_word(rapid ? 0 : !arc ? 1 : step.turn == Turn::kClockwise ? 2 : 3);
  if (arc || step.to.x != at_.x) word('X', step.to.x, rules_.grid);
  if (arc || step.to.y != at_.y) word('Y', step.to.y, rules_.grid);
  if (step.to.z != at_.z) word('Z', step.to.z, rules_.grid);
  if (arc) {
    word('I', step.i, rules_.grid);
    word('J', step.j, rules_.grid);
  }
  at_ = step.to;
  if (rapid) {
    feed_ = -1;  // the first feed move after a rapid says its feed again
  } else {
    feed_word(feed);
  }
  end_block();
}

void IsoWriter::motion_word(int code) {
  if (code == motion_) return;
  motion_ = code;
  fmt::format_to(std::back_inserter(block_), "G{}", code);
}

void IsoWriter::word(char letter, long long ticks, const PrintGrid& grid) {
  if (!block_.empty()) block_ += ' ';
  block_ += letter;
  append_number(block_, ticks, grid.decimals(), dialect_.always_point);
}

void IsoWriter::feed_word(MmPerMin feed) {
  const long long ticks = std::max(1LL, feed_grid_.ticks(feed.mm_per_min()));
  if (ticks == feed_) return;
  feed_ = ticks;
  word('F', ticks, feed_grid_);
}

void IsoWriter::end_block() {
  if (block_.size() > dialect_.line_length) std::erase(block_, ' ');
  line(block_);
  block_.clear();
}

void IsoWriter::line(std::string_view text) {
  out_ += text;
  out_ += '\n';
}

void IsoWriter::comment(std::string_view text) {
  const std::string plain = plain_comment(text);
  const std::size_t room = dialect_.line_length - 2;
  std::size_t begin = 0;
  do {
    const std::string piece = plain.substr(begin, room);
    line(dialect_.comments == CommentForm::kParentheses ? "(" + piece + ")" : "; " + piece);
    begin += room;
  } while (begin < plain.size());
}

std::string IsoWriter::tool_comment(int number) const {
  for (const Tool& tool : part_.tools) {
    if (tool.number == number) {
      return fmt::format("TOOL T{}: {} D{} MM", number, tool.name, trimmed(tool.diameter, 4));
    }
  }
  return fmt::format("TOOL T{}", number);
}

}  // namespace

std::string write_iso(const Toolpath& toolpath, const Part& part, const PostOptions& options,
                      const IsoDialect& dialect) {
  return IsoWriter(part, options, dialect, safe_height(toolpath, part)).program(toolpath);
}

}  // namespace clearcut
