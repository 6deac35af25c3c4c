// Order of execution within a block: modes, frames, path control, feed, spindle, tool, edge, motion, cycle, end. Words that mean the same to
// other controls are handed to their interpreter (control/).
#include "read/gcode/sinumerik/sinumerik.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/units.h"
#include "model/options/post_options.h"
#include "read/gcode/control/control.h"
#include "read/gcode/control/mode_words.h"
#include "read/gcode/control/motion_words.h"
#include "read/gcode/control/place_words.h"
#include "read/gcode/motion/cycle.h"
#include "read/gcode/program/program.h"
#include "read/gcode/sinumerik/held_words.h"
#include "read/gcode/sinumerik/language.h"
#include "read/gcode/sinumerik/words.h"
#include "read/gcode/words/block.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

constexpr std::string_view kAxes = "XYZ", kCenters = "IJK", kPlaces = "XYZIJK";
constexpr double kMostTurns = 10000;

/// What a word without a number does.
enum class NamedUse : unsigned char {
  kNothing,     ///< bears on neither path nor verdict
  kEnd,         ///< ends the program
  kSuppress,    ///< the block is in the machine's own frame
  kModalCall,   ///< calls a cycle at every place that follows
  kShift,       ///< moves the zero
  kShiftMore,   ///< moves it further
  kFrame,       ///< turns, scales or mirrors; alone it takes the programmed frame away
  kCompress,    ///< joins short blocks within a tolerance
  kAround,      ///< approaches go round the contour that compensation begins at
  kFreeRapids,  ///< rapids need not be straight
  kProgram      ///< jumps, loops, variables, calls
};

struct NamedWord {
  std::string_view name;
  NamedUse use;
};

constexpr NamedWord kNamedWords[] = {{"MSG", NamedUse::kNothing},        {"STOPRE", NamedUse::kNothing},
                                     {"FFWON", NamedUse::kNothing},      {"FFWOF", NamedUse::kNothing},
                                     {"SOFT", NamedUse::kNothing},       {"BRISK", NamedUse::kNothing},
                                     {"DRIVE", NamedUse::kNothing},      {"DYNNORM", NamedUse::kNothing},
                                     {"DYNPOS", NamedUse::kNothing},     {"DYNROUGH", NamedUse::kNothing},
                                     {"DYNSEMIFIN", NamedUse::kNothing}, {"DYNFINISH", NamedUse::kNothing},
                                     {"DYNPREC", NamedUse::kNothing},    {"COMPOF", NamedUse::kNothing},
                                     {"CFC", NamedUse::kNothing},        {"CFTCP", NamedUse::kNothing},
                                     {"CFIN", NamedUse::kNothing},       {"NORM", NamedUse::kNothing},
                                     {"KONT", NamedUse::kAround},        {"DIAMOF", NamedUse::kNothing},
                                     {"RTLION", NamedUse::kNothing},     {"WALIMON", NamedUse::kNothing},
                                     {"WALIMOF", NamedUse::kNothing},    {"TRAFOOF", NamedUse::kNothing},
                                     {"TOFFOF", NamedUse::kNothing},     {"CUT2D", NamedUse::kNothing},
                                     {"CUT2DF", NamedUse::kNothing},     {"FNORM", NamedUse::kNothing},
                                     {"WORKPIECE", NamedUse::kNothing},  {"GROUP_BEGIN", NamedUse::kNothing},
                                     {"GROUP_END", NamedUse::kNothing},  {"ADISPOS", NamedUse::kNothing},
                                     {"OTOL", NamedUse::kNothing},       {"RET", NamedUse::kEnd},
                                     {"SUPA", NamedUse::kSuppress},      {"MCALL", NamedUse::kModalCall},
                                     {"TRANS", NamedUse::kShift},        {"ATRANS", NamedUse::kShiftMore},
                                     {"ROT", NamedUse::kFrame},          {"AROT", NamedUse::kFrame},
                                     {"ROTS", NamedUse::kFrame},         {"AROTS", NamedUse::kFrame},
                                     {"CROTS", NamedUse::kFrame},        {"SCALE", NamedUse::kFrame},
                                     {"ASCALE", NamedUse::kFrame},       {"MIRROR", NamedUse::kFrame},
                                     {"AMIRROR", NamedUse::kFrame},      {"COMPON", NamedUse::kCompress},
                                     {"COMPCURV", NamedUse::kCompress},  {"COMPCAD", NamedUse::kCompress},
                                     {"COMPSURF", NamedUse::kCompress},  {"RTLIOF", NamedUse::kFreeRapids},
                                     {"IF", NamedUse::kProgram},         {"ELSE", NamedUse::kProgram},
                                     {"ENDIF", NamedUse::kProgram},      {"WHILE", NamedUse::kProgram},
                                     {"ENDWHILE", NamedUse::kProgram},   {"FOR", NamedUse::kProgram},
                                     {"ENDFOR", NamedUse::kProgram},     {"LOOP", NamedUse::kProgram},
                                     {"ENDLOOP", NamedUse::kProgram},    {"REPEAT", NamedUse::kProgram},
                                     {"REPEATB", NamedUse::kProgram},    {"UNTIL", NamedUse::kProgram},
                                     {"GOTO", NamedUse::kProgram},       {"GOTOF", NamedUse::kProgram},
                                     {"GOTOB", NamedUse::kProgram},      {"GOTOC", NamedUse::kProgram},
                                     {"GOTOS", NamedUse::kProgram},      {"CASE", NamedUse::kProgram},
                                     {"CALL", NamedUse::kProgram},       {"PCALL", NamedUse::kProgram},
                                     {"EXTCALL", NamedUse::kProgram},    {"EXTERN", NamedUse::kProgram},
                                     {"DEF", NamedUse::kProgram},        {"DEFINE", NamedUse::kProgram},
                                     {"PROC", NamedUse::kProgram},       {"SETAL", NamedUse::kProgram}};

