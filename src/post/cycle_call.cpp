#include "post/cycle_call.h"

#include <vector>

#include "base/inch.h"
#include "base/text/format.h"

namespace clearcut::post {
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
