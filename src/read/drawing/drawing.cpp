#include "read/drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "features/derived_outlines.h"
#include "features/standing.h"
#include "geometry/contours/boolean.h"
#include "read/common/text.h"
#include "read/drawing/drawn_features.h"
#include "read/drawing/outline_roles.h"
#include "read/drawing/overlaps.h"
#include "read/repair/meetings.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

/// Options take precedence over the file.
double depth_of(const DrawnGroup& group, const ReadOptions& options, Diagnostics& diagnostics) {
  std::optional<double> depth = options.depth ? options.depth : group.depth;
  if (group.depth && std::abs(*depth - *group.depth) > kSamePlaceMm)
    diagnostics.warn(group.where, "it says a depth of " + trimmed(*group.depth, 4) + " mm, and --depth " +
                                      trimmed(*depth, 4) + " goes before it: cut " + trimmed(*depth, 4) +
                                      " mm deep");
  if (!depth && options.depth_if_missing) {
    depth = options.depth_if_missing;
    diagnostics.warn(group.where, "no depth given: " + trimmed(*depth, 4) + " mm assumed");
  }
  if (!depth) {
    throw InputError(
        group.where,
        "no depth given; add --depth 5 for all, or --op pocket_d5:LAYER, or name the layer like POCKET_D5");
  }
  return checked_depth(*depth, group.where);
}

RepairOptions repair_options(const DrawnGroup& group, const ReadOptions& options) {
  RepairOptions out;
  out.tol = options.tol;
  out.where = group.where;
  out.open_curves = options.overview ? OpenCurves::kSkip : options.open_curves.value_or(OpenCurves::kRefuse);
  out.may_be_empty = out.open_curves == OpenCurves::kSkip;
  out.find_arcs = options.find_arcs.value_or(true);
  out.has_pens = group.has_pens;
  return out;
}

Feature feature_of(const DrawnGroup& group, Region region, double depth, const ReadOptions& options) {
  Feature feature = blank_feature(group, depth, options);
  feature.target = {std::move(region)};
  feature.allowed = feature.target;
  if (group.role == LayerRole::kHole) make_hole(feature, group, options.tol);
  return feature;
}

Regions islands_of(std::vector<DrawnGroup>& groups, const ReadOptions& options, Diagnostics& diagnostics) {
  Regions islands;
  for (DrawnGroup& group : groups) {
    // A thread's boss stays standing as an island does, and is a feature besides.
    if ((group.role != LayerRole::kIsland && !is_external_thread(group)) || group.curves.empty()) continue;
    std::vector<RawCurve> curves = group.curves;
    const Regions more = repair(std::move(curves), repair_options(group, options), diagnostics);
    islands = islands.empty() ? more : unite(islands, more, options.tol);
  }
  return islands;
}

/// A profile along one loop, or a line to engrave.
Feature profile_of(const DrawnGroup& group, Path line, ProfileSide side, double depth,
                   const ReadOptions& options) {
  Feature feature = blank_feature(group, depth, options);
  feature.kind = side == ProfileSide::kOutside  ? FeatureKind::kOutsideProfile
                 : side == ProfileSide::kInside ? FeatureKind::kInsideProfile
                                                : FeatureKind::kEngraving;
  ProfileCut cut;
  cut.side = side;
  cut.closed = line.front().from == line.back().to;
  if (side != ProfileSide::kOn && signed_area(line) < 0) line = reversed(line);
  cut.line = std::move(line);
  feature.through = side != ProfileSide::kOn;
  if (feature.through) cut.beyond = options.solid.breakthrough.value_or(0);
  feature.floor_z -= cut.beyond;
  features::follow(feature, std::move(cut), options.tol);
  return feature;
}

/// The islands that options name by their numbers.
Regions named_islands(const std::vector<ShapedGroup>& shaped, const Tolerances& tol) {
  Regions islands;
  for (const ShapedGroup& one : shaped)
    if (one.group.role == LayerRole::kIsland) islands = unite(islands, one.regions, tol);
  return islands;
}

/// Along the inside of outlines, along the outside of those in them.
void add_inside_profiles(const ShapedGroup& shaped, double depth, const ReadOptions& options,
                         std::vector<Feature>& out) {
  for (const Region& region : shaped.regions) {
    for (const Loop& island : region.islands())
      out.push_back(profile_of(shaped.group, island, ProfileSide::kOutside, depth, options));
    out.push_back(profile_of(shaped.group, region.outer(), ProfileSide::kInside, depth, options));
  }
}

