// Parameters as in Siemens' "Programming Manual, Cycles": RTP return plane, RFP reference plane, SDIS safety distance above it, DP
// depth (absolute), DPR depth below RFP, DTB dwell at the bottom.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "base/units.h"
#include "read/gcode/motion/cycle.h"
#include "read/gcode/sinumerik/words.h"

namespace clearcut::read::gcode {
namespace {

constexpr double kMostPecks = 10000;
/// Places of parameters, from 0.
constexpr std::size_t kRtp = 0, kRfp = 1, kSdis = 2, kDp = 3, kDpr = 4, kDtb = 5;
/// mm. CYCLE83 lifts by this to break a chip where no distance is stated.
constexpr double kChipLift = 1;
/// CYCLE83 begins to feed so far above the last depth where no distance is stated: mm, up to a depth of 30 mm; a fiftieth of deeper
/// ones, and no more than 7 mm.
constexpr double kLeastGap = 0.6, kShallow = 30, kGapShare = 50, kMostGap = 7;
/// Coarse pitches of M threads, mm, for which MPIT stands.
struct CoarsePitch {
  double size, pitch;
};
constexpr CoarsePitch kCoarse[] = {{3, 0.5},   {4, 0.7},  {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5},
                                   {12, 1.75}, {14, 2},   {16, 2},   {18, 2.5}, {20, 2.5}, {22, 2.5},
                                   {24, 3},    {27, 3},   {30, 3.5}, {33, 3.5}, {36, 4},   {39, 4},
                                   {42, 4.5},  {45, 4.5}, {48, 5}};

enum class HoleForm : unsigned char { kDrill, kPecks, kRigidTap, kTap, kFeedsOut };

struct HoleRow {
  std::string_view name;
  HoleForm form;
  std::size_t parameters;  ///< that are read; three mode words may follow
};
constexpr HoleRow kHoleRows[] = {{"CYCLE81", HoleForm::kDrill, 5},   {"CYCLE82", HoleForm::kDrill, 6},
                                 {"CYCLE83", HoleForm::kPecks, 17},  {"CYCLE84", HoleForm::kRigidTap, 12},
                                 {"CYCLE840", HoleForm::kTap, 11},   {"CYCLE85", HoleForm::kFeedsOut, 8},
                                 {"CYCLE89", HoleForm::kFeedsOut, 6}};

const HoleRow* hole_row(const std::string& name) {
  const auto* const found = std::find_if(std::begin(kHoleRows), std::end(kHoleRows),
                                         [&](const HoleRow& row) { return row.name == name; });
  return found == std::end(kHoleRows) ? nullptr : found;
}

class HoleMaker {
 public:
  HoleMaker(Control& control, const SinumerikWord& call)
      : control_(control), call_(call), row_(*hole_row(call.name)) {
    read_heights();
    read_modes();
    if (row_.form == HoleForm::kPecks) read_pecks();
    if (is_tap()) read_tap();
  }

  void make() {
    control_.before_feed();
    control_.moved = true;
    for (const std::size_t axis : {0U, 1U, 2U}) control_.builder.known(axis, control_.line);
    rapid(start_);
    switch (row_.form) {
      case HoleForm::kPecks:
        peck();
        break;
      case HoleForm::kRigidTap:
      case HoleForm::kTap:
        tap();
        break;
      default:
        feed(bottom_, feed_in());
        dwell(value(kDtb));
        if (row_.form == HoleForm::kFeedsOut) feed(start_, feed_out());
    }
    rapid(above_);
  }

 private:
  bool is_tap() const { return row_.form == HoleForm::kRigidTap || row_.form == HoleForm::kTap; }
  bool has(std::size_t place) const {
    return place < call_.arguments.size() && !call_.arguments[place].empty();
  }

  /// 0 where nothing is said.
  double value(std::size_t place) const {
    if (!has(place)) return 0;
    std::string_view text = call_.arguments[place];
    if (text[0] == '+') text.remove_prefix(1);
    double number = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
    if (error != std::errc{} || end != text.data() + text.size())
      refuse("has '" + call_.arguments[place] + "' for its parameter " + std::to_string(place + 1) +
             "; post the program with plain numbers");
    if (!(std::abs(number) <= 1e6)) refuse("has a number no machine takes; correct it");
    return number;
  }
  double length(std::size_t place) const { return control_.mm(value(place)); }

