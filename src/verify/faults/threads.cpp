// Symbols
//
//   P     pitch, mm; d major diameter, d1 = d - 5/8 sqrt(3) P minor diameter of the basic profile (ISO 68-1),
//         d3 = d - 17/24 sqrt(3) P at the root of external threads
//   z0    mm; height of the helix at the angle 0 about the axis; each turn adds P
#include "verify/faults/threads.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "base/elementary.h"
#include "base/text.h"
#include "verify/faults/faults.h"

namespace clearcut::verify {
namespace {

/// mm permitted deviation of the mill from the major radius; the finest tolerance of bolts is several times as large.
constexpr double kRadiusSlack = 0.01;
/// Permitted deviation from the helix: kPitchShare of the pitch plus kThreadHeightSlack mm, more than rounding.
constexpr double kPitchShare = 0.01;
constexpr double kThreadHeightSlack = 0.006;
/// Number of places checked on each move.
constexpr int kThreadPlaces = 48;
/// mm. Lines whose ends are as far from the axis as each other to within this are chords of a turn: rounding makes
/// less.
constexpr double kSameRadius = 0.003;
/// Radians. Runs of chords with a smaller turn do not determine a pitch.
constexpr double kLeastTurn = 0.1;

double whole_turns_off(double height, double pitch) {
  return height - pitch * std::round(height / pitch);
}

/// A run of moves about the axis: an arc, or chords one after the other.
struct AxisTurn {
  const CheckedMove* first = nullptr;
  Vec2 to;
  double z_to = 0;
  double sweep = 0;  ///< radians, counter-clockwise
};

class ThreadCheck {
 public:
  explicit ThreadCheck(const Feature& feature)
      : hole_(*feature.hole), top_(feature.top_z), pitch_(hole_.thread->pitch) {
    minor_radius_ = hole_.diameter / 2 - 5 * std::sqrt(3.0) / 16 * pitch_;
    slack_ = kPitchShare * pitch_ + kThreadHeightSlack;
  }

  std::vector<ThreadDefect> check(const std::vector<const CheckedMove*>& moves) {
    for (const AxisTurn& turn : turns_of(moves)) find_helix(turn);
    if (!origin_) return {nothing(moves)};
    for (const CheckedMove* checked : moves) sample_along(*checked);
    sample_at_heights();
    return std::move(defects_);
  }

 private:
  /// mm; distance of the teeth's outermost (in holes) or innermost (around bosses) reach from the axis.
  double reach(const CheckedMove& checked, Vec2 at) const {
    return distance(at, hole_.center) + (hole_.external ? -checked.radius() : checked.radius());
  }

  /// mm; the radius that the teeth must reach.
  double full_radius() const {
    return hole_.external ? root_diameter(*hole_.thread) / 2 : hole_.diameter / 2;
  }

  /// mm missing to the full thread for teeth at the given radius.
  double short_of_full(double reached) const {
    return hole_.external ? reached - full_radius() : full_radius() - reached;
  }

  /// Whether teeth at the given radius are in the material of the thread, and not only in its range of tolerance.
  bool is_in_thread(double reached) const {
    if (hole_.external) return reached < hole_.diameter / 2 - crest_tolerance(*hole_.thread);
    return reached > minor_radius_ + minor_tolerance(*hole_.thread);
  }

  bool is_about_axis(const Move& move) const {
    return move.path.is_arc() && distance(move.path.center, hole_.center) <= kRadiusSlack;
  }

  /// The angle about the axis of a line forming a chord of a turn, radians; 0 for other lines.
  double chord_about_axis(const Move& move) const {
    const Vec2 a = move.path.from - hole_.center, b = move.path.to - hole_.center;
    if (move.path.is_arc() || move.is_vertical() || std::abs(norm(a) - norm(b)) > kSameRadius) return 0;
    const double sweep = base::atan2(cross(a, b), dot(a, b));
    return norm(a) * (1 - base::cos(sweep / 2)) <= kRadiusSlack ? sweep : 0;
  }

