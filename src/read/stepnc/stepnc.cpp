#include "read/stepnc/stepnc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/error.h"
#include "base/text/format.h"
#include "model/results/not_machined.h"
#include "read/stepnc/operation.h"
#include "read/stepnc/parts.h"
#include "read/stepnc/setup.h"
#include "read/stepnc/shapes/regions.h"
#include "stock/stacking.h"

namespace clearcut::read::stepnc {
namespace {

constexpr double kEverywhere = std::numeric_limits<double>::infinity();
constexpr double kLevel = 0.01;  // mm; heights nearer than this are one

class Reader {
 public:
  Reader(const P21File& file, const Tolerances& tol) : context_(file, tol) {}

  Part read() {
    program_ = read_program(context_);
    part_.name = program_.name;
    part_.source_file = context_.file.name;
    part_.clearance_z = read_clearance(program_, context_);
    part_.stock = read_stock(program_, context_);
    draft_features();
    choose_depth_reading();
    if (!part_.stock) derive_stock();
    check_clearance();
    make_features();
    const Tools tools(context_);
    part_.tools = tools.list();
    make_workingsteps(tools);
    drop_unused_features();
    set_tops();
    context_.flush();
    part_.diagnostics = context_.diagnostics;
    return std::move(part_);
  }

 private:
  void draft_features();
  void draft_members(const Node& feature, const std::vector<Member>& members);
  std::size_t draft_index(const Member& member);
  void choose_depth_reading();
  void derive_stock();
  void check_clearance();
  void make_features();
  void make_feature(std::size_t draft);
  void report_left_out(const std::vector<std::size_t>& drafts);
  void make_workingsteps(const Tools& tools);
  void make_workingstep(const Node& step, const Tools& tools);
  std::vector<std::size_t> sound_drafts(const Node& feature) const;
  void check_part(const Draft& draft, const Node& step, const Operation& operation) const;
  void drop_unused_features();
  void set_tops();
  double floor_of(const Draft& draft) const;
  std::string unique_name(const Draft& draft);
  void leave_out(const Node& step, const InputError& error);
  std::string within_file(const InputError& error) const;  ///< its text, for messages that name the file
  Feature& feature_of(const Workingstep& step) {
    return part_.features[static_cast<std::size_t>(step.feature)];
  }
  const Feature& feature_of_draft(std::size_t draft) const {
    return part_.features[static_cast<std::size_t>(feature_of_draft_[draft])];
  }

