// Random STEP-NC programs (CLEARCUT_STEPNC says how many) from their text to the text of the machine's program, against the solid that the
// generator means: heights at points, cut along every way of the program. It shares neither reader nor geometry with what it judges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <sstream>

#include "base/error.h"
#include "pipeline/run.h"
#include "post/part/part_writers.h"
#include "read/job/read_part.h"
#include "read/stepnc/stepnc.h"
#include "support/independent/plain_gcode.h"

namespace clearcut {
namespace {

constexpr double kPiHere = 3.14159265358979323846;
constexpr double kSagittaOfArcs = 0.0002;  // mm
constexpr double kPrinted = 0.0012;    // mm; printed digits and chords, where passes lie a whole cutter apart
constexpr double kMostGouge = 0.012;   // mm; printed digits, chords, tolerances of the plan
constexpr double kMostLeft = 0.012;    // mm, over floors
constexpr double kBesideWalls = 0.02;  // mm; nearer points are judged by neither side

int program_count() {
  const char* set = std::getenv("CLEARCUT_STEPNC");
  return set != nullptr ? std::atoi(set) : 12;
}

int first_seed() {
  const char* set = std::getenv("CLEARCUT_STEPNC_SEED");
  return set != nullptr ? std::atoi(set) : 1;
}

struct Point {
  double x = 0, y = 0;
};

/// A cylinder, cuboid or capsule that is removed, or a boss in it: in its own frame, turned and placed.
struct Shape {
  enum class Kind { kCircle, kRectangle, kCapsule } kind = Kind::kCircle;
  double a = 0, b = 0;  ///< radius; half sides; half length and radius
  double corner = 0;    ///< kRectangle: radius of its corners
  Point place;
  double turn = 0;

  /// mm to its outline, negative inside.
  double distance(Point p) const {
    const double c = std::cos(turn), s = std::sin(turn);
    const double x = c * (p.x - place.x) + s * (p.y - place.y),
                 y = -s * (p.x - place.x) + c * (p.y - place.y);
    if (kind == Kind::kCircle) return std::hypot(x, y) - a;
    if (kind == Kind::kCapsule) return std::hypot(std::max(std::abs(x) - a, 0.0), y) - b;
    const double u = std::abs(x) - (a - corner), v = std::abs(y) - (b - corner);
    return std::hypot(std::max(u, 0.0), std::max(v, 0.0)) + std::min(std::max(u, v), 0.0) - corner;
  }
};

struct Boss {
  Shape shape;
  double top = 0;
};

/// What the cutter's form leaves, rather than a floor and upright walls.
enum class Form { kUpright, kVee, kHalfRound, kChamfer, kLeaning, kFilleted };

struct Volume {
  Shape shape;
  Form form = Form::kUpright;
  double wide = 0;  ///< mm: kChamfer: on the top; kLeaning: how far its wall comes in down to its floor
  double floor = 0;
  int tool = 1;
  bool drilled = false;
  std::vector<Boss> bosses;
};

/// mm of cutters by T number.
const std::map<int, double> kCutters{{1, 6}, {2, 4}, {3, 5}, {4, 8}, {5, 5}, {6, 6}, {7, 11}};
constexpr int kCone = 4;  ///< of 90 degrees
constexpr int kBall = 5;
constexpr int kBullNose = 6;
constexpr int kDisc = 7;
constexpr double kBullNoseCorner = 1.5;                ///< mm
constexpr double kDiscHeight = 2;                      ///< mm
constexpr double kBlockWidth = 80, kBlockHeight = 20;  ///< mm
constexpr double kDrillPoint = 1.55;                   ///< mm; longer than the point of the drill

const std::map<int, std::string> kBodies{{1, "ENDMILL"},     {2, "ENDMILL"},      {3, "TWIST_DRILL"},
                                         {4, "COUNTERSINK"}, {5, "BALL_ENDMILL"}, {6, "BULLNOSE_ENDMILL"},
                                         {7, "T_SLOT_MILL"}};

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  std::vector<Volume> volumes;  ///< of the first set-up
  std::vector<Volume>
      volumes_over;  ///< of the second, in which the block is turned over; empty where there is none

