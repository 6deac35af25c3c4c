#include "read/gcode/control/place_words.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/text.h"
#include "base/units.h"
#include "read/gcode/control/circle_words.h"
#include "read/gcode/control/compensation_words.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kLeastScale = 0.001, kGreatestScale = 1000;
constexpr int kSystemWords[] = {540, 550, 560, 570, 580, 590, 591, 592, 593};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

/// Words that use X, Y, Z for something else than motion in the work's frame.
bool PlaceWords::move_specially(const Block& block) {
  for (const int code : block.g) {
    if (group_of(code) == Group::kOnce || code == 530)
      CompensationWords(control_).refuse_while_on(g_word(code));
  }
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
  if (mill_circle(control_, block)) return true;
  if (has_g(block, 100)) {
    set_offset_table(block);
    return true;
  }
  if (has_g(block, 920) || has_g(block, 520)) {
    shift(block);
    return true;
  }
  if (has_g(block, 680)) {
    rotate(block);
    return true;
  }
  if (has_g(block, 510)) {
    scale(block);
    return true;
  }
  for (const int code : {501, 511}) {
    if (!has_g(block, code)) continue;
    mirror(block, code == 511);
    return true;
  }
  for (const int code : {921, 922, 923}) {
    if (has_g(block, code)) clear_shift(code);
  }
  if (has_g(block, 431) || has_g(block, 432)) return true;
  return has_g(block, 40) && control_.rules.dwell_by_x;
}

void PlaceWords::go_home(const Block& block, bool first) {
  const std::string name = first ? "g28-home" : "g30-home";
  const bool all = !block.has_axis();
  if (control_.rules.no_home_in_cycle && control_.is_cycle(control_.motion))
    control_.refuse(
        "G28 and G30 within a drilling cycle stop the control with an alarm; end it by G80 before");
  if (control_.rules.home_is_switches) return go_to_unknown(block, name, all, false);
  // The way goes through the place stated, straight, whatever lies there.
  if (!all) control_.builder.rapid(stated_way(block), control_.line);
  const auto& stored = control_.references[first ? 0 : 1];
  if (control_.options.places || stored) {
    std::array<double, 3> reference{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      reference[axis] = stored ? (*stored)[axis].value_or(0)
                               : (first ? control_.options.places->reference
                                        : control_.options.places->second_reference)[axis] -
                                     control_.frame.machine_zero(axis);
    }
    return go_to_reference(block, reference);
  }
  go_to_unknown(block, name, all, first && control_.rules.home_is_top);
}

/// The place that a block with G28 goes through first; G91 with zeros goes through none.
Target PlaceWords::stated_way(const Block& block) {
  Target way;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = "XYZ"[axis];
    const bool stays = !control_.modes.absolute && block.value(letter) == 0;
    if (block.has(letter) && !stays) way[axis] = control_.target_of(axis, block);
  }
  return way;
}

void PlaceWords::go_to_reference(const Block& block, const std::array<double, 3>& reference) {
  Target to;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!block.has_axis() || block.has("XYZ"[axis])) to[axis] = reference[axis];
  }
  control_.builder.rapid(to, control_.line);
}

/// Z is lifted, X and Y stay as far as anything is known. Harmless: Z alone on a machine whose zero is at the top.
void PlaceWords::go_to_unknown(const Block& block, const std::string& name, bool all, bool harmless) {
  const bool z = all || block.has('Z'), plan = all || block.has('X') || block.has('Y');
  if (plan && !(z && !all && harmless && control_.builder.at_home_height()) &&
      !control_.builder.at_home_height()) {
    control_.condition(
        name, "moves X and Y to a place of the machine at once with Z or below home; the way there is free");
  } else if (!harmless) {
    control_.condition(
        name, "moves to a place of the machine that the program does not state; taken as straight up to Z " +
                  trimmed(control_.builder.home_z(), 3) + " mm");
  }
  if (z) control_.builder.lift_home(control_.line);
  if (plan) control_.builder.leave_plan(name);
}

void PlaceWords::store_reference(bool first) {
  const Target& at = control_.builder.position();
  if (!at[0] || !at[1] || !at[2]) {
    control_.condition(first ? "g28-home" : "g30-home", "stores a place that the program has not stated");
  }
  control_.references[first ? 0 : 1] = at;
}