std::optional<NamedUse> use_of(const std::string& name) {
  for (const NamedWord& one : kNamedWords)
    if (one.name == name) return one.use;
  return std::nullopt;
}

/// G words, whole numbers, that change nothing of a path: exact stop in one block and its criteria, Siemens mode, speed in rpm, what
/// compensation does where approaches meet the contour.
constexpr int kStillGWords[] = {9, 97, 290, 460, 461, 462, 601, 602};
/// G words that other controls take alike, as their interpreter knows them.
constexpr int kSharedGWords[] = {0, 1, 2, 3, 17, 18, 19, 40, 41, 42, 90, 91, 93, 94, 95, 54, 55, 56, 57};

/// G words that are refused, each with its reason for the message.
struct RefusedG {
  int word;
  std::string_view why;
};
constexpr RefusedG kRefusedG[] = {
    {33, "threads by words are not read; post CYCLE84 or CYCLE840"},
    {63, "threads by words are not read; post CYCLE84 or CYCLE840"},
    {331, "threads by words are not read; post CYCLE84 or CYCLE840"},
    {332, "threads by words are not read; post CYCLE84 or CYCLE840"},
    {58, "shifts single axes on a Sinumerik and is no work offset; post G54 to G57 or G505 to G599"},
    {59, "shifts single axes on a Sinumerik and is no work offset; post G54 to G57 or G505 to G599"},
    {74, "drives to reference points; post SUPA with the machine's place"},
    {75, "drives to a fixed point of the machine; post SUPA with the machine's place"},
    {96, "is a cutting speed for turning; post G97 with the spindle's speed"},
    {110, "polar coordinates are not read; post X and Y"},
    {111, "polar coordinates are not read; post X and Y"},
    {112, "polar coordinates are not read; post X and Y"},
    {291, "switches to ISO words; give the program that follows as one of fanuc"}};

class SinumerikReader {
 public:
  SinumerikReader(const DialectRules& rules, const ReadControllerOptions& options, ToolpathBuilder& builder)
      : control_(builder, rules, options), modes_(control_) {}

  bool read(std::string_view text) {
    Lines lines(text);
    for (std::string_view line; !control_.ended && lines.next(line);) execute_line(line, lines.number());
    if (control_.ended) warn_of_blocks_behind(lines);
    return control_.ended;
  }

  /// Follows the program and keeps what its words leave behind.
  StopScan scan(std::string_view text, int line) {
    StopScan scan;
    std::vector<MotionNeed> needs;
    Lines lines(text);
    try {
      for (std::string_view one; !control_.ended && lines.next(one);) {
        control_.line = lines.number();
        const SinumerikBlock block = sinumerik_block(one, refuse_, computes_);
        take_number(block.comment);
        if (!block.words.empty()) scan_block(block, line, needs, scan);
      }
    } catch (const MacroError&) {
      scan.macro_line = control_.line;
      if (scan.blocks.empty() || scan.blocks.back().line != control_.line) {
        scan.blocks.push_back({.line = control_.line});
        needs.push_back(MotionNeed::kPasses);
      }
    }
    settle_motion_words(needs, scan);
    return scan;
  }

  /// Programs that compute, loop and call.
  bool run(std::string_view text, const std::string& file_name) {
    const SinumerikBlocks blocks{[this](std::string_view block, int line) { execute_line(block, line); },
                                 [this] { return control_.ended; }, [this] { control_.ended = false; },
                                 [](const std::string& name) { return is_own_word(name); }};
    return run_sinumerik(text, file_name, blocks, control_.rules, control_.options, control_.builder);
  }

 private:
  /// Whether the name is a word or a cycle of the control's, read or refused.
  static bool is_own_word(const std::string& name) {
    constexpr std::string_view kOthers[] = {
        "AC",      "IC",      "CR",    "RPL",   "TURN",   "CTOL",   "ADIS",    "SPOS",    "RND",
        "RNDM",    "CHF",     "CHR",   "CIP",   "CT",     "ANG",    "TRAORI",  "POCKET1", "POCKET2",
        "POCKET3", "POCKET4", "SLOT1", "SLOT2", "HOLES1", "HOLES2", "LONGHOLE"};
    return use_of(name).has_value() || name.starts_with("CYCLE") ||
           std::find(std::begin(kOthers), std::end(kOthers), name) != std::end(kOthers);
  }

  void execute_line(std::string_view line, int number) {
    control_.line = number;
    const SinumerikBlock block = sinumerik_block(line, refuse_, computes_);
    read_marker(block.comment, control_.builder);
    take_number(block.comment);
    if (!block.words.empty()) execute(block);
  }

  void take_number(std::string_view comment) {
    if (const auto named = named_tool_in(comment)) tool_numbers_.insert(*named);
  }

  // --- where the program can be begun anew