  std::string text() {
    inch_ = chance(0.25);
    const std::string head = program_head();
    add_features();
    const std::string steps = list_of_steps();
    if (!chance(0.3)) {
      put(2, "WORKPLAN('MAIN',(" + steps + "),$,#4,$)");
      return head + body_.str() + "ENDSEC;\nEND-ISO-10303-21;\n";
    }
    steps_.clear();
    is_over_ = true;
    std::swap(volumes, volumes_over);
    add_features();
    std::swap(volumes, volumes_over);
    put(2, "WORKPLAN('MAIN',(#40,#41),$,$,$)");
    put(40, "WORKPLAN('ABOVE',(" + steps + "),$,#4,$)");
    put(41, "WORKPLAN('BELOW',(" + list_of_steps() + "),$,#42,$)");
    put(42, "SETUP('OVER',$,#44,(#43))");
    put(43, "WORKPIECE_SETUP(#3,#47,$,$,())");
    put(44, "PLANE('SECURITY',#45)");
    put(45, "AXIS2_PLACEMENT_3D('',#46,$,$)");
    put(46, "CARTESIAN_POINT('',(0.,0.," + length(50) + "))");
    put(47, "AXIS2_PLACEMENT_3D('',$,#49,$)");
    put(49, "DIRECTION('',(0.,0.,-1.))");
    return head + body_.str() + "ENDSEC;\nEND-ISO-10303-21;\n";
  }

  void add_features() {
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 2; ++row)
        if (chance(0.6) || volumes.empty()) add_feature({20 + 40.0 * column, 20 + 40.0 * row});
    if (chance(0.4)) add_step();
  }

  std::string list_of_steps() const {
    std::string steps;
    for (const int step : steps_) steps += (steps.empty() ? "#" : ",#") + std::to_string(step);
    return steps;
  }

  /// The same with one attribute of one entity unset.
  std::string without_one(const std::string& text) {
    std::vector<std::size_t> commas;
    for (std::size_t i = text.find("DATA;"); i < text.size(); ++i)
      if (text[i] == ',' || (text[i] == '(' && text[i - 1] != '(')) commas.push_back(i);
    const std::size_t begin = commas[below(commas.size())] + 1;
    const std::size_t end = text.find_first_of(",)(", begin);
    return text.substr(0, begin) + "$" +
           (text[end] == '(' ? text.substr(text.find(')', end) + 1) : text.substr(end));
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance(double share) { return between(0, 1) < share; }
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  std::string length(double mm) const {
    char text[40];
    std::snprintf(text, sizeof text, "%.9f", inch_ ? mm / 25.4 : mm);
    return text;
  }
  static std::string real(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.12f", value);
    return text;
  }
  void put(int id, const std::string& entity) { body_ << "#" << id << "=" << entity << ";\n"; }
  std::string add(const std::string& entity) {
    put(++last_, entity);
    return "#" + std::to_string(last_);
  }
  std::string point(double x, double y, double z) {
    return add("CARTESIAN_POINT('',(" + length(x) + "," + length(y) + "," + length(z) + "))");
  }
  std::string placement(Point at, double z, double turn) {
    const std::string place = point(at.x, at.y, z);
    if (turn == 0) return add("AXIS2_PLACEMENT_3D(''," + place + ",$,$)");
    const std::string x = add("DIRECTION('',(" + real(std::cos(turn)) + "," + real(std::sin(turn)) + ",0.))");
    return add("AXIS2_PLACEMENT_3D(''," + place + ",#50," + x + ")");
  }
  /// Of a feature in the workpiece, at a point of the block as it lies in its set-up with its top at zero.
  std::string feature_placement(Point at, double z, double turn) {
    if (!is_over_) return placement(at, z, turn);
    const std::string place = point(at.x, kBlockWidth - at.y, -kBlockHeight - z);
    const std::string x =
        add("DIRECTION('',(" + real(std::cos(turn)) + "," + real(-std::sin(turn)) + ",0.))");
    return add("AXIS2_PLACEMENT_3D(''," + place + ",#49," + x + ")");
  }
  std::string measure(double mm) { return add("TOLERANCED_LENGTH_MEASURE(" + length(mm) + ",$)"); }
  std::string depth_plane(double z) { return add("PLANE('DEPTH'," + placement({}, z, 0) + ")"); }

  std::string program_head() {
    put(1, "PROJECT('P',#2,(#3),$,$,$)");
    put(3, "WORKPIECE('WP',$,$,$,$,#5,())");
    put(4, "SETUP('S',$,#7,(#9))");
    put(5, "BLOCK('B',#6," + length(120) + "," + length(80) + "," + length(20) + ")");
    put(6, "AXIS2_PLACEMENT_3D('',#60,$,$)");
    put(60, "CARTESIAN_POINT('',(0.,0.," + length(-20) + "))");
    put(7, "PLANE('SECURITY',#8)");
    put(8, "AXIS2_PLACEMENT_3D('',#61,$,$)");
    put(61, "CARTESIAN_POINT('',(0.,0.," + length(30) + "))");
    put(9, "WORKPIECE_SETUP(#3,$,$,$,())");
    put(50, "DIRECTION('',(0.,0.,1.))");
    if (inch_) {
      put(51, "(GLOBAL_UNIT_ASSIGNED_CONTEXT((#52))REPRESENTATION_CONTEXT('',''))");
      put(52, "(CONVERSION_BASED_UNIT('INCH',#53)LENGTH_UNIT()NAMED_UNIT($))");
      put(53, "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#54)");
      put(54, "(LENGTH_UNIT()NAMED_UNIT($)SI_UNIT(.MILLI.,.METRE.))");
    }
    for (const auto& [number, diameter] : kCutters) {
      const std::string n = std::to_string(70 + 3 * number), body = std::to_string(71 + 3 * number),
                        size = std::to_string(72 + 3 * number);
      put(70 + 3 * number, "MILLING_CUTTING_TOOL('T" + std::to_string(number) + "',#" + body + ",(),$,$,$)");
      const std::string more = number == kCone   ? ",$"
                               : number == kDisc ? "," + length(kDiscHeight)
                                                 : std::string();
      put(71 + 3 * number, kBodies.at(number) + "(#" + size + ",2,.RIGHT.,$,$" + more + ")");
      const std::string angle = number == kCone ? real(kPiHere / 2) : "$";
      const std::string corner = number == kBall       ? length(diameter / 2)
                                 : number == kBullNose ? length(kBullNoseCorner)
                                 : number < 3          ? "0."
                                                       : "$";
      put(72 + 3 * number, "MILLING_TOOL_DIMENSION(" + length(diameter) + "," + angle + ",$," + length(25) +
                               "," + corner + ",$,$)");
    }
    put(98, "MILLING_TECHNOLOGY(0.01,.TCP.,$,-100.,$,$,$,$,$)");
    put(99, "MILLING_MACHINE_FUNCTIONS(.T.,$,$,.F.,$,(),.F.,$,$,())");
    last_ = 100;
    return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('MACHINING_SCHEMA'));\nENDSEC;\nDATA;\n";
  }

