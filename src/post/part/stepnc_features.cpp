#include "post/part/stepnc_features.h"

#include <algorithm>
#include <cmath>

#include "base/tolerances.h"
#include "base/units.h"

namespace clearcut::post {

namespace {

bool near(double a, double b) {
  return std::abs(a - b) <= kSamePlaceMm;
}

std::string point(P21Writer& out, Vec2 p, double z = 0) {
  return out.add("CARTESIAN_POINT", {"''", p21_list({p21_real(p.x), p21_real(p.y), p21_real(z)})});
}

std::string direction(P21Writer& out, Vec2 d, double z = 0) {
  return out.add("DIRECTION", {"''", p21_list({p21_real(d.x), p21_real(d.y), p21_real(z)})});
}

std::string length_measure(P21Writer& out, double value) {
  return out.add("TOLERANCED_LENGTH_MEASURE", {p21_real(value), kUnset});
}

std::string polyline(P21Writer& out, const Path& path, std::size_t first, std::size_t last) {
  std::vector<std::string> points{point(out, path[first].from)};
  for (std::size_t i = first; i < last; ++i) points.push_back(point(out, path[i].to));
  return out.add("POLYLINE", {"''", p21_list(points)});
}

std::string trimmed_arc(P21Writer& out, const P21Common& common, const Edge& arc) {
  const std::string circle =
      out.add("CIRCLE", {"''", p21_placement(out, common, arc.center, 0), p21_real(arc.radius())});
  return out.add("TRIMMED_CURVE",
                 {"''", circle, p21_list({point(out, arc.from)}), p21_list({point(out, arc.to)}),
                  arc.turn == Turn::kCounterClockwise ? ".T." : ".F.", ".CARTESIAN."});
}

/// A polyline if the path is straight throughout, else a composite of polylines and trimmed circles.
std::string curve(P21Writer& out, const P21Common& common, const Path& path) {
  const bool straight = std::none_of(path.begin(), path.end(), [](const Edge& e) { return e.is_arc(); });
  if (straight) return polyline(out, path, 0, path.size());
  std::vector<std::string> segments;
  for (std::size_t i = 0; i < path.size();) {
    std::size_t end = i + 1;
    if (!path[i].is_arc())
      while (end < path.size() && !path[end].is_arc()) ++end;
    const std::string piece =
        path[i].is_arc() ? trimmed_arc(out, common, path[i]) : polyline(out, path, i, end);
    segments.push_back(out.add("COMPOSITE_CURVE_SEGMENT", {".CONTINUOUS.", ".T.", piece}));
    i = end;
  }
  return out.add("COMPOSITE_CURVE", {"''", p21_list(segments), ".F."});
}

/// Center of a loop forming one full circle.
std::optional<Vec2> circle_center(const Loop& loop) {
  for (const Edge& edge : loop)
    if (!edge.is_arc() || edge.turn != loop[0].turn || distance(edge.center, loop[0].center) > kSamePlaceMm)
      return std::nullopt;
  return loop[0].center;
}

std::string closed_profile(P21Writer& out, const P21Common& common, const Loop& loop) {
  if (const auto center = circle_center(loop))
    return out.add("CIRCULAR_CLOSED_PROFILE",
                   {p21_placement(out, common, *center, 0), length_measure(out, 2 * loop[0].radius())});
  const Loop outline = signed_area(loop) < 0 ? reversed(loop) : loop;
  return out.add("GENERAL_CLOSED_PROFILE", {kUnset, curve(out, common, outline)});
}

/// The four sides of the stock, and tests for edges on them.
class StockEdge {
 public:
  explicit StockEdge(const std::optional<Stock>& stock) : stock_(stock) {}

  bool carries(const Edge& edge) const {
    if (!stock_ || edge.is_arc()) return false;
    const Box& box = stock_->plan;
    const auto along = [&](double Vec2::*axis, double at) {
      return near(edge.from.*axis, at) && near(edge.to.*axis, at);
    };
    return along(&Vec2::x, box.min.x) || along(&Vec2::x, box.max.x) || along(&Vec2::y, box.min.y) ||
           along(&Vec2::y, box.max.y);
  }
  bool is_outline(const Loop& loop) const {
    return stock_ && std::all_of(loop.begin(), loop.end(), [&](const Edge& e) { return carries(e); });
  }
  /// Whether `wall`, `away` mm from the cut-off side, leaves at least as much of the stock beyond itself.
  bool is_nearer_side(const Edge& wall, double away) const {
    const bool upright = std::abs(wall.to.x - wall.from.x) < std::abs(wall.to.y - wall.from.y);
    return 2 * away <= (upright ? stock_->plan.width() : stock_->plan.height());
  }
  bool is_below(double z) const { return stock_ && z < stock_->z_bottom; }

