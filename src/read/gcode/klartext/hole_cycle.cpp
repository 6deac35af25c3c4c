// Q200 set-up clearance over the surface Q203; Q201 depth below it, negative; Q202 peck; Q204 second clearance over the surface, to which the
// tool goes back; Q206 feed down, Q208 feed up; Q210, Q211 dwells at the top and at the bottom; Q212 by how much each peck is less than the
// one before, down to Q205; Q213 how often a chip is broken, by Q256, before the drill comes out; Q239 pitch, negative for left-hand threads;
// Q395 what the depth counts to. Of deep holes (205): Q257 depth after which a chip is broken, Q258 and Q259 how far above the last depth the
// drill goes on after the first and the last peck, Q379 how deep below the surface it begins, and Q253 the feed down to there.
// (TNC manuals, cycle programming.)
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "read/gcode/klartext/klartext.h"
#include "read/gcode/klartext/words.h"
#include "read/gcode/motion/cycle.h"

namespace clearcut::read::gcode {
namespace {

constexpr double kMostPecks = 10000;
/// mm/min; programs write this feed for FMAX, as long as the field takes no word.
constexpr double kFeedAsRapid = 99999;
/// mm; a hole of the tool's size is bored straight down.
constexpr double kSameRadius = 1e-6;

struct Form {
  int number;
  std::vector<int> needed, allowed;
};

const std::vector<Form>& forms() {
  static const std::vector<Form> all{
      {200, {200, 201, 202, 203, 204, 206}, {210, 211, 395}},
      {201, {200, 201, 203, 204, 206}, {208, 211}},
      {202, {200, 201, 203, 204, 206, 214}, {208, 211, 336}},
      {203, {200, 201, 202, 203, 204, 206}, {205, 208, 210, 211, 212, 213, 256, 395}},
      {205, {200, 201, 202, 203, 204, 206}, {205, 208, 211, 212, 253, 256, 257, 258, 259, 379, 395}},
      {206, {200, 201, 203, 204, 206}, {211}},
      {207, {200, 201, 203, 204, 239}, {}},
      {208, {200, 201, 203, 204, 206, 334, 335}, {342, 351}},
      {209, {200, 201, 203, 204, 239, 256, 257}, {336, 403}}};
  return all;
}

const Form* form_of(int number) {
  const auto found =
      std::find_if(forms().begin(), forms().end(), [&](const Form& one) { return one.number == number; });
  return found == forms().end() ? nullptr : &*found;
}

bool has(const std::vector<int>& numbers, int one) {
  return std::find(numbers.begin(), numbers.end(), one) != numbers.end();
}

class Maker {
 public:
  Maker(const HoleCycle& cycle, double unit, ToolpathBuilder& builder, int line)
      : cycle_(cycle), unit_(unit), builder_(builder), line_(line) {}

  void make() {
    check();
    builder_.rapid(height(clear_), line_);
    if (cycle_.number == 200 || cycle_.number == 203) {
      drill();
    } else if (cycle_.number == 205) {
      drill_deep();
    } else if (cycle_.number == 208) {
      mill();
    } else if (is_tap()) {
      tap();
    } else {
      bore();
    }
    builder_.rapid(height(above_), line_);
  }

 private:
  void check() {
    const Form& form = *form_of(cycle_.number);
    for (const int one : form.needed) {
      if (!cycle_.parameters.count(one)) refuse("lacks Q" + std::to_string(one) + "; add it");
    }
    for (const auto& [one, value] : cycle_.parameters) {
      if (!has(form.needed, one) && !has(form.allowed, one))
        refuse("has no parameter Q" + std::to_string(one) + " that is read; post its moves one by one");
    }
    if (value(395) != 0) refuse("counts its depth to the full diameter (Q395); post it to the tip");
    if (value(201) >= 0) refuse("goes down by a negative depth Q201; correct it");
    if (value(212) < 0 || value(205) < 0 || value(213) < 0 || value(256) < 0)
      refuse("has pecks below 0; correct it");
    if (value(212) > 0 && !(value(205) > 0))
      refuse("makes pecks smaller and smaller (Q212) without a least one (Q205); correct it");
    if (value(257) < 0 || value(258) < 0 || value(259) < 0 || value(379) < 0)
      refuse("has a distance below 0; correct Q257, Q258, Q259 or Q379");
    if (cycle_.number == 202 && value(214) != std::clamp(std::floor(value(214)), 0.0, 4.0))
      refuse("leaves the wall to no side that Q214 numbers, 0 to 4; correct it");
    if (value(200) < 0 || value(204) < 0) refuse("has a clearance below 0; correct Q200 or Q204");
    const double surface = value(203) * unit_;
    clear_ = surface + value(200) * unit_;
    above_ = std::max(clear_, surface + value(204) * unit_);
    bottom_ = surface + value(201) * unit_;
  }