  std::string strategy() {
    switch (below(5)) {
      case 0:
        return add("CONTOUR_PARALLEL(0.5,.T.,.CCW.,.CLIMB.)");
      case 1:
        return add("BIDIRECTIONAL_MILLING(0.5,.T.,$,$,$)");
      case 2:
        return add("CONTOUR_SPIRAL($,.T.,.CCW.,$)");
      default:
        return "$";
    }
  }
  std::string approach() {
    switch (below(4)) {
      case 0:
        return add("PLUNGE_RAMP($,0.08)");
      case 1:
        return add("PLUNGE_HELIX($," + length(1) + ",0.06)");
      default:
        return "$";
    }
  }
  std::string milling(int tool, double depth) {
    const bool finishes = chance(0.2);
    return add(std::string(finishes ? "BOTTOM_AND_SIDE_FINISH_MILLING" : "BOTTOM_AND_SIDE_ROUGH_MILLING") +
               "($,$,'OP',$,$,#" + std::to_string(70 + 3 * tool) + ",#98,#99,$," + approach() + ",$," +
               strategy() + "," + (chance(0.5) ? length(depth / 2) : "$") + ",$,$,$)");
  }
  void work_on(const std::string& feature, const std::string& operation) {
    add("MACHINING_WORKINGSTEP('WS',#7," + feature + "," + operation + ",$)");
    steps_.push_back(last_);
  }

  void add_feature(Point middle) {
    const double depth = between(2, 12);
    switch (below(8)) {
      case 6:
        return add_filleted(middle, depth);
      case 7:
        return add_t_slot(middle);
      case 0:
        return add_pocket(middle, depth);
      case 1:
        return add_slot(middle, depth);
      case 2:
        return add_hole(middle, depth);
      case 3:
        return add_groove(middle, depth, kCone);
      case 4:
        return add_groove(middle, depth, kBall);
      default:
        return add_ring_of_holes(middle, depth);
    }
  }

