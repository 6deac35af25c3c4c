#include "read/step_solid/step_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "read/common/curve_fit.h"
#include "read/drawing/drawing.h"
#include "read/step_solid/asked_features.h"
#include "read/step_solid/floor_sweep.h"
#include "read/step_solid/height_map.h"
#include "read/step_solid/leaning_faces.h"
#include "read/step_solid/orientation.h"
#include "read/step_solid/solid_model.h"

namespace clearcut::read {
namespace {

/// Heights times edges.
constexpr double kMostWork = 2e7;
/// mm2. Smaller areas are rounding.
constexpr double kSpeck = 0.01;
/// mm. Longer or shorter solids are asked about.
constexpr double kTooLong = 2000, kTooShort = 1;
/// mm. Permitted projection of a solid out of its stock.
constexpr double kSlack = 1e-3;
/// Length of a drill's point of 118 degrees over its diameter.
constexpr double kDrillPoint = 0.3004;
/// Of a hole's diameter: heights of cones that differ by less are of one angle, such as 118 and 120 degrees.
constexpr double kSamePoint = 0.02;
/// Faces described one by one; the condition has the numbers of all.
constexpr int kMostDescribed = 10;
/// mm. Non-flat faces with lower ends nearer in height than this are cut together, down to the highest of these ends.
constexpr double kOneLevel = 0.1;
constexpr const char* kSetUps[] = {"-Z", "+X", "-X", "+Y", "-Y"};
/// Condition for a part not held at the end.
constexpr const char* kLoosePart = "loose-part";

bool any_inside(const std::vector<Vec2>& points, const Region& region) {
  return std::any_of(points.begin(), points.end(), [&](Vec2 p) { return region.contains(p); });
}

std::string span(double low, double high) {
  return trimmed(low, 3) + ".." + trimmed(high, 3);
}

/// Numbers of faces: "3, 7, 9-14".
std::string listed(const std::set<int>& numbers) {
  std::string text;
  for (auto first = numbers.begin(); first != numbers.end();) {
    auto last = first;
    for (auto next = std::next(last); next != numbers.end() && *next == *last + 1; ++next) last = next;
    text += (text.empty() ? "" : ", ") + std::to_string(*first);
    if (last != first) text += (*last == *first + 1 ? ", " : "-") + std::to_string(*last);
    first = std::next(last);
  }
  return text;
}

/// "face 3 is", "faces 3, 7, 9-14 are".
std::string subject(const std::set<int>& numbers) {
  return (numbers.size() == 1 ? "face " : "faces ") + listed(numbers) +
         (numbers.size() == 1 ? " is" : " are");
}

/// The full circle within kCurveTolerance of an outline, if its curves are not just a polygon's sides; nothing for
/// other outlines.
std::optional<Region> circle_like(const Region& region) {
  if (!region.islands().empty()) return std::nullopt;
  const Vec2 center = region.box().center();
  double least = kOpenReach, most = 0;
  for (const Edge& edge : region.outer()) {
    for (const double t : {0.0, 0.25, 0.5, 0.75}) {
      const double apart = distance(center, edge.at(t));
      least = std::min(least, apart);
      most = std::max(most, apart);
    }
  }
  if (most - least > 2 * kCurveTolerance) return std::nullopt;
  const bool has_arcs = std::any_of(region.outer().begin(), region.outer().end(),
                                    [](const Edge& edge) { return edge.is_arc(); });
  if (!has_arcs) return std::nullopt;
  const Vec2 radius{std::sqrt(region.area() / kPi), 0};
  const auto half = [&](Vec2 from, Vec2 to) { return Edge::arc(from, to, center, Turn::kCounterClockwise); };
  return Region::from_valid_loops(
      {half(center + radius, center - radius), half(center - radius, center + radius)}, {});
}

std::string described(const SolidFace& face) {
  return "face " + std::to_string(face.number) + " (" + face.surface + ", x " +
         span(face.plan.min.x, face.plan.max.x) + ", y " + span(face.plan.min.y, face.plan.max.y) + ", z " +
         span(face.z_low, face.z_high) + ")";
}

/// The solid's box, or the stock stated in a job; the solid must be inside.
Stock stock_around(const SolidModel& solid, const std::optional<StockRequest>& request,
                   const std::string& file_name) {
  Stock stock{solid.plan, solid.z_bottom, solid.z_top};
  if (!request) return stock;
  stock.plan = solid.plan.grown(request->margin);
  const auto set = [](const auto& range, double& low, double& high) {
    if (range) low = (*range)[0], high = (*range)[1];
  };
  // A value written with fewer digits equals the solid's own side.
  const auto taken = [](double& side, double own) {
    if (std::abs(side - own) < kSlack) side = own;
  };
  set(request->x, stock.plan.min.x, stock.plan.max.x);
  set(request->y, stock.plan.min.y, stock.plan.max.y);
  stock.z_bottom = request->z[0];
  stock.z_top = request->z[1];
  taken(stock.plan.min.x, solid.plan.min.x);
  taken(stock.plan.min.y, solid.plan.min.y);
  taken(stock.plan.max.x, solid.plan.max.x);
  taken(stock.plan.max.y, solid.plan.max.y);
  taken(stock.z_bottom, solid.z_bottom);
  taken(stock.z_top, solid.z_top);
  const Box room = stock.plan.grown(kSlack);
  if (room.contains(solid.plan.min) && room.contains(solid.plan.max) &&
      solid.z_bottom > stock.z_bottom - kSlack && solid.z_top < stock.z_top + kSlack)
    return stock;
  throw InputError(file_name, "the stock does not hold the solid, which takes x " +
                                  span(solid.plan.min.x, solid.plan.max.x) + ", y " +
                                  span(solid.plan.min.y, solid.plan.max.y) + ", z " +
                                  span(solid.z_bottom, solid.z_top) + "; correct the stock");
}

/// A question, for the file's unit may be wrong.
void question_size(Part& part, const SolidModel& solid) {
  const double size = std::max({solid.plan.width(), solid.plan.height(), solid.z_top - solid.z_bottom});
  if (size > kTooLong || size < kTooShort)
    part.diagnostics.warn(part.source_file, "the solid is " + trimmed(size, 3) +
                                                " mm long: if that is not meant, export it in its true unit");
}

/// Whether an area has the whole of a box as a hole.
bool goes_round(const Feature& feature, const Box& box) {
  return std::any_of(feature.target.begin(), feature.target.end(), [&](const Region& region) {
    return std::any_of(region.islands().begin(), region.islands().end(), [&](const Loop& island) {
      const Box hole = clearcut::box(island);
      return hole.width() > box.width() - kSlack && hole.height() > box.height() - kSlack;
    });
  });
}

/// The drills at hand.
std::vector<Tool> drills_of(const SolidOptions& solid) {
  std::vector<Tool> drills;
  std::copy_if(solid.tools.begin(), solid.tools.end(), std::back_inserter(drills),
               [](const Tool& tool) { return tool.kind == ToolKind::kDrill; });
  for (const double diameter : solid.drills) {
    drills.emplace_back();
    drills.back().kind = ToolKind::kDrill;
    drills.back().diameter = diameter;
  }
  return drills;
}

/// One solid while its features are found.
class Finder {
 public:
  Finder(const SolidModel& solid, const std::string& file_name, const ReadOptions& options)
      : solid_(solid),
        file_name_(file_name),
        tol_(options.tol),
        stock_(stock_around(solid, options.solid.stock, file_name)),
        options_(options),
        breakthrough_(options.solid.breakthrough.value_or(kBreakthrough)),
        drills_(drills_of(options.solid)),
        has_other_setups_(options.solid.has_other_setups),
        map_(solid, file_name, options.tol) {}