  void scan_block(const SinumerikBlock& block, int line, std::vector<MotionNeed>& needs, StopScan& scan) {
    const StopBlock stop = stop_at(block);
    needs.push_back(need_of(block, stop));
    add_stop(
        stop, line, [this] { return held(); }, scan);
    const Coolant before = control_.modes.coolant;
    execute(block);
    keep_sinumerik_words(block, held_words_);
    keep_coolant(before, control_.modes.coolant, held_words_);
  }

  static bool has_word(const SinumerikBlock& block, std::string_view name) {
    return std::any_of(block.words.begin(), block.words.end(),
                       [&](const SinumerikWord& word) { return word.name == name; });
  }
  static std::optional<int> motion_word(const SinumerikBlock& block) {
    for (const SinumerikWord& word : block.words)
      if (word.name == "G" && word.number >= 0 && word.number <= 3) return static_cast<int>(word.number);
    return std::nullopt;
  }

  StopBlock stop_at(const SinumerikBlock& block) {
    StopBlock stop;
    stop.line = control_.line;
    const bool has_frame = std::any_of(block.words.begin(), block.words.end(), [](const SinumerikWord& word) {
      const auto use = use_of(word.name);
      return use == NamedUse::kShift || use == NamedUse::kShiftMore || use == NamedUse::kFrame;
    });
    stop.moves =
        !has_frame && std::any_of(block.words.begin(), block.words.end(), [](const SinumerikWord& word) {
          return word.name.size() == 1 && kPlaces.find(word.name[0]) != std::string_view::npos;
        });
    stop.changes_tool = std::any_of(block.words.begin(), block.words.end(), [](const SinumerikWord& word) {
      return word.name == "M" && word.number == 6;
    });
    const Target& at = control_.builder.position();
    stop.is_placed = at[0] && at[1] && at[2];
    stop.z = at[2].value_or(0);
    stop.tool = control_.builder.drive.tool;
    stop.hindrance = hindrance_at(block);
    return stop;
  }

  Hindrance hindrance_at(const SinumerikBlock& block) const {
    if (control_.builder.compensates() || control_.builder.compensation_leaves())
      return Hindrance::kCompensation;
    if (control_.builder.waits_at_corner()) return Hindrance::kCorner;
    const bool is_shifted = std::any_of(shifts_.begin(), shifts_.end(), [](double mm) { return mm != 0; });
    if (control_.plan_map.is_on || is_shifted) return Hindrance::kMap;
    if (modal_ && !has_word(block, "MCALL")) return Hindrance::kCycle;
    return Hindrance::kNone;
  }

  MotionNeed need_of(const SinumerikBlock& block, const StopBlock& stop) const {
    if (motion_word(block)) return MotionNeed::kNothing;
    if (!stop.moves) return MotionNeed::kPasses;
    const bool is_straight = control_.motion == 0 || control_.motion == 10;
    if (is_straight) return stop.is_placed ? MotionNeed::kNothing : MotionNeed::kStraight;
    return MotionNeed::kArcs;
  }

  HeldState held() {
    HeldState state;
    state.modes = control_.modes;
    state.modes.system = control_.frame.system();
    state.motion = control_.motion;
    state.tool = control_.builder.drive.tool;
    state.next_tool = control_.next_tool;
    state.tool_said = control_.tool_said;
    state.changer = control_.changer;
    state.position = control_.builder.position();
    for (std::size_t axis = 0; axis < 3; ++axis) state.shift[axis] = control_.frame.shift(axis);
    state.at_home = control_.builder.at_home_height();
    state.spindle_wait = wait_behind_spindle(control_.builder.events());
    state.words = held_words_;
    state.words.path = path_words();
    state.words.tool_numbers = tool_numbers_;
    return state;
  }

  /// The words that round corners as they are rounded now.
  std::string path_words() const {
    if (!high_speed_.empty()) return high_speed_;
    const auto number = [&](double mm) { return trimmed(mm / control_.modes.unit, 6); };
    switch (rounding_) {
      case Rounding::kUnstated:
        return "";
      case Rounding::kExactStop:
        return "G60";
      case Rounding::kFree:
        return "G64";
      case Rounding::kDistance:
        return "G641 ADIS=" + number(distance_mm_);
      case Rounding::kContour:
        return contour_mm_ ? "G642 CTOL=" + number(*contour_mm_) : "G642";
    }
    return "";
  }

  /// How corners are rounded.
  enum class Rounding : unsigned char { kUnstated, kExactStop, kFree, kDistance, kContour };

  /// What is gathered of a block before it is executed.
  struct Gathered {
    Block block;                               ///< what other controls have, too
    std::vector<const SinumerikWord*> places;  ///< X, Y, Z, I, J, K
    const SinumerikWord* call = nullptr;       ///< a cycle
    std::optional<NamedUse> frame;
    bool suppressed = false, modal = false, dwells = false, changes_path = false;
    std::optional<double> dwell_s, dwell_turns;
    std::optional<double> turn_deg;  ///< RPL
    std::optional<int> edge;
    std::optional<double> corner_feed;  ///< FRC
  };

