#include "post/blocks.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/text.h"
#include "base/units.h"
#include "post/words/comment.h"

namespace clearcut::post {
namespace {

constexpr int kNumberStep = 10;
constexpr int kGreatestNumber = 99990;  // controls read five digits; then they begin again
constexpr std::size_t kLongestNumber = std::string_view("N99990 ").size();

}  // namespace

void BlockPrinter::word(std::string_view text) {
  if (!block_.empty()) block_ += ' ';
  block_ += text;
}

void BlockPrinter::word(char letter, long long ticks, const PrintGrid& grid) {
  if (!block_.empty()) block_ += ' ';
  block_ += letter;
  append_number(block_, ticks, grid.decimals(), dialect_.always_point);
}

std::size_t BlockPrinter::packed_size() const {
  return block_.size() - static_cast<std::size_t>(std::count(block_.begin(), block_.end(), ' '));
}

void BlockPrinter::end_block() {
  const std::size_t number = numbered_ || due_number_ > 0 ? kLongestNumber : 0;
  if (block_.size() + number > dialect_.line_length) std::erase(block_, ' ');
  line(block_);
  block_.clear();
}

void BlockPrinter::line(std::string_view text) {
  // Comments, the tape's ends and the program's number have their own lines.
  const bool is_block =
      !text.empty() && std::string_view("(;%O").find(text.front()) == std::string_view::npos;
  if (numbered_ && is_block) out_ += 'N' + std::to_string(next_number()) + ' ';
  if (!numbered_ && is_block && due_number_ > 0) out_ += 'N' + std::to_string(due_number_) + ' ';
  if (is_block) due_number_ = 0;
  out_ += text;
  out_ += '\n';
}

int BlockPrinter::next_number() {
  number_ = number_ == kGreatestNumber ? kNumberStep : number_ + kNumberStep;
  return number_;
}

void BlockPrinter::title(const std::string& number, std::string_view name) {
  const std::string both = number + " (" + plain_comment(name) + ")";
  if (!number.empty() && !name.empty() && both.size() <= dialect_.line_length) return line(both);
  if (!number.empty()) line(number);
  if (!name.empty()) comment(name);
}

void BlockPrinter::comment(std::string_view text) {
  for (const std::string& piece : comment_pieces(text, dialect_.line_length - 2))
    line(dialect_.comments == CommentForm::kParentheses ? "(" + piece + ")" : "; " + piece);
}

namespace {

/// Rotation words as the cycles count them.
constexpr int kClockwiseTurn = 3, kCounterClockwiseTurn = 4;
/// CYCLE840 without an encoder: the feed is given by the F word.
constexpr const char* kByFeed = "1";
/// CYCLE83 with a retract out of the hole after each peck.
constexpr const char* kClearsChips = "1";

/// "CYCLE81(1,,2)": absent parameters are empty, and those at the end are left out.
std::string call_text(const std::string& name, std::vector<std::string> values) {
  while (!values.empty() && values.back().empty()) values.pop_back();
  std::string text = "MCALL " + name + "(";
  for (std::size_t k = 0; k < values.size(); ++k) text += (k > 0 ? "," : "") + values[k];
  return text + ")";
}

std::string number_text(long long ticks, const PrintGrid& grid) {
  std::string text;
  append_number(text, ticks, grid.decimals(), false);
  return text;
}

}  // namespace

bool has_cycle(const DrillBlock& hole, double dwell_s) {
  return hole.form != DrillForm::kChips && (dwell_s == 0 || hole.form != DrillForm::kPecks);
}

std::string cycle_call(const CycleCall& call, const PrintGrid& grid, bool inch) {
  const DrillBlock& hole = call.hole;
  const auto length = [&](long long ticks) { return number_text(ticks, grid); };
  const std::string dwell = call.dwell_s > 0 ? trimmed(call.dwell_s, 2) : "";
  // The plane at which feeding begins is the reference plane; nothing is added to it.
  const std::vector<std::string> heights{length(hole.above), length(hole.clear), "0", length(hole.bottom.z),
                                         ""};
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> all = heights;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  if (call.tap) {
    const std::string turn = std::to_string(call.clockwise ? kClockwiseTurn : kCounterClockwiseTurn);
    const std::string back = std::to_string(call.clockwise ? kCounterClockwiseTurn : kClockwiseTurn);
    const double pitch = call.tap->pitch * (call.tap->left_hand ? -1 : 1) / (inch ? kMmPerInch : 1);
    const std::string pitch_text = trimmed(pitch, 6), speed = std::to_string(call.spindle_rpm);
    if (call.tap->floating) return call_text("CYCLE840", with({dwell, back, turn, kByFeed}));
    return call_text("CYCLE84", with({dwell, turn, "", pitch_text, "0", speed, speed}));
  }
  switch (hole.form) {
    case DrillForm::kPecks:
      // First depth, no degression, chips cleared; the least peck is the peck, and feeding begins again kPeckGap
      // above the last.
      return call_text("CYCLE83", with({length(hole.clear - hole.peck), "", "0", "", "", "1", kClearsChips,
                                        "", length(hole.peck), "", "", length(grid.ticks(kPeckGap))}));
    case DrillForm::kFeedsOut: {
      const std::string feed = trimmed(hole.feed.mm_per_min() / (inch ? kMmPerInch : 1), inch ? 3 : 2);
      return call_text("CYCLE85", with({dwell, feed, feed}));
    }
    default:
      return dwell.empty() ? call_text("CYCLE81", heights) : call_text("CYCLE82", with({dwell}));
  }
}

}  // namespace clearcut::post
