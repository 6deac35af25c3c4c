#include "read/gcode/control/motion_words.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/units.h"
#include "read/gcode/control/compensation_words.h"
#include "read/gcode/control/place_words.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kMostTurns = 10000;
/// Arcs standing upright (G18, G19) become chords: a Move is an arc in plan only. mm.
constexpr double kUprightChord = 0.0005;

}  // namespace

void MotionWords::move(const Block& block) {
  const int said = motion_in(block);
  if (said >= 0) control_.motion = said;
  const bool cycle = control_.is_cycle(control_.motion);
  if (!cycle) control_.cycle = {};
  if (control_.motion == 800) control_.tied_by_m29 = false;
  if (block.corner) check_corner(block);
  if (PlaceWords(control_).move_specially(block)) {
    if (block.corner) refuse_idle_corner();
    return;
  }
  if (has_g(block, 51)) return;  // its axis words name axes
  if (has_g(block, 310)) return measure(block);
  const bool arc_words = block.has('I') || block.has('J') || block.has('K') || block.has('R');
  const bool arc_motion = control_.motion == 20 || control_.motion == 30;
  if (!block.has_axis() && !(arc_motion && arc_words)) return;
  if (control_.motion < 0) {
    control_.condition("motion-mode",
                       "axis words come before any motion word; the control begins with rapids (G0)");
    control_.motion = 0;
  }
  check_words_said(block);
  check_compensation();
  control_.moved = true;
  if (control_.motion != 0) control_.before_feed();
  if (block.corner) control_.builder.expect_corner(control_.line);
  if (control_.motion == 0 || control_.motion == 10)
    straight(block, control_.motion == 0);
  else if (arc_motion)
    arc(block);
  if (block.corner) round_corner(*block.corner);
  if (control_.motion == 0 || control_.motion == 10 || arc_motion) return;
  if (cycle) return CannedCycles(control_).execute(block);
  if (control_.motion == 331) return rigid_tap(block);
  if (control_.motion >= 382 && control_.motion <= 385) return measure(block);
  if (control_.motion == 800) control_.refuse("axis words after G80 without a motion word; add G0 or G1");
  refuse_motion();
}

/// What no control here does by the word, or what a path in a stock seen from above cannot show.
void MotionWords::refuse_motion() const {
  const int code = control_.motion;
  if (bores_from_below(control_.rules, code)) control_.refuse(g_word(code) + std::string(kBoresFromBelow));
  if (code == 870 || code == 880)
    control_.refuse(g_word(code) + " does nothing that " + std::string(control_.rules.title) +
                    " states; bore by G85, G86 or G89");
  if (code == 760)
    control_.refuse("G76 cuts a thread in passes here, which is not read; mill it by G2 and G3");
  control_.refuse(g_word(code) + " is not read; post the program without it");
}

void MotionWords::check_corner(const Block& block) {
  const bool cuts = control_.motion == 10 || control_.motion == 20 || control_.motion == 30;
  if (!control_.rules.corner_words)
    control_.refuse(std::string("',") + block.corner->letter + "' is no word of " +
                    std::string(control_.rules.name) +
                    "; post the program for this control, or name another");
  if (!cuts || !block.has_axis() || has_g(block, 51) || has_g(block, 310)) refuse_idle_corner();
  if (control_.modes.plane != Plane::kXY)
    control_.refuse("corners are rounded and chamfered in the XY plane alone here; use G17");
  if (!control_.rules.corner_needs.empty())
    control_.condition("corner-words", std::string(control_.rules.corner_needs));
}

void MotionWords::refuse_idle_corner() const {
  control_.refuse("a corner is rounded or chamfered behind a block that cuts no line or arc; correct it");
}

void MotionWords::round_corner(const CornerWord& said) {
  Corner corner;
  corner.kind = said.letter == 'R'   ? CornerKind::kRounding
                : said.letter == 'C' ? CornerKind::kChamfer
                                     : CornerKind::kChamferLength;
  refuse_unequal_scales();
  corner.size = control_.mm(said.value) * (control_.plan_map.is_on ? control_.plan_map.scale : 1);
  corner.feeds_as_next = control_.rules.corner_feeds_as_next;
  if (said.feed && control_.modes.feed_mode != FeedMode::kPerMinute)
    control_.refuse("a feed for the corner alone is read in mm or inches for the minute; post G94");
  if (said.feed) corner.feed = MmPerMin::of(*said.feed);
  corner.line = control_.line;
  control_.builder.round_corner(corner);
}