  void execute(const SinumerikBlock& block) {
    Gathered found;
    found.block.line = control_.line;
    if (block.optional)
      control_.condition("block-delete", "blocks marked '/' are executed; block delete is off");
    for (const SinumerikWord& word : block.words) gather(word, found);
    // F and S of a dwell are its time.
    take_drive_words(block, found);
    modes_.set_modes(found.block);
    if (found.changes_path) {
      high_speed_.clear();
      set_path();
    }
    modes_.set_feed_and_drive(found.block, feed_unit());
    follow_tool(found);
    const bool moves = !found.dwells && !found.frame && !found.modal && !found.call;
    if ((found.block.corner || found.corner_feed) && !moves)
      control_.refuse("RND, CHR, CHF and FRC belong to a line or an arc; correct the block");
    if (found.dwells) return dwell(found);
    if (found.turn_deg && !found.frame) control_.refuse("RPL belongs to ROT and AROT; correct it");
    if (found.frame) return change_frame(found);
    if (found.modal) return set_modal(found);
    if (found.call) return run_call(*found.call);
    move(found);
    for (const int m : found.block.m) modes_.end(m);
  }

  // --- gathering

  void gather(const SinumerikWord& word, Gathered& found) {
    if (word.name == "G") return gather_g(word, found);
    if (word.name.size() == 1 && kPlaces.find(word.name[0]) != std::string_view::npos)
      return found.places.push_back(&word);
    if (gather_drive(word, found) || gather_path(word, found)) return;
    if (word.kind == SinumerikValue::kArguments &&
        (is_sinumerik_hole(word.name) || is_setting_cycle(word.name))) {
      found.call = &word;
      return;
    }
    const auto use = use_of(word.name);
    if (!use) refuse_word(word);
    use_named(*use, word, found);
  }

  static bool is_setting_cycle(const std::string& name) { return name == "CYCLE832" || name == "CYCLE800"; }

  void use_named(NamedUse use, const SinumerikWord& word, Gathered& found) {
    switch (use) {
      case NamedUse::kNothing:
        return;
      case NamedUse::kEnd:
        control_.ended = true;
        return;
      case NamedUse::kSuppress:
        found.suppressed = true;
        return;
      case NamedUse::kModalCall:
        found.modal = true;
        return;
      case NamedUse::kShift:
      case NamedUse::kShiftMore:
      case NamedUse::kFrame:
        found.frame = use;
        frame_word_ = word.name;
        return;
      case NamedUse::kAround:
        control_.refuse(
            "KONT goes round to a contour that compensation begins at, which is not read; post NORM");
      case NamedUse::kCompress:
        compressor_ = word.name;
        return;
      case NamedUse::kFreeRapids:
        control_.condition("rtliof",
                           "rapids need not be straight after RTLIOF; nothing stands beside their way");
        return;
      case NamedUse::kProgram:
        control_.macro(word.name + " does not stand where it is read; post the program without it");
    }
  }

  void gather_g(const SinumerikWord& word, Gathered& found) {
    const int g = static_cast<int>(word.number);
    if (word.kind != SinumerikValue::kNumber || g != word.number || g < 0)
      control_.refuse("G word with an impossible number; correct it");
    for (const RefusedG& one : kRefusedG)
      if (one.word == g) control_.refuse("G" + std::to_string(g) + " " + std::string(one.why));
    const auto among = [g](const auto& list) {
      return std::find(std::begin(list), std::end(list), g) != std::end(list);
    };
    if (among(kStillGWords)) return;
    if (g == 450 || g == 451) {
      control_.outside_corner = g == 450 ? OutsideCorner::kArc : OutsideCorner::kLines;
      return;
    }
    if (among(kSharedGWords)) {
      refuse_two_of_one_kind(10 * g, found.block);
      return found.block.g.push_back(10 * g);
    }
    if (g == 4) {
      found.dwells = true;
    } else if (g == 53 || g == 153) {
      found.suppressed = true;
    } else if (g == 500 || (g >= kFirstSettable / 10 && g <= kLastSettable / 10)) {
      use_offset(g);
    } else if (g == 70 || g == 71 || g == 700 || g == 710) {
      use_units(g, found);
    } else if (!set_rounding(g, found)) {
      control_.refuse("G" + std::to_string(g) + " is not read; post the program without it");
    }
  }

  void refuse_two_of_one_kind(int code, const Block& block) const {
    for (const int other : block.g)
      if (is_modal(group_of(code)) && group_of(code) == group_of(other))
        control_.refuse(g_word(code) + " contradicts another G word of its block; split the block");
  }

  /// G700 and G710 are inches and mm for all; G70 and G71 for lengths, while feeds stay in the control's own unit.
  void use_units(int g, Gathered& found) {
    found.block.g.push_back(g == 70 || g == 700 ? 200 : 210);
    feeds_in_mm_ = g == 70 || g == 71;
    if (feeds_in_mm_)
      control_.condition("g" + std::to_string(g),
                         "G" + std::to_string(g) +
                             " is for lengths alone; the control's own unit is mm, so that "
                             "F is in mm/min");
  }
  double feed_unit() const { return feeds_in_mm_ ? 1 : control_.modes.unit; }

  void use_offset(int g) {
    control_.frame.use_system(Frame::kElsewhere);
    const std::string word = "G" + std::to_string(g);
    control_.condition("g" + std::to_string(g), word + " has its origin where the work's is");
  }

  bool set_rounding(int g, Gathered& found) {
    switch (g) {
      case 60:
        rounding_ = Rounding::kExactStop;
        break;
      case 603:
        control_.condition(
            "g603", "G603 goes on before a corner is reached; what the axes lag behind matters to nobody");
        return true;
      case 64:
      case 644:
        rounding_ = Rounding::kFree;
        break;
      case 641:
        rounding_ = Rounding::kDistance;
        break;
      case 642:
      case 643:
      case 645:
        rounding_ = Rounding::kContour;
        break;
      default:
        return false;
    }
    found.changes_path = true;
    return true;
  }

