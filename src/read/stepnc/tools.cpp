#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/units.h"
#include "read/stepnc/toolpaths.h"
#include "read/tools/formats.h"

namespace clearcut::read::stepnc {
namespace {

constexpr double kMostTeeth = 100;

struct BodyKind {
  std::string_view keyword;
  ToolKind kind;
};
constexpr BodyKind kBodies[] = {{"ENDMILL", ToolKind::kEndMill},
                                {"TAPERED_ENDMILL", ToolKind::kEndMill},
                                {"BALL_ENDMILL", ToolKind::kBallEndMill},
                                {"BULLNOSE_ENDMILL", ToolKind::kBullNoseEndMill},
                                {"FACEMILL", ToolKind::kFaceMill},
                                {"TWIST_DRILL", ToolKind::kDrill},
                                {"SPADE_DRILL", ToolKind::kDrill},
                                {"CENTER_DRILL", ToolKind::kDrill},
                                {"TAPERED_DRILL", ToolKind::kDrill},
                                {"REAMER", ToolKind::kReamer},
                                {"TAPERED_REAMER", ToolKind::kReamer},
                                {"BORING_TOOL", ToolKind::kBoringBar},
                                {"COUNTERSINK", ToolKind::kSpotDrill},
                                {"TAP", ToolKind::kTap},
                                {"COUNTERBORE", ToolKind::kCounterbore},
                                {"T_SLOT_MILL", ToolKind::kTSlot},
                                {"WOODRUFF_KEYSEAT_MILL", ToolKind::kTSlot}};

ToolKind kind_of(const Node& body) {
  for (const BodyKind& entry : kBodies)
    if (body.is(entry.keyword)) return entry.kind;
  return ToolKind::kOther;
}

/// "T3" gives 3 and leaves the name; "T3 MILL 20MM" gives 3 and the rest as the name.
std::optional<int> number_in(std::string& name) {
  if (name.size() < 2 || (name[0] != 'T' && name[0] != 't')) return std::nullopt;
  int number = 0;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  const bool whole = end == name.data() + name.size();
  if (error != std::errc() || number <= 0 || (!whole && *end != ' ')) return std::nullopt;
  if (!whole) name.erase(0, static_cast<std::size_t>(end - name.data()) + 1);
  return number;
}

/// Of drills the radius is not read: the ledger of what is not used names it.
double corner_radius_of(const Node& tool, const Tool& result, Context& context) {
  if (is_driven_down(result)) return 0;
  const std::optional<double> edge_radius = tool.length(4);
  if (result.kind == ToolKind::kBallEndMill) {
    if (edge_radius && std::abs(*edge_radius - result.radius()) > kSamePlaceMm)
      context.warn("not followed: an edge radius of " + trimmed(*edge_radius, 4) +
                       " mm; the end of a ball mill is as round as it is wide",
                   tool);
    return result.radius();
  }
  if (!edge_radius) context.note("no edge radius; the cutter is taken as flat-ended", tool);
  if (edge_radius && *edge_radius > result.radius() + 1e-9)
    tool.fail("its edge radius is larger than half its diameter; correct it");
  return std::max(0.0, edge_radius.value_or(0));
}

/// Of drills and cones: the angle between opposite flanks. Below 90 degrees the standard's angle is that between an edge and the plane
/// square to the axis (31 degrees: a point of 118).
std::optional<Radians> tip_of(const Node& size, const Context& context) {
  const auto stated = size.number(1);
  if (!stated || *stated <= 0) return std::nullopt;
  const double angle = context.angle(*stated);
  const double tip = angle < kPi / 2 - 1e-6 ? kPi - 2 * angle : angle;
  if (!(tip > 0 && tip < kPi)) size.fail("its tool_top_angle is no angle of a drill's point; correct it");
  return Radians::of(tip);
}

/// Without an angle it is an end mill like any other.
void read_taper(const Node& body, Tool& tool, Context& context) {
  const double angle = context.draft_angle(body.number(5).value_or(0));
  if (angle == 0) return;
  const double degrees = Radians::of(angle).degrees();
  if (degrees < kLeastTaper || degrees > kMostTaper)
    body.fail("its taper is not from " + trimmed(kLeastTaper, 1) + " to " + trimmed(kMostTaper, 1) +
              " degrees; correct it");
  if (!tool.flute_length)
    body.fail("a tapered end mill needs the length of its cutting edges; add it to its dimensions");
  if (tool.corner_radius > 0)
    body.fail(
        "its tip is rounded, and tapered end mills are read with flat tips alone; correct its edge radius");
  tool.kind = ToolKind::kTapered;
  tool.tip_angle = Radians::of(2 * angle);
  context.note("the diameter of a tapered end mill is read as that of its tip, its taper as that of one side",
               body);
}

/// mm on each side between the neck of a T-slot cutter and its slot, where nothing states the neck.
constexpr double kBesideUnstatedNeck = 0.1;

/// The height of its disc, and a neck that passes through the slots that it undercuts: the standard has no word for it.
void read_disc(const Node& body, const StatedUse& use, Tool& tool, Context& context) {
  if (const auto height = body.length(5); height && *height > 0) tool.flute_length = height;
  if (!tool.flute_length) body.fail("the height of its disc is missing; give cutting_thickness");
  if (use.neck <= 0) return;
  tool.shank_diameter = std::max(use.neck - 2 * kBesideUnstatedNeck, 0.1);
  context.warn("no attribute states the neck of a cutter of undercuts: it is taken as " +
                   trimmed(tool.shank_diameter, 3) + " mm, " + trimmed(kBesideUnstatedNeck, 3) +
                   " mm off the walls of its slot",
               body);
}

/// A countersink that runs along edges is a V-bit; a tapered end mill that breaks edges alone is a chamfer mill, with its own tip.
void read_cone(const Node& body, const StatedUse& use, Tool& tool, Context& context) {
  if (tool.kind == ToolKind::kSpotDrill && use.mills) tool.kind = ToolKind::kVBit;
  if (tool.kind != ToolKind::kTapered || !use.breaks_edges) return;
  tool.kind = ToolKind::kChamferMill;
  tool.tip_diameter = tool.diameter;
  tool.diameter += 2 * *tool.flute_length * base::tan(tool.tip_angle->radians() / 2);
  context.note("it breaks edges alone and is taken as a chamfer mill, whose tip does not cut", body);
}

/// Other hands than the two that a spindle can turn for.
void check_hand(const Node& body, Context& context) {
  const std::string hand = body.enumeration(2);
  if (!hand.empty() && hand != "LEFT" && hand != "RIGHT")
    context.warn("not followed: hand_of_cut ." + hand + ".; its spindle turns clockwise, as for .RIGHT.",
                 body);
}

Tool read_tool(const Node& node, const StatedUse& use, Context& context) {
  if (!node.is_any("MILLING_CUTTING_TOOL", "CUTTING_TOOL"))
    node.fail("a MILLING_CUTTING_TOOL is needed here; correct the reference");
  const Node body = node.needed_ref(1, "tool body");
  const Node size = body.needed_ref(0, "tool dimension");
  Tool tool;
  tool.name = node.text(0);
  tool.kind = kind_of(body);
  check_hand(body, context);
  tool.diameter = size.needed_length(0, "diameter");
  if (tool.diameter <= 0) size.fail("the tool's diameter is not above zero; correct it");
  tool.corner_radius = corner_radius_of(size, tool, context);
  tool.flute_length = size.length(3);
  if (tool.flute_length && *tool.flute_length <= 0) tool.flute_length.reset();
  const double teeth = body.number(1).value_or(2);
  tool.teeth = teeth >= 1 && teeth <= kMostTeeth ? static_cast<int>(teeth) : 2;
  tool.center_cutting = tool.kind != ToolKind::kFaceMill;
  if (body.is("TAPERED_ENDMILL")) read_taper(body, tool, context);
  if (tool.kind == ToolKind::kDrill) tool.tip_angle = tip_of(size, context);
  if (tool.kind == ToolKind::kSpotDrill)
    tool.tip_angle = tip_of(size, context).value_or(Radians::of_degrees(90));
  read_cone(body, use, tool, context);
  if (tool.kind == ToolKind::kTSlot) read_disc(body, use, tool, context);
  return tool;
}

bool same_tool(const Tool& a, const Tool& b) {
  return a.name == b.name && a.kind == b.kind && a.diameter == b.diameter &&
         a.corner_radius == b.corner_radius && a.teeth == b.teeth && a.flute_length == b.flute_length &&
         a.tip_angle.value_or(Radians{}).radians() == b.tip_angle.value_or(Radians{}).radians();
}

}  // namespace

Tools::Tools(Context& context, const std::map<std::uint64_t, StatedUse>& uses) : uses_(uses) {
  for (const Node& node : nodes_called(context.file, "MILLING_CUTTING_TOOL")) {
    try {
      Tool tool = read_tool(node, uses_[node.id()], context);
      const auto number = number_in(tool.name);
      if (number) tool.number = *number;
      by_entity_[node.id()] = add(std::move(tool), number.has_value(), hand_of(node) == Hand::kLeft);
    } catch (const InputError&) {
      // find() reports it where an operation needs this tool.
    }
  }
  number_the_rest();
}

int Tools::add(Tool tool, bool numbered, bool left_handed) {
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const bool same_number = numbered_[i] == numbered && (!numbered || tools_[i].number == tool.number);
    if (same_number && left_handed_[i] == left_handed && same_tool(tools_[i], tool))
      return static_cast<int>(i);
    if (numbered && numbered_[i] && tools_[i].number == tool.number) numbered = false;
  }
  tools_.push_back(std::move(tool));
  numbered_.push_back(numbered);
  left_handed_.push_back(left_handed);
  return static_cast<int>(tools_.size()) - 1;
}

