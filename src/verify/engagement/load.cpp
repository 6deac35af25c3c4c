#include "verify/engagement/load.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "model/cutter_profile.h"
#include "stock/cutting_load.h"
#include "stock/material.h"
#include "verify/engagement/entry_watch.h"
#include "verify/engagement/tool_takes.h"

namespace clearcut::verify {
namespace {

/// mm. Thinner material, beside or below the cutter, is due to rounding of printed coordinates.
constexpr double kResidual = 1e-3;
/// mm. Thinner material beside or below the cutter is not compared with a reference load: two passes of a program,
/// each rounded, leave more than kResidual between them, over a wide angle, and a chip is ten times as thick.
constexpr double kNoChip = 5e-3;
/// Radians. Engagement of a cutter that only grazes a sliver.
constexpr double kGraze = kPi / 180;
/// mm. Depth of cut is measured this far inside the cutter's circle, because slivers left on a wall by an earlier
/// cutter are higher, but cause no load.
constexpr double kSliver = 0.05;
/// mm. Material nearer than this to the tool above its flutes counts as touching: chips jam there, and the shank rubs.
constexpr double kClearOfWalls = 0.05;
/// mm. Greatest distance between samples of the engagement.
constexpr double kLongestStep = 0.25;

/// mm down for each mm of advance. Steeper moves are checked as plunges.
constexpr double kAsPlunge = 1;
/// Cosine of 6 degrees: with a smaller change of direction two moves join smoothly.
constexpr double kSmooth = 0.995;

double degrees(double radians) {
  return radians * 180 / kPi;
}

Vec2 direction_at(const Move& move, double t) {
  return move.path.tangent_at(t);
}

Move raised(Move move, double by) {
  move.z_from += by;
  move.z_to += by;
  return move;
}

class LoadMeter {
 public:
  LoadMeter(const Part& part, stock::Material& material, const LoadOptions& options)
      : part_(part), material_(material), options_(options), entry_(options.finished) {}

  /// The first of these moves, the next of the program; the others follow.
  void measure(std::span<CheckedMove> moves) {
    CheckedMove& checked = moves.front();
    const Move& move = *checked.move;
    const double radius = checked.radius();
    register_cutter(checked);
    follow_entry(moves);
    measure_overcut(checked);
    measure_holder(checked);
    if (checked.feeds() && checked.tool && is_conical(*checked.tool)) {
      measure_cone(checked);
    } else if (checked.low_z() < material_.z_top() - kResidual && radius > kResidual) {
      if (!checked.feeds()) {
        measure_rapid(checked);
      } else if (move.is_vertical()) {
        measure_plunge(checked);
      } else {
        measure_feed(checked);
      }
    }
    take_away(checked);
  }

  /// Runs a move measured by another task: gives the same state as measuring it.
  void pass_over(std::span<const CheckedMove> moves) {
    const CheckedMove& checked = moves.front();
    register_cutter(checked);
    follow_entry(moves);
    take_away(checked);
  }

 private:
  /// Sets the numbers of a move's cutter. Tools that leave material within their form, such as thread mills between the turns of a
  /// thread, meet it again where they were before.
  void register_cutter(const CheckedMove& checked) {
    cutter_ = own_ = stock::Material::kCylinder;
    if (!checked.tool) return;
    const stock::Removal removal = removal_of(checked);
    cutter_ = material_.add_cutter(removal.profile, removal.circle);
    if (removal.profile.widest > 0) own_ = cutter_;
  }

  void take_away(const CheckedMove& checked) {
    if (checked.radius() > 0 && checked.feeds()) {
      if (cutter_ == stock::Material::kCylinder) {
        material_.add(*checked.move, checked.radius());
      } else {
        material_.add_sweep(*checked.move, cutter_);
      }
    }
    before_ = checked.feeds() ? checked.move : nullptr;
    last_ = &checked;
  }