  /// Finds floors and through openings; whether there are any.
  bool find();
  /// Adds features made by cutters' own shapes; whether there is anything to mill.
  bool shape_faces();
  /// The reason if no feature is found.
  std::string why_nothing() const;
  Part part(bool stated_stock);
  /// Applies the requested operations.
  void take_asked();

 private:
  std::vector<double> levels();
  double level_under(double z, const std::vector<double>& floors, std::vector<double>& others) const;
  void refuse_too_much(std::size_t levels) const;
  void report_stock(bool stated);
  void report_through();
  void add_level(double z, const Regions& free);
  std::vector<int> floors_in(const Region& region, double z) const;
  void add_area(const Region& target, const Region& allowed, bool open, double z);
  double point_below(const Feature& hole) const;
  bool is_pierced(const Feature& hole, double point) const;
  FeatureKind kind_of(const Region& target, bool open, bool through) const;
  void leave_out_thin();
  void doubt(const std::string& what);
  void report_hidden_floors();
  void report_left_out();
  void add_shadows(const std::set<int>& faces);
  std::string kinds_of(const std::set<int>& faces) const;
  void report_set_ups();
  void propose_side(const std::array<std::vector<int>, 5>& floors);
  void propose_taps();
  bool is_threaded(const Feature& hole) const;
  const Tool* drill_of(const Feature& hole) const;
  void end_holes();
  void end_hole(Feature& hole, const SolidFace& floor);
  void report_hole_ends();
  bool is_reached(const SolidFace& wall) const;
  bool is_faced(const SolidFace& wall) const;
  bool is_undermined(const SolidFace& ceiling) const;
  int set_up_of(const SolidFace& face) const;

