#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/tolerances.h"
#include "post/part/p21_text.h"
#include "post/part/stepnc_features.h"
#include "post/part/stepnc_setups.h"
#include "post/part/stepnc_toolpaths.h"

namespace clearcut::post {

namespace {

std::string optional_real(std::optional<double> value) {
  return value ? p21_real(*value) : kUnset;
}
std::string positive_real(double value) {
  return value > 0 ? p21_real(value) : kUnset;
}

/// A chamfer mill whose tip does not cut is a tapered end mill as wide as its tip.
bool has_blunt_tip(const Tool& tool) {
  return tool.kind == ToolKind::kChamferMill && tool.tip_diameter > 0;
}

const char* body_keyword(ToolKind kind) {
  switch (kind) {
    case ToolKind::kEndMill:
      return "ENDMILL";
    case ToolKind::kFaceMill:
      return "FACEMILL";
    case ToolKind::kBallEndMill:
      return "BALL_ENDMILL";
    case ToolKind::kBullNoseEndMill:
      return "BULLNOSE_ENDMILL";
    case ToolKind::kTapered:
      return "TAPERED_ENDMILL";
    case ToolKind::kDrill:
      return "TWIST_DRILL";
    case ToolKind::kReamer:
      return "REAMER";
    case ToolKind::kSpotDrill:
      return "CENTER_DRILL";
    case ToolKind::kTap:
      return "TAP";
    case ToolKind::kBoringBar:
      return "BORING_TOOL";
    case ToolKind::kCounterbore:
      return "COUNTERBORE";
    case ToolKind::kVBit:
    case ToolKind::kChamferMill:
      return "COUNTERSINK";
    case ToolKind::kTSlot:
      return "T_SLOT_MILL";
    case ToolKind::kThreadMill:
    case ToolKind::kOther:
      break;
  }
  return "SIDE_MILL";
}

/// The reader takes the number from "T3" or "T3 name".
std::string tool_name(const Tool& tool) {
  const std::string number = "T" + std::to_string(tool.number);
  return tool.name == number || tool.name.empty() ? number : number + " " + tool.name;
}

/// Strategies of ISO 14649-11 with the number of their arguments and the place of the cut mode (-1: none).
struct Strategy {
  std::string_view hint;
  std::string_view keyword;
  int arguments;
  int cutmode;
  int rotation;
  bool strokes = false;  ///< the third argument is the direction of strokes
};
constexpr Strategy kStrategies[] = {{"unidirectional_milling", "UNIDIRECTIONAL_MILLING", 4, 3, -1, true},
                                    {"unidirectional", "UNIDIRECTIONAL", 4, 3, -1, true},
                                    {"bidirectional_milling", "BIDIRECTIONAL_MILLING", 5, -1, -1, true},
                                    {"bidirectional", "BIDIRECTIONAL", 5, -1, -1, true},
                                    {"contour_parallel", "CONTOUR_PARALLEL", 4, 3, 2},
                                    {"bidirectional_contour", "BIDIRECTIONAL_CONTOUR", 6, 5, -1, true},
                                    {"contour_bidirectional", "CONTOUR_BIDIRECTIONAL", 6, 5, -1},
                                    {"contour_spiral", "CONTOUR_SPIRAL", 4, 3, 2},
                                    {"center_milling", "CENTER_MILLING", 2, -1, -1},
                                    {"explicit_strategy", "EXPLICIT_STRATEGY", 2, -1, -1}};

const Strategy* strategy_of(const Operation& operation) {
  for (const Strategy& strategy : kStrategies)
    if (operation.strategy_hint == strategy.hint) return &strategy;
  return nullptr;
}

const char* operation_keyword(OperationKind kind) {
  switch (kind) {
    case OperationKind::kFinishing:
      return "BOTTOM_AND_SIDE_FINISH_MILLING";
    case OperationKind::kBottomFinishing:
      return "PLANE_FINISH_MILLING";
    case OperationKind::kSideFinishing:
      return "SIDE_FINISH_MILLING";
    case OperationKind::kDrilling:
      return "DRILLING";
    case OperationKind::kReaming:
      return "REAMING";
    case OperationKind::kRoughing:
    case OperationKind::kOther:
      break;
  }
  return "BOTTOM_AND_SIDE_ROUGH_MILLING";
}

/// Of a drill with a stated point: the angle of its edges against the plane square to its axis.
/// Of cones from 90 degrees on that between their flanks.
std::string top_angle_of(const Tool& tool) {
  if (!tool.tip_angle || has_blunt_tip(tool)) return kUnset;
  const double tip = tool.tip_angle->radians();
  if (is_conical(tool)) return p21_real(tip < kPi / 2 - 1e-6 ? (kPi - tip) / 2 : tip);
  return tool.kind == ToolKind::kDrill ? p21_real((kPi - tip) / 2) : kUnset;
}

std::string width_of(const Tool& tool) {
  return p21_real(has_blunt_tip(tool) ? tool.tip_diameter : tool.diameter);
}

std::string edge_length_of(const Tool& tool) {
  return has_blunt_tip(tool) ? p21_real(flank_height(tool)) : optional_real(tool.flute_length);
}

bool is_point(const KeepOut& clamp) {
  return clamp.plan.min == clamp.plan.max && clamp.bottom_z == clamp.top_z;
}

/// Which tools of a set-up are written.
enum class WrittenTools : unsigned char {
  kAll,
  kUsed,  ///< those of its workingsteps: others are written with the set-up that uses them
};

/// One set-up: SETUP, tools, features, operations and workingsteps.
class SetupWriter {
 public:
  /// `toolpath`: null if none is written.
  SetupWriter(P21Writer& out, const P21Common& common, const Part& part, const Toolpath* toolpath,
              WrittenTools tools)
      : part_(part),
        toolpath_(toolpath),
        written_tools_(tools),
        out_(out),
        common_(common),
        paths_(out_, common_, part.safe_z()) {}

