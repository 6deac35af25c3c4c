#include "read/gcode/recognise.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "read/common/text.h"
#include "read/gcode/macros/macro_line.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

namespace {

/// What a program uses, found in one pass.
struct Traits {
  bool percent = false;      ///< a '%' line
  bool tape = false;         ///< and an O word after it
  bool long_number = false;  ///< five digits in the O word
  bool parentheses = false;
  bool semicolons = false;
  bool end = false;  ///< M2 or M30
  bool last_m30 = false;
  bool blend_bound = false;  ///< G64 P
  bool blend_plain = false;  ///< G64
  bool length_plain = false;
  bool length_numbered = false;
  bool dwell_x = false;
  bool haas = false, fanuc = false, linuxcnc = false, okuma = false;
  bool tool = false;
  bool beyond_grbl = false;
  bool arcs_stated = false;    ///< G91.1
  bool old_units = false;      ///< G70 or G71 that is no turning cycle
  bool turns_said = false;     ///< an S word beyond the powers of Marlin's
  bool marlin = false;         ///< G4 S, M106, M107: printers' words
  bool o_words = false;        ///< O words with letters behind, or named parameters
  bool jumps = false;          ///< IF, GOTO, WHILE with DO; G65, M98, G68 and others that LinuxCNC has not
  bool scale_off = false;      ///< G50
  bool reference = false;      ///< G30
  std::vector<Dialect> named;  ///< controls that comments name, each once
};

/// What posts and people write in comments for the control that a program was made for.
struct ControlWord {
  std::string_view word;  ///< in capitals
  Dialect dialect;
};
constexpr ControlWord kControlWords[] = {
    {"GRBL", Dialect::kGrbl},     {"GRBLHAL", Dialect::kGrblHal},   {"LINUXCNC", Dialect::kLinuxCnc},
    {"EMC2", Dialect::kLinuxCnc}, {"MACH2", Dialect::kMach3},       {"MACH3", Dialect::kMach3},
    {"MACH4", Dialect::kMach4},   {"PATHPILOT", Dialect::kTormach}, {"TORMACH", Dialect::kTormach},
    {"HAAS", Dialect::kHaas},     {"FANUC", Dialect::kFanuc},       {"MAZAK", Dialect::kMazak},
    {"MARLIN", Dialect::kMarlin}, {"OKUMA", Dialect::kOkuma},       {"OSP", Dialect::kOkuma}};

/// Words end at everything but letters and digits: "Mach2/3" and "grbl_post.py" name their controls.
void note_named_controls(std::string_view comment, std::vector<Dialect>& named) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t begin = 0; begin < comment.size();) {
    std::size_t end = begin;
    while (end < comment.size() && in_word(comment[end])) ++end;
    const std::string word = capitals(comment.substr(begin, end - begin));
    for (const ControlWord& row : kControlWords) {
      if (row.word == word && std::find(named.begin(), named.end(), row.dialect) == named.end())
        named.push_back(row.dialect);
    }
    begin = end + 1;
  }
}

/// The S word of controls that say a power with it goes up to this.
constexpr double kFullPower = 255;

bool is_turning_cycle(const Block& block) {
  return block.has('P') || block.has('Q') || block.has('D') || block.has('U') || block.has('W');
}

