#include "read/stepnc/file/entity_list.h"

namespace clearcut::read::stepnc {
namespace {

enum class Treatment {
  kPlanned,  ///< read, and in the program
  kSaid,     ///< not in the program; named in the diagnostics or in the verdict
  kRefused   ///< leaves out the workingstep that needs it
};
using enum Treatment;

/// One kind of entity; the rows are in the order of the documentation.
struct ListedEntity {
  std::string_view keyword;
  Treatment treatment = kPlanned;
  const char* reason = "";  ///< what is said of it, or what to do instead
};

constexpr const char* kByHand = "not carried out: the condition `not-followed`";
constexpr const char* kFreeForm = "it is a free-form surface; write flat parts of it as pockets or faces";
constexpr const char* kFormCutter = "cutters of this kind are not planned with; give an end mill";
constexpr const char* kProbing = "it is no machining workingstep; leave it to its machine";

constexpr ListedEntity kListed[] = {
    // The program and its order.
    {"PROJECT"},
    {"WORKPLAN"},
    {"MACHINING_WORKINGSTEP"},
    {"NON_SEQUENTIAL"},
    {"PARALLEL"},
    {"SELECTIVE"},
    {"IF_STATEMENT"},
    {"PROGRAM_STOP"},
    {"OPTIONAL_STOP"},
    {"DISPLAY_MESSAGE"},
    {"WHILE_STATEMENT", kSaid,
     "its workingsteps are not machined, unless its condition is known to be false"},
    {"ASSIGNMENT", kSaid, kByHand},
    {"RAPID_MOVEMENT", kSaid, kByHand},
    {"RETURN_HOME", kSaid, kByHand},
    {"LOAD_TOOL", kSaid, "tools are changed where the next step needs another"},
    {"UNLOAD_TOOL", kSaid, "tools are changed where the next step needs another"},
    {"EXCHANGE_PALLET", kSaid, kByHand},
    {"INDEX_PALLET", kSaid, kByHand},
    {"INDEX_TABLE", kSaid, kByHand},
    {"SET_MARK", kSaid, kByHand},
    {"WAIT_FOR_MARK", kSaid, kByHand},
    {"WORKPIECE_PROBING", kRefused, kProbing},
    {"WORKPIECE_COMPLETE_PROBING", kRefused, kProbing},
    {"TOOL_PROBING", kRefused, kProbing},
    // Set-ups and the workpiece.
    {"WORKPIECE"},
    {"SETUP"},
    {"WORKPIECE_SETUP"},
    {"BLOCK"},
    {"RIGHT_CIRCULAR_CYLINDER"},
    {"OFFSET_VECTOR", kSaid, "the place of the workpiece on the machine is reported"},
    {"SETUP_INSTRUCTION", kSaid, "a warning with its text"},
    {"MATERIAL", kSaid,
     "an annotation; where a feed or speed is missing, that for the material, if its name is recognised"},
    // Features.
    {"PLANAR_FACE"},
    {"CLOSED_POCKET"},
    {"OPEN_POCKET"},
    {"SLOT"},
    {"STEP"},
    {"ROUND_HOLE"},
    {"BOSS"},
    {"GENERAL_OUTSIDE_PROFILE"},
    {"CIRCULAR_CLOSED_SHAPE_PROFILE"},
    {"RECTANGULAR_CLOSED_SHAPE_PROFILE"},
    {"GENERAL_SHAPE_PROFILE"},
    {"PARTIAL_CIRCULAR_SHAPE_PROFILE"},
    {"RECTANGULAR_OPEN_SHAPE_PROFILE"},
    {"COMPOUND_FEATURE"},
    {"COUNTERBORE_HOLE"},
    {"COUNTERSUNK_HOLE"},
    {"CIRCULAR_PATTERN"},
    {"RECTANGULAR_PATTERN"},
    {"GENERAL_PATTERN"},
    {"CATALOGUE_THREAD"},
    {"DEFINED_THREAD"},
    {"CHAMFER"},
    {"REGION_PROJECTION"},
    {"EDGE_ROUND", kRefused,
     "an edge is rounded with a form cutter along it, which is not planned; round it by hand, add the pass, "
     "or write it as a CHAMFER"},
    {"THREAD", kRefused, "it says no size; write it as CATALOGUE_THREAD or DEFINED_THREAD"},
    {"ROUNDED_END", kRefused,
     "its wall is round from the side and is no 2.5-D feature; write it as a pocket or step"},
    {"SPHERICAL_CAP", kRefused, "a ball is no 2.5-D feature; it needs free-form milling"},
    {"TOOLPATH_FEATURE", kRefused,
     "it is only a path; write what is to be removed as a pocket, face, slot or step"},
    {"REGION_SURFACE_LIST", kRefused, kFreeForm},
    {"TOPOLOGICAL_REGION", kRefused, kFreeForm},
    {"GENERAL_FREEFORM", kRefused, kFreeForm},
    // Their ends, bottoms and tapers.
    {"PLANAR_POCKET_BOTTOM_CONDITION"},
    {"THROUGH_POCKET_BOTTOM_CONDITION"},
    {"FLAT_HOLE_BOTTOM"},
    {"THROUGH_BOTTOM_CONDITION"},
    {"CONICAL_HOLE_BOTTOM"},
    {"SPHERICAL_HOLE_BOTTOM"},
    {"FLAT_WITH_RADIUS_HOLE_BOTTOM"},
    {"DIAMETER_TAPER"},
    {"ANGLE_TAPER"},
    {"OPEN_SLOT_END_TYPE"},
    {"RADIUSED_SLOT_END_TYPE"},
    {"FLAT_SLOT_END_TYPE"},
    {"LOOP_SLOT_END_TYPE"},
    {"WOODRUFF_SLOT_END_TYPE", kRefused,
     "this end of a slot rises in an arc about a level axis, and only a disc on that axis makes it; write "
     "the "
     "end as open, round or flat"},
    {"GENERAL_POCKET_BOTTOM_CONDITION", kRefused,
     "the pocket's bottom is a free-form surface and cannot be machined yet; write what lies above it as a "
     "flat "
     "pocket"},
    {"RADIUSED_POCKET_BOTTOM_CONDITION", kRefused,
     "the pocket's bottom is rounded and cannot be machined yet; write what lies above it as a flat pocket"},
    // Profiles, paths and curves.
    {"GENERAL_CLOSED_PROFILE"},
    {"CIRCULAR_CLOSED_PROFILE"},
    {"RECTANGULAR_CLOSED_PROFILE"},
    {"NGON_PROFILE"},
    {"GENERAL_PROFILE"},
    {"LINEAR_PROFILE"},
    {"PARTIAL_CIRCULAR_PROFILE"},
    {"SQUARE_U_PROFILE"},
    {"ROUNDED_U_PROFILE"},
    {"VEE_PROFILE"},
    {"TEE_PROFILE"},
    {"LINEAR_PATH"},
    {"GENERAL_PATH"},
    {"PARTIAL_CIRCULAR_PATH"},
    {"COMPLETE_CIRCULAR_PATH"},
    {"POLYLINE"},
    {"TRIMMED_CURVE"},
    {"COMPOSITE_CURVE"},
    {"CIRCLE"},
    {"ELLIPSE"},
    {"B_SPLINE_CURVE_WITH_KNOTS"},
    {"BEZIER_CURVE"},
    {"TOLERANCED_LENGTH_MEASURE"},
    // Operations.
    {"PLANE_MILLING"},
    {"PLANE_ROUGH_MILLING"},
    {"PLANE_FINISH_MILLING"},
    {"SIDE_MILLING"},
    {"SIDE_ROUGH_MILLING"},
    {"SIDE_FINISH_MILLING"},
    {"BOTTOM_AND_SIDE_MILLING"},
    {"BOTTOM_AND_SIDE_ROUGH_MILLING"},
    {"BOTTOM_AND_SIDE_FINISH_MILLING"},
    {"DRILLING"},
    {"CENTER_DRILLING"},
    {"COUNTER_SINKING"},
    {"MULTISTEP_DRILLING"},
    {"BORING"},
    {"REAMING"},
    {"TAPPING"},
    {"THREAD_DRILLING", kRefused,
     "one tool that drills and cuts the thread is not planned; give DRILLING and TAPPING"},
    {"BACK_BORING", kRefused, "boring from below is not planned; bore it afterwards"},
    {"FREEFORM_OPERATION", kRefused,
     "free-form milling is that of a level REGION_PROJECTION alone; mill flat parts as pockets or faces"},
    {"FREEFORM_MILLING", kRefused,
     "free-form milling cannot be machined yet; mill flat parts as pockets or faces"},
    // How they cut.
    {"UNIDIRECTIONAL_MILLING"},
    {"BIDIRECTIONAL_MILLING"},
    {"CONTOUR_PARALLEL"},
    {"BIDIRECTIONAL_CONTOUR"},
    {"CONTOUR_SPIRAL"},
    {"EXPLICIT_STRATEGY"},
    {"DRILLING_TYPE_STRATEGY"},
    {"CONTOUR_BIDIRECTIONAL", kSaid, "not among our strategies: the fastest of ours is planned"},
    {"CENTER_MILLING", kSaid, "not among our strategies: the fastest of ours is planned"},
    {"PLUNGE_TOOLAXIS"},
    {"PLUNGE_RAMP"},
    {"PLUNGE_HELIX"},
    {"PLUNGE_ZIGZAG"},
    {"AP_RETRACT_ANGLE"},
    {"AP_RETRACT_TANGENT"},
    {"AP_LIFT_PATH_ANGLE", kSaid, "entered along a ramp"},
    {"AP_LIFT_PATH_TANGENT", kSaid, "entered along a ramp"},
    {"ALONG_PATH", kSaid, "the planner chooses the entry"},
    {"MILLING_TECHNOLOGY"},
    {"MILLING_MACHINE_FUNCTIONS"},
    {"THREE_AXES"},
    {"TOOLPATH_LIST"},
    {"CUTTER_LOCATION_TRAJECTORY"},
    {"CUTTER_CONTACT_TRAJECTORY"},
    {"FEEDSTOP"},
    {"CONNECT_DIRECT"},
    {"TOOLPATH_SPEED"},
    {"AXIS_TRAJECTORY", kRefused,
     "toolpaths of this kind are not followed; write CUTTER_LOCATION_TRAJECTORY"},
    {"CONNECT_SECPLANE", kRefused,
     "toolpaths of this kind are not followed; write CUTTER_LOCATION_TRAJECTORY"},
    // Tools.
    {"MILLING_CUTTING_TOOL"},
    {"MILLING_TOOL_DIMENSION"},
    {"ENDMILL"},
    {"TAPERED_ENDMILL"},
    {"BALL_ENDMILL"},
    {"BULLNOSE_ENDMILL"},
    {"FACEMILL"},
    {"TWIST_DRILL"},
    {"SPADE_DRILL"},
    {"CENTER_DRILL"},
    {"TAPERED_DRILL"},
    {"REAMER"},
    {"TAPERED_REAMER"},
    {"BORING_TOOL"},
    {"COUNTERSINK"},
    {"TAP"},
    {"COUNTERBORE"},
    {"T_SLOT_MILL"},
    {"WOODRUFF_KEYSEAT_MILL"},
    {"SIDE_MILL", kRefused, kFormCutter},
    {"DOVETAIL_MILL", kRefused, kFormCutter},
    {"THREAD_MILL", kRefused, "threads are cut with a TAP; give one, and TAPPING"},
    {"PROFILED_END_MILL", kRefused, kFormCutter},
    {"COMBINED_DRILL_AND_TAP", kRefused, "give a TWIST_DRILL and a TAP"},
    {"COMBINED_DRILL_AND_REAMER", kRefused, "give a TWIST_DRILL and a REAMER"},
};

std::string rows_with_reason(Treatment treatment, const char* heading) {
  std::string text = std::string("| ") + heading + " | |\n|--|--|\n";
  for (const ListedEntity& one : kListed)
    if (one.treatment == treatment) text += "| " + std::string(one.keyword) + " | " + one.reason + " |\n";
  return text;
}

}  // namespace

void refuse_listed(const Node& node) {
  for (const ListedEntity& one : kListed)
    if (one.treatment == kRefused && node.is(one.keyword)) node.fail(one.reason);
}

std::string entity_tables() {
  constexpr std::size_t kInRow = 4;
  std::string text = "| read and planned | | | |\n|--|--|--|--|\n";
  std::size_t column = 0;
  for (const ListedEntity& one : kListed) {
    if (one.treatment != kPlanned) continue;
    text += (column == 0 ? "| " : "") + std::string(one.keyword) + " |";
    column = (column + 1) % kInRow;
    text += column == 0 ? "\n" : " ";
  }
  for (; column != 0 && column < kInRow; ++column) text += column + 1 < kInRow ? "| " : "|\n";
  return text + "\n" + rows_with_reason(kSaid, "read and said") + "\n" +
         rows_with_reason(kRefused, "refused by name");
}

}  // namespace clearcut::read::stepnc