/// G33.1 of LinuxCNC: to the place at the feed that K says for each turn, back to where it began with the spindle turning
/// the other way, which then turns as before.
void MotionWords::rigid_tap(const Block& block) {
  if (!block.has('K') || !(std::abs(block.value('K')) > 0))
    control_.refuse("G33.1 needs its K word; add the pitch");
  if (control_.modes.spindle == 5 || control_.modes.speed <= 0)
    control_.refuse("G33.1 waits for a spindle that does not turn; start it before");
  const Target to = control_.target(block);
  Target back;
  for (std::size_t axis = 0; axis < 3; ++axis) back[axis] = control_.builder.known(axis, control_.line);
  const auto feed = MmPerMin::of(std::abs(control_.mm(block.value('K'))) * control_.modes.speed);
  control_.builder.feed(to, feed, control_.line);
  control_.builder.turn_tap_back({}, control_.line);
  control_.builder.feed(back, feed, control_.line);
}

/// G38.2 to G38.5 and G31 move a probe until it meets the work. Where that is only the machine knows: nothing is moved here.
void MotionWords::measure(const Block& block) {
  const std::string word = has_g(block, 310) ? "G31" : g_word(control_.motion);
  const Target to = control_.target(block);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    control_.measured[axis] = to[axis] ? *to[axis] : control_.builder.known(axis, control_.line);
    control_.zero_is_measured[axis] = to[axis].has_value();
  }
  control_.has_measured = true;
  control_.condition("measured-move",
                     word +
                         " moves a probe until it meets the work; its way is free, it cuts "
                         "nothing, and what it measures leaves the zero where the part's is");
}

/// What the program leaves to the state in which the control was left.
void MotionWords::check_words_said(const Block& block) {
  if (!control_.units_said && !control_.rules.always_mm) {
    control_.condition(
        "units", "the program states " + std::string(control_.rules.unit_words) + "; the control is in mm");
  }
  if (!control_.distance_said && !control_.rules.resets_modes) {
    control_.condition("g90",
                       "the program states neither G90 nor G91 before it moves; the control is in G90");
  }
  const bool plane_matters = control_.motion != 0 && control_.motion != 10;
  if (!control_.plane_said && !control_.rules.resets_modes && plane_matters && !control_.rules.always_in_xy) {
    control_.condition("g17", "the program states no plane before its arcs or cycles; the control is in G17");
  }
  if (!control_.rules.points_matter) return;
  const bool counts_holes = control_.is_cycle(motion_in(block) >= 0 ? motion_in(block) : control_.motion);
  for (const char letter : {'X', 'Y', 'Z', 'I', 'J', 'K', 'R', 'Q'}) {
    if (letter == 'K' && counts_holes) continue;
    if (block.has(letter) && block.is_whole(letter) && block.value(letter) != 0) {
      control_.condition("decimal-point",
                         std::string(1, letter) +
                             " has no decimal point; the control takes whole numbers as mm or inches, not as "
                             "increments");
    }
  }
}

/// Arcs cannot begin or end compensation, and nothing but lines and arcs follows it.
void MotionWords::check_compensation() const {
  const int motion = control_.motion;
  const bool is_arc = motion == 20 || motion == 30;
  if (motion == 0 || motion == 10) return;
  if (!is_arc) return CompensationWords(control_).refuse_while_on(g_word(motion));
  if (control_.builder.compensation_begins())
    control_.refuse("cutter compensation begins with an arc; enter along a straight line");
  if (control_.builder.compensation_leaves())
    control_.refuse("cutter compensation ends with an arc; leave along a straight line");
}

