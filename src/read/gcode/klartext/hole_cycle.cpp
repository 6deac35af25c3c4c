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
#include "read/gcode/klartext/klartext.h"
#include "read/gcode/klartext/words.h"
#include "read/gcode/motion/cycle.h"

namespace clearcut::read::gcode {
namespace {

constexpr double kMostPecks = 10000;
/// mm/min; programs write this feed for FMAX, as long as the field takes no word.
constexpr double kFeedAsRapid = 99999;

struct Form {
  int number;
  std::vector<int> needed, allowed;
};

const std::vector<Form>& forms() {
  static const std::vector<Form> all{
      {200, {200, 201, 202, 203, 204, 206}, {210, 211, 395}},
      {201, {200, 201, 203, 204, 206}, {208, 211}},
      {203, {200, 201, 202, 203, 204, 206}, {205, 208, 210, 211, 212, 213, 256, 395}},
      {205, {200, 201, 202, 203, 204, 206}, {205, 208, 211, 212, 253, 256, 257, 258, 259, 379, 395}},
      {206, {200, 201, 203, 204, 206}, {211}},
      {207, {200, 201, 203, 204, 239}, {}}};
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
    } else {
      feed_down_and_up();
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

  void feed_down_and_up() {
    const MmPerMin down = cycle_.number == 207 ? feed_of_pitch() : feed_in();
    feed(bottom_, down);
    dwell();
    if (cycle_.number == 201) return feed_out_of_hole();
    builder_.turn_tap_back({std::nullopt, cycle_.number == 207, false}, line_);
    feed(clear_, down);
  }

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

int turning_of(const HoleCycle& cycle) {
  if (cycle.number != 207) return 0;
  const auto pitch = cycle.parameters.find(239);
  return pitch != cycle.parameters.end() && pitch->second < 0 ? 4 : 3;
}

void make_hole(const HoleCycle& cycle, double unit, ToolpathBuilder& builder, int line) {
  Maker(cycle, unit, builder, line).make();
}

}  // namespace clearcut::read::gcode
