#include "read/outline/outline_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/format.h"
#include "read/outline/drawing.h"
#include "read/outline/json_value.h"
#include "read/outline/text.h"
#include "read/outline/units.h"
#include "read/repair/repair.h"

namespace clearcut {
namespace {

const std::set<std::string> kOutlineKeys{"name", "units", "outer", "islands", "top", "depth", "slope_rad"};
constexpr double kSteepest = 1.5;  // rad from vertical: beyond this a wall is a floor

/// One file while it is being read.
struct Context {
  const std::string& file;
  const ReadOptions& options;
  Diagnostics& diagnostics;

  std::string at(const JsonValue& value) const { return file + ":" + std::to_string(value.line); }
  [[noreturn]] void fail(const JsonValue& value, const std::string& what) const {
    throw InputError(at(value), what);
  }
};

double number_of(const Context& context, const JsonValue& value, const std::string& what) {
  if (!value.is_number()) context.fail(value, what + " must be a number");
  return value.number;
}

BulgeVertex vertex_of(const Context& context, const JsonValue& value, double unit) {
  if (!value.is_array() || value.items.size() < 2 || value.items.size() > 3) {
    context.fail(value, "a vertex must be [x, y] or [x, y, bulge]");
  }
  BulgeVertex vertex;
  vertex.point = {unit * number_of(context, value.items[0], "x"),
                  unit * number_of(context, value.items[1], "y")};
  if (value.items.size() == 3) vertex.bulge = number_of(context, value.items[2], "the bulge");
  return vertex;
}

RawCurve curve_of(const Context& context, const JsonValue& value, double unit, const std::string& name) {
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

std::vector<RawCurve> curves_of(const Context& context, const JsonValue& outline, double unit) {
  const JsonValue* outer = outline.find("outer");
  if (!outer)
    context.fail(outline, "\"outer\" is missing; give the outline as \"outer\": [[x, y, bulge], ...]");
  std::vector<RawCurve> curves{curve_of(context, *outer, unit, "outer")};
  const JsonValue* islands = outline.find("islands");
  if (!islands) return curves;
  if (!islands->is_array()) context.fail(*islands, "\"islands\" must be a list of outlines");
  for (const auto& island : islands->items) {
    curves.push_back(curve_of(context, island, unit, "island " + std::to_string(curves.size())));
  }
  return curves;
}

/// An island that has no vertex inside the outline is a mistake, not a second pocket.
void refuse_islands_outside(const Context& context, const JsonValue& outline, const std::vector<RawCurve>& curves) {
  const Loop& outer = curves.front().edges;
  for (std::size_t i = 1; i < curves.size(); ++i) {
    const bool inside = std::any_of(curves[i].edges.begin(), curves[i].edges.end(),
                                    [&](const Edge& edge) { return contains(outer, edge.from); });
    if (!inside) {
      context.fail(outline, "island " + std::to_string(i) + " lies outside \"outer\"; move it inside or leave it out");
    }
  }
}

void note_unknown_keys(const Context& context, const JsonValue& value, const std::set<std::string>& known) {
  std::string names;
  for (const auto& [key, member] : value.members) {
    if (!known.count(key)) names += (names.empty() ? "\"" : ", \"") + printable(key) + "\"";
  }
  if (!names.empty()) context.diagnostics.note(context.at(value), "not used: " + names);
}

double depth_of(const Context& context, const JsonValue& outline, double unit) {
  if (context.options.depth) return *context.options.depth;
  const JsonValue* value = outline.find("depth");
  if (!value) context.fail(outline, "\"depth\" is missing; add \"depth\": 2 or give the depth as an option");
  const double depth = unit * number_of(context, *value, "\"depth\"");
  if (!(depth > 0) || depth > kLargestCoordinate) {
    context.fail(*value, "\"depth\" is " + trimmed(depth, 6) + " mm; it must be above 0");
  }
  return depth;
}

double optional_number(const Context& context, const JsonValue& outline, const std::string& key,
                       double otherwise) {
  const JsonValue* value = outline.find(key);
  return value ? number_of(context, *value, "\"" + key + "\"") : otherwise;
}

std::string text_of(const Context& context, const JsonValue& outline, const std::string& key,
                    const std::string& otherwise) {
  const JsonValue* value = outline.find(key);
  if (!value) return otherwise;
  if (!value->is_string()) context.fail(*value, "\"" + key + "\" must be text");
  return value->text;
}

double unit_of(const Context& context, const JsonValue& outline, double otherwise) {
  if (context.options.unit) return require_unit(*context.options.unit, "unit");
  const JsonValue* value = outline.find("units");
  if (!value) return otherwise;
  if (!value->is_string()) context.fail(*value, "\"units\" must be text, for example \"mm\"");
  return require_unit(value->text, context.at(*value));
}

Radians slope_of(const Context& context, const JsonValue& outline) {
  const double slope = optional_number(context, outline, "slope_rad", 0);
  if (!(std::abs(slope) <= kSteepest)) {
    context.fail(*outline.find("slope_rad"),
                 "\"slope_rad\" is " + trimmed(slope, 4) + "; it must lie within +-1.5");
  }
  return Radians::of(slope);
}

Feature feature_of(const Context& context, const JsonValue& outline, double unit, const std::string& name) {
  Feature feature;
  feature.name = text_of(context, outline, "name", name);
  if (feature.name.empty()) feature.name = name;
  feature.source = "line " + std::to_string(outline.line);
  feature.top_z =
      context.options.top ? *context.options.top : unit * optional_number(context, outline, "top", 0);
  if (!(std::abs(feature.top_z) <= kLargestCoordinate)) context.fail(outline, "\"top\" is out of range");
  feature.floor_z = feature.top_z - depth_of(context, outline, unit);
  feature.wall_slope = slope_of(context, outline);
  RepairOptions repair_options;
  repair_options.tol = context.options.tol;
  repair_options.where = context.file;
  repair_options.open_curves = context.options.open_curves;
  repair_options.find_arcs = context.options.find_arcs.value_or(false);
  const auto curves = curves_of(context, outline, unit);
  refuse_islands_outside(context, outline, curves);
  feature.target = repair(curves, repair_options, context.diagnostics);
  feature.allowed = feature.target;
  return feature;
}

}  // namespace

Part read_outline_json(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  const JsonValue root = parse_json(text, file_name);
  Part part;
  part.source_file = file_name;
  const Context context{file_name, options, part.diagnostics};
  if (!root.is_object())
    context.fail(root, "an outline must be an object: {\"outer\": [...], \"depth\": ...}");
  const std::string stem = std::filesystem::path(file_name).stem().string();
  part.name = text_of(context, root, "name", stem);
  const double unit = unit_of(context, root, 1);
  const JsonValue* pockets = root.find("pockets");
  if (!pockets) {
    note_unknown_keys(context, root, kOutlineKeys);
    add_feature(part, feature_of(context, root, unit, part.name.empty() ? "pocket" : part.name));
    return part;
  }
  note_unknown_keys(context, root, {"name", "units", "pockets"});
  if (!pockets->is_array() || pockets->items.empty()) {
    context.fail(*pockets, "\"pockets\" must be a list with at least one outline");
  }
  for (const auto& pocket : pockets->items) {
    if (!pocket.is_object()) context.fail(pocket, "a pocket must be an object with \"outer\" and \"depth\"");
    note_unknown_keys(context, pocket, kOutlineKeys);
    const std::string name = "pocket" + std::to_string(part.features.size() + 1);
    add_feature(part, feature_of(context, pocket, unit_of(context, pocket, unit), name));
  }
  return part;
}

Part read_outline_json(std::string_view text, const std::string& file_name, const Tolerances& tol) {
  ReadOptions options;
  options.tol = tol;
  return read_outline_json(text, file_name, options);
}

}  // namespace clearcut
