#include "resolve/values/cutting_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/text.h"
#include "features/round_hole.h"
#include "model/work_material.h"

namespace clearcut::resolve {
namespace {

ToolCutting stated_for(int tool, const PlanOptions& options) {
  const auto index = static_cast<std::size_t>(tool);
  return index < options.tool_cutting.size() ? options.tool_cutting[index] : ToolCutting{};
}

/// Cutting data of a tool in the part's own operations.
ToolCutting used_with(int tool, const Part& part) {
  const auto step = std::find_if(part.workplan.begin(), part.workplan.end(),
                                 [&](const Workingstep& one) { return one.operation.tool == tool; });
  if (step == part.workplan.end()) return {};
  return {true, step->operation.cutting, step->operation.stepdown, step->operation.stepover};
}

template <typename Value>
void set_if(std::optional<Value>& target, const std::optional<Value>& value) {
  if (value) target = value;
}

template <typename Value>
void drop_if_same(std::optional<Value>& target, const std::optional<Value>& value) {
  if (value && target == value) target.reset();
}

void take(Operation& operation, const ToolCutting& tool) {
  if (!tool.stated) return;
  CuttingData& cutting = operation.cutting;
  set_if(cutting.feed, tool.cutting.feed);
  set_if(cutting.plunge_feed, tool.cutting.plunge_feed);
  set_if(cutting.ramp_feed, tool.cutting.ramp_feed);
  set_if(cutting.slot_feed, tool.cutting.slot_feed);
  set_if(cutting.spindle_rpm, tool.cutting.spindle_rpm);
  cutting.spindle_clockwise = tool.cutting.spindle_clockwise;
  set_if(cutting.coolant, tool.cutting.coolant);
  set_if(operation.stepdown, tool.stepdown);
  set_if(operation.stepover, tool.stepover);
}

/// Removes the values of `tool`, unless another source stated them.
void take_back(Operation& operation, const ToolCutting& tool) {
  if (!tool.stated) return;
  CuttingData& cutting = operation.cutting;
  drop_if_same(cutting.feed, tool.cutting.feed);
  drop_if_same(cutting.plunge_feed, tool.cutting.plunge_feed);
  drop_if_same(cutting.ramp_feed, tool.cutting.ramp_feed);
  drop_if_same(cutting.slot_feed, tool.cutting.slot_feed);
  drop_if_same(cutting.spindle_rpm, tool.cutting.spindle_rpm);
  if (cutting.spindle_clockwise == tool.cutting.spindle_clockwise) cutting.spindle_clockwise = true;
  drop_if_same(cutting.coolant, tool.cutting.coolant);
  drop_if_same(operation.stepdown, tool.stepdown);
  drop_if_same(operation.stepover, tool.stepover);
}

/// Values requested for all operations, on the command line or by [plan] of a job, take precedence over a tool's
/// values.
ToolCutting without_what_is_asked(ToolCutting tool, const PlanOptions& options) {
  const auto drop = [&](auto& value, const auto& asked, const char* name) {
    if (asked || options.sources.find(name)) value.reset();
  };
  drop(tool.cutting.feed, options.cutting.feed, "feed");
  drop(tool.cutting.plunge_feed, options.cutting.plunge_feed, "plunge-feed");
  drop(tool.cutting.ramp_feed, options.cutting.ramp_feed, "ramp-feed");
  drop(tool.cutting.slot_feed, options.cutting.slot_feed, "slot-feed");
  drop(tool.cutting.spindle_rpm, options.cutting.spindle_rpm, "spindle");
  drop(tool.cutting.coolant, options.cutting.coolant, "coolant");
  drop(tool.stepdown, options.stepdown, "stepdown");
  return tool;
}

}  // namespace

void take_tool_cutting(Operation& operation, const PlanOptions& options) {
  take(operation, without_what_is_asked(stated_for(operation.tool, options), options));
}

void change_tool(Operation& operation, int tool, const Part& part, const PlanOptions& options) {
  ToolCutting before = stated_for(operation.tool, options), after = stated_for(tool, options);
  const bool own_tools = options.tools.empty();
  if (!after.stated && own_tools) after = used_with(tool, part);
  if (!before.stated && own_tools && after.stated) before = used_with(operation.tool, part);
  take_back(operation, without_what_is_asked(before, options));
  operation.tool = tool;
  take(operation, without_what_is_asked(after, options));
}

// Symbols
//
//   v_c   cutting speed, m/min                      n = 1000 v_c / (pi D)
//   f_z   feed per tooth, mm; of drills per turn    v_f = f_z z n
//   k_c   specific force, N/mm2                     k_c1.1 h^-m_c [kienzle1957], h the mean chip, mm
//   A     section of the cut, mm2                   P = k_c A v_f / 60000 W
//   F     force along the circumference, N          F = P 60 / v_c
//   L, E, I  the cutter as a beam from its holder   bend = F L^3 / (3 E I), I of 0.8 of the diameter

namespace {

// Rules of docs/feeds.md. Coated edges run a fifth faster; high-speed steel runs at half the speed of carbide.
constexpr double kCarbide = 2, kCoating = 1.2;
constexpr double kReamingShare = 2.0 / 3, kTappingShare = 0.4;  // share of the drill's speed
constexpr double kReamingFeed = 0.05;                           // mm a tooth
constexpr double kFlatHoleShare = 0.5;  // share of the drill's feed per turn: counterbores, boring bars
constexpr double kConeShare = 0.5;      // share of a cone's diameter for which its feed is taken
constexpr double kThreadShare =
    0.25;  // share of a mill's feed: small teeth, and the programmed circle is the smaller one
constexpr double kMostTapping = 15;  // m/min
constexpr double kPlungeShare = 0.3;
/// Usable share of the stated power and torque.
constexpr double kPowerShare = 0.8;
constexpr double kMostThinning = 2;
/// A stated value this many times above or below is reported.
constexpr double kFarOff = 2;
/// Share of the feed used for slots on weak machines.
constexpr double kSlotShare = 0.7;
/// Chips of router bits are stated for cuts as deep as the cutter is wide; deeper ones take a quarter less for each
/// diameter.
constexpr double kDeeperShare = 0.25, kLeastDepthShare = 0.5;
/// mm; permitted deflection of a cutter's tip in roughing; share of the diameter that is its core.
constexpr double kMostBend = 0.05, kCore = 0.8;
constexpr double kCarbideElasticity = 600000, kSteelElasticity = 210000;  // N/mm2

double at_diameter(const std::array<double, 4>& feeds, double diameter) {
  if (diameter <= kFeedDiameters.front()) return feeds.front() * diameter / kFeedDiameters.front();
  for (std::size_t i = 1; i < feeds.size(); ++i) {
    if (diameter > kFeedDiameters[i]) continue;
    const double t = (diameter - kFeedDiameters[i - 1]) / (kFeedDiameters[i] - kFeedDiameters[i - 1]);
    return std::lerp(feeds[i - 1], feeds[i], t);
  }
  return feeds.back();
}

struct Suggestion {
  double speed = 0;  ///< m/min
  double tooth = 0;  ///< mm per tooth; per turn if `teeth` is 1
  double teeth = 1;
};

/// Values for tools with vertical moves only: high-speed steel unless the tool states carbide.
Suggestion of_hole_tool(const WorkMaterial& work, const Tool& tool) {
  const bool carbide = tool.high_speed_steel == false;
  Suggestion out{work.drill_speed * (carbide ? kCarbide : 1), at_diameter(work.drill_feed, tool.diameter), 1};
  if (tool.kind == ToolKind::kTap) return {std::min(out.speed * kTappingShare, kMostTapping), tool.pitch, 1};
  if (tool.kind == ToolKind::kSpotDrill) out.tooth = at_diameter(work.drill_feed, tool.diameter * kConeShare);
  if (tool.kind == ToolKind::kDrill || tool.kind == ToolKind::kSpotDrill) return out;
  out.speed *= kReamingShare;
  if (tool.kind == ToolKind::kReamer) return {out.speed, kReamingFeed, static_cast<double>(tool.teeth)};
  out.tooth *= kFlatHoleShare;
  return out;
}

/// mm; the cutting diameter: for a cone, that of the circle at the top of its cut.
double cutting_diameter(const Tool& tool, double depth) {
  if (!is_conical(tool) || !(depth > 0)) return 2 * widest_radius(tool);
  return std::min(2 * widest_radius(tool), 2 * radius_at(tool, depth));
}

/// Whether chips for light machines are used: if stated, or, without a statement, in woods and plastics, because
/// users who cut these on stiff machines state that.
bool takes_hobby_chips(const WorkMaterial& work, const Machine& machine) {
  if (machine.stiffness == MachineStiffness::kUnknown) return !work.has_forces();
  return machine.stiffness == MachineStiffness::kHobby;
}

/// Factor on the chip in cuts deeper than the cutter's width, in woods and plastics.
double share_at_depth(const WorkMaterial& work, double depth, double diameter) {
  if (work.has_forces() || depth <= diameter) return 1;
  return std::max(kLeastDepthShare, 1 - kDeeperShare * (depth / diameter - 1));
}

/// Values for mills: carbide unless the tool states high-speed steel.
Suggestion of_mill(const WorkMaterial& work, const Tool& tool, const Machine& machine, double depth) {
  const double diameter = cutting_diameter(tool, depth);
  const auto& feeds = takes_hobby_chips(work, machine) ? work.hobby_feed : work.mill_feed;
  Suggestion out{work.mill_speed,
                 at_diameter(feeds, is_conical(tool) ? diameter * kConeShare : tool.diameter),
                 static_cast<double>(tool.teeth)};
  if (!is_conical(tool)) out.tooth *= share_at_depth(work, depth, diameter);
  if (tool.high_speed_steel.value_or(false)) out.speed /= kCarbide;
  if (tool.kind == ToolKind::kThreadMill) out.tooth *= kThreadShare;
  return out;
}

Suggestion suggestion_for(const WorkMaterial& work, const Tool& tool, const Machine& machine, double depth) {
  Suggestion out = is_driven_down(tool) ? of_hole_tool(work, tool) : of_mill(work, tool, machine, depth);
  if (tool.coated) out.speed *= kCoating;
  return out;
}

/// Ratio of the chip's thickness to the feed per tooth for an engagement of less than a quarter turn.
double thinning(const std::optional<double>& engagement_deg) {
  if (!engagement_deg || *engagement_deg >= 90) return 1;
  return std::min(kMostThinning, 1 / base::sin(*engagement_deg * kPi / 180));
}

/// W; permitted power of a cut at `rpm`; absent if the machine does not state it.
std::optional<double> allowed_power(const Machine& machine, double rpm) {
  std::optional<double> most;
  if (machine.spindle_power_w) most = kPowerShare * *machine.spindle_power_w;
  if (machine.spindle_torque_nm) {
    const double by_torque = kPowerShare * *machine.spindle_torque_nm * 2 * kPi * rpm / 60;
    most = most ? std::min(*most, by_torque) : by_torque;
  }
  return most;
}

/// mm/min; the feed at which a cut of `section` mm2 takes `power`, its mean chip being `chip` times the feed.
/// P = k h^-m A v / 60000 with h = chip v gives v^(1 - m) = 60000 P chip^m / (k A); in woods and plastics the
/// specific energy is the same for every chip.
double feed_at_power(const WorkMaterial& work, double power, double section, double chip) {
  if (!work.has_forces()) return power * 60000 / (work.specific_energy * section);
  return base::pow(power * 60000 * base::pow(chip, work.mc) / (work.kc11 * section), 1 / (1 - work.mc));
}

/// N; lateral force that bends the cutter by the permitted deflection; absent if its holder is not known.
std::optional<double> bending_force(const Tool& tool) {
  if (!tool.stickout || !(*tool.stickout > 0)) return std::nullopt;
  const double core = kCore * tool.diameter;
  const double inertia = kPi * core * core * core * core / 64;
  const double elasticity = tool.high_speed_steel.value_or(false) ? kSteelElasticity : kCarbideElasticity;
  const double length = *tool.stickout;
  return 3 * elasticity * inertia * kMostBend / (length * length * length);
}

/// mm/min; upper limit of a cut's feed, and its origin.
struct FeedLimit {
  double most = HUGE_VAL;
  const char* by = "";
};

/// Limit of the machine: its greatest stated feed, and the slower rapid of X and Y.
FeedLimit feed_limit(const Machine& machine) {
  const AxisValues speeds = axis_speeds(machine);
  FeedLimit limit{std::min(speeds[0], speeds[1]), "the machine's rapid"};
  if (machine.max_feed && machine.max_feed->mm_per_min() <= limit.most)
    limit = {machine.max_feed->mm_per_min(), "the machine's max_feed"};
  return limit;
}

class Filler {
 public:
  Filler(Operation& operation, const Tool& tool, const WorkMaterial& work, const PlanOptions& options,
         Sources& sources)
      : operation_(operation), tool_(tool), work_(work), options_(options), sources_(sources) {}

