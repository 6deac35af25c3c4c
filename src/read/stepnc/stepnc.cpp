#include "read/stepnc/stepnc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "features/derived_outlines.h"
#include "features/standing.h"
#include "geometry/contours/boolean.h"
#include "model/entry.h"
#include "model/results/findings.h"
#include "model/results/nothing_to_machine.h"
#include "read/stepnc/materials.h"
#include "read/stepnc/operation.h"
#include "read/stepnc/reader.h"
#include "read/stepnc/toolpaths.h"

namespace clearcut::read::stepnc {
namespace {

/// As the file calls it, else its kind and number.
std::string name_of_feature(const Node& feature) {
  try {
    const std::string name = feature.text(0);
    return name.empty() ? feature.label() : name;
  } catch (const InputError&) {
    return feature.label();  // its name is no text
  }
}

}  // namespace

Part Reader::read(int number) {
  program_ = read_program(context_, number);
  tell_context();
  doubt_several_setups(number);
  part_.name = program_.name;
  part_.source_file = context_.file.name;
  part_.clearance_z = read_clearance(program_, context_);
  part_.stock = read_stock(program_, context_);
  draft_features();
  choose_depth_reading();
  if (!part_.stock) derive_stock();
  part_.keep_outs = read_keep_outs(program_, part_.stock, context_);
  check_clearance();
  make_features();
  const Tools tools(context_, tool_uses());
  part_.tools = tools.list();
  make_workingsteps(tools);
  tell_what_is_read();
  check_holes();
  check_through_ends();
  check_rounded_bottoms();
  check_undercuts();
  check_members();
  check_fillets();
  drop_unused_features();
  set_tops(number);
  drop_finished_steps();
  context_.flush();
  name_what_is_not_used(start_of_program(), context_);
  part_.diagnostics = context_.diagnostics;
  return std::move(part_);
}

/// Reads the feature of every workingstep once; what fails is remembered for its workingsteps.
void Reader::draft_features() {
  const Members members(context_, program_.chosen().turn);
  for (const OrderedStep& ordered : program_.steps) {
    const Node& step = ordered.node;
    const auto feature = step.sound_ref(2);
    if (!feature || drafts_of_.count(feature->id()) || bad_features_.count(feature->id())) continue;
    try {
      draft_members(*feature, members.of(*feature));
    } catch (const InputError& error) {
      bad_features_.emplace(feature->id(), error);
    }
  }
}

/// Members that cannot be read are left out, unless none can.
void Reader::draft_members(const Node& feature, const std::vector<Member>& members) {
  std::vector<std::size_t> drafts;
  std::vector<InputError> errors;
  for (const Member& member : members) {
    try {
      drafts.push_back(draft_index(member));
    } catch (const InputError& error) {
      errors.push_back(error);
      context_.said(member.feature);
    }
  }
  if (drafts.empty()) throw errors.front();
  for (const InputError& error : errors)
    say_not_machined(context_.diagnostics, context_.file.place(feature.line()), name_of_feature(feature),
                     "a part of " + feature.label() + " is left out: " + within_file(error));
  drafts_of_[feature.id()] = std::move(drafts);
}

/// Regions lie on the raw piece's top.
Draft Reader::laid_on_blank(Draft draft) const {
  if (!draft.below_blank) return draft;
  if (!part_.stock)
    draft.node.fail(
        "its depth is below the raw piece's surface; give the WORKPIECE a BLOCK as its raw piece");
  draft.placement_z = part_.stock->z_top;
  return draft;
}

/// The same feature in the same place, alone and as the element of a compound, is one.
std::size_t Reader::draft_index(const Member& member) {
  const auto same = drafts_by_entity_.equal_range(member.feature.id());
  for (auto it = same.first; it != same.second; ++it) {
    const Frame& there = drafts_[it->second].placement;
    if (there.origin == member.placement.origin && there.x == member.placement.x) return it->second;
  }
  drafts_.push_back(laid_on_blank(draft_feature(member, context_)));
  drafts_by_entity_.emplace(member.feature.id(), drafts_.size() - 1);
  return drafts_.size() - 1;
}

double Reader::floor_of(const Draft& draft) const {
  if (draft.below_blank) return draft.placement_z - *draft.below_blank;
  return (absolute_depths_ ? 0.0 : draft.placement_z) + draft.depth_z + draft.raised_floor;
}

/// By the standard a depth is relative to its feature. Files whose floors then lie below the stock, and
/// inside it when read as absolute z, were written the other way.
void Reader::choose_depth_reading() {
  if (!part_.stock) return;
  const Stock& stock = *part_.stock;
  std::vector<const Draft*> below;
  bool absolute_fits = true;
  for (const Draft& draft : drafts_) {
    if (draft.below_blank) continue;
    if (!draft.through && draft.placement_z + draft.depth_z < stock.z_bottom - kLevel)
      below.push_back(&draft);
    absolute_fits = absolute_fits && draft.depth_z < stock.z_top && draft.depth_z > stock.z_bottom - kLevel &&
                    draft.depth_z < draft.placement_z + kLevel;
  }
  if (below.empty()) return;
  if (!absolute_fits) {
    for (const Draft* draft : below) context_.warn("its floor lies below the stock", draft->node);
    return;
  }
  absolute_depths_ = true;
  const Draft& example = *below.front();
  context_.diagnostics.warn(
      context_.file.name,
      "read by the standard (relative to the feature) the floors of " + std::to_string(below.size()) +
          " of " + std::to_string(drafts_.size()) + " features would lie below the stock (" + example.name +
          " at z " + trimmed(example.placement_z + example.depth_z, 3) + ", stock down to " +
          trimmed(stock.z_bottom, 3) +
          "); the depths of the whole file are taken as absolute z, and tops from what is cut before");
}

/// Where no bounding geometry is given but a face with its extent is, the faces and features show the stock.
void Reader::derive_stock() {
  const auto plan = plan_of_drafts(drafts_);
  if (!plan) {
    context_.diagnostics.note(
        context_.file.name,
        "no bounding geometry of the workpiece; the material is taken as solid around the features");
    return;
  }
  Stock stock{*plan, kEverywhere, -kEverywhere};
  for (const Draft& draft : drafts_) {
    stock.z_bottom = std::min(stock.z_bottom, floor_of(draft));
    stock.z_top = std::max(stock.z_top, draft.placement_z);
  }
  if (!(stock.z_top > stock.z_bottom)) return;
  part_.stock = stock;
  context_.diagnostics.note(
      context_.file.name,
      "no bounding geometry of the workpiece; the box around its features is taken as the stock: " +
          trimmed(plan->width(), 3) + " x " + trimmed(plan->height(), 3) + ", z " +
          trimmed(stock.z_bottom, 3) + " to " + trimmed(stock.z_top, 3));
}

void Reader::check_clearance() {
  if (!part_.stock || !part_.clearance_z || *part_.clearance_z > part_.stock->z_top) return;
  context_.diagnostics.warn(context_.file.name,
                            "the security plane (z " + trimmed(*part_.clearance_z, 3) +
                                ") is not above the stock; 10 mm above the stock is used");
  part_.clearance_z.reset();
}

std::string Reader::unique_name(const Draft& draft) {
  std::string base = draft.name;
  if (base.empty()) base = std::string(name_of(draft.kind)) + " #" + std::to_string(draft.node.id());
  return unique_name(base);
}

std::string Reader::unique_name(const std::string& base) {
  std::string name = base;
  while (!names_.insert(name).second) name = base + " (" + std::to_string(1 + ++copies_[base]) + ")";
  return name;
}

void Reader::make_features() {
  features_of_draft_.assign(drafts_.size(), {});
  fillets_in_plan_ = fillets_are_in_plan();
  // Edges last: they lie between other features.
  std::vector<std::size_t> order(drafts_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return !drafts_[i].edge; });
  for (const std::size_t i : order) {
    try {
      if (drafts_[i].edge)
        make_chamfer(i);
      else
        make_feature(i);
    } catch (const InputError& error) {
      bad_drafts_.emplace(i, error);
      context_.said(drafts_[i].node);
    }
  }
  for (const auto& [feature, drafts] : drafts_of_) report_left_out(drafts);
}