  void add_pocket(Point middle, double depth) {
    Volume volume;
    volume.floor = -depth;
    volume.tool = chance(0.5) ? 1 : 2;
    volume.shape.turn = chance(0.5) ? 0 : between(0, 6);
    volume.shape.place = middle;
    const bool is_round = chance(0.4);
    const double corner = is_round || chance(0.5) ? 0 : 0.5 * kCutters.at(volume.tool) + between(0.1, 1);
    volume.shape.kind = is_round ? Shape::Kind::kCircle : Shape::Kind::kRectangle;
    volume.shape.a = between(9, is_round ? 17 : 12.5);
    volume.shape.b = between(9, 12.5);
    volume.shape.corner = corner;
    const std::string place = feature_placement(middle, 0, volume.shape.turn);
    const std::string profile = is_round
                                    ? add("CIRCULAR_CLOSED_PROFILE($," + measure(2 * volume.shape.a) + ")")
                                    : add("RECTANGULAR_CLOSED_PROFILE($," + measure(2 * volume.shape.b) +
                                          "," + measure(2 * volume.shape.a) + ")");
    std::string bosses;
    if (chance(0.4)) {
      Boss boss;
      boss.shape.a = between(0.8, 2);
      boss.shape.place = middle;
      const double down = chance(0.5) ? 0 : between(0.3, depth - 0.5);
      boss.top = -down;
      bosses = add("BOSS('B',#3,()," + placement({}, -down, 0) + "," + depth_plane(-depth + down) + "," +
                   add("CIRCULAR_CLOSED_PROFILE($," + measure(2 * boss.shape.a) + ")") + ",$)");
      volume.bosses.push_back(boss);
    }
    const std::string operation = milling(volume.tool, depth);
    work_on(add("CLOSED_POCKET('POCKET',#3,(" + operation + ")," + place + "," + depth_plane(-depth) + ",(" +
                bosses + "),$," + add("PLANAR_POCKET_BOTTOM_CONDITION()") + ",$," +
                (corner > 0 ? measure(corner) : "$") + "," + profile + ")"),
            operation);
    volumes.push_back(volume);
    if (volume.bosses.empty() && chance(0.4)) add_chamfer(volume, last_ - 1);
  }

  /// A round pocket whose floor meets its wall in a fillet, by a bull-nose mill of that radius.
  void add_filleted(Point middle, double depth) {
    Volume volume;
    volume.form = Form::kFilleted;
    volume.floor = -depth;
    volume.tool = kBullNose;
    volume.shape.a = between(8, 17);
    volume.shape.place = middle;
    const std::string operation = milling(kBullNose, depth);
    work_on(add("CLOSED_POCKET('ROUNDED',#3,(" + operation + ")," + feature_placement(middle, 0, 0) + "," +
                depth_plane(-depth) + ",(),$," + add("PLANAR_POCKET_BOTTOM_CONDITION()") + "," +
                measure(kBullNoseCorner) + ",$," +
                add("CIRCULAR_CLOSED_PROFILE($," + measure(2 * volume.shape.a) + ")") + ")"),
            operation);
    volumes.push_back(volume);
  }

  /// From the left edge of the block as far as `middle`, by a mill for its neck and a disc below. Seen from above it is its neck.
  void add_t_slot(Point middle) {
    if (middle.x > 40) return add_hole(middle, 5);
    Volume volume;
    volume.floor = -between(5, 9);
    volume.tool = 1;
    volume.shape.kind = Shape::Kind::kCapsule;
    volume.shape.a = middle.x;
    volume.shape.b = 3.5;
    volume.shape.place = {0, middle.y};
    const std::string path =
        add("LINEAR_PATH($," + measure(middle.x) + "," + add("DIRECTION('',(1.,0.,0.))") + ")");
    const std::string section = add("TEE_PROFILE($,0.,0.," + measure(kCutters.at(kDisc)) + "," +
                                    measure(kDiscHeight) + ",$," + measure(2 * volume.shape.b) + ",$,$)");
    const std::string ends = "(" + add("OPEN_SLOT_END_TYPE()") + "," + add("RADIUSED_SLOT_END_TYPE()") + ")";
    const std::string neck = milling(1, -volume.floor), disc = milling_by(kDisc, "$");
    const std::string slot =
        add("SLOT('TEE',#3,(" + neck + "," + disc + ")," + feature_placement({0, middle.y}, 0, 0) + "," +
            depth_plane(volume.floor) + "," + path + "," + section + "," + ends + ")");
    work_on(slot, neck);
    work_on(slot, disc);
    volumes.push_back(volume);
  }

  /// About a pocket, by its angle of 45 degrees; the face that the edge lies in is there before.
  void add_chamfer(const Volume& pocket, int entity) {
    Volume volume = pocket;
    volume.form = Form::kChamfer;
    volume.tool = kCone;
    volume.wide = between(0.3, 1.2);
    volume.floor = -volume.wide;
    const std::string face =
        add("PLANAR_FACE('FACE',#3,()," + feature_placement({}, 2, 0) + "," + depth_plane(-2) + ",$,$,$,())");
    const std::string walls = "#" + std::to_string(entity), operation = milling_by(kCone, "$");
    work_on(add("CHAMFER('EDGE',#3,(" + operation + ")," +
                (chance(0.5) ? face + "," + walls : walls + "," + face) + "," + real(kPiHere / 4) + "," +
                measure(volume.wide) + ")"),
            operation);
    volumes.push_back(volume);
  }