  /// Measures how deep the tip of a cone is in material.
  void measure_cone(CheckedMove& checked) {
    const Move& move = *checked.move;
    if (checked.low_z() >= material_.z_top() - kResidual) return;
    const double length = move.length();
    const int steps =
        move.is_vertical() ? 1 : std::max(1, static_cast<int>(std::ceil(length / kLongestStep)));
    for (int i = 0; i <= steps; ++i) measure_tip(checked, static_cast<double>(i) / steps);
    (checked.load.axial_mm > 0 ? checked.load.cutting_mm : checked.load.air_mm) += length;
    if (checked.load.axial_mm <= 0) checked.load.by_flank = cuts_by_flank(checked);
  }

  void measure_tip(CheckedMove& checked, double t) {
    const Move& move = *checked.move;
    const Vec2 p = move.is_vertical() ? move.path.from : move.path.at(t);
    const double z = move.is_vertical() ? checked.low_z() : move.z_from + (move.z_to - move.z_from) * t;
    const double axial = material_.height(p) - z;
    if (axial <= std::max(kResidual, checked.load.axial_mm)) return;
    checked.load.axial_mm = axial;
    checked.load.axial_at = {p, z, move.line};
  }

  /// Whether a cone whose tip is in the open touches material at some height of its flank.
  bool cuts_by_flank(const CheckedMove& checked) const {
    const double high = std::min(flank_height(*checked.tool), material_.z_top() - checked.low_z());
    for (const double share : {0.95, 0.6, 0.3}) {
      const double radius = std::max(radius_at(*checked.tool, share * high) - kSliver, 2 * kResidual);
      if (touched_above(checked, share * high, radius)) return true;
    }
    return false;
  }

  static int steps_of(double length, double radius) {
    return std::max(1, static_cast<int>(std::ceil(length / std::min(radius / 10, kLongestStep))));
  }

  void measure_feed(CheckedMove& checked) {
    const Move& move = *checked.move;
    const double length = move.length(), radius = checked.radius();
    const int steps = steps_of(length, radius);
    for (int i = 0; i < steps; ++i) measure_at(checked, (i + 0.5) / steps, length / steps);
    // Just after the start and at the end, too, because engagement is greatest at corners. Smoothly continuing moves
    // have no corner.
    if (!goes_smoothly_on(move)) measure_at(checked, std::min(0.01 / length, 0.25 / steps), 0);
    if (steps > 1) measure_at(checked, 1, 0);
    if (checked.slope() >= kAsPlunge) find_plunge_contact(checked, move.path.to);
  }

  void follow_entry(std::span<const CheckedMove> moves) {
    const CheckedMove& checked = moves.front();
    if (checked.tool != stated_for_) {
      stated_for_ = checked.tool;
      stated_ = stated_entry(part_, checked.tool);
      takes_ = checked.tool ? takes_of(*checked.tool, part_) : ToolTakes{};
    }
    entry_.follow(moves, stated_);
    if (entry_.begins()) entered_ = false;
    if (!entry_.asks_for_material() || !checked.feeds() || checked.radius() <= kSliver) return;
    const double low = checked.low_z() + kSliver;
    if (low < material_.z_top() && material_.in_reach(checked.move->path, checked.radius() - kSliver, low))
      entry_.meets_material(*checked.move);
  }

  void measure_overcut(CheckedMove& checked) const {
    if (!checked.tool) return;
    const double bottom = part_.stock ? part_.stock->z_bottom : -HUGE_VAL;
    if (const auto overcut = overcut_of(checked, takes_, material_, bottom)) checked.load.overcut = *overcut;
  }

  bool goes_smoothly_on(const Move& move) const {
    if (!before_ || before_->is_vertical() || before_->path.to != move.path.from) return false;
    return dot(direction_at(*before_, 1), direction_at(move, 0)) > kSmooth;
  }

