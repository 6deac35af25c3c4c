#include "read/board/gerber_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/units.h"
#include "geometry/contours/boolean.h"
#include "read/board/drawn.h"
#include "read/board/gerber_canvas.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/drawing/layer_rules.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {
namespace {

class Splitter {
 public:
  explicit Splitter(const std::string& file) : file_(file) {}

  void add(char c) {
    if (c == '\n') ++line_;
    if (c == '%' && !is_comment()) {
      in_extended_ ? end_extended() : begin_extended();
    } else if (c == '*') {
      end_block();
    } else if (static_cast<unsigned char>(c) >= ' ') {
      if (block_.empty()) block_line_ = line_;
      block_ += c;
    }
  }

  std::vector<GerberCommand> take() {
    if (in_extended_) fail();
    if (block_.find_first_not_of(' ') != std::string::npos) end_block();
    return std::move(commands_);
  }

 private:
  bool is_comment() const { return block_.starts_with("G04"); }

  [[noreturn]] void fail() const {
    throw InputError(file_ + ":" + std::to_string(begin_line_),
                     "a command that begins with % has no end; the file is damaged, export it again");
  }

  void begin_extended() {
    end_block();
    in_extended_ = true;
    begin_line_ = line_;
    begin_ = commands_.size();
  }

  void end_extended() {
    end_block();
    in_extended_ = false;
    if (begin_ == commands_.size() || !commands_[begin_].text.starts_with("AM")) return;
    for (std::size_t i = begin_ + 1; i < commands_.size(); ++i)
      commands_[begin_].blocks.push_back(std::move(commands_[i].text));
    commands_.resize(begin_ + 1);
  }

  void end_block() {
    if (block_.find_first_not_of(' ') != std::string::npos)
      commands_.push_back({std::move(block_), {}, in_extended_, block_line_});
    block_.clear();
  }

  const std::string& file_;
  std::vector<GerberCommand> commands_;
  std::string block_;
  int line_ = 1, block_line_ = 1, begin_line_ = 1;
  std::size_t begin_ = 0;  ///< the first command of the extended ones
  bool in_extended_ = false;
};

}  // namespace

std::vector<GerberCommand> gerber_commands(std::string_view text, const std::string& file) {
  Splitter splitter(file);
  for (const char c : text) splitter.add(c);
  return splitter.take();
}

namespace {

constexpr int kFirstAperture = 10;
constexpr double kMostRepeats = 10000;

/// "MIA0B0", "OFA0B0", "SFA1B1", "ICAS" (the file is in ASCII): commands without effect.
bool has_no_effect(std::string_view text) {
  if (text == "IPPOS" || text == "ASAXBY" || text == "IR0" || text == "ICAS") return true;
  const bool scale = text.starts_with("SF");
  if (!scale && !text.starts_with("MI") && !text.starts_with("OF")) return false;
  const auto words = words_of(text.substr(2));
  return words && std::all_of(words->begin(), words->end(),
                              [&](const auto& word) { return plain_number(word.second) == (scale ? 1 : 0); });
}

bool is_one_of(std::string_view text, const auto& codes) {
  return std::any_of(codes.begin(), codes.end(),
                     [&](std::string_view code) { return text.starts_with(code); });
}

class GerberReader {
 public:
  GerberReader(const std::string& file, const RepairOptions& repair)
      : file_(file), repair_(repair), canvas_(repair_.where) {}

  GerberImage read(std::string_view text) {
    for (const GerberCommand& command : gerber_commands(text, file_)) {
      repair_.where = file_ + ":" + std::to_string(command.line);
      if (ended_) break;
      command.extended ? extended(command) : word_command(command.text);
    }
    if (!ended_) fail("the file ends without M02: it is cut short; export it again");
    return {canvas_.take(), std::move(function_)};
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(repair_.where, what); }
  [[noreturn]] void not_understood(std::string_view command) const {
    fail("Gerber command '" + printable(command) +
         "' is not understood; export the layer again as RS-274X or X2");
  }