  const SolidModel& solid_;
  const std::string& file_name_;
  Tolerances tol_;
  Stock stock_;
  const ReadOptions& options_;
  double breakthrough_;  ///< mm
  std::vector<Tool> drills_;
  bool has_other_setups_;
  HeightMap map_;
  std::vector<double> level_of_;  ///< mm; for each cell the height down to which the material above is cut
  Part part_;
  std::vector<Feature> found_;
  std::vector<std::string> flat_drilled_;  ///< holes with a flat floor that a drill ends with its cone
  std::vector<std::string> pierced_;       ///< holes whose drill goes through the solid below a flat floor
  std::vector<std::string> deepened_;      ///< holes whose drill goes below a flat floor with its point
  std::vector<std::string> flat_cones_;    ///< holes that end in a cone, cut flat without a drill
  std::vector<std::string>
      other_points_;         ///< holes that end in another cone than that of their drill's point
  double point_left_ = 0;    ///< mm; height of the highest cone left on flat floors
  double point_below_ = 0;   ///< mm; length of the longest point below a flat floor
  Diagnostics thin_;         ///< floors not worth a cut
  double deepest_thin_ = 0;  ///< mm; depth of the deepest of these floors
  std::set<int> reached_;    ///< indices of cells
  std::set<int> shaped_;     ///< numbers of faces made by cutters' own shapes
  std::vector<std::string> proposals_;
  Diagnostics asked_;
};

bool Finder::find() {
  const std::vector<double> heights = levels();
  refuse_too_much(heights.size());
  FloorSweep sweep(map_, tol_);
  for (const double z : heights) add_level(z, sweep.free_at(z));
  leave_out_thin();
  return !found_.empty();
}

std::string Finder::why_nothing() const {
  std::string tools;
  for (const std::string& one : proposals_) tools += "; " + one;
  if (deepest_thin_ <= 0) return "no floor looks up and nothing goes through" + tools;
  return "its floors lie at most " + trimmed(deepest_thin_, 5) +
         " mm below what is around them, too little for a cut, and nothing goes through (is its unit right?)";
}

Part Finder::part(bool stated_stock) {
  part_.name = std::filesystem::path(file_name_).stem().string();
  part_.source_file = file_name_;
  part_.stock = stock_;
  part_.diagnostics.append(map_.mends());
  report_stock(stated_stock);
  question_size(part_, solid_);
  if (solid_.bodies.size() > 1)
    part_.diagnostics.warn(file_name_,
                           std::to_string(solid_.bodies.size()) + " solids are taken as one part");
  part_.diagnostics.append(thin_);
  part_.diagnostics.append(asked_);
  add_features(part_, std::move(found_));
  report_hidden_floors();
  report_left_out();
  report_hole_ends();
  report_set_ups();
  report_through();
  propose_taps();
  return std::move(part_);
}

void Finder::report_stock(bool stated) {
  const std::string what = stated ? "the stock is " : "the solid's bounding box is taken as the stock: ";
  part_.diagnostics.note(file_name_, what + trimmed(stock_.plan.width(), 3) + " x " +
                                         trimmed(stock_.plan.height(), 3) + ", z " +
                                         span(stock_.z_bottom, stock_.z_top));
}

/// Reports through openings, and loose pieces.
void Finder::report_through() {
  const auto& features = part_.features;
  const auto count =
      std::count_if(features.begin(), features.end(), [](const Feature& f) { return f.through; });
  if (count == 0) return;
  double lowest = solid_.z_bottom;
  for (const Feature& feature : features)
    if (feature.through) lowest = std::min(lowest, feature.floor_z);
  const double plain = solid_.z_bottom - breakthrough_;
  const std::string below = trimmed(breakthrough_, 3) + " mm below the solid (--breakthrough)" +
                            (lowest < plain ? " and drills by their point more" : "") + ", down to z " +
                            trimmed(std::min(lowest, plain), 3);
  part_.diagnostics.warn(file_name_, std::to_string(count) + " cut(s) go through, " + below +
                                         ": keep table, vice and clamps away from there");
  const bool freed = std::any_of(features.begin(), features.end(), [&](const Feature& feature) {
    return feature.kind == FeatureKind::kOutsideProfile && feature.floor_z <= stock_.z_bottom &&
           goes_round(feature, solid_.plan);
  });
  if (freed)
    part_.diagnostics.doubt(file_name_, kLoosePart,
                            "the outside is cut through all round: the part comes loose; hold it by itself");
}

/// mm. The height down to which the material over a non-flat face with its highest place at z is cut: the height of a
/// floor or of another such face higher by less than kOneLevel, else its own; the latter is added to `others`.
double Finder::level_under(double z, const std::vector<double>& floors, std::vector<double>& others) const {
  for (const std::vector<double>* heights : {&floors, static_cast<const std::vector<double>*>(&others)}) {
    for (const double height : *heights)
      if (height >= z - kSameHeight && height <= z + kOneLevel) return std::max(height, z);
  }
  others.push_back(z);
  return z;
}

/// Heights below the stock's top of floors and of non-flat faces, top down; last the solid's bottom, for openings
/// without a floor.
std::vector<double> Finder::levels() {
  const auto& cells = map_.cells();
  const auto is_below_top = [&](const Cell& cell) { return cell.z < stock_.z_top - kSameHeight; };
  std::vector<double> floors, others;
  std::vector<std::size_t> highest_first;
  level_of_.clear();
  for (const Cell& cell : cells) {
    level_of_.push_back(cell.z);
    if (cell.floor && is_below_top(cell)) floors.push_back(cell.z);
    if (!cell.floor && is_below_top(cell) && area(cell.area) > kSpeck)
      highest_first.push_back(level_of_.size() - 1);
  }
  std::stable_sort(highest_first.begin(), highest_first.end(),
                   [&](std::size_t a, std::size_t b) { return cells[a].z > cells[b].z; });
  for (const std::size_t i : highest_first) level_of_[i] = level_under(cells[i].z, floors, others);
  std::vector<double> heights = floors;
  heights.insert(heights.end(), others.begin(), others.end());
  heights.push_back(solid_.z_bottom);
  std::sort(heights.rbegin(), heights.rend());
  const auto same = [](double a, double b) { return std::abs(a - b) < kSameHeight; };
  heights.erase(std::unique(heights.begin(), heights.end(), same), heights.end());
  return heights;
}

void Finder::refuse_too_much(std::size_t levels) const {
  std::size_t edges = 0;
  for (const Cell& cell : map_.cells())
    for (const Path& path : cell.curves) edges += path.size();
  if (static_cast<double>(levels) * static_cast<double>(edges) > kMostWork)
    throw InputError(file_name_, "the solid has " + std::to_string(levels) + " heights and " +
                                     std::to_string(edges) + " edges, too many to plan; simplify it");
}

void Finder::add_level(double z, const Regions& free) {
  const Region stock = rectangular_region(stock_.plan);
  const Box inside = solid_.plan.grown(kOpenReach / 2);
  for (const Region& area : free) {
    const bool open = !inside.contains(area.box().min);
    if (!open) {
      add_area(area, area, false, z);
      continue;
    }
    for (const Region& target : intersect({area}, {stock}, tol_)) add_area(target, area, true, z);
  }
}

/// Indices of the cells over which the region is cut down to z: floors at that height, and non-flat faces ending
/// there.
std::vector<int> Finder::floors_in(const Region& region, double z) const {
  std::vector<int> floors;
  const auto& cells = map_.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_cut = cells[i].floor || cells[i].z < stock_.z_top - kSameHeight;
    if (is_cut && std::abs(level_of_[i] - z) < kSameHeight && any_inside(cells[i].inside, region))
      floors.push_back(static_cast<int>(i));
  }
  return floors;
}

/// mm. Length of the point of the hole's available drill; 0 without one.
double Finder::point_below(const Feature& hole) const {
  return drill_of(hole) ? kDrillPoint * *hole.hole_diameter : 0;
}

FeatureKind Finder::kind_of(const Region& target, bool open, bool through) const {
  if (!open) return circle_diameter(target, tol_) ? FeatureKind::kRoundHole : FeatureKind::kClosedPocket;
  if (through) return FeatureKind::kOutsideProfile;
  const double whole = stock_.plan.width() * stock_.plan.height();
  return target.area() > whole - kSpeck ? FeatureKind::kPlanarFace : FeatureKind::kOpenPocket;
}

void Finder::add_area(const Region& target, const Region& allowed, bool open, double z) {
  if (target.area() < kSpeck) return;
  const std::vector<int> floors = floors_in(target, z);
  const bool through = z < solid_.z_bottom + kSameHeight;
  if (floors.empty() && !through) return;
  Feature feature;
  feature.kind = kind_of(target, open, through);
  feature.name = name_of(feature.kind);
  feature.target = {target};
  feature.allowed = {allowed};
  if (const auto circle = open ? std::nullopt : circle_like(target)) {
    feature.target = feature.allowed = {*circle};
    feature.kind = kind_of(*circle, open, through);
    feature.name = name_of(feature.kind);
  }
  feature.top_z = stock_.z_top;
  feature.floor_z = z;
  feature.through = through;
  if (feature.kind == FeatureKind::kRoundHole)
    feature.hole_diameter = circle_diameter(feature.target[0], tol_);
  if (through) feature.floor_z -= breakthrough_ + point_below(feature);
  for (const int index : floors) {
    const Cell& cell = map_.cells()[static_cast<std::size_t>(index)];
    if (!cell.floor) continue;
    reached_.insert(index);
    const SolidFace& face = solid_.faces[static_cast<std::size_t>(cell.face)];
    feature.source += (feature.source.empty() ? "face " : ", ") + std::to_string(face.number);
  }
  if (!floors.empty() && feature.source.empty()) feature.source = "above what is not flat";
  found_.push_back(std::move(feature));
}

void Finder::leave_out_thin() {
  for (const Feature& thin : settle_tops(found_, stock_, tol_)) {
    deepest_thin_ = std::max(deepest_thin_, thin.top_z - thin.floor_z);
    thin_.skip(file_name_, "the floor at z " + trimmed(thin.floor_z, 5) + " (" + thin.source + ") lies " +
                               trimmed(thin.top_z - thin.floor_z, 5) + " mm below what is around it, " +
                               "too little for a cut: left out");
  }
}

bool Finder::shape_faces() {
  const SolidWork work{solid_, map_.cells(), found_, stock_, options_.solid.tools};
  for (ShapedFaces made : {broken_edges_of(work, tol_), fillets_of(work, tol_)}) {
    shaped_.merge(made.faces);
    proposals_.insert(proposals_.end(), made.proposals.begin(), made.proposals.end());
    std::move(made.features.begin(), made.features.end(), std::back_inserter(found_));
  }
  return !found_.empty();
}

void Finder::take_asked() {
  name_features(found_);
  if (!options_.layer_rules.empty()) {
    apply_operations(found_, stock_, options_, asked_);
    if (found_.empty()) throw InputError(file_name_, "all of its features are to be left out (--op ignore)");
    settle_tops(found_, stock_, tol_);
  }
  end_holes();
}

/// The drill at hand for the hole; null without one.
const Tool* Finder::drill_of(const Feature& hole) const {
  const auto found = std::find_if(drills_.begin(), drills_.end(), [&](const Tool& drill) {
    return hole.hole_diameter && features::is_near_size(drill.diameter, *hole.hole_diameter);
  });
  return found == drills_.end() ? nullptr : &*found;
}

/// Names of features, a few.
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kNamed = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kNamed); ++i) text += (i ? ", " : "") + names[i];
  return names.size() > kNamed ? text + ", ..." : text;
}

