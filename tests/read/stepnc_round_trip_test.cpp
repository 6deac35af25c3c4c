// STEP-NC: the writer and the reader against each other.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "base/random.h"
#include "base/units.h"
#include "features/standing.h"
#include "geometry/contours/boolean.h"
#include "pipeline/run.h"
#include "post/part/part_writers.h"
#include "read/job/read_part.h"
#include "read/stepnc/stepnc.h"
#include "studies/fishhead.h"
#include "support/data.h"
#include "support/plans.h"
#include "support/plate.h"
#include "support/same_regions.h"
#include "support/stepnc_files.h"

namespace clearcut {
namespace {

using test_support::expect_same_part;
using test_support::read_data;

// Files of other writers; what is in them is described beside them.
const char* const kFiles[] = {"fishhead.p21",
                              "fishhead_sloped.p21",
                              "iso14649_11_ex1.stp",
                              "iso14649_11_ex1_nist.stp",
                              "ufsc_hole_slot_step_pocket.p21",
                              "ufsc_slot_rounded_u.p21",
                              "unb_final_test.p21"};

TEST(StepNcRoundTrip, EveryFile) {
  std::vector<Part> parts{studies::fishhead(false, {}), studies::fishhead(true, {})};
  if (test_support::data_folder())
    for (const char* name : kFiles) parts.push_back(read_data(name));
  for (const Part& part : parts) {
    SCOPED_TRACE(part.name);
    const std::string text = post::write_stepnc(part);
    const Part again = read::stepnc::read_stepnc(text, "again.p21", {});
    expect_same_part(part, again);
    EXPECT_EQ(post::write_stepnc(again), text) << "writing what was read changes nothing more";
  }
}

TEST(StepNcRoundTrip, Plate) {
  const Part plate = test_support::plate();
  expect_same_part(plate, read::stepnc::read_stepnc(post::write_stepnc(plate), "again.p21", {}));
}

TEST(StepNcRoundTrip, PartsWithoutFeedsKeepTheirMaterial) {
  Part plate = test_support::plate();
  plate.workplan.front().operation.cutting.feed.reset();
  plate.material = "brass";
  EXPECT_EQ(read::stepnc::read_stepnc(post::write_stepnc(plate), "again.p21", {}).material, "brass");
  plate.material.reset();
  EXPECT_FALSE(read::stepnc::read_stepnc(post::write_stepnc(plate), "again.p21", {}).material);
}

TEST(StepNcRoundTrip, TaperedEndMillsKeepTheirTaper) {
  Part plate = test_support::plate();
  Tool& tool = plate.tools.front();
  tool.kind = ToolKind::kTapered;
  tool.tip_angle = Radians::of_degrees(8);
  tool.flute_length = 30;
  tool.corner_radius = 0;
  const Part again = read::stepnc::read_stepnc(post::write_stepnc(plate), "again.p21", {});
  expect_same_part(plate, again);
  EXPECT_EQ(again.tools.front().kind, ToolKind::kTapered);
  EXPECT_NEAR(again.tools.front().tip_angle.value_or(Radians{}).degrees(), 8, 1e-9);
}

TEST(StepNcRoundTrip, LinesToFollowAreRefusedByName) {
  Part part = test_support::plate();
  Feature& first = part.features.front();
  first.kind = FeatureKind::kInsideProfile;
  first.profile.emplace();
  first.profile->side = ProfileSide::kInside;
  first.profile->line = first.target.front().outer();
  try {
    post::write_stepnc(part);
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find(first.name + " is an inside profile, a line to follow"), std::string::npos) << what;
  }
}

/// A step that finds nothing left has no toolpath to be read again, and would be planned anew.
TEST(StepNcRoundTrip, StepsThatFindNothingLeftAreNotWrittenWithToolpaths) {
  const Part pocket = read::read_part_text(
      R"({"units": "mm", "pockets": [{"name": "P", "top": 0, "depth": 2, "outer": [
         [0, 0, 1], [20, 0, 1]]}]})",
      "round.json", {});
  PlanOptions options = test_support::plan_options_with({"endmill:6", "endmill:3"});
  options.shop.rest = true;
  const PlanResult plan = pipeline::plan_part(pocket, options);
  ASSERT_EQ(plan.part.workplan.size(), 2U);
  const std::string text = post::write_stepnc(plan.part, plan.planned);
  EXPECT_EQ(read::stepnc::read_stepnc(text, "again.p21", {}).workplan.size(), 1U);
  EXPECT_EQ(read::stepnc::read_stepnc(post::write_stepnc(plan.part), "again.p21", {}).workplan.size(), 2U);
}