  std::string milling_by(int tool, const std::string& stepdown) {
    return add("BOTTOM_AND_SIDE_FINISH_MILLING($,$,'OP',$,$,#" + std::to_string(70 + 3 * tool) +
               ",#98,#99,$,$,$,$," + stepdown + ",$,$,$)");
  }

  /// A vee of 90 degrees, or a slot that the ball makes at once, its lower part half round.
  void add_groove(Point middle, double depth, int tool) {
    Volume volume;
    volume.form = tool == kCone ? Form::kVee : Form::kHalfRound;
    volume.tool = tool;
    const double down =
        tool == kCone ? between(0.5, 3.8) : kCutters.at(kBall) / 2 + (chance(0.5) ? 0 : 0.3 * depth);
    volume.floor = -down;
    volume.shape.kind = Shape::Kind::kCapsule;
    volume.shape.turn = chance(0.5) ? 0 : between(0, 6);
    volume.shape.a = between(3, 9);
    volume.shape.b = tool == kCone ? down : kCutters.at(kBall) / 2;
    volume.shape.place = middle;
    const double half = volume.shape.a, c = std::cos(volume.shape.turn), s = std::sin(volume.shape.turn);
    const std::string place =
        feature_placement({middle.x - half * c, middle.y - half * s}, 0, volume.shape.turn);
    const std::string path =
        add("LINEAR_PATH($," + measure(2 * half) + "," + add("DIRECTION('',(1.,0.,0.))") + ")");
    const std::string end = add("RADIUSED_SLOT_END_TYPE()");
    const std::string section = tool == kCone
                                    ? add("VEE_PROFILE($,$," + real(kPiHere / 2) + "," +
                                          (chance(0.5) ? "$" : real(kPiHere / 4)) + ")")
                                    : add("ROUNDED_U_PROFILE($," + measure(kCutters.at(kBall)) + ")");
    const std::string operation = milling_by(tool, chance(0.5) ? length(1.5) : "$");
    work_on(add("SLOT('GROOVE',#3,(" + operation + ")," + place + "," + depth_plane(-down) + "," + path +
                "," + section + ",(" + end + "," + end + "))"),
            operation);
    volumes.push_back(volume);
  }

  /// Along the whole front of the block, its wall leaning.
  void add_step() {
    Volume volume;
    volume.form = Form::kLeaning;
    const double wide = between(0.5, 0.9), depth = between(1, 4);
    const double lean = chance(0.3) ? 0 : between(0.2, 0.8) * std::atan(wide / depth);
    volume.floor = -depth;
    volume.wide = depth * std::tan(lean);
    volume.shape.kind = Shape::Kind::kRectangle;
    volume.shape.place = {60, wide - 50};
    volume.shape.a = 200;
    volume.shape.b = 50;
    const std::string angle = real(kPiHere / 2 + lean);
    const std::string path =
        add("LINEAR_PATH($," + measure(120) + "," + add("DIRECTION('',(1.,0.,0.))") + ")");
    const std::string operation = milling_by(1, "$");
    work_on(add("STEP('STEP',#3,(" + operation + ")," + feature_placement({0, wide}, 0, 0) + "," +
                depth_plane(-depth) + "," + path + "," + add("VEE_PROFILE($,$," + angle + "," + angle + ")") +
                ",())"),
            operation);
    volumes.push_back(volume);
  }

  void add_slot(Point middle, double depth) {
    Volume volume;
    volume.floor = -depth;
    volume.tool = chance(0.5) ? 1 : 2;
    volume.shape.kind = Shape::Kind::kCapsule;
    volume.shape.turn = chance(0.5) ? 0 : between(0, 6);
    volume.shape.a = between(3, 9);
    volume.shape.b = kCutters.at(volume.tool) / 2 + between(0.2, 2);
    volume.shape.place = middle;
    const double half = volume.shape.a, c = std::cos(volume.shape.turn), s = std::sin(volume.shape.turn);
    const std::string place =
        feature_placement({middle.x - half * c, middle.y - half * s}, 0, volume.shape.turn);
    const std::string path =
        add("LINEAR_PATH($," + measure(2 * half) + "," + add("DIRECTION('',(1.,0.,0.))") + ")");
    const std::string end = add("RADIUSED_SLOT_END_TYPE()");
    const std::string operation = milling(volume.tool, depth);
    work_on(add("SLOT('SLOT',#3,(" + operation + ")," + place + "," + depth_plane(-depth) + "," + path + "," +
                add("SQUARE_U_PROFILE($," + measure(2 * volume.shape.b) + ",$,$,$,$)") + ",(" + end + "," +
                end + "))"),
            operation);
    volumes.push_back(volume);
  }