  FilledValues fill(const Suggestion& start, double depth) {
    fill_speed(start, depth);
    if (tool_.kind != ToolKind::kTap) fill_feed(start, depth);
    return std::move(told_);
  }

 private:
  struct Limit {
    double most;
    const char* by;
  };

  Limit most_rpm() const {
    Limit limit{options_.machine.max_spindle_rpm.value_or(kUsualTopRpm), options_.machine.max_spindle_rpm
                                                                             ? "the machine's max_spindle"
                                                                             : "where no machine is stated"};
    if (tool_.max_spindle_rpm && *tool_.max_spindle_rpm < limit.most)
      limit = {*tool_.max_spindle_rpm, "the tool's max_spindle"};
    return limit;
  }

  /// rpm; if the machine's feed is the limit, routers turn more slowly, because thin chips burn wood and melt
  /// plastics.
  double slowed(double rpm, const Suggestion& start, std::string& why) const {
    if (is_driven_down(tool_) || work_.has_forces()) return rpm;
    const FeedLimit limit = feed_limit(options_.machine);
    const double kept = limit.most / (start.tooth * start.teeth * thinning(options_.engagement_deg));
    if (kept >= rpm) return rpm;
    why += fmt::format(", slower so that {} keeps the chip", limit.by);
    return kept;
  }