/// Members that nothing can be made of, of a feature of which the rest is made.
void Reader::report_left_out(const std::vector<std::size_t>& drafts) {
  const auto is_bad = [&](std::size_t draft) { return bad_drafts_.count(draft) > 0; };
  if (std::all_of(drafts.begin(), drafts.end(), is_bad)) return;
  for (const std::size_t draft : drafts)
    if (is_bad(draft))
      say_not_machined(context_.diagnostics, context_.file.place(drafts_[draft].node.line()),
                       name_of_feature(drafts_[draft].node),
                       "a part is left out: " + within_file(bad_drafts_.at(draft)));
}

/// z of the floors of the zones of a feature: the tops of bosses that end below its own top, from above, and its floor.
std::vector<double> Reader::zone_floors(const Draft& draft, double top, double floor) {
  // Where depths are absolute a feature's placement lies at its first layer, not at its top.
  const double full = absolute_depths_ ? draft.placement_z : top;
  std::vector<double> floors;
  for (std::size_t i = 0; i < draft.bosses.size(); ++i) {
    const double z = boss_top(draft, i);
    if (z >= full - context_.tol.join_gap) continue;
    if (z <= floor + kLevel)
      context_.warn("a boss ends at or below its floor and does not stand (z " + trimmed(z, 3) + ")",
                    draft.node);
    else
      floors.push_back(z);
  }
  floors.push_back(floor);
  std::sort(floors.begin(), floors.end(), [](double a, double b) { return a > b; });
  floors.erase(std::unique(floors.begin(), floors.end(), [](double a, double b) { return a - b < kLevel; }),
               floors.end());
  floors.back() = floor;
  return floors;
}

