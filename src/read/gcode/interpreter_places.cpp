// Words about places: work offsets, shifts, tool lengths, and the machine's own frame.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text/format.h"
#include "read/gcode/interpreter.h"
#include "read/gcode/words/g_words.h"

namespace clearcut::read::gcode {

namespace {

constexpr int kSystemWords[] = {540, 550, 560, 570, 580, 590, 591, 592, 593};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

/// Words that use X, Y, Z for something else than motion in the work's frame.
bool Interpreter::move_specially(const Block& block) {
  if (has_g(block, 280) || has_g(block, 300)) {
    go_home(block, has_g(block, 280));
    return true;
  }
  if (has_g(block, 281) || has_g(block, 301)) {
    store_reference(has_g(block, 281));
    return true;
  }
  if (has_g(block, 530)) {
    machine_frame(block);
    return true;
  }
  if (has_g(block, 100)) {
    set_offset_table(block);
    return true;
  }
  if (has_g(block, 920) || has_g(block, 520)) {
    shift(block);
    return true;
  }
  for (const int code : {921, 922, 923}) {
    if (has_g(block, code)) clear_shift(code);
  }
  if (has_g(block, 431)) return true;
  return has_g(block, 40) && rules_.dwell_by_x;
}

void Interpreter::go_home(const Block& block, bool first) {
  const std::string name = first ? "g28-home" : "g30-home";
  const bool all = !block.has_axis();
  if (rules_.dialect == Dialect::kMarlin) return go_to_unknown(block, name, all, false);
  // The way goes through the place stated, straight, whatever lies there.
  if (!all) builder_.rapid(stated_way(block), line_);
  const auto& stored = references_[first ? 0 : 1];
  if (options_.places || stored) {
    std::array<double, 3> reference{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      reference[axis] = stored
                            ? (*stored)[axis].value_or(0)
                            : (first ? options_.places->reference : options_.places->second_reference)[axis] -
                                  frame_.machine_zero(axis);
    }
    return go_to_reference(block, reference);
  }
  go_to_unknown(block, name, all, first && rules_.home_is_top);
}

/// The place that a block with G28 goes through first; G91 with zeros goes through none.
Target Interpreter::stated_way(const Block& block) {
  Target way;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = "XYZ"[axis];
    const bool stays = !modes_.absolute && block.value(letter) == 0;
    if (block.has(letter) && !stays) way[axis] = target_of(axis, block);
  }
  return way;
}

void Interpreter::go_to_reference(const Block& block, const std::array<double, 3>& reference) {
  Target to;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!block.has_axis() || block.has("XYZ"[axis])) to[axis] = reference[axis];
  }
  builder_.rapid(to, line_);
}

/// Z is lifted, X and Y stay as far as anything is known. Harmless: Z alone on a machine whose zero is at the top.
void Interpreter::go_to_unknown(const Block& block, const std::string& name, bool all, bool harmless) {
  const bool z = all || block.has('Z'), plan = all || block.has('X') || block.has('Y');
  if (plan && !(z && !all && harmless && builder_.at_home_height()) && !builder_.at_home_height()) {
    condition(name,
              "moves X and Y to a place of the machine at once with Z or below home; the way there is free");
  } else if (!harmless) {
    condition(name,
              "moves to a place of the machine that the program does not state; taken as straight up to Z " +
                  trimmed(builder_.home_z(), 3) + " mm");
  }
  if (z) builder_.lift_home(line_);
  if (plan) builder_.leave_plan(name);
}

void Interpreter::store_reference(bool first) {
  const Target& at = builder_.position();
  if (!at[0] || !at[1] || !at[2]) {
    condition(first ? "g28-home" : "g30-home", "stores a place that the program has not stated");
  }
  references_[first ? 0 : 1] = at;
}

/// G53: absolute in the machine's frame, whatever G90 or G91 says.
void Interpreter::machine_frame(const Block& block) {
  if (!block.has_axis()) return;
  moved_ = true;
  if (!options_.places) {
    const bool top =
        rules_.home_is_top && block.has('Z') && block.value('Z') == 0 && !block.has('X') && !block.has('Y');
    return go_to_unknown(block, "g53", false, top);
  }
  Target to;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block.has("XYZ"[axis])) to[axis] = mm(block.value("XYZ"[axis])) - frame_.machine_zero(axis);
  }
  if (motion_ == 10) {
    before_feed();
    builder_.feed(to, MmPerMin::of(modes_.feed), line_);
  } else {
    builder_.rapid(to, line_);
  }
}