  void fill_speed(const Suggestion& start, double depth) {
    const double circle = is_driven_down(tool_) ? 2 * widest_radius(tool_) : cutting_diameter(tool_, depth);
    const double wanted = start.speed * 1000 / (kPi * circle);
    const Limit top = most_rpm();
    double rpm = std::min(wanted, top.most);
    std::string why = fmt::format("{}: {} m/min", work_.name, trimmed(start.speed, 1));
    if (wanted > top.most) why += fmt::format(", no more than {} rpm, {}", trimmed(top.most, 0), top.by);
    rpm = slowed(rpm, start, why);
    if (rpm >= 100) rpm = std::floor(rpm / 10) * 10;
    const double least = std::min(options_.machine.min_spindle_rpm.value_or(0), top.most);
    // A tap is no mill: a tap far above its speed breaks, so it keeps the required speed, and is refused if its feed
    // is tied to the speed.
    const bool breaks = tool_.kind == ToolKind::kTap && least > kFarOff * wanted;
    const bool is_too_slow = rpm < least && !breaks;
    if (is_too_slow) {
      rpm = least;
      why += fmt::format(", no less than {} rpm, the machine's min_spindle", trimmed(least, 0));
    }
    std::optional<double>& stated = operation_.cutting.spindle_rpm;
    if (stated) {
      check_stated("spindle", *stated, std::max(wanted, rpm), std::min(wanted, rpm), "rpm");
      return;
    }
    stated = std::max(rpm, std::min(1.0, top.most));
    say("spindle", why, trimmed(*stated, 3) + " rpm");
    if (is_too_slow && *stated > kFarOff * wanted)
      told_.warnings.push_back(
          fmt::format("the spindle turns no slower than {} rpm, and {} with T{} asks for {}",
                      trimmed(least, 0), work_.name, tool_.number, trimmed(wanted, 0)));
  }

