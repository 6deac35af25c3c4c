#include "read/outline/outline_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "features/derived_outlines.h"
#include "features/standing.h"
#include "geometry/contours/boolean.h"
#include "read/common/data_value.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/drawing/overlaps.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

const std::set<std::string> kOutlineKeys{"name",   "kind",   "outer",       "islands", "allowed",
                                         "top",    "depth",  "slope_rad",   "through", "line",
                                         "closed", "beyond", "floor_fillet"};
constexpr double kSteepest = 1.5;  // rad from vertical: beyond this a wall is a floor

/// A file being read.
struct Context {
  const std::string& file;
  const ReadOptions& options;
  Diagnostics& diagnostics;

  std::string at(const DataValue& value) const { return file + ":" + std::to_string(value.line); }
  [[noreturn]] void fail(const DataValue& value, const std::string& what) const {
    throw InputError(at(value), what);
  }
};

double number_of(const Context& context, const DataValue& value, const std::string& what) {
  if (!value.is_number()) context.fail(value, what + " must be a number");
  return value.number;
}

BulgeVertex vertex_of(const Context& context, const DataValue& value, double unit) {
  if (!value.is_array() || value.items.size() < 2 || value.items.size() > 3) {
    context.fail(value, "a vertex must be [x, y] or [x, y, bulge]");
  }
  BulgeVertex vertex;
  vertex.point = {unit * number_of(context, value.items[0], "x"),
                  unit * number_of(context, value.items[1], "y")};
  if (value.items.size() == 3) vertex.bulge = number_of(context, value.items[2], "the bulge");
  return vertex;
}

RawCurve curve_of(const Context& context, const DataValue& value, double unit, const std::string& name) {
  if (!value.is_array()) context.fail(value, name + " must be a list of [x, y, bulge]");
  if (value.items.size() < 2)
    context.fail(value, name + " needs at least 2 vertices, and 3 unless it has arcs");
  std::vector<BulgeVertex> vertices;
  vertices.reserve(value.items.size());
  for (const auto& item : value.items) vertices.push_back(vertex_of(context, item, unit));
  RawCurve curve;
  curve.closed = true;
  curve.source = name + ", line " + std::to_string(value.line);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& next = vertices[(i + 1) % vertices.size()];
    curve.edges.push_back(Edge::from_bulge(vertices[i].point, next.point, vertices[i].bulge));
  }
  return curve;
}

std::vector<RawCurve> curves_of(const Context& context, const DataValue& outline, double unit) {
  const DataValue* outer = outline.find("outer");
  if (!outer)
    context.fail(outline, "\"outer\" is missing; give the outline as \"outer\": [[x, y, bulge], ...]");
  std::vector<RawCurve> curves{curve_of(context, *outer, unit, "outer")};
  const DataValue* islands = outline.find("islands");
  if (!islands) return curves;
  if (!islands->is_array()) context.fail(*islands, "\"islands\" must be a list of outlines");
  for (const auto& island : islands->items) {
    curves.push_back(curve_of(context, island, unit, "island " + std::to_string(curves.size())));
  }
  return curves;
}

/// An island without a vertex inside the outline is a mistake, not a second pocket.
void refuse_islands_outside(const Context& context, const DataValue& outline,
                            const std::vector<RawCurve>& curves) {
  const Loop& outer = curves.front().edges;
  for (std::size_t i = 1; i < curves.size(); ++i) {
    const bool inside = std::any_of(curves[i].edges.begin(), curves[i].edges.end(),
                                    [&](const Edge& edge) { return contains(outer, edge.from); });
    if (!inside) {
      context.fail(outline,
                   "island " + std::to_string(i) + " lies outside \"outer\"; move it inside or leave it out");
    }
  }
}

void note_unknown_keys(const Context& context, const DataValue& value, const std::set<std::string>& known) {
  std::string names;
  for (const auto& [key, member] : value.members) {
    if (!known.count(key)) names += (names.empty() ? "\"" : ", \"") + printable(key) + "\"";
  }
  if (!names.empty()) context.diagnostics.note(context.at(value), "not used: " + names);
}