/// Of each zone, at its top: without the bosses that stand in it. Drafted walls have come nearer by then.
std::vector<FeatureRegions> Reader::zone_regions(const Draft& draft, double top,
                                                 const std::vector<double>& floors) {
  const auto stands_over = [&](std::size_t boss, double z) { return boss_top(draft, boss) > z + kLevel; };
  Draft zone = draft;
  const auto keep_bosses = [&](const auto& wanted) {
    zone.bosses.clear();
    zone.boss_tops.clear();
    for (std::size_t i = 0; i < draft.bosses.size(); ++i) {
      if (!wanted(i)) continue;
      zone.bosses.push_back(draft.bosses[i]);
      zone.boss_tops.push_back(draft.boss_tops[i]);
    }
  };
  std::vector<FeatureRegions> regions;
  double above = top;
  for (const double floor : floors) {
    if (regions.empty() || draft.wall_slope.radians() == 0) {
      keep_bosses([&](std::size_t boss) { return stands_over(boss, floor); });
      regions.push_back(feature_regions(zone, part_.stock, context_));
    } else {
      FeatureRegions next = regions.back();
      const double drop = above - regions_top_;
      next.target = features::at_depth(next.target, draft.wall_slope, drop, context_.tol);
      next.allowed = features::at_depth(next.allowed, draft.wall_slope, drop, context_.tol);
      for (std::size_t i = 0; i < draft.bosses.size(); ++i) {
        if (!stands_over(i, floor) || stands_over(i, above)) continue;
        Loop boss = draft.bosses[i];
        if (signed_area(boss) < 0) boss = reversed(boss);
        next.target = subtract(next.target, {Region::from_valid_loops(boss, {})}, context_.tol);
        next.allowed = subtract(next.allowed, {Region::from_valid_loops(boss, {})}, context_.tol);
      }
      regions.push_back(std::move(next));
    }
    regions_top_ = above;
    above = floor;
  }
  return regions;
}