  /// The reference of the SETUP.
  std::string write(const std::string& name) {
    const std::string setup = write_setup(name);
    write_tools();
    write_workingsteps();
    return setup;
  }
  const std::vector<std::string>& steps() const { return steps_; }

 private:
  /// Blocks; several of them as a list.
  std::string restricted_area() {
    std::vector<std::string> blocks;
    for (const KeepOut& clamp : part_.keep_outs)
      if (!is_point(clamp))
        blocks.push_back(out_.add(
            "BLOCK",
            {"'restricted area'", p21_place_in_workpiece(out_, common_, clamp.plan.min, clamp.bottom_z),
             p21_real(clamp.plan.width()), p21_real(clamp.plan.height()),
             p21_real(clamp.top_z - clamp.bottom_z)}));
    if (blocks.empty()) return kUnset;
    return blocks.size() == 1 ? blocks.front() : p21_list(blocks);
  }

  /// The axes of the workpiece in the set-up.
  std::string mounted_axes() {
    const auto& turn = common_.place.turn;
    const auto column = [&](std::size_t i) {
      return out_.add("DIRECTION",
                      {"''", p21_list({p21_real(turn[0][i]), p21_real(turn[1][i]), p21_real(turn[2][i])})});
    };
    const std::string zero = out_.add("CARTESIAN_POINT", {"''", "(0.0,0.0,0.0)"});
    const std::string up = column(2);
    return out_.add("AXIS2_PLACEMENT_3D", {"''", zero, up, column(0)});
  }

  std::string write_setup(const std::string& name) {
    security_ = p21_plane(out_, common_, "security plane", part_.safe_z());
    const std::string origin = p21_placement(out_, common_, {}, 0);
    const std::string mounted = out_.add(
        "WORKPIECE_SETUP",
        {common_.workpiece, is_turned(common_) ? mounted_axes() : origin, kUnset, restricted_area(), "()"});
    return out_.add("SETUP", {p21_string(name), origin, security_, p21_list({mounted})});
  }

  bool counter_clockwise(int tool) const {
    return any_step_of(tool,
                       [](const Workingstep& step) { return !step.operation.cutting.spindle_clockwise; });
  }

  template <typename Matches>
  bool any_step_of(int tool, Matches matches) const {
    return std::any_of(part_.workplan.begin(), part_.workplan.end(),
                       [&](const Workingstep& step) { return step.operation.tool == tool && matches(step); });
  }