/// The outlines of all layers of profiles are nested: an edge of a part, a cut-out in the part, a part in the
/// cut-out.
void add_profiles(const std::vector<ShapedGroup>& groups, const ReadOptions& options,
                  Diagnostics& diagnostics, std::vector<Feature>& out) {
  std::vector<Loop> loops;
  std::vector<const DrawnGroup*> owners;
  std::vector<double> depths;
  for (const ShapedGroup& shaped : groups) {
    if (shaped.group.role != LayerRole::kProfile || shaped.regions.empty()) continue;
    const double depth = depth_of(shaped.group, options, diagnostics);
    for (Loop& loop : loops_of(shaped.regions)) loops.push_back(std::move(loop));
    owners.resize(loops.size(), &shaped.group);
    depths.resize(loops.size(), depth);
  }
  const auto about = loops_about(loops);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const ProfileSide side = about[i].size() % 2 == 0 ? ProfileSide::kOutside : ProfileSide::kInside;
    out.push_back(profile_of(*owners[i], loops[i], side, depths[i], options));
  }
}

void add_group_features(ShapedGroup& shaped, const ReadOptions& options, Diagnostics& diagnostics,
                        std::vector<Feature>& out) {
  if (shaped.regions.empty() && shaped.lines.empty()) return;
  if (shaped.group.role == LayerRole::kVCarve) {
    for (Region& region : shaped.regions) out.push_back(carving_of(shaped.group, std::move(region), options));
    return;
  }
  if (shaped.group.role == LayerRole::kChamfer) return add_chamfers(shaped, options, diagnostics, out);
  const bool cone = shaped.group.hole && needs_no_depth(*shaped.group.hole);
  const double depth = cone ? shaped.group.depth.value_or(1) : depth_of(shaped.group, options, diagnostics);
  switch (shaped.group.role) {
    case LayerRole::kInside:
      return add_inside_profiles(shaped, depth, options, out);
    case LayerRole::kEngrave:
      for (Loop& loop : loops_of(shaped.regions)) shaped.lines.push_back(std::move(loop));
      for (const Path& line : shaped.lines)
        out.push_back(profile_of(shaped.group, line, ProfileSide::kOn, depth, options));
      return;
    case LayerRole::kTSlot:
      for (Loop& loop : loops_of(shaped.regions)) shaped.lines.push_back(std::move(loop));
      for (const Path& line : shaped.lines) {
        out.push_back(profile_of(shaped.group, line, ProfileSide::kOn, depth, options));
        out.back().kind = FeatureKind::kTSlot;
      }
      return;
    case LayerRole::kIsolate:
      return out.push_back(isolation_of(shaped, depth, options, diagnostics));
    case LayerRole::kFace:
      for (const Region& one : shaped.regions) out.push_back(face_of(shaped.group, one, depth, options));
      return;
    default:
      for (Region& region : shaped.regions)
        out.push_back(feature_of(shaped.group, std::move(region), depth, options));
  }
}

/// Faces first, then pockets and holes, engraving, edges, and features freeing the part last: inner cut-outs before
/// outer ones.
int turn_of(const Feature& feature) {
  if (feature.kind == FeatureKind::kPlanarFace) return 0;
  if (feature.carving || feature.chamfer || comes_after_pilot(feature)) return 2;
  if (!feature.profile) return 1;
  return feature.profile->side == ProfileSide::kOn ? 2 : 3;
}

double area_within(const Feature& feature) {
  return feature.profile && feature.profile->closed ? std::abs(signed_area(feature.profile->line)) : 0;
}

bool goes_before(const Feature& a, const Feature& b) {
  if (turn_of(a) != turn_of(b)) return turn_of(a) < turn_of(b);
  return turn_of(a) == 3 ? area_within(a) < area_within(b) : a.floor_z > b.floor_z;
}

bool follows_lines(LayerRole role) {
  return role == LayerRole::kEngrave || role == LayerRole::kTSlot;
}

/// Areas of all groups except islands and ignored ones.
std::vector<ShapedGroup> shaped_groups(std::vector<DrawnGroup>& groups, const ReadOptions& options,
                                       Diagnostics& diagnostics) {
  std::vector<ShapedGroup> all;
  for (DrawnGroup& group : groups) {
    if (group.role == LayerRole::kIsland || group.role == LayerRole::kIgnore || group.curves.empty())
      continue;
    ShapedGroup shaped;
    std::vector<RawCurve> curves = std::move(group.curves);
    shaped.group = std::move(group);
    if (follows_lines(shaped.group.role)) {
      shaped.lines = chained_lines(curves, options.tol.join_gap);
    } else {
      RepairOptions how = repair_options(shaped.group, options);
      how.crossing = &shaped.crossing;
      shaped.regions = repair(std::move(curves), how, diagnostics);
    }
    all.push_back(std::move(shaped));
  }
  return all;
}