  bool gather_path(const SinumerikWord& word, Gathered& found) {
    if (word.name == "RPL") {
      if (word.kind != SinumerikValue::kNumber) control_.refuse("RPL without a number; correct it");
      found.turn_deg = word.number;
      return true;
    }
    if (word.name != "CTOL" && word.name != "ADIS") return false;
    if (word.kind != SinumerikValue::kNumber) control_.refuse(word.name + " without a number; correct it");
    // Counted once the units of the block are known.
    (word.name == "CTOL" ? contour_word_ : distance_word_) = word.number;
    found.changes_path = true;
    return true;
  }

  /// Tool, edge, spindle and what belongs to arcs.
  bool gather_drive(const SinumerikWord& word, Gathered& found) {
    const std::string& name = word.name;
    if (name == "CR" || name == "TURN") {
      if (word.kind != SinumerikValue::kNumber) control_.refuse(name + " without a number; correct it");
      if (name == "TURN" &&
          !(word.number >= 0 && word.number < kMostTurns && word.number == std::floor(word.number)))
        control_.refuse("TURN= is no number of turns; correct it");
      found.block.set(name == "CR" ? 'R' : 'P', name == "CR" ? word.number : word.number + 1);
      return true;
    }
    if (gather_corner(word, found)) return true;
    if (name == "T") {
      found.block.set('T', word.kind == SinumerikValue::kText ? number_of_tool(word.text) : word.number);
      return true;
    }
    if (name == "D") {
      if (word.kind != SinumerikValue::kNumber || !(word.number >= 0 && word.number <= 99))
        control_.refuse("D word with an impossible edge; correct it");
      found.edge = static_cast<int>(word.number);
      return true;
    }
    if (name == "M" || name == "M1") {
      gather_m(word, found);
      return true;
    }
    if (name == "F" || name == "S" || name == "S1") return true;  // see take_drive_words
    if (name == "SPOS") {
      found.block.m.push_back(190);
      return true;
    }
    if (name == "H") {
      control_.condition("h", "H words go to the machine's own program; they move nothing");
      return true;
    }
    if (name == "A" || name == "B" || name == "C" || name == "U" || name == "V" || name == "W") {
      if (word.number != 0 || word.kind != SinumerikValue::kNumber)
        control_.refuse("axis word " + name + "; only the three axes X, Y, Z are read");
      return true;
    }
    return false;
  }

  /// RND= is the radius of a rounding, CHR= what a chamfer takes off each line, CHF= its length.
  bool gather_corner(const SinumerikWord& word, Gathered& found) const {
    const char letter = word.name == "RND" ? 'R' : word.name == "CHR" ? 'C' : word.name == "CHF" ? 'L' : '\0';
    if (letter == '\0' && word.name != "FRC") return false;
    if (word.kind != SinumerikValue::kNumber) control_.refuse(word.name + " without a number; correct it");
    if (letter == '\0') {
      found.corner_feed = word.number;
      return true;
    }
    if (found.block.corner) control_.refuse("two of RND, CHR and CHF in one block; keep one");
    found.block.corner = CornerWord{letter, word.number};
    return true;
  }

  void gather_m(const SinumerikWord& word, Gathered& found) {
    const int m = static_cast<int>(word.number);
    if (word.kind != SinumerikValue::kNumber || m != word.number || m < 0 || m > 999)
      control_.refuse("M word with an impossible number; correct it");
    if (m == 17) {
      control_.ended = true;
    } else if (m < 40 || m > 45) {  // those choose gears
      found.block.m.push_back(10 * m);
    }
  }

  void take_drive_words(const SinumerikBlock& block, Gathered& found) {
    for (const SinumerikWord& word : block.words) {
      const bool feed = word.name == "F", speed = word.name == "S" || word.name == "S1";
      if (!feed && !speed) continue;
      if (word.kind != SinumerikValue::kNumber) control_.refuse(word.name + " without a number; correct it");
      if (found.dwells)
        (feed ? found.dwell_s : found.dwell_turns) = word.number;
      else
        found.block.set(feed ? 'F' : 'S', word.number);
    }
  }

  /// Tools that are called by names are numbered as they come, behind those that comments number; a name that is a number is that tool.
  int number_of_tool(const std::string& name) {
    const bool is_number = !name.empty() && name.size() < 7 &&
                           std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (is_number) return std::stoi(name);
    int last = 0;
    for (const auto& [other, its] : tool_numbers_) last = std::max(last, its);
    const auto found = tool_numbers_.try_emplace(name, last + 1).first;
    const std::string number = std::to_string(found->second);
    control_.condition("tool-name-" + number, "T=\"" + name + "\" is the tool that is T" + number + " here");
    return found->second;
  }

  [[noreturn]] void refuse_word(const SinumerikWord& word) const {
    const std::string& name = word.name;
    if (name == "R") control_.macro("an R parameter stands alone; '=' and its value are missing");
    if (name == "L" || name == "P")
      control_.macro("a call of a subprogram stands in a block of its own; split the block");
    if (word.kind == SinumerikValue::kArguments)
      control_.macro(name + " is a cycle that is not read; post its moves one by one");
    control_.macro(name + " is not read; post the program without it");
  }

  // --- executing