  /// The pecks count from the surface; each begins the set-up clearance above the last depth, or where the chip was broken.
  void drill() {
    const double surface = value(203) * unit_;
    double peck = value(202) * unit_;
    if (!(peck > 0) || (surface - bottom_) / least_peck(peck) > kMostPecks)
      refuse("needs a plunging depth Q202 of a sensible size; correct it");
    int broken = 0;
    for (double at = surface - peck; at > bottom_; at -= peck) {
      feed(at, feed_in());
      if (broken < value(213)) {
        ++broken;
        builder_.rapid(height(std::min(clear_, at + value(256) * unit_)), line_);
      } else {
        broken = 0;
        builder_.rapid(height(clear_), line_);
        builder_.rapid(height(std::min(clear_, at + value(200) * unit_)), line_);
      }
      peck = std::max(least_peck(peck), peck - value(212) * unit_);
    }
    feed(bottom_, feed_in());
    dwell();
    if (cycle_.number == 203) feed_out_of_hole();
  }

  /// The pecks count from where drilling begins. After each the drill comes out to the set-up clearance and goes back to above the last depth:
  /// of the two distances the smaller one, since the control changes from the one to the other.
  void drill_deep() {
    const double start = value(203) * unit_ - value(379) * unit_;
    const double before = std::min(value(258), value(259)) * unit_;
    double peck = value(202) * unit_;
    if (!(peck > 0) || (start - bottom_) / least_peck(peck) > kMostPecks)
      refuse("needs a plunging depth Q202 of a sensible size; correct it");
    if (start <= bottom_) refuse("begins no higher than it ends; correct Q379 or Q201");
    if (value(379) > 0) feed(start, value(253) > 0 ? feed_of(value(253)) : feed_in());
    double last = start;
    for (double at = start - peck; at > bottom_; at -= peck) {
      break_chips(last, at);
      builder_.rapid(height(clear_), line_);
      builder_.rapid(height(std::min(clear_, at + before)), line_);
      last = at;
      peck = std::max(least_peck(peck), peck - value(212) * unit_);
    }
    break_chips(last, bottom_);
    dwell();
    feed_out_of_hole();
  }

  /// Down to `to`, with a short way up by Q256 each Q257.
  void break_chips(double from, double to) {
    const double each = value(257) * unit_;
    if (each > 0 && (from - to) / each > kMostPecks) refuse("breaks chips too often; correct Q257");
    for (double at = from - each; each > 0 && at > to; at -= each) {
      feed(at, feed_in());
      feed(std::min(clear_, at + value(256) * unit_), feed_out());
    }
    feed(to, feed_in());
  }

  double least_peck(double peck) const {
    const double least = value(205) * unit_;
    return value(212) > 0 && least > 0 ? std::min(peck, least) : peck;
  }

  /// The path of a boring bar stays in the middle: aside it goes by 0.2 mm, away from the wall that it has cut, while it stands.
  void bore() {
    feed(bottom_, feed_in());
    dwell();
    if (value(214) != 0) note_oriented_retract(builder_, line_, "by 0.2 mm to the side of Q214");
    feed_out_of_hole();
  }

  bool is_tap() const { return cycle_.number == 206 || turning_of(cycle_) != 0; }

  /// The feed and the turns are bound to each other, also on the way out, which Q403 makes faster.
  void tap() {
    const bool tied = cycle_.number != 206;
    const double faster = value(403) > 0 ? value(403) : 1, speed = builder_.drive.spindle_rpm;
    const MmPerMin down = tied ? feed_of_pitch() : feed_in();
    const MmPerMin up = MmPerMin::of(down.mm_per_min() * faster);
    const double each = value(257) * unit_, back = value(256) * std::abs(value(239)) * unit_;
    if (each < 0 || (each > 0 && (clear_ - bottom_) / each > kMostPecks))
      refuse("breaks chips too often; correct Q257");
    const auto turn_back_to = [&](double z) {
      builder_.turn_tap_back({std::nullopt, tied, false}, line_);
      builder_.speed = builder_.drive.spindle_rpm = speed * faster;
      feed(z, up);
      builder_.speed = builder_.drive.spindle_rpm = speed;
    };
    for (double at = value(203) * unit_ - each; each > 0 && at > bottom_; at -= each) {
      feed(at, down);
      turn_back_to(back > 0 ? std::min(clear_, at + back) : clear_);
    }
    feed(bottom_, down);
    dwell();
    turn_back_to(clear_);
  }