  /// A spot drill that also countersinks has the body that countersinking needs.
  std::string_view body_of(int number) const {
    const Tool& tool = part_.tools[static_cast<std::size_t>(number)];
    if (has_blunt_tip(tool)) return "TAPERED_ENDMILL";
    const auto countersinks = [&](const Workingstep& step) {
      return is_countersunk(feature_of(part_, step));
    };
    if (tool.kind == ToolKind::kSpotDrill && any_step_of(number, countersinks)) return "COUNTERSINK";
    return body_keyword(tool.kind);
  }

  void write_tools() {
    for (std::size_t i = 0; i < part_.tools.size(); ++i) {
      const Tool& tool = part_.tools[i];
      const int number = static_cast<int>(i);
      if (written_tools_ == WrittenTools::kUsed &&
          !any_step_of(number, [](const Workingstep&) { return true; })) {
        tools_.push_back(kUnset);
        continue;
      }
      const std::string size = out_.add("MILLING_TOOL_DIMENSION",
                                        {width_of(tool), top_angle_of(tool), kUnset, edge_length_of(tool),
                                         p21_real(tool.corner_radius), kUnset, kUnset});
      const bool left_handed = tool.left_hand || counter_clockwise(number);
      const char* hand = left_handed ? ".LEFT." : ".RIGHT.";
      std::vector<std::string> arguments = {size, std::to_string(tool.teeth), hand, ".F.", kUnset};
      const std::string_view keyword = body_of(number);
      if (keyword == "SIDE_MILL" || keyword == "COUNTERSINK") arguments.push_back(kUnset);
      if (tool.kind == ToolKind::kTSlot) arguments.push_back(edge_length_of(tool));
      if (keyword == "TAPERED_ENDMILL")
        arguments.push_back(p21_real(tool.tip_angle.value_or(Radians{}).radians() / 2));
      const std::string body = out_.add(std::string(keyword), arguments);
      const std::string edge = out_.add("CUTTING_COMPONENT", {kUnset, kUnset, kUnset, kUnset, kUnset});
      tools_.push_back(out_.add("MILLING_CUTTING_TOOL", {p21_string(tool_name(tool)), body, p21_list({edge}),
                                                         kUnset, kUnset, kUnset}));
    }
  }

  /// Workingsteps in order; a feature is written at its first workingstep, with all its operations.
  void write_workingsteps() {
    operations_.resize(part_.workplan.size());
    std::vector<std::vector<std::string>> features(part_.features.size());
    for (const std::size_t i : order_of_steps()) {
      const auto index = static_cast<std::size_t>(part_.workplan[i].feature);
      if (features[index].empty()) features[index] = write_feature_with_operations(static_cast<int>(index));
      write_stops(part_.workplan[i]);
      if (has_nothing_left(i)) continue;
      for (std::size_t piece = 0; piece < features[index].size(); ++piece)
        steps_.push_back(
            out_.add("MACHINING_WORKINGSTEP", {p21_string(piece_name(part_.workplan[i].name, piece)),
                                               security_, features[index][piece], operations_[i], kUnset}));
    }
  }

  void write_stops(const Workingstep& step) {
    for (const ProgramStop& stop : step.stops) {
      if (stop.kind == StopKind::kMessage)
        steps_.push_back(out_.add("DISPLAY_MESSAGE", {p21_string(stop.text), p21_string(stop.text)}));
      else
        steps_.push_back(out_.add(stop.kind == StopKind::kHalt ? "PROGRAM_STOP" : "OPTIONAL_STOP",
                                  {p21_string(stop.text)}));
    }
  }

  /// In the order of cutting; uncut ones after the others.
  std::vector<std::size_t> order_of_steps() const {
    std::vector<std::size_t> order;
    const auto add = [&](std::size_t i) {
      if (std::find(order.begin(), order.end(), i) == order.end()) order.push_back(i);
    };
    if (toolpath_ != nullptr)
      for (const Section& section : toolpath_->sections)
        if (section.workingstep >= 0) add(static_cast<std::size_t>(section.workingstep));
    for (std::size_t i = 0; i < part_.workplan.size(); ++i) add(i);
    return order;
  }

  /// All cuts of the program for a workingstep; nothing if there are none.
  std::optional<Section> section_of(std::size_t step) const {
    std::optional<Section> whole;
    if (toolpath_ == nullptr) return whole;
    for (const Section& section : toolpath_->sections) {
      if (section.workingstep != static_cast<int>(step)) continue;
      if (!whole) {
        whole = section;
        continue;
      }
      for (const Dwell& dwell : section.dwells)
        whole->dwells.push_back({whole->moves.size() + dwell.after, dwell.seconds});
      whole->moves.insert(whole->moves.end(), section.moves.begin(), section.moves.end());
    }
    return whole;
  }