void MotionWords::straight(const Block& block, bool rapid) {
  const Target to = control_.target(block);
  if (rapid) return control_.builder.rapid(to, control_.line);
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!to[axis]) continue;
    const double way = *to[axis] - control_.builder.position()[axis].value_or(*to[axis]);
    squared += way * way;
  }
  control_.builder.feed(to, control_.feed_for(std::sqrt(squared), block), control_.line);
}

void MotionWords::arc(const Block& block) {
  const PlaneAxes axes = axes_of(control_.modes.plane);
  std::array<double, 3> from{}, to{};
  for (std::size_t axis = 0; axis < 3; ++axis) from[axis] = control_.builder.known(axis, control_.line);
  const Target said = control_.target(block);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    to[axis] = said[axis].value_or(from[axis]);
    if (!(std::abs(to[axis]) <= 1e6))
      control_.refuse("coordinate beyond any machine; check the number and the units");
  }
  const ArcShape shape =
      arc_shape(block, {from[axes.first], from[axes.second]}, {to[axes.first], to[axes.second]});
  if (control_.modes.plane == Plane::kXY) {
    plan_arc(block, shape, to[2]);
  } else {
    upright_arc(shape, to[axes.across]);
  }
}

void MotionWords::refuse_unequal_scales() const {
  if (control_.plan_map.scale == 0)
    control_.refuse(
        "arcs while G51 scales X and Y differently are no arcs; post them as lines, or scale both alike");
}

ArcShape MotionWords::arc_shape(const Block& block, Vec2 from, Vec2 to) {
  const PlanMap& map = control_.plan_map;
  refuse_unequal_scales();
  const bool clockwise = (control_.motion == 20) != (map.is_on && map.flips);
  const Turn turn = clockwise ? Turn::kClockwise : Turn::kCounterClockwise;
  const PlaneAxes axes = axes_of(control_.modes.plane);
  if ((map.is_on || control_.polar_mode) && control_.modes.plane != Plane::kXY)
    control_.refuse("arcs outside the XY plane under " + std::string(map.words) + " are not read; use G17");
  const RadiusRule rule =
      control_.modes.unit == 1 ? RadiusRule{} : RadiusRule{0.0005 * kMmPerInch, 0.05 * kMmPerInch};
  const char first = "IJK"[axes.first], second = "IJK"[axes.second];
  const bool center = block.has(first) || block.has(second);
  if (block.has('R') && center) {
    control_.depends_on_dialect = true;
    if (!control_.rules.radius_beats_center)
      control_.refuse("arc with R and with its centre; give one of them");
  }
  if (block.has('R'))
    return arc_of_radius(from, to, control_.mm(block.value('R')) * map.scale, turn, rule,
                         control_.builder.place(control_.line));
  if (!center)
    control_.refuse(std::string("arc without ") + first + ", " + second + " or R; give its centre");
  if (control_.rules.centers_set_up && !control_.centers_said) {
    control_.condition("arc-centres",
                       "the program states neither G90.1 nor G91.1; I, J, K count from the arc's start");
  }
  const auto center_of = [&](char letter, std::size_t axis, double start) {
    if (!block.has(letter)) return start;
    return control_.mm(block.value(letter)) +
           (control_.modes.absolute_centers ? control_.frame.shift(axis) : start);
  };
  const double turns = block.has('P') ? block.value('P') : 1;
  if (!(turns >= 1 && turns <= kMostTurns) || turns != std::floor(turns))
    control_.refuse("P word is no number of turns; correct it");
  if (map.is_on) {
    if (control_.modes.absolute_centers)
      control_.refuse("absolute centres under G68, G51 or G51.1 are not read; use G91.1");
    const Vec2 arm = map.turned({control_.mm(block.value('I')), control_.mm(block.value('J'))});
    return arc_about(from, to, from + arm, turn, static_cast<int>(turns), rule,
                     control_.builder.place(control_.line));
  }
  const Vec2 middle{center_of(first, axes.first, from.x), center_of(second, axes.second, from.y)};
  return arc_about(from, to, middle, turn, static_cast<int>(turns), rule,
                   control_.builder.place(control_.line));
}

