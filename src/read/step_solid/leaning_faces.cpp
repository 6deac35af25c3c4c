#include "read/step_solid/leaning_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "features/derived_outlines.h"
#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "geometry/voronoi/clearance.h"
#include "read/drawing/drawing.h"
#include "read/repair/repair.h"
#include "read/step_solid/floor_sweep.h"

namespace clearcut::read {
namespace {

/// Radians. A cone with a greater difference of angle does not make the face: 2 um over a chamfer of 1 mm.
constexpr double kSameLean = 0.002;
/// mm. A cutter's end with a greater difference of radius does not make the fillet.
constexpr double kSameRound = 0.002;
/// mm. Faces with the heights of their ends nearer than this belong to one broken edge.
constexpr double kSameEnd = 1e-3;
/// mm beside a foot at which cut areas are searched.
constexpr double kBesideFoot = 0.02;
/// mm; least height of a wall below a broken edge.
constexpr double kWallUnder = 0.01;
/// mm along a foot between the tested places.
constexpr double kFootStep = 2;
/// mm. Half the width of seams left by booleans between touching areas.
constexpr double kSeamOfFaces = 0.003;
/// mm2. Fillets of less are rounding.
constexpr double kLeastFillet = 0.01;
constexpr double kLevelStep = 1e-5;
/// Degrees. Range of cone angles of broken edges; faces of other angles are drafted walls or inclined floors.
constexpr int kSharpest = 50, kBluntest = 150;

/// Faces of equal inclination between the same heights.
struct LeaningFaces {
  double lean = 0;           // radians
  double foot = 0, top = 0;  // z, mm
  std::vector<const SolidFace*> faces;
};

std::vector<LeaningFaces> leaning_alike(const SolidModel& solid) {
  std::vector<LeaningFaces> groups;
  for (const SolidFace& face : solid.faces) {
    if (face.lean <= 0 || face.foot.empty()) continue;
    const auto is_alike = [&](const LeaningFaces& group) {
      return std::abs(group.lean - face.lean) < kSameLean && std::abs(group.foot - face.z_low) < kSameEnd &&
             std::abs(group.top - face.z_high) < kSameEnd;
    };
    auto group = std::find_if(groups.begin(), groups.end(), is_alike);
    if (group == groups.end()) group = groups.insert(groups.end(), {face.lean, face.z_low, face.z_high, {}});
    group->faces.push_back(&face);
  }
  return groups;
}

/// The first stored point near `p`, so that common ends are equal.
Vec2 met(Vec2 p, std::vector<Vec2>& points) {
  for (const Vec2 q : points)
    if (distance(p, q) < kSamePlace) return q;
  points.push_back(p);
  return p;
}

/// A closed foot and the faces over it.
struct Foot {
  Loop line;  ///< counter-clockwise
  std::set<int> faces;
};

/// The closed feet of a group; open ones are left out.
std::vector<Foot> feet_of(const LeaningFaces& group, const Tolerances& tol) {
  std::vector<Path> paths;
  std::vector<std::pair<Vec2, int>> owners;
  std::vector<Vec2> points;
  for (const SolidFace* face : group.faces) {
    for (Path path : face->foot) {
      for (Edge& edge : path) {
        edge.from = met(edge.from, points);
        edge.to = met(edge.to, points);
      }
      owners.emplace_back(path.front().from, face->number);
      paths.push_back(std::move(path));
    }
  }
  std::vector<Foot> feet;
  for (RawCurve& curve : chained(paths, "the foot of a broken edge")) {
    if (!curve.closed) continue;
    Foot foot;
    for (const Edge& edge : curve.edges)
      for (const auto& [from, number] : owners)
        if (from == edge.from) foot.faces.insert(number);
    RepairOptions how;
    how.tol = tol;
    how.where = "the foot of a broken edge";
    how.may_be_empty = true;
    Diagnostics unused;
    const Regions within = repair({std::move(curve)}, how, unused);
    if (within.size() != 1 || !within.front().islands().empty()) continue;
    foot.line = within.front().outer();
    feet.push_back(std::move(foot));
  }
  return feet;
}

/// The side of a foot that is cut deeper; nothing if it is not the same along the whole foot.
std::optional<bool> is_open_inside(const Foot& foot, double foot_z, const SolidWork& work) {
  const auto is_open = [&](Vec2 p) {
    if (!work.stock.plan.contains(p)) return true;
    return std::any_of(work.found.begin(), work.found.end(), [&](const Feature& other) {
      return other.floor_z < foot_z - kWallUnder && other.top_z > foot_z && contains(other.target, p);
    });
  };
  int inside = 0, outside = 0;
  for (const Edge& edge : foot.line) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(edge.length() / kFootStep)));
    for (int i = 0; i < pieces; ++i) {
      const double t = (i + 0.5) / pieces;
      const Vec2 aside = left_of(edge.tangent_at(t)) * kBesideFoot;
      const bool left = is_open(edge.at(t) + aside), right = is_open(edge.at(t) - aside);
      if (left == right) return std::nullopt;
      ++(left ? inside : outside);
    }
  }
  if (inside > 0 && outside > 0) return std::nullopt;
  return inside > 0;
}

