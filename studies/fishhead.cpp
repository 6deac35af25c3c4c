// The part's dimensions are facts taken from the program printed in [tour], appendix 9.1.
#include "studies/fishhead.h"

#include <cmath>

#include "features/standing.h"
#include "geometry/region.h"

namespace clearcut::studies {

namespace {

constexpr double kCorner = 5;  // mm: every rounded corner of the part has this radius

/// A corner of an outline in workpiece coordinates, counter-clockwise; radius of the arc to the next corner,
/// > 0 counter-clockwise, 0 for a line.
struct Vertex {
  double x = 0;
  double y = 0;
  double radius = 0;
};

// The walls that faces 2, 3 and 4 leave standing.
constexpr Vertex kWalls2[] = {
    {29.774, 132.056},        {23.748, 132.056},        {15, 82.154},     {15, 28.126},   {21.96, 28.126},
    {24.4, 47.448},           {24.4, 52.509, -kCorner}, {29.177, 57.504}, {52.45, 57.55}, {52.45, 59.45},
    {30.02, 59.45, -kCorner}, {25.02, 64.45},           {32.546, 106.8}};
constexpr Vertex kWalls3[] = {{100.9, 167.5},
                              {99.599, 167.5},
                              {107.448, 125.518},
                              {112.614, 64.87, -kCorner},
                              {107.842, 59.454},
                              {70.95, 59.45, -kCorner},
                              {65.95, 64.45},
                              {65.954, 94.45},
                              {66.929, 106.811},
                              {63.958, 106.811},
                              {63.968, 102.368},
                              {63.992, 102.084},
                              {63.989, 102.065},
                              {63.998, 101.933},
                              {64, 64.45, -kCorner},
                              {59, 59.45},
                              {30.02, 59.45, -kCorner},
                              {25.02, 64.45},
                              {27.002, 106.8},
                              {29.767, 131.998},
                              {34.5, 167.5},
                              {31.5, 167.5},
                              {25, 139.2},
                              {15, 82.154},
                              {15, 15},
                              {119, 15},
                              {119, 80.65},
                              {110.45, 130.75},
                              {104.001, 161.498}};
constexpr Vertex kWalls4[] = {{93.005, 167.5},
                              {91.075, 167.2},
                              {89.505, 166.295},
                              {88.968, 165.818},
                              {88.005, 164.67},
                              {87.28, 163.04},
                              {78.456, 130.034, -kCorner},
                              {78.256, 129.437},
                              {77.495, 127.752, -kCorner},
                              {76.686, 126.503},
                              {75.184, 124.927, -kCorner},
                              {74.141, 124.142},
                              {72.514, 123.292, -kCorner},
                              {71.287, 122.846},
                              {69.181, 122.466, -kCorner},
                              {68.506, 122.392},
                              {61.344, 122.446, -kCorner},
                              {60.91, 122.483},
                              {58.918, 122.807, -kCorner},
                              {57.668, 123.184},
                              {55.87, 124.081, -kCorner},
                              {54.81, 124.844},
                              {54.313, 125.337},
                              {53.254, 126.469, -kCorner},
                              {52.531, 127.557},
                              {51.664, 129.484, -kCorner},
                              {51.447, 130.063},
                              {42.6, 163.15},
                              {41.75, 165.001},
                              {40.375, 166.4},
                              {38.5, 167.25},
                              {34.5, 167.5},
                              {31.5, 167.5},
                              {25, 139.2},
                              {15, 82.154},
                              {15, 15},
                              {119, 15},
                              {119, 80.65},
                              {110.45, 130.75},
                              {104.001, 161.498},
                              {100.9, 167.5}};

constexpr Vertex kPocket1[] = {{29.177, 57.504, kCorner},
                               {24.4, 52.509},
                               {24.4, 47.448},
                               {21.94, 27.936, kCorner},
                               {26.921, 22.5},
                               {106.8, 22.5, kCorner},
                               {111.8, 27.5},
                               {111.795, 52.687, kCorner},
                               {107.02, 57.466}};
constexpr Vertex kPocket2[] = {
    {70.734, 57.491, kCorner}, {65.955, 52.716}, {65.95, 27.5, kCorner},     {70.95, 22.5},
    {106.8, 22.5, kCorner},    {111.8, 27.5},    {111.795, 52.687, kCorner}, {107.02, 57.466}};
constexpr Vertex kPocket3[] = {{29.177, 57.504, kCorner},
                               {24.4, 52.509},
                               {24.4, 47.448},
                               {21.94, 27.936, kCorner},
                               {26.921, 22.5},
                               {59, 22.5, kCorner},
                               {64, 27.5},
                               {63.996, 52.729, kCorner},
                               {59.021, 57.522}};
constexpr Vertex kPocket4[] = {
    {59, 106.8},    {31.569, 106.796, kCorner}, {26.776, 102.034}, {25.02, 64.45, kCorner},
    {30.02, 59.45}, {59, 59.45, kCorner},       {64, 64.45},       {64, 101.8, kCorner}};
constexpr Vertex kPocket5[] = {{71.693, 105.802, kCorner},
                               {66.645, 101.313},
                               {66.618, 100.9, kCorner},
                               {66.548, 100.47},
                               {66.074, 94.445},
                               {66.07, 64.57, kCorner},
                               {71.07, 59.57},
                               {107.712, 59.574, kCorner},
                               {112.484, 64.99},
                               {109.451, 100.923, kCorner},
                               {104.562, 105.314}};

using Outline = std::span<const Vertex>;

struct Circle {
  Vec2 center;
  double diameter = 0;
};
constexpr Circle kBossInPocket5{{86.6, 84.05}, 8.5};
constexpr Circle kPocket6{{86.6, 84.055}, 14};

constexpr int kFaceMill = 0;  // indices into Part::tools
constexpr int kEndMill = 1;
constexpr double kStepdown = 2;   // mm
constexpr double kSlope = 0.785;  // radians, POCKET3 of the sloped part
constexpr double kScallop = 0.5;  // mm, asked for on its walls
constexpr Stock kBlock{{{0, 0}, {135, 185}}, -40, 0};
constexpr double kSecurityPlane = 10;

/// The smaller arc from one corner to the next.
Edge edge_between(const Vertex& a, const Vertex& b) {
  const Vec2 from{a.x, a.y}, to{b.x, b.y};
  if (a.radius == 0) return Edge::line(from, to);
  const double half = distance(from, to) / 2;
  const double height = std::sqrt(a.radius * a.radius - half * half);
  const Vec2 left = left_of(unit(to - from));
  const bool left_turn = a.radius > 0;
  return Edge::arc(from, to, lerp(from, to, 0.5) + left * (left_turn ? height : -height),
                   left_turn ? Turn::kCounterClockwise : Turn::kClockwise);
}

Loop loop_of(Outline outline) {
  Loop loop;
  for (std::size_t i = 0; i < outline.size(); ++i)
    loop.push_back(edge_between(outline[i], outline[(i + 1) % outline.size()]));
  return loop;
}

Loop loop_of(const Circle& circle) {
  const Vec2 c = circle.center, r{circle.diameter / 2, 0};
  return {Edge::arc(c + r, c - r, c, Turn::kCounterClockwise),
          Edge::arc(c - r, c + r, c, Turn::kCounterClockwise)};
}

/// Collects features with their workingsteps in order of cutting.
class Builder {
 public:
  Builder() {
    part_.name = "fishhead";
    part_.stock = kBlock;
    part_.clearance_z = kSecurityPlane;
    Tool face_mill;
    face_mill.number = 4;
    face_mill.name = "T4";
    face_mill.kind = ToolKind::kFaceMill;
    face_mill.diameter = 40;
    face_mill.center_cutting = false;
    Tool end_mill;
    end_mill.number = 3;
    end_mill.name = "T3";
    end_mill.diameter = 10;
    part_.tools = {face_mill, end_mill};
  }