 private:
  const std::optional<Stock>& stock_;
};

bool is_rectangle(const Loop& loop) {
  if (loop.size() != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Edge& a = loop[i];
    const Edge& b = loop[(i + 1) % 4];
    if (a.is_arc() ||
        std::abs(dot(a.to - a.from, b.to - b.from)) > kSamePlaceMm * (1 + a.length() * b.length()))
      return false;
  }
  return true;
}

/// Two parallel lines joined by two half circles.
bool is_rounded_band(const Loop& loop) {
  if (loop.size() != 4) return false;
  const std::size_t first = loop[0].is_arc() ? 0 : 1;
  const auto half_circle = [&](const Edge& e) { return e.is_arc() && near(e.sweep(), kPi); };
  return half_circle(loop[first]) && half_circle(loop[first + 2]) && !loop[first + 1].is_arc() &&
         !loop[(first + 3) % 4].is_arc();
}

/// A slot's course of travel.
struct Band {
  Vec2 from;
  Vec2 to;
  double width = 0;
  std::string from_end;
  std::string to_end;
};

std::optional<Band> band_of(P21Writer& out, const Region& region, const StockEdge& stock) {
  const Loop& loop = region.outer();
  if (!region.islands().empty()) return std::nullopt;
  if (is_rounded_band(loop)) {
    const std::size_t first = loop[0].is_arc() ? 0 : 1;
    const std::string end = out.add("RADIUSED_SLOT_END_TYPE", {});
    return Band{loop[first].center, loop[first + 2].center, 2 * loop[first].radius(), end, end};
  }
  if (!is_rectangle(loop)) return std::nullopt;
  // The ends are the open pair of sides, else the shorter pair.
  const auto open = [&](std::size_t i) { return stock.carries(loop[i]); };
  const int even = open(0) + open(2), odd = open(1) + open(3);
  const std::size_t end = even != odd ? (even > odd ? 0 : 1) : (loop[0].length() < loop[1].length() ? 0 : 1);
  const auto end_type = [&](std::size_t i) {
    return open(i) ? out.add("OPEN_SLOT_END_TYPE", {})
                   : out.add("FLAT_SLOT_END_TYPE", {length_measure(out, 0), length_measure(out, 0)});
  };
  const std::string from_end = end_type(end), to_end = end_type(end + 2);
  return Band{loop[end].at(0.5), loop[end + 2].at(0.5), loop[end].length(), from_end, to_end};
}

std::string linear_path(P21Writer& out, const P21Common& common, Vec2 from, Vec2 to) {
  return out.add("LINEAR_PATH", {p21_placement(out, common, from, 0), length_measure(out, distance(from, to)),
                                 direction(out, unit(to - from))});
}

/// Writes one piece; the arguments common to all features first.
class FeatureWriter {
 public:
  FeatureWriter(P21Writer& out, const P21Common& common, const FeaturePiece& piece,
                const std::optional<Stock>& stock, const std::vector<std::string>& operations)
      : out_(out),
        common_(common),
        feature_(*piece.feature),
        region_(*piece.region),
        name_(piece.name),
        operations_(operations),
        stock_(stock),
        tool_(piece.tool),
        is_element_(piece.is_element) {}

  std::string write() {
    if (feature_.chamfer) return chamfer();
    if (tool_ != nullptr && is_grooved(feature_, *tool_)) return groove();
    switch (feature_.kind) {
      case FeatureKind::kClosedPocket:
      case FeatureKind::kVCarving:
      case FeatureKind::kChamfer:
      case FeatureKind::kExternalThread:
        return closed_pocket();
      case FeatureKind::kPlanarFace:
        return planar_face();
      case FeatureKind::kSlot:
        return slot();
      case FeatureKind::kStep:
        return step();
      case FeatureKind::kRoundHole:
        return round_hole();
      case FeatureKind::kOutsideProfile:
      case FeatureKind::kInsideProfile:
      case FeatureKind::kEngraving:
      case FeatureKind::kTSlot:
        return outside_profile();
      case FeatureKind::kOpenPocket:
      case FeatureKind::kIsolation:
        break;
    }
    return open_pocket();
  }