/// The area of the top removed by a broken edge.
Regions top_of(const Foot& foot, double width, bool open_inside, const Tolerances& tol) {
  const Regions within{Region::from_valid_loops(foot.line, {})};
  if (open_inside) return subtract(dilate(within, width, tol), within, tol);
  const Regions rest = inset(within.front(), width, tol);
  return rest.empty() ? within : subtract(within, rest, tol);
}

/// Whether the whole removed area is still material before: another, deeper feature there would leave only part of an
/// edge.
bool stands_whole(const Regions& top, double top_z, const SolidWork& work, const Tolerances& tol) {
  return std::none_of(work.found.begin(), work.found.end(), [&](const Feature& other) {
    if (other.floor_z >= top_z - kWallUnder || !box(other.target).overlaps(box(top))) return false;
    return !inset(intersect(top, other.target, tol), kSeamOfFaces, tol).empty();
  });
}

bool leans_so(const Tool& tool, double lean) {
  return is_conical(tool) && std::abs(tool.tip_angle->radians() / 2 - lean) < kSameLean;
}

/// Radius of a line forming a circle; nothing for other lines.
std::optional<double> circle_of(const Loop& line) {
  const Vec2 center = line.front().center;
  for (const Edge& edge : line)
    if (!edge.is_arc() || distance(edge.center, center) > kSamePlace) return std::nullopt;
  return line.front().radius();
}

Feature chamfer_along(const LeaningFaces& group, const Foot& foot, bool open_inside, const Tolerances& tol) {
  Feature feature;
  feature.kind = FeatureKind::kChamfer;
  feature.name = name_of(feature.kind);
  feature.top_z = group.top;
  feature.floor_z = group.foot;
  feature.wall_slope = Radians::of(group.lean);
  const double depth = group.top - group.foot;
  feature.target = feature.allowed =
      features::kerf_of({ProfileSide::kOn, foot.line, true, 0, {}}, depth, tol);
  feature.chamfer = Chamfer{foot.line, depth, open_inside, {}, 0, 0};
  return feature;
}

Feature countersink_over(const LeaningFaces& group, Vec2 center, double radius) {
  Feature feature;
  feature.kind = FeatureKind::kRoundHole;
  feature.name = "countersink";
  feature.top_z = group.top;
  feature.floor_z = group.foot;
  feature.wall_slope = Radians::of(group.lean);
  feature.hole_diameter = 2 * radius;
  feature.target = feature.allowed = {disc_about(center, radius)};
  HoleForm hole;
  hole.kind = HoleKind::kCountersunk;
  hole.center = center;
  hole.diameter = 2 * radius;
  hole.full_z = group.top;
  feature.hole = hole;
  return feature;
}

/// Whether a feature is the hole whose edge a circle is.
bool is_hole_at(const Feature& feature, Vec2 center, double radius, const Tolerances& tol) {
  const auto round = features::round_hole_of(feature, tol);
  return round && distance(round->center, center) < kSameEnd && std::abs(round->radius - radius) < kSameEnd;
}

bool has_point_in(const Cell& cell, const Feature& feature) {
  return std::any_of(cell.inside.begin(), cell.inside.end(),
                     [&](Vec2 p) { return contains(feature.target, p); });
}

/// Whether a tool that makes a countersink `wide` mm in radius at its top keeps its tip within the hole of `radius` mm: a
/// hole's conical end has room for a part of the tip.
bool clears_end(const Tool& tool, double wide, double top, const Feature& hole, double radius,
                const SolidWork& work) {
  if (hole.through) return true;
  const double tip = tool.tip_diameter / 2;
  const double tip_z = top - (wide - tip) / base::tan(tool.tip_angle->radians() / 2);
  double end = hole.floor_z;
  for (const Cell& cell : work.cells)
    if (cell.floor && std::abs(cell.z - hole.floor_z) < kSameEnd && has_point_in(cell, hole))
      end = std::min(end, work.solid.faces[static_cast<std::size_t>(cell.face)].z_low);
  if (tip_z >= hole.floor_z - kSameEnd) return true;
  if (tip_z < end) return false;
  return tip <= radius * (tip_z - end) / (hole.floor_z - end);
}