void MotionWords::plan_arc(const Block& block, const ArcShape& shape, double z_to) {
  const double z_from = control_.builder.known(2, control_.line);
  const double round = shape.sweep * distance(shape.from, shape.center);
  const double apart = std::abs(distance(shape.from, shape.center) - distance(shape.to, shape.center));
  const MmPerMin feed = control_.feed_for(base::hypot(round, z_to - z_from), block);
  control_.builder.arc(shape, z_to, feed, control_.line, apart);
}

void MotionWords::upright_arc(const ArcShape& shape, double along) {
  const PlaneAxes axes = axes_of(control_.modes.plane);
  if (control_.modes.feed_mode == FeedMode::kInverseTime)
    control_.refuse("arcs outside the XY plane under G93 are not read");
  control_.builder.note(control_.line, "arcs outside the XY plane are taken as chords within 0.5 um");
  const double across = control_.builder.known(axes.across, control_.line);
  const std::vector<Edge> edges = arc_edges(shape);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    std::vector<Vec2> points;
    append_flattened(edges[k], kUprightChord, points);
    for (std::size_t n = 0; n < points.size(); ++n) {
      const double t =
          (static_cast<double>(k) + static_cast<double>(n + 1) / static_cast<double>(points.size())) /
          static_cast<double>(edges.size());
      Target to;
      to[axes.first] = points[n].x;
      to[axes.second] = points[n].y;
      to[axes.across] = std::lerp(across, along, t);
      control_.builder.feed(to, control_.feed_for(0, {}), control_.line);
    }
  }
}

namespace {

constexpr double kMostRepeats = 10000;

}  // namespace

/// The words stay in force for the following blocks of the cycle; on some controls for other cycles, too.
void CannedCycles::set_cycle_words(const Block& block) {
  const std::size_t across = axes_of(control_.modes.plane).across;
  check_dwell(block);
  if (control_.cycle.code == 0) {
    control_.cycle = {};
    control_.cycle.level = control_.builder.known(across, control_.line) - control_.frame.shift(across);
  } else if (control_.cycle.code != control_.motion) {
    control_.depends_on_dialect = true;
    if (!control_.rules.keeps_cycle_words)
      control_.cycle.z = control_.cycle.r = control_.cycle.peck = std::nullopt;
  }
  control_.cycle.code = control_.motion;
  const char bottom = "XYZ"[across];
  if (block.has(bottom)) control_.cycle.z = control_.mm(block.value(bottom));
  if (block.has('R')) control_.cycle.r = control_.mm(block.value('R'));
  if (block.has('Q')) control_.cycle.peck = control_.mm(block.value('Q'));
  if (block.has('P')) control_.cycle.dwell = block.value('P') * (control_.rules.dwell_in_ms ? 0.001 : 1);
  if (!control_.cycle.z || !control_.cycle.r)
    control_.refuse("drilling cycle without its Z or R word; give both");
}

/// LinuxCNC asks for the time of a dwell wherever a cycle begins that dwells.
void CannedCycles::check_dwell(const Block& block) const {
  const int code = control_.motion;
  const bool dwells = code == 820 || code == 860 || code == 880 || code == 890;
  if (dwells && control_.rules.cycle_needs_dwell && control_.cycle.code != code && !block.has('P'))
    control_.refuse(g_word(code) + " without its P word, which " + std::string(control_.rules.title) +
                    " asks for; add the seconds of the dwell");
}

/// In G91, R counts from a height before the cycle and Z from R.
void CannedCycles::set_cycle_heights(Hole& hole) {
  if (control_.plan_map.scale_z != 1)
    control_.refuse(
        "drilling cycles while G51 scales heights are not read; scale X and Y alone, or drill outside of it");
  const double shift = control_.frame.shift(hole.across);
  const double level = control_.cycle.level + shift;
  hole.r = *control_.cycle.r + (control_.modes.absolute ? shift : level);
  hole.bottom = *control_.cycle.z + (control_.modes.absolute ? shift : hole.r);
  const double initial = control_.rules.cycle_goes_over_below_r ? level : std::max(level, hole.r);
  hole.clear = control_.modes.return_to_level ? initial : hole.r;
  if (!control_.modes.absolute) control_.depends_on_dialect = true;
  if (hole.r < hole.bottom) control_.refuse("drilling cycle whose R lies below its Z; correct it");
  if (control_.return_said || std::max(level, hole.r) == hole.r) return;
  control_.depends_on_dialect = true;
  control_.condition(control_.modes.return_to_level ? "g98" : "g99",
                     std::string("the program states neither G98 nor G99; the control is in ") +
                         (control_.modes.return_to_level ? "G98 and returns to the height before the cycle"
                                                         : "G99 and returns to R"));
}