/// Decides how blind holes end for which nothing else was asked.
void Finder::end_holes() {
  for (Feature& feature : found_) {
    if (feature.kind != FeatureKind::kRoundHole || feature.through || feature.hole ||
        feature.target.size() != 1)
      continue;
    for (const int index : floors_in(feature.target.front(), feature.floor_z)) {
      const Cell& cell = map_.cells()[static_cast<std::size_t>(index)];
      if (cell.floor) end_hole(feature, solid_.faces[static_cast<std::size_t>(cell.face)]);
    }
  }
}

/// Whether a face of the solid lies within the cone that a point of this length, mm, cuts below the hole's flat floor.
/// Faces count as their boxes in plan view.
bool Finder::is_pierced(const Feature& hole, double point) const {
  const Vec2 center = box(hole.target).center();
  const double radius = *hole.hole_diameter / 2;
  return std::any_of(solid_.faces.begin(), solid_.faces.end(), [&](const SolidFace& face) {
    if (face.z_low > hole.floor_z - kSameHeight || face.z_high < hole.floor_z - point) return false;
    const double below = std::max(0.0, hole.floor_z - face.z_high);
    return face.plan.distance_to(center) < radius * (1 - below / point) - kSlack;
  });
}

/// A cone at the hole's end is made by the point of the hole's drill: the hole has its full width down to where the cone begins. A drill
/// without a stated angle ends with its point on a flat floor, and leaves its cone there.
void Finder::end_hole(Feature& hole, const SolidFace& floor) {
  const Tool* const drill = drill_of(hole);
  if (floor.level) {
    if (!drill) return;
    const double point = point_length(*drill);
    if (!drill->tip_angle) {
      flat_drilled_.push_back(hole.name);
      point_left_ = std::max(point_left_, point);
    } else if (is_pierced(hole, point)) {
      pierced_.push_back(hole.name);
    } else {
      deepened_.push_back(hole.name);
      point_below_ = std::max(point_below_, point);
    }
  } else if (!drill) {
    flat_cones_.push_back(hole.name);
  } else if (!hole.hole) {
    HoleForm form;
    form.center = hole.target.front().outer().front().center;
    form.diameter = *hole.hole_diameter;
    form.full_z = hole.floor_z;
    hole.hole = form;
    hole.floor_z = form.full_z - point_length(*drill);
    if (std::abs(hole.floor_z - floor.z_low) > kSamePoint * form.diameter) other_points_.push_back(hole.name);
  }
}

