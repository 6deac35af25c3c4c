#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "read/stepnc/stepnc.h"

namespace clearcut::read::stepnc {
namespace {

/// Entities that a message names before it counts the rest.
constexpr std::size_t kNamed = 8;
/// Characters of an annotation's value.
constexpr std::size_t kShownOfAnnotations = 60;

// Heads that many kinds of entities have in common.
#define FEATURE_HEAD "~its_id its_workpiece ~its_operations feature_placement depth "
#define THREAD_TAIL                                                                                \
  "partial_profile applied_shape inner_or_outer_thread ~qualifier ?fit_class form major_diameter " \
  "number_of_threads thread_hand "
#define OPERATION_HEAD                                                                         \
  "its_toolpath its_tool_direction ~its_id retract_plane start_point its_tool its_technology " \
  "its_machine_functions overcut_length "
#define MILLING_HEAD OPERATION_HEAD "approach retract its_machining_strategy axial_cutting_depth "
#define DRILLING_HEAD \
  OPERATION_HEAD      \
  "cutting_depth previous_diameter dwell_time_bottom feed_on_retract its_machining_strategy "
#define STRATEGY_HEAD "?overlap ?allow_multiple_passes "
#define TOOLPATH_HEAD "its_priority its_type its_speed its_technology its_machine_functions "
#define BODY_HEAD "dimension number_of_teeth hand_of_cut ~coolant_through_tool ~pilot_length "

constexpr EntityRow kEntities[] = {
    {"PROJECT", "~its_id main_workplan its_workpieces ~its_owner ~its_release ~its_status"},
    {"WORKPLAN", "~its_id its_elements ~its_channel its_setup ~its_effect"},
    {"NON_SEQUENTIAL", "~its_id its_elements"},
    {"PARALLEL", "~its_id branches"},
    {"SELECTIVE", "~its_id its_elements"},
    {"IF_STATEMENT", "~its_id condition true_branch false_branch"},
    {"WHILE_STATEMENT", "~its_id condition body"},
    {"PROGRAM_STOP", "its_id"},
    {"OPTIONAL_STOP", "its_id"},
    {"DISPLAY_MESSAGE", "~its_id its_text"},
    {"MACHINING_WORKINGSTEP", "~its_id its_secplane its_feature its_operation ~its_effect"},
    {"WORKPIECE",
     "~its_id ~its_material ~global_tolerance its_rawpiece ~its_geometry ~its_bounding_geometry "
     "clamping_positions"},
    {"MATERIAL", "~standard_identifier ~material_identifier ~material_property"},
    {"SETUP", "~its_id its_origin its_secplane its_workpiece_setup"},
    {"WORKPIECE_SETUP", "its_workpiece its_origin its_offset its_restricted_area its_instructions"},
    {"OFFSET_VECTOR", "translate rotate"},
    {"SETUP_INSTRUCTION", "description external_document"},
    {"PLANAR_FACE", FEATURE_HEAD "course_of_travel removal_boundary face_boundary its_boss"},
    {"CLOSED_POCKET",
     FEATURE_HEAD "its_boss slope bottom_condition planar_radius orthogonal_radius feature_boundary"},
    {"OPEN_POCKET", FEATURE_HEAD
     "its_boss slope bottom_condition planar_radius orthogonal_radius open_boundary wall_boundary"},
    {"STEP", FEATURE_HEAD "open_boundary wall_boundary its_boss"},
    {"SLOT", FEATURE_HEAD "course_of_travel swept_shape end_conditions"},
    {"ROUND_HOLE", FEATURE_HEAD "diameter change_in_diameter bottom_condition"},
    {"CHAMFER",
     "~its_id its_workpiece ~its_operations first_feature second_feature angle_to_plane first_offset_amount"},
    {"CATALOGUE_THREAD", FEATURE_HEAD THREAD_TAIL "~documentation"},
    {"DEFINED_THREAD", FEATURE_HEAD THREAD_TAIL "?pitch_diameter ?minor_diameter ?crest"},
    {"PARTIAL_AREA_DEFINITION", "effective_length ?placement ?maximum_length"},
    {"BOSS", "~its_id its_workpiece ~its_operations feature_placement ~depth its_boundary slope"},
    {"GENERAL_OUTSIDE_PROFILE", FEATURE_HEAD "~profile_swept_shape feature_boundary"},
    {"CIRCULAR_CLOSED_SHAPE_PROFILE",
     FEATURE_HEAD "~profile_swept_shape floor_condition ~removal_direction closed_boundary"},
    {"RECTANGULAR_CLOSED_SHAPE_PROFILE",
     FEATURE_HEAD "~profile_swept_shape floor_condition ~removal_direction closed_boundary"},
    {"GENERAL_SHAPE_PROFILE",
     FEATURE_HEAD "~profile_swept_shape floor_condition ~removal_direction profile_boundary"},
    {"PARTIAL_CIRCULAR_SHAPE_PROFILE",
     FEATURE_HEAD "~profile_swept_shape floor_condition ~removal_direction open_boundary"},
    {"RECTANGULAR_OPEN_SHAPE_PROFILE",
     FEATURE_HEAD "~profile_swept_shape floor_condition ~removal_direction open_boundary"},
    {"CIRCULAR_PATTERN",
     "~its_id its_workpiece ~its_operations feature_placement replicate_base_feature angle_increment "
     "number_of_feature relocated_base_feature missing_base_feature base_feature_diameter "
     "base_feature_rotation"},
    {"RECTANGULAR_PATTERN",
     "~its_id its_workpiece ~its_operations feature_placement replicate_base_feature spacing its_direction "
     "number_of_rows number_of_columns row_spacing row_layout_direction relocated_base_feature "
     "missing_base_feature"},
    {"GENERAL_PATTERN",
     "~its_id its_workpiece ~its_operations feature_placement replicate_base_feature replicate_locations"},
    {"COMPOUND_FEATURE", "~its_id its_workpiece ~its_operations feature_placement elements elements"},
    {"COUNTERBORE_HOLE",
     "~its_id its_workpiece ~its_operations feature_placement elements elements constituents constituents"},
    {"COUNTERSUNK_HOLE",
     "~its_id its_workpiece ~its_operations feature_placement elements elements constituents constituents"},
    {"FLAT_WITH_RADIUS_HOLE_BOTTOM", "corner_radius"},
    {"SPHERICAL_HOLE_BOTTOM", "radius"},
    {"CONICAL_HOLE_BOTTOM", "tip_angle tip_radius"},
    {"FLAT_SLOT_END_TYPE", "?corner_radius_1 ?corner_radius_2"},
    {"GENERAL_CLOSED_PROFILE", "placement closed_profile_shape"},
    {"CIRCULAR_CLOSED_PROFILE", "placement diameter"},
    {"RECTANGULAR_CLOSED_PROFILE", "placement profile_width profile_length"},
    {"NGON_CLOSED_PROFILE", "placement diameter number_of_sides circumscribed_or_across_flats"},
    {"NGON_PROFILE", "placement diameter number_of_sides circumscribed_or_across_flats"},
    {"GENERAL_PROFILE", "placement its_profile"},
    {"LINEAR_PROFILE", "~placement profile_length"},
    {"PARTIAL_CIRCULAR_PROFILE", "placement radius sweep_angle"},
    {"SQUARE_U_PROFILE", "~placement width first_radius first_angle second_radius second_angle"},
    {"ROUNDED_U_PROFILE", "~placement width"},
    {"VEE_PROFILE", "~placement profile_radius profile_angle tilt_angle"},
    {"TEE_PROFILE",
     "~placement first_angle second_angle cross_bar_width cross_bar_depth radius width first_offset "
     "second_offset"},
    {"LINEAR_PATH", "placement distance its_direction"},
    {"GENERAL_PATH", "placement swept_path"},
    {"PARTIAL_CIRCULAR_PATH", "placement radius sweep_angle"},
    {"COMPLETE_CIRCULAR_PATH", "placement radius"},
    {"REGION_PROJECTION",
     "~its_id its_workpiece ~its_operations feature_placement proj_curve proj_dir depth"},
    {"FREEFORM_OPERATION", OPERATION_HEAD "approach retract its_machining_strategy"},
    {"PLANE_MILLING", MILLING_HEAD "allowance_bottom"},
    {"PLANE_ROUGH_MILLING", MILLING_HEAD "allowance_bottom"},
    {"PLANE_FINISH_MILLING", MILLING_HEAD "allowance_bottom"},
    {"SIDE_MILLING", MILLING_HEAD "radial_cutting_depth allowance_side"},
    {"SIDE_ROUGH_MILLING", MILLING_HEAD "radial_cutting_depth allowance_side"},
    {"SIDE_FINISH_MILLING", MILLING_HEAD "radial_cutting_depth allowance_side"},
    {"BOTTOM_AND_SIDE_MILLING", MILLING_HEAD "radial_cutting_depth allowance_side allowance_bottom"},
    {"BOTTOM_AND_SIDE_ROUGH_MILLING", MILLING_HEAD "radial_cutting_depth allowance_side allowance_bottom"},
    {"BOTTOM_AND_SIDE_FINISH_MILLING", MILLING_HEAD "radial_cutting_depth allowance_side allowance_bottom"},
    {"DRILLING", DRILLING_HEAD},
    {"CENTER_DRILLING", DRILLING_HEAD},
    {"COUNTER_SINKING", DRILLING_HEAD},
    {"MULTISTEP_DRILLING", DRILLING_HEAD "?retract_distance ?first_depth depth_of_step ?dwell_time_step"},
    {"BORING", DRILLING_HEAD "?spindle_stop_at_bottom ?depth_of_testcut ?waiting_position"},
    {"REAMING", DRILLING_HEAD "?spindle_stop_at_bottom ?depth_of_testcut ?waiting_position"},
    {"TAPPING", DRILLING_HEAD "compensation_chuck"},
    {"DRILLING_TYPE_STRATEGY",
     "?reduced_cut_at_start reduced_feed_at_start depth_of_start ?reduced_cut_at_end reduced_feed_at_end "
     "depth_of_end"},
    {"UNIDIRECTIONAL_MILLING", STRATEGY_HEAD "?feed_direction ?cutmode"},
    {"UNIDIRECTIONAL", STRATEGY_HEAD "?feed_direction ?cutmode"},
    {"BIDIRECTIONAL_MILLING",
     STRATEGY_HEAD "?feed_direction ?stepover_direction ?its_stroke_connection_strategy"},
    {"BIDIRECTIONAL", STRATEGY_HEAD "?feed_direction ?stepover_direction ?its_stroke_connection_strategy"},
    {"CONTOUR_PARALLEL", STRATEGY_HEAD "?rotation_direction ?cutmode"},
    {"BIDIRECTIONAL_CONTOUR",
     STRATEGY_HEAD "?feed_direction ?stepover_direction ?rotation_direction ?spiral_cutmode"},
    {"CONTOUR_BIDIRECTIONAL",
     STRATEGY_HEAD "?feed_direction ?stepover_direction ?rotation_direction ?spiral_cutmode"},
    {"CONTOUR_SPIRAL", STRATEGY_HEAD "?rotation_direction ?cutmode"},
    {"CENTER_MILLING", STRATEGY_HEAD},
    {"EXPLICIT_STRATEGY", STRATEGY_HEAD},
    {"PLUNGE_TOOLAXIS", "~tool_orientation"},
    {"PLUNGE_RAMP", "~tool_orientation ?angle"},
    {"PLUNGE_HELIX", "~tool_orientation ?radius ?angle"},
    {"PLUNGE_ZIGZAG", "~tool_orientation ?angle ?width"},
    {"AP_RETRACT_ANGLE", "~tool_orientation ?angle ?travel_length"},
    {"AP_RETRACT_TANGENT", "~tool_orientation ?radius"},
    {"AP_LIFT_PATH_ANGLE", "~tool_orientation ?angle ?benchmark"},
    {"AP_LIFT_PATH_TANGENT", "~tool_orientation ?radius"},
    {"MILLING_TECHNOLOGY",
     "feedrate ?feedrate_reference ~cutspeed spindle ~feedrate_per_tooth ?synchronize_spindle_with_feed "
     "~inhibit_feedrate_override ~inhibit_spindle_override ~its_adaptive_control"},
    {"MILLING_MACHINE_FUNCTIONS",
     "coolant ~coolant_pressure mist through_spindle_coolant ~through_pressure ~axis_clamping ~chip_removal "
     "?oriented_spindle_stop ~its_process_model other_functions"},
    {"NUMERIC_PARAMETER", "~parameter_name its_parameter_value ~its_parameter_unit"},
    {"DESCRIPTIVE_PARAMETER", "~parameter_name descriptive_string"},
    {"MILLING_CUTTING_TOOL",
     "its_id its_tool_body ~its_cutting_edge ~overall_assembly_length ~direction_for_spindle_orientation "
     "~tool_holder_diameter_for_spindle_orientation"},
    {"MILLING_TOOL_DIMENSION",
     "diameter ?tool_top_angle ?tool_circumference_angle cutting_edge_length ?edge_radius "
     "~edge_center_vertical ~edge_center_horizontal"},
    {"TOOL_DIMENSION",
     "diameter ?tool_top_angle ?tool_circumference_angle cutting_edge_length ?edge_radius "
     "~edge_center_vertical ~edge_center_horizontal"},
    {"ENDMILL", BODY_HEAD},
    {"BALL_ENDMILL", BODY_HEAD},
    {"BULLNOSE_ENDMILL", BODY_HEAD},
    {"FACEMILL", BODY_HEAD},
    {"TAPERED_ENDMILL", BODY_HEAD "taper_angle"},
    {"TWIST_DRILL", BODY_HEAD},
    {"SPADE_DRILL", BODY_HEAD},
    {"CENTER_DRILL", BODY_HEAD},
    {"TAPERED_DRILL", BODY_HEAD "?taper_angle"},
    {"REAMER", BODY_HEAD},
    {"TAPERED_REAMER", BODY_HEAD "?taper_angle"},
    {"COUNTERSINK", BODY_HEAD "?countersink_radius"},
    {"BORING_TOOL", BODY_HEAD},
    {"TAP", BODY_HEAD},
    {"COUNTERBORE", BODY_HEAD},
    {"T_SLOT_MILL", BODY_HEAD "cutting_thickness"},
    {"WOODRUFF_KEYSEAT_MILL", BODY_HEAD "cutting_thickness"},
    {"TOOLPATH_LIST", "its_list"},
    {"CUTTER_LOCATION_TRAJECTORY", TOOLPATH_HEAD "its_direction basiccurve its_toolaxis ~surface_normal"},
    {"CUTTER_CONTACT_TRAJECTORY", TOOLPATH_HEAD "its_direction basiccurve its_toolaxis ?its_contact_type"},
    {"CURVE_WITH_NORMAL", "basiccurve ~surface_normal"},
    {"CONNECT_DIRECT", TOOLPATH_HEAD},
    {"FEEDSTOP", TOOLPATH_HEAD "dwell"},
    {"TOOLPATH_SPEED", "speed"},
    {"CARTESIAN_POINT", "~name coordinates"},
    {"DIRECTION", "~name direction_ratios"},
    {"VECTOR", "~name orientation magnitude"},
    {"AXIS2_PLACEMENT_3D", "~name location axis ref_direction"},
    {"AXIS2_PLACEMENT_2D", "~name location ref_direction"},
    {"AXIS1_PLACEMENT", "~name location axis"},
    {"PLANE", "~name position"},
    {"ELEMENTARY_SURFACE", "~name position"},
    {"BLOCK", "~name position x y z"},
    {"RIGHT_CIRCULAR_CYLINDER", "~name position height radius"},
    {"LINE", "~name pnt dir"},
    {"CIRCLE", "~name position radius"},
    {"ELLIPSE", "~name position semi_axis_1 semi_axis_2"},
    {"POLYLINE", "~name points"},
    {"COMPOSITE_CURVE", "~name segments ~self_intersect"},
    {"COMPOSITE_CURVE_SEGMENT", "~transition same_sense parent_curve"},
    {"TRIMMED_CURVE", "~name basis_curve trim_1 trim_2 sense_agreement ~master_representation"},
    {"B_SPLINE_CURVE_WITH_KNOTS",
     "~name degree control_points_list ~curve_form ~closed_curve ~self_intersect knot_multiplicities knots "
     "~knot_spec"},
    {"BEZIER_CURVE", "~name degree control_points_list ~curve_form ~closed_curve ~self_intersect"},
    {"TOLERANCED_LENGTH_MEASURE", "theoretical_size implicit_tolerance"},
    {"PLUS_MINUS_VALUE", "upper_limit lower_limit ~significant_digits"},
    {"LIMITS_AND_FITS", "?deviation ?grade ?its_fitting_type"},
};

#undef FEATURE_HEAD
#undef THREAD_TAIL
#undef OPERATION_HEAD
#undef MILLING_HEAD
#undef DRILLING_HEAD
#undef STRATEGY_HEAD
#undef BODY_HEAD
#undef TOOLPATH_HEAD

struct Attribute {
  std::string name;
  Weight weight = Weight::kPart;
};

/// The attribute's word in the row; nothing after its last one.
std::optional<std::string_view> word_of(std::string_view words, std::size_t number) {
  for (; !words.empty();) {
    const std::size_t blank = std::min(words.find(' '), words.size());
    const std::string_view word = words.substr(0, blank);
    words.remove_prefix(std::min(blank + 1, words.size()));
    if (word.empty()) continue;
    if (number == 0) return word;
    --number;
  }
  return std::nullopt;
}

Attribute attribute_of(const Node& node, std::size_t argument) {
  for (const EntityRow& row : kEntities) {
    if (!node.is(row.keyword)) continue;
    const auto word = word_of(row.attributes, argument);
    if (!word) break;
    if (word->front() == '~') return {std::string(word->substr(1)), Weight::kAnnotation};
    if (word->front() == '?') return {std::string(word->substr(1)), Weight::kManner};
    return {std::string(*word), Weight::kPart};
  }
  return {"argument " + std::to_string(argument + 1), Weight::kPart};
}

/// Whether the value asks for nothing: unset, empty, zero, .F.
bool asks_nothing(const P21Value& value) {
  switch (value.kind) {
    case P21Kind::kUnset:
    case P21Kind::kDerived:
      return true;
    case P21Kind::kInteger:
    case P21Kind::kReal:
      return value.number == 0;
    case P21Kind::kString:
      return value.text.empty();
    case P21Kind::kEnum:
      return value.text == "F" || value.text == "f" || value.text == "FALSE";
    case P21Kind::kList:
      return value.count == 0;
    default:
      return false;
  }
}

class Walk {
 public:
  explicit Walk(Context& context) : context_(context) {}