  Context context_;
  Program program_;
  Part part_;
  std::vector<Draft> drafts_;  // of simple features, in order of first use
  /// Feature entity -> drafts_: one, or the members of a pattern or compound.
  std::map<std::uint64_t, std::vector<std::size_t>> drafts_of_;
  std::multimap<std::uint64_t, std::size_t> drafts_by_entity_;  // simple feature entity -> drafts_
  std::map<std::uint64_t, InputError> bad_features_;
  std::map<std::size_t, InputError> bad_drafts_;
  std::vector<int> feature_of_draft_;  // -> Part::features, -1 when it failed
  std::set<std::string> names_;
  std::map<std::string, int> copies_;  // of a name after the first
  bool absolute_depths_ = false;
  std::optional<InputError> first_error_;
};

/// As the file calls it, else its kind and number.
std::string name_of_feature(const Node& feature) {
  try {
    const std::string name = feature.text(0);
    return name.empty() ? feature.label() : name;
  } catch (const InputError&) {
    return feature.label();  // its name is no text
  }
}

/// Reads the feature of every workingstep once; what fails is remembered for its workingsteps.
void Reader::draft_features() {
  const Members members(context_);
  for (const Node& step : program_.workingsteps) {
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
    }
  }
  if (drafts.empty()) throw errors.front();
  for (const InputError& error : errors)
    say_not_machined(context_.diagnostics, context_.file.place(feature.line()), name_of_feature(feature),
                     "a part of " + feature.label() + " is left out: " + within_file(error));
  drafts_of_[feature.id()] = std::move(drafts);
}

/// The same feature in the same place, alone and as the element of a compound, is one.
std::size_t Reader::draft_index(const Member& member) {
  const auto same = drafts_by_entity_.equal_range(member.feature.id());
  for (auto it = same.first; it != same.second; ++it) {
    const Frame& there = drafts_[it->second].placement;
    if (there.origin == member.placement.origin && there.x == member.placement.x) return it->second;
  }
  drafts_.push_back(draft_feature(member, context_));
  drafts_by_entity_.emplace(member.feature.id(), drafts_.size() - 1);
  return drafts_.size() - 1;
}

double Reader::floor_of(const Draft& draft) const {
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
  std::string name = base;
  while (!names_.insert(name).second) name = base + " (" + std::to_string(1 + ++copies_[base]) + ")";
  return name;
}

void Reader::make_features() {
  feature_of_draft_.assign(drafts_.size(), -1);
  for (std::size_t i = 0; i < drafts_.size(); ++i) {
    try {
      make_feature(i);
    } catch (const InputError& error) {
      bad_drafts_.emplace(i, error);
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

void Reader::make_feature(std::size_t index) {
  const Draft& draft = drafts_[index];
  Feature feature;
  feature.kind = draft.kind;
  feature.source = "#" + std::to_string(draft.node.id());
  feature.floor_z = floor_of(draft);
  feature.top_z = absolute_depths_ ? part_.stock->z_top : draft.placement_z;
  if (feature.floor_z >= feature.top_z - 1e-9)
    draft.node.fail("its depth plane (z " + trimmed(feature.floor_z, 3) + ") is not below its top (z " +
                    trimmed(feature.top_z, 3) + "); give a depth below zero");
  FeatureRegions regions = feature_regions(draft, part_.stock, context_);
  feature.target = std::move(regions.target);
  feature.allowed = std::move(regions.allowed);
  feature.wall_slope = draft.wall_slope;
  feature.hole_diameter = draft.hole_diameter;
  feature.through = draft.through;
  feature.name = unique_name(draft);
  if (draft.raised_floor > 0)
    context_.diagnostics.skip(context_.file.place(draft.node.line()),
                              draft.node.label() + ": its rounded bottom, below z " +
                                  trimmed(feature.floor_z, 3) +
                                  ", cannot be machined yet; the part above it is");
  feature_of_draft_[index] = static_cast<int>(part_.features.size());
  part_.features.push_back(std::move(feature));
}

std::string Reader::within_file(const InputError& error) const {
  std::string reason = error.what();
  const std::string prefix = context_.file.name + ":";
  if (reason.rfind(prefix, 0) == 0) reason.replace(0, prefix.size(), "line ");
  return reason;
}

void Reader::leave_out(const Node& step, const InputError& error) {
  if (!first_error_) first_error_ = error;
  const auto feature = step.sound_ref(2);
  const std::string own = step.text(0).empty() ? "workingstep #" + std::to_string(step.id()) : step.text(0);
  say_not_machined(context_.diagnostics, context_.file.place(step.line()),
                   feature ? name_of_feature(*feature) : own,
                   "workingstep #" + std::to_string(step.id()) + " '" + step.text(0) +
                       "' is left out: " + within_file(error));
}

void Reader::make_workingsteps(const Tools& tools) {
  for (const Node& step : program_.workingsteps) {
    try {
      make_workingstep(step, tools);
    } catch (const InputError& error) {
      leave_out(step, error);
    }
  }
  if (!part_.workplan.empty()) return;
  if (program_.workingsteps.size() == 1) throw *first_error_;
  throw InputError("", std::string(first_error_->what()) + " (and none of the other " +
                           std::to_string(program_.workingsteps.size() - 1) +
                           " workingsteps can be machined)");
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
  Operation operation = read_operation(node, tools, context_);
  std::vector<const Draft*> parts;
  for (const std::size_t draft : drafts) parts.push_back(&drafts_[draft]);
  const std::vector<std::size_t> chosen =
      parts_for(parts, node, operation, part_.tools[static_cast<std::size_t>(operation.tool)]);
  if (operation.retract_z) {
    double top = -kEverywhere;
    for (const std::size_t draft : drafts) top = std::max(top, feature_of_draft(draft).top_z);
    *operation.retract_z += top;
  }
  for (const std::size_t i : chosen) check_part(drafts_[drafts[i]], step, operation);
  for (const std::size_t i : chosen)
    part_.workplan.push_back(
        {step.text(0), "#" + std::to_string(step.id()), feature_of_draft_[drafts[i]], operation});
}

void Reader::check_part(const Draft& draft, const Node& step, const Operation& operation) const {
  const ToolKind kind = part_.tools[static_cast<std::size_t>(operation.tool)].kind;
  if (draft.raised_floor > 0 && kind == ToolKind::kBallEndMill)
    step.fail("a rounded bottom cannot be machined yet; leave this step out");
  if (goes_straight_down(operation) && !draft.hole_diameter)
    step.fail(draft.node.is("ROUND_HOLE") ? "a tapered hole is milled, not drilled; give a milling operation"
                                          : "drilling is for round holes; correct the operation");
}

/// Features whose workingsteps were all left out (and reported) are no part of the job.
void Reader::drop_unused_features() {
  std::vector<int> renumbered(part_.features.size(), -1);
  std::vector<Feature> used;
  for (const Workingstep& step : part_.workplan) renumbered[static_cast<std::size_t>(step.feature)] = 0;
  for (std::size_t i = 0; i < part_.features.size(); ++i) {
    if (renumbered[i] < 0) continue;
    renumbered[i] = static_cast<int>(used.size());
    used.push_back(std::move(part_.features[i]));
  }
  part_.features = std::move(used);
  for (Workingstep& step : part_.workplan) step.feature = renumbered[static_cast<std::size_t>(step.feature)];
}

/// Tops from stacking; retract planes follow, and stay below the security plane.
void Reader::set_tops() {
  if (absolute_depths_) {
    const std::vector<double> tops = stock::stacked_tops(part_, context_.tol);
    for (Workingstep& step : part_.workplan)
      if (step.operation.retract_z)
        *step.operation.retract_z += tops[static_cast<std::size_t>(step.feature)] - feature_of(step).top_z;
    for (std::size_t i = 0; i < tops.size(); ++i) part_.features[i].top_z = tops[i];
  } else {
    stock::stack_tops(part_, context_.tol);
    context_.diagnostics.append(part_.diagnostics);
  }
  for (Workingstep& step : part_.workplan)
    if (part_.clearance_z && step.operation.retract_z)
      step.operation.retract_z = std::min(*step.operation.retract_z, *part_.clearance_z);
}

}  // namespace

Part read_stepnc(std::string_view text, const std::string& file_name, const Tolerances& tol) {
  const P21File file = parse_part21(text, file_name);
  check_schema(file);
  return Reader(file, tol).read();
}

}  // namespace clearcut::read::stepnc