 private:
  /// The five arguments of every feature, then `rest`.
  std::string entity(const std::string& keyword, const std::vector<std::string>& rest, Vec2 origin = {}) {
    std::vector<std::string> arguments = {p21_string(name_), common_.workpiece, p21_list(operations_),
                                          placement(origin), depth()};
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    return out_.add(keyword, arguments);
  }

  std::string placement(Vec2 origin) {
    return is_element_ ? p21_placement(out_, common_, origin, feature_.top_z)
                       : p21_place_in_workpiece(out_, common_, origin, feature_.top_z);
  }

  std::string depth() { return p21_plane(out_, common_, "depth", feature_.floor_z - feature_.top_z); }

  std::string slope() {
    return feature_.wall_slope.radians() == 0 ? kUnset : p21_real(feature_.wall_slope.radians());
  }

  std::string bottom() {
    const bool through = feature_.through || stock_.is_below(feature_.floor_z);
    return out_.add(through ? "THROUGH_POCKET_BOTTOM_CONDITION" : "PLANAR_POCKET_BOTTOM_CONDITION", {});
  }

  std::string fillet() {
    return feature_.floor_fillet > 0 ? length_measure(out_, feature_.floor_fillet) : kUnset;
  }

  std::string bosses() {
    std::vector<std::string> result;
    for (const Loop& island : region_.islands()) {
      const std::string placement = p21_placement(out_, common_, {}, 0);
      const std::string name = p21_string(name_ + " BOSS" + std::to_string(result.size() + 1));
      result.push_back(out_.add("BOSS", {name, common_.workpiece, "()", placement, depth(),
                                         closed_profile(out_, common_, island), slope()}));
    }
    return p21_list(result);
  }

  std::string closed_pocket() {
    const std::string islands = bosses(), boundary = closed_profile(out_, common_, region_.outer());
    return entity("CLOSED_POCKET", {islands, slope(), bottom(), fillet(), kUnset, boundary});
  }

  std::string planar_face() {
    const bool whole = stock_.is_outline(region_.outer());
    const std::string boundary = whole ? kUnset : closed_profile(out_, common_, region_.outer());
    return entity("PLANAR_FACE", {kUnset, kUnset, boundary, bosses()});
  }

  std::string slot() {
    const auto band = band_of(out_, region_, stock_);
    if (!band) return open_pocket();
    const std::string draft = slope();
    const std::string radius = feature_.floor_fillet > 0 ? fillet()
                               : draft == kUnset         ? kUnset
                                                         : length_measure(out_, 0);
    const std::string profile = out_.add(
        "SQUARE_U_PROFILE", {kUnset, length_measure(out_, band->width), radius, draft, radius, draft});
    const std::string course = linear_path(out_, common_, band->from, band->to);
    return entity("SLOT", {course, profile, p21_list({band->from_end, band->to_end})});
  }

  /// The edge between a face and walls that are not machined by themselves: its line is theirs.
  std::string chamfer() {
    const Chamfer& edge = *feature_.chamfer;
    const std::string level = p21_plane(out_, common_, "face", 0);
    const std::string at = p21_place_in_workpiece(out_, common_, {}, feature_.top_z);
    const std::string face = out_.add("PLANAR_FACE", {p21_string(name_ + " FACE"), common_.workpiece, "()",
                                                      at, level, kUnset, kUnset, kUnset, "()"});
    const std::string line = closed_profile(out_, common_, edge.line), down = depth();
    const std::string flat = out_.add("PLANAR_POCKET_BOTTOM_CONDITION", {});
    const std::string walls =
        edge.air_inside
            ? out_.add("CLOSED_POCKET", {p21_string(name_ + " WALLS"), common_.workpiece, "()", at, down,
                                         "()", kUnset, flat, kUnset, kUnset, line})
            : out_.add("GENERAL_OUTSIDE_PROFILE",
                       {p21_string(name_ + " WALLS"), common_.workpiece, "()", at, down, kUnset, line});
    const double lean = feature_.wall_slope.radians();
    return out_.add("CHAMFER", {p21_string(name_), common_.workpiece, p21_list(operations_), walls, face,
                                p21_real(lean), length_measure(out_, edge.depth)});
  }