/// Tools whose name holds no number (or one that is taken) get the smallest free ones.
void Tools::number_the_rest() {
  std::vector<int> taken;
  for (std::size_t i = 0; i < tools_.size(); ++i)
    if (numbered_[i]) taken.push_back(tools_[i].number);
  std::sort(taken.begin(), taken.end());
  int next = 1;
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    if (numbered_[i]) continue;
    while (std::binary_search(taken.begin(), taken.end(), next)) ++next;
    tools_[i].number = next++;
    if (tools_[i].name.empty()) tools_[i].name = "T" + std::to_string(tools_[i].number);
  }
}

int Tools::find(const Node& tool, Context& context) const {
  const auto found = by_entity_.find(tool.id());
  if (found != by_entity_.end()) return found->second;
  read_tool(tool, {}, context);  // throws what is wrong with it
  tool.fail("a MILLING_CUTTING_TOOL is needed here; correct the reference");
}

Hand Tools::hand_of(const Node& tool) const {
  const auto body = tool.ref(1);
  if (!body) return Hand::kUnstated;
  const std::string hand = body->enumeration(2);
  return hand == "LEFT" ? Hand::kLeft : hand == "RIGHT" ? Hand::kRight : Hand::kUnstated;
}

}  // namespace clearcut::read::stepnc