  /// A face over the whole block but for the walls.
  void face(const char* name, double floor_z, Outline walls, double feed, double rpm) {
    std::vector<Loop> islands;
    if (!walls.empty()) islands.push_back(loop_of(walls));
    Feature feature;
    feature.kind = FeatureKind::kPlanarFace;
    feature.target = {Region::from_valid_loops(rectangle(kBlock.plan), islands)};
    feature.allowed = {Region::from_valid_loops(rectangle(kBlock.plan.grown(kOpenReach)), islands)};
    add(name, std::move(feature), floor_z, walls.empty() ? kFaceMill : kEndMill, feed, rpm);
  }

  void pocket(const char* name, double floor_z, Loop outline, std::vector<Loop> bosses, double feed,
              double rpm) {
    Feature feature;
    feature.target = {Region::from_valid_loops(std::move(outline), std::move(bosses))};
    feature.allowed = feature.target;
    add(name, std::move(feature), floor_z, kEndMill, feed, rpm);
  }

  Part& part() { return part_; }

 private:
  void add(const char* name, Feature feature, double floor_z, int tool, double feed, double rpm) {
    feature.name = name;
    feature.top_z = kBlock.z_top;
    feature.floor_z = floor_z;
    Workingstep step;
    step.name = std::string("WS ") + name;
    step.feature = static_cast<int>(part_.features.size());
    step.operation.name = name;
    step.operation.tool = tool;
    step.operation.stepdown = kStepdown;
    step.operation.cutting.feed = MmPerMin::of(feed);
    step.operation.cutting.spindle_rpm = rpm;
    part_.features.push_back(std::move(feature));
    part_.workplan.push_back(std::move(step));
  }

  Part part_;
};

}  // namespace

Part fishhead(bool sloped, const Tolerances& tol) {
  Builder b;
  b.face("PLANAR_FACE1", -2, {}, 250, 1989);
  b.face("PLANAR_FACE2", -12, kWalls2, 796, 7958);
  b.face("PLANAR_FACE3", -23.5, kWalls3, 250, 7639);
  b.pocket("POCKET1", -17, loop_of(kPocket1), {}, 509, 6366);
  b.pocket("POCKET2", -24.5, loop_of(kPocket2), {}, 509, 6398);
  b.pocket("POCKET3", -26.5, loop_of(kPocket3), {}, 400, 6366);
  b.pocket("POCKET4", -25, loop_of(kPocket4), {}, 828, 8276);
  b.pocket("POCKET5", -25.5, loop_of(kPocket5), {loop_of(kBossInPocket5)}, 250, 6430);
  b.pocket("POCKET6", -27, loop_of(kPocket6), {}, 250, 5730);
  b.face("PLANAR_FACE4", -27, kWalls4, 250, 6525);
  Part part = std::move(b.part());
  if (sloped) {
    part.name = "fishhead with a sloped pocket";
    part.features[5].wall_slope = Radians::of(kSlope);
    part.workplan[5].operation.scallop = kScallop;
  }
  const std::vector<double> tops = features::stacked_tops(part, tol);
  for (std::size_t i = 0; i < tops.size(); ++i) part.features[i].top_z = tops[i];
  return part;
}

}  // namespace clearcut::studies