void note_traits(const Block& block, std::string_view line, Traits& traits) {
  traits.percent = traits.percent || block.percent;
  if (block.has('O') && traits.percent) {
    traits.tape = true;
    const auto first = line.find_first_of("oO:");
    const auto last = line.find_first_not_of("0123456789", first + 1);
    traits.long_number = std::min(last, line.size()) - first - 1 >= 5;
  }
  for (const std::string_view comment : block.comments) {
    const bool semicolon = comment.data() > line.data() && comment.data()[-1] == ';';
    (semicolon ? traits.semicolons : traits.parentheses) = true;
    note_named_controls(comment, traits.named);
  }
  traits.okuma = traits.okuma || block.names_file;
  const auto missing = rules_of(Dialect::kLinuxCnc).g.missing;
  for (const int code : block.g) {
    traits.blend_bound = traits.blend_bound || (code == 640 && block.has('P'));
    traits.blend_plain = traits.blend_plain || (code == 640 && !block.has('P'));
    traits.length_plain = traits.length_plain || (code == 430 && !block.has('H'));
    traits.length_numbered = traits.length_numbered || (code == 430 && block.has('H'));
    traits.dwell_x = traits.dwell_x || (code == 40 && block.has('X') && !block.has('P'));
    traits.haas = traits.haas || code == 1870 || code == 1540;
    const bool other_length = has_g(block, 430) || has_g(block, 440);
    traits.okuma = traits.okuma || (block.has('H') && (code == 150 || (code == 560 && !other_length)));
    traits.fanuc = traits.fanuc || code == 541 || code == 51;
    traits.linuxcnc = traits.linuxcnc || code == 281 || code == 301 || code == 923;
    traits.arcs_stated = traits.arcs_stated || code == 911;
    traits.scale_off = traits.scale_off || code == 500;
    traits.reference = traits.reference || code == 300;
    traits.old_units = traits.old_units || ((code == 700 || code == 710) && !is_turning_cycle(block));
    traits.jumps = traits.jumps || code == 650 || code == 680 || code == 511 || code == 160 || code == 310;
    traits.jumps = traits.jumps || std::find(missing.begin(), missing.end(), code) != missing.end();
    traits.marlin = traits.marlin || (code == 40 && block.has('S') && !block.has('P'));
    const bool known = group_of(code) == Group::kUnknown || knows_g(rules_of(Dialect::kGrbl), code);
    traits.beyond_grbl = traits.beyond_grbl || !known;
  }
  for (const int m : block.m) {
    if (m == 20 || m == 300) {
      traits.end = true;
      traits.last_m30 = m == 300;
    }
    traits.linuxcnc = traits.linuxcnc || (m >= 700 && m <= 730);
    traits.haas = traits.haas || (m == 970 && block.has('P'));
    traits.jumps = traits.jumps || (m == 980 && block.has('P'));
    traits.marlin = traits.marlin || m == 1060 || m == 1070;
    traits.beyond_grbl = traits.beyond_grbl || m == 60 || (m == 980 && block.has('P'));
  }
  traits.tool = traits.tool || block.has('T');
  traits.linuxcnc = traits.linuxcnc || block.is_polar();
  traits.turns_said = traits.turns_said || (block.has('S') && block.value('S') > kFullPower);
}

/// A line that only a reader of macros understands.
void note_macro(std::string_view line, Traits& traits) {
  std::string text;
  try {
    text = cleaned(line, "").text;
  } catch (const InputError&) {
    return;
  }
  const auto has = [&](std::string_view word) { return text.find(word) != std::string::npos; };
  const bool is_o = text.size() > 1 && text[0] == 'O';
  const std::size_t behind = text.find_first_not_of("0123456789", 1);
  traits.o_words = traits.o_words || has("#<") || has("**") || (is_o && behind != std::string::npos);
  traits.beyond_grbl = true;
  traits.jumps = traits.jumps || has("GOTO") || has("]DO") || has("]THEN") || has("G65") || has("#0]") ||
                 (!is_o && (text.rfind("IF[", 0) == 0 || text.rfind("WHILE[", 0) == 0));
}

/// Grbl's and Marlin's programs look alike where all comments stand behind semicolons and nothing ends them.
bool is_grbl_or_marlin(const Traits& traits) {
  return traits.semicolons && !traits.parentheses && !traits.end && !traits.tool && !traits.beyond_grbl;
}