/// Makes parts with every kind of feature, tool and operation.
class RandomPart {
 public:
  explicit RandomPart(std::uint64_t seed) : random_(seed) {}

  Part make() {
    part_.name = random_.below(2) ? "part '1' \\ \u03c0\U0001F600" : "P";
    const double w = random_.between(80, 200), h = random_.between(80, 200);
    const Vec2 corner{random_.between(-50, 50), random_.between(-50, 50)};
    part_.stock = Stock{{corner, corner + Vec2{w, h}}, -60, 0};
    if (random_.below(2)) part_.clearance_z = random_.between(5, 30);
    make_tools();
    const auto features = 1 + random_.below(5);
    for (std::uint64_t i = 0; i < features; ++i) make_feature();
    features::stack_tops(part_, {});
    for (Workingstep& step : part_.workplan)
      if (step.operation.retract_z)
        *step.operation.retract_z = part_.features[static_cast<std::size_t>(step.feature)].top_z + 2;
    part_.diagnostics = {};
    return part_;
  }

 private:
  bool maybe() { return random_.below(2) == 1; }
  std::optional<double> perhaps(double low, double high) {
    return maybe() ? std::optional(random_.between(low, high)) : std::nullopt;
  }
  std::optional<MmPerMin> perhaps_feed() {
    const double most = random_.below(8) == 0 ? 400000 : 3000;  // also faster than many files' mm/min in m/s
    return maybe() ? std::optional(MmPerMin::of(random_.between(50, most))) : std::nullopt;
  }

  void make_tools() {
    const ToolKind kinds[] = {ToolKind::kEndMill, ToolKind::kFaceMill, ToolKind::kBallEndMill,
                              ToolKind::kBullNoseEndMill, ToolKind::kDrill};
    for (int i = 0; i < 5; ++i) {
      Tool tool;
      tool.number = i * 3 + 1 + static_cast<int>(random_.below(3));
      tool.name = maybe() ? "T" + std::to_string(tool.number) : "cutter no. " + std::to_string(i);
      tool.kind = kinds[i];
      tool.diameter = random_.between(2, 20);
      if (tool.kind == ToolKind::kBallEndMill) tool.corner_radius = tool.diameter / 2;
      if (tool.kind == ToolKind::kBullNoseEndMill) tool.corner_radius = tool.diameter / 5;
      tool.teeth = 1 + static_cast<int>(random_.below(6));
      tool.flute_length = perhaps(5, 50);
      tool.center_cutting = tool.kind != ToolKind::kFaceMill;
      part_.tools.push_back(tool);
    }
  }

  Operation operation(bool hole) {
    Operation op;
    op.name = "op " + std::to_string(part_.workplan.size());
    op.kind = hole && maybe() ? OperationKind::kDrilling
              : maybe()       ? OperationKind::kRoughing
                              : OperationKind::kFinishing;
    const bool drilling = op.kind == OperationKind::kDrilling;
    op.tool = drilling ? 4 : static_cast<int>(random_.below(4));
    op.cutting.feed = perhaps_feed();
    op.cutting.plunge_feed = perhaps_feed();
    op.cutting.ramp_feed = perhaps_feed();
    op.cutting.slot_feed = perhaps_feed();
    op.cutting.spindle_rpm = perhaps(500, random_.below(8) == 0 ? 90000 : 40000);
    op.cutting.spindle_clockwise = !op.cutting.spindle_rpm || maybe();
    if (maybe()) op.cutting.coolant = static_cast<Coolant>(1 + random_.below(3));
    if (maybe()) op.retract_z = 1;  // set to 2 mm above the top once that is known
    if (!drilling) milling(op);
    return op;
  }