  void measure_at(CheckedMove& checked, double t, double length) {
    const Move& move = *checked.move;
    const double z = move.z_from + (move.z_to - move.z_from) * t;
    if (z >= material_.z_top() - kResidual) return;
    const stock::CutterEngagement whole =
        material_.engagement(raised(move, kResidual), t, checked.radius() - kResidual, own_);
    MoveLoad& load = checked.load;
    if (options_.reference && whole.angle > 0)
      compare_with_reference(checked, t, {move.path.at(t), z, move.line});
    const double axial = whole.angle > 0 ? measure_axial(checked, move.path.at(t),
                                                         angle_of(direction_at(move, t)), z, whole.angles)
                                         : 0;
    if (entry_.is_inside()) measure_entry(checked, {whole, axial, length, {move.path.at(t), z, move.line}});
    const auto others = beside_entry(checked, t, z);
    if (others && others->angle <= 0) return;
    const stock::CutterEngagement& contact = others ? *others : whole;
    if (contact.angle <= 0) {
      load.air_mm += length;
      return;
    }
    const double angle = degrees(contact.angle);
    load.cutting_mm += length;
    load.angle_mm_deg += angle * length;
    load.classes.add(angle, length);
    if (options_.limit_deg && angle > *options_.limit_deg) load.over_limit_mm += length;
    if (options_.material)
      add_forces(checked, {contact, axial, length, {move.path.at(t), z, move.line}}, *options_.material);
    const double climb = climb_share(contact, checked.clockwise);
    load.climb_mm += length * climb;
    load.conventional_mm += length * (1 - climb);
    if (angle > load.max_deg) {
      load.max_deg = angle;
      load.max_at = {move.path.at(t), z, move.line};
    }
  }

  /// For mills that clear floors: entries, leads and links count, too. In material the cap applies to them as well.
  void compare_with_reference(CheckedMove& checked, double t, const Place& place) const {
    if (!mills_upright(*checked.tool) || checked.radius() <= kNoChip) return;
    const stock::CutterEngagement contact =
        material_.engagement(raised(*checked.move, kNoChip), t, checked.radius() - kNoChip, own_);
    if (contact.angle <= kGraze) return;
    const LoadReference& reference = *options_.reference;
    const double allowed = reference.feed(checked.workingstep, checked.tool_number) *
                           stock::load_at_feed_of_one(reference.rule.by, reference.rule.reference);
    if (allowed <= 0) return;
    const double feed = checked.move->feed.mm_per_min();
    const double load = feed * stock::load_at_feed_of_one(reference.rule.by, contact);
    const double of_cap = feed / reference.cap(checked.workingstep, checked.tool_number);
    keep_greatest(checked.load.reference, {load / allowed, place});
    if (of_cap > 1) keep_greatest(checked.load.reference, {of_cap, place});
  }

  static void keep_greatest(HeapOptional<ReferenceLoad>& kept, const ReferenceLoad& one) {
    if (!kept || one.share > kept->share) kept = one;
  }

  /// Measures an entry's contact with its own and with other material.
  void measure_entry(CheckedMove& checked, const CutSample& step) {
    if (step.contact.angle <= 0) return entry_.meets_nothing_at(checked.move->path, step.at.z);
    if (!checked.load.entry) checked.load.entry = EntryLoad{};
    EntryLoad& load = *checked.load.entry;
    load.begins = load.begins || !entered_;
    entered_ = true;
    load.length_mm += step.length;
    load.max_axial_mm = std::max(load.max_axial_mm, checked.load.axial_mm);
    const double angle = degrees(step.contact.angle);
    if (angle <= load.max_deg) return;
    load.max_deg = angle;
    load.max_at = step.at;
  }

  /// In an entry, the contact with material not belonging to it; nothing outside of entries, where all material
  /// counts.
  std::optional<stock::CutterEngagement> beside_entry(const CheckedMove& checked, double t, double z) const {
    if (!entry_.is_inside()) return std::nullopt;
    const double from = entry_.others_from(z);
    if (from >= material_.z_top() - kResidual) return stock::CutterEngagement{stock::AngleSet(0, 0), 0, 0, 0};
    return material_.engagement(raised(*checked.move, from - z), t, checked.radius() - kResidual);
  }