  /// A vee, or the half round of a ball.
  std::string groove() {
    const ProfileCut& cut = *feature_.profile;
    const std::string course = out_.add("GENERAL_PATH", {kUnset, curve(out_, common_, cut.line)});
    const std::string section =
        is_conical(*tool_) ? out_.add("VEE_PROFILE", {kUnset, kUnset, p21_real(tool_->tip_angle->radians()),
                                                      p21_real((kPi - tool_->tip_angle->radians()) / 2)})
                           : out_.add("ROUNDED_U_PROFILE", {kUnset, length_measure(out_, tool_->diameter)});
    const std::string end = out_.add(cut.closed ? "LOOP_SLOT_END_TYPE" : "RADIUSED_SLOT_END_TYPE", {});
    return entity("SLOT", {course, section, cut.closed ? p21_list({end}) : p21_list({end, end})});
  }

  /// The section of a step: its angle is that between floor and wall.
  std::string leaning_wall() {
    const double lean = feature_.wall_slope.radians();
    if (lean == 0) return kUnset;
    const std::string angle = p21_real(kPi / 2 + lean);
    return out_.add("VEE_PROFILE", {kUnset, kUnset, angle, angle});
  }

  /// The wall is the side opposite to an open one, with the material on its left. A step takes the smaller
  /// part of the stock: readers in doubt about the drawn side rely on this.
  std::string step() {
    const Loop& loop = region_.outer();
    if (is_rectangle(loop) && region_.islands().empty()) {
      for (std::size_t i = 0; i < 4; ++i) {
        if (stock_.carries(loop[i]) || !stock_.carries(loop[(i + 2) % 4])) continue;
        if (!stock_.is_nearer_side(loop[i], loop[(i + 1) % 4].length())) continue;
        const std::string path = linear_path(out_, common_, loop[i].to, loop[i].from);
        return entity("STEP", {path, leaning_wall(), "()"});
      }
    }
    return open_pocket();
  }

  std::string thread() {
    const Thread& thread = *feature_.hole->thread;
    const auto word = [&](const char* name, const char* text) {
      return out_.add("DESCRIPTIVE_PARAMETER", {p21_string(name), p21_string(text)});
    };
    const std::string pitch =
        out_.add("NUMERIC_PARAMETER", {p21_string("PITCH"), p21_real(thread.pitch), p21_string("MM")});
    return placed_hole(
        "CATALOGUE_THREAD", feature_.hole->full_z - feature_.top_z,
        {kUnset, "()", ".T.", kUnset, kUnset, word("FORM", "METRIC"), length_measure(out_, thread.diameter),
         pitch, word("HAND", thread.left_hand ? "LEFT" : "RIGHT"), kUnset});
  }

  /// At the middle of the hole, and as deep as said.
  std::string placed_hole(const std::string& keyword, double down, const std::vector<std::string>& rest) {
    std::vector<std::string> arguments = {p21_string(name_), common_.workpiece, p21_list(operations_),
                                          placement(feature_.hole->center),
                                          p21_plane(out_, common_, "depth", down)};
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    return out_.add(keyword, arguments);
  }

  /// A hole that narrows by the angle of its cone, down to where the cone ends.
  std::string countersink() {
    constexpr double kLeastFloor = 0.01;  // mm; wider than nothing, as holes are
    const HoleForm& form = *feature_.hole;
    const double lean = flank_slope(*tool_);
    const double down = (form.diameter - tool_->tip_diameter) / (2 * lean);
    const std::string taper = out_.add(
        "DIAMETER_TAPER",
        {length_measure(out_, std::max(tool_->tip_diameter, std::min(kLeastFloor, form.diameter / 2)))});
    return placed_hole("ROUND_HOLE", -down,
                       {length_measure(out_, form.diameter), taper, out_.add("FLAT_HOLE_BOTTOM", {})});
  }

  std::string round_hole() {
    if (is_tapped(feature_)) return thread();
    if (is_countersunk(feature_)) return countersink();
    const auto center = circle_center(region_.outer());
    if (!center) return closed_pocket();
    const std::string condition =
        out_.add(feature_.through ? "THROUGH_BOTTOM_CONDITION" : "FLAT_HOLE_BOTTOM", {});
    const double diameter = 2 * region_.outer()[0].radius();
    return entity("ROUND_HOLE", {length_measure(out_, diameter), kUnset, condition}, *center);
  }