void Reader::make_feature(std::size_t index) {
  const Draft& draft = drafts_[index];
  Feature feature;
  feature.kind = draft.kind;
  feature.source = "#" + std::to_string(draft.node.id());
  feature.floor_z = floor_of(draft);
  feature.top_z = absolute_depths_ ? part_.stock->z_top : draft.placement_z;
  if (draft.groove && (draft.groove->sides || feature.floor_z >= feature.top_z - 1e-9)) {
    features_of_draft_[index].push_back(make_groove(index));
    return;
  }
  if (feature.floor_z >= feature.top_z - 1e-9)
    draft.node.fail("its depth plane (z " + trimmed(feature.floor_z, 3) + ") is not below its top (z " +
                    trimmed(feature.top_z, 3) + "); give a depth below zero");
  feature.wall_slope = draft.wall_slope;
  feature.hole_diameter = draft.hole_diameter;
  const std::vector<double> floors = zone_floors(draft, feature.top_z, feature.floor_z);
  std::vector<FeatureRegions> regions = zone_regions(draft, feature.top_z, floors);
  const std::string name = unique_name(draft);
  for (std::size_t zone = 0; zone < floors.size(); ++zone) {
    const bool lowest = zone + 1 == floors.size();
    feature.floor_z = floors[zone];
    feature.target = std::move(regions[zone].target);
    feature.allowed = std::move(regions[zone].allowed);
    feature.through = lowest && draft.through;
    const bool has_fillet = draft.floor_fillet && !fillets_in_plan_ && draft.wall_slope.radians() == 0;
    feature.floor_fillet = lowest && has_fillet ? draft.floor_fillet->size : 0;
    feature.name = lowest ? name : unique_name(name + " above z " + trimmed(floors[zone], 3));
    features_of_draft_[index].push_back(static_cast<int>(part_.features.size()));
    part_.features.push_back(feature);
    feature.top_z = feature.floor_z;
  }
}

std::string Reader::within_file(const InputError& error) const {
  std::string reason = error.what();
  const std::string prefix = context_.file.name + ":";
  if (reason.rfind(prefix, 0) == 0) reason.replace(0, prefix.size(), "line ");
  return reason;
}

void Reader::leave_out(const Node& step, const InputError& error) {
  context_.said(step);
  if (!first_error_) first_error_ = error;
  const auto feature = step.sound_ref(2);
  if (feature) left_out_.insert(feature->id());
  const std::string own = step.text(0).empty() ? "workingstep #" + std::to_string(step.id()) : step.text(0);
  say_not_machined(context_.diagnostics, context_.file.place(step.line()),
                   feature ? name_of_feature(*feature) : own,
                   "workingstep #" + std::to_string(step.id()) + " '" + step.text(0) +
                       "' is left out: " + within_file(error));
}

void Reader::tell_stops_after_the_last(const std::vector<ProgramStop>& stops) {
  if (stops.empty() || part_.workplan.empty()) return;
  context_.diagnostics.note(
      context_.file.name,
      "stops and messages after the last workingstep that is machined are not in the program, "
      "which ends there");
}

void Reader::make_workingsteps(const Tools& tools) {
  std::vector<ProgramStop> stops;  // of steps that were left out
  for (const OrderedStep& step : program_.steps) {
    const std::size_t before = part_.workplan.size();
    stops.insert(stops.end(), step.stops.begin(), step.stops.end());
    try {
      make_workingstep(step.node, tools);
    } catch (const InputError& error) {
      leave_out(step.node, error);
    }
    if (part_.workplan.size() == before) continue;
    part_.workplan[before].stops = std::move(stops);
    stops.clear();
  }
  tell_stops_after_the_last(stops);
  if (!part_.workplan.empty()) return;
  std::string why = first_error_->what();
  if (program_.steps.size() > 1)
    why += " (and none of the other " + std::to_string(program_.steps.size() - 1) +
           " workingsteps can be machined)";
  throw NothingToMachine("", why, context_.diagnostics);
}