  void set_path() {
    if (contour_word_)
      contour_mm_ = *contour_word_ > 0 ? std::optional(control_.mm(*contour_word_)) : std::nullopt;
    if (distance_word_) distance_mm_ = control_.mm(*distance_word_);
    contour_word_ = distance_word_ = std::nullopt;
    PathControl path;
    switch (rounding_) {
      case Rounding::kUnstated:
        break;
      case Rounding::kExactStop:
        path.mode = PathMode::kExactStop;
        break;
      case Rounding::kFree:
        path.mode = PathMode::kContinuous;
        break;
      case Rounding::kDistance:
        path.mode = distance_mm_ > 0 ? PathMode::kTolerance : PathMode::kContinuous;
        if (distance_mm_ > 0) path.tolerance_mm = distance_mm_;
        break;
      case Rounding::kContour:
        path.mode = contour_mm_ ? PathMode::kTolerance : PathMode::kSmoothness;
        path.tolerance_mm = contour_mm_;
    }
    control_.modes.path = control_.builder.path_control = path;
  }

  /// The first edge holds from a tool change on; D0 takes the length away until another D.
  void follow_tool(const Gathered& found) {
    const bool changed = std::find(found.block.m.begin(), found.block.m.end(), 60) != found.block.m.end();
    if (changed) {
      edge_said_ = false;
      use_edge(1);
    }
    if (!found.edge) return;
    edge_said_ = true;
    use_edge(*found.edge);
    if (*found.edge > 1) {
      const std::string word = "D" + std::to_string(*found.edge);
      control_.condition("d" + std::to_string(*found.edge), word + " holds the length of the tool's tip");
    }
  }

  void use_edge(int edge) {
    ToolLength length;
    length.kind = edge == 0 ? LengthKind::kOff : LengthKind::kOfTool;
    length.h = edge == 0 ? 0 : control_.builder.drive.tool;
    control_.length_used = control_.length_used || (edge > 0 && edge_said_);
    control_.modes.length = control_.builder.length = length;
  }

  void dwell(const Gathered& found) {
    if (found.dwell_s) return add_dwell(control_.builder, control_.line, *found.dwell_s, false);
    if (!found.dwell_turns) control_.refuse("G4 without F (seconds) or S (turns); add one");
    if (!(control_.modes.speed > 0)) control_.refuse("G4 S waits for turns of a spindle that has no speed");
    add_dwell(control_.builder, control_.line, 60 * *found.dwell_turns / control_.modes.speed, false);
  }

  /// TRANS, ROT, SCALE and MIRROR replace all that was programmed, ATRANS and its like add to it; any of the words alone takes all of it
  /// away.
  void change_frame(const Gathered& found) {
    const FrameRow& row = frame_row(frame_word_);
    if (row.replaces || (found.places.empty() && !found.turn_deg)) {
      control_.plan_map = {};
      for (std::size_t axis = 0; axis < 3; ++axis) shift_axis(axis, 0);
    }
    if (found.places.empty() && !found.turn_deg) return;
    if (found.turn_deg && row.change != FrameChange::kTurn)
      control_.refuse("RPL belongs to ROT and AROT; correct it");
    if (control_.builder.compensates() || control_.builder.compensation_leaves())
      control_.refuse(frame_word_ + " while cutter compensation is on; end it by G40 before");
    switch (row.change) {
      case FrameChange::kShift:
        return shift_frame(found);
      case FrameChange::kTurn:
        return turn_frame(found);
      case FrameChange::kMirror:
        return mirror_frame(found);
      case FrameChange::kScale:
        return scale_frame(found);
      case FrameChange::kNone:
        control_.refuse(frame_word_ + " turns in space, which is not read; post without it");
    }
  }

  enum class FrameChange : unsigned char { kNone, kShift, kTurn, kMirror, kScale };
  struct FrameRow {
    std::string_view word;
    FrameChange change;
    bool replaces;
  };
  static const FrameRow& frame_row(const std::string& word) {
    static constexpr FrameRow kRows[] = {
        {"TRANS", FrameChange::kShift, true},   {"ATRANS", FrameChange::kShift, false},
        {"ROT", FrameChange::kTurn, true},      {"AROT", FrameChange::kTurn, false},
        {"MIRROR", FrameChange::kMirror, true}, {"AMIRROR", FrameChange::kMirror, false},
        {"SCALE", FrameChange::kScale, true},   {"ASCALE", FrameChange::kScale, false},
        {"", FrameChange::kNone, true}};
    for (const FrameRow& row : kRows)
      if (row.word == word) return row;
    return kRows[std::size(kRows) - 1];
  }

  /// The number of an axis word of a frame.
  std::pair<std::size_t, double> frame_value(const SinumerikWord& word) const {
    const std::size_t axis = kAxes.find(word.name[0]);
    if (axis == std::string_view::npos || word.kind != SinumerikValue::kNumber)
      control_.refuse(frame_word_ + " takes X, Y and Z alone; correct it");
    return {axis, word.number};
  }

  /// Counted in the axes that are turned already.
  void shift_frame(const Gathered& found) {
    std::array<double, 3> by{};
    for (const SinumerikWord* word : found.places) {
      const auto [axis, value] = frame_value(*word);
      by[axis] = control_.mm(value);
    }
    const Vec2 plan = control_.plan_map.is_on ? control_.plan_map.turned({by[0], by[1]}) : Vec2{by[0], by[1]};
    shift_axis(0, shifts_[0] + plan.x);
    shift_axis(1, shifts_[1] + plan.y);
    shift_axis(2, shifts_[2] + by[2]);
  }