  void read_heights() {
    if (!has(kRtp) || !has(kRfp)) refuse("needs RTP and RFP, its first two parameters; add them");
    if (control_.modes.plane != Plane::kXY) refuse("outside the XY plane is not read; use G17");
    const double shift = control_.frame.shift(2), reference = length(kRfp);
    if (value(kSdis) < 0) refuse("has a safety distance SDIS below 0; correct it");
    const bool says_both = has(kDp) && value(kDpr) != 0;
    const double below = reference - length(kDpr), absolute = length(kDp);
    if (!has(kDp) && value(kDpr) == 0) refuse("states no depth; give DP");
    if (says_both && std::abs(below - absolute) > 1e-6)
      refuse("states two depths, DP and DPR, that differ; give one of them");
    bottom_ = (has(kDp) ? absolute : below) + shift;
    reference_ = reference + shift;
    start_ = reference_ + length(kSdis);
    above_ = length(kRtp) + shift;
    if (bottom_ > reference_) refuse("goes up to its depth; correct DP");
    if (above_ < start_) refuse("has its return plane RTP below RFP and SDIS; correct it");
  }

  /// _GMODE, _DMODE and _AMODE, the last three of a long call. The units of _AMODE say how DP counts.
  void read_modes() {
    const std::size_t count = call_.arguments.size();
    if (count <= row_.parameters) return;
    const std::size_t first = count >= row_.parameters + 3 ? count - 3 : row_.parameters;
    for (std::size_t place = row_.parameters; place < first; ++place)
      if (value(place) != 0 && !(is_tap() && place == row_.parameters && value(place) == 3))
        refuse("has parameter " + std::to_string(place + 1) + ", which is not read; post without it");
    if (value(first) != 0)
      refuse("counts its depth to the shank or by a diameter (_GMODE); post it to the tip");
    if (value(first + 1) != 0 && value(first + 1) != 1) refuse("is for another plane (_DMODE); use G17");
    if (static_cast<long long>(std::abs(value(first + 2))) % 10 == 1)
      refuse("counts its depth from RFP (_AMODE); give DP as a height");
  }

  void read_pecks() {
    const std::size_t fdep = 5, fdpr = 6;
    if (!has(fdep) && value(fdpr) == 0) refuse("states no first depth; give FDEP or FDPR");
    first_ = has(fdep) ? length(fdep) + control_.frame.shift(2) : reference_ - length(fdpr);
    if (!(reference_ - first_ > 0)) refuse("has its first depth above RFP; correct FDEP");
    for (const std::size_t place : {std::size_t{14}, std::size_t{16}})
      if (value(place) < 0) refuse("has a distance below 0; correct _VRT or _DIS1");
    if (has(12) && value(12) != 0 && value(12) != 3) refuse("drills along X or Y (_AXN); use Z");
  }

  /// Depths of the pecks, from the first to the bottom. The last two are of one size where pecks become smaller by a stated amount.
  std::vector<double> depths() const {
    const double less = value(7), least = length(13);
    double stroke = reference_ - first_, at = std::max(first_, bottom_);
    std::vector<double> found{at};
    while (at > bottom_) {
      const double rest = at - bottom_, by = control_.mm(less);
      if (less < 0) stroke = std::max(stroke * std::min(-less, 1.0), std::max(least, 1e-6));
      if (less > 0) {
        stroke = std::max(stroke - by, by);
        if (stroke <= by && rest <= 2 * by) stroke = found.size() > 1 && rest > by ? rest / 2 : rest;
      }
      if (!(stroke > 0) || rest / stroke > kMostPecks || static_cast<double>(found.size()) > kMostPecks)
        refuse("makes too many pecks; correct FDEP or _DAM");
      at = std::max(bottom_, at - stroke);
      found.push_back(at);
    }
    return found;
  }

  void peck() {
    const double at_bottom = has(15) && value(15) != 0 ? value(15) : value(kDtb);
    const double slower = has(10) && value(10) > 0 ? std::min(value(10), 1.0) : 1;
    const bool clears = value(11) == 1;
    const std::vector<double> all = depths();
    for (std::size_t k = 0; k < all.size(); ++k) {
      const MmPerMin in = k == 0 ? MmPerMin::of(feed_in().mm_per_min() * slower) : feed_in();
      feed(all[k], in);
      if (k + 1 == all.size()) break;
      dwell(value(kDtb));
      if (clears) {
        rapid(start_);
        dwell(value(9));
        rapid(std::min(start_, all[k] + gap(reference_ - all[k])));
      } else {
        const double lift = length(14) > 0 ? length(14) : kChipLift;
        feed(std::min(start_, all[k] + lift), feed_in());
      }
    }
    dwell(at_bottom);
  }