/// Ends of blind holes that the program makes otherwise than they are drawn.
void Finder::report_hole_ends() {
  if (!flat_drilled_.empty())
    doubt("the floor of " + some_of(flat_drilled_) +
          " is flat and keeps the cone of a drill's point, up to " + trimmed(point_left_, 3) +
          " mm high; --op pocket:" + flat_drilled_.front() +
          " mills it, and a drill with its angle stated (:118deg) goes deeper by its point");
  if (!pierced_.empty())
    doubt("below the flat floor of " + some_of(pierced_) +
          " the point of the drill goes through what is left of the solid; --op pocket:" + pierced_.front() +
          " mills the floor");
  if (!deepened_.empty())
    part_.diagnostics.doubt(file_name_, kNotAsDrawn,
                            "the point of the drill goes below the flat floor of " + some_of(deepened_) +
                                ", up to " + trimmed(point_below_, 3) +
                                " mm, as its angle is stated; --op pocket:" + deepened_.front() +
                                " mills the floor, and a drill without an angle ends there with its point");
  if (!flat_cones_.empty())
    doubt("the cone at the end of " + some_of(flat_cones_) +
          " is not cut: the hole ends flat where it begins; a drill as wide as the hole makes it");
  if (!other_points_.empty())
    doubt("the cone at the end of " + some_of(other_points_) +
          " has another angle than the point of its drill (:118deg states it)");
}