  /// Section of a cut at full width and stepdown; tools with vertical moves only cut their own circle.
  double section(double depth) const {
    if (is_driven_down(tool_)) return kPi * tool_.diameter * tool_.diameter / 4;
    return is_conical(tool_) ? depth * cutting_diameter(tool_, depth) / 2 : depth * tool_.diameter;
  }

  void limit_by_power(double& feed, const Suggestion& start, double depth, std::string& why) const {
    const double rpm = *operation_.cutting.spindle_rpm;
    if (!(depth > 0) || (!work_.has_forces() && !(work_.specific_energy > 0))) return;
    // Mean chip of a slot: 2 / pi of the feed a tooth; of a drill half the feed a turn across its two edges.
    const double chip = (is_driven_down(tool_) ? 0.5 : 2 / kPi) / (start.teeth * rpm);
    const auto keep_below = [&](std::optional<double> power, const char* by) {
      if (!power) return;
      const double most = feed_at_power(work_, *power, section(depth), chip);
      if (feed <= most) return;
      feed = most;
      why += fmt::format(", no more than {}", by);
    };
    keep_below(allowed_power(options_.machine, rpm), "80 % of the spindle's power");
    if (is_driven_down(tool_)) return;
    // A force along the circumference takes its speed as power.
    const double speed = kPi * cutting_diameter(tool_, depth) * rpm / 60000;  // m/s
    const auto power_of = [&](std::optional<double> force) {
      return force ? std::optional<double>(*force * speed) : std::nullopt;
    };
    keep_below(power_of(options_.machine.cutting_force_n), "the force that the machine bears");
    keep_below(power_of(bending_force(tool_)), "what bends the cutter by 0.05 mm");
  }