  /// Successive chords form one turn: a single chord rises too little to determine the pitch.
  std::vector<AxisTurn> turns_of(const std::vector<const CheckedMove*>& moves) const {
    std::vector<AxisTurn> turns;
    bool goes_on = false;
    for (const CheckedMove* checked : moves) {
      if (!checked->feeds()) continue;
      const Move& move = *checked->move;
      const bool is_arc = is_about_axis(move);
      const double sweep = is_arc ? move.path.sweep() : chord_about_axis(move);
      const bool joins = goes_on && !is_arc && sweep * turns.back().sweep > 0 &&
                         distance(turns.back().to, move.path.from) <= kSameRadius &&
                         checked->tool == turns.back().first->tool;
      goes_on = sweep != 0 && !is_arc;
      if (sweep == 0) continue;
      if (!joins) turns.push_back({checked, {}, 0, 0});
      turns.back().to = move.path.to;
      turns.back().z_to = move.z_to;
      turns.back().sweep += sweep;
    }
    std::erase_if(turns, [](const AxisTurn& turn) {
      return !turn.first->move->path.is_arc() && std::abs(turn.sweep) < kLeastTurn;
    });
    return turns;
  }

  /// Takes z0 and the threaded heights from turns at the full radius, and checks their pitch.
  void find_helix(const AxisTurn& turn) {
    const CheckedMove& checked = *turn.first;
    const Move& move = *checked.move;
    const double short_of = short_of_full(reach(checked, move.path.from));
    if (short_of > kRadiusSlack) {
      narrowest_ = std::max(narrowest_, short_of);
      return;
    }
    const double rise = (turn.z_to - move.z_from) / (turn.sweep * sign()) * 2 * kPi;
    if (!origin_) origin_ = on_helix(move.path.from, move.z_from);
    if (std::abs(rise - pitch_) > slack_) {
      add(ThreadDefect::Kind::kHelix, std::abs(rise - pitch_), move.line,
          rise < 0
              ? "turns the other way round its axis as it rises: the hand is wrong"
              : "rises " + trimmed(rise, 4) + " mm a turn where the pitch is " + trimmed(pitch_, 4) + " mm");
      return;
    }
    const Tool& tool = *checked.tool;
    const double rows =
        tool.pitch > 0 && tool.flute_length ? std::floor(*tool.flute_length / tool.pitch + 1e-9) : 1;
    cut_.push_back(
        {std::min(move.z_from, turn.z_to), std::max(move.z_from, turn.z_to) + (rows - 1) * pitch_});
  }

  double sign() const { return hole_.thread->left_hand ? -1 : 1; }

  /// mm; z0 of the helix through p at the height z, give or take whole pitches.
  double on_helix(Vec2 p, double z) const {
    return z - sign() * pitch_ * angle_of(p - hole_.center) / (2 * kPi);
  }

  /// Adds a defect if the mill reaches into the wall at a place off the helix.
  void sample_along(const CheckedMove& checked) {
    const Move& move = *checked.move;
    for (int i = 0; i <= kThreadPlaces; ++i) {
      const double t = static_cast<double>(i) / kThreadPlaces;
      const Vec2 p = move.is_vertical() ? move.path.from : move.path.at(t);
      const double z = move.z_from + (move.z_to - move.z_from) * t;
      if (z >= top_ || !is_in_thread(reach(checked, p))) continue;
      const double off = std::abs(whole_turns_off(on_helix(p, z) - *origin_, pitch_));
      if (off <= slack_) continue;
      return add(ThreadDefect::Kind::kHelix, off, move.line,
                 (checked.feeds() ? "is cut " : "is cut at the rapid ") + trimmed(off, 3) +
                     " mm beside its helix, at z " + trimmed(z, 3));
    }
  }

  /// Adds a defect if the turns, one above the other, have a gap or do not reach from full_z to the top.
  void sample_at_heights() {
    std::sort(cut_.begin(), cut_.end());
    double low = hole_.full_z;
    for (const auto& [from, to] : cut_) {
      if (from <= low + kThreadHeightSlack) low = std::max(low, to);
    }
    const bool begins_low = !cut_.empty() && cut_.front().first <= hole_.full_z + kThreadHeightSlack;
    if (!begins_low) {
      const double lowest = cut_.empty() ? top_ : cut_.front().first;
      return add(
          ThreadDefect::Kind::kShallow, lowest - hole_.full_z, 0,
          "is full down to z " + trimmed(lowest, 3) + " only, and shall be to z " + trimmed(hole_.full_z, 3));
    }
    // Where the last groove ends below the top, nothing can be screwed in there.
    if (low < top_ - kThreadHeightSlack)
      add(ThreadDefect::Kind::kShallow, top_ - low, 0, "is not cut above z " + trimmed(low, 3));
  }