/// What bears on a plan only where it comes near a limit, so that whoever compares the file sees it: sizes of tools, planes of retracts.
void Reader::tell_what_is_read() {
  std::set<int> tools;
  std::map<std::string, std::string> planes;  // by height, of which operations
  for (const Workingstep& step : part_.workplan) {
    tools.insert(step.operation.tool);
    if (!step.operation.retract_z) continue;
    const double over = *step.operation.retract_z - feature_of(step).top_z;
    std::string& of = planes[trimmed(over, 3)];
    if (of.find(step.operation.source) == std::string::npos)
      of += (of.empty() ? "" : ", ") + step.operation.source;
  }
  std::string text;
  for (const int index : tools) {
    const Tool& tool = part_.tools[static_cast<std::size_t>(index)];
    text += (text.empty() ? "" : "; ") + ("T" + std::to_string(tool.number)) + " " + name_of(tool.kind) +
            " " + trimmed(tool.diameter, 4) + " mm, " + std::to_string(tool.teeth) + " teeth";
    if (tool.flute_length) text += ", edges " + trimmed(*tool.flute_length, 3) + " mm";
    if (tool.tip_angle) text += ", point " + trimmed(tool.tip_angle->degrees(), 3) + " deg";
  }
  context_.diagnostics.note(context_.file.name, "tools as read: " + text);
  text.clear();
  for (const auto& [over, of] : planes) text += (text.empty() ? "" : "; ") + over + " (" + of + ")";
  if (!text.empty())
    context_.diagnostics.note(context_.file.name, "retract planes as read, mm over the features: " + text);
  tell_of_entries();
  take_material();
}

namespace {

/// " 2 mm 3.4 deg" of a way into or out of the material.
std::string shown_way(const std::optional<double>& size, const std::optional<Radians>& angle) {
  std::string text;
  if (size) text += " " + trimmed(*size, 4) + " mm";
  if (angle) text += " " + trimmed(angle->degrees(), 4) + " deg";
  return text;
}

}  // namespace

/// Entries and leads bear on a program only where the cutter goes down in material, and along walls.
void Reader::tell_of_entries() {
  std::map<std::string, std::string> ways;  // of which operations
  const auto add = [&](const std::string& way, const Operation& operation) {
    std::string& of = ways[way];
    if (of.find(operation.source) == std::string::npos) of += (of.empty() ? "" : ", ") + operation.source;
  };
  for (const Workingstep& step : part_.workplan) {
    const Operation& operation = step.operation;
    if (operation.entry)
      add(name_of(*operation.entry) + shown_way(operation.entry_size, operation.entry_angle), operation);
    if (operation.lead || operation.lead_angle)
      add("lead" + shown_way(operation.lead, operation.lead_angle), operation);
  }
  std::string text;
  for (const auto& [way, of] : ways) text += (text.empty() ? "" : "; ") + way + " (" + of + ")";
  if (!text.empty()) context_.diagnostics.note(context_.file.name, "entries and leads as read: " + text);
}

/// Where an operation states no feed or no speed, those for the workpiece's material count, unless the user states another.
void Reader::take_material() {
  if (!program_.workpiece || program_.workpiece->unset(1)) return;
  const std::string stated = program_.workpiece->shown(1);
  const std::string material = recognised_material(stated);
  std::string of;
  for (const Workingstep& step : part_.workplan) {
    const CuttingData& cutting = step.operation.cutting;
    if ((cutting.feed && cutting.spindle_rpm) || of.find(step.operation.source) != std::string::npos)
      continue;
    of += (of.empty() ? "" : ", ") + step.operation.source;
  }
  if (of.empty()) return;
  if (material.empty()) {
    context_.note("no feed or no speed is stated for " + of +
                      "; none of the materials of --material is recognised in " + stated +
                      "; choose one, or give both",
                  *program_.workpiece);
    return;
  }
  part_.material = material;
  const Node entity = program_.workpiece->needed_ref(1, "material");
  for (std::size_t i = 0; i < 2; ++i) entity.use(i);
  context_.note("no feed or no speed is stated for " + of + "; without --material they are those for " +
                    material + ", by " + stated + " (line " + std::to_string(entity.line()) + ")",
                *program_.workpiece);
}