  /// 1 if the material is on the climb side, 0 if on the other, 1/2 in a slot.
  static double climb_share(const stock::CutterEngagement& contact, bool clockwise) {
    const double difference = clockwise ? contact.right - contact.left : contact.left - contact.right;
    if (std::abs(difference) < 0.01 * contact.angle) return 0.5;
    return difference > 0 ? 1 : 0;
  }

  /// mm; height of the material before the cutter, well inside its removed area, at this sample; updates the
  /// greatest of the move.
  double measure_axial(CheckedMove& checked, Vec2 center, double heading, double z,
                       const stock::AngleSet& contact) {
    const double inside = checked.radius() - kSliver;
    double here = 0;
    const bool may_be_more = z + checked.load.axial_mm + kResidual < material_.z_top();
    if (inside <= 0 || (!may_be_more && !options_.material)) return here;
    for (const stock::AngleInterval& item : contact.intervals()) {
      for (const double part : {0.1, 0.5, 0.9}) {
        const double angle = heading + item.from + part * item.width();
        const Vec2 p = center + direction_of(angle) * inside;
        measure_axial_at(checked, p, center, z);
        if (options_.material)
          here = std::max(here, std::min(material_.height(p, own_) - z, height_of_edges(*checked.tool)));
      }
    }
    return here;
  }

  void measure_axial_at(CheckedMove& checked, Vec2 p, Vec2 center, double z) {
    MoveLoad& load = checked.load;
    if (material_.is_removed(p, z + load.axial_mm + kResidual, own_)) return;
    const double axial = std::min(material_.height(p, own_) - z, height_of_edges(*checked.tool));
    if (axial <= load.axial_mm) return;
    load.axial_mm = axial;
    load.axial_at = {center, z, checked.move->line};
  }

  void measure_plunge(CheckedMove& checked) {
    const Move& move = *checked.move;
    if (move.z_to >= move.z_from) return;
    const Vec2 center = move.path.from;
    const double radius = checked.radius(), z = move.z_to;
    for (const double share : {0.0, 0.5, 1.0}) {
      for (int i = 0; i < 8; ++i) {
        const Vec2 p = center + direction_of(kPi / 4 * i) * (share * (radius - kSliver));
        measure_axial_at(checked, p, center, z);
      }
    }
    const auto hit = material_.in_reach(move.path, radius - kSliver, z + kResidual, own_);
    if (hit) measure_axial_at(checked, *hit, center, z);
    find_plunge_contact(checked, center);
  }

  /// For mills that may not plunge; for other tools their kind decides the permitted material below.
  void find_plunge_contact(CheckedMove& checked, Vec2 center) const {
    if (may_plunge(*checked.tool) || takes_.down < HUGE_VAL) return;
    const double z = checked.move->z_to;
    if (touches(*checked.tool, center, z)) checked.load.plunge_contact = Place{center, z, checked.move->line};
  }

  /// Whether material reaches into the cutter anywhere with its tip at z.
  bool touches(const Tool& tool, Vec2 center, double z) const {
    return hit_on(tool, Edge::line(center, center), z).has_value();
  }

  /// A place with material inside a cutter moving level with its tip at z.
  std::optional<Vec2> hit_on(const Tool& tool, const Edge& path, double z) const {
    return material_.in_reach(path, outer_profile(tool).narrowed(kResidual), z + kResidual);
  }

  /// Whether the cutter retracts from its last position with the same tool: since cutters never narrow upwards, it
  /// meets no new material.
  bool comes_out(const CheckedMove& checked) const {
    const Move& move = *checked.move;
    const Tool& tool = *checked.tool;
    return move.is_vertical() && move.z_to >= move.z_from && last_ != nullptr &&
           last_->tool == checked.tool && last_->move->path.to == move.path.from &&
           last_->move->z_to == move.z_from && inner_profile(tool) == outer_profile(tool) &&
           !outer_profile(tool).is_cylinder();
  }