  Volume hole_at(Point at, double radius, double depth, int tool) {
    Volume volume;
    volume.floor = -depth;
    volume.tool = tool;
    volume.drilled = tool == 3;
    volume.shape.a = radius;
    volume.shape.place = at;
    return volume;
  }
  std::string hole(const std::string& place, double radius, double depth, const std::string& operation) {
    return add("ROUND_HOLE('HOLE',#3,(" + operation + ")," + place + "," + depth_plane(-depth) + "," +
               measure(2 * radius) + ",$," + add("FLAT_HOLE_BOTTOM()") + ")");
  }
  std::string drilling() { return add("DRILLING($,$,'DRILL',$,$,#79,#98,#99,$,$,$,$,$,$)"); }

  void add_hole(Point middle, double depth) {
    const bool drilled = chance(0.5);
    const int tool = drilled ? 3 : 2;
    const double radius = drilled ? 2.5 : between(2.4, 9);
    const std::string place = feature_placement(middle, 0, 0),
                      operation = drilled ? drilling() : milling(tool, depth);
    work_on(hole(place, radius, depth, operation), operation);
    volumes.push_back(hole_at(middle, radius, depth, tool));
  }

  void add_ring_of_holes(Point middle, double depth) {
    const int count = 3 + static_cast<int>(below(4));
    const double ring = between(8, 14), step = 2 * kPiHere / count;
    const std::string operation = drilling();
    const std::string base =
        hole(feature_placement({middle.x + ring, middle.y}, 0, 0), 2.5, depth, operation);
    work_on(add("CIRCULAR_PATTERN('RING',#3,(" + operation + ")," + feature_placement(middle, 0, 0) + "," +
                base + "," + real(step) + "," + std::to_string(count) + ",(),()," + measure(2 * ring) + "," +
                real(0) + ")"),
            operation);
    for (int i = 0; i < count; ++i)
      volumes.push_back(hole_at({middle.x + ring * std::cos(i * step), middle.y + ring * std::sin(i * step)},
                                2.5, depth, 3));
  }

  std::mt19937 random_;
  std::ostringstream body_;
  std::vector<int> steps_;
  int last_ = 100;
  bool inch_ = false;
  bool is_over_ = false;
};

/// Lowest z of the tip over the part of a way that lies within `radius` of p; nothing where it does not come so near.
std::optional<double> lowest_within(Point p, const test_support::TipWay& way, double radius) {
  const double dx = way.x1 - way.x0, dy = way.y1 - way.y0, ex = way.x0 - p.x, ey = way.y0 - p.y;
  const double aa = dx * dx + dy * dy, bb = ex * dx + ey * dy, cc = ex * ex + ey * ey - radius * radius;
  double low = 0, high = 1;
  if (aa > 0) {
    const double root = bb * bb - aa * cc;
    if (root < 0) return std::nullopt;
    low = std::max(0.0, (-bb - std::sqrt(root)) / aa);
    high = std::min(1.0, (-bb + std::sqrt(root)) / aa);
    if (low > high) return std::nullopt;
  } else if (cc > 0) {
    return std::nullopt;
  }
  return std::min(way.z0 + low * (way.z1 - way.z0), way.z0 + high * (way.z1 - way.z0));
}

/// mm; how high what cuts stands over the tip, `away` mm from its axis.
double over_tip(int tool, double away) {
  const double radius = kCutters.at(tool) / 2;
  if (tool == kCone) return away;
  if (tool == kBullNose) {
    const double over = std::max(0.0, away - (radius - kBullNoseCorner));
    return kBullNoseCorner - std::sqrt(std::max(0.0, kBullNoseCorner * kBullNoseCorner - over * over));
  }
  return tool == kBall ? radius - std::sqrt(std::max(0.0, radius * radius - away * away)) : 0;
}