Vec2 mirrored(Vec2 p) {
  return {-p.x, p.y};
}

/// Left to right; loops keep their sense.
void mirror(std::vector<DrawnGroup>& groups) {
  for (DrawnGroup& group : groups) {
    for (RawCurve& curve : group.curves) {
      for (Edge& edge : curve.edges) {
        edge = {mirrored(edge.from), mirrored(edge.to), mirrored(edge.center),
                static_cast<Turn>(-static_cast<int>(edge.turn))};
      }
      curve.edges = reversed(curve.edges);
    }
  }
}

/// The features of all groups in the groups' order, those of profiles last.
std::vector<Feature> features_of(std::vector<ShapedGroup>& shaped, const Regions& islands,
                                 const ReadOptions& options, Diagnostics& diagnostics) {
  give_through_depths(shaped, options);
  unite_overlapping_layers(shaped, options, diagnostics);
  let_steps_stand(shaped, options);
  std::vector<Feature> features;
  for (ShapedGroup& one : shaped) {
    const LayerRole role = one.group.role;
    if (role == LayerRole::kStock || role == LayerRole::kIgnore || role == LayerRole::kProfile) continue;
    const bool stands =
        role == LayerRole::kChamfer || role == LayerRole::kIsolate || is_external_thread(one.group);
    if (!islands.empty() && !stands && near_any(islands, one.regions))
      one.regions =
          without_islands(std::move(one.regions), islands, one.group.where, options.tol, diagnostics);
    add_group_features(one, options, diagnostics, features);
  }
  add_profiles(shaped, options, diagnostics, features);
  return features;
}

void ask(const DrawingQuestion& question, DrawingOverview& overview) {
  overview.question = question.text;
  overview.answers = question.answers;
}

/// Adds to the overview a plan's questions about, or refusal of, pockets that remove others.
void question_features(std::vector<ShapedGroup> shaped, const Regions& islands, const ReadOptions& options) {
  if (!options.overview->question.empty()) return;
  Diagnostics said_when_planned;
  try {
    const bool several = shaped.size() > 1;
    const auto features = features_of(shaped, islands, options, said_when_planned);
    if (!several) return;
    if (const auto question = question_of_cut_away(features, options.tol)) ask(*question, *options.overview);
  } catch (const InputError& error) {  // a depth is missing: the depth is asked first
    options.overview->missing = error.what();
  }
}

/// Asks about, or reports, features removed by pockets.
void ask_of_cut_away(Part& part, const std::vector<Feature>& features, const ReadOptions& options) {
  const auto question = question_of_cut_away(features, options.tol);
  if (!question) return;
  if (options.ask_if_unclear) throw InputError(part.source_file, question->text);
  part.diagnostics.warn(part.source_file, question->text);
}

bool have_several_floors(const std::vector<Feature>& features) {
  return std::any_of(features.begin(), features.end(),
                     [&](const Feature& feature) { return feature.floor_z < features.front().floor_z; });
}

/// Adds a plan's question to the overview; without an overview, asks it.
void ask_of_layers(const std::vector<ShapedGroup>& shaped, const ReadOptions& options) {
  const auto question = question_of_layers(shaped, options);
  if (!question) return;
  if (!options.overview) throw InputError(question->where, question->text);
  if (options.overview->question.empty()) ask(*question, *options.overview);
}

/// In the words of the reader, as much as a person reads; "" for none.
std::string what_was_left_out(const Diagnostics& diagnostics) {
  constexpr int kListed = 3;
  std::string all;
  int count = 0;
  for (const Diagnostic& item : diagnostics.items())
    if ((item.severity == Severity::kSkipped || item.condition == kLeftOut) && ++count <= kListed)
      all += (all.empty() ? "" : "; ") + item.what;
  if (count > kListed) all += "; and " + std::to_string(count - kListed) + " more";
  return all.empty() ? "" : " (" + all + ")";
}

std::string nothing_found(const Diagnostics& diagnostics) {
  return "nothing to mill was found" + what_was_left_out(diagnostics) +
         "; draw the pockets as closed curves, or have the cutter follow open lines (--op engrave:'*')";
}