  void measure_rapid(CheckedMove& checked) {
    const Move& move = *checked.move;
    if (comes_out(checked)) return;
    // A vertical rapid touches most at its lowest point.
    if (move.is_vertical()) {
      if (touches(*checked.tool, move.path.from, checked.low_z()))
        report_rapid(checked, move.path.from, checked.low_z());
      return;
    }
    if (move.z_from == move.z_to) {
      const auto hit = hit_on(*checked.tool, move.path, move.z_to);
      if (hit) report_rapid(checked, move.path.at(nearest(move.path, *hit).t), move.z_to);
      return;
    }
    const int steps = steps_of(move.path.length(), checked.radius());
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const double z = move.z_from + (move.z_to - move.z_from) * t;
      if (z >= material_.z_top() - kResidual) continue;
      if (touches(*checked.tool, move.path.at(t), z)) return report_rapid(checked, move.path.at(t), z);
    }
  }

  /// Tests shank and holder against the material before the move: at the lowest height of the path, in steps if it
  /// slopes.
  void measure_holder(CheckedMove& checked) {
    if (!checked.tool) return;
    const Tool& tool = *checked.tool;
    if (tool.stickout && tool.holder_diameter > 0)
      measure_above(checked, *tool.stickout, tool.holder_diameter / 2, false);
    if (tool.flute_length && (tool.shank_diameter > 2 * widest_radius(tool) || tool.kind == ToolKind::kTSlot))
      measure_above(checked, *tool.flute_length, tool.shank_diameter / 2, true);
    measure_flutes(checked);
  }

  /// mm; radius of the tool above its flutes that needs room: a stated neck of a mill has its own.
  static double radius_above_flutes(const Tool& tool) {
    const double widest = widest_radius(tool), shank = tool.shank_diameter / 2;
    return clears_floors(tool) && shank > 0 ? std::min(shank, widest) : widest;
  }

  /// Flutes need to reach only as high as material stands around the cutter: not over a wider hole or pocket that was
  /// cut before.
  void measure_flutes(CheckedMove& checked) const {
    const Tool& tool = *checked.tool;
    if (!checked.feeds() || !tool.flute_length) return;
    const auto touch = touched_above(checked, *tool.flute_length, radius_above_flutes(tool) + kClearOfWalls);
    if (!touch) return;
    checked.load.wall_beyond_flutes =
        WallBeyondFlutes{touch->at, material_.height(touch->material) - touch->at.z};
  }

  void measure_above(CheckedMove& checked, double above, double radius, bool is_shank) {
    if (checked.load.holder_contact) return;
    const auto touched = touched_above(checked, above, radius);
    if (!touched) return;
    checked.load.holder_contact = touched->at;
    checked.load.is_shank = is_shank;
  }

  struct Touch {
    Place at;       ///< of the tip
    Vec2 material;  ///< the point touched
  };

  /// The first place at which a cylinder beginning `above` the tip touches material.
  std::optional<Touch> touched_above(const CheckedMove& checked, double above, double radius) const {
    const Move& move = *checked.move;
    if (checked.low_z() + above >= material_.z_top() - kResidual) return std::nullopt;
    const bool is_one = move.is_vertical() || move.z_from == move.z_to;
    const int steps = is_one ? 1 : steps_of(move.path.length(), radius);
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 1.0) / steps;
      const double z = is_one ? checked.low_z() : move.z_from + (move.z_to - move.z_from) * t;
      const Vec2 at = move.is_vertical() ? move.path.from : move.path.at(t);
      const Edge way = is_one && !move.is_vertical() ? move.path : Edge::line(at, at);
      const auto hit = material_.in_reach(way, radius - kResidual, z + above + kResidual);
      if (!hit) continue;
      return Touch{{way.from == way.to ? at : nearest(way, *hit).point, z, move.line}, *hit};
    }
    return std::nullopt;
  }

  static void report_rapid(CheckedMove& checked, Vec2 center, double z) {
    checked.load.rapid_contact = Place{center, z, checked.move->line};
  }

  const Part& part_;
  stock::Material& material_;
  const LoadOptions& options_;
  const CheckedMove* last_ = nullptr;        ///< the move before the current one
  int cutter_ = stock::Material::kCylinder;  ///< number of the current cutter in the material
  /// The same where its earlier sweeps count with its circle.
  int own_ = stock::Material::kCylinder;
  const Move* before_ = nullptr;  ///< the last feed move before the current one
  EntryWatch entry_;
  const Tool* stated_for_ = nullptr;  ///< tool of the next two members
  StatedEntry stated_;
  ToolTakes takes_;
  bool entered_ = false;  ///< the entry has met material
};