  bool is_cut(std::size_t step) const {
    return std::any_of(toolpath_->sections.begin(), toolpath_->sections.end(),
                       [&](const Section& section) { return section.workingstep == static_cast<int>(step); });
  }

  /// Whether other steps leave nothing of its feature to the step, which without a toolpath would be planned anew from the file.
  bool has_nothing_left(std::size_t step) const {
    if (toolpath_ == nullptr || is_cut(step)) return false;
    for (std::size_t i = 0; i < part_.workplan.size(); ++i)
      if (part_.workplan[i].feature == part_.workplan[step].feature && is_cut(i)) return true;
    return false;
  }

  static std::string piece_name(const std::string& name, std::size_t piece) {
    return piece == 0 ? name : name + " (" + std::to_string(piece + 1) + ")";
  }

  std::vector<std::string> write_feature_with_operations(int index) {
    const Feature& feature = part_.features[static_cast<std::size_t>(index)];
    std::vector<std::string> its_operations;
    for (std::size_t i = 0; i < part_.workplan.size(); ++i) {
      if (part_.workplan[i].feature != index || has_nothing_left(i)) continue;
      operations_[i] = write_operation(i, feature);
      its_operations.push_back(operations_[i]);
    }
    std::vector<std::string> pieces;
    const Tool* tool = tool_on(index);
    // A chamfer has no frame for its toolpaths; in a turned set-up that of a compound serves.
    const bool is_compound =
        toolpath_ != nullptr &&
        (feature.chamfer ? is_turned(common_) : feature.target.size() > 1 && !is_grooved_by(feature, tool));
    for (const Region& region : feature.target) {
      pieces.push_back(write_feature(
          out_, common_, {&feature, &region, piece_name(feature.name, pieces.size()), tool, is_compound},
          part_.stock, its_operations));
      if (feature.chamfer || is_grooved_by(feature, tool)) break;  // the line is all of it
    }
    if (!is_compound) return pieces;
    return {
        out_.add("COMPOUND_FEATURE", {p21_string(feature.name), common_.workpiece, p21_list(its_operations),
                                      p21_place_in_workpiece(out_, common_, {}, 0), p21_list(pieces)})};
  }

  static bool is_grooved_by(const Feature& feature, const Tool* tool) {
    return tool != nullptr && is_grooved(feature, *tool);
  }

  /// What the first workingstep on a feature works with.
  const Tool* tool_on(int feature) const {
    for (const Workingstep& step : part_.workplan)
      if (step.feature == feature) return &tool_of(part_, step);
    return nullptr;
  }

  /// The frame of the feature's entity, in which its toolpaths are written.
  static PathOrigin path_origin(const Feature& feature, const Tool& tool) {
    if (feature.chamfer) return {};  // which has no frame of its own
    if (is_grooved(feature, tool)) return {{}, feature.top_z};
    if (feature.target.size() != 1) return {};
    return {placement_of({&feature, &feature.target.front(), feature.name}), feature.top_z};
  }

  std::string write_operation(std::size_t step, const Feature& feature) {
    const Operation& operation = part_.workplan[step].operation;
    const std::string retract = operation.retract_z ? p21_real(*operation.retract_z - feature.top_z) : kUnset;
    const auto section = section_of(step);
    const std::string path =
        section ? paths_.write(*section, path_origin(feature, tool_of(part_, part_.workplan[step])),
                               spindle_of(operation.cutting))
                : kUnset;
    is_explicit_ = path != kUnset;
    std::vector<std::string> arguments = {path,
                                          kUnset,
                                          p21_string(operation.name),
                                          retract,
                                          kUnset,
                                          tools_[static_cast<std::size_t>(operation.tool)],
                                          write_technology(operation.cutting),
                                          write_functions(operation),
                                          kUnset};
    const std::vector<std::string> rest =
        operation.kind == OperationKind::kDrilling || operation.kind == OperationKind::kReaming
            ? drilling_arguments(operation, is_tapped(feature))
            : milling_arguments(operation);
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    const bool bores = operation.kind == OperationKind::kReaming &&
                       part_.tools[static_cast<std::size_t>(operation.tool)].kind == ToolKind::kBoringBar;
    const bool spots = feature.hole && feature.hole->kind == HoleKind::kSpotted;
    const char* keyword = bores                     ? "BORING"
                          : spots                   ? "CENTER_DRILLING"
                          : is_tapped(feature)      ? "TAPPING"
                          : is_countersunk(feature) ? "COUNTER_SINKING"
                                                    : operation_keyword(operation.kind);
    return out_.add(keyword, arguments);
  }