/// Adds a condition for a shape of the solid not made by the program.
void Finder::doubt(const std::string& what) {
  part_.diagnostics.doubt(file_name_, kLeftOut, what);
}

/// Whether a thread is requested in the hole.
bool Finder::is_threaded(const Feature& hole) const {
  const Vec2 center = box(hole.target).center();
  return std::any_of(part_.features.begin(), part_.features.end(), [&](const Feature& other) {
    return other.hole && other.hole->thread && distance(other.hole->center, center) < kSlack;
  });
}

/// Plain holes as wide as the drill before a coarse metric thread: a solid does not state whether they are tapped.
void Finder::propose_taps() {
  constexpr double kSameWidth = 0.011;  // mm
  for (const char* name : {"M2", "M2.5", "M3", "M4", "M5", "M6", "M8", "M10", "M12", "M16", "M20"}) {
    const std::optional<Thread> thread = thread_named(name);
    if (!thread) continue;
    std::vector<std::string> holes;
    bool all_through = true;
    for (const Feature& feature : part_.features) {
      if (feature.hole || !feature.hole_diameter || is_threaded(feature) ||
          std::abs(*feature.hole_diameter - (thread->diameter - thread->pitch)) > kSameWidth)
        continue;
      holes.push_back(feature.name);
      all_through = all_through && feature.through;
    }
    if (holes.empty()) continue;
    const std::string kind = "tap_m" + std::string(name).substr(1) + (all_through ? "_thru" : "");
    part_.diagnostics.note(file_name_, some_of(holes) + (holes.size() == 1 ? " is" : " are") +
                                           " as wide as the drill before " + name + ": --op " + kind + ":" +
                                           holes.front() + " if it is tapped");
  }
}

