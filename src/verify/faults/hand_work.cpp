#include "verify/faults/hand_work.h"

#include <algorithm>
#include <cstddef>

namespace clearcut::verify {
namespace {

bool has_length(const CheckedMove& checked) {
  if (!checked.control) return false;
  const LengthKind kind = checked.control->length.kind;
  return kind != LengthKind::kOff && kind != LengthKind::kUnstated;
}

}  // namespace

HandWork::HandWork(std::span<const CheckedMove> moves, const ControlTable* control,
                   const VerifyOptions& options)
    : moves_(moves),
      control_(control),
      needs_tool_length_(options.needs_tool_length),
      changes_tools_alone_(options.changes_tools_alone) {
  if (!control || control->spans.empty()) return;
  switches_spindle_ = !control->spindle_said;
  sets_speed_ = !control->speed_said;
  const auto cut =
      std::find_if(moves.begin(), moves.end(), [](const CheckedMove& checked) { return checked.works(); });
  if (cut != moves.end()) first_cut_ = &*cut;
  find_lengths();
  find_changes();
}

void HandWork::find_lengths() {
  const auto found = std::find_if(moves_.begin(), moves_.end(), has_length);
  if (found != moves_.end()) first_with_length_ = &*found;
  for (const ControlEvent& event : control_->events) {
    if (event.kind == ControlEventKind::kToolChange) changed_.insert(event.tool);
  }
}

/// Finds the first cut after each change that needs a length.
void HandWork::find_changes() {
  if (first_with_length_) return;
  touched_off_ = true;
  int tool = 0;
  for (const CheckedMove& checked : moves_) {
    if (!checked.works() || !checked.control || checked.tool_number == tool || !needs_length()) continue;
    touched_off_ = touched_off_ && (first_cuts_.empty() || somebody_comes_before(checked));
    first_cuts_.push_back(&checked);
    tool = checked.tool_number;
  }
}

/// Whether an operator is at the machine between the previous cut and this one: at a pause, or because tools are
/// changed by hand.
bool HandWork::somebody_comes_before(const CheckedMove& cut) const {
  if (!changes_tools_alone_) return true;
  const auto index = static_cast<std::size_t>(&cut - moves_.data());
  std::size_t before = index;
  while (before > 0 && !moves_[before - 1].works()) --before;
  return std::any_of(control_->events.begin(), control_->events.end(), [&](const ControlEvent& event) {
    return event.kind == ControlEventKind::kPause && event.before_move >= before &&
           event.before_move <= index;
  });
}

/// The lengths of tools loaded by a changer are not measured in the spindle; a single tool is measured before the
/// program, so that a missing length does not make the control cut at wrong heights.
bool HandWork::needs_length() const {
  return needs_tool_length_ ? !changed_.empty() : changed_.size() > 1;
}

bool HandWork::lacks_length(const CheckedMove& checked) const {
  if (first_with_length_ && &checked >= first_with_length_) return true;
  return needs_length() && !lengths_are_touched_off();
}

bool HandWork::lengths_are_touched_off() const {
  return !first_with_length_ && touched_off_;
}

std::string HandWork::tools() const {
  std::string text;
  for (const CheckedMove* cut : first_cuts_) {
    const std::string tool = "T" + std::to_string(cut->tool_number);
    if (text.find(tool + ",") == std::string::npos) text += tool + ", ";
  }
  return text.substr(0, text.size() - 2);
}

std::vector<Condition> HandWork::conditions() const {
  std::vector<Condition> all;
  if (!first_cut_) return all;
  const int line = first_cut_->move->line;
  if (switches_spindle_)
    all.push_back({"spindle-by-hand",
                   std::string("the program has no word for the spindle (M3, M4); it is switched on by hand "
                               "before the first cut, the way that the cutters turn") +
                       (sets_speed_ ? ", at a speed that is set by hand" : "") + ", and stays on",
                   line});
  else if (sets_speed_)
    all.push_back(
        {"speed-by-hand", "the program states no speed (S); it is set by hand at the spindle", line});
  if (first_cuts_.empty() || !lengths_are_touched_off()) return all;
  const int first = first_cuts_.front()->move->line;
  if (changed_.size() > 1)
    all.push_back({"tool-by-hand",
                   "the program uses no tool lengths (G43); " + tools() +
                       " are each touched off at the work's zero by hand after they are put in",
                   first});
  else
    all.push_back({"tool-length-off",
                   "the program uses no tool length (G43); the work's zero was touched off with " + tools() +
                       " in the spindle and no length in force",
                   first});
  return all;
}

}  // namespace clearcut::verify