  void fill_feed(const Suggestion& start, double depth) {
    CuttingData& cutting = operation_.cutting;
    const double thin = is_driven_down(tool_) ? 1 : thinning(options_.engagement_deg);
    const double wanted = start.tooth * thin * start.teeth * *cutting.spindle_rpm;
    double feed = wanted;
    std::string why = fmt::format("{}: {} mm a {}", work_.name, trimmed(start.tooth, 4),
                                  is_driven_down(tool_) && start.teeth == 1 ? "turn" : "tooth");
    if (thin > 1) why += fmt::format(" and {} times that for thin chips", trimmed(thin, 2));
    limit_by_power(feed, start, depth, why);
    const FeedLimit limit = feed_limit(options_.machine);
    if (feed > limit.most) {
      feed = limit.most;
      why += fmt::format(", no more than {}", limit.by);
    }
    if (feed >= 20) feed = std::floor(feed);
    take_feed(feed, wanted, why);
    fill_slot_feed(wanted);
  }

  /// Chip loads of light machines are meant for half the width: slots get less. A feed already reduced as far by
  /// another limit is unchanged.
  void fill_slot_feed(double wanted) {
    CuttingData& cutting = operation_.cutting;
    if (is_driven_down(tool_) || !clears_floors(tool_) || cutting.slot_feed) return;
    if (!takes_hobby_chips(work_, options_.machine) || options_.shop.feed_by) return;
    const double slot = std::floor(kSlotShare * wanted);
    const Source* of_feed = sources_.find("feed");
    if (!of_feed || of_feed->origin != Origin::kDerived || !(slot < cutting.feed->mm_per_min())) return;
    cutting.slot_feed = MmPerMin::of(slot);
    sources_.set("slot-feed",
                 {Origin::kDerived, fmt::format("70 % of {}'s feed, all round (docs/feeds.md)", work_.name)});
  }

  void take_feed(double feed, double wanted, const std::string& why) {
    CuttingData& cutting = operation_.cutting;
    // Tools with vertical moves only have one feed, which may be stated as either of the two.
    std::optional<MmPerMin>& own =
        is_driven_down(tool_) && cutting.plunge_feed ? cutting.plunge_feed : cutting.feed;
    if (own) check_stated("feed", own->mm_per_min(), wanted, feed, "mm/min");
    if (!cutting.feed) {
      cutting.feed = MmPerMin::of(feed);
      say("feed", why, trimmed(feed, 3) + " mm/min");
    }
    if (cutting.plunge_feed) return;
    cutting.plunge_feed = is_driven_down(tool_) ? *cutting.feed : *cutting.feed * kPlungeShare;
    std::string down = is_driven_down(tool_) ? "the feed" : "30 % of the feed";
    const MmPerMin z_rapid = MmPerMin::of(axis_speeds(options_.machine)[2]);
    if (*cutting.plunge_feed > z_rapid) {
      cutting.plunge_feed = z_rapid;
      down += ", no more than the machine's rapid";
    }
    sources_.set("plunge-feed", {Origin::kDerived, down});
  }

  /// `wanted`: the table's value; `limited`: the value permitted by machine and tool.
  void check_stated(const char* name, double stated, double wanted, double limited, const char* unit) {
    if (stated <= kFarOff * wanted && stated >= limited / kFarOff) return;
    told_.warnings.push_back(
        fmt::format("the {} of T{} is stated as {} {}, and {} usually takes about {}; the stated value is "
                    "used (docs/feeds.md)",
                    name, tool_.number, trimmed(stated, 0), unit, work_.name,
                    trimmed(stated > kFarOff * wanted ? wanted : limited, 0)));
  }

  void say(const char* name, const std::string& why, const std::string& value) {
    told_.filled.push_back(fmt::format("{} {} for {}", name, value, work_.name));
    sources_.set(name, {Origin::kDerived, why + " (docs/feeds.md)"});
  }

  Operation& operation_;
  const Tool& tool_;
  const WorkMaterial& work_;
  const PlanOptions& options_;
  Sources& sources_;
  FilledValues told_;
};

}  // namespace

FilledValues fill_cutting_values(Operation& operation, const Tool& tool, double depth,
                                 const std::string& material, const PlanOptions& options, Sources& sources) {
  const auto work = work_material_named(material);
  if (!work || !(tool.diameter > 0)) return {};
  return Filler(operation, tool, *work, options, sources)
      .fill(suggestion_for(*work, tool, options.machine, depth), depth);
}

}  // namespace clearcut::resolve
