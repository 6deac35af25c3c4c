#include "read/stepnc/operation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "read/stepnc/file/entity_list.h"
#include "read/stepnc/toolpaths.h"

namespace clearcut::read::stepnc {

namespace {

constexpr double kSameHole = 0.05;  // mm

template <class Wanted>
std::vector<std::size_t> those(const std::vector<const Draft*>& parts, const Wanted& wanted) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (wanted(*parts[i])) chosen.push_back(i);
  return chosen;
}

bool lists(const Draft& part, const Node& operation) {
  const std::vector<Node> own = part.node.refs(2);
  return std::any_of(own.begin(), own.end(), [&](const Node& node) { return node.id() == operation.id(); });
}

}  // namespace

bool goes_straight_down(const Operation& operation) {
  return operation.kind == OperationKind::kDrilling || operation.kind == OperationKind::kReaming;
}

std::vector<std::size_t> parts_for(const std::vector<const Draft*>& parts, const Node& node,
                                   const Operation& operation, const Tool& tool) {
  std::vector<std::size_t> all(parts.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (parts.size() == 1) return all;
  std::vector<std::size_t> chosen = those(parts, [&](const Draft& part) { return lists(part, node); });
  if (!chosen.empty()) return chosen;
  if (goes_straight_down(operation))
    chosen = those(parts, [&](const Draft& part) {
      return part.hole_diameter && std::abs(*part.hole_diameter - tool.diameter) < kSameHole;
    });
  if (!chosen.empty()) return chosen;
  chosen = those(parts, [&](const Draft& part) {
    if (!part.hole_diameter) return !goes_straight_down(operation);
    return *part.hole_diameter > tool.diameter - kSameHole;
  });
  return chosen.empty() ? all : chosen;
}

namespace {

constexpr double kFastestCut = 20;  // m/s; cutting speeds above this are m/min
constexpr double kFastestFeed = 2;  // m/s; feeds above this are mm/min

struct OperationEntity {
  std::string_view keyword;
  OperationKind kind;
  HoleKind hole = HoleKind::kDrilled;
};
constexpr OperationEntity kOperations[] = {
    {"PLANE_MILLING", OperationKind::kRoughing},
    {"PLANE_ROUGH_MILLING", OperationKind::kRoughing},
    {"PLANE_FINISH_MILLING", OperationKind::kBottomFinishing},
    {"SIDE_MILLING", OperationKind::kRoughing},
    {"SIDE_ROUGH_MILLING", OperationKind::kRoughing},
    {"SIDE_FINISH_MILLING", OperationKind::kSideFinishing},
    {"BOTTOM_AND_SIDE_MILLING", OperationKind::kRoughing},
    {"BOTTOM_AND_SIDE_ROUGH_MILLING", OperationKind::kRoughing},
    {"BOTTOM_AND_SIDE_FINISH_MILLING", OperationKind::kFinishing},
    {"FREEFORM_OPERATION", OperationKind::kRoughing},
    {"DRILLING", OperationKind::kDrilling},
    {"MULTISTEP_DRILLING", OperationKind::kDrilling},
    {"CENTER_DRILLING", OperationKind::kDrilling, HoleKind::kSpotted},
    {"COUNTER_SINKING", OperationKind::kDrilling, HoleKind::kCountersunk},
    {"BORING", OperationKind::kReaming, HoleKind::kBored},
    {"REAMING", OperationKind::kReaming, HoleKind::kReamed},
    {"TAPPING", OperationKind::kDrilling, HoleKind::kTapped}};

const OperationEntity& row_of_operation(const Node& node) {
  for (const OperationEntity& entry : kOperations)
    if (node.is(entry.keyword)) return entry;
  refuse_listed(node);
  node.fail(
      "operations of this kind cannot be machined yet; give plane, side or bottom-and-side milling, or "
      "drilling");
}

void read_spindle(const Node& technology, const Tool& tool, bool left_handed, CuttingData& cutting,
                  Context& context) {
  const auto spindle = technology.number(3);
  if (left_handed && spindle && *spindle < 0)
    context.diagnostics.doubt(context.file.place(technology.line()), kNotFollowed,
                              technology.label() +
                                  ": its spindle turns clockwise, and the cutter is left-handed "
                                  "(hand_of_cut): it would turn backwards");
  if (spindle && *spindle != 0) {
    if (context.spindle_rpm)
      context.note("spindle speeds are read as rpm: some are too fast for 1/s", technology);
    cutting.spindle_rpm = std::abs(*spindle) * (context.spindle_rpm ? 1 : 60);
    cutting.spindle_clockwise = !(left_handed && *spindle > 0);
    return;
  }
  const auto speed = technology.number(2);
  if (!speed || *speed <= 0) {
    context.note("no spindle speed; the planner's default is used", technology);
    return;
  }
  const bool per_minute = !context.standard_units && *speed > kFastestCut;
  if (per_minute) context.note("the cutting speed is read as m/min: it is too fast for m/s", technology);
  const double m_per_min = *speed * (per_minute ? 1 : 60);
  cutting.spindle_rpm = m_per_min * 1000 / (kPi * tool.diameter);
}

void read_feed(const Node& technology, const Tool& tool, CuttingData& cutting, Context& context) {
  const auto feed = feed_of_technology(technology, context);
  const auto per_tooth = technology.length(4);
  if (feed) {
    cutting.feed = feed;
  } else if (per_tooth && *per_tooth > 0 && cutting.spindle_rpm) {
    cutting.feed = MmPerMin::of(*per_tooth * tool.teeth * *cutting.spindle_rpm);
  } else {
    context.note("no feed; the planner's default is used", technology);
  }
}

/// Extra data in its place for property parameters: argument 10 of the machine functions.
void read_properties(const Node& functions, Operation& operation, Context& context) {
  for (const Node& property : functions.refs(9)) {
    const std::string name = property.text(0);
    const auto number = property.is("NUMERIC_PARAMETER") ? property.number(1) : std::nullopt;
    if (!number || *number <= 0) {
      if (name == "CUT DIRECTION")
        operation.direction =
            property.text(1) == "CLIMB" ? CutDirection::kClimb : CutDirection::kConventional;
      else
        context.warn("not followed: " + name + " " + property.shown(1), property);
      continue;
    }
    const bool known = name == "PLUNGE FEED" || name == "RAMP FEED" || name == "SLOT FEED" ||
                       name == "SCALLOP HEIGHT" || name == "STEPOVER";
    if (!known) context.warn("not followed: " + name + " " + property.shown(1), property);
    if (name == "PLUNGE FEED") operation.cutting.plunge_feed = MmPerMin::of(*number);
    if (name == "RAMP FEED") operation.cutting.ramp_feed = MmPerMin::of(*number);
    if (name == "SLOT FEED") operation.cutting.slot_feed = MmPerMin::of(*number);
    if (name == "SCALLOP HEIGHT") operation.scallop = *number;
    if (name == "STEPOVER") operation.stepover = *number;
  }
}

/// Values that say what is done anyway.
void use_what_is_usual(const Node& technology) {
  if (technology.peek(1).kind == P21Kind::kEnum && technology.peek(1).text == "TCP") technology.use(1);
}

void read_cutting(const Node& node, const Tool& tool, Hand hand, Operation& operation, Context& context) {
  const bool left_handed = hand == Hand::kLeft;
  operation.cutting.spindle_clockwise = !left_handed;
  if (const auto technology = node.ref(6)) {
    use_what_is_usual(*technology);
    read_spindle(*technology, tool, left_handed, operation.cutting, context);
    read_feed(*technology, tool, operation.cutting, context);
  } else {
    context.note("no technology; the planner's default feed and speed are used", node);
  }
  if (const auto functions = node.ref(7)) {
    const bool flood = functions->flag(0) == true;
    const bool through_tool = functions->flag(3) == true;
    if (through_tool)
      context.warn(std::string("coolant through the spindle") + (flood ? "" : " alone") +
                       " is switched on as flood; a word of the machine's own may be needed",
                   *functions);
    const Coolant coolant = coolant_of(flood || through_tool, functions->flag(2) == true);
    if (coolant != Coolant::kOff) operation.cutting.coolant = coolant;
    read_properties(*functions, operation, context);
  }
}

std::optional<double> positive(std::optional<double> value) {
  return value && *value > 0 ? value : std::nullopt;
}

/// An angle of a way into or out of the material, where it is stated.
std::optional<Radians> path_angle(const Node& strategy, std::size_t argument, const Context& context) {
  const auto angle = strategy.number(argument);
  return angle && *angle > 0 ? std::optional(Radians::of(context.draft_angle(*angle))) : std::nullopt;
}

/// Leads of passes along walls; ours are the same on the way in and out. False for other strategies.
bool read_lead(const Node& strategy, Operation& operation, const Context& context) {
  if (strategy.is("AP_RETRACT_TANGENT")) {
    operation.lead = positive(strategy.length(1));
  } else if (strategy.is("AP_RETRACT_ANGLE")) {
    operation.lead_angle = path_angle(strategy, 1, context);
    operation.lead = positive(strategy.length(2));
  } else {
    return false;
  }
  return true;
}

void set_entry(Operation& operation, EntryKind kind, std::optional<Radians> angle,
               std::optional<double> size) {
  operation.entry = kind;
  operation.entry_angle = angle;
  operation.entry_size = size;
}

void read_approach(const Node& node, Operation& operation, Context& context) {
  const auto approach = node.ref(9);
  if (!approach || read_lead(*approach, operation, context)) return;
  if (approach->is("PLUNGE_TOOLAXIS")) {
    set_entry(operation, EntryKind::kPlunge, std::nullopt, std::nullopt);
  } else if (approach->is("PLUNGE_RAMP")) {
    set_entry(operation, EntryKind::kRamp, path_angle(*approach, 1, context), std::nullopt);
  } else if (approach->is("PLUNGE_HELIX")) {
    set_entry(operation, EntryKind::kHelix, path_angle(*approach, 2, context), positive(approach->length(1)));
  } else if (approach->is("PLUNGE_ZIGZAG")) {
    set_entry(operation, EntryKind::kZigzagRamp, path_angle(*approach, 1, context),
              positive(approach->length(2)));
  } else if (approach->is("AP_LIFT_PATH_ANGLE")) {
    set_entry(operation, EntryKind::kRamp, path_angle(*approach, 1, context), std::nullopt);
  } else if (approach->is("AP_LIFT_PATH_TANGENT")) {
    operation.entry = EntryKind::kRamp;
    context.note("an approach that comes down in an arc is made a ramp", *approach);
  } else {
    context.said(*approach);
    context.note("an approach of this kind is not used; the planner chooses the entry", *approach);
  }
}

/// What the approach says of leads goes before what the retract says. Any other way up is straight up, which is named where another is asked for.
void read_retract(const Node& node, Operation& operation, Context& context) {
  const auto retract = node.ref(10);
  if (!retract) return;
  if (operation.lead) {
    context.said(*retract);
    return context.note("the lead of the approach goes before what its retract says: " + node.shown(10),
                        *retract);
  }
  if (read_lead(*retract, operation, context)) return;
  context.said(*retract);
  if (!retract->is("PLUNGE_TOOLAXIS"))
    context.note("a retract of this kind is not used; the cutter is lifted straight up: " + node.shown(10),
                 *retract);
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Parallel strokes: their direction; what else is stated of them is left to the planner, by name.
void read_strokes(const Node& strategy, Operation& operation, Context& context) {
  if (const auto direction = strategy.sound_ref(2)) {
    const Vec3 along = axis_of(*direction);
    if (along.x != 0 || along.y != 0) operation.feed_direction = Radians::of(base::atan2(along.y, along.x));
  }
  if (strategy.is_any("UNIDIRECTIONAL_MILLING", "UNIDIRECTIONAL"))
    return context.note("strokes in one direction alone are not made; they are cut to and fro", strategy);
  const std::string connection = strategy.enumeration(4);
  if (strategy.is_any("BIDIRECTIONAL_MILLING", "BIDIRECTIONAL") && !connection.empty() &&
      connection != "STRAIGHTLINE")
    context.note("the stroke connection " + connection +
                     " is not used; strokes are joined straight or along the walls",
                 strategy);
  if (!strategy.enumeration(3).empty())
    context.note("the stepover direction " + strategy.enumeration(3) +
                     " is not used; the side to begin at is left to the planner",
                 strategy);
}

/// The cut mode; where there is none, clockwise rotation, which inside a pocket is conventional for a cutter that turns
/// clockwise. Counter-clockwise is climb, as is what nobody says.
void read_cut_direction(const Node& strategy, Operation& operation, Context& context) {
  std::optional<CutDirection> mode, rotation;
  for (std::size_t i = 2; i < 6; ++i) {
    const std::string word = strategy.enumeration(i);
    if (word == "CLIMB") mode = CutDirection::kClimb;
    if (word == "CONVENTIONAL") mode = CutDirection::kConventional;
    if (word == "CCW") rotation = CutDirection::kClimb;
    if (word == "CW") rotation = CutDirection::kConventional;
  }
  if (mode && rotation && *mode != *rotation)
    context.note("the rotation direction is not used; the cut mode goes before it", strategy);
  if (mode)
    operation.direction = mode;
  else if (rotation == CutDirection::kConventional)
    operation.direction = rotation;
}

void read_strategy(const Node& node, Operation& operation, Context& context) {
  const auto strategy = node.ref(11);
  if (!strategy) return;
  operation.strategy_hint = lower(strategy->keyword());
  if (strategy->is_any("UNIDIRECTIONAL_MILLING", "UNIDIRECTIONAL", "BIDIRECTIONAL_MILLING", "BIDIRECTIONAL",
                       "BIDIRECTIONAL_CONTOUR"))
    read_strokes(*strategy, operation, context);
  read_cut_direction(*strategy, operation, context);
  if (strategy->enumeration(1) == "F")
    context.note(
        "that only one pass in depth is allowed is not used; layers are as deep as the cutting depth",
        *strategy);
  const auto overlap = strategy->number(0);
  if (overlap && operation.stepover)
    context.note("the radial depth goes before its overlap of " + trimmed(*overlap, 6), *strategy);
  if (!overlap || operation.stepover) return;
  if (!(*overlap >= 0 && *overlap < 1))
    return context.note(
        "the strategy's overlap of " + trimmed(*overlap, 6) + " is not a ratio from 0 to 1; it is not used",
        *strategy);
  operation.stepover = 1 - *overlap;
  context.note("the width of cut is the planner's unless --stepover asks for one; not followed: overlap " +
                   trimmed(*overlap, 6),
               *strategy);
}

double allowance(const Node& node, std::size_t argument) {
  const double value = node.length(argument).value_or(0);
  if (value < 0) node.fail("an allowance below zero would cut into the part; correct it");
  return value;
}

/// Arguments 13 on: which they are depends on the family of the operation.
void read_depths(const Node& node, const Tool& tool, Operation& operation, Context& context) {
  const bool plane = node.keyword().rfind("PLANE_", 0) == 0;
  const bool side = node.keyword().rfind("SIDE_", 0) == 0;
  operation.stepdown = positive(node.length(12));
  if (!operation.stepdown) context.note("no cutting depth; the planner's default is used", node);
  if (plane) {
    operation.allowance_floor = allowance(node, 13);
    return;
  }
  const auto radial = positive(node.length(13));
  if (radial)
    context.note(
        "the width of cut is the planner's unless --stepover asks for one; not followed: "
        "radial_cutting_depth " +
            trimmed(*radial, 6) + " mm",
        node);
  if (radial && *radial <= tool.diameter + 1e-9)
    operation.stepover = *radial / tool.diameter;
  else if (radial)
    context.warn("its radial depth is more than the cutter's diameter; it is not used", node);
  operation.allowance_side = allowance(node, 14);
  if (!side) operation.allowance_floor = allowance(node, 15);
}

/// A share of a feed: files write ratios or percent.
double share_of(const Node& node, std::size_t argument, const Context& context) {
  constexpr double kMostRatio = 2;
  const double value = node.number(argument).value_or(1);
  if (value <= 0)
    node.fail("argument " + std::to_string(argument + 1) + " is a share of zero or less; correct it");
  return !context.standard_units && value > kMostRatio ? value / 100 : value;
}

/// Reduced feeds where the hole begins and before it ends.
void read_drilling_strategy(const Node& node, HoleFeeds& feeds, const Context& context) {
  const auto strategy = node.ref(13);
  if (!strategy) return;
  if (!strategy->is("DRILLING_TYPE_STRATEGY"))
    strategy->fail("a DRILLING_TYPE_STRATEGY is needed here; correct the reference");
  feeds.start_share = share_of(*strategy, 1, context);
  feeds.start_depth = positive(strategy->length(2)).value_or(0);
  feeds.end_share = share_of(*strategy, 4, context);
  feeds.end_depth = positive(strategy->length(5)).value_or(0);
}

bool differs_from_one_feed(const HoleFeeds& feeds) {
  return (feeds.start_depth > 0 && feeds.start_share != 1) || (feeds.end_depth > 0 && feeds.end_share != 1) ||
         feeds.retract_share || feeds.dwell_s > 0;
}

/// A hole has one place to begin.
void use_start_at_center(const Node& node) {
  const P21Value start = node.peek(4);
  const P21Entity* entity = start.kind == P21Kind::kReference ? node.file().find(start.id) : nullptr;
  if (entity == nullptr) return;
  const std::vector<double> at = Node(node.file(), *entity).numbers(1);
  if (at.size() >= 2 && at[0] == 0 && at[1] == 0) node.use(4);
}

void read_drilling(const Node& node, StatedOperation& stated, const Context& context) {
  use_start_at_center(node);
  stated.depth = positive(node.length(9));
  stated.previous_diameter = positive(node.length(10));
  HoleFeeds feeds;
  feeds.dwell_s = positive(node.number(11)).value_or(0);
  if (!node.unset(12) && node.number(12) != 0.0) feeds.retract_share = share_of(node, 12, context);
  read_drilling_strategy(node, feeds, context);
  if (differs_from_one_feed(feeds)) stated.operation.hole_feeds = feeds;
  if (node.is("TAPPING")) stated.is_floating = node.flag(14) == true;
  if (!node.is("MULTISTEP_DRILLING")) return;
  stated.operation.stepdown = positive(node.length(16));
  if (!node.unset(15) && node.peek(15).number == node.peek(16).number) node.use(15);
}

void check_cutter(const Node& node, const Operation& operation, const Tool& tool) {
  const bool drill = is_driven_down(tool);
  if ((tool.kind == ToolKind::kTap) != node.is("TAPPING"))
    node.fail(tool.kind == ToolKind::kTap ? "a tap is for TAPPING alone; correct the operation"
                                          : "tapping needs a TAP; correct the tool");
  if (goes_straight_down(operation)) {
    if (tool.kind == ToolKind::kOther)
      node.fail("drilling with this kind of tool cannot be machined yet; give a drill, reamer or end mill");
  } else if (drill || tool.kind == ToolKind::kOther) {
    node.fail(
        "milling with this kind of tool cannot be machined yet; give an end mill, ball or bull-nose mill, or "
        "face mill");
  }
}

}  // namespace

std::optional<MmPerMin> feed_of_technology(const Node& technology, Context& context) {
  const auto feed = technology.number(0);
  if (!feed || *feed <= 0) return std::nullopt;
  const bool per_minute = !context.standard_units && *feed > kFastestFeed;
  if (per_minute) context.note("the feed is read as mm/min: it is too fast for m/s", technology);
  return MmPerMin::of(*feed * (per_minute ? 1 : 60000));
}

StatedOperation read_operation(const Node& node, const Tools& tools, Context& context) {
  const OperationEntity& row = row_of_operation(node);
  StatedOperation stated;
  stated.hole = row.hole;
  Operation& operation = stated.operation;
  operation.kind = row.kind;
  operation.name = node.text(2);
  operation.source = "#" + std::to_string(node.id());
  const auto direction = node.sound_ref(1);
  if (direction && !direction->is("THREE_AXES"))
    node.fail("it asks for a tool that is not upright (" + direction->label() +
              "); only THREE_AXES can be machined in a set-up");
  const Node tool_node = node.needed_ref(5, "tool");
  operation.tool = tools.find(tool_node, context);
  const Tool& tool = tools.list()[static_cast<std::size_t>(operation.tool)];
  if (tool.kind == ToolKind::kOther)
    if (const auto body = tool_node.sound_ref(1)) refuse_listed(*body);
  check_cutter(node, operation, tool);
  if (goes_straight_down(operation)) {
    read_drilling(node, stated, context);
  } else {
    read_depths(node, tool, operation, context);
    read_approach(node, operation, context);
    read_retract(node, operation, context);
    read_strategy(node, operation, context);
  }
  stated.hand = tools.hand_of(tool_node);
  read_cutting(node, tool, stated.hand, operation, context);
  if (const auto retract = node.length(3)) operation.retract_z = *retract;
  if (operation.entry == EntryKind::kPlunge && !tool.center_cutting) {
    context.note("plunging is asked for with a face mill; the planner chooses the entry", node);
    operation.entry.reset();
  }
  return stated;
}

}  // namespace clearcut::read::stepnc