  ThreadDefect nothing(const std::vector<const CheckedMove*>& moves) const {
    if (narrowest_ > 0)
      return {ThreadDefect::Kind::kNarrow, narrowest_,
              "the mill stays " + trimmed(narrowest_, 3) + " mm short of its diameter of " +
                  trimmed(2 * full_radius(), 3) + " mm",
              moves.front()->move->line};
    return {ThreadDefect::Kind::kNothing, top_ - hole_.full_z, "no thread mill turns about its axis", 0};
  }

  void add(ThreadDefect::Kind kind, double size, int line, const std::string& text) {
    const bool known = std::any_of(defects_.begin(), defects_.end(),
                                   [&](const ThreadDefect& one) { return one.kind == kind; });
    if (!known) defects_.push_back({kind, size, text, line});
  }

  const HoleForm& hole_;
  double top_;
  double pitch_, minor_radius_ = 0, slack_ = 0;
  double narrowest_ = 0;
  std::optional<double> origin_;
  std::vector<std::pair<double, double>> cut_;  ///< mm; range of heights threaded by each turn
  std::vector<ThreadDefect> defects_;
};

}  // namespace

std::vector<ThreadDefect> defects_of_thread(const Feature& feature,
                                            const std::vector<const CheckedMove*>& moves) {
  return ThreadCheck(feature).check(moves);
}

namespace {

/// Permitted relative difference of a tap's feed from its pitch times the speed.
constexpr double kTapFeedShare = 0.005;
/// mm; rounding of heights.
constexpr double kTapHeight = 1e-3;

/// The cycles with reversal of taps, by the move at whose end the reversal is.
std::map<const CheckedMove*, TapCycle> tap_cycles(const CheckedProgram& program,
                                                  const VerifyOptions& options) {
  std::map<const CheckedMove*, TapCycle> cycles;
  if (!options.control) return cycles;
  const auto own = std::find_if(program.moves.begin(), program.moves.end(),
                                [](const CheckedMove& checked) { return !checked.earlier; });
  for (const ControlEvent& event : options.control->events) {
    const auto index = static_cast<std::ptrdiff_t>(event.before_move);
    if (event.kind == ControlEventKind::kTapTurnsBack && index > 0 && index <= program.moves.end() - own)
      cycles[&own[index - 1]] = event.tap;
  }
  return cycles;
}

bool is_tap_move(const CheckedMove& checked) {
  return !checked.earlier && checked.tool && checked.tool->kind == ToolKind::kTap && checked.feeds() &&
         checked.move->is_vertical();
}

bool goes_in(const CheckedMove& checked) {
  return checked.move->z_to < checked.move->z_from;
}

const char* way_of(SpindleState spindle) {
  return spindle == SpindleState::kClockwise          ? "clockwise"
         : spindle == SpindleState::kCounterClockwise ? "counter-clockwise"
                                                      : "not at all";
}

class TapCheck {
 public:
  TapCheck(const Part& part, const CheckedProgram& program, const VerifyOptions& options)
      : part_(part),
        program_(program),
        cycles_(tap_cycles(program, options)),
        has_control_(options.control) {}

  std::optional<Fault> feed(const CheckedMove& checked) const {
    if (!is_asked(checked)) return std::nullopt;
    const double rpm = checked.control ? checked.control->spindle_rpm : checked.rpm;
    const double wanted = checked.tool->pitch * rpm, feed = checked.move->feed.mm_per_min();
    if (std::abs(feed - wanted) <= kTapFeedShare * wanted) return std::nullopt;
    return fault(checked, std::abs(feed - wanted) / std::max(1.0, rpm),
                 "the tap feeds " + trimmed(feed, 2) + " mm/min where its pitch of " +
                     trimmed(checked.tool->pitch, 4) + " mm at " + trimmed(rpm, 0) + " rpm asks for " +
                     trimmed(wanted, 2));
  }

  std::optional<Fault> turn(const CheckedMove& checked) const {
    if (!is_asked(checked) || !checked.control) return std::nullopt;
    return goes_in(checked) ? turn_in(checked) : turn_out(checked);
  }