double depth_of(const Context& context, const DataValue& outline, double unit) {
  const ReadOptions& options = context.options;
  if (options.depth) return checked_depth(*options.depth, "depth");
  const DataValue* value = outline.find("depth");
  if (!value && options.depth_if_missing) {
    context.diagnostics.warn(context.at(outline),
                             "no depth given: " + trimmed(*options.depth_if_missing, 4) + " mm assumed");
    return checked_depth(*options.depth_if_missing, "depth");
  }
  if (!value) context.fail(outline, "\"depth\" is missing; add \"depth\": 2 or give the depth as an option");
  return checked_depth(unit * number_of(context, *value, "\"depth\""), context.at(*value));
}

double optional_number(const Context& context, const DataValue& outline, const std::string& key,
                       double otherwise) {
  const DataValue* value = outline.find(key);
  return value ? number_of(context, *value, "\"" + key + "\"") : otherwise;
}

std::string text_of(const Context& context, const DataValue& outline, const std::string& key,
                    const std::string& otherwise) {
  const DataValue* value = outline.find(key);
  if (!value) return otherwise;
  if (!value->is_string()) context.fail(*value, "\"" + key + "\" must be text");
  return value->text;
}

double unit_of(const Context& context, const DataValue& root) {
  if (context.options.unit) return require_unit(*context.options.unit, "unit");
  const DataValue* value = root.find("units");
  if (!value) {
    context.diagnostics.note(context.file, "no \"units\" given: millimetres assumed");
    return 1;
  }
  if (!value->is_string()) context.fail(*value, "\"units\" must be text, for example \"mm\"");
  return require_unit(value->text, context.at(*value));
}

bool flag_of(const Context& context, const DataValue& outline, const std::string& key) {
  const DataValue* value = outline.find(key);
  if (!value) return false;
  if (value->kind != DataValue::Kind::kBoolean) context.fail(*value, "\"" + key + "\" must be true or false");
  return value->boolean;
}

Radians slope_of(const Context& context, const DataValue& outline) {
  const double slope = optional_number(context, outline, "slope_rad", 0);
  if (!(std::abs(slope) <= kSteepest)) {
    context.fail(*outline.find("slope_rad"),
                 "\"slope_rad\" is " + trimmed(slope, 4) + "; it must lie within +-1.5");
  }
  return Radians::of(slope);
}

/// mm.
double floor_fillet_of(const Context& context, const DataValue& outline, double unit) {
  const double radius = unit * optional_number(context, outline, "floor_fillet", 0);
  if (!(radius >= 0 && radius <= kLargestCoordinate))
    context.fail(*outline.find("floor_fillet"), "\"floor_fillet\" must be a radius of 0 or more");
  return radius;
}

FeatureKind kind_of(const Context& context, const DataValue& outline) {
  const std::string name = text_of(context, outline, "kind", name_of(FeatureKind::kClosedPocket));
  for (const FeatureKind kind :
       {FeatureKind::kClosedPocket, FeatureKind::kOpenPocket, FeatureKind::kPlanarFace, FeatureKind::kSlot,
        FeatureKind::kStep, FeatureKind::kRoundHole, FeatureKind::kOutsideProfile,
        FeatureKind::kInsideProfile, FeatureKind::kEngraving, FeatureKind::kTSlot, FeatureKind::kIsolation}) {
    if (name == name_of(kind)) return kind;
  }
  context.fail(*outline.find("kind"),
               "unknown kind '" + printable(name) +
                   "'; use closed_pocket, open_pocket, planar_face, slot, step, round_hole, "
                   "outside_profile, inside_profile, engraving, t_slot or isolation");
}

Regions regions_of(const Context& context, const DataValue& outline, double unit) {
  RepairOptions options;
  options.tol = context.options.tol;
  options.where = context.file;
  options.open_curves = context.options.open_curves.value_or(OpenCurves::kRefuse);
  options.find_arcs = context.options.find_arcs.value_or(false);
  std::vector<RawCurve> curves = curves_of(context, outline, unit);
  refuse_islands_outside(context, outline, curves);
  return repair(std::move(curves), options, context.diagnostics);
}