double CannedCycles::repeats(const Block& block) const {
  const double count = block.has('L') ? block.value('L') : block.has('K') ? block.value('K') : 1;
  if (!(count >= 0 && count <= kMostRepeats))
    control_.refuse("L word with an impossible number of repeats; correct it");
  return count;
}

/// '@' and '^' in G91 count from where each hole was.
Block CannedCycles::counted_on(Block block) {
  block.unset('X');
  block.unset('Y');
  return control_.without_polar_words(block);
}

void CannedCycles::execute(const Block& block) {
  set_cycle_words(block);
  const PlaneAxes axes = axes_of(control_.modes.plane);
  if (control_.modes.plane != Plane::kXY) {
    control_.depends_on_dialect = true;
    if (control_.motion == 840 || control_.motion == 740)
      control_.refuse(g_word(control_.motion) +
                      " outside the XY plane mixes the axes up on LinuxCNC; use G17");
  }
  for (const std::size_t axis : {0U, 1U, 2U}) control_.builder.known(axis, control_.line);
  Hole hole;
  hole.code = control_.motion;
  hole.across = axes.across;
  hole.peck = control_.cycle.peck.value_or(0);
  hole.gap = control_.modes.unit == 1 ? 0.254 : 0.01 * kMmPerInch;
  hole.dwell = control_.cycle.dwell;
  hole.feeds_out_to_clear = control_.rules.feeds_out_to_clear;
  hole.tap = {control_.motion == 740,
              control_.rules.taps == TapRule::kTied ||
                  (control_.rules.taps == TapRule::kTiedByM29 && control_.tied_by_m29),
              control_.rules.taps != TapRule::kAsItTurns};
  hole.taps_peck = control_.rules.taps_peck;
  hole.hands_take_it_out = control_.motion == 870 || control_.motion == 880;
  if (control_.motion == 760)
    note_oriented_retract(control_.builder, control_.line,
                          "by Q, or I and J, to a side that the control is set to");
  set_cycle_heights(hole);
  if (hole.feeds_out_to_clear != (hole.clear == hole.r) &&
      (control_.motion == 740 || control_.motion == 840 || control_.motion == 890)) {
    control_.depends_on_dialect = true;
  }
  for (int n = static_cast<int>(repeats(block)); n > 0; --n) {
    go_over_hole(block.is_polar() ? counted_on(block) : block, hole);
    drill(control_.builder, hole, control_.feed_for(1, block), control_.line);
  }
}

/// LinuxCNC goes up only where the cycles began below R, and takes the rest of the way up with the way over. Fanuc and
/// its like go over the hole first, at whatever height they are.
void CannedCycles::go_over_hole(const Block& block, const Hole& hole) {
  const PlaneAxes axes = axes_of(control_.modes.plane);
  Target over, down;
  down[axes.across] = hole.r;
  const double at = *control_.builder.position()[axes.across];
  const double from =
      control_.rules.cycle_rises_over ? control_.cycle.level + control_.frame.shift(axes.across) : at;
  if (from < hole.r && !control_.rules.cycle_goes_over_below_r) control_.builder.rapid(down, control_.line);
  const Target said = control_.target(block);
  for (const std::size_t axis : {axes.first, axes.second}) over[axis] = said[axis];
  const double now = *control_.builder.position()[axes.across];
  if (control_.rules.cycle_rises_over && now <= hole.r) over[axes.across] = hole.clear;
  control_.builder.rapid(over, control_.line);
  control_.builder.rapid(down, control_.line);
}

}  // namespace clearcut::read::gcode