/// G10 L2 writes an offset; L20 writes it so that the tool stands at the words.
void Interpreter::set_offset_table(const Block& block) {
  condition("g10", "G10 writes into the control's tables; they are as the program leaves them");
  const int kind = block.has('L') ? static_cast<int>(block.value('L')) : 2;
  if (kind != 2 && kind != 20) return;
  if (block.has('R') && block.value('R') != 0) refuse("G10 with a rotation (R) is not read; post without it");
  const int number = block.has('P') ? static_cast<int>(block.value('P')) : 0;
  const int system = number == 0 ? frame_.system() : number;
  if (system < 1 || system > Frame::kSystems) refuse("G10 with an impossible P word; correct it");
  const bool adds = !modes_.absolute && rules_.dialect == Dialect::kFanuc && kind == 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!block.has("XYZ"[axis])) continue;
    double value = mm(block.value("XYZ"[axis]));
    if (adds) value += frame_.origin(system, axis);
    if (kind == 20) {
      const int before = frame_.system();
      frame_.use_system(system);
      value = frame_.origin(system, axis) + builder_.known(axis, line_) - frame_.shift(axis) - value;
      frame_.use_system(before);
    }
    frame_.set_origin(system, axis, value, moved_);
  }
}

/// G92 renames the place where the tool is; G52 moves the origin. Neither moves the tool.
void Interpreter::shift(const Block& block) {
  const bool local = has_g(block, 520);
  const std::string word = local ? "g52" : "g92";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = "XYZ"[axis];
    if (!block.has(letter)) continue;
    const double value = mm(block.value(letter));
    if (local) {
      frame_.set_local(axis, value);
      if (value == 0) continue;
    } else if (builder_.position()[axis]) {
      frame_.name_place(axis, *builder_.position()[axis], value);
    } else {
      builder_.place_at(axis, value + frame_.shift(axis));
    }
    condition(word, "the origin is shifted by " + std::string(local ? "G52" : "G92") +
                        "; no other shift was in force when the program began");
  }
}

void Interpreter::clear_shift(int code) {
  if (code == 923) {
    if (!frame_.restore_local()) refuse("G92.3 restores an offset from outside the program; post without it");
    return;
  }
  frame_.clear_local(code == 922);
}

void Interpreter::use_system(int code, const Block& block) {
  if (code == 541 || code == 1540) {
    if (!block.has('P')) refuse(g_word(code) + " without its P word; give the number of the work offset");
    const std::string word = lower(g_word(code)) + "-p" + trimmed(block.value('P'), 0);
    condition(word,
              g_word(code) + " P" + trimmed(block.value('P'), 0) + " has its origin where the work's is");
    return;
  }
  const auto* const found = std::find(std::begin(kSystemWords), std::end(kSystemWords), code);
  frame_.use_system(static_cast<int>(found - std::begin(kSystemWords)) + 1);
  if (code == 540 || options_.places) return;
  condition(lower(g_word(code)), g_word(code) + " has its origin where the work's is");
}

void Interpreter::set_length(int code, const Block& block) {
  ToolLength length;
  if (code == 490) {
    length.kind = LengthKind::kOff;
  } else if (code == 431) {
    for (const char letter : {'X', 'Y'}) {
      if (block.has(letter) && block.value(letter) != 0)
        refuse("G43.1 with X or Y is not read; post without it");
    }
    length.kind = LengthKind::kStatedHeight;
    length.stated_mm = block.has('Z') ? mm(block.value('Z')) : 0;
    condition("tool-length-g43.1",
              "the tool stood at its stated height when the work was touched off without G43.1");
  } else if (block.has('H')) {
    length.kind = block.value('H') == 0 && rules_.dialect != Dialect::kLinuxCnc ? LengthKind::kOff
                                                                                : LengthKind::kNumbered;
    length.h = static_cast<int>(block.value('H'));
  } else {
    length.kind = LengthKind::kOfTool;
    length.h = tool_said_ && changer_ ? builder_.drive.tool : next_tool_;
  }
  length_used_ = length_used_ || code == 430;
  frame_.set_stated_length(length.stated_mm);
  modes_.length = builder_.length = length;
}

}  // namespace clearcut::read::gcode