  std::string outside_profile() {
    if (!stock_.is_outline(region_.outer()) || region_.islands().size() != 1) return open_pocket();
    const std::string down = direction(out_, {}, -1);
    const std::string sweep =
        out_.add("LINEAR_PATH", {kUnset, length_measure(out_, feature_.top_z - feature_.floor_z), down});
    return entity("GENERAL_OUTSIDE_PROFILE", {sweep, closed_profile(out_, common_, region_.islands()[0])});
  }

  /// Walls and everything else of the outline but one stretch of the stock's edge, material on the left.
  std::string open_pocket() {
    const Loop& loop = region_.outer();
    const auto open_edge =
        std::find_if(loop.begin(), loop.end(), [&](const Edge& e) { return stock_.carries(e); });
    if (open_edge == loop.end()) return closed_pocket();
    Loop turned = loop;
    std::rotate(turned.begin(), turned.begin() + (open_edge - loop.begin()) + 1, turned.end());
    turned.pop_back();
    const std::string islands = bosses();
    const std::string walls = out_.add("GENERAL_PROFILE", {kUnset, curve(out_, common_, reversed(turned))});
    return entity("OPEN_POCKET", {islands, slope(), bottom(), fillet(), kUnset, walls, kUnset});
  }

  P21Writer& out_;
  const P21Common& common_;
  const Feature& feature_;
  const Region& region_;
  const std::string& name_;
  const std::vector<std::string>& operations_;
  StockEdge stock_;
  const Tool* tool_;
  bool is_element_;
};

}  // namespace

bool is_grooved(const Feature& feature, const Tool& tool) {
  return feature.kind == FeatureKind::kEngraving && is_carved(feature, tool) && tool.tip_diameter == 0;
}

bool is_tapped(const Feature& feature) {
  return feature.hole && feature.hole->kind == HoleKind::kTapped && feature.hole->thread;
}

bool is_countersunk(const Feature& feature) {
  return feature.hole && feature.hole->kind == HoleKind::kCountersunk;
}

Vec2 placement_of(const FeaturePiece& piece) {
  if (is_tapped(*piece.feature) || is_countersunk(*piece.feature)) return piece.feature->hole->center;
  if (piece.feature->kind != FeatureKind::kRoundHole) return {};
  return circle_center(piece.region->outer()).value_or(Vec2{});
}

std::string p21_placement(P21Writer& out, const P21Common& common, Vec2 at, double z) {
  return out.add("AXIS2_PLACEMENT_3D", {"''", point(out, at, z), common.z_axis, common.x_axis});
}

SetupPlace::Row turned_back(const P21Common& common, const SetupPlace::Row& v) {
  SetupPlace::Row back{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) back[i] += common.place.turn[k][i] * v[k];
  return back;
}

namespace {

std::string triple(P21Writer& out, const char* keyword, const SetupPlace::Row& v) {
  return out.add(keyword, {"''", p21_list({p21_real(v[0]), p21_real(v[1]), p21_real(v[2])})});
}

}  // namespace

bool is_turned(const P21Common& common) {
  return common.place.turn != SetupPlace{}.turn;
}

std::string p21_place_in_workpiece(P21Writer& out, const P21Common& common, Vec2 at, double z) {
  if (!is_turned(common)) return p21_placement(out, common, at, z);
  const std::string origin = triple(out, "CARTESIAN_POINT", turned_back(common, {at.x, at.y, z}));
  const std::string up = triple(out, "DIRECTION", turned_back(common, {0, 0, 1}));
  return out.add("AXIS2_PLACEMENT_3D",
                 {"''", origin, up, triple(out, "DIRECTION", turned_back(common, {1, 0, 0}))});
}

std::string p21_plane(P21Writer& out, const P21Common& common, const std::string& name, double z) {
  return out.add("PLANE", {p21_string(name), p21_placement(out, common, {}, z)});
}

std::string write_feature(P21Writer& out, const P21Common& common, const FeaturePiece& piece,
                          const std::optional<Stock>& stock, const std::vector<std::string>& operations) {
  return FeatureWriter(out, common, piece, stock, operations).write();
}

}  // namespace clearcut::post