  double gap(double deep) const {
    if (length(16) > 0) return length(16);
    return deep <= kShallow ? kLeastGap : std::min(deep / kGapShare, kMostGap);
  }

  void read_tap() {
    const bool rigid = row_.form == HoleForm::kRigidTap;
    const std::size_t size = rigid ? 7 : 9, pitch = rigid ? 8 : 10;
    pitch_ = length(pitch);
    if (pitch_ == 0 && value(size) != 0) {
      const double wanted = std::abs(value(size));
      const auto* const found =
          std::find_if(std::begin(kCoarse), std::end(kCoarse),
                       [&](const CoarsePitch& one) { return std::abs(one.size - wanted) < 1e-9; });
      if (found == std::end(kCoarse)) refuse("names a thread MPIT without a coarse pitch; give PIT");
      pitch_ = std::copysign(found->pitch, value(size));
    }
    const bool by_feed = !rigid && value(8) == 1;
    if (pitch_ == 0 && !by_feed) refuse("needs the pitch PIT; add it");
  }

  /// The control turns the spindle itself. With a compensating chuck and no encoder (ENC 1) the F word is the feed.
  void tap() {
    const bool rigid = row_.form == HoleForm::kRigidTap;
    const double spoken = control_.modes.speed;
    const double in = rigid && value(10) > 0 ? value(10) : spoken;
    const double out = rigid && value(11) > 0 ? value(11) : in;
    const bool by_feed = !rigid && value(8) == 1;
    const bool tied = rigid || value(8) == 0 || value(8) == 20;
    const auto speed_of = [&](double rpm) {
      return by_feed ? feed_in() : MmPerMin::of(std::abs(pitch_) * rpm);
    };
    const int before = control_.modes.spindle, turn_in = pitch_ != 0 ? (pitch_ < 0 ? 4 : 3) : before;
    turn(in, turn_in);
    feed(bottom_, speed_of(in));
    dwell(value(kDtb));
    TapCycle cycle{std::nullopt, tied, true};
    if (pitch_ != 0) cycle.left_hand = pitch_ < 0;
    // SDR states the turn on the way out; 0 reverses it. The same turn as on the way in pulls the tap out of its thread.
    const bool pulls = !rigid && value(6) != 0 && static_cast<int>(value(6)) == turn_in;
    if (!pulls) control_.builder.turn_tap_back(cycle, control_.line);
    if (out != in) turn(out, control_.modes.spindle);
    feed(start_, speed_of(out));
    const double after = value(rigid ? 6 : 7);
    turn(spoken, after == 3 || after == 4 || after == 5 ? static_cast<int>(after) : before);
  }

  void turn(double rpm, int m) {
    if (m != control_.modes.spindle) control_.turn_spindle(m);
    control_.builder.speed = rpm;
    control_.builder.drive.spindle_rpm = m == 5 ? 0 : rpm;
  }

  /// s; below 0 turns of the spindle.
  void dwell(double time) {
    if (time < 0 && control_.modes.speed > 0) time = -time * 60 / control_.modes.speed;
    if (time > 0) add_dwell_in_hole(control_.builder, control_.line, time);
  }

  MmPerMin feed_in() const {
    const bool own = call_.name == "CYCLE85" && value(6) > 0;
    return own ? MmPerMin::of(control_.mm(value(6))) : control_.feed_for(1, {});
  }
  MmPerMin feed_out() const {
    const bool own = call_.name == "CYCLE85" && value(7) > 0;
    return own ? MmPerMin::of(control_.mm(value(7))) : feed_in();
  }

  void feed(double z, MmPerMin speed) { control_.builder.feed(height(z), speed, control_.line); }
  void rapid(double z) { control_.builder.rapid(height(z), control_.line); }
  static Target height(double z) { return {std::nullopt, std::nullopt, z}; }
  [[noreturn]] void refuse(const std::string& what) const { control_.refuse(call_.name + " " + what); }

  Control& control_;
  const SinumerikWord& call_;
  const HoleRow& row_;
  double reference_ = 0, start_ = 0, bottom_ = 0, above_ = 0, first_ = 0;  // mm
  double pitch_ = 0;  // mm, below 0 for left-hand threads
};

}  // namespace

bool is_sinumerik_hole(const std::string& name) {
  return hole_row(name) != nullptr;
}

void check_sinumerik_hole(Control& control, const SinumerikWord& call) {
  HoleMaker(control, call);
}

void make_sinumerik_hole(Control& control, const SinumerikWord& call) {
  HoleMaker(control, call).make();
}

}  // namespace clearcut::read::gcode
