// What cutters make by their own form along an edge or a course: chamfers, vees, half-round slots.
#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/text.h"
#include "features/derived_outlines.h"
#include "model/results/findings.h"
#include "read/stepnc/operation.h"
#include "read/stepnc/reader.h"

namespace clearcut::read::stepnc {
namespace {

constexpr double kSameCone = 0.002;      // radians
constexpr double kSameSlotWidth = 0.01;  // mm

Loop counter_clockwise(Loop loop) {
  return signed_area(loop) < 0 ? reversed(loop) : loop;
}

/// mm; width of the neck of a T slot; 0 for other features.
double neck_of(const Node& feature) {
  const auto section = feature.is("SLOT") ? feature.sound_ref(6) : std::nullopt;
  if (!section || !section->is("TEE_PROFILE")) return 0;
  try {
    return section->length(6).value_or(0);
  } catch (const InputError&) {
    return 0;  // where it is drafted that is said
  }
}

}  // namespace

std::map<std::uint64_t, StatedUse> Reader::tool_uses() const {
  std::map<std::uint64_t, StatedUse> uses;
  for (const OrderedStep& ordered : program_.steps) {
    const auto feature = ordered.node.sound_ref(2), operation = ordered.node.sound_ref(3);
    const auto tool = operation ? operation->sound_ref(5) : std::nullopt;
    if (!feature || !tool) continue;
    const bool is_chamfer = feature->is("CHAMFER");
    const auto [use, is_new] = uses.emplace(tool->id(), StatedUse{false, 0, is_chamfer});
    const double neck = neck_of(*feature);
    if (neck > 0) use->second.neck = use->second.neck > 0 ? std::min(use->second.neck, neck) : neck;
    use->second.mills = use->second.mills || operation->keyword().find("MILLING") != std::string::npos;
    use->second.breaks_edges = use->second.breaks_edges && is_chamfer;
  }
  return uses;
}

namespace {

/// The closed edges at the top of a feature's own walls: of pockets and holes without those of their bosses.
void add_own_edges(const Draft& draft, const Regions& at_top, double top, std::vector<WallEdge>& edges) {
  const bool is_outside = draft.kind == FeatureKind::kOutsideProfile && draft.bosses.size() == 1;
  if (is_outside) edges.push_back({counter_clockwise(draft.bosses.front()), top, false, draft.wall_slope});
  if (draft.kind != FeatureKind::kClosedPocket && draft.kind != FeatureKind::kRoundHole) return;
  for (const Region& region : at_top)
    edges.push_back({counter_clockwise(region.outer()), top, true, draft.wall_slope});
}

}  // namespace

/// The closed edges at the top of the walls of a feature or a boss.
std::vector<WallEdge> Reader::edges_of(const Node& owner) {
  std::vector<WallEdge> edges;
  for (std::size_t i = 0; i < drafts_.size(); ++i) {
    const Draft& draft = drafts_[i];
    if (features_of_draft_[i].empty()) continue;
    if (draft.node.id() == owner.id())
      add_own_edges(draft, part_.features[static_cast<std::size_t>(features_of_draft_[i].front())].target,
                    top_of_draft(i), edges);
    for (std::size_t boss = 0; owner.is("BOSS") && boss < draft.bosses.size(); ++boss)
      if (draft.boss_ids[boss] == owner.id())
        edges.push_back({counter_clockwise(draft.bosses[boss]),
                         std::min(boss_top(draft, boss), top_of_draft(i)), false, draft.wall_slope});
  }
  if (edges.empty())
    for (const Draft& draft : unmachined(owner))
      add_own_edges(draft, feature_regions(draft, part_.stock, context_).target, draft.placement_z, edges);
  return edges;
}

/// Features without a workingstep that an edge refers to, such as a face finished before.
std::vector<Draft> Reader::unmachined(const Node& owner) {
  std::vector<Draft> drafts;
  if (owner.is_any("BOSS", "CHAMFER")) return drafts;
  for (const Member& member : Members(context_, program_.chosen().turn).of(owner))
    drafts.push_back(draft_feature(member, context_));
  return drafts;
}

/// z of the floors of a feature's members.
std::vector<double> Reader::floors_of(const Node& owner) {
  std::vector<double> floors;
  for (std::size_t i = 0; i < drafts_.size(); ++i)
    if (drafts_[i].node.id() == owner.id() && !features_of_draft_[i].empty())
      floors.push_back(floor_of(drafts_[i]));
  if (floors.empty())
    for (const Draft& draft : unmachined(owner)) floors.push_back(floor_of(draft));
  return floors;
}

/// The edges of `walls` that lie in the floor of `face`, or in the surface that it leaves as it is.
std::vector<WallEdge> Reader::edges_between(const Node& walls, const Node& face) {
  std::vector<WallEdge> edges = edges_of(walls);
  const std::vector<double> floors = floors_of(face);
  const bool is_boss = walls.is("BOSS");
  std::erase_if(edges, [&](const WallEdge& edge) {
    const bool meets = std::any_of(floors.begin(), floors.end(),
                                   [&](double floor) { return std::abs(floor - edge.top) < kLevel; });
    return !meets && !is_boss;
  });
  return edges;
}

/// The edge is where the walls of one feature end in the floor of the other; a boss has its own.
void Reader::make_chamfer(std::size_t index) {
  const Draft& draft = drafts_[index];
  const BrokenEdge& asked = *draft.edge;
  if (absolute_depths_)
    draft.node.fail("its edge is not known where depths are absolute; write them relative to their features");
  bool walls_are_first = !asked.second.is("BOSS");
  std::vector<WallEdge> edges =
      walls_are_first ? edges_between(asked.first, asked.second) : edges_between(asked.second, asked.first);
  if (edges.empty()) {
    walls_are_first = !walls_are_first;
    edges =
        walls_are_first ? edges_between(asked.first, asked.second) : edges_between(asked.second, asked.first);
  }
  if (edges.empty())
    draft.node.fail("no closed edge lies between " + asked.first.label() + " and " + asked.second.label() +
                    ": it lies where walls that are machined (of a pocket, hole, boss or outside profile) "
                    "end in the floor "
                    "of the other feature; correct them, or break the edge by hand");
  const double slope = base::tan(asked.angle.radians());
  const double depth = walls_are_first ? asked.offset : asked.offset * slope;
  const double width = walls_are_first ? asked.offset * slope : asked.offset;
  for (const WallEdge& edge : edges) {
    if (edge.wall_slope.radians() != 0)
      draft.node.fail("the wall below its edge is drafted; only edges of upright walls are broken");
    Feature feature;
    feature.kind = FeatureKind::kChamfer;
    feature.name = unique_name(draft);
    feature.source = "#" + std::to_string(draft.node.id());
    feature.top_z = edge.top;
    feature.floor_z = edge.top - depth;
    feature.wall_slope = Radians::of(base::atan2(width, depth));
    feature.target = feature.allowed =
        features::kerf_of({ProfileSide::kOn, edge.line, true, 0, {}}, depth, context_.tol);
    feature.chamfer = Chamfer{edge.line, depth, edge.air_inside, {}, 0, 0};
    features_of_draft_[index].push_back(static_cast<int>(part_.features.size()));
    part_.features.push_back(std::move(feature));
  }
}

/// Whether nothing of a slot is left for cutters of another form.
bool Reader::is_groove_alone(std::size_t index) const {
  const auto groove = grooves_.find(index);
  return groove != grooves_.end() && !features_of_draft_[index].empty() &&
         features_of_draft_[index].back() == groove->second;
}

/// A cone breaks edges and cuts vees of its own angle; a ball cuts half-round slots of its own width.
void Reader::check_form_cutter(std::size_t index, const StatedOperation& stated, const Node& step) const {
  const Draft& draft = drafts_[index];
  const Tool& tool = part_.tools[static_cast<std::size_t>(stated.operation.tool)];
  if (draft.edge && goes_straight_down(stated.operation))
    step.fail(
        "an edge is broken by an operation of milling along it; that of a hole also by COUNTER_SINKING of "
        "the ROUND_HOLE");
  if (goes_straight_down(stated.operation)) return;
  const bool is_vee = draft.groove && draft.groove->sides;
  if (tool.kind == ToolKind::kTSlot) return check_disc(index, tool, step);
  if (!draft.edge && !is_vee) {
    if (is_conical(tool)) step.fail("a cone leaves no flat floor and no upright walls; give an end mill");
    if (is_groove_alone(index) && tool.kind != ToolKind::kBallEndMill)
      step.fail(
          "the slot is no deeper than its half-round section, which a ball of its width cuts; give one");
    return;
  }
  const std::string what = draft.edge ? "a chamfer" : "a vee";
  if (!is_conical(tool))
    step.fail(what + " is cut by a cone; give a COUNTERSINK with its tool_top_angle" +
              (draft.edge ? ", or a TAPERED_ENDMILL" : ""));
  const Feature& made = part_.features[static_cast<std::size_t>(features_of_draft_[index].front())];
  const double half = draft.edge ? made.wall_slope.radians() : draft.groove->sides->radians() / 2;
  if (std::abs(tool.tip_angle->radians() / 2 - half) > kSameCone)
    step.fail(what + " of this angle is cut by a cone of " + trimmed(Radians::of(2 * half).degrees(), 2) +
              " degrees between its flanks, and its tool has " + trimmed(tool.tip_angle->degrees(), 2) +
              "; give another");
  const double depth = made.top_z - made.floor_z;
  if (depth > flank_height(tool) + kLevel)
    step.fail(what + " of " + trimmed(depth, 3) +
              " mm depth is deeper than the flanks of its tool are high, " + trimmed(flank_height(tool), 3) +
              " mm; give a wider one");
  if (is_vee && tool.tip_diameter > 0)
    step.fail("a vee comes to a point, and the tip of its tool is flat; give a pointed one");
}

/// The groove along the course of a slot.
int Reader::make_groove(std::size_t index) {
  const Draft& draft = drafts_[index];
  Feature feature;
  feature.kind = FeatureKind::kEngraving;
  feature.source = "#" + std::to_string(draft.node.id());
  feature.top_z = absolute_depths_ ? part_.stock->z_top : draft.placement_z;
  feature.floor_z = floor_of(draft) - draft.raised_floor;
  if (feature.floor_z >= feature.top_z - kRoundingMm)
    draft.node.fail("its depth plane (z " + trimmed(feature.floor_z, 3) + ") is not below its top (z " +
                    trimmed(feature.top_z, 3) + "); give a depth below zero");
  ProfileCut cut;
  cut.side = ProfileSide::kOn;
  cut.line = groove_course(draft, part_.stock, context_);
  cut.closed = distance(cut.line.front().from, cut.line.back().to) <= context_.tol.join_gap;
  feature.name = unique_name(draft);
  features::follow(feature, std::move(cut), context_.tol);
  part_.features.push_back(std::move(feature));
  return grooves_[index] = static_cast<int>(part_.features.size()) - 1;
}

/// The groove that the operation's cutter makes by its form.
int Reader::groove_of(std::size_t index, const StatedOperation& stated) {
  const Draft& draft = drafts_[index];
  const Tool& tool = part_.tools[static_cast<std::size_t>(stated.operation.tool)];
  if (!draft.groove->sides && std::abs(tool.diameter - draft.width) > kSameSlotWidth)
    draft.node.fail("its half-round bottom is " + trimmed(draft.width, 3) +
                    " mm wide, and the ball of its operation " + trimmed(tool.diameter, 3) +
                    " mm; give a ball of that width");
  const auto known = grooves_.find(index);
  return known != grooves_.end() ? known->second : make_groove(index);
}

/// The undercut of a T slot follows the slot for its neck, which an earlier workingstep mills.
void Reader::check_disc(std::size_t index, const Tool& tool, const Node& step) const {
  const Draft& draft = drafts_[index];
  if (!draft.undercut)
    step.fail(
        "a disc (T-slot or woodruff mill) makes the undercut of a slot with a TEE_PROFILE alone; give an end "
        "mill");
  constexpr double kSameDisc = 0.02;  // mm
  if (std::abs(tool.diameter - draft.undercut->width) > kSameDisc ||
      std::abs(*tool.flute_length - draft.undercut->height) > kSameDisc)
    step.fail("the undercut is " + trimmed(draft.undercut->width, 3) + " mm wide and " +
              trimmed(draft.undercut->height, 3) + " mm high, and the disc of its tool " +
              trimmed(tool.diameter, 3) + " and " + trimmed(*tool.flute_length, 3) +
              " mm; give one of that size");
  if (draft.undercut->height >= -draft.depth_z - kLevel)
    step.fail(
        "the undercut is as high as the slot is deep: nothing would stand over it; correct cross_bar_depth");
  const auto steps = steps_of_draft_.find(index);
  if (steps == steps_of_draft_.end() || steps->second.empty())
    step.fail("no earlier workingstep mills the slot for the neck of its cutter; add one with an end mill");
  const bool is_open = std::any_of(std::begin(draft.ends), std::end(draft.ends),
                                   [](SlotEnd end) { return end == SlotEnd::kOpen; });
  if (draft.ends_given && !is_open)
    step.fail("both ends of the slot are closed, and the disc can go down at neither; write one as open");
}

/// The undercut along the course of a slot. Made once.
int Reader::undercut_of(std::size_t index, const Node& step) {
  if (const auto known = undercuts_.find(index); known != undercuts_.end()) return known->second;
  const Draft& draft = drafts_[index];
  if (!part_.stock)
    step.fail("where the disc goes down needs the size of the stock; give the WORKPIECE a BLOCK");
  Feature feature = feature_of_draft(index);
  feature.name = unique_name(feature.name + " undercut");
  feature.kind = FeatureKind::kTSlot;
  feature.wall_slope = {};
  feature.floor_fillet = 0;
  feature.through = false;
  ProfileCut cut;
  cut.side = ProfileSide::kOn;
  cut.line = groove_course(draft, part_.stock, context_);
  cut.closed = false;
  features::follow(feature, std::move(cut), context_.tol);
  part_.features.push_back(std::move(feature));
  return undercuts_[index] = static_cast<int>(part_.features.size()) - 1;
}

/// Undercuts that no disc has made.
void Reader::check_undercuts() {
  for (const auto& [index, steps] : steps_of_draft_) {
    const Draft& draft = drafts_[index];
    if (!draft.undercut || undercuts_.count(index) || steps.empty() || left_out_.count(draft.node.id()))
      continue;
    say_not_machined(context_.diagnostics, context_.file.place(draft.node.line()),
                     "the undercut of " + feature_of_draft(index).name,
                     draft.node.label() + ": it needs a T_SLOT_MILL of " + trimmed(draft.undercut->width, 3) +
                         " x " + trimmed(draft.undercut->height, 3) + " mm; add a workingstep with one");
  }
}

/// Half-round bottoms that no ball has made.
void Reader::check_rounded_bottoms() {
  for (const auto& [index, steps] : steps_of_draft_) {
    const Draft& draft = drafts_[index];
    if (draft.raised_floor <= 0 || grooves_.count(index) || steps.empty() || left_out_.count(draft.node.id()))
      continue;
    say_not_machined(context_.diagnostics, context_.file.place(draft.node.line()),
                     "the rounded bottom of " + feature_of_draft(index).name,
                     draft.node.label() + ": what lies below z " + trimmed(floor_of(draft), 3) +
                         " needs a ball as wide as the slot; add a workingstep with one");
  }
}

}  // namespace clearcut::read::stepnc