/// Of a pattern or compound: what could be made of it.
std::vector<std::size_t> Reader::sound_drafts(const Node& feature) const {
  const auto bad = bad_features_.find(feature.id());
  if (bad != bad_features_.end()) throw bad->second;
  const std::vector<std::size_t>& all = drafts_of_.at(feature.id());
  std::vector<std::size_t> sound;
  for (const std::size_t draft : all)
    if (!bad_drafts_.count(draft)) sound.push_back(draft);
  if (sound.empty()) throw bad_drafts_.at(all.front());
  return sound;
}

void Reader::make_workingstep(const Node& step, const Tools& tools) {
  const Node feature = step.needed_ref(2, "feature");
  const std::vector<std::size_t> drafts = sound_drafts(feature);
  const Node node = step.needed_ref(3, "operation");
  StatedOperation stated = read_operation(node, tools, context_);
  Operation& operation = stated.operation;
  const Tool& tool = part_.tools[static_cast<std::size_t>(operation.tool)];
  std::vector<const Draft*> parts;
  for (const std::size_t draft : drafts) parts.push_back(&drafts_[draft]);
  const std::vector<std::size_t> chosen = parts_for(parts, node, operation, tool);
  if (operation.retract_z) {
    double top = -kEverywhere;
    for (const std::size_t draft : drafts) top = std::max(top, top_of_draft(draft));
    *operation.retract_z += top;
  }
  if (operation.feed_direction) {
    const Vec3 along = program_.chosen().turn.x;
    *operation.feed_direction = *operation.feed_direction + Radians::of(base::atan2(along.y, along.x));
  }
  std::vector<std::size_t> of;
  for (const std::size_t i : chosen) of.push_back(drafts[i]);
  for (const std::size_t draft : of) {
    check_part(draft, step, stated);
    if (!drafts_[draft].below_blank) refuse_listed(node);  // free-form milling is that of level regions
  }
  use_overcut(node, of);
  std::optional<StatedPath> path = stated_path(feature, node, operation, of);
  for (const std::size_t draft : of) {
    for (const int index : features_for(draft, stated, node)) {
      steps_of_draft_[draft].push_back(part_.workplan.size());
      part_.workplan.push_back({step.text(0), "#" + std::to_string(step.id()), index, operation});
      part_.workplan.back().stated_path = path;
      if (path) path->moves.clear();  // the one path makes all parts of the feature
    }
  }
}

namespace {

/// Where the tool of this radius cuts along the path, in plan: on open sides its centre may lie beside the feature.
Box cut_box(const StatedPath& path, double radius) {
  Box cut;
  for (const StatedMove& move : path.moves)
    if (!is_rapid(move.kind)) cut.add(move.path.box().grown(radius));
  return cut;
}

}  // namespace

/// What the operation states in its_toolpath. One that cannot be followed leaves its workingstep out where the strategy is EXPLICIT; else it
/// is named.
std::optional<StatedPath> Reader::stated_path(const Node& feature, const Node& node,
                                              const Operation& operation,
                                              const std::vector<std::size_t>& drafts) {
  if (node.unset(0)) return std::nullopt;
  // Nothing that drills has a strategy that could say so.
  const bool is_explicit = operation.strategy_hint == "explicit_strategy" || goes_straight_down(operation);
  ToolpathSetting setting;
  setting.tool = part_.tools[static_cast<std::size_t>(operation.tool)];
  setting.placement = is_simple_feature(feature)
                          ? drafts_[drafts.front()].placement
                          : composed(program_.chosen().turn, frame_of(feature.sound_ref(3)));
  try {
    std::optional<StatedPath> path = read_toolpath(node, setting, context_);
    Box area;
    for (const std::size_t draft : drafts) area.add(box(feature_of_draft(draft).target));
    if (path && !cut_box(*path, setting.tool.radius()).overlaps(area)) {
      setting.placement = program_.chosen().turn;
      const auto in_workpiece = read_toolpath(node, setting, context_);
      if (cut_box(*in_workpiece, setting.tool.radius()).overlaps(area)) {
        context_.warn("its toolpath lies beside its feature; it is taken in the coordinates of the workpiece",
                      node);
        path = in_workpiece;
      }
    }
    if (path) path->is_explicit = is_explicit;
    return path;
  } catch (const InputError& error) {
    if (is_explicit) throw;
    if (const auto list = node.sound_ref(0)) context_.said(*list);
    context_.diagnostics.doubt(context_.file.place(node.line()), kNotFollowed,
                               node.label() + ": its toolpath is not followed: " + within_file(error));
    return std::nullopt;
  }
}