/// The same as lowest_within() for cutters whose ends are not flat: what they leave is convex along a straight way.
std::optional<double> lowest_of_form(Point p, const test_support::TipWay& way, double wider) {
  if (!lowest_within(p, way, kCutters.at(way.tool) / 2 + wider)) return std::nullopt;
  const auto left_at = [&](double t) {
    const double x = way.x0 + t * (way.x1 - way.x0), y = way.y0 + t * (way.y1 - way.y0);
    const double away = std::max(0.0, std::hypot(x - p.x, y - p.y) - wider);
    if (away > kCutters.at(way.tool) / 2) return 1000 + away;
    return way.z0 + t * (way.z1 - way.z0) + over_tip(way.tool, away);
  };
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (left_at(a) < left_at(b) ? high : low) = left_at(a) < left_at(b) ? b : a;
  }
  return left_at((low + high) / 2);
}

/// What stands at p in the end, by cutters a little narrower or wider than they are.
double height_at(Point p, const std::vector<test_support::TipWay>& ways, double wider) {
  double height = 0;
  for (const auto& way : ways) {
    // What a disc takes lies below what it leaves.
    if (way.tool == kDisc || std::min(way.z0, way.z1) >= height) continue;
    const bool is_flat = way.tool != kCone && way.tool != kBall && way.tool != kBullNose;
    const auto low =
        is_flat ? lowest_within(p, way, kCutters.at(way.tool) / 2 + wider) : lowest_of_form(p, way, wider);
    if (low) height = std::min(height, *low);
  }
  return height;
}

/// What the generator means to stand at p; nothing where it lies too near a wall, under the point of a drill, or out of the cutter's reach.
struct Meant {
  double at_least = 0;
  std::optional<double> at_most;
};

/// mm. The wall of a half-round slot is too steep beyond to be judged by heights.
constexpr double kSteep = 0.3;

/// What the cutter's form leaves there of a volume; nothing where that is judged by neither side.
std::optional<Meant> formed_at(Point p, const Volume& volume) {
  const double away = volume.shape.distance(p);
  if (volume.form == Form::kChamfer) {
    if (std::abs(away) < kBesideWalls || std::abs(away - volume.wide) < kBesideWalls) return std::nullopt;
    if (away < 0 || away > volume.wide) return Meant{0, 1000};
    const double height = away - volume.wide;
    // Where the pocket has corners the mill's roundings keep the cone off them.
    const bool is_round = volume.shape.kind == Shape::Kind::kCircle;
    return Meant{height, is_round ? std::optional(height) : std::nullopt};
  }
  if (std::abs(away) < kBesideWalls) return std::nullopt;
  if (away > 0) return Meant{0, 1000};
  if (volume.form == Form::kFilleted) {
    const double over = std::max(0.0, kBullNoseCorner + away);
    if (over > 0.8 * kBullNoseCorner) return std::nullopt;  // too steep to be judged by heights
    const double height = volume.floor + kBullNoseCorner -
                          std::sqrt(std::max(0.0, kBullNoseCorner * kBullNoseCorner - over * over));
    return Meant{height, height};
  }
  if (volume.form == Form::kLeaning) {
    const double lean = volume.wide / -volume.floor, down = lean > 0 ? -away / lean : 1000;
    if (down < -volume.floor) return Meant{-down, std::nullopt};
    return Meant{volume.floor, -away > volume.wide + 0.05 ? std::optional(volume.floor) : std::nullopt};
  }
  const double from_line = away + volume.shape.b;
  if (volume.form == Form::kVee) return Meant{volume.floor + from_line, volume.floor + from_line};
  if (-away < kSteep) return std::nullopt;
  const double height = volume.floor + over_tip(kBall, from_line);
  return Meant{height, height};
}

std::optional<Meant> meant_at(Point p, const std::vector<Volume>& volumes) {
  Meant meant{0, 0};
  for (const Volume& volume : volumes) {
    if (volume.form != Form::kUpright) {
      const auto formed = formed_at(p, volume);
      if (!formed) return std::nullopt;
      if (formed->at_most == 1000.0) continue;
      meant.at_least = std::min(meant.at_least, formed->at_least);
      meant.at_most = formed->at_most;
      continue;
    }
    const double away = volume.shape.distance(p), radius = kCutters.at(volume.tool) / 2;
    if (std::abs(away) < kBesideWalls) return std::nullopt;
    if (away > 0) continue;
    double height = volume.floor, from_boss = 1000;
    for (const Boss& boss : volume.bosses) {
      from_boss = boss.shape.distance(p);
      if (std::abs(from_boss) < kBesideWalls) return std::nullopt;
      if (from_boss < 0) height = boss.top;
    }
    meant.at_least = std::min(meant.at_least, height);
    const bool reached = volume.drilled || (-away > radius && std::abs(from_boss) > radius) ||
                         (-away > radius && from_boss < 0);
    if (!reached)
      meant.at_most.reset();
    else
      meant.at_most = volume.drilled ? height + kDrillPoint : height;
  }
  return meant;
}

