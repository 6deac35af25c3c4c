#include "verify/engagement/load.h"

#include <algorithm>
#include <cmath>

#include "base/progress.h"
#include "stock/material.h"
#include "verify/engagement/forces.h"
#include "verify/faults/shaped_cutter.h"

namespace clearcut::verify {
namespace {

/// mm. Thinner material, beside or below the cutter, comes from rounding of printed coordinates.
constexpr double kFilm = 1e-3;
/// mm. Depth of cut is measured this far inside the cutter's circle, because slivers that an earlier cutter
/// left on a wall are higher, but give no load.
constexpr double kSliver = 0.05;
/// mm. Greatest distance between samples of the engagement.
constexpr double kLongestStep = 0.25;

/// mm down for each mm of advance. A move that descends less is not an entry but a pass that is not quite
/// level: 0.17 degrees.
constexpr double kEntrySlope = 3e-3;
/// mm down for each mm of advance. Steeper moves are checked as plunges.
constexpr double kAsPlunge = 1;
/// mm. A level move this near to the ramps before it lies on them.
constexpr double kOverRamp = 0.01;
/// Cosine of 6 degrees: with a smaller change of direction two moves join smoothly.
constexpr double kSmooth = 0.995;

double degrees(double radians) {
  return radians * 180 / kPi;
}

Vec2 direction_at(const Move& move, double t) {
  return move.path.tangent_at(t);
}

class LoadMeter {
 public:
  LoadMeter(stock::Material& material, const LoadOptions& options) : material_(material), options_(options) {}

  void measure(JudgedMove& judged) {
    const Move& move = *judged.move;
    const double radius = judged.radius();
    follow_entry(judged);
    measure_holder(judged);
    if (judged.feeds() && judged.tool && is_conical(*judged.tool)) return measure_cone(judged);
    if (judged.low_z() < material_.z_top() - kFilm && radius > kFilm) {
      if (!judged.feeds()) {
        measure_rapid(judged);
      } else if (move.is_vertical()) {
        measure_plunge(judged);
      } else {
        measure_feed(judged);
      }
    }
    take_away(judged);
  }

  /// Runs a move that is measured elsewhere: the same state as after measuring it.
  void pass_over(const JudgedMove& judged) {
    follow_entry(judged);
    if (judged.feeds() && judged.tool && is_conical(*judged.tool)) {
      before_ = judged.move;
      return cones_.add(*judged.move, *judged.tool);
    }
    take_away(judged);
  }

 private:
  void take_away(const JudgedMove& judged) {
    if (judged.radius() > 0 && judged.feeds()) material_.add(*judged.move, judged.radius());
    before_ = judged.feeds() ? judged.move : nullptr;
  }

  /// Measures how deep the tip of a cone is in material. What cones remove counts as removed for later cones only.
  void measure_cone(JudgedMove& judged) {
    const Move& move = *judged.move;
    before_ = &move;
    if (judged.low_z() < material_.z_top() - kFilm) {
      const double length = move.length();
      const int steps =
          move.is_vertical() ? 1 : std::max(1, static_cast<int>(std::ceil(length / kLongestStep)));
      for (int i = 0; i <= steps; ++i) measure_tip(judged, static_cast<double>(i) / steps);
      (judged.load.axial_mm > 0 ? judged.load.cutting_mm : judged.load.air_mm) += length;
    }
    cones_.add(move, *judged.tool);
  }

  void measure_tip(JudgedMove& judged, double t) {
    const Move& move = *judged.move;
    const Vec2 p = move.is_vertical() ? move.path.from : move.path.at(t);
    const double z = move.is_vertical() ? judged.low_z() : move.z_from + (move.z_to - move.z_from) * t;
    const double axial = std::min(material_.height(p), cones_.at(p)) - z;
    if (axial <= std::max(kFilm, judged.load.axial_mm)) return;
    judged.load.axial_mm = axial;
    judged.load.axial_at = {p, z, move.line};
  }

  static int steps_of(double length, double radius) {
    return std::max(1, static_cast<int>(std::ceil(length / std::min(radius / 10, kLongestStep))));
  }