  void milling(Operation& op) {
    op.stepdown = perhaps(0.5, 5);
    op.stepover = perhaps(0.1, 1);
    op.allowance_side = perhaps(0.1, 1).value_or(0);
    op.allowance_floor = perhaps(0.1, 1).value_or(0);
    op.scallop = perhaps(0.1, 1);
    if (maybe()) op.direction = maybe() ? CutDirection::kClimb : CutDirection::kConventional;
    const char* hints[] = {"",
                           "contour_parallel",
                           "bidirectional_milling",
                           "unidirectional_milling",
                           "contour_spiral",
                           "bidirectional_contour"};
    op.strategy_hint = hints[random_.below(6)];
    if (op.strategy_hint.find("directional") != std::string::npos && maybe())
      op.feed_direction = Radians::of(random_.between(-3, 3));
    const EntryKind entries[] = {EntryKind::kHelix, EntryKind::kRamp, EntryKind::kZigzagRamp,
                                 EntryKind::kPlunge};
    if (maybe()) op.entry = entries[random_.below(op.tool == 1 ? 3 : 4)];
    if (op.entry && *op.entry != EntryKind::kPlunge && maybe())
      op.entry_angle = Radians::of(random_.between(0.01, 1.2));
    if (op.entry == EntryKind::kHelix || op.entry == EntryKind::kZigzagRamp) op.entry_size = perhaps(0.5, 5);
    op.lead = perhaps(0.5, 5);
    if (op.lead && maybe()) op.lead_angle = Radians::of(random_.between(0.01, 1.2));
  }

  /// A star-shaped outline with arcs.
  Loop blob(Vec2 center, double radius) {
    std::vector<BulgeVertex> vertices;
    const auto n = 5 + random_.below(8);
    for (std::uint64_t i = 0; i < n; ++i) {
      const double angle =
          2 * kPi * (static_cast<double>(i) + random_.between(-0.2, 0.2)) / static_cast<double>(n);
      vertices.push_back({center + direction_of(angle) * radius * random_.between(0.7, 1),
                          maybe() ? random_.between(-0.12, 0.3) : 0});
    }
    return loop_from_bulges(vertices);
  }
  Loop disc(Vec2 c, double radius) {
    const Vec2 r{radius, 0};
    return {Edge::arc(c + r, c - r, c, Turn::kCounterClockwise),
            Edge::arc(c - r, c + r, c, Turn::kCounterClockwise)};
  }
  Loop rectangle(double x0, double y0, double x1, double y1) {
    const Vec2 corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    return loop_from_points(corners);
  }
  std::vector<Loop> bosses(Vec2 center, double radius) {
    if (maybe()) return {};
    return {maybe() ? blob(center, radius * 0.3) : disc(center, radius * 0.2)};
  }
  Vec2 inner_point(double margin) {
    const Box inner = part_.stock->plan.grown(-margin);
    return {random_.between(inner.min.x, inner.max.x), random_.between(inner.min.y, inner.max.y)};
  }

  void closed(FeatureKind kind, Region region) {
    feature_.kind = kind;
    feature_.target = feature_.allowed = {std::move(region)};
  }
  /// Target and allowed of an open feature, as the definition of Feature has them.
  void open(FeatureKind kind, const Region& boundary) {
    const Box& plan = part_.stock->plan;
    const Region stock =
        Region::from_valid_loops(rectangle(plan.min.x, plan.min.y, plan.max.x, plan.max.y), {});
    const Box reach = plan.grown(kOpenReach);
    const Region air = Region::from_valid_loops(rectangle(reach.min.x, reach.min.y, reach.max.x, reach.max.y),
                                                {stock.outer()});
    feature_.kind = kind;
    feature_.target = intersect({boundary}, {stock}, {});
    feature_.allowed = unite({boundary}, {air}, {});
  }