/// PathPilot has LinuxCNC's words and knows G50; its posts begin with G50 and G91.1 and go to G30 for a change of tools.
bool is_pathpilot(const Traits& traits) {
  return traits.scale_off &&
         (traits.linuxcnc || traits.blend_bound || (traits.arcs_stated && traits.reference));
}

/// The one control that comments name; Grbl only where it knows all words.
std::optional<Dialect> named_control(const Traits& traits) {
  if (traits.named.size() != 1 || (traits.named[0] == Dialect::kGrbl && traits.beyond_grbl))
    return std::nullopt;
  return traits.named[0];
}

/// What a program uses, and whose program that makes it.
struct Clue {
  bool (*is_there)(const Traits&);
  Recognised points_to;
};

/// Words of one control alone. Of these clues, as of those below, the first that is there counts.
constexpr Clue kWordsOfOne[] = {
    {[](const Traits& of) { return of.okuma; }, {Dialect::kOkuma, true, {}}},
    {[](const Traits& of) { return of.haas; }, {Dialect::kHaas, false, {}}},
    {[](const Traits& of) { return of.o_words; }, {Dialect::kLinuxCnc, true, {}}},
    {[](const Traits& of) { return of.fanuc || of.dwell_x; }, {Dialect::kFanuc, false, {}}},
    {is_pathpilot, {Dialect::kTormach, true, {}}},
    {[](const Traits& of) { return of.linuxcnc || of.blend_bound; }, {Dialect::kLinuxCnc, true, {}}}};

/// Habits of posts, for programs whose comments name no control.
constexpr Clue kHabits[] = {
    {[](const Traits& of) { return of.tape && of.long_number; }, {Dialect::kHaas, false, {}}},
    {[](const Traits& of) { return of.tape; }, {Dialect::kFanuc, false, {}}},
    {[](const Traits& of) { return of.old_units; }, {Dialect::kMach3, false, {}}},
    {[](const Traits& of) { return of.length_plain; }, {Dialect::kLinuxCnc, false, {}}},
    {[](const Traits& of) { return of.blend_plain && of.length_numbered; }, {Dialect::kMach3, false, {}}},
    {[](const Traits& of) { return of.jumps; }, {Dialect::kFanuc, false, {}}},
    {[](const Traits& of) { return is_grbl_or_marlin(of) && of.marlin; }, {Dialect::kMarlin, false, {}}},
    {[](const Traits& of) { return is_grbl_or_marlin(of) && of.turns_said; },
     {Dialect::kGrbl, false, Dialect::kMarlin}},
    {is_grbl_or_marlin, {Dialect::kMarlin, false, Dialect::kGrbl}},
    {[](const Traits& of) { return !of.beyond_grbl && of.last_m30 && of.arcs_stated && !of.blend_plain; },
     {Dialect::kGrbl, false, {}}},
    {[](const Traits&) { return true; }, {Dialect::kLinuxCnc, false, {}}}};

template <std::size_t kCount>
const Clue* first_of(const Clue (&clues)[kCount], const Traits& traits) {
  const auto* const clue =
      std::find_if(std::begin(clues), std::end(clues), [&](const Clue& one) { return one.is_there(traits); });
  return clue != std::end(clues) ? clue : nullptr;
}

}  // namespace

Recognised recognised(std::string_view text, const std::string& file_name) {
  Traits traits;
  Lines lines(text);
  BlockReader reader(text, file_name);
  std::string_view line;
  Block block;
  try {
    while (!traits.end && lines.next(line)) {
      try {
        if (!reader.next(block)) break;
        note_traits(block, line, traits);
      } catch (const MacroError&) {
        note_macro(line, traits);
      }
    }
  } catch (const InputError&) {
    // The reader itself says what is wrong, where it is not behind the end.
  }
  if (const Clue* clue = first_of(kWordsOfOne, traits)) return clue->points_to;
  if (const auto named = named_control(traits)) return {*named, true, {}};
  return first_of(kHabits, traits)->points_to;
}

}  // namespace clearcut::read::gcode