  /// Down a helix from the set-up clearance, once round at the bottom, and back to the middle. How the control comes to the helix and leaves it
  /// is its own choice; here by half circles, which lie within what the helix clears.
  void mill() {
    const double from_middle = value(335) / 2 * unit_ - cycle_.tool_radius;
    const std::string tool = "the tool, whose radius is " + trimmed(cycle_.tool_radius, 4) + " mm";
    if (from_middle < -kSameRadius)
      refuse("mills a hole that is smaller than " + tool + "; the control stops");
    if (from_middle <= kSameRadius) {
      feed(bottom_, feed_in());
      return;
    }
    if (from_middle > cycle_.tool_radius && value(342) <= 0)
      refuse("mills a hole more than twice as wide as " + tool +
             ", and Q342 states none that is there already; the control stops");
    const double deep = value(334) * unit_;
    if (!(deep > 0) || (clear_ - bottom_) / deep > kMostPecks)
      refuse("needs a depth of one turn Q334 of a sensible size; correct it");
    const Vec2 middle{builder_.known(0, line_), builder_.known(1, line_)};
    const Turn turn = value(351) < 0 ? Turn::kClockwise : Turn::kCounterClockwise;
    const double side = turn == Turn::kCounterClockwise ? 1 : -1, turns = (clear_ - bottom_) / deep;
    const Vec2 arm{from_middle, 0}, low = middle + rotated(arm, side * 2 * kPi * turns);
    along({middle, middle + arm, middle + arm / 2, turn, kPi}, clear_);
    along({middle + arm, low, middle, turn, 2 * kPi * turns}, bottom_);
    along({low, low, middle, turn, 2 * kPi}, bottom_);
    along({low, middle, (low + middle) / 2, turn, kPi}, bottom_);
  }

  void along(const ArcShape& shape, double z_to) { builder_.arc(shape, z_to, feed_in(), line_); }

  /// Where MAX is asked for it goes up at the rapid alone.
  void feed_out_of_hole() {
    if (value(208) < kFeedAsRapid) feed(clear_, feed_out());
  }

  void feed(double z, MmPerMin speed) { builder_.feed(height(z), speed, line_); }

  void dwell() {
    if (value(211) > 0) add_dwell_in_hole(builder_, line_, value(211));
  }

  MmPerMin feed_in() const { return feed_of(value(206)); }

  /// Where none is given, out at the feed in.
  MmPerMin feed_out() const {
    return value(208) > 0 && value(208) < kFeedAsRapid ? feed_of(value(208)) : feed_in();
  }

  /// In inch programs in tenths of an inch, as F.
  MmPerMin feed_of(double words) const { return MmPerMin::of(words * feed_unit(unit_)); }

  MmPerMin feed_of_pitch() const {
    if (!(std::abs(value(239)) > 0)) refuse("taps with a pitch Q239 of 0; correct it");
    return MmPerMin::of(std::abs(value(239)) * unit_ * builder_.speed);
  }

  double value(int parameter) const {
    const auto found = cycle_.parameters.find(parameter);
    return found == cycle_.parameters.end() ? 0 : found->second;
  }

  static Target height(double z) {
    Target target;
    target[2] = z;
    return target;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(builder_.place(line_), "cycle " + std::to_string(cycle_.number) + " " + what);
  }

  const HoleCycle& cycle_;
  double unit_;
  ToolpathBuilder& builder_;
  int line_;
  double clear_ = 0, above_ = 0, bottom_ = 0;  // mm
};

}  // namespace

bool is_hole_cycle(int number) {
  return form_of(number) != nullptr;
}

bool needs_radius(const HoleCycle& cycle) {
  return cycle.number == 208;
}

int turning_of(const HoleCycle& cycle) {
  if (cycle.number != 207 && cycle.number != 209) return 0;
  const auto pitch = cycle.parameters.find(239);
  return pitch != cycle.parameters.end() && pitch->second < 0 ? 4 : 3;
}

void make_hole(const HoleCycle& cycle, double unit, ToolpathBuilder& builder, int line) {
  Maker(cycle, unit, builder, line).make();
}

}  // namespace clearcut::read::gcode