  void turn_frame(const Gathered& found) {
    double degrees = found.turn_deg.value_or(0);
    for (const SinumerikWord* word : found.places) {
      const auto [axis, value] = frame_value(*word);
      if (axis != 2 && value != 0)
        control_.refuse(frame_word_ +
                        " about X or Y tilts the plane, which is not read; only turns about Z are");
      if (axis == 2) degrees += value;
    }
    const double angle = degrees * kPi / 180, c = base::cos(angle), s = base::sin(angle);
    map_frame({c, -s, s, c}, 1);
  }

  void mirror_frame(const Gathered& found) {
    std::array<double, 2> sign{1, 1};
    for (const SinumerikWord* word : found.places) {
      const std::size_t axis = frame_value(*word).first;
      if (axis == 2) control_.refuse("a mirrored Z is not read; post the program without it");
      sign[axis] = -1;
    }
    map_frame({sign[0], 0, 0, sign[1]}, 1);
  }

  void scale_frame(const Gathered& found) {
    std::array<double, 3> by{1, 1, 1};
    for (const SinumerikWord* word : found.places) {
      const auto [axis, value] = frame_value(*word);
      by[axis] = value;
    }
    if (by[2] != 1 || by[0] != by[1] || !(by[0] > 0))
      control_.refuse(frame_word_ +
                      " is read with one factor above 0 for X and Y, and none for Z; post without it");
    map_frame({by[0], 0, 0, by[1]}, by[0]);
  }

  /// Puts a change of the axes in plan (xx, xy, yx, yy) behind those in force.
  void map_frame(const std::array<double, 4>& change, double scale) {
    if (control_.modes.plane != Plane::kXY)
      control_.refuse(frame_word_ + " outside the XY plane is not read; use G17");
    PlanMap& map = control_.plan_map;
    const PlanMap before = map;
    map.xx = before.xx * change[0] + before.xy * change[2];
    map.xy = before.xx * change[1] + before.xy * change[3];
    map.yx = before.yx * change[0] + before.yy * change[2];
    map.yy = before.yx * change[1] + before.yy * change[3];
    map.scale = before.scale * scale;
    map.flips = map.xx * map.yy - map.xy * map.yx < 0;
    map.fixed = {};
    map.words = "ROT, MIRROR and SCALE";
    map.is_on = true;
  }

  void shift_axis(std::size_t axis, double value) {
    shifts_[axis] = value;
    control_.frame.set_local(axis, value);
  }

  void set_modal(const Gathered& found) {
    modal_.reset();
    if (!found.call) return;
    if (!is_sinumerik_hole(found.call->name))
      control_.refuse("MCALL of " + found.call->name + " is not read");
    check_sinumerik_hole(control_, *found.call);
    modal_ = *found.call;
  }

  void run_call(const SinumerikWord& call) {
    if (call.name == "CYCLE832") return set_high_speed(call);
    if (call.name == "CYCLE800") return leave_plane(call);
    make_sinumerik_hole(control_, call);
  }

  /// Tolerance and kind of machining, of which the units say none (0), finishing (1) and so on; _OFF, _FINISH likewise.
  void set_high_speed(const SinumerikWord& call) {
    const auto argument = [&](std::size_t k) {
      return k < call.arguments.size() ? call.arguments[k] : std::string();
    };
    const std::string mode = argument(1);
    const bool is_off = mode.empty() || mode.back() == '0' || mode == "_OFF";
    double tolerance = 0;
    if (!argument(0).empty()) {
      SinumerikBlock parsed = sinumerik_block("CTOL=" + argument(0), refuse_, computes_);
      tolerance = parsed.words.front().number;
    }
    rounding_ = is_off ? Rounding::kUnstated : Rounding::kContour;
    contour_word_ = is_off ? 0 : tolerance;
    high_speed_ = is_off ? std::string() : fmt::format("CYCLE832({})", fmt::join(call.arguments, ","));
    set_path();
  }

  /// Empty it brings the swivel axes to where they stand for three axes; with anything in it they turn.
  void leave_plane(const SinumerikWord& call) {
    if (!call.arguments.empty())
      control_.refuse("CYCLE800 swivels the plane of machining, which is not read; only X, Y, Z are");
    control_.condition("cycle800", "the swivel axes stand at their start, so that CYCLE800() moves nothing");
  }

  void move(Gathered& found) {
    Block& block = found.block;
    if (found.suppressed) block.g.push_back(530);
    if (found.corner_feed) {
      if (!block.corner) control_.refuse("FRC without RND, CHR or CHF in its block; correct it");
      block.corner->feed = *found.corner_feed * feed_unit();
    }
    const bool absolute_centers = set_places(found);
    if (found.suppressed) note_length_in_machine_frame(block);
    const int said = motion_in(block);
    const int motion = said >= 0 ? said : control_.motion;
    const bool cuts = block.has_axis() && motion != 0 && !found.suppressed;
    if (cuts) note_before_cut();
    control_.modes.absolute_centers = absolute_centers;
    MotionWords(control_).move(block);
    control_.modes.absolute_centers = false;
    if (modal_ && block.has_axis() && !found.suppressed) make_sinumerik_hole(control_, *modal_);
  }