void Finder::report_hidden_floors() {
  const auto& cells = map_.cells();
  std::set<int> hidden, small;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i].floor || cells[i].z > solid_.z_top - kSameHeight || reached_.count(static_cast<int>(i)))
      continue;
    const bool is_small = area(cells[i].area) < kSpeck;
    part_.diagnostics.skip(file_name_,
                           described(solid_.faces[static_cast<std::size_t>(cells[i].face)]) +
                               (is_small ? " is smaller than " + trimmed(kSpeck, 3) + " mm2: left out"
                                         : " lies under an overhang: left out"));
    (is_small ? small : hidden).insert(cells[i].face + 1);
  }
  add_shadows(hidden);
  add_shadows(small);
  if (!small.empty()) doubt(subject(small) + " smaller than " + trimmed(kSpeck, 3) + " mm2 and left out");
  if (!hidden.empty() && !has_other_setups_) doubt(subject(hidden) + " under an overhang and left out");
}

/// Adds the plan view of these faces, as far as they look up, to the part's faces that are left out.
void Finder::add_shadows(const std::set<int>& faces) {
  for (const Cell& cell : map_.cells()) {
    if (faces.count(cell.face + 1)) part_.left_out = unite(part_.left_out, cell.area, tol_);
  }
}

/// " (cylinder, sphere)": the surfaces of faces; "" if all are planes.
std::string Finder::kinds_of(const std::set<int>& faces) const {
  std::set<std::string> kinds;
  for (const int number : faces) kinds.insert(solid_.faces[static_cast<std::size_t>(number - 1)].surface);
  if (kinds == std::set<std::string>{"plane"}) return "";
  std::string text;
  for (const std::string& kind : kinds) text += (text.empty() ? " (" : ", ") + kind;
  return text + ")";
}

void Finder::report_left_out() {
  std::set<int> floors;
  for (const Cell& cell : map_.cells())
    if (cell.floor && cell.z < solid_.z_top - kSameHeight) floors.insert(cell.face);
  std::set<int> left_out;
  for (const SolidFace& face : solid_.faces) {
    if (face.facing == Facing::kUpright || face.level || floors.count(face.number - 1) ||
        shaped_.count(face.number))
      continue;
    left_out.insert(face.number);
    if (left_out.size() <= kMostDescribed)
      part_.diagnostics.skip(
          file_name_,
          described(face) + " is neither a flat floor nor a vertical wall: left out, its material stays");
  }
  if (left_out.empty()) return;
  add_shadows(left_out);
  std::string tools;
  for (const std::string& one : proposals_) tools += "; " + one;
  doubt(subject(left_out) + " neither flat and level nor upright" + kinds_of(left_out) +
        ": the material up to the top of each stays" + tools);
}

/// Whether the cutter passes directly in front of a wall, down to the wall's foot.
bool Finder::is_reached(const SolidFace& wall) const {
  const Vec2 p = wall.front->before;
  if (!solid_.plan.contains(p)) return true;
  const auto& cells = map_.cells();
  // A wall beside a sloping floor is left out because of this floor, not by itself.
  const auto foot_of = [&](const Cell& cell) {
    return cell.floor ? cell.z : solid_.faces[static_cast<std::size_t>(cell.face)].z_low;
  };
  return std::none_of(cells.begin(), cells.end(), [&](const Cell& cell) {
    return foot_of(cell) > wall.z_low + 0.001 && contains(cell.area, p);
  });
}

/// Whether a wall facing it is in front of its middle: no cutter can come from there.
bool Finder::is_faced(const SolidFace& wall) const {
  const Vec2 p = wall.front->before;
  const double z = (wall.z_low + wall.z_high) / 2;
  return std::any_of(solid_.faces.begin(), solid_.faces.end(), [&](const SolidFace& other) {
    if (!other.front || dot(other.front->outward, wall.front->outward) > -0.5) return false;
    const Vec2 away = other.plan.center() - p;
    if (dot(away, wall.front->outward) <= 0 || z < other.z_low || z > other.z_high) return false;
    const Vec2 across = left_of(wall.front->outward);
    const double reach = std::abs(across.x) * other.plan.width() + std::abs(across.y) * other.plan.height();
    return std::abs(dot(away, across)) <= reach / 2;
  });
}