void Reader::check_part(std::size_t index, const Node& step, const StatedOperation& stated) const {
  const Draft& draft = drafts_[index];
  check_form_cutter(index, stated, step);
  const bool is_countersink = stated.hole == HoleKind::kCountersunk && draft.node.is("ROUND_HOLE");
  if (goes_straight_down(stated.operation) && !draft.hole_diameter && !is_countersink)
    step.fail(draft.node.is("ROUND_HOLE") ? "a tapered hole is milled, not drilled; give a milling operation"
                                          : "drilling is for round holes; correct the operation");
}

/// Steps whose features are cut away before: two drills that go as deep in one hole.
void Reader::drop_finished_steps() {
  const auto is_same_hole = [&](const Workingstep& before, const Workingstep& step) {
    const Feature &done = feature_of(before), &asked = feature_of(step);
    return before.operation.tool == step.operation.tool && makes_holes(tool_of(part_, step)) &&
           distance(box(done.target).min, box(asked.target).min) < kSamePlaceMm &&
           distance(box(done.target).max, box(asked.target).max) < kSamePlaceMm &&
           done.floor_z <= asked.floor_z + kSamePlaceMm;
  };
  std::vector<Workingstep> left;
  std::vector<ProgramStop> stops;  // of steps that are dropped
  for (Workingstep& step : part_.workplan) {
    stops.insert(stops.end(), step.stops.begin(), step.stops.end());
    const Feature& feature = feature_of(step);
    const bool is_made = std::any_of(left.begin(), left.end(),
                                     [&](const Workingstep& before) { return is_same_hole(before, step); });
    // What the point of the drill before has left, the same drill does not take.
    const double least = is_made ? point_length(tool_of(part_, step)) + kSamePlaceMm : kSamePlaceMm;
    if (feature.top_z - feature.floor_z > least) {
      left.push_back(std::move(step));
      left.back().stops = std::move(stops);
      stops.clear();
      continue;
    }
    context_.diagnostics.note(context_.file.name,
                              "workingstep " + step.source + " '" + step.name +
                                  "' has nothing left to cut: what comes before it goes as deep in " +
                                  feature.name);
  }
  if (left.empty()) return;
  tell_stops_after_the_last(stops);
  part_.workplan = std::move(left);
  drop_unused_features();
}

/// What the whole reading knows of the program.
void Reader::tell_context() {
  if (program_.workpiece) context_.workpiece = program_.workpiece->id();
  for (const OrderedStep& step : program_.steps)
    if (const auto operation = step.node.sound_ref(3)) context_.operations.insert(operation->id());
  const auto& chosen = program_.chosen().node;
  for (const ProgramSetup& setup : program_.setups)
    if (setup.node && chosen && setup.node->id() != chosen->id()) context_.said(*setup.node);
}

/// Adds an open condition where several set-ups are planned as if they were one.
void Reader::doubt_several_setups(int number) {
  if (number > 0 || program_.setups.size() < 2) return;
  context_.diagnostics.doubt(
      context_.file.name, kNotFollowed,
      "its workingsteps are cut in " + std::to_string(program_.setups.size()) +
          " set-ups, and are taken here as if the workpiece lay as in the first of them");
}

Node Reader::start_of_program() const {
  for (const char* keyword : {"PROJECT", "WORKPLAN"}) {
    const std::vector<Node> found = nodes_called(context_.file, keyword);
    if (!found.empty()) return found.front();
  }
  return program_.steps.front().node;
}