  std::optional<Fault> way_out(const CheckedMove& checked) const {
    if (!is_asked(checked) || !goes_in(checked)) return std::nullopt;
    const double top = std::min(checked.move->z_from, top_at(checked));
    // A cycle that breaks chips goes back and down again before the tap is out.
    const bool breaks_chips = cycles_.count(&checked) > 0;
    for (const CheckedMove* next = &checked + 1; next <= &program_.moves.back(); ++next) {
      if (!next->feeds() || !next->move->is_vertical()) break;
      if (next->move->z_to >= top - kTapHeight) return std::nullopt;
      if (!breaks_chips) break;
    }
    return fault(checked, 0, "the tap does not come out at its feed right after it went in");
  }

 private:
  bool is_asked(const CheckedMove& checked) const {
    return is_tap_move(checked) && checked.low_z() < top_at(checked);
  }

  /// mm; top of the feature being tapped.
  double top_at(const CheckedMove& checked) const {
    const auto step = static_cast<std::size_t>(checked.workingstep);
    return checked.workingstep < 0 ? part_.top_z() : feature_of(part_, part_.workplan[step]).top_z;
  }

  static SpindleState cutting_way(const Tool& tap) {
    return tap.left_hand ? SpindleState::kCounterClockwise : SpindleState::kClockwise;
  }

  std::optional<Fault> turn_in(const CheckedMove& checked) const {
    const SpindleState needed = cutting_way(*checked.tool), stated = checked.control->spindle;
    const auto cycle = cycles_.find(&checked);
    if (cycle == cycles_.end() || !cycle->second.left_hand)
      return stated == needed ? std::nullopt : wrong_way(checked);
    const bool cuts_left = *cycle->second.left_hand;
    if (cuts_left != checked.tool->left_hand)
      return fault(checked, 0,
                   std::string("the cycle is for ") + (cuts_left ? "left" : "right") + "-hand taps, and T" +
                       std::to_string(checked.tool_number) + " is a " + (cuts_left ? "right" : "left") +
                       "-hand one");
    const bool may_stand = cycle->second.turns_by_itself && stated == SpindleState::kOff;
    if (may_stand || stated == needed) return std::nullopt;
    return fault(checked, 0,
                 std::string("the spindle turns ") + way_of(stated) + " before a cycle that asks for " +
                     way_of(needed) + ": the control stops, or the tap breaks");
  }

  std::optional<Fault> turn_out(const CheckedMove& checked) const {
    const bool by_cycle = &checked != program_.moves.data() && cycles_.count(&checked - 1) > 0;
    const SpindleState spindle = checked.control->spindle, in = cutting_way(*checked.tool);
    if (!has_control_ || by_cycle || (spindle != in && spindle != SpindleState::kOff)) return std::nullopt;
    return fault(checked, 0, "the tap comes out while the spindle still turns as on its way in");
  }

  std::optional<Fault> wrong_way(const CheckedMove& checked) const {
    return fault(checked, 0, "the spindle does not turn the way that this tap cuts");
  }

  Fault fault(const CheckedMove& checked, double size, const std::string& what) const {
    return fault_of(part_, FaultKind::kTapping, checked,
                    {checked.move->path.to, checked.move->z_to, checked.move->line}, size, what);
  }

  const Part& part_;
  const CheckedProgram& program_;
  std::map<const CheckedMove*, TapCycle> cycles_;
  bool has_control_;
};

}  // namespace

std::vector<MoveCheck> tapping_checks(const Part& part, const CheckedProgram& program,
                                      const VerifyOptions& options) {
  const auto check = std::make_shared<const TapCheck>(part, program, options);
  return {[check](const CheckedMove& one) { return check->feed(one); },
          [check](const CheckedMove& one) { return check->turn(one); },
          [check](const CheckedMove& one) { return check->way_out(one); }};
}

std::vector<Condition> conditions_of_taps(const CheckedProgram& program, const VerifyOptions& options) {
  if (!options.control) return {};
  const std::map<const CheckedMove*, TapCycle> cycles = tap_cycles(program, options);
  for (const CheckedMove& checked : program.moves) {
    if (!is_tap_move(checked) || !goes_in(checked) || checked.tool->floating || !checked.cuts()) continue;
    const auto cycle = cycles.find(&checked);
    if (cycle != cycles.end() && cycle->second.is_tied) continue;
    return {{"rigid-tap",
             "T" + std::to_string(checked.tool_number) +
                 " is a rigid tap, and nothing ties its feed to the spindle; its holder floats",
             checked.move->line}};
  }
  return {};
}

}  // namespace clearcut::verify
