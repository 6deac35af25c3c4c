#include "read/gcode/control/osp_words.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/tolerances.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {
namespace {

/// G words in tenths.
constexpr int kDwell = 40, kEndOfTurn = 100, kOffset = 150, kOneOffset = 160, kNoLength = 530, kLength = 560,
              kReturnLevel = 710, kEndOfCycle = 800;
/// What these stand for in words that are shared.
constexpr int kSharedLength = 430, kSharedNoLength = 490, kMachineFrame = 530;
constexpr int kLastOffset = 200;

/// What is not read of OSP, and what to do instead.
struct Refused {
  int code;  ///< G word in tenths
  const char* why;
};
constexpr Refused kRefused[] = {
    {410, "compensates for the cutter by rules that are not read; post the path of the tool's centre"},
    {420, "compensates for the cutter by rules that are not read; post the path of the tool's centre"},
    {540, "is a length of the tool along X, which is not read; give work offsets by G15 H"},
    {550, "is a length of the tool along Y, which is not read; give work offsets by G15 H"},
    {570, "is a length of the tool along a fourth axis, which is not read; give work offsets by G15 H"},
    {580, "is a length of the tool along a fifth axis, which is not read; give work offsets by G15 H"},
    {590, "is a length of the tool along a sixth axis, which is not read; give work offsets by G15 H"},
    {430, "is no word of OSP; give the length by G56 H"},
    {490, "is no word of OSP; end the length by G53"},
    {730, "breaks chips by its I and J, which is not read; post the moves"},
    {760, "bores with a bar that goes aside, which is not read; post the moves"},
    {870, "bores from below, which is not read; post the moves"},
    {880, "is a cycle whose moves are not known here; post the moves"}};

class OspBlock {
 public:
  OspBlock(const Block& block, Control& control) : block_(block), control_(control) {}

  Block shared() {
    for (const Refused& one : kRefused)
      if (has_g(block_, one.code)) control_.refuse(g_word(one.code) + " " + one.why);
    note_spindle();
    set_offset();
    set_length();
    if (has_g(block_, kDwell)) dwell();
    if (has_g(block_, kReturnLevel)) set_return_level();
    if (take_g(kEndOfTurn) && (block_.has_axis() || block_.has('L') || block_.has('P')))
      control_.refuse("G10 ends G11 on OSP and has no words of its own; post the program without them");
    set_cycle();
    return block_;
  }

 private:
  bool take_g(int code) { return std::erase(block_.g, code) > 0; }
  bool take_m(int code) { return std::erase(block_.m, code) > 0; }
  bool says_m(std::initializer_list<int> codes) const {
    return std::any_of(codes.begin(), codes.end(), [&](int code) {
      return std::find(block_.m.begin(), block_.m.end(), code) != block_.m.end();
    });
  }

  /// Some posts leave G80 out where the spindle is to turn on, since it stops it.
  void note_spindle() {
    if (says_m({30, 40, 50, 60}))
      control_.spindle_may_stand = false;
    else if (has_g(block_, kEndOfCycle) && control_.modes.spindle != 5)
      control_.spindle_may_stand = true;
  }

  /// The number in H.
  int number_of(const char* word, int most) {
    if (!block_.has('H')) control_.refuse(std::string(word) + " without its H word; give its number");
    const double number = block_.value('H');
    if (number != std::floor(number) || number < 0 || number > most)
      control_.refuse(std::string(word) + " H" + trimmed(number, 3) + ": OSP has H0 to H" +
                      std::to_string(most) + "; correct it");
    block_.unset('H');
    return static_cast<int>(number);
  }

  void set_offset() {
    const bool once = has_g(block_, kOneOffset), stays = has_g(block_, kOffset);
    if (!once && !stays) return;
    if (has_g(block_, kLength) || (once && stays))
      control_.refuse("G15, G16 and G56 share the H word of their block; split it");
    const int number = number_of(stays ? "G15" : "G16", kLastOffset);
    if (once) return use_once(number);
    take_g(kOffset);
    if (number == 0)
      control_.refuse("G15 H0 is the machine's own frame, which is not read; give a work offset, G15 H1");
    control_.frame.use_system(number == 1 ? 1 : Frame::kElsewhere);
    if (number == 1) return;
    const std::string text = std::to_string(number);
    control_.condition("g15-h" + text, "G15 H" + text + " has its origin where the work's is");
  }

  /// G16 H0: the block's places are the machine's.
  void use_once(int number) {
    if (number != 0) control_.refuse("G16 with a work offset for one block is not read; give it by G15 H");
    if (has_g(block_, kNoLength)) control_.refuse("G53 beside G16 is not read; split the block");
    std::replace(block_.g.begin(), block_.g.end(), kOneOffset, kMachineFrame);
    is_in_machine_ = true;
  }

  void set_length() {
    if (!is_in_machine_) std::replace(block_.g.begin(), block_.g.end(), kNoLength, kSharedNoLength);
    if (!has_g(block_, kLength)) return;
    if (!block_.has('H')) control_.refuse("G56 without its H word; give the number of the length");
    std::replace(block_.g.begin(), block_.g.end(), kLength, kSharedLength);
  }

  void dwell() {
    if (!block_.has('F') || block_.has('P'))
      control_.refuse("G4 of OSP is read with its time in F alone, in seconds; post G4 F");
    if (block_.is_whole('F') && block_.value('F') != 0)
      control_.condition("decimal-point", "F of G4 has no decimal point; the control takes it as seconds");
    block_.set('P', block_.value('F'));
    block_.unset('F');
  }

  void set_return_level() {
    if (!block_.has('Z') || block_.has('X') || block_.has('Y') || has_g(block_, 910) ||
        !control_.modes.absolute)
      control_.refuse("G71 is read with Z alone, in G90; split its block");
    control_.return_level = control_.mm(block_.value('Z'));
    take_g(kReturnLevel);
    block_.unset('Z');
  }

  /// Cycles come back to the level of G71, at which the tool has to stand before the first of them.
  void set_cycle() {
    if (says_m({520, 540}))
      control_.refuse(
          "M52 and M54 choose heights to which cycles return that are not read; post M53 with G71");
    const bool returns = take_m(530);
    const int said = motion_in(block_);
    if (said < 0 || !control_.is_cycle(said)) return;
    const bool goes_on = control_.cycle.code == said;
    if (!returns && !goes_on)
      control_.refuse(g_word(said) +
                      " without M53 returns to a height that it does not state; post M53 with G71");
    if (!control_.return_level)
      control_.refuse(g_word(said) +
                      " with M53 before any G71; give the height to which it returns by G71 Z");
    const double stands = control_.builder.known(2, control_.line) - control_.frame.shift(2);
    if (control_.cycle.code == 0 && std::abs(stands - *control_.return_level) > kSamePlaceMm)
      control_.refuse(g_word(said) +
                      " begins elsewhere than at the height of its G71, which is not read; go there before");
    control_.modes.return_to_level = control_.return_said = true;
    if (!block_.has('P')) return;
    control_.condition("cycle-dwell", "P of drilling cycles counts in milliseconds, as the control is set");
    block_.set('P', block_.value('P') / 1000);
  }

  Block block_;
  Control& control_;
  bool is_in_machine_ = false;
};

}  // namespace

Block without_osp_words(const Block& block, Control& control) {
  return OspBlock(block, control).shared();
}

}  // namespace clearcut::read::gcode
