#include "read/gcode/laying.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/error.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {
namespace {

constexpr std::array kTakenG{0, 10, 170, 210, 900, 940};
constexpr std::array kTakenM{20, 30, 40, 50, 300, 830};
constexpr std::string_view kTakenLetters = "EFNSXYZ";

template <typename Codes>
bool has(const Codes& codes, int code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

class LayingReader {
 public:
  LayingReader(std::string_view text, const std::string& file_name) : blocks_(text, file_name) {}

  LayingProgram read() {
    Block block;
    while (blocks_.next(block)) {
      place_ = blocks_.place(block.line);
      refuse_others(block);
      take_modes(block);
      if (block.has_axis() || block.has('E')) take_move(block);
    }
    if (lays_by_power_) program_.word = LayingWord::kPower;
    return std::move(program_);
  }

 private:
  void refuse_others(const Block& block) const {
    for (const int code : block.g)
      if (!has(kTakenG, code)) throw InputError(place_, g_word(code) + " is no word of a layer that is laid");
    for (const int code : block.m)
      if (!has(kTakenM, code))
        throw InputError(place_, "M" + std::to_string(code / 10) + " is no word of a layer that is laid");
    for (char letter = 'A'; letter <= 'Z'; ++letter)
      if (block.has(letter) && kTakenLetters.find(letter) == std::string_view::npos)
        throw InputError(place_, std::string(1, letter) + " is no word of a layer that is laid");
  }

  void take_modes(const Block& block) {
    for (const int code : block.g)
      if (code == 0 || code == 10) motion_ = code;
    for (const int code : block.m) {
      if (code == 30 || code == 40) beam_ = true;
      if (code == 50) beam_ = false;
    }
    if (block.has('S')) power_ = block.value('S');
    if (block.has('F')) feed_ = MmPerMin::of(block.value('F'));
  }

  void take_move(const Block& block) {
    if (!motion_) throw InputError(place_, "a place without G0 or G1 before it");
    const Vec2 from = at_;
    const bool is_first = !known_;
    if (block.has('X')) at_.x = block.value('X');
    if (block.has('Y')) at_.y = block.value('Y');
    const double z_before = z_;
    if (block.has('Z')) z_ = block.value('Z');
    known_ = known_ || (block.has('X') && block.has('Y'));
    const bool cuts = *motion_ == 10;
    const double fed = block.has('E') ? block.value('E') : 0;
    if (beam_ && block.has('E'))
      throw InputError(place_, "E with the beam on: an extruder or a laser, not both");
    const bool by_power = cuts && beam_ && power_ > 0;
    const bool lays = by_power || (cuts && fed > 0);
    lays_by_power_ = lays_by_power_ || by_power;
    if (is_first && (lays || block.has('E')))
      throw InputError(place_, "lays before any place is known; begin with G0 X Y");
    if (lays && z_ != z_before) throw InputError(place_, "a move that lays changes its height");
    if (lays && from == at_) throw InputError(place_, "lays without a move");
    if (is_first || from == at_) return;
    program_.moves.push_back(
        {Edge::line(from, at_), z_, feed_, lays, lays ? (by_power ? power_ : fed) : 0, block.line});
  }

  BlockReader blocks_;
  LayingProgram program_;
  std::string place_;
  std::optional<int> motion_;
  Vec2 at_;
  double z_ = 0;
  double power_ = 0;
  MmPerMin feed_;
  bool known_ = false, beam_ = false, lays_by_power_ = false;
};

}  // namespace

LayingProgram read_laying(std::string_view text, const std::string& file_name) {
  return LayingReader(text, file_name).read();
}

}  // namespace clearcut::read::gcode