  void measure_feed(JudgedMove& judged) {
    const Move& move = *judged.move;
    const double length = move.length(), radius = judged.radius();
    const int steps = steps_of(length, radius);
    for (int i = 0; i < steps; ++i) measure_at(judged, (i + 0.5) / steps, length / steps);
    // Just after the start and at the end, too, because engagement is greatest at corners. Moves that
    // continue smoothly have no corner.
    if (!goes_smoothly_on(move)) measure_at(judged, std::min(0.01 / length, 0.25 / steps), 0);
    if (steps > 1) measure_at(judged, 1, 0);
    if (judged.slope() >= kAsPlunge) find_plunge_contact(judged, move.path.to);
  }

  /// Sets in_entry_: the move descends into material, or it is level along the ramps just cut and removes what they left.
  void follow_entry(const JudgedMove& judged) {
    const Move& move = *judged.move;
    in_entry_ = false;
    if (!judged.feeds() || move.z_to > move.z_from) return ramps_.clear();
    if (move.is_vertical()) return;
    if (move.z_to < move.z_from) {
      in_entry_ = judged.slope() >= kEntrySlope;
      if (in_entry_) ramps_.push_back(&move);
      return;
    }
    in_entry_ = !ramps_.empty();
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) in_entry_ = in_entry_ && over_ramps(move.path.at(t));
    if (!in_entry_) ramps_.clear();
  }

  bool over_ramps(Vec2 p) const {
    return std::any_of(ramps_.begin(), ramps_.end(),
                       [&](const Move* ramp) { return distance(ramp->path, p) < kOverRamp; });
  }

  bool goes_smoothly_on(const Move& move) const {
    if (!before_ || before_->is_vertical() || before_->path.to != move.path.from) return false;
    return dot(direction_at(*before_, 1), direction_at(move, 0)) > kSmooth;
  }

  void measure_at(JudgedMove& judged, double t, double length) {
    const Move& move = *judged.move;
    const double z = move.z_from + (move.z_to - move.z_from) * t;
    if (z >= material_.z_top() - kFilm) return;
    Move lifted = move;
    lifted.z_from += kFilm;
    lifted.z_to += kFilm;
    const stock::CutterEngagement contact = material_.engagement(lifted, t, judged.radius() - kFilm);
    MoveLoad& load = judged.load;
    const double axial = contact.angle > 0 ? measure_axial(judged, move.path.at(t),
                                                           angle_of(direction_at(move, t)), z, contact.angles)
                                           : 0;
    if (in_entry_) return;
    if (contact.angle <= 0) {
      load.air_mm += length;
      return;
    }
    const double angle = degrees(contact.angle);
    load.cutting_mm += length;
    load.angle_mm_deg += angle * length;
    load.histogram_mm[std::min<std::size_t>(17, static_cast<std::size_t>(angle / 10))] += length;
    if (options_.limit_deg && angle > *options_.limit_deg) load.over_limit_mm += length;
    if (options_.material)
      add_forces(judged, {contact, axial, length, {move.path.at(t), z, move.line}}, *options_.material);
    const double climb = climb_share(contact, judged.clockwise);
    load.climb_mm += length * climb;
    load.conventional_mm += length * (1 - climb);
    if (angle > load.max_deg) {
      load.max_deg = angle;
      load.max_at = {move.path.at(t), z, move.line};
    }
  }

  /// 1 if the material is on the climb side, 0 if on the other, 1/2 in a slot.
  static double climb_share(const stock::CutterEngagement& contact, bool clockwise) {
    const double difference = clockwise ? contact.right - contact.left : contact.left - contact.right;
    if (std::abs(difference) < 0.01 * contact.angle) return 0.5;
    return difference > 0 ? 1 : 0;
  }

  /// mm; height of the material before the cutter, well inside what it removes, at this sample; updates the
  /// greatest of the move.
  double measure_axial(JudgedMove& judged, Vec2 center, double heading, double z,
                       const stock::AngleSet& contact) {
    const double inside = judged.radius() - kSliver;
    double here = 0;
    const bool may_be_more = z + judged.load.axial_mm + kFilm < material_.z_top();
    if (inside <= 0 || (!may_be_more && !options_.material)) return here;
    for (const stock::AngleInterval& item : contact.intervals()) {
      for (const double part : {0.1, 0.5, 0.9}) {
        const double angle = heading + item.from + part * item.width();
        const Vec2 p = center + direction_of(angle) * inside;
        measure_axial_at(judged, p, center, z);
        if (options_.material) here = std::max(here, material_.height(p) - z);
      }
    }
    return here;
  }