/// Whether the solid continues below the middle of a downward face.
bool Finder::is_undermined(const SolidFace& ceiling) const {
  const auto& cells = map_.cells();
  return std::any_of(cells.begin(), cells.end(), [&](const Cell& cell) {
    return cell.z < ceiling.z_low - kSameHeight && contains(cell.area, ceiling.plan.center());
  });
}

/// Index into kSetUps of the direction for which the face is a floor; -1 for none.
int Finder::set_up_of(const SolidFace& face) const {
  if (face.level && face.facing == Facing::kDown)
    return face.z_low > solid_.z_bottom + kSameHeight && !is_undermined(face) ? 0 : -1;
  if (!face.front || is_reached(face) || is_faced(face)) return -1;
  const Vec2 out = face.front->outward;
  if (out.x != 0) return out.x > 0 ? 1 : 2;
  return out.y > 0 ? 3 : 4;
}

/// Reports if more floors face another direction than this.
void Finder::propose_side(const std::array<std::vector<int>, 5>& floors) {
  if (has_other_setups_) return;
  const auto most = std::max_element(floors.begin(), floors.end(),
                                     [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::set<int> here;
  for (const int index : reached_) here.insert(map_.cells()[static_cast<std::size_t>(index)].face);
  if (most->size() <= here.size()) return;
  const std::string side = kSetUps[static_cast<std::size_t>(most - floors.begin())];
  const bool is_turned = !options_.solid.up.empty() && options_.solid.up != "+Z";
  part_.diagnostics.warn(file_name_, std::to_string(most->size()) + " floors look along " + side +
                                         (is_turned ? " as it is turned" : "") + ", and " +
                                         std::to_string(here.size()) + " up: most is made with that side up" +
                                         (is_turned ? "" : " (--up " + side + ")"));
}

/// Reports floors of other directions, one line for each direction.
void Finder::report_set_ups() {
  std::array<std::vector<int>, std::size(kSetUps)> floors;
  for (const SolidFace& face : solid_.faces) {
    const int direction = set_up_of(face);
    if (direction >= 0) floors[static_cast<std::size_t>(direction)].push_back(face.number);
  }
  std::set<int> sideways;
  for (std::size_t i = 0; i < floors.size(); ++i) {
    if (floors[i].empty()) continue;
    std::string names;
    for (std::size_t k = 0; k < std::min<std::size_t>(floors[i].size(), 10); ++k)
      names += (k ? ", " : "") + std::to_string(floors[i][k]);
    part_.diagnostics.skip(file_name_, std::to_string(floors[i].size()) + " floor(s) look along " +
                                           kSetUps[i] + " (faces " + names +
                                           (floors[i].size() > 10 ? ", ..." : "") +
                                           "): they need another set-up, with the solid turned");
    sideways.insert(floors[i].begin(), floors[i].end());
  }
  propose_side(floors);
  if (!sideways.empty() && !has_other_setups_)
    doubt(subject(sideways) + " not made from this side: " +
          (sideways.size() == 1 ? "it needs" : "they need") + " another set-up");
}

}  // namespace

Part read_step_solid(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  const SolidOptions& how = options.solid;
  const SolidModel solid = load_solid(text, file_name, {how.up, how.turn_deg, how.body});
  refuse_assembly(solid, file_name);
  const auto offers = [&](const std::string& side) {
    ReadOptions turned = options;
    turned.solid.stock.reset();
    const SolidModel other = load_solid(text, file_name, {side, how.turn_deg, how.body});
    return Finder(other, file_name, turned).find();
  };
  if (how.up.empty() && !how.is_stock) {
    refuse_sheet_on_edge(solid, file_name, offers);
    refuse_askew(solid, file_name);
  }
  Finder finder(solid, file_name, options);
  finder.find();
  if (!how.is_stock) {
    if (!finder.shape_faces()) refuse_without_floor(solid, file_name, how.up, finder.why_nothing(), offers);
    finder.take_asked();
  }
  Part part = finder.part(how.stock.has_value());
  part.is_solid = true;
  if (options.unit || options.depth || options.top || !options.layers.empty()) {
    part.diagnostics.warn(file_name,
                          "unit, depth, top and layers given as options are for drawings; not used here");
  }
  return part;
}

}  // namespace clearcut::read