  void extended(const GerberCommand& command) {
    /// Attributes, and names of images and layers: not drawn.
    constexpr std::array<std::string_view, 6> kNotDrawn{"TF", "TA", "TO", "TD", "IN", "LN"};
    constexpr std::array<std::string_view, 6> kWholeImage{"IP", "AS", "IR", "MI", "OF", "SF"};
    const std::string& text = command.text;
    const auto is = [&](std::string_view code) { return text.starts_with(code); };
    if (is("FS")) return format(text);
    if (is("MO")) return unit(text);
    if (is("AD")) return define_aperture(text);
    if (is("AM")) return void(macros_[text.substr(2)] = command.blocks);
    if (text == "LPD" || text == "LPC") return canvas_.set_dark(text == "LPD");
    if (is("LM") || is("LR") || is("LS")) return transform(text);
    if (is("SR")) return repeat(text);
    if (is("AB")) return aperture_block(text);
    if (is("TF.FileFunction,")) return void(function_ = text.substr(text.find(',') + 1));
    if (is_one_of(text, kNotDrawn) || has_no_effect(text)) return;
    if (!is_one_of(text, kWholeImage)) not_understood(text);
    fail("'" + printable(text) +
         "' changes the whole image in a way that is no longer in use; export the layer again");
  }

  void format(std::string_view text) {
    const auto words = words_of(text.substr(2));
    if (!words) not_understood(text);
    for (const auto& [letter, digits] : *words) {
      if (letter == 'I') is_incremental_ = true;
      if (letter == 'T') format_.trailing_omitted = true;
      if (letter != 'X') continue;
      if (digits.size() != 2 || digits[0] < '0' || digits[0] > '7' || digits[1] < '0' || digits[1] > '7')
        not_understood(text);
      format_.whole = digits[0] - '0';
      format_.decimals = digits[1] - '0';
      has_format_ = true;
    }
    if (!has_format_) not_understood(text);
  }

  void unit(std::string_view text) {
    if (text != "MOMM" && text != "MOIN") not_understood(text);
    mm_ = text == "MOMM" ? 1 : kMmPerInch;
    has_unit_ = true;
  }

  void define_aperture(const std::string& text) {
    const std::size_t end = text.find_first_not_of("0123456789", 3);
    if (text.size() < 4 || text[2] != 'D' || end == std::string::npos) not_understood(text);
    const auto number = plain_number(std::string_view(text).substr(3, end - 3));
    if (!number || !(*number < 1e9)) not_understood(text);
    need_unit();
    canvas_.define(static_cast<int>(*number), aperture_of(text.substr(end), {macros_, mm_, repair_}));
  }

  void transform(const std::string& text) {
    if (text.starts_with("LM")) {
      canvas_.transform().mirror_x = text.find('X') != std::string::npos;
      canvas_.transform().mirror_y = text.find('Y') != std::string::npos;
      return;
    }
    const auto value = plain_number(std::string_view(text).substr(2));
    if (!value || (text[1] == 'S' && !(*value > 0))) not_understood(text);
    (text[1] == 'S' ? canvas_.transform().scale : canvas_.transform().turn_deg) = *value;
  }

  void repeat(std::string_view text) {
    if (text == "SR") return canvas_.end_repeat();
    const auto words = words_of(text.substr(2));
    if (!words) not_understood(text);
    StepAndRepeat block;
    for (const auto& [letter, digits] : *words) {
      const auto value = plain_number(digits);
      const bool counts = letter == 'X' || letter == 'Y';
      if (!value || (counts && !(*value >= 1 && *value <= kMostRepeats && *value == std::floor(*value))))
        not_understood(text);
      if (letter == 'X') block.columns = static_cast<int>(*value);
      if (letter == 'Y') block.rows = static_cast<int>(*value);
      if (letter == 'I') block.step.x = *value * mm_;
      if (letter == 'J') block.step.y = *value * mm_;
    }
    canvas_.begin_repeat(block);
  }

  void aperture_block(std::string_view text) {
    if (text == "AB") return canvas_.end_aperture();
    const auto number = text.starts_with("ABD") ? plain_number(text.substr(3)) : std::nullopt;
    if (!number || !(*number >= kFirstAperture && *number < 1e9)) not_understood(text);
    canvas_.begin_aperture(static_cast<int>(*number));
  }

  void word_command(std::string_view text) {
    if (text.starts_with("G04") || text.starts_with("G4 ")) return comment(text);
    const auto words = words_of(text);
    if (!words) not_understood(text);
    std::optional<int> operation;
    GerberMove move;
    for (const auto& [letter, digits] : *words) {
      const double number = plain_number(digits).value_or(-1);
      if (letter == 'G') {
        general(number, text);
      } else if (letter == 'M') {
        if (number != 0 && number != 1 && number != 2) not_understood(text);
        ended_ = number != 1;
      } else if (letter == 'D') {
        if (!(number >= 0 && number < 1e9) || (number >= 4 && number < kFirstAperture)) not_understood(text);
        operation = static_cast<int>(number);
      } else {
        move.set(letter, length(digits, text));
      }
    }
    if (operation && *operation >= kFirstAperture) return canvas_.select(*operation);
    if (operation && *operation > 0) operation_ = *operation;
    if (operation || move.any()) operate(move);
  }