  void measure_axial_at(JudgedMove& judged, Vec2 p, Vec2 center, double z) {
    MoveLoad& load = judged.load;
    if (material_.is_removed(p, z + load.axial_mm + kFilm)) return;
    const double axial = material_.height(p) - z;
    if (axial <= load.axial_mm) return;
    load.axial_mm = axial;
    load.axial_at = {center, z, judged.move->line};
  }

  void measure_plunge(JudgedMove& judged) {
    const Move& move = *judged.move;
    if (move.z_to >= move.z_from) return;
    const Vec2 center = move.path.from;
    const double radius = judged.radius(), z = move.z_to;
    for (const double share : {0.0, 0.5, 1.0}) {
      for (int i = 0; i < 8; ++i) {
        const Vec2 p = center + direction_of(kPi / 4 * i) * (share * (radius - kSliver));
        measure_axial_at(judged, p, center, z);
      }
    }
    const auto hit = material_.in_reach(move.path, radius - kSliver, z + kFilm);
    if (hit) measure_axial_at(judged, *hit, center, z);
    find_plunge_contact(judged, center);
  }

  void find_plunge_contact(JudgedMove& judged, Vec2 center) const {
    if (judged.tool->center_cutting) return;
    const double z = judged.move->z_to;
    if (touches(center, judged.radius() - kFilm, z))
      judged.load.plunge_contact = Place{center, z, judged.move->line};
  }

  /// Whether material above z lies anywhere in the disc.
  bool touches(Vec2 center, double radius, double z) const {
    return material_.in_reach(Edge::line(center, center), radius, z + kFilm).has_value();
  }

  void measure_rapid(JudgedMove& judged) {
    const Move& move = *judged.move;
    const double radius = judged.radius() - kFilm;
    // A cone that goes straight up in its groove touches nothing.
    if (judged.tool && is_conical(*judged.tool) && move.is_vertical() && move.z_to >= move.z_from) return;
    // A vertical rapid touches most where it is lowest.
    if (move.is_vertical()) {
      if (touches(move.path.from, radius, judged.low_z()))
        report_rapid(judged, move.path.from, judged.low_z());
      return;
    }
    if (move.z_from == move.z_to) {
      const auto hit = material_.in_reach(move.path, radius, move.z_to + kFilm);
      if (hit) report_rapid(judged, move.path.at(nearest(move.path, *hit).t), move.z_to);
      return;
    }
    const int steps = steps_of(move.path.length(), judged.radius());
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const double z = move.z_from + (move.z_to - move.z_from) * t;
      if (z >= material_.z_top() - kFilm) continue;
      if (touches(move.path.at(t), radius, z)) return report_rapid(judged, move.path.at(t), z);
    }
  }

  /// What is above the cutter, in what stands before the move: its way at the lowest, in steps where it slopes.
  void measure_holder(JudgedMove& judged) {
    if (!judged.tool) return;
    const Tool& tool = *judged.tool;
    if (tool.stickout && tool.holder_diameter > 0)
      measure_above(judged, *tool.stickout, tool.holder_diameter / 2, false);
    if (tool.flute_length && tool.shank_diameter > tool.diameter)
      measure_above(judged, *tool.flute_length, tool.shank_diameter / 2, true);
  }

  void measure_above(JudgedMove& judged, double above, double radius, bool is_shank) {
    const Move& move = *judged.move;
    if (judged.load.holder_contact || judged.low_z() + above >= material_.z_top() - kFilm) return;
    const bool is_one = move.is_vertical() || move.z_from == move.z_to;
    const int steps = is_one ? 1 : steps_of(move.path.length(), radius);
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 1.0) / steps;
      const double z = is_one ? judged.low_z() : move.z_from + (move.z_to - move.z_from) * t;
      const Vec2 at = move.is_vertical() ? move.path.from : move.path.at(t);
      const Edge way = is_one && !move.is_vertical() ? move.path : Edge::line(at, at);
      const auto hit = material_.in_reach(way, radius - kFilm, z + above + kFilm);
      if (!hit) continue;
      judged.load.holder_contact = Place{is_one ? nearest_on(way, *hit) : at, z, move.line};
      judged.load.is_shank = is_shank;
      return;
    }
  }

  static Vec2 nearest_on(const Edge& way, Vec2 p) {
    return way.from == way.to ? way.from : nearest(way, p).point;
  }

  static void report_rapid(JudgedMove& judged, Vec2 center, double z) {
    judged.load.rapid_contact = Place{center, z, judged.move->line};
  }

  stock::Material& material_;
  const LoadOptions& options_;
  CutHeights cones_;                ///< what cones have cut
  const Move* before_ = nullptr;    ///< the last feed move before the current one
  std::vector<const Move*> ramps_;  ///< of the entry that is being run
  bool in_entry_ = false;
};

