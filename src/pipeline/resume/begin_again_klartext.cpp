// Order of the lines: datum, tolerance; up; tool; spindle; over the place; coolant; down; cycle, pole and feed. Each block states its motion itself.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "pipeline/resume/begin_again.h"

namespace clearcut::pipeline {
namespace {

using read::gcode::HeldState;

/// "X+10", as the control's own editor writes it.
std::string signed_word(char axis, double value, int digits = 6) {
  const std::string text = trimmed(value, digits);
  return axis + (text[0] == '-' ? text : "+" + text);
}

class KlartextBegin {
 public:
  KlartextBegin(const HeldState& held, const WayIn& way) : held_(held), way_(way) {}

  std::string text(int line) {
    add(fmt::format("; RESUMED BEFORE LINE {}", line));
    out_ += held_.words.offset + held_.words.path + held_.words.tool_definitions;
    if (!way_.is_needed) return out_ + coolant() + what_holds() + feed_alone();
    out_ += held_.words.home + held_.words.tool_calls;
    if (held_.modes.spindle != 5) add(fmt::format("M{}", held_.modes.spindle));
    if (held_.modes.spindle != 5 && held_.spindle_wait > 0)
      add("CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL " + trimmed(held_.spindle_wait, 3));
    if (!is_placed()) return out_ + coolant() + what_holds() + feed_alone();
    write_way();
    out_ += what_holds();
    if (held_.modes.feed > 0) add("L " + height(*held_.position[2]) + feed_word(held_.modes.feed));
    return out_;
  }

 private:
  void add(const std::string& line) { out_ += line + "\n"; }
  bool is_placed() const { return held_.position[0] && held_.position[1] && held_.position[2]; }
  std::string coolant() const {
    std::string lines;
    for (const std::string& word : held_.words.coolant) lines += word + "\n";
    return lines;
  }
  /// The definition of the cycle for holes, and the pole.
  std::string what_holds() const {
    return held_.words.cycle + (held_.pole ? "CC " + plan(*held_.pole, 6) + "\n" : "");
  }
  std::string feed_alone() const {
    return held_.modes.feed > 0 ? "L" + feed_word(held_.modes.feed) + "\n" : "";
  }
  std::string plan(Vec2 place, int digits) const {
    return signed_word('X', place.x / held_.modes.unit, digits) + " " +
           signed_word('Y', place.y / held_.modes.unit, digits);
  }
  /// Heights of the tip, which DL lifts.
  std::string height(double z) const { return signed_word('Z', (z - held_.shift[2]) / held_.modes.unit); }
  /// In inch programs tenths of an inch.
  std::string feed_word(double feed) const {
    return " F" + trimmed(held_.modes.unit == 1 ? feed : feed * 10 / held_.modes.unit, 6);
  }

  /// Up, across, down, as in programs of words.
  void write_way() {
    const double z = *held_.position[2];
    const bool crosses_first = !held_.words.home.empty(), stays_up = held_.at_home && crosses_first;
    const int digits = held_.modes.unit == 1 ? 3 : 4;
    const std::string over =
        "L " +
        (way_.beside ? plan(*way_.beside, digits) : plan({*held_.position[0], *held_.position[1]}, 6)) +
        " R0 FMAX";
    if (crosses_first) add(over);
    if (!stays_up) add("L " + height(std::max(way_.safe_z, z)) + " R0 FMAX");
    if (!crosses_first) add(over);
    out_ += coolant();
    if (stays_up) return;
    const WayDown down = way_down(held_, way_);
    if (down.rapid_to) add("L " + height(*down.rapid_to) + " R0 FMAX");
    if (!down.feed_to) return;
    add("L " + height(*down.feed_to) + " R0" + feed_word(way_.plunge));
    if (!way_.beside) return;
    add("L " + plan({*held_.position[0], *held_.position[1]}, 6) + " R0" +
        feed_word(held_.modes.feed > 0 ? held_.modes.feed : way_.plunge));
  }

  const HeldState& held_;
  const WayIn& way_;
  std::string out_;
};

}  // namespace

std::string klartext_that_begins_again(const HeldState& held, const WayIn& way, int line) {
  return KlartextBegin(held, way).text(line);
}

}  // namespace clearcut::pipeline