/// mm; a height below every floor.
double bottom_of(const Part& part) {
  double bottom = part.top_z();
  for (const Feature& feature : part.features) bottom = std::min(bottom, feature.floor_z);
  return bottom - 1;
}

/// Least number of samples in a part of the program: each part must run all earlier moves again.
constexpr double kLeastSamples = 20000;
/// Greatest number of parts, and greatest length of path over all of them in cutter radii: each part keeps the
/// material of its own run, about half a kB for each radius of path.
constexpr int kMostParts = 4;
constexpr double kMostRadii = 6e5;

/// About how many samples a move is measured at.
std::size_t samples_of(const CheckedMove& checked, double top_z) {
  const bool sampled = checked.feeds() && checked.radius() > kResidual && checked.low_z() < top_z;
  const double step = std::min(checked.radius() / 10, kLongestStep);
  return 1 + (sampled ? static_cast<std::size_t>(checked.move->length() / step) : 0);
}

/// Measures the moves from `first` to before `last`, after running all before them.
void measure_moves(const Part& part, std::vector<CheckedMove>& moves, std::size_t first, std::size_t last,
                   const LoadOptions& options) {
  std::vector<double> radii;
  for (const CheckedMove& checked : moves) {
    if (checked.radius() > 0) radii.push_back(widest_radius(*checked.tool));
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
  LoadMeter meter(part, material, options);
  for (std::size_t i = 0; i < last; ++i) {
    throw_if_cancelled(options.cancel);
    if (!moves[i].counts_below(part.top_z())) continue;  // a hollow under material
    if (i < first || moves[i].is_carried()) {
      meter.pass_over(std::span(moves).subspan(i));
    } else {
      meter.measure(std::span(moves).subspan(i));
    }
    if (i >= first && options.meter) options.meter->add(samples_of(moves[i], part.top_z()));
  }
}

}  // namespace

std::size_t samples_of(const Part& part, const std::vector<CheckedMove>& moves) {
  std::size_t all = 0;
  for (const CheckedMove& checked : moves) all += samples_of(checked, part.top_z());
  return all;
}

void measure_load(const Part& part, std::vector<CheckedMove>& moves, const LoadOptions& options) {
  measure_moves(part, moves, 0, moves.size(), options);
}

std::vector<std::function<void()>> load_tasks(const Part& part, std::vector<CheckedMove>& moves,
                                              const LoadOptions& options, int threads) {
  double all = 0, radii = 0;
  for (const CheckedMove& checked : moves) {
    all += samples_of(checked, part.top_z());
    if (checked.feeds() && checked.radius() > kResidual) radii += checked.move->length() / checked.radius();
  }
  const double room = std::clamp(kMostRadii / std::max(radii, 1.0), 1.0, double{kMostParts});
  const int most = std::clamp(threads, 1, static_cast<int>(room));
  const int parts = std::clamp(static_cast<int>(all / kLeastSamples), 1, most);
  std::vector<std::function<void()>> tasks;
  double before = 0;
  for (std::size_t first = 0, last = 0; last < moves.size(); first = last) {
    const double until = all * (static_cast<double>(tasks.size()) + 1) / parts;
    // A part begins with a rapid: the material met by an entry is known only if the whole entry is measured.
    while (last < moves.size() && (last == first || before < until || moves[last].feeds()))
      before += samples_of(moves[last++], part.top_z());
    if (static_cast<int>(tasks.size()) + 1 == parts) last = moves.size();
    tasks.push_back(
        [&part, &moves, options, first, last] { measure_moves(part, moves, first, last, options); });
  }
  return tasks;
}

}  // namespace clearcut::verify