  void note_before_cut() {
    const bool by_itself = control_.modes.length.kind == LengthKind::kOfTool && !edge_said_;
    if (by_itself)
      control_.condition("d1",
                         "no D word follows the tool change; the control takes the first edge by itself");
    if (!compressor_.empty() && !contour_mm_)
      control_.condition(
          "compressor",
          compressor_ +
              " joins blocks within a bound of its own (no CTOL); it rounds by nothing that matters");
  }

  /// With a length in force it is the tip that goes to the machine's place.
  void note_length_in_machine_frame(const Block& block) {
    const LengthKind kind = control_.modes.length.kind;
    if (block.has('Z') && kind != LengthKind::kOff && kind != LengthKind::kUnstated)
      control_.condition("d0",
                         "Z goes to a place of the machine with the tool's length in force (no D0); the "
                         "spindle stays within its travel");
  }

  /// Axis words as the mode of the block has them; whether the centres of arcs are absolute.
  bool set_places(Gathered& found) {
    int absolute = 0, centers = 0;
    for (const SinumerikWord* word : found.places) {
      const char letter = word->name[0];
      if (found.block.has(letter))
        control_.refuse(std::string("two ") + letter + " words in one block; split it");
      if (word->kind == SinumerikValue::kText || word->kind == SinumerikValue::kNone ||
          word->kind == SinumerikValue::kArguments)
        control_.refuse(std::string(1, letter) + " without a number; correct it");
      const std::size_t center = kCenters.find(letter);
      if (center != std::string_view::npos) {
        ++centers;
        absolute += word->kind == SinumerikValue::kAbsolute ? 1 : 0;
        found.block.set(letter, word->number);
      } else {
        found.block.set(letter, in_mode_of_block(*word, kAxes.find(letter), found.suppressed));
      }
    }
    if (absolute > 0 && absolute < centers)
      control_.refuse("one centre word with AC() beside one without; give both alike");
    if (absolute == 0 || !control_.plan_map.is_on) return absolute > 0;
    // In turned axes centres count from the arc's start.
    for (const std::size_t axis : {0U, 1U})
      if (const char letter = kCenters[axis]; found.block.has(letter))
        found.block.set(letter, found.block.value(letter) - program_place(axis) / control_.modes.unit);
    return false;
  }

  /// Where the tool stands, as the program counts, mm.
  double program_place(std::size_t axis) {
    if (axis == 2 || !control_.plan_map.is_on)
      return control_.builder.known(axis, control_.line) - control_.frame.shift(axis);
    const Vec2 at{control_.builder.known(0, control_.line) - control_.frame.shift(0),
                  control_.builder.known(1, control_.line) - control_.frame.shift(1)};
    const Vec2 place = control_.plan_map.placed_back(at);
    return axis == 0 ? place.x : place.y;
  }

  double in_mode_of_block(const SinumerikWord& word, std::size_t axis, bool suppressed) {
    const bool is_absolute = word.kind == SinumerikValue::kAbsolute, absolute = control_.modes.absolute;
    if (word.kind == SinumerikValue::kNumber || is_absolute == absolute) return word.number;
    if (suppressed) control_.refuse("AC() and IC() in the machine's frame are not read; post plain numbers");
    const double here = program_place(axis) / control_.modes.unit;
    return is_absolute ? word.number - here : word.number + here;
  }

  /// What a control never runs may be what somebody wanted to be cut.
  void warn_of_blocks_behind(Lines& lines) {
    const int end = control_.line;
    try {
      for (std::string_view line; lines.next(line);) {
        if (sinumerik_block(line, refuse_, computes_).words.empty()) continue;
        control_.builder.warn(lines.number(),
                              "what follows the end word in line " + std::to_string(end) + " is not run");
        return;
      }
    } catch (const InputError&) {
      return;  // no code
    }
  }

  Control control_;
  ModeWords modes_;
  RefuseBlock refuse_ = [this](const std::string& why) { control_.refuse(why); };
  RefuseBlock computes_ = [this](const std::string& why) { control_.macro(why); };
  HeldWords held_words_;    ///< while stops are scanned
  std::string high_speed_;  ///< the call of CYCLE832 in force, as text
  std::optional<SinumerikWord> modal_;
  std::map<std::string, int> tool_numbers_;
  Rounding rounding_ = Rounding::kUnstated;
  std::optional<double> contour_word_, distance_word_;  ///< in the program's unit
  std::optional<double> contour_mm_;
  double distance_mm_ = 0;
  std::array<double, 3> shifts_{};  ///< mm, by TRANS and ATRANS
  std::string frame_word_, compressor_;
  bool edge_said_ = false, feeds_in_mm_ = false;
};

}  // namespace

StopScan scan_sinumerik_stops(std::string_view text, const std::string& file_name,
                              const ReadControllerOptions& options, int line) {
  Diagnostics diagnostics;
  std::vector<Condition> conditions;
  ToolpathBuilder builder({file_name, options.home_z, options.safe_z}, diagnostics, conditions);
  return SinumerikReader(rules_of(*options.dialect), options, builder).scan(text, line);
}

bool read_sinumerik(std::string_view text, const std::string& file_name, SinumerikDepth depth,
                    const DialectRules& rules, const ReadControllerOptions& options,
                    ToolpathBuilder& builder) {
  SinumerikReader reader(rules, options, builder);
  return depth == SinumerikDepth::kPlain ? reader.read(text) : reader.run(text, file_name);
}

}  // namespace clearcut::read::gcode