  void from(const Node& start) {
    reach(start.id());
    while (!waiting_.empty()) {
      const std::uint64_t id = waiting_.back();
      waiting_.pop_back();
      const P21Entity* entity = context_.file.find(id);
      if (entity != nullptr && entity->records == 1) visit(Node(context_.file, *entity));
    }
  }

  void tell() {
    for (const Group& group : groups_) tell(group);
    if (labels_ > 0)
      context_.diagnostics.note(context_.file.name,
                                "names of " + std::to_string(labels_) + " entities are labels and not used");
  }

 private:
  struct Group {
    std::string keyword;
    Attribute attribute;
    std::vector<std::string> entities;  ///< "#3 (line 9) 0.01"
    int first_line = 0;
    std::size_t more = 0;
  };

  void reach(std::uint64_t id) {
    if (!context_.is_said(id) && reached_.insert(id).second) waiting_.push_back(id);
  }

  void reach_all(const P21Value& value) {
    if (value.kind == P21Kind::kReference) return reach(value.id);
    if (value.kind != P21Kind::kList && value.kind != P21Kind::kTyped) return;
    for (const P21Value& inner : context_.file.children(value)) reach_all(inner);
  }

  void visit(const Node& node) {
    for (std::size_t i = 0; i < node.arguments(); ++i) {
      const P21Value value = node.peek(i);
      if (node.is_used(i)) {
        reach_all(value);
      } else if (!asks_nothing(value) && !is_all_said(value)) {
        add(node, i, value);
      }
    }
  }