/// Adds a plan's question to the overview if all lines are open.
void question_open_lines(const std::vector<ShapedGroup>& shaped, const Part& part,
                         const ReadOptions& options) {
  const bool nothing = std::all_of(shaped.begin(), shaped.end(), [](const ShapedGroup& one) {
    return one.regions.empty() && one.lines.empty();
  });
  if (nothing && !shaped.empty()) options.overview->question = nothing_found(part.diagnostics);
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

double checked_length(double length, const std::string& what, const std::string& place) {
  if (!(length > 0) || length > kLargestCoordinate) {
    throw InputError(place, "the " + what + " is " + short_number(length) + " mm; it must be above 0");
  }
  return length;
}

double checked_depth(double depth, const std::string& place) {
  checked_length(depth, "depth", place);
  // The checks ignore walls of this height.
  const double least = Tolerances{}.gouge;
  if (depth > least) return depth;
  throw InputError(place, "the depth is " + short_number(depth) + " mm; it must be above " +
                              trimmed(least, 4) + ": is the unit right?");
}

void apply_rules(const std::vector<LayerRule>& rules, const std::string& name, DrawnGroup& group) {
  bool role = false, depth = false, top = false;
  for (const LayerRule& rule : rules) {
    if (!matches(rule.pattern, name)) continue;
    // An edge to be broken remains the edge of its area.
    if (rule.role == LayerRole::kChamfer && group.says_role && group.role != LayerRole::kChamfer) {
      group.broken_edges = rule;
      continue;
    }
    if (rule.role && !role) {
      group.role = *rule.role;
      group.hole = rule.hole;
      group.says_role = role = true;
    }
    if (rule.depth && !depth) group.depth = rule.depth, depth = true;
    if (rule.top && !top) group.top = rule.top, top = true;
    if (rule.width) group.width = rule.width;
    if (!rule.asked) return;
  }
}

void question_size(const std::vector<DrawnGroup>& groups, const std::string& file,
                   const ReadOptions& options) {
  constexpr double kLargest = 2000, kSmallest = 1;  // mm
  if (!options.ask_if_unclear || options.unit || options.scale != 1) return;
  Box all;
  for (const DrawnGroup& group : groups) {
    for (const RawCurve& curve : group.curves) all.add(box(curve.edges));
  }
  if (all.empty()) return;
  const double size = std::max(all.width(), all.height());
  if (!(size > kLargest || size < kSmallest)) return;
  const std::string question =
      "in the unit it names the drawing is " + trimmed(all.width(), 3) + " x " + trimmed(all.height(), 3) +
      " mm, " + (size > kLargest ? "larger than 2 m" : "smaller than 1 mm") +
      "; say which unit it is drawn in (--unit mm, --unit in), or --scale 1 if it is right";
  if (options.overview) {
    options.overview->question = question;
    options.overview->answers = {{"--unit", "mm"}, {"--unit", "inch"}, {"--scale", "1"}};
  } else if (!options.scale_is_right) {
    throw InputError(file, question);
  }
}

void add_features(Part& part, std::vector<Feature> features) {
  std::unordered_set<std::string> taken;
  std::unordered_map<std::string, int> next;  // next number for a name already in use
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
  part.order_free = true;  // the order of drawing is accidental
}

std::string listed(const LeftOut& left_out) {
  std::string text;
  for (const auto& [name, count] : left_out)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + printable(name);
  return text;
}

void report_left_out(Diagnostics& diagnostics, const std::string& file, const LeftOut& left_out,
                     const std::string& what) {
  const std::string text = listed(left_out);
  if (!text.empty()) diagnostics.skip(file, what + " " + text);
}

void add_drawn_features(Part& part, std::vector<DrawnGroup> groups, const ReadOptions& options) {
  if (options.mirror) mirror(groups);
  std::vector<NamedLayer> layers;
  for (const DrawnGroup& group : groups) layers.push_back({group.name, !group.curves.empty()});
  Regions islands = islands_of(groups, options, part.diagnostics);
  std::vector<ShapedGroup> shaped = shaped_groups(groups, options, part.diagnostics);
  assign_outline_roles(shaped, layers, options, part.source_file, part.diagnostics);
  if (const Regions named = named_islands(shaped, options.tol); !named.empty())
    islands = unite(islands, named, options.tol);
  if (options.overview || options.ask_if_unclear) ask_of_layers(shaped, options);
  if (options.overview) {
    question_open_lines(shaped, part, options);
    return question_features(std::move(shaped), islands, options);
  }
  std::vector<Feature> features = features_of(shaped, islands, options, part.diagnostics);
  if (features.empty()) throw InputError(part.source_file, nothing_found(part.diagnostics));
  ask_of_cut_away(part, features, options);
  std::stable_sort(features.begin(), features.end(), goes_before);
  keep_open_features_off_others(features, options.tol);
  set_stock(part, shaped, features, options);
  const bool several_floors = have_several_floors(features);
  add_features(part, std::move(features));
  open_at_stock_edge(part, options.tol);
  // A deep pocket within a shallow one begins on its floor.
  if (several_floors) features::stack_tops(part, options.tol);
}

}  // namespace clearcut::read