/// G53: absolute in the machine's frame, whatever G90 or G91 says.
void PlaceWords::machine_frame(const Block& block) {
  if (!block.has_axis()) return;
  control_.moved = true;
  if (!control_.options.places) {
    const bool top = control_.rules.home_is_top && (!block.has('Z') || block.value('Z') == 0);
    return go_to_unknown(block, control_.rules.osp_words ? "g16" : "g53", false, top);
  }
  Target to;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block.has("XYZ"[axis]))
      to[axis] = control_.mm(block.value("XYZ"[axis])) - control_.frame.machine_zero(axis);
  }
  if (control_.motion == 10) {
    control_.before_feed();
    control_.builder.feed(to, MmPerMin::of(control_.modes.feed), control_.line);
  } else {
    control_.builder.rapid(to, control_.line);
  }
}

/// G10 L2 writes an offset; L20 writes it so that the tool stands at the words.
void PlaceWords::set_offset_table(const Block& block) {
  control_.condition("g10", "G10 writes into the control's tables; they are as the program leaves them");
  const int kind = block.has('L') ? static_cast<int>(block.value('L')) : 2;
  if (kind != 2 && kind != 20) return;
  if (block.has('R') && block.value('R') != 0)
    control_.refuse("G10 with a rotation (R) is not read; post without it");
  const int number = block.has('P') ? static_cast<int>(block.value('P')) : 0;
  const int system = number == 0 ? control_.frame.system() : number;
  if (system < 1 || system > Frame::kSystems) control_.refuse("G10 with an impossible P word; correct it");
  const bool adds = !control_.modes.absolute && control_.rules.adds_to_offsets && kind == 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!block.has("XYZ"[axis])) continue;
    if (kind == 20 && control_.zero_is_measured[axis]) continue;
    if (kind == 2) control_.origins_written[static_cast<std::size_t>(system - 1)][axis] = true;
    double value = control_.mm(block.value("XYZ"[axis]));
    if (adds) value += control_.frame.origin(system, axis);
    if (kind == 20) {
      const int before = control_.frame.system();
      control_.frame.use_system(system);
      value = control_.frame.origin(system, axis) + control_.builder.known(axis, control_.line) -
              control_.frame.shift(axis) - value;
      control_.frame.use_system(before);
    }
    control_.frame.set_origin(system, axis, value, control_.moved);
  }
}

/// G92 renames the place where the tool is; G52 moves the origin. Neither moves the tool.
void PlaceWords::shift(const Block& block) {
  const bool local = has_g(block, 520);
  const std::string word = local ? "g52" : "g92";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = "XYZ"[axis];
    if (!block.has(letter)) continue;
    if (!local && control_.zero_is_measured[axis]) continue;
    const double value = control_.mm(block.value(letter));
    if (local) {
      control_.frame.set_local(axis, value);
      if (value == 0) continue;
    } else if (control_.builder.position()[axis]) {
      control_.frame.name_place(axis, *control_.builder.position()[axis], value);
    } else {
      control_.builder.place_at(axis, value + control_.frame.shift(axis));
    }
    control_.condition(word, "the origin is shifted by " + std::string(local ? "G52" : "G92") +
                                 "; no other shift was in force when the program began");
  }
}

/// G68 turns what follows about a place by R degrees.
void PlaceWords::rotate(const Block& block) {
  refuse_second_map(680);
  if (control_.modes.plane != Plane::kXY) control_.refuse("G68 outside the XY plane is not read; use G17");
  if (!block.has('X') || !block.has('Y') || !block.has('R'))
    control_.refuse("G68 without its X, Y or R word; give the centre and the angle");
  if (!control_.modes.absolute) control_.refuse("G68 in G91 is not read; state its centre and angle in G90");
  if (control_.rules.points_matter && block.is_whole('R') && block.value('R') != 0)
    control_.condition("decimal-point", "R of G68 has no decimal point; the control takes it as degrees");
  const double angle = block.value('R') * kPi / 180;
  PlanMap map;
  map.is_on = true;
  map.made_by = 680;
  map.xx = map.yy = base::cos(angle);
  map.yx = base::sin(angle);
  map.xy = -map.yx;
  map.fixed = {control_.mm(block.value('X')), control_.mm(block.value('Y'))};
  control_.plan_map = map;
}