  /// Whether a share of the feed really reduces it.
  static bool is_reduced(double depth, double share) { return depth > 0 && share != 1; }

  std::vector<std::string> drilling_arguments(const Operation& operation, bool taps) {
    std::vector<std::string> arguments(5, kUnset);
    if (const auto& feeds = operation.hole_feeds) {
      if (feeds->dwell_s > 0) arguments[2] = p21_real(feeds->dwell_s);
      if (feeds->retract_share) arguments[3] = p21_real(*feeds->retract_share);
      if (is_reduced(feeds->start_depth, feeds->start_share) ||
          is_reduced(feeds->end_depth, feeds->end_share))
        arguments[4] = out_.add("DRILLING_TYPE_STRATEGY",
                                {kUnset, p21_real(feeds->start_share), p21_real(feeds->start_depth), kUnset,
                                 p21_real(feeds->end_share), p21_real(feeds->end_depth)});
    }
    if (taps)
      arguments.push_back(part_.tools[static_cast<std::size_t>(operation.tool)].floating ? ".T." : ".F.");
    if (operation.kind == OperationKind::kReaming) arguments.insert(arguments.end(), {".F.", kUnset, kUnset});
    return arguments;
  }

  std::vector<std::string> milling_arguments(const Operation& operation) {
    std::vector<std::string> arguments = {write_approach(operation), write_retract(operation),
                                          write_strategy(operation), optional_real(operation.stepdown)};
    if (operation.kind == OperationKind::kBottomFinishing) {
      arguments.push_back(positive_real(operation.allowance_floor));
      return arguments;
    }
    const double diameter = part_.tools[static_cast<std::size_t>(operation.tool)].diameter;
    arguments.push_back(operation.stepover ? p21_real(*operation.stepover * diameter) : kUnset);
    arguments.push_back(positive_real(operation.allowance_side));
    if (operation.kind != OperationKind::kSideFinishing)
      arguments.push_back(positive_real(operation.allowance_floor));
    return arguments;
  }

  std::string write_approach(const Operation& operation) {
    if (!operation.entry) return kUnset;
    const std::string angle = operation.entry_angle ? p21_real(operation.entry_angle->radians()) : kUnset;
    switch (*operation.entry) {
      case EntryKind::kHelix: {
        const double radius =
            operation.entry_size.value_or(part_.tools[static_cast<std::size_t>(operation.tool)].radius() / 2);
        return out_.add("PLUNGE_HELIX", {kUnset, p21_real(radius), angle});
      }
      case EntryKind::kRamp:
        return out_.add("PLUNGE_RAMP", {kUnset, angle});
      case EntryKind::kZigzagRamp: {
        const double width =
            operation.entry_size.value_or(part_.tools[static_cast<std::size_t>(operation.tool)].diameter);
        return out_.add("PLUNGE_ZIGZAG", {kUnset, angle, p21_real(width)});
      }
      case EntryKind::kPlunge:
        break;
    }
    return out_.add("PLUNGE_TOOLAXIS", {kUnset});
  }

  std::string write_retract(const Operation& operation) {
    if (!operation.lead || *operation.lead <= 0) return kUnset;
    if (!operation.lead_angle) return out_.add("AP_RETRACT_TANGENT", {kUnset, p21_real(*operation.lead)});
    return out_.add("AP_RETRACT_ANGLE",
                    {kUnset, p21_real(operation.lead_angle->radians()), p21_real(*operation.lead)});
  }

  static bool radial_in_strategy(const Operation& operation) {
    return operation.kind == OperationKind::kBottomFinishing && operation.stepover &&
           *operation.stepover > 0 && *operation.stepover <= 1;
  }