/// The disc of a T slot goes along the middle of it, no deeper.
void expect_disc_in_slot(const std::vector<Volume>& volumes, const std::vector<test_support::TipWay>& ways,
                         unsigned seed) {
  for (const auto& way : ways) {
    const double z = std::min(way.z0, way.z1);
    if (way.tool != kDisc || z > -kMostGouge) continue;
    const bool is_in_slot = std::any_of(volumes.begin(), volumes.end(), [&](const Volume& volume) {
      const double middle = volume.shape.place.y;
      return z > volume.floor - kMostGouge && std::abs(way.y0 - middle) < kMostGouge &&
             std::abs(way.y1 - middle) < kMostGouge && std::max(way.x0, way.x1) < volume.shape.a + kMostGouge;
    });
    const bool is_outside = std::max(way.x0, way.x1) < -kCutters.at(kDisc) / 2 + kMostGouge;
    ASSERT_TRUE(is_in_slot || is_outside) << "seed " << seed << ": the disc at " << way.x1 << ", " << way.y1;
  }
}

/// `over`: the coordinates of the set-up in which the block is turned over.
void expect_meant(const std::vector<Volume>& volumes, const std::string& program, unsigned seed,
                  bool over = false) {
  auto ways = test_support::ways_of(program, kSagittaOfArcs);
  for (auto& way : ways) {
    if (!over) break;
    way.y0 += kBlockWidth, way.y1 += kBlockWidth;
    way.z0 -= kBlockHeight, way.z1 -= kBlockHeight;
  }
  expect_disc_in_slot(volumes, ways, seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(0, 120), y(0, 80);
  for (int i = 0; i < 500; ++i) {
    const Point p{x(random), y(random)};
    const auto meant = meant_at(p, volumes);
    if (!meant) continue;
    const double certain = height_at(p, ways, kPrinted), possible = height_at(p, ways, -0.01);
    ASSERT_GE(possible, meant->at_least - kMostGouge)
        << "seed " << seed << ": cut too deep at " << p.x << ", " << p.y << "\n";
    if (!meant->at_most) continue;
    ASSERT_LE(certain, *meant->at_most + kMostLeft)
        << "seed " << seed << ": left standing at " << p.x << ", " << p.y << "\n";
  }
}

PlanResult planned(const Part& part) {
  PlanOptions options;
  options.accept = {"out-of-reach"};
  options.post.dialect = "grbl";  // without cycles
  return pipeline::plan_part(part, options);
}

/// Which is not written back.
bool has_t_slot(const std::string& text) {
  return text.find("TEE_PROFILE") != std::string::npos;
}

TEST(RandomStepNc, PlansAreTheSolidsThatTheirFilesMean) {
  int clean = 0;
  const int count = program_count();
  for (int seed = first_seed(); seed < first_seed() + count; ++seed) {
    Generator generator(static_cast<unsigned>(seed));
    const std::string text = generator.text();
    SetupPlace place;
    const PlanResult plan = planned(read::stepnc::read_setup(text, "random.p21", {}, 1, place));
    clean += verdict_of(plan.findings) == Verdict::kClean;
    EXPECT_EQ(verdict_and_reasons(plan.findings), "CLEAN\n") << "seed " << seed;
    expect_meant(generator.volumes, plan.program, static_cast<unsigned>(seed));
    if (!generator.volumes_over.empty()) {
      const auto below = planned(read::stepnc::read_setup(text, "random.p21", {}, 2, place));
      EXPECT_EQ(verdict_and_reasons(below.findings), "CLEAN\n") << "seed " << seed << ", turned over";
      expect_meant(generator.volumes_over, below.program, static_cast<unsigned>(seed), true);
    }
    if (seed % 4 != 0 || has_t_slot(text)) continue;
    const Part again = read::read_part_text(post::write_stepnc(plan.part, plan.planned), "again.p21", {});
    expect_meant(generator.volumes, planned(again).program, static_cast<unsigned>(seed));
  }
  EXPECT_GT(clean, count / 2);
}

TEST(RandomStepNc, WithoutAnAttributeTheyAreRefusedInOneLineOrPlanned) {
  int refused = 0, planned_all_the_same = 0;
  for (int seed = 1; seed <= program_count(); ++seed) {
    Generator generator(static_cast<unsigned>(seed));
    const std::string text = generator.without_one(generator.text());
    try {
      planned(read::read_part_text(text, "random.p21", {}));
      ++planned_all_the_same;
    } catch (const InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(refused + planned_all_the_same, 0);
}

}  // namespace
}  // namespace clearcut