  void make_shape() {
    const Box& s = part_.stock->plan;
    const Vec2 c = inner_point(30);
    switch (random_.below(9)) {
      case 0:
        return closed(FeatureKind::kClosedPocket, Region::from_valid_loops(blob(c, 25), bosses(c, 25)));
      case 1:
        return open(FeatureKind::kPlanarFace,
                    Region::from_valid_loops(rectangle(s.min.x - 5, s.min.y - 5, s.max.x + 5, s.max.y + 5),
                                             bosses(c, 25)));
      case 2:
        return open(FeatureKind::kPlanarFace,
                    Region::from_valid_loops(rectangle(s.min.x - 5, c.y - 10, c.x, s.max.y + 3), {}));
      case 3:
        return open(FeatureKind::kSlot,
                    Region::from_valid_loops(rectangle(s.min.x - 5, c.y - 4, s.max.x + 5, c.y + 4), {}));
      case 4:
        return open(
            FeatureKind::kStep,
            Region::from_valid_loops(rectangle(s.max.x - 20, s.min.y - 5, s.max.x + 20, s.max.y + 5), {}));
      case 5:
        feature_.hole_diameter = random_.between(3, 30);
        feature_.through = maybe();
        return closed(FeatureKind::kRoundHole,
                      Region::from_valid_loops(disc(c, *feature_.hole_diameter / 2), {}));
      case 6:
        return open(FeatureKind::kOutsideProfile,
                    Region::from_valid_loops(rectangle(s.min.x - 5, s.min.y - 5, s.max.x + 5, s.max.y + 5),
                                             {blob(c, 25)}));
      case 7:
        return rounded_slot(c);
      default:
        return open(FeatureKind::kOpenPocket, Region::from_valid_loops(blob({s.min.x + 3, c.y}, 25), {}));
    }
  }

  void rounded_slot(Vec2 c) {
    const Vec2 along = direction_of(random_.between(0, 2 * kPi)), side = left_of(along) * 4,
               a = c - along * 12, b = c + along * 12;
    closed(FeatureKind::kSlot,
           Region::from_valid_loops(
               {Edge::line(a - side, b - side), Edge::arc(b - side, b + side, b, Turn::kCounterClockwise),
                Edge::line(b + side, a + side), Edge::arc(a + side, a - side, a, Turn::kCounterClockwise)},
               {}));
  }

  void make_feature() {
    feature_ = Feature();
    make_shape();
    feature_.name = "feature " + std::to_string(part_.features.size() + 1);
    feature_.floor_z = -random_.between(1, 55);
    if (feature_.kind == FeatureKind::kClosedPocket && maybe())
      feature_.wall_slope = Radians::of(random_.between(0.01, 0.2));
    if (feature_.target.size() != 1) return;
    const bool hole = feature_.kind == FeatureKind::kRoundHole;
    part_.features.push_back(feature_);
    const auto steps = 1 + random_.below(2);
    for (std::uint64_t i = 0; i < steps; ++i) {
      Workingstep step;
      step.name = "step " + std::to_string(part_.workplan.size());
      step.feature = static_cast<int>(part_.features.size()) - 1;
      step.operation = operation(hole);
      part_.workplan.push_back(step);
    }
  }

  Random random_;
  Part part_;
  Feature feature_;
};

TEST(StepNcRoundTrip, RandomParts) {
  int features = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Part part = RandomPart(seed).make();
    const bool something_to_cut = std::all_of(part.features.begin(), part.features.end(),
                                              [](const Feature& f) { return f.top_z > f.floor_z + 1e-6; });
    if (part.features.empty() || !something_to_cut) continue;
    features += static_cast<int>(part.features.size());
    const std::string text = post::write_stepnc(part);
    ASSERT_EQ(text, post::write_stepnc(part));
    const Part again = read::stepnc::read_stepnc(text, "again.p21", {});
    expect_same_part(part, again);
    if (HasFailure()) break;
  }
  EXPECT_GT(features, 300);
}

}  // namespace
}  // namespace clearcut