/// The area permitted to the cutter: the outlines in "allowed" for open sides, else the target itself.
Regions allowed_of(const Context& context, const DataValue& outline, double unit, const Regions& target) {
  const DataValue* allowed = outline.find("allowed");
  if (!allowed) return target;
  if (!allowed->is_array()) context.fail(*allowed, "\"allowed\" must be a list of {\"outer\", \"islands\"}");
  Regions regions;
  for (const DataValue& item : allowed->items) {
    if (!item.is_object()) context.fail(item, "\"allowed\" must be a list of {\"outer\", \"islands\"}");
    for (Region& region : regions_of(context, item, unit)) regions.push_back(std::move(region));
  }
  // The target must be inside, as guaranteed by Feature: overlaps are united.
  return unite(regions, target, context.options.tol);
}

/// The vertices of "line" joined; the last one to the first if `closed`.
Path line_of(const Context& context, const DataValue& value, double unit, bool closed) {
  RawCurve curve = curve_of(context, value, unit, "line");
  if (!closed) curve.edges.pop_back();
  return std::move(curve.edges);
}

/// The outline followed by a cutter on one side, or the line to engrave.
ProfileCut profile_of(const Context& context, const DataValue& outline, double unit, FeatureKind kind) {
  const DataValue* line = outline.find("line");
  ProfileCut cut;
  cut.side = kind == FeatureKind::kOutsideProfile  ? ProfileSide::kOutside
             : kind == FeatureKind::kInsideProfile ? ProfileSide::kInside
                                                   : ProfileSide::kOn;
  cut.closed = !outline.find("closed") || flag_of(context, outline, "closed");
  if (!cut.closed && cut.side != ProfileSide::kOn)
    context.fail(*line, "a profile's \"line\" must be closed; close it, or make it an engraving");
  cut.beyond = unit * optional_number(context, outline, "beyond", 0);
  if (!(cut.beyond >= 0 && cut.beyond <= kLargestCoordinate))
    context.fail(outline, "\"beyond\" must be a length of 0 or more");
  cut.line = line_of(context, *line, unit, cut.closed);
  if (cut.side == ProfileSide::kOn) return cut;
  // Crossings are refused later, in the repair of outlines.
  RepairOptions options;
  options.tol = context.options.tol;
  options.where = context.file;
  const Regions whole = repair({curve_of(context, *line, unit, "line")}, options, context.diagnostics);
  if (whole.size() != 1 || !whole.front().islands().empty())
    context.fail(*line, "a profile's \"line\" must be one simple outline; correct it");
  if (signed_area(cut.line) < 0) cut.line = reversed(cut.line);
  return cut;
}

bool follows_line(FeatureKind kind) {
  return kind == FeatureKind::kInsideProfile || kind == FeatureKind::kEngraving ||
         kind == FeatureKind::kTSlot;
}

void set_areas(const Context& context, const DataValue& outline, double unit, Feature& feature) {
  if (!outline.find("line")) {
    if (follows_line(feature.kind))
      context.fail(outline,
                   "\"line\" is missing; give what the cutter follows as \"line\": [[x, y, bulge], ...]");
    feature.target = regions_of(context, outline, unit);
    feature.allowed = allowed_of(context, outline, unit, feature.target);
    return;
  }
  if (feature.kind != FeatureKind::kOutsideProfile && !follows_line(feature.kind))
    context.fail(*outline.find("line"),
                 "only profiles and engravings have a \"line\"; give \"outer\" instead");
  features::follow(feature, profile_of(context, outline, unit, feature.kind), context.options.tol);
}