/// G51.1 mirrors the moves after it about the places of its axis words; G50.1 ends the mirror of the axes it names.
void PlaceWords::mirror(const Block& block, bool on) {
  PlanMap& map = control_.plan_map;
  if (block.has('Z')) control_.refuse("mirrored Z is not read; post the program without it");
  refuse_second_map(511);
  if (!block.has_axis() && on)
    control_.refuse("G51.1 without axis words; give the place about which it mirrors");
  const bool all = !block.has_axis();
  if (all || block.has('X')) map.xx = on ? -1 : 1;
  if (all || block.has('Y')) map.yy = on ? -1 : 1;
  if (on && block.has('X')) map.fixed.x = control_.mm(block.value('X'));
  if (on && block.has('Y')) map.fixed.y = control_.mm(block.value('Y'));
  map.flips = map.xx * map.yy < 0;
  map.is_on = map.xx < 0 || map.yy < 0;
  map.made_by = 511;
}

void PlaceWords::refuse_second_map(int code) const {
  const PlanMap& map = control_.plan_map;
  if (map.is_on && map.made_by != code)
    control_.refuse(g_word(code) + " while " + g_word(map.made_by) +
                    " is in force is not read; end one of them before");
}

void PlaceWords::end_map(int code, int made_by) {
  if (control_.plan_map.made_by != made_by) return;
  if (control_.plan_map.is_on) CompensationWords(control_).refuse_while_on(g_word(code));
  control_.plan_map = {};
}

/// G51 scales the places of the moves after it, arcs with them; feeds, lengths and radii of tools stay.
void PlaceWords::scale(const Block& block) {
  if (control_.rules.scaling == ScalingWords::kNone)
    control_.refuse("G51 is not read; post the program without it");
  refuse_second_map(510);
  if (control_.modes.plane != Plane::kXY) control_.refuse("G51 outside the XY plane is not read; use G17");
  if (!control_.modes.absolute) control_.refuse("G51 in G91 is not read; state its centre in G90");
  if (control_.polar_mode) control_.refuse("G51 while G16 is in force is not read; end one of them before");
  PlanMap map;
  map.made_by = 510;
  set_scales(block, map);
  map.is_on = map.xx != 1 || map.yy != 1 || map.scale_z != 1;
  map.flips = map.xx * map.yy < 0;
  map.scale = std::abs(map.xx) == std::abs(map.yy) ? std::abs(map.xx) : 0;
  control_.plan_map = map;
}

/// An axis without its word is scaled about the place where it is.
void PlaceWords::set_scales(const Block& block, PlanMap& map) {
  double* const scales[] = {&map.xx, &map.yy, &map.scale_z};
  double* const fixed[] = {&map.fixed.x, &map.fixed.y, &map.fixed_z};
  const bool by_axes = control_.rules.scaling == ScalingWords::kAxes;
  const bool has_one = block.has('P');
  const bool one_by_one = control_.rules.scaling == ScalingWords::kThousandths && !has_one;
  if (!by_axes && !has_one && !(one_by_one && (block.has('I') || block.has('J') || block.has('K'))))
    control_.refuse("G51 without its factor P takes it from a setting of the control; add P");
  if (by_axes && !block.has_axis())
    control_.refuse("G51 without X, Y and Z, the factors of the axes; add them");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = "XYZ"[axis];
    if (by_axes) {
      if (block.has(letter)) *scales[axis] = scale_of(letter, block);
      continue;
    }
    *scales[axis] = has_one                  ? scale_of('P', block)
                    : block.has("IJK"[axis]) ? scale_of("IJK"[axis], block)
                                             : 1;
    *fixed[axis] = block.has(letter)
                       ? control_.mm(block.value(letter))
                       : control_.builder.known(axis, control_.line) - control_.frame.shift(axis);
  }
  if (map.scale_z < 0) control_.refuse("mirrored Z is not read; post the program without it");
}

/// The factor that the word states.
double PlaceWords::scale_of(char letter, const Block& block) const {
  double factor = block.value(letter);
  if (control_.rules.scaling == ScalingWords::kThousandths && block.is_whole(letter)) {
    factor /= 1000;
    control_.condition("scaling",
                       "P, I, J and K of G51 without a point count in thousandths (parameter 5400.7), as the "
                       "control is delivered");
  }
  const bool mirrors = letter != 'P' && control_.rules.scaling != ScalingWords::kFactor;
  if (!(std::abs(factor) >= kLeastScale && std::abs(factor) <= kGreatestScale) || (factor < 0 && !mirrors))
    control_.refuse(std::string("G51 with an impossible factor ") + letter + "; correct it");
  return factor;
}

void PlaceWords::clear_shift(int code) {
  if (code == 923) {
    if (!control_.frame.restore_local())
      control_.refuse(
          "G92.3 restores a shift from outside the program, which nothing states; post without it, or shift "
          "by "
          "G92 before");
    return;
  }
  control_.frame.clear_local(code == 922);
}

