#include "read/common/drawing.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "base/error.h"
#include "base/format.h"
#include "geometry/boolean.h"
#include "read/common/text.h"
#include "read/repair/mends.h"
#include "stock/stacking.h"

namespace clearcut::read {
namespace {

/// What the options say goes before what the file says.
double depth_of(const DrawnGroup& group, const ReadOptions& options, Diagnostics& diagnostics) {
  std::optional<double> depth = options.depth ? options.depth : group.depth;
  if (!depth && options.depth_if_missing) {
    depth = options.depth_if_missing;
    diagnostics.warn(group.where, "no depth given: " + trimmed(*depth, 4) + " mm assumed");
  }
  if (!depth) {
    throw InputError(group.where, "no depth given; add it as an option, or name the layer like POCKET_D5");
  }
  return checked_depth(*depth, group.where);
}

RepairOptions repair_options(const DrawnGroup& group, const ReadOptions& options) {
  RepairOptions out;
  out.tol = options.tol;
  out.where = group.where;
  out.open_curves = options.open_curves;
  out.find_arcs = options.find_arcs.value_or(true);
  return out;
}

Feature feature_of(const DrawnGroup& group, Region region, double depth, const ReadOptions& options) {
  Feature feature;
  feature.name = group.name == "0" ? "pocket" : group.name;
  feature.source = group.name;
  feature.top_z = options.top ? *options.top : group.top.value_or(0);
  feature.floor_z = feature.top_z - depth;
  if (group.role == LayerRole::kHole) {
    feature.hole_diameter = circle_diameter(region, options.tol);
    if (!feature.hole_diameter) {
      throw InputError(group.where,
                       "the outline at " + place_text(region.outer().front().from) +
                           " is on a layer of holes and is no circle; draw a circle or rename the layer");
    }
    feature.kind = FeatureKind::kRoundHole;
  }
  feature.target = {std::move(region)};
  feature.allowed = feature.target;
  return feature;
}

Regions islands_of(std::vector<DrawnGroup>& groups, const ReadOptions& options, Diagnostics& diagnostics) {
  Regions islands;
  for (DrawnGroup& group : groups) {
    if (group.role != LayerRole::kIsland) continue;
    const Regions more = repair(std::move(group.curves), repair_options(group, options), diagnostics);
    islands = islands.empty() ? more : unite(islands, more, options.tol);
  }
  return islands;
}

/// In the words of the reader; "" for none.
std::string what_was_left_out(const Diagnostics& diagnostics) {
  std::string all;
  for (const Diagnostic& item : diagnostics.items())
    if (item.severity == Severity::kSkipped) all += (all.empty() ? "" : "; ") + item.what;
  return all.empty() ? "" : " (" + all + ")";
}

bool near_any(const Regions& regions, const Regions& others) {
  const Box around = box(others);
  return std::any_of(regions.begin(), regions.end(),
                     [&](const Region& region) { return region.box().overlaps(around); });
}

}  // namespace

std::optional<double> circle_diameter(const Region& region, const Tolerances& tol) {
  if (!region.islands().empty()) return std::nullopt;
  const Edge& first = region.outer().front();
  if (!first.is_arc()) return std::nullopt;
  for (const Edge& edge : region.outer()) {
    if (!edge.is_arc() || distance(edge.center, first.center) > tol.join_gap ||
        std::abs(edge.radius() - first.radius()) > tol.join_gap) {
      return std::nullopt;
    }
  }
  return 2 * first.radius();
}

double checked_depth(double depth, const std::string& place) {
  if (!(depth > 0) || depth > kLargestCoordinate) {
    throw InputError(place, "the depth is " + short_number(depth) + " mm; it must be above 0");
  }
  return depth;
}

void apply_rules(const std::vector<LayerRule>& rules, const std::string& name, DrawnGroup& group) {
  const auto rule = std::find_if(rules.begin(), rules.end(), [&](const LayerRule& candidate) {
    return matches(candidate.pattern, name);
  });
  if (rule == rules.end()) return;
  if (rule->role) group.role = *rule->role;
  if (rule->depth) group.depth = rule->depth;
  if (rule->top) group.top = rule->top;
}

void add_features(Part& part, std::vector<Feature> features) {
  std::unordered_set<std::string> taken;
  std::unordered_map<std::string, int> next;  // number to try for a name that is taken
  for (const auto& other : part.features) taken.insert(other.name);
  for (Feature& feature : features) {
    const std::string wanted = feature.name;
    for (int& n = next.try_emplace(wanted, 2).first->second; taken.count(feature.name); ++n) {
      feature.name = wanted + "_" + std::to_string(n);
    }
    taken.insert(feature.name);
    Workingstep step;
    step.name = feature.name;
    step.source = feature.source;
    step.feature = static_cast<int>(part.features.size());
    step.operation.name = feature.name;
    if (feature.kind == FeatureKind::kRoundHole) step.operation.kind = OperationKind::kDrilling;
    part.workplan.push_back(std::move(step));
    part.features.push_back(std::move(feature));
  }
  part.order_free = true;  // as drawn is as it happened to be drawn
}

void report_left_out(Diagnostics& diagnostics, const std::string& file, const LeftOut& left_out,
                     const std::string& what) {
  std::string text;
  for (const auto& [name, count] : left_out)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + printable(name);
  if (!text.empty()) diagnostics.skip(file, what + " " + text);
}

void add_drawn_features(Part& part, std::vector<DrawnGroup> groups, const ReadOptions& options) {
  const Regions islands = islands_of(groups, options, part.diagnostics);
  std::vector<Feature> features;
  for (DrawnGroup& group : groups) {
    if (group.role == LayerRole::kIsland || group.role == LayerRole::kIgnore || group.curves.empty())
      continue;
    const double depth = depth_of(group, options, part.diagnostics);
    Regions regions = repair(std::move(group.curves), repair_options(group, options), part.diagnostics);
    if (!islands.empty() && near_any(islands, regions)) regions = subtract(regions, islands, options.tol);
    for (Region& region : regions) features.push_back(feature_of(group, std::move(region), depth, options));
  }
  if (features.empty()) {
    throw InputError(part.source_file, "nothing to mill was found" + what_was_left_out(part.diagnostics) +
                                           "; draw the pockets as closed curves");
  }
  std::stable_sort(features.begin(), features.end(),
                   [](const Feature& a, const Feature& b) { return a.floor_z > b.floor_z; });
  const bool several_floors = features.front().floor_z > features.back().floor_z;
  add_features(part, std::move(features));
  // A deep pocket within a shallow one begins on its floor.
  if (several_floors) stock::stack_tops(part, options.tol);
}

}  // namespace clearcut::read