std::string faces_text(const std::set<int>& numbers) {
  std::string text = numbers.size() == 1 ? "face " : "faces ";
  for (auto first = numbers.begin(); first != numbers.end();) {
    auto last = first;
    for (auto next = std::next(last); next != numbers.end() && *next == *last + 1; ++next) last = next;
    text += (first == numbers.begin() ? "" : ", ") + std::to_string(*first);
    if (last != first) text += (*last == *first + 1 ? ", " : "-") + std::to_string(*last);
    first = std::next(last);
  }
  return text;
}

/// The broken edge over one foot, made with an available tool; nothing if there is none.
std::optional<Feature> edge_over(const LeaningFaces& group, const Foot& foot, bool open_inside,
                                 const SolidWork& work, const Tolerances& tol) {
  const double depth = group.top - group.foot;
  const double width = depth * base::tan(group.lean);
  const auto any_tool = [&](const auto& does) {
    return std::any_of(work.tools.begin(), work.tools.end(),
                       [&](const Tool& tool) { return leans_so(tool, group.lean) && does(tool); });
  };
  const auto radius = circle_of(foot.line);
  if (radius && open_inside) {
    const Vec2 center = foot.line.front().center;
    const auto hole = std::find_if(work.found.begin(), work.found.end(), [&](const Feature& feature) {
      return is_hole_at(feature, center, *radius, tol);
    });
    const bool is_hole = hole != work.found.end();
    const auto sinks = [&](const Tool& tool) {
      return tool.diameter > 2 * (*radius + width) - kSameEnd && tool.tip_diameter < 2 * *radius - kSameEnd &&
             clears_end(tool, *radius + width, group.top, *hole, *radius, work);
    };
    // Without its hole a cone has nothing to be about.
    const bool is_made = std::any_of(work.tools.begin(), work.tools.end(), [&](const Tool& tool) {
      return features::is_near_size(tool.diameter, 2 * *radius) ||
             (mills_upright(tool) && tool.diameter < 2 * *radius);
    });
    if (is_hole && !is_made) return std::nullopt;
    if (is_hole && any_tool(sinks)) return countersink_over(group, center, *radius + width);
  }
  const auto goes_along = [&](const Tool& tool) {
    return tool.kind != ToolKind::kSpotDrill && depth <= flank_height(tool) + kSameEnd;
  };
  if (!any_tool(goes_along)) return std::nullopt;
  return chamfer_along(group, foot, open_inside, tol);
}

/// mm; radius left by a cutter's end between a floor and a wall, 0 for a sharp corner.
double end_radius(const Tool& tool) {
  if (tool.kind == ToolKind::kBallEndMill) return tool.radius();
  return mills_upright(tool) ? tool.corner_radius : 0;
}

/// Cells of fillets of one radius over one floor.
struct FilletCells {
  double radius = 0, floor = 0;  // mm
  std::vector<const Cell*> cells;
};

std::vector<FilletCells> fillets_alike(const SolidWork& work) {
  std::vector<FilletCells> groups;
  for (const Cell& cell : work.cells) {
    const SolidFace& face = work.solid.faces[static_cast<std::size_t>(cell.face)];
    if (face.fillet <= 0 || cell.area.empty()) continue;
    const double floor = face.z_high - face.fillet;
    const auto is_alike = [&](const FilletCells& group) {
      return std::abs(group.radius - face.fillet) < kSameRound && std::abs(group.floor - floor) < kLevelStep;
    };
    auto group = std::find_if(groups.begin(), groups.end(), is_alike);
    if (group == groups.end()) group = groups.insert(groups.end(), {face.fillet, floor, {}});
    group->cells.push_back(&cell);
  }
  return groups;
}

/// Other material between the floor of fillets and their top.
Regions standing_beside(const FilletCells& group, const SolidWork& work, const Tolerances& tol) {
  Regions standing;
  for (const Cell& cell : work.cells) {
    const bool is_own = std::find(group.cells.begin(), group.cells.end(), &cell) != group.cells.end();
    if (is_own || cell.area.empty() || cell.z <= group.floor + kLevelStep ||
        cell.z > group.floor + group.radius + kLevelStep)
      continue;
    standing = standing.empty() ? cell.area : unite(standing, cell.area, tol);
  }
  return standing;
}