  std::string write_strategy(const Operation& operation) {
    if (is_explicit_) return out_.add("EXPLICIT_STRATEGY", {kUnset, kUnset});
    const Strategy* strategy = strategy_of(operation);
    if (strategy == nullptr) return kUnset;
    std::vector<std::string> arguments(static_cast<std::size_t>(strategy->arguments), kUnset);
    if (operation.feed_direction && strategy->strokes) {
      const Vec2 along = direction_of(operation.feed_direction->radians());
      arguments[2] =
          out_.add("DIRECTION", {"''", p21_list({p21_real(along.x), p21_real(along.y), p21_real(0)})});
    }
    if (radial_in_strategy(operation)) arguments[0] = p21_real(1 - *operation.stepover);
    if (strategy->rotation >= 0)
      arguments[static_cast<std::size_t>(strategy->rotation)] =
          operation.direction == CutDirection::kConventional ? ".CW." : ".CCW.";
    if (strategy->cutmode >= 0 && operation.direction)
      arguments[static_cast<std::size_t>(strategy->cutmode)] =
          *operation.direction == CutDirection::kClimb ? ".CLIMB." : ".CONVENTIONAL.";
    return out_.add(std::string(strategy->keyword), arguments);
  }

  std::string write_technology(const CuttingData& cutting) {
    const std::string feed = cutting.feed ? p21_feed(*cutting.feed) : kUnset;
    return out_.add("MILLING_TECHNOLOGY",
                    {feed, ".TCP.", kUnset, spindle_of(cutting), kUnset, ".F.", ".F.", ".F.", kUnset});
  }

  static std::string spindle_of(const CuttingData& cutting) {
    const double sign = cutting.spindle_clockwise ? -1 : 1;
    return cutting.spindle_rpm ? p21_real(sign * *cutting.spindle_rpm / 60) : kUnset;
  }

  std::string write_functions(const Operation& operation) {
    std::vector<std::string> properties;
    const auto number = [&](const char* name, std::optional<double> value, const char* unit) {
      if (value)
        properties.push_back(
            out_.add("NUMERIC_PARAMETER", {p21_string(name), p21_real(*value), p21_string(unit)}));
    };
    const auto feed = [&](const char* name, const std::optional<MmPerMin>& value) {
      if (value) number(name, value->mm_per_min(), "MM/MIN");
    };
    feed("PLUNGE FEED", operation.cutting.plunge_feed);
    feed("RAMP FEED", operation.cutting.ramp_feed);
    feed("SLOT FEED", operation.cutting.slot_feed);
    number("SCALLOP HEIGHT", operation.scallop, "MM");
    const Strategy* strategy = strategy_of(operation);
    if (operation.stepover && operation.kind == OperationKind::kBottomFinishing &&
        !(strategy != nullptr && radial_in_strategy(operation)))
      number("STEPOVER", operation.stepover, "RATIO");
    if (operation.direction && (strategy == nullptr || strategy->cutmode < 0))
      properties.push_back(out_.add(
          "DESCRIPTIVE_PARAMETER",
          {"'CUT DIRECTION'", *operation.direction == CutDirection::kClimb ? "'CLIMB'" : "'CONVENTIONAL'"}));
    const Coolant coolant = operation.cutting.coolant.value_or(Coolant::kOff);
    return out_.add("MILLING_MACHINE_FUNCTIONS",
                    {has_flood(coolant) ? ".T." : ".F.", kUnset, has_mist(coolant) ? ".T." : kUnset, ".F.",
                     kUnset, "()", ".F.", kUnset, kUnset, p21_list(properties)});
  }

  const Part& part_;
  const Toolpath* toolpath_;
  WrittenTools written_tools_;
  P21Writer& out_;
  P21Common common_;
  ToolpathWriter paths_;
  bool is_explicit_ = false;  // the operation being written has a toolpath
  std::string security_;
  std::vector<std::string> tools_;
  std::vector<std::string> operations_;  // operation of each workingstep
  std::vector<std::string> steps_;
};

/// A set-up to be written.
struct AskedSetup {
  const Part* part = nullptr;
  const Toolpath* toolpath = nullptr;  ///< null if none is written
  SetupPlace place = {};
};

/// A file of one or several set-ups in the order: project, workplan, workpiece, then each set-up with its tools, features and operations.
class ProgramWriter {
 public:
  ProgramWriter(std::string name, const std::vector<AskedSetup>& setups)
      : name_(std::move(name)), setups_(setups) {}