/// Features whose workingsteps were all left out (and reported) are no part of the job.
void Reader::drop_unused_features() {
  std::vector<int> renumbered(part_.features.size(), -1);
  std::vector<std::size_t> order;
  for (const Workingstep& step : part_.workplan) {
    const auto index = static_cast<std::size_t>(step.feature);
    if (renumbered[index] < 0) order.push_back(index);
    renumbered[index] = 0;
  }
  if (!has_own_holes_) std::sort(order.begin(), order.end());
  std::vector<Feature> used;
  for (const std::size_t index : order) {
    renumbered[index] = static_cast<int>(used.size());
    used.push_back(std::move(part_.features[index]));
  }
  part_.features = std::move(used);
  for (Workingstep& step : part_.workplan) step.feature = renumbered[static_cast<std::size_t>(step.feature)];
}

/// A later set-up is planned on what the earlier ones have left, which the file alone does not tell: tops from stacking
/// on the whole block are the highest possible ones.
void Reader::set_tops_on_carried_stock() {
  const std::vector<double> tops = features::stacked_tops(part_, context_.tol);
  for (std::size_t i = 0; i < tops.size(); ++i) {
    Feature& feature = part_.features[i];
    const double declared = std::exchange(feature.top_z, tops[i]);
    if (std::abs(tops[i] - declared) <= context_.tol.join_gap) continue;
    context_.diagnostics.note(
        feature.name + " (" + feature.source + ")",
        "its top is given as z " + trimmed(declared, 3) +
            "; where earlier set-ups have left material above, it is cut from up to z " +
            trimmed(tops[i], 3));
  }
}

/// Tops from stacking; retract planes follow, and stay below the security plane.
void Reader::set_tops(int setup) {
  if (absolute_depths_) {
    const std::vector<double> tops = features::stacked_tops(part_, context_.tol);
    for (Workingstep& step : part_.workplan)
      if (step.operation.retract_z)
        *step.operation.retract_z += tops[static_cast<std::size_t>(step.feature)] - feature_of(step).top_z;
    for (std::size_t i = 0; i < tops.size(); ++i) part_.features[i].top_z = tops[i];
  } else if (setup > 1) {
    set_tops_on_carried_stock();
  } else {
    features::stack_tops(part_, context_.tol);
    context_.diagnostics.append(part_.diagnostics);
  }
  for (Workingstep& step : part_.workplan)
    if (part_.clearance_z && step.operation.retract_z)
      step.operation.retract_z = std::min(*step.operation.retract_z, *part_.clearance_z);
}

namespace {

/// The file with its unit of length; messages about it are added to `diagnostics`.
P21File parsed(std::string_view text, const std::string& file_name, FileUnits& units,
               Diagnostics& diagnostics) {
  P21File file = parse_part21(text, file_name);
  check_schema(file);
  units = file_units(file, diagnostics);
  file.mm_per_length = units.mm_per_length;
  return file;
}

SetupPlace place_of(const ProgramSetup& setup) {
  const Frame& turn = setup.turn;
  SetupPlace place;
  place.turn = {
      {{turn.x.x, turn.y.x, turn.z.x}, {turn.x.y, turn.y.y, turn.z.y}, {turn.x.z, turn.y.z, turn.z.z}}};
  return place;
}

}  // namespace

Part read_setup(std::string_view text, const std::string& file_name, const Tolerances& tol, int number,
                SetupPlace& place) {
  FileUnits units;
  Diagnostics diagnostics;
  const P21File file = parsed(text, file_name, units, diagnostics);
  Reader reader(file, tol, units);
  reader.diagnostics().append(diagnostics);
  Part part = reader.read(number);
  place = place_of(reader.program().chosen());
  const std::size_t count = reader.program().setups.size();
  if (number > 0 && count > 1)
    part.name += ", set-up " + std::to_string(number) + " of " + std::to_string(count);
  return part;
}

Part read_stepnc(std::string_view text, const std::string& file_name, const Tolerances& tol) {
  SetupPlace place;
  return read_setup(text, file_name, tol, 0, place);
}

int count_setups(std::string_view text, const std::string& file_name) {
  FileUnits units;
  Diagnostics diagnostics;
  const P21File file = parsed(text, file_name, units, diagnostics);
  Context context(file, {});
  return static_cast<int>(read_program(context, 0).setups.size());
}

}  // namespace clearcut::read::stepnc