/// The feature cut by a rounded end in one area already cut down to the top of the fillets.
std::optional<Feature> fillet_in(const Feature& above, const FilletCells& group, const Regions& standing,
                                 std::set<int>& faces, const SolidWork& work, const Tolerances& tol) {
  Regions target;
  for (const Cell* cell : group.cells) {
    if (!has_point_in(*cell, above)) continue;
    target = target.empty() ? cell->area : unite(target, cell->area, tol);
    faces.insert(work.solid.faces[static_cast<std::size_t>(cell->face)].number);
  }
  if (area(target) < kLeastFillet) return std::nullopt;
  Feature feature;
  feature.allowed = standing.empty() ? above.allowed : subtract(above.allowed, standing, tol);
  feature.target = intersect(target, feature.allowed, tol);
  if (area(feature.target) < kLeastFillet) return std::nullopt;
  feature.kind = above.kind == FeatureKind::kRoundHole || above.kind == FeatureKind::kClosedPocket
                     ? FeatureKind::kClosedPocket
                     : FeatureKind::kOpenPocket;
  feature.name = "fillet";
  feature.top_z = group.floor + group.radius;
  feature.floor_z = group.floor;
  feature.floor_fillet = group.radius;
  feature.source = faces_text(faces);
  return feature;
}

}  // namespace

ShapedFaces broken_edges_of(const SolidWork& work, const Tolerances& tol) {
  ShapedFaces out;
  std::map<int, std::set<int>> wanted;  // faces by the whole degrees of the cone needed
  for (const LeaningFaces& group : leaning_alike(work.solid)) {
    for (const Foot& foot : feet_of(group, tol)) {
      const auto open_inside = is_open_inside(foot, group.foot, work);
      if (!open_inside) continue;
      const double width = (group.top - group.foot) * base::tan(group.lean);
      if (!stands_whole(top_of(foot, width, *open_inside, tol), group.top, work, tol)) continue;
      auto feature = edge_over(group, foot, *open_inside, work, tol);
      if (!feature) {
        wanted[static_cast<int>(std::lround(2 * group.lean * 180 / kPi))].insert(foot.faces.begin(),
                                                                                 foot.faces.end());
        continue;
      }
      feature->source = faces_text(foot.faces);
      out.faces.insert(foot.faces.begin(), foot.faces.end());
      out.features.push_back(std::move(*feature));
    }
  }
  for (const auto& [degrees, faces] : wanted) {
    if (degrees < kSharpest || degrees > kBluntest) continue;
    out.proposals.push_back("a cone of " + std::to_string(degrees) +
                            " degrees, long and wide enough, breaks the edges of " + faces_text(faces) +
                            " (--tool chamfer:" + std::to_string(degrees) + "deg:6)");
  }
  return out;
}

ShapedFaces fillets_of(const SolidWork& work, const Tolerances& tol) {
  ShapedFaces out;
  for (const FilletCells& group : fillets_alike(work)) {
    const bool has_end = std::any_of(work.tools.begin(), work.tools.end(), [&](const Tool& tool) {
      return std::abs(end_radius(tool) - group.radius) < kSameRound;
    });
    if (!has_end) {
      std::set<int> faces;
      for (const Cell* cell : group.cells)
        faces.insert(work.solid.faces[static_cast<std::size_t>(cell->face)].number);
      const std::string radius = trimmed(group.radius, 3);
      const bool is_ball = std::all_of(group.cells.begin(), group.cells.end(), [&](const Cell* cell) {
        return work.solid.faces[static_cast<std::size_t>(cell->face)].surface == "sphere";
      });
      const std::string tool = is_ball ? "ball:" + trimmed(2 * group.radius, 3)
                                       : "bullnose:" + trimmed(4 * group.radius, 3) + ":corner=" + radius;
      out.proposals.push_back("a ball or bull-nose end mill with a radius of " + radius + " mm makes " +
                              faces_text(faces) + " (--tool " + tool + ")");
      continue;
    }
    const Regions standing = standing_beside(group, work, tol);
    for (const Feature& above : work.found) {
      if (std::abs(above.floor_z - group.floor - group.radius) > kLevelStep) continue;
      std::set<int> faces;
      auto feature = fillet_in(above, group, standing, faces, work, tol);
      if (!feature) continue;
      out.faces.insert(faces.begin(), faces.end());
      out.features.push_back(std::move(*feature));
    }
  }
  return out;
}

}  // namespace clearcut::read