  /// "G04 #@! TF.FileFunction,Copper,L1,Top" is an attribute in files for old readers.
  void comment(std::string_view text) {
    const std::string_view mark = "TF.FileFunction,";
    const std::size_t at = text.find(mark);
    if (at != std::string_view::npos && text.find("#@!") < at) function_ = text.substr(at + mark.size());
  }

  void general(double code, std::string_view text) {
    if (code == 0 || code == 1) return void(turn_ = Turn::kStraight);
    if (code == 2) return void(turn_ = Turn::kClockwise);
    if (code == 3) return void(turn_ = Turn::kCounterClockwise);
    if (code == 36) return canvas_.begin_region();
    if (code == 37) return canvas_.end_region();
    if (code == 70) return unit("MOIN");
    if (code == 71) return unit("MOMM");
    if (code == 74 || code == 75) return void(single_quadrant_ = code == 74);
    if (code == 90 || code == 91) return void(is_incremental_ = code == 91);
    if (code != 54 && code != 55) not_understood(text);  // these say no more than the D word after them
  }

  double length(std::string_view digits, std::string_view text) const {
    need_unit();
    if (!has_format_)
      fail(
          "the file does not say how its numbers are written (%FS...); export the layer again as RS-274X or "
          "X2");
    const auto value = coordinate(digits, format_);
    if (!value) not_understood(text);
    return *value * mm_;
  }

  void need_unit() const {
    if (!has_unit_)
      fail("the file does not say its unit (%MOMM*% or %MOIN*%); export the layer again as RS-274X or X2");
  }

  void operate(const GerberMove& move) {
    const Vec2 from = at_;
    at_ = move.end(from, is_incremental_);
    if (operation_ == 1) {
      const auto edges = gerber_edge(from, at_, move.center_offset(), turn_, single_quadrant_);
      if (!edges)
        fail("an arc has no center at the same distance from both of its ends; export the layer again");
      canvas_.draw_to(at_, *edges);
    } else if (operation_ == 2) {
      canvas_.lift();
    } else if (operation_ == 3 && !canvas_.in_region()) {
      canvas_.flash(at_);
    } else {
      fail("coordinates without a command what to do there (D01, D02, D03); export the layer again");
    }
  }

  const std::string& file_;
  RepairOptions repair_;  ///< its place is that of the current command
  GerberCanvas canvas_;
  bool ended_ = false;
  std::string function_;
  // Format of the file's coordinates.
  CoordinateFormat format_;
  bool has_format_ = false, has_unit_ = false, is_incremental_ = false;
  double mm_ = 1;
  Macros macros_;
  // The current state.
  Vec2 at_;
  int operation_ = 0;
  Turn turn_ = Turn::kStraight;
  bool single_quadrant_ = false;
};

}  // namespace

GerberImage gerber_image(std::string_view text, const std::string& file, const RepairOptions& repair) {
  return GerberReader(file, repair).read(text);
}