Feature feature_of(const Context& context, const DataValue& outline, double unit, const std::string& name) {
  Feature feature;
  feature.name = text_of(context, outline, "name", name);
  if (feature.name.empty()) feature.name = name;
  feature.source = "line " + std::to_string(outline.line);
  feature.kind = kind_of(context, outline);
  feature.top_z =
      context.options.top ? *context.options.top : unit * optional_number(context, outline, "top", 0);
  if (!(std::abs(feature.top_z) <= kLargestCoordinate)) context.fail(outline, "\"top\" is out of range");
  feature.floor_z = feature.top_z - depth_of(context, outline, unit);
  feature.wall_slope = slope_of(context, outline);
  feature.floor_fillet = floor_fillet_of(context, outline, unit);
  feature.through = flag_of(context, outline, "through");
  set_areas(context, outline, unit, feature);
  if (feature.kind == FeatureKind::kRoundHole) {
    if (feature.target.size() == 1)
      feature.hole_diameter = circle_diameter(feature.target[0], context.options.tol);
    if (!feature.hole_diameter)
      context.fail(outline, "a round_hole must be one circle; correct its outline or its kind");
  }
  return feature;
}

/// "x": [low, high] of the stock.
std::array<double, 2> range_of(const Context& context, const DataValue& stock, const std::string& axis,
                               double unit) {
  const DataValue* value = stock.find(axis);
  if (!value || !value->is_array() || value->items.size() != 2) {
    context.fail(stock, "the stock needs \"" + axis + "\": [low, high]");
  }
  const double low = unit * number_of(context, value->items[0], axis),
               high = unit * number_of(context, value->items[1], axis);
  if (!(low < high) || !(std::abs(low) <= kLargestCoordinate) || !(std::abs(high) <= kLargestCoordinate)) {
    context.fail(*value, "the stock's " + axis + " range is empty or out of range");
  }
  return {low, high};
}

std::optional<Stock> stock_of(const Context& context, const DataValue& root, double unit) {
  const DataValue* value = root.find("stock");
  if (!value) return std::nullopt;
  if (!value->is_object())
    context.fail(*value, "\"stock\" must be {\"x\": [low, high], \"y\": ..., \"z\": ...}");
  const auto x = range_of(context, *value, "x", unit), y = range_of(context, *value, "y", unit);
  const auto z = range_of(context, *value, "z", unit);
  return Stock{{{x[0], y[0]}, {x[1], y[1]}}, z[0], z[1]};
}

void add_pockets(const Context& context, const DataValue& pockets, double unit, Part& part) {
  if (!pockets.is_array() || pockets.items.empty()) {
    context.fail(pockets, "\"pockets\" must be a list with at least one outline");
  }
  std::vector<Feature> features;
  for (const auto& pocket : pockets.items) {
    if (!pocket.is_object()) context.fail(pocket, "a pocket must be an object with \"outer\" and \"depth\"");
    note_unknown_keys(context, pocket, kOutlineKeys);
    const std::string name = "pocket" + std::to_string(features.size() + 1);
    features.push_back(feature_of(context, pocket, unit, name));
  }
  add_features(part, std::move(features));
  if (part.features.size() > 1) features::stack_tops(part, context.options.tol);
}

}  // namespace

Part read_outline_json(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  return read_outline_value(parse_json(text, file_name), file_name, options);
}

Part read_outline_value(const DataValue& root, const std::string& file_name, const ReadOptions& options) {
  Part part;
  part.source_file = file_name;
  const Context context{file_name, options, part.diagnostics};
  if (!root.is_object())
    context.fail(root, "an outline must be an object: {\"outer\": [...], \"depth\": ...}");
  const std::string stem = std::filesystem::path(file_name).stem().string();
  part.name = text_of(context, root, "name", stem);
  const double unit = unit_of(context, root);
  part.stock = stock_of(context, root, unit);
  if (const DataValue* pockets = root.find("pockets")) {
    note_unknown_keys(context, root, {"name", "units", "stock", "pockets"});
    add_pockets(context, *pockets, unit, part);
  } else {
    std::set<std::string> known = kOutlineKeys;
    known.insert({"units", "stock"});
    note_unknown_keys(context, root, known);
    add_features(part, {feature_of(context, root, unit, part.name.empty() ? "pocket" : part.name)});
  }
  open_at_stock_edge(part, options.tol);
  return part;
}

Part read_outline_json(std::string_view text, const std::string& file_name, const Tolerances& tol) {
  ReadOptions options;
  options.tol = tol;
  return read_outline_json(text, file_name, options);
}

}  // namespace clearcut::read