/// mm; a height below every floor.
double bottom_of(const Part& part) {
  double bottom = part.top_z();
  for (const Feature& feature : part.features) bottom = std::min(bottom, feature.floor_z);
  return bottom - 1;
}

/// Least number of samples in a part of the program: each part has to run all moves before it once more.
constexpr double kLeastSamples = 20000;
/// Greatest number of parts, and greatest length of path over all of them in cutter radii: each part keeps the material of its
/// own run, about half a kB for each radius of path.
constexpr int kMostParts = 4;
constexpr double kMostRadii = 6e5;

/// About how many samples a move is measured at.
double samples_of(const JudgedMove& judged, double top_z) {
  const bool sampled = judged.feeds() && judged.radius() > kFilm && judged.low_z() < top_z;
  return 1 + (sampled ? judged.move->length() / std::min(judged.radius() / 10, kLongestStep) : 0);
}

/// Measures the moves from `first` to before `last`, after running all before them.
void measure_moves(const Part& part, std::vector<JudgedMove>& moves, std::size_t first, std::size_t last,
                   const LoadOptions& options) {
  std::vector<double> radii;
  for (const JudgedMove& judged : moves) {
    if (judged.radius() > 0) radii.push_back(judged.radius());
  }
  for (const PredrilledHole& hole : part.predrilled) radii.push_back(hole.diameter / 2);
  if (radii.empty()) return;
  std::optional<Box> plan;
  if (part.stock) plan = part.stock->plan;
  stock::Material material(plan, part.top_z(), radii);
  for (const PredrilledHole& hole : part.predrilled) {
    const Edge down = Edge::line(hole.center, hole.center);
    material.add({down, part.top_z(), bottom_of(part), MoveKind::kPlunge, {}, 0}, hole.diameter / 2);
  }
  LoadMeter meter(material, options);
  for (std::size_t i = 0; i < last; ++i) {
    throw_if_cancelled(options.cancel);
    if (i < first) {
      meter.pass_over(moves[i]);
    } else {
      meter.measure(moves[i]);
    }
  }
}

}  // namespace

void measure_load(const Part& part, std::vector<JudgedMove>& moves, const LoadOptions& options) {
  measure_moves(part, moves, 0, moves.size(), options);
}

std::vector<std::function<void()>> load_tasks(const Part& part, std::vector<JudgedMove>& moves,
                                              const LoadOptions& options, int threads) {
  double all = 0, radii = 0;
  for (const JudgedMove& judged : moves) {
    all += samples_of(judged, part.top_z());
    if (judged.feeds() && judged.radius() > kFilm) radii += judged.move->length() / judged.radius();
  }
  const double room = std::clamp(kMostRadii / std::max(radii, 1.0), 1.0, double{kMostParts});
  const int most = std::clamp(threads, 1, static_cast<int>(room));
  const int parts = std::clamp(static_cast<int>(all / kLeastSamples), 1, most);
  std::vector<std::function<void()>> tasks;
  double before = 0;
  for (std::size_t first = 0, last = 0; last < moves.size(); first = last) {
    const double until = all * (static_cast<double>(tasks.size()) + 1) / parts;
    while (last < moves.size() && (last == first || before < until))
      before += samples_of(moves[last++], part.top_z());
    if (static_cast<int>(tasks.size()) + 1 == parts) last = moves.size();
    tasks.push_back(
        [&part, &moves, options, first, last] { measure_moves(part, moves, first, last, options); });
  }
  return tasks;
}

}  // namespace clearcut::verify