  std::string write() {
    const int project = out_.reserve(), workplan = out_.reserve(), workpiece = out_.reserve();
    common_.z_axis = out_.add("DIRECTION", {"'z'", "(0.0,0.0,1.0)"});
    common_.x_axis = out_.add("DIRECTION", {"'x'", "(1.0,0.0,0.0)"});
    common_.workpiece = p21_reference(workpiece);
    write_workpiece(workpiece);
    const std::string name = p21_string(name_);
    write_workplan(workplan);
    out_.put(project, "PROJECT",
             {name, p21_reference(workplan), p21_list({common_.workpiece}), kUnset, kUnset, kUnset});
    return header() + out_.text() + "ENDSEC;\nEND-ISO-10303-21;\n";
  }

 private:
  std::string header() const {
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('ISO 14649 program; lengths mm, angles "
           "radian'),'2;1');\n"
           "FILE_NAME(" +
           p21_string(name_) +
           ",'',(''),(''),'clearcut','clearcut','');\n"
           "FILE_SCHEMA(('MACHINING_SCHEMA','MILLING_SCHEMA'));\nENDSEC;\nDATA;\n";
  }

  P21Common common_of(const AskedSetup& setup) const {
    P21Common common = common_;
    common.place = setup.place;
    return common;
  }

  void write_workpiece(int id) {
    std::string block = kUnset;
    const AskedSetup& first = setups_.front();
    if (first.part->stock) {
      const Stock s = is_turned(common_of(first)) ? moved(*first.part->stock, between(first.place, {}))
                                                  : *first.part->stock;
      block = out_.add(
          "BLOCK", {"'stock'", p21_placement(out_, common_, s.plan.min, s.z_bottom), p21_real(s.plan.width()),
                    p21_real(s.plan.height()), p21_real(s.z_top - s.z_bottom)});
    }
    const auto& stated = first.part->material;
    const std::string material = stated ? out_.add("MATERIAL", {"''", p21_string(*stated), "()"}) : kUnset;
    out_.put(id, "WORKPIECE",
             {"'workpiece'", material, kUnset, kUnset, kUnset, block, p21_list(clamping_positions())});
  }

  /// Of all set-ups, in the coordinates of the workpiece.
  std::vector<std::string> clamping_positions() {
    std::vector<SetupPlace::Row> points;
    std::vector<std::string> written;
    for (const AskedSetup& setup : setups_) {
      for (const KeepOut& clamp : setup.part->keep_outs) {
        if (!is_point(clamp)) continue;
        const SetupPlace::Row at =
            turned_back(common_of(setup), {clamp.plan.min.x, clamp.plan.min.y, clamp.bottom_z});
        if (std::find(points.begin(), points.end(), at) != points.end()) continue;
        points.push_back(at);
        written.push_back(out_.add(
            "CARTESIAN_POINT", {"'clamp'", p21_list({p21_real(at[0]), p21_real(at[1]), p21_real(at[2])})}));
      }
    }
    return written;
  }

  void write_workplan(int id) {
    if (setups_.size() == 1) {
      SetupWriter writer(out_, common_of(setups_.front()), *setups_.front().part, setups_.front().toolpath,
                         WrittenTools::kAll);
      const std::string setup = writer.write("setup");
      out_.put(id, "WORKPLAN", {"'main workplan'", p21_list(writer.steps()), kUnset, setup, kUnset});
      return;
    }
    std::vector<std::string> plans;
    for (std::size_t i = 0; i < setups_.size(); ++i) {
      const std::string name = "set-up " + std::to_string(i + 1);
      SetupWriter writer(out_, common_of(setups_[i]), *setups_[i].part, setups_[i].toolpath,
                         WrittenTools::kUsed);
      const std::string setup = writer.write(name);
      plans.push_back(
          out_.add("WORKPLAN", {p21_string(name), p21_list(writer.steps()), kUnset, setup, kUnset}));
    }
    out_.put(id, "WORKPLAN", {"'main workplan'", p21_list(plans), kUnset, kUnset, kUnset});
  }

  std::string name_;
  const std::vector<AskedSetup>& setups_;
  P21Writer out_;
  P21Common common_;
};

std::string program_text(const std::string& name, const std::vector<AskedSetup>& setups) {
  return ProgramWriter(name, setups).write();
}

/// Why a line to follow cannot be written; "" where it can. With its moves a profile is the kerf that it clears.
std::string not_written(const Feature& feature, const Tool& tool, bool has_moves) {
  if (!feature.profile || is_grooved(feature, tool)) return "";
  if (feature.kind == FeatureKind::kTSlot) return "a line to follow, and STEP-NC has none";
  if (!feature.profile->tabs.empty()) return "and its tabs are material that STEP-NC has no word for";
  if (is_carved(feature, tool)) return "cut by a cone with a flat tip, and STEP-NC has no such section";
  return has_moves ? "" : "a line to follow, and STEP-NC has none";
}

void refuse_profiles(const Part& part, bool has_moves) {
  for (const Workingstep& step : part.workplan) {
    const Feature& feature = feature_of(part, step);
    const std::string why = not_written(feature, tool_of(part, step), has_moves);
    if (why.empty()) continue;
    std::string kind = name_of(feature.kind);
    std::replace(kind.begin(), kind.end(), '_', ' ');
    throw InputError(part.source_file,
                     feature.name + (feature.kind == FeatureKind::kTSlot ? " is a " : " is an ") + kind +
                         ", " + why + "; write outline JSON, which holds it (-o NAME.json)");
  }
}

/// Countersinks are written as holes by a pointed cone that is as wide as they are.
void refuse_wide_cones(const Part& part) {
  for (const Workingstep& step : part.workplan) {
    const Feature& feature = feature_of(part, step);
    const Tool& tool = tool_of(part, step);
    if (!is_countersunk(feature)) continue;
    const bool is_plain = is_conical(tool) && !has_blunt_tip(tool) &&
                          feature.hole->diameter <= tool.diameter + Tolerances{}.fit &&
                          step.operation.kind == OperationKind::kDrilling;
    if (!is_plain)
      throw InputError(part.source_file,
                       feature.name +
                           " is a countersink that its cutter goes round in, and STEP-NC has "
                           "COUNTER_SINKING by a cone as wide; leave it out with --op ignore:" +
                           feature.source);
  }
}

void refuse_without_tools(const Part& part) {
  for (const auto& step : part.workplan) {
    if (step.operation.tool >= 0 && step.operation.tool < static_cast<int>(part.tools.size())) continue;
    throw InputError(part.source_file, "names no tool for " + step.name + "; STEP-NC needs one: give --tool");
  }
}

}  // namespace

std::string write_stepnc(const Part& part) {
  refuse_without_tools(part);
  refuse_profiles(part, false);
  return program_text(part.name, {{&part}});
}

std::string write_stepnc(const Part& part, const Toolpath& toolpath) {
  refuse_without_tools(part);
  refuse_profiles(part, true);
  refuse_wide_cones(part);
  return program_text(part.name, {{&part, &toolpath}});
}

namespace {

/// By right angles, without what rounding leaves of them.
SetupPlace exactly_turned(const WrittenSetup& setup, std::size_t number) {
  const auto refuse = [&](const char* why) {
    throw InputError(setup.part.source_file, "set-up " + std::to_string(number) + " " + why +
                                                 "; write each set-up by itself (--setup)");
  };
  if (!keeps_boxes(setup.place)) refuse("is not turned by right angles");
  if (setup.place.shift != SetupPlace{}.shift)
    refuse("has a zero of its own, and STEP-NC programs are read with that of the workpiece");
  SetupPlace place = setup.place;
  for (SetupPlace::Row& row : place.turn)
    for (double& value : row) value = std::round(value) + 0.0;
  return place;
}

/// Without the number of the set-up.
std::string name_of_project(const std::string& name, std::size_t count) {
  const std::string end = ", set-up 1 of " + std::to_string(count);
  const bool has_end = name.size() > end.size() && name.substr(name.size() - end.size()) == end;
  return has_end ? name.substr(0, name.size() - end.size()) : name;
}

}  // namespace

std::string write_stepnc(const std::vector<WrittenSetup>& setups) {
  std::vector<AskedSetup> asked;
  for (const WrittenSetup& setup : setups) {
    refuse_without_tools(setup.part);
    refuse_profiles(setup.part, true);
    refuse_wide_cones(setup.part);
    asked.push_back({&setup.part, &setup.toolpath, exactly_turned(setup, asked.size() + 1)});
  }
  return program_text(name_of_project(setups.front().part.name, setups.size()), asked);
}

}  // namespace clearcut::post