  bool is_all_said(const P21Value& value) const {
    return value.kind == P21Kind::kReference && context_.is_said(value.id);
  }

  void add(const Node& node, std::size_t argument, const P21Value& value) {
    const Attribute attribute = attribute_of(node, argument);
    const bool is_label = value.kind == P21Kind::kString && argument == 0;
    if (is_label && attribute.weight == Weight::kAnnotation) {
      ++labels_;
      return;
    }
    auto group = std::find_if(groups_.begin(), groups_.end(), [&](const Group& one) {
      return one.keyword == node.keyword() && one.attribute.name == attribute.name;
    });
    if (group == groups_.end())
      group = groups_.insert(groups_.end(), {node.keyword(), attribute, {}, node.line(), 0});
    if (group->entities.size() == kNamed) {
      ++group->more;
      return;
    }
    std::string shown = node.shown(argument);
    if (attribute.weight == Weight::kAnnotation && shown.size() > kShownOfAnnotations)
      shown = shown.substr(0, kShownOfAnnotations) + " ...";
    group->entities.push_back("#" + std::to_string(node.id()) + " (line " + std::to_string(node.line()) +
                              ") " + shown);
  }

  void tell(const Group& group) {
    std::string text = group.keyword + ": " + group.attribute.name;
    for (std::size_t i = 0; i < group.entities.size(); ++i)
      text += (i == 0 ? " of " : "; of ") + group.entities[i];
    if (group.more > 0) text += "; of " + std::to_string(group.more) + " more";
    const std::string place = context_.file.place(group.first_line);
    if (group.attribute.weight == Weight::kAnnotation)
      context_.diagnostics.note(place, "not used, an annotation: " + text);
    else if (group.attribute.weight == Weight::kManner)
      context_.diagnostics.warn(place, "not followed: " + text);
    else
      context_.diagnostics.doubt(place, kNotFollowed, "not followed: " + text);
  }

  Context& context_;
  std::set<std::uint64_t> reached_;
  std::vector<std::uint64_t> waiting_;
  std::vector<Group> groups_;
  std::size_t labels_ = 0;
};

}  // namespace

std::span<const EntityRow> entity_rows() {
  return kEntities;
}

void name_what_is_not_used(const Node& start, Context& context) {
  Walk walk(context);
  walk.from(start);
  walk.tell();
}

}  // namespace clearcut::read::stepnc