namespace {

/// Meaning of a word of the attribute or of the file's name.
struct LayerWord {
  std::string_view word;
  LayerRole role;
};

/// First fields of the attribute FileFunction (section 5.6.3 of the specification).
constexpr std::array kFunctions{
    LayerWord{"COPPER", LayerRole::kIsolate}, LayerWord{"PROFILE", LayerRole::kProfile},
    LayerWord{"PLATED", LayerRole::kHole}, LayerWord{"NONPLATED", LayerRole::kHole}};

/// Parts of names as CAD programs give them: KiCad, EAGLE, Altium and their kin.
constexpr std::array kNames{
    LayerWord{"EDGE_CUTS", LayerRole::kProfile}, LayerWord{"EDGE.CUTS", LayerRole::kProfile},
    LayerWord{"OUTLINE", LayerRole::kProfile},   LayerWord{"PROFILE", LayerRole::kProfile},
    LayerWord{"DIMENSION", LayerRole::kProfile}, LayerWord{".GKO", LayerRole::kProfile},
    LayerWord{".GM1", LayerRole::kProfile},      LayerWord{".GML", LayerRole::kProfile},
    LayerWord{"F_CU", LayerRole::kIsolate},      LayerWord{"B_CU", LayerRole::kIsolate},
    LayerWord{"F.CU", LayerRole::kIsolate},      LayerWord{"B.CU", LayerRole::kIsolate},
    LayerWord{"COPPER", LayerRole::kIsolate},    LayerWord{".GTL", LayerRole::kIsolate},
    LayerWord{".GBL", LayerRole::kIsolate},      LayerWord{".CMP", LayerRole::kIsolate},
    LayerWord{".SOL", LayerRole::kIsolate},      LayerWord{"MASK", LayerRole::kPocket},
    LayerWord{"PASTE", LayerRole::kPocket},      LayerWord{"SILK", LayerRole::kPocket},
    LayerWord{".GTS", LayerRole::kPocket},       LayerWord{".GBS", LayerRole::kPocket},
    LayerWord{".GTP", LayerRole::kPocket},       LayerWord{".GBP", LayerRole::kPocket},
    LayerWord{".GTO", LayerRole::kPocket},       LayerWord{".GBO", LayerRole::kPocket}};

std::optional<LayerRole> role_of_function(const std::string& function) {
  const std::string field = capitals(function.substr(0, function.find(',')));
  for (const LayerWord& word : kFunctions)
    if (field == word.word) return word.role;
  return field.empty() ? std::nullopt : std::optional(LayerRole::kPocket);
}

std::optional<LayerRole> role_of_name(const std::string& file_name) {
  const std::string name = capitals(std::filesystem::path(file_name).filename().string());
  for (const LayerWord& word : kNames)
    if (name.find(word.word) != std::string::npos) return word.role;
  return std::nullopt;
}

bool is_bottom(const std::string& function, const std::string& file_name) {
  const std::string words = "," + capitals(function) + ",";
  if (words.size() > 2) return words.find(",BOT,") != std::string::npos;
  const std::string name = capitals(std::filesystem::path(file_name).filename().string());
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  return has("B_CU") || has("B.CU") || has(".GBL") || has("BOTTOM");
}

DrawnGroup group_of(const std::string& function, const std::string& file_name, const ReadOptions& options) {
  DrawnGroup group;
  group.name = std::filesystem::path(file_name).stem().string();
  group.where = file_name;
  std::optional<LayerRole> role = role_of_function(function);
  if (!role) role = role_of_name(file_name);
  group.role = role.value_or(LayerRole::kPocket);
  group.says_role = role.has_value();
  apply_rules(options.layer_rules, group.name, group);
  return group;
}

/// Paths of a cutter along drawn items: strokes without their width, and the outlines of areas.
std::vector<RawCurve> lines_of(std::vector<Drawn> drawn) {
  std::vector<RawCurve> curves;
  for (Drawn& one : drawn) {
    if (!one.line.empty()) {
      curves.push_back({std::move(one.line), false, "a line", {}});
    } else {
      for (Path& piece : one.pieces) curves.push_back({std::move(piece), true, "an area", {}});
    }
  }
  return curves;
}

std::vector<RawCurve> areas_of(const std::vector<Drawn>& drawn, const RepairOptions& repair) {
  std::vector<RawCurve> curves;
  for (Path& loop : loops_of(dark_area(drawn, repair)))
    curves.push_back({std::move(loop), true, "what is drawn", Compound{}});
  return curves;
}

void scale(std::vector<Drawn>& drawn, double by) {
  if (by == 1) return;
  for (Drawn& one : drawn) one = mapped(one, Affine::scaling(by, by));
}

}  // namespace

Part read_gerber(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  Part part;
  part.name = std::filesystem::path(file_name).stem().string();
  part.source_file = file_name;
  RepairOptions repair;
  repair.tol = options.tol;
  repair.where = file_name;
  GerberImage image = gerber_image(text, file_name, repair);
  scale(image.drawn, options.scale);
  DrawnGroup group = group_of(image.function, file_name, options);
  if (!group.says_role && options.ask_if_unclear && !options.overview) {
    throw InputError(file_name,
                     "nothing says what this layer is for (no attribute FileFunction, no usual name): say "
                     "--op isolate:'*' for copper, "
                     "profile:'*' for the board's outline, pocket:'*' to mill what is drawn");
  }
  const bool follows = group.role == LayerRole::kProfile || group.role == LayerRole::kInside ||
                       group.role == LayerRole::kEngrave;
  group.curves = follows ? lines_of(std::move(image.drawn)) : areas_of(image.drawn, repair);
  if (!image.function.empty())
    part.diagnostics.note(file_name,
                          "the layer is " + printable(image.function) + ", read as " + name_of(group.role));
  if (is_bottom(image.function, file_name) && !options.mirror) {
    part.diagnostics.warn(file_name,
                          "this is the bottom of the board, drawn as seen from the top; --mirror gives it as "
                          "seen from below, as it lies when the board is turned over");
  }
  std::vector<DrawnGroup> groups{std::move(group)};
  question_size(groups, file_name, options);
  add_drawn_features(part, std::move(groups), options);
  return part;
}

}  // namespace clearcut::read