/// Offsets that are called by a number: G54.1 P or G54 P on Fanuc, Haas's G154 P and its short words G110 to G129, Mach3's
/// G59 P.
bool PlaceWords::uses_numbered_system(int code, const Block& block) const {
  if (code == 541 || code >= 1100) return true;
  const bool takes_number = code == control_.rules.offset_with_number;
  const bool is_of_another = has_g(block, 40) || has_g(block, 100) || has_g(block, 640);
  return takes_number && block.has('P') && !is_of_another;
}

void PlaceWords::use_numbered_system(int code, const Block& block) {
  const bool is_short = code >= 1100 && code <= 1290;
  const std::string word = g_word(is_short ? 1540 : code == 540 ? 541 : code);
  if (!is_short && !block.has('P'))
    control_.refuse(word + " without its P word; give the number of the work offset");
  const int of_word = (code - 1100) / 10 + 1;  // G110 is the first; codes are in tenths
  const double number = is_short ? of_word : block.value('P');
  if (code == 590 && number == std::floor(number) && number >= 1 && number <= 6)
    return use_plain_system(kSystemWords[static_cast<int>(number) - 1]);
  const int most = control_.rules.numbered_offsets;
  if (number != std::floor(number) || number < 1 || number > most)
    control_.refuse(word + " P" + trimmed(number, 3) + ": the control has P1 to P" + std::to_string(most) +
                    "; correct it");
  control_.frame.use_system(Frame::kElsewhere);
  const std::string text = trimmed(number, 0);
  control_.condition(lower(word) + "-p" + text, word + " P" + text + " has its origin where the work's is");
}

void PlaceWords::use_system(int code, const Block& block) {
  if (uses_numbered_system(code, block)) return use_numbered_system(code, block);
  use_plain_system(code);
}

void PlaceWords::use_plain_system(int code) {
  const auto* const found = std::find(std::begin(kSystemWords), std::end(kSystemWords), code);
  const int system = static_cast<int>(found - std::begin(kSystemWords)) + 1;
  control_.frame.use_system(system);
  const auto& places = control_.options.places;
  if (code == 540 || (places && system <= places->stated_origins)) return;
  control_.condition(lower(g_word(code)), g_word(code) + " has its origin where the work's is");
}

void PlaceWords::refuse_lengths_in_plan(int code, const Block& block) const {
  for (const char letter : {'X', 'Y'}) {
    if (block.has(letter) && block.value(letter) != 0)
      control_.refuse(g_word(code) + " with X or Y is not read; post without it");
  }
}

/// G43.2 adds to the length in force: one that is stated, or one of the tool table.
void PlaceWords::add_length(const Block& block) {
  refuse_lengths_in_plan(432, block);
  if (block.has('H') == block.has('Z'))
    control_.refuse("G43.2 asks for the number of a length H, or the length Z itself; give one of them");
  control_.adds_length = true;
  if (block.has('Z'))
    return control_.frame.set_stated_length(control_.frame.stated_length() + control_.mm(block.value('Z')));
  const std::string number = trimmed(block.value('H'), 0);
  control_.condition("tool-length-g43.2", "the length H" + number + " that G43.2 adds is a wear of 0");
}

void PlaceWords::set_length(int code, const Block& block) {
  if (code == 432) return add_length(block);
  control_.adds_length = false;
  ToolLength length;
  if (code == 490) {
    length.kind = LengthKind::kOff;
  } else if (code == 431) {
    refuse_lengths_in_plan(code, block);
    length.kind = LengthKind::kStatedHeight;
    length.stated_mm = block.has('Z') ? control_.mm(block.value('Z')) : 0;
    control_.condition("tool-length-g43.1",
                       "the tool stood at its stated height when the work was touched off without G43.1");
  } else if (block.has('H')) {
    length.kind =
        block.value('H') == 0 && control_.rules.zero_length_is_off ? LengthKind::kOff : LengthKind::kNumbered;
    length.h = control_.last_length = static_cast<int>(block.value('H'));
  } else if (control_.rules.lengths_by_number) {
    length.kind = control_.last_length > 0 ? LengthKind::kNumbered : LengthKind::kOff;
    length.h = control_.last_length;
  } else {
    length.kind = LengthKind::kOfTool;
    length.h = control_.tool_said && control_.changer ? control_.builder.drive.tool : control_.next_tool;
  }
  control_.length_used = control_.length_used || code == 430;
  control_.frame.set_stated_length(length.stated_mm);
  control_.modes.length = control_.builder.length = length;
}

}  // namespace clearcut::read::gcode
