// Nothing that a STEP-NC file says is passed over in silence: each attribute of a file, changed or taken away alone, changes the program, a line of
// the verdict or what is said besides, or it is among the attributes that are known to be annotations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "pipeline/run.h"
#include "read/stepnc/file/entity_list.h"
#include "read/stepnc/stepnc.h"
#include "support/data.h"

namespace clearcut {
namespace {

using read::stepnc::EntityRow;

/// A part that uses as many kinds of attributes as fit: a pocket with a low boss, drilled and centred holes, stops, a set-up with everything.
const char* const kExample[] = {
    "#1=PROJECT('MUTATED',#2,(#3),#200,$,$)",
    "#2=WORKPLAN('MAIN',(#20,#21,#22,#23,#24),$,#4,$)",
    "#3=WORKPIECE('PLATE',#5,0.01,$,$,#6,(#7))",
    "#200=PERSON_AND_ADDRESS($,$)",
    "#4=SETUP('VICE',#8,#9,(#10))",
    "#5=MATERIAL('6061','ALUMINIUM',(#11))",
    "#11=DESCRIPTIVE_PARAMETER('TEMPER','T6')",
    "#6=BLOCK('BLANK',#12,60.,40.,12.)",
    "#7=CARTESIAN_POINT('CLAMP',(0.,20.,8.))",
    "#8=AXIS2_PLACEMENT_3D('TABLE',#13,#14,#15)",
    "#9=PLANE('SECURITY',#16)",
    "#10=WORKPIECE_SETUP(#3,#17,#18,#19,(#30))",
    "#12=AXIS2_PLACEMENT_3D('',#31,#14,#15)",
    "#31=CARTESIAN_POINT('',(0.,0.,0.))",
    "#13=CARTESIAN_POINT('',(100.,50.,10.))",
    "#14=DIRECTION('',(0.,0.,1.))",
    "#15=DIRECTION('',(1.,0.,0.))",
    "#16=AXIS2_PLACEMENT_3D('',#32,#14,#15)",
    "#32=CARTESIAN_POINT('',(0.,0.,40.))",
    "#17=AXIS2_PLACEMENT_3D('',#33,#14,#15)",
    "#33=CARTESIAN_POINT('',(1.,2.,3.))",
    "#18=OFFSET_VECTOR((4.,5.,6.),$)",
    "#19=BLOCK('JAW',#34,60.,4.,14.)",
    "#34=AXIS2_PLACEMENT_3D('',#35,#14,#15)",
    "#35=CARTESIAN_POINT('',(0.,40.,0.))",
    "#30=SETUP_INSTRUCTION('20 NM','VICE.PDF')",
    "#20=MACHINING_WORKINGSTEP('ROUGH',#9,#40,#41,$)",
    "#21=PROGRAM_STOP('CLEAR THE CHIPS')",
    "#22=DISPLAY_MESSAGE('MSG','HOLES NEXT')",
    "#23=MACHINING_WORKINGSTEP('CENTRE',#9,#42,#43,$)",
    "#24=MACHINING_WORKINGSTEP('DRILL',#9,#42,#44,$)",
    // The pocket.
    "#40=CLOSED_POCKET('POCKET',#3,(#41),#45,#46,(#47),0.,#48,$,#49,#50)",
    "#45=AXIS2_PLACEMENT_3D('',#51,#14,#15)",
    "#51=CARTESIAN_POINT('',(22.,20.,12.))",
    "#46=PLANE('',#52)",
    "#52=AXIS2_PLACEMENT_3D('',#53,#14,#15)",
    "#53=CARTESIAN_POINT('',(0.,0.,-4.))",
    "#47=BOSS('BOSS',#3,(),#54,#46,#55,$)",
    "#54=AXIS2_PLACEMENT_3D('',#56,#14,#15)",
    "#56=CARTESIAN_POINT('',(0.,0.,-2.))",
    "#55=CIRCULAR_CLOSED_PROFILE($,#57)",
    "#57=TOLERANCED_LENGTH_MEASURE(6.,#58)",
    "#58=PLUS_MINUS_VALUE(0.1,0.1,3)",
    "#48=PLANAR_POCKET_BOTTOM_CONDITION()",
    "#49=TOLERANCED_LENGTH_MEASURE(5.,#59)",
    "#59=PLUS_MINUS_VALUE(0.1,0.1,3)",
    "#50=RECTANGULAR_CLOSED_PROFILE(#60,#61,#62)",
    "#60=AXIS2_PLACEMENT_3D('',#63,#14,#15)",
    "#63=CARTESIAN_POINT('',(0.,0.,0.))",
    "#61=TOLERANCED_LENGTH_MEASURE(22.,#64)",
    "#64=PLUS_MINUS_VALUE(0.3,0.1,3)",
    "#62=TOLERANCED_LENGTH_MEASURE(26.,#65)",
    "#65=PLUS_MINUS_VALUE(0.1,0.1,3)",
    "#41=BOTTOM_AND_SIDE_ROUGH_MILLING($,#66,'OP',5.,#67,#68,#69,#70,1.,#71,#72,#73,2.,2.5,0.1,0.2)",
    "#66=THREE_AXES()",
    "#67=CARTESIAN_POINT('',(3.,3.,0.))",
    "#71=PLUNGE_RAMP($,0.08)",
    "#72=AP_RETRACT_TANGENT($,1.)",
    "#73=CONTOUR_PARALLEL(0.5,.T.,.CCW.,.CLIMB.)",
    "#68=MILLING_CUTTING_TOOL('T1 MILL',#74,(#75),90.,$,$)",
    "#74=ENDMILL(#76,3,.RIGHT.,.F.,$)",
    "#75=CUTTING_COMPONENT(80.,$,$,$,$)",
    "#76=MILLING_TOOL_DIMENSION(5.,$,$,20.,0.5,0.5,2.)",
    "#69=MILLING_TECHNOLOGY(0.015,.TCP.,$,-100.,$,.F.,.F.,.F.,$)",
    "#70=MILLING_MACHINE_FUNCTIONS(.T.,300000.,.F.,.F.,$,('A'),.T.,$,$,(#77))",
    "#77=NUMERIC_PARAMETER('PLUNGE FEED',250.,'MM/MIN')",
    // The hole.
    "#42=ROUND_HOLE('HOLE',#3,(#43,#44),#80,#81,#82,$,#83)",
    "#80=AXIS2_PLACEMENT_3D('',#84,#14,#15)",
    "#84=CARTESIAN_POINT('',(48.,20.,12.))",
    "#81=PLANE('',#85)",
    "#85=AXIS2_PLACEMENT_3D('',#86,#14,#15)",
    "#86=CARTESIAN_POINT('',(0.,0.,-9.))",
    "#82=TOLERANCED_LENGTH_MEASURE(4.,#87)",
    "#87=PLUS_MINUS_VALUE(0.05,0.05,3)",
    "#83=CONICAL_HOLE_BOTTOM(2.0594885,$)",
    "#43=CENTER_DRILLING($,$,'SPOT',4.,#88,#89,#90,#91,$,1.5,$,$,$,$)",
    "#88=CARTESIAN_POINT('',(0.,0.,0.))",
    "#89=MILLING_CUTTING_TOOL('T2 CENTRE',#92,(),60.,$,$)",
    "#92=CENTER_DRILL(#93,2,.RIGHT.,.F.,$)",
    "#93=MILLING_TOOL_DIMENSION(3.,0.5236,$,12.,$,$,$)",
    "#90=MILLING_TECHNOLOGY(0.003,.TCP.,$,-40.,$,.F.,.F.,.F.,$)",
    "#91=MILLING_MACHINE_FUNCTIONS(.T.,$,$,.F.,$,(),.F.,$,$,())",
    "#44=DRILLING($,$,'DRILL',3.,$,#94,#95,#96,$,7.,3.,1.5,0.5,#97)",
    "#94=MILLING_CUTTING_TOOL('T3 DRILL',#98,(),60.,$,$)",
    "#98=TWIST_DRILL(#99,2,.RIGHT.,.F.,$)",
    "#99=MILLING_TOOL_DIMENSION(4.,2.0594885,$,30.,$,$,$)",
    "#95=MILLING_TECHNOLOGY(0.004,.TCP.,$,-45.,$,.F.,.F.,.F.,$)",
    "#96=MILLING_MACHINE_FUNCTIONS(.T.,$,$,.F.,$,(),.F.,$,$,())",
    "#97=DRILLING_TYPE_STRATEGY(0.5,0.6,1.,0.5,0.7,1.5)",
};

/// Features and cutters that the first example has not: a face, an open pocket, a slot, a vee, half round and T slots, a step whose wall leans, a
/// pattern, a compound, a chamfer.
const char* const kFormedExample[] = {
    "#1=PROJECT('FORMED',#2,(#3),$,$,$)",
    "#2=WORKPLAN('MAIN',(#20,#21,#22,#23,#24,#25,#26,#27,#28,#29,#36),$,#4,$)",
    "#3=WORKPIECE('PLATE',$,$,$,$,#6,())",
    "#4=SETUP('VICE',#12,#9,(#10))",
    "#6=BLOCK('BLANK',#12,120.,80.,20.)",
    "#9=PLANE('SECURITY',#16)",
    "#10=WORKPIECE_SETUP(#3,#12,$,$,())",
    "#12=AXIS2_PLACEMENT_3D('',#31,#14,#15)",
    "#31=CARTESIAN_POINT('',(0.,0.,0.))",
    "#14=DIRECTION('',(0.,0.,1.))",
    "#15=DIRECTION('',(1.,0.,0.))",
    "#16=AXIS2_PLACEMENT_3D('',#32,#14,#15)",
    "#32=CARTESIAN_POINT('',(0.,0.,40.))",
    "#90=MILLING_TECHNOLOGY(0.015,.TCP.,$,-100.,$,$,$,$,$)",
    "#91=MILLING_MACHINE_FUNCTIONS(.T.,$,$,.F.,$,(),.F.,$,$,())",
    // T1 mill, T2 cone, T3 ball, T4 disc, T5 drill.
    "#100=MILLING_CUTTING_TOOL('T1',#101,(),$,$,$)",
    "#101=ENDMILL(#102,3,.RIGHT.,.F.,$)",
    "#102=MILLING_TOOL_DIMENSION(6.,$,$,20.,0.,$,$)",
    "#103=MILLING_CUTTING_TOOL('T2',#104,(),$,$,$)",
    "#104=COUNTERSINK(#105,2,.RIGHT.,.F.,$,$)",
    "#105=MILLING_TOOL_DIMENSION(10.,1.5707963268,$,20.,$,$,$)",
    "#106=MILLING_CUTTING_TOOL('T3',#107,(),$,$,$)",
    "#107=BALL_ENDMILL(#108,2,.RIGHT.,.F.,$)",
    "#108=MILLING_TOOL_DIMENSION(6.,$,$,20.,3.,$,$)",
    "#109=MILLING_CUTTING_TOOL('T4',#110,(),$,$,$)",
    "#110=T_SLOT_MILL(#111,6,.RIGHT.,.F.,$,3.)",
    "#111=MILLING_TOOL_DIMENSION(12.,$,$,$,$,$,$)",
    "#112=MILLING_CUTTING_TOOL('T5',#113,(),$,$,$)",
    "#113=TWIST_DRILL(#114,2,.RIGHT.,.F.,$)",
    "#114=MILLING_TOOL_DIMENSION(4.,$,$,30.,$,$,$)",
    // A face over everything.
    "#20=MACHINING_WORKINGSTEP('FACE',#9,#200,#201,$)",
    "#200=PLANAR_FACE('FACE',#3,(#201),#202,#204,#206,#209,$,())",
    "#201=PLANE_ROUGH_MILLING($,$,'OP',$,$,#100,#90,#91,$,$,$,$,$,$)",
    "#202=AXIS2_PLACEMENT_3D('',#203,#14,#15)",
    "#203=CARTESIAN_POINT('',(0.,0.,20.))",
    "#204=PLANE('',#205)",
    "#205=AXIS2_PLACEMENT_3D('',#210,#14,#15)",
    "#210=CARTESIAN_POINT('',(0.,0.,-1.))",
    "#206=LINEAR_PATH($,#207,#208)",
    "#207=TOLERANCED_LENGTH_MEASURE(118.,$)",
    "#208=DIRECTION('',(1.,0.,0.))",
    "#209=LINEAR_PROFILE($,#211)",
    "#211=TOLERANCED_LENGTH_MEASURE(78.,$)",
    // An open pocket at the left.
    "#21=MACHINING_WORKINGSTEP('OPEN',#9,#220,#221,$)",
    "#220=OPEN_POCKET('OPEN',#3,(#221),#222,#224,(),$,#226,$,$,#227,$)",
    "#221=BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',$,$,#100,#90,#91,$,$,$,$,$,$,$,$)",
    "#222=AXIS2_PLACEMENT_3D('',#223,#14,#15)",
    "#223=CARTESIAN_POINT('',(0.,50.,19.))",
    "#224=PLANE('',#225)",
    "#225=AXIS2_PLACEMENT_3D('',#228,#14,#15)",
    "#228=CARTESIAN_POINT('',(0.,0.,-3.))",
    "#226=PLANAR_POCKET_BOTTOM_CONDITION()",
    "#227=GENERAL_PROFILE($,#229)",
    "#229=POLYLINE('',(#230,#231,#232,#233))",
    "#230=CARTESIAN_POINT('',(0.,20.,0.))",
    "#231=CARTESIAN_POINT('',(15.,20.,0.))",
    "#232=CARTESIAN_POINT('',(15.,0.,0.))",
    "#233=CARTESIAN_POINT('',(0.,0.,0.))",
    // A step whose wall leans, at the front.
    "#22=MACHINING_WORKINGSTEP('STEP',#9,#240,#221,$)",
    "#240=STEP('STEP',#3,(#221),#241,#243,#245,#248,())",
    "#241=AXIS2_PLACEMENT_3D('',#242,#14,#15)",
    "#242=CARTESIAN_POINT('',(0.,5.,19.))",
    "#243=PLANE('',#244)",
    "#244=AXIS2_PLACEMENT_3D('',#249,#14,#15)",
    "#249=CARTESIAN_POINT('',(0.,0.,-2.))",
    "#245=LINEAR_PATH($,#246,#247)",
    "#246=TOLERANCED_LENGTH_MEASURE(118.,$)",
    "#247=DIRECTION('',(1.,0.,0.))",
    "#248=VEE_PROFILE($,$,1.9,1.9)",
    // A vee, a half round slot and a T slot.
    "#23=MACHINING_WORKINGSTEP('VEE',#9,#260,#261,$)",
    "#260=SLOT('VEE',#3,(#261),#262,#264,#266,#269,(#270,#270))",
    "#261=BOTTOM_AND_SIDE_FINISH_MILLING($,$,'OP',$,$,#103,#90,#91,$,$,$,$,$,$,$,$)",
    "#262=AXIS2_PLACEMENT_3D('',#263,#14,#15)",
    "#263=CARTESIAN_POINT('',(30.,60.,19.))",
    "#264=PLANE('',#265)",
    "#265=AXIS2_PLACEMENT_3D('',#271,#14,#15)",
    "#271=CARTESIAN_POINT('',(0.,0.,-2.5))",
    "#266=LINEAR_PATH($,#267,#268)",
    "#267=TOLERANCED_LENGTH_MEASURE(15.,$)",
    "#268=DIRECTION('',(1.,0.,0.))",
    "#269=VEE_PROFILE($,$,1.5707963268,0.7853981634)",
    "#270=RADIUSED_SLOT_END_TYPE()",
    "#24=MACHINING_WORKINGSTEP('ROUND',#9,#280,#281,$)",
    "#280=SLOT('ROUND',#3,(#281),#282,#284,#266,#289,(#270,#270))",
    "#281=BOTTOM_AND_SIDE_FINISH_MILLING($,$,'OP',$,$,#106,#90,#91,$,$,$,$,$,$,$,$)",
    "#282=AXIS2_PLACEMENT_3D('',#283,#14,#15)",
    "#283=CARTESIAN_POINT('',(60.,60.,19.))",
    "#284=PLANE('',#285)",
    "#285=AXIS2_PLACEMENT_3D('',#288,#14,#15)",
    "#288=CARTESIAN_POINT('',(0.,0.,-3.))",
    "#289=ROUNDED_U_PROFILE($,#286)",
    "#286=TOLERANCED_LENGTH_MEASURE(6.,$)",
    "#25=MACHINING_WORKINGSTEP('NECK',#9,#300,#221,$)",
    "#26=MACHINING_WORKINGSTEP('DISC',#9,#300,#301,$)",
    "#300=SLOT('TEE',#3,(#221,#301),#302,#304,#306,#309,(#310,#310))",
    "#301=BOTTOM_AND_SIDE_FINISH_MILLING($,$,'OP',$,$,#109,#90,#91,$,$,$,$,$,$,$,$)",
    "#302=AXIS2_PLACEMENT_3D('',#303,#14,#15)",
    "#303=CARTESIAN_POINT('',(0.,30.,19.))",
    "#304=PLANE('',#305)",
    "#305=AXIS2_PLACEMENT_3D('',#311,#14,#15)",
    "#311=CARTESIAN_POINT('',(0.,0.,-6.))",
    "#306=LINEAR_PATH($,#307,#308)",
    "#307=TOLERANCED_LENGTH_MEASURE(120.,$)",
    "#308=DIRECTION('',(1.,0.,0.))",
    "#309=TEE_PROFILE($,0.,0.,#312,#313,$,#314,$,$)",
    "#310=OPEN_SLOT_END_TYPE()",
    "#312=TOLERANCED_LENGTH_MEASURE(12.,$)",
    "#313=TOLERANCED_LENGTH_MEASURE(3.,$)",
    "#314=TOLERANCED_LENGTH_MEASURE(8.,$)",
    // Holes in a row, a pocket with its edge broken.
    "#27=MACHINING_WORKINGSTEP('HOLES',#9,#320,#321,$)",
    "#320=RECTANGULAR_PATTERN('ROW',#3,(#321),#322,#330,#331,#332,1,3,$,$,(),())",
    "#321=DRILLING($,$,'DRILL',$,$,#112,#90,#91,$,$,$,$,$,$)",
    "#322=AXIS2_PLACEMENT_3D('',#323,#14,#15)",
    "#323=CARTESIAN_POINT('',(40.,47.,19.))",
    "#330=ROUND_HOLE('HOLE',#3,(#321),#322,#333,#334,$,#335)",
    "#331=TOLERANCED_LENGTH_MEASURE(9.,$)",
    "#332=DIRECTION('',(1.,0.,0.))",
    "#333=PLANE('',#336)",
    "#336=AXIS2_PLACEMENT_3D('',#337,#14,#15)",
    "#337=CARTESIAN_POINT('',(0.,0.,-8.))",
    "#334=TOLERANCED_LENGTH_MEASURE(4.,$)",
    "#335=FLAT_HOLE_BOTTOM()",
    "#28=MACHINING_WORKINGSTEP('POCKET',#9,#340,#221,$)",
    "#340=CLOSED_POCKET('POCKET',#3,(#221),#341,#343,(),$,#226,$,$,#345)",
    "#341=AXIS2_PLACEMENT_3D('',#342,#14,#15)",
    "#342=CARTESIAN_POINT('',(100.,60.,19.))",
    "#343=PLANE('',#344)",
    "#344=AXIS2_PLACEMENT_3D('',#347,#14,#15)",
    "#347=CARTESIAN_POINT('',(0.,0.,-4.))",
    "#345=CIRCULAR_CLOSED_PROFILE($,#346)",
    "#346=TOLERANCED_LENGTH_MEASURE(16.,$)",
    "#29=MACHINING_WORKINGSTEP('EDGE',#9,#350,#261,$)",
    "#350=CHAMFER('EDGE',#3,(#261),#200,#340,0.7853981634,#351)",
    "#351=TOLERANCED_LENGTH_MEASURE(0.6,$)",
    // An n-gon that stays, in a pocket of its own.
    "#36=MACHINING_WORKINGSTEP('BOSSED',#9,#360,#221,$)",
    "#360=CLOSED_POCKET('BOSSED',#3,(#221),#361,#363,(#366),0.05,#226,$,$,#365)",
    "#361=AXIS2_PLACEMENT_3D('',#362,#14,#15)",
    "#362=CARTESIAN_POINT('',(75.,15.,19.))",
    "#363=PLANE('',#364)",
    "#364=AXIS2_PLACEMENT_3D('',#370,#14,#15)",
    "#370=CARTESIAN_POINT('',(0.,0.,-2.))",
    "#365=NGON_PROFILE($,#371,6,.T.)",
    "#371=TOLERANCED_LENGTH_MEASURE(17.,$)",
    "#366=BOSS('BOSS',#3,(),#12,#363,#367,0.05)",
    "#367=CIRCULAR_CLOSED_PROFILE($,#368)",
    "#368=TOLERANCED_LENGTH_MEASURE(3.,$)",
};

/// Whatever a change may leave as it is, with the reason. Attributes whose row says annotation need none.
struct Unchanged {
  const char* keyword;    ///< "": any
  const char* attribute;  ///< "": all
  bool changed;           ///< also when it has another value, not only when it is taken away
  const char* reason;
};
const Unchanged kUnchanged[] = {
    {"MATERIAL", "", true, "the workpiece's material is an annotation"},
    {"DESCRIPTIVE_PARAMETER", "", true, "a property of that material"},
    {"CUTTING_COMPONENT", "", true, "the list that it is in is an annotation"},
    {"PERSON_AND_ADDRESS", "", true, "the owner is an annotation"},
    {"PROJECT", "its_workpieces", false, "the workpiece of the features is the same"},
    {"MACHINING_WORKINGSTEP", "its_secplane", false, "the plane of the set-up is the same"},
    {"SETUP", "its_secplane", false, "the planes of the steps are the same"},
    {"", "its_workpiece", false, "there is one workpiece"},
    {"", "hand_of_cut", false, "right where nothing is stated"},
    {"", "number_of_teeth", false, "two where nothing is stated"},
    {"LINEAR_PATH", "its_direction", false, "along x where none is stated"},
    {"VEE_PROFILE", "tilt_angle", false, "alike on both sides where none is stated"},
    {"TEE_PROFILE", "first_angle", false, "level where none is stated"},
    {"TEE_PROFILE", "second_angle", false, "level where none is stated"},
    {"RECTANGULAR_PATTERN", "number_of_rows", false, "one where none is stated"},
    {"BLOCK", "position", false, "at the origin where none is stated"},
    {"RECTANGULAR_CLOSED_PROFILE", "placement", false, "at the origin where none is stated"},
    {"AXIS2_PLACEMENT_3D", "location", false, "at the origin where none is stated"},
    {"AXIS2_PLACEMENT_3D", "axis", false, "along z where none is stated"},
    {"AXIS2_PLACEMENT_3D", "ref_direction", false, "along x where none is stated"},
    {"CLOSED_POCKET", "slope", false, "upright where none is stated"},
    {"TOLERANCED_LENGTH_MEASURE", "implicit_tolerance", false, "the size is the middle of its field"},
    {"PLUS_MINUS_VALUE", "", true, "of holes: the drill lies in the field; of others see the pocket's width"},
    {"BOTTOM_AND_SIDE_ROUGH_MILLING", "its_tool_direction", false, "upright where none is stated"},
    {"CENTER_DRILLING", "start_point", false, "the middle of the hole"},
    {"DRILLING", "previous_diameter", false, "an earlier step makes that hole"},
    {"CONTOUR_PARALLEL", "allow_multiple_passes", false, "allowed where nothing is stated"},
    {"CONTOUR_PARALLEL", "rotation_direction", false, "says the same as the cut mode"},
    {"CONTOUR_PARALLEL", "cutmode", false, "says the same as the rotation"},
    {"MILLING_CUTTING_TOOL", "its_id", true, "a name; the numbers are the same"},
    {"MILLING_TECHNOLOGY", "feedrate_reference", false, "of the tool's centre where nothing is stated"},
    {"MILLING_TECHNOLOGY", "synchronize_spindle_with_feed", false, "off where nothing is stated"},
    {"MILLING_MACHINE_FUNCTIONS", "mist", false, "off where nothing is stated"},
    {"MILLING_MACHINE_FUNCTIONS", "through_spindle_coolant", false, "off where nothing is stated"},
};
/// Of the example of features of form besides: its workpiece lies at the origin, along the axes.
const Unchanged kUnchangedOfForms[] = {
    {"", "its_origin", false, "at the origin where none is stated"},
    {"WORKPLAN", "its_setup", false,
     "its planes are those of the steps, and the workpiece lies at its origin"},
    {"SETUP", "its_workpiece_setup", false, "the workpiece lies at the origin where nothing is stated"},
    {"RECTANGULAR_PATTERN", "feature_placement", false, "the axes of the workpiece where none are stated"},
    {"BOSS", "feature_placement", false, "at the origin where none is stated"},
    {"SLOT", "end_conditions", false, "as the cutter leaves them, open at the edge of the stock"},
    {"MILLING_TOOL_DIMENSION", "tool_top_angle", false, "of a cone 90 degrees where none is stated"},
    {"MILLING_TOOL_DIMENSION", "edge_radius", false, "of a ball half its diameter"},
};

struct Entity {
  std::string id, keyword;
  std::vector<std::string> arguments;

  std::string text() const {
    std::string out = id + "=" + keyword + "(";
    for (std::size_t i = 0; i < arguments.size(); ++i) out += (i == 0 ? "" : ",") + arguments[i];
    return out + ");";
  }
};

Entity parsed(const std::string& line) {
  Entity entity;
  const std::size_t equals = line.find('='), open = line.find('(');
  entity.id = line.substr(0, equals);
  entity.keyword = line.substr(equals + 1, open - equals - 1);
  int depth = 0;
  bool quoted = false;
  std::string argument;
  for (std::size_t i = open + 1; i + 1 < line.size(); ++i) {
    const char c = line[i];
    quoted = quoted != (c == '\'');
    if (!quoted && c == '(') ++depth;
    if (!quoted && c == ')') --depth;
    if (!quoted && depth == 0 && c == ',') {
      entity.arguments.push_back(argument);
      argument.clear();
    } else {
      argument += c;
    }
  }
  if (!argument.empty()) entity.arguments.push_back(argument);
  return entity;
}

std::vector<Entity> entities_of(std::span<const char* const> lines) {
  std::vector<Entity> entities;
  for (const char* line : lines) entities.push_back(parsed(line));
  return entities;
}

std::vector<Entity> example() {
  return entities_of(kExample);
}

std::string file_of(const std::vector<Entity>& entities) {
  std::string text = "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('MACHINING_SCHEMA'));\nENDSEC;\nDATA;\n";
  for (const Entity& entity : entities) text += entity.text() + "\n";
  return text + "ENDSEC;\nEND-ISO-10303-21;\n";
}

/// Of each set-up, as planning reads them.
std::vector<Part> parts_of(const std::vector<Entity>& entities) {
  const std::string text = file_of(entities), name = "m.p21";
  const int setups = read::stepnc::count_setups(text, name);
  std::vector<Part> parts;
  SetupPlace place;
  if (setups < 2) return {read::stepnc::read_stepnc(text, name, {})};
  for (int number = 1; number <= setups; ++number)
    parts.push_back(read::stepnc::read_setup(text, name, {}, number, place));
  return parts;
}

/// Everything that a person sees of the plan but annotations; or why it is refused.
std::string seen_by(const std::vector<Entity>& entities, const std::optional<std::string>& strategy) {
  try {
    PlanOptions options;
    options.threads = 1;
    options.strategy = strategy;
    std::string all;
    for (const Part& part : parts_of(entities)) {
      const PlanResult result = pipeline::plan_part(part, options);
      all += result.program + verdict_and_reasons(result.findings);
      for (const ResolvedValue& value : result.values) all += "\n" + value.name + " " + value.value;
      for (const Diagnostic& one : result.part.diagnostics.items())
        if (one.what.rfind("not used, an annotation", 0) != 0 && one.what.rfind("names of ", 0) != 0)
          all += "\n" + one.where + ": " + one.what;
    }
    return all;
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string seen(const std::vector<Entity>& entities) {
  return seen_by(entities, std::nullopt);
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("+-.0123456789Ee") == std::string::npos &&
         text.find_first_of("0123456789") != std::string::npos;
}

/// Flags and words of which both values are known.
std::optional<std::string> other_word(const std::string& word) {
  static const std::map<std::string, std::string> kOther{{".T.", ".F."},
                                                         {".F.", ".T."},
                                                         {".CCW.", ".CW."},
                                                         {".CW.", ".CCW."},
                                                         {".CLIMB.", ".CONVENTIONAL."},
                                                         {".CONVENTIONAL.", ".CLIMB."},
                                                         {".TCP.", ".CCP."},
                                                         {".CCP.", ".TCP."},
                                                         {".RIGHT.", ".LEFT."},
                                                         {".LEFT.", ".RIGHT."}};
  const auto other = kOther.find(word);
  if (other != kOther.end()) return other->second;
  return word[0] == '.' && word.find_first_of("0123456789") == std::string::npos ? std::optional(".OTHER.")
                                                                                 : std::nullopt;
}

/// Each number of a list that holds only numbers, changed alone.
std::vector<std::string> changed_list(const std::string& list) {
  std::vector<std::string> all;
  for (std::size_t begin = 1; begin < list.size();) {
    const std::size_t end = std::min(list.find_first_of(",)", begin), list.size());
    const std::string item = list.substr(begin, end - begin);
    if (!is_number(item)) return {};
    const auto put = [&](const std::string& other) {
      all.push_back(list.substr(0, begin) + other + list.substr(end));
    };
    if (item.find('.') == std::string::npos) {
      put(std::to_string(std::stoi(item) + 1));
    } else {
      put(std::to_string(std::stod(item) + 0.75));
      put(std::to_string(std::stod(item) - 0.75));  // what reaches beyond the stock may not grow
    }
    begin = end + 1;
  }
  return all;
}

/// Other values of the same type, of lists of numbers with each of them changed; none where none means something.
std::vector<std::string> changed(const std::string& value) {
  if (const auto other = other_word(value)) return {*other};
  if (value.rfind("'", 0) == 0) return {"'OTHER'"};
  if (value.rfind("('", 0) == 0) return {"('B')"};
  if (value.size() > 2 && value[0] == '(') return changed_list(value);
  if (!is_number(value)) return {};
  return {value.find('.') == std::string::npos ? std::to_string(std::stoi(value) + 1)
                                               : std::to_string(std::stod(value) * 1.25 + 0.11)};
}

/// "~its_id" and so on; "" where the entity has no row.
std::string row_word(const std::string& keyword, std::size_t argument) {
  for (const EntityRow& row : read::stepnc::entity_rows()) {
    if (row.keyword != keyword) continue;
    std::string word;
    std::size_t number = 0;
    for (const char c : std::string(row.attributes) + " ") {
      if (c != ' ') {
        word += c;
        continue;
      }
      if (!word.empty() && number++ == argument) return word;
      word.clear();
    }
  }
  return "";
}

bool may_stay(const std::string& keyword, const std::string& word, bool taken_away,
              std::span<const Unchanged> more) {
  if (!word.empty() && word[0] == '~') return true;
  const std::string name = !word.empty() && word[0] == '?' ? word.substr(1) : word;
  for (const std::span<const Unchanged> rows : {std::span<const Unchanged>(kUnchanged), more})
    for (const Unchanged& one : rows)
      if ((keyword == one.keyword || std::string(one.keyword).empty()) &&
          (name == one.attribute || std::string(one.attribute).empty()))
        return taken_away || one.changed;
  return false;
}

TEST(StepNcMutation, TheExampleIsPlannedAndSaysWhatItDoesNotFollow) {
  const std::string all = seen(example());
  EXPECT_THAT(all, ::testing::HasSubstr("STOP: CLEAR THE CHIPS"));
  EXPECT_THAT(all, ::testing::HasSubstr("\nM0\n"));
  EXPECT_THAT(all, ::testing::HasSubstr("MESSAGE: HOLES NEXT"));
  EXPECT_THAT(all, ::testing::HasSubstr("\nG4 P1.5\n"));
  EXPECT_THAT(all, ::testing::HasSubstr("start_point of #41"));
  EXPECT_THAT(all, ::testing::HasSubstr("go 7 of the 9 mm down"));
}

TEST(StepNcMutation, RadiiAndAnglesOfToolsThatAreNotReadAreSaid) {
  std::vector<Entity> entities = example();
  const auto drill =
      std::find_if(entities.begin(), entities.end(), [](const Entity& one) { return one.id == "#99"; });
  ASSERT_NE(drill, entities.end());
  drill->arguments[4] = "0.3";
  EXPECT_THAT(seen_by(entities, "zigzag"), ::testing::HasSubstr("edge_radius of #99"));
}

TEST(StepNcMutation, TheDocumentationListsTheSameAttributes) {
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/stepnc.md", 1 << 20);
  for (const EntityRow& row : read::stepnc::entity_rows()) {
    std::string line = "| " + std::string(row.keyword) + " | ";
    for (std::size_t i = 0; !row_word(std::string(row.keyword), i).empty(); ++i)
      line += (i == 0 ? "" : " ") + row_word(std::string(row.keyword), i);
    EXPECT_THAT(page, ::testing::HasSubstr(line + " |\n"));
  }
}

TEST(StepNcMutation, TheDocumentationSaysWhatBecomesOfEachEntity) {
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/stepnc.md", 1 << 20);
  EXPECT_THAT(page, ::testing::HasSubstr(read::stepnc::entity_tables()));
}

/// Changes and takes away each attribute alone; how many mutations that are. `seen_of`: what a person sees of a file.
template <class Seen>
int expect_each_is_seen(const std::vector<Entity>& whole, const Seen& seen_of,
                        std::span<const Unchanged> more = {}) {
  const std::string before = seen_of(whole);
  int mutations = 0;
  const auto is_seen = [&](std::size_t entity, std::size_t argument, const std::string& value) {
    std::vector<Entity> mutated = whole;
    mutated[entity].arguments[argument] = value;
    return seen_of(mutated) != before;
  };
  for (std::size_t e = 0; e < whole.size(); ++e) {
    for (std::size_t a = 0; a < whole[e].arguments.size(); ++a) {
      const std::string value = whole[e].arguments[a], word = row_word(whole[e].keyword, a);
      const std::vector<std::string> others = changed(value);
      if (!others.empty() && !may_stay(whole[e].keyword, word, false, more)) {
        ++mutations;
        EXPECT_TRUE(std::any_of(others.begin(), others.end(),
                                [&](const std::string& other) { return is_seen(e, a, other); }))
            << whole[e].text() << " with another value for " << value << " (" << word << ")";
      }
      if (value == "$" || value == "()" || may_stay(whole[e].keyword, word, true, more)) continue;
      ++mutations;
      EXPECT_TRUE(is_seen(e, a, value[0] == '(' ? "()" : "$"))
          << whole[e].text() << " without " << value << " (" << word << ")";
    }
  }
  return mutations;
}

TEST(StepNcMutation, EachAttributeChangedOrTakenAwayAloneIsSeen) {
  EXPECT_GT(expect_each_is_seen(example(), seen), 150);
}

/// Features, tools, operations in numbers, and what is said of them.
void tell_part(const Part& part, std::ostream& all) {
  for (const Feature& one : part.features) {
    const Box plan = box(one.target);
    all << one.name << ' ' << name_of(one.kind) << ' ' << one.top_z << ' ' << one.floor_z << ' '
        << area(one.target) << ' ' << plan.min.x << ' ' << plan.min.y << ' ' << plan.max.x << ' '
        << plan.max.y << ' ' << one.wall_slope.radians() << ' ' << one.through << ' '
        << one.hole_diameter.value_or(0) << ' ' << (one.chamfer ? one.chamfer->depth : 0) << '\n';
  }
  for (const Workingstep& step : part.workplan)
    all << step.name << ' ' << step.feature << ' ' << step.operation.tool << ' '
        << (step.operation.cutting.feed ? step.operation.cutting.feed->mm_per_min() : 0) << ' '
        << step.operation.cutting.spindle_rpm.value_or(0) << ' ' << step.operation.cutting.spindle_clockwise
        << ' ' << static_cast<int>(step.operation.kind) << ' '
        << static_cast<int>(step.operation.cutting.coolant.value_or(Coolant::kOff)) << '\n';
  for (const Tool& tool : part.tools)
    all << tool.number << ' ' << name_of(tool.kind) << ' ' << tool.diameter << ' ' << tool.corner_radius
        << '\n';
  all << part.clearance_z.value_or(0);
  if (part.stock)
    all << ' ' << part.stock->z_top << ' ' << part.stock->plan.max.x << ' ' << part.stock->plan.max.y << '\n';
  for (const Diagnostic& one : part.diagnostics.items())
    if (one.what.rfind("not used, an annotation", 0) != 0 && one.what.rfind("names of ", 0) != 0)
      all << one.where << ": " << one.what << '\n';
}

/// What a reader makes of a file, and says of it: each feature, tool and operation in numbers.
std::string read_of(const std::vector<Entity>& entities) {
  std::ostringstream all;
  try {
    for (const Part& part : parts_of(entities)) tell_part(part, all);
  } catch (const InputError& error) {
    all << error.what();
  }
  return all.str();
}
TEST(StepNcMutation, EachAttributeOfOtherFeaturesIsReadOrSaid) {
  const std::vector<Entity> whole = entities_of(kFormedExample);
  EXPECT_THAT(read_of(whole), ::testing::Not(::testing::HasSubstr("not machined")));
  EXPECT_GT(expect_each_is_seen(whole, read_of, kUnchangedOfForms), 250);
}

/// The entities of a file's text. Complex instances and entities without arguments to change are kept as they are.
std::vector<Entity> entities_of_text(const std::string& text) {
  std::vector<Entity> entities;
  std::string line;
  bool quoted = false;
  const std::size_t begin = text.find("DATA;") + 5, end = text.find("ENDSEC;", begin);
  for (std::size_t i = begin; i < end; ++i) {
    const char c = text[i];
    if (!quoted && text.compare(i, 2, "/*") == 0) {
      i = text.find("*/", i) + 1;
      continue;
    }
    quoted = quoted != (c == '\'');
    if (!quoted && c == ';') {
      entities.push_back(parsed(line));
      line.clear();
    } else if (quoted || c == '\'' || !std::isspace(static_cast<unsigned char>(c))) {
      line += c;
    }
  }
  return entities;
}

/// Of the files beside the checkout, whose features and operations are of every kind: see their README.
const Unchanged kUnchangedOfFiles[] = {
    {"", "its_origin", false, "at the origin where none is stated"},
    {"", "feature_placement", false, "at the origin where none is stated"},
    {"", "allow_multiple_passes", false, "allowed where nothing is stated"},
    {"", "rotation_direction", false, "says the same as the cut mode"},
    {"", "cutmode", false, "says the same as the rotation"},
    {"", "its_priority", false, "a path is followed where nothing is stated"},
    {"", "its_type", false, "a path of the trajectory where nothing is stated"},
    {"CIRCULAR_PATTERN", "base_feature_diameter", false, "as far out as the feature that is repeated"},
    {"RECTANGULAR_PATTERN", "row_layout_direction", false, "square to its direction where none is stated"},
    {"STEP", "wall_boundary", false, "upright where none is stated"},
    {"COMPOSITE_CURVE_SEGMENT", "same_sense", false, "along its curve where nothing is stated"},
    {"", "retract", false, "straight up where nothing is stated"},
    {"", "its_machine_functions", false, "off where nothing is stated"},
    {"DRILLING", "its_machining_strategy", false, "one feed where nothing is stated"},
    {"REAMING", "its_machining_strategy", false, "one feed where nothing is stated"},
    {"CLOSED_POCKET", "orthogonal_radius", false, "zero where none is stated"},
    {"VEE_PROFILE", "profile_radius", false, "zero where none is stated"},
    {"MILLING_TOOL_DIMENSION", "edge_radius", false, "of a ball half its diameter"},
    {"VEE_PROFILE", "profile_angle", false, "of steps: upright where none is stated"},
    {"WORKPLAN", "its_setup", false,
     "its planes are those of the steps, and the workpiece lies at its origin"},
    {"SETUP", "its_workpiece_setup", false, "the workpiece lies at the origin where nothing is stated"},
    {"LINEAR_PATH", "placement", false, "at the feature's origin where none is stated"},
    {"SLOT", "end_conditions", false, "as the cutter leaves them, open at the edge of the stock"},
    {"DIRECTION", "direction_ratios", true,
     "of what is round, and of planes: the other examples have the rest"},
};

/// Workingsteps and branches that the file's own messages call left out: nothing is made of what is theirs alone.
std::set<std::string> left_out_of(const std::string& told) {
  std::set<std::string> ids;
  const std::string before = "workingstep #";
  for (std::size_t at = told.find(before); at != std::string::npos; at = told.find(before, at + 1)) {
    const std::size_t begin = at + before.size() - 1;
    const std::size_t end = told.find_first_not_of("0123456789", begin + 1);
    if (told.compare(told.find('\'', end + 2), 14, "' is left out:") == 0)
      ids.insert(told.substr(begin, end - begin));
  }
  const std::string branch = " is not machined: #";
  for (std::size_t at = told.find(branch); at != std::string::npos; at = told.find(branch, at + 1)) {
    const std::size_t begin = at + branch.size() - 1;
    const std::size_t end = told.find_first_not_of("0123456789", begin + 1);
    if (told.compare(end, 4, " IF_") == 0 || told.compare(end, 7, " WHILE_") == 0)
      ids.insert(told.substr(begin, end - begin));
  }
  return ids;
}

bool is_annotation(const std::string& word) {
  return !word.empty() && word[0] == '~';
}

/// The ids that the text of an argument refers to.
std::vector<std::string> references_in(const std::string& argument) {
  std::vector<std::string> ids;
  for (std::size_t at = argument.find('#'); at != std::string::npos; at = argument.find('#', at + 1))
    ids.push_back(argument.substr(at, argument.find_first_not_of("0123456789", at + 1) - at));
  return ids;
}

/// Entities that the project reaches otherwise than by annotations, and by workingsteps that are machined. `told`: by read_of().
std::set<std::string> bearing_on_the_part(const std::vector<Entity>& whole, const std::string& told) {
  const std::set<std::string> left_out = left_out_of(told);
  std::map<std::string, const Entity*> by_id;
  std::vector<std::string> waiting;
  for (const Entity& entity : whole) {
    by_id[entity.id] = &entity;
    if (entity.keyword == "PROJECT") waiting.push_back(entity.id);
  }
  std::set<std::string> reached(waiting.begin(), waiting.end());
  while (!waiting.empty()) {
    const auto found = by_id.find(waiting.back());
    waiting.pop_back();
    if (found == by_id.end() || left_out.count(found->first) > 0) continue;
    const Entity& entity = *found->second;
    for (std::size_t a = 0; a < entity.arguments.size(); ++a) {
      if (is_annotation(row_word(entity.keyword, a))) continue;
      for (const std::string& id : references_in(entity.arguments[a]))
        if (reached.insert(id).second) waiting.push_back(id);
    }
  }
  for (const std::string& id : left_out) reached.erase(id);
  return reached;
}

/// Zero and .F. ask for nothing.
bool asks_for_nothing(const std::string& value) {
  return value == "$" || value == "()" || value == ".F." ||
         value.find_first_not_of("-0.") == std::string::npos;
}

struct Silent {
  int mutations = 0;
  std::map<std::string, std::vector<std::string>> by_attribute;
};

/// How the reader would have each step cut, besides what tell_part() tells.
void tell_operations(const Part& part, std::ostream& all) {
  const auto put = [&](const char* name, const auto& value) {
    if (value) all << ' ' << name << ' ' << *value;
  };
  const auto put_feed = [&](const char* name, const std::optional<MmPerMin>& feed) {
    if (feed) all << ' ' << name << ' ' << feed->mm_per_min();
  };
  for (const Workingstep& step : part.workplan) {
    const Operation& operation = step.operation;
    all << step.name << ' ' << operation.strategy_hint << ' ' << operation.allowance_side << ' '
        << operation.allowance_floor;
    put("down", operation.stepdown);
    put("over", operation.stepover);
    put("retract", operation.retract_z);
    put("lead", operation.lead);
    put("entry size", operation.entry_size);
    put_feed("plunge", operation.cutting.plunge_feed);
    put_feed("ramp", operation.cutting.ramp_feed);
    put_feed("slot", operation.cutting.slot_feed);
    if (operation.entry) all << " entry " << static_cast<int>(*operation.entry);
    if (operation.entry_angle) all << " angle " << operation.entry_angle->radians();
    if (operation.lead_angle) all << " lead angle " << operation.lead_angle->radians();
    if (operation.feed_direction) all << " along " << operation.feed_direction->radians();
    if (operation.direction) all << " direction " << static_cast<int>(*operation.direction);
    if (operation.hole_feeds)
      all << " feeds " << operation.hole_feeds->dwell_s << ' '
          << operation.hole_feeds->retract_share.value_or(1) << ' ' << operation.hole_feeds->start_share
          << ' ' << operation.hole_feeds->start_depth << ' ' << operation.hole_feeds->end_share << ' '
          << operation.hole_feeds->end_depth;
    for (const ProgramStop& stop : step.stops) all << " stop " << stop.text;
    if (step.stated_path)
      for (const StatedMove& move : step.stated_path->moves)
        all << ' ' << move.path.to.x << ' ' << move.path.to.y << ' ' << static_cast<int>(move.kind);
    all << '\n';
  }
  for (const KeepOut& clamp : part.keep_outs)
    all << clamp.plan.min.x << ' ' << clamp.plan.min.y << ' ' << clamp.plan.max.x << ' ' << clamp.plan.max.y
        << ' ' << clamp.bottom_z << ' ' << clamp.top_z << '\n';
}

std::string operations_of(const std::vector<Entity>& entities) {
  std::ostringstream all;
  for (const Part& part : parts_of(entities)) tell_operations(part, all);
  return all.str();
}

std::string read_in_full(const std::vector<Entity>& entities) {
  const std::string all = read_of(entities);
  try {
    return all + operations_of(entities);
  } catch (const InputError&) {
    return all;
  }
}

/// Every `stride`-th mutation of a file, and which of them neither the reader takes in another way nor the plan.
void mutate(const std::vector<Entity>& whole, const std::string& file, int stride, int& count,
            Silent& silent) {
  try {
    parts_of(whole);
  } catch (const InputError&) {
    return;  // of a file that is refused as a whole one reason is said
  }
  const std::string read_before = read_in_full(whole);
  std::optional<std::string> seen_before;
  const auto is_seen = [&](std::size_t entity, std::size_t argument, const std::string& value) {
    std::vector<Entity> mutated = whole;
    mutated[entity].arguments[argument] = value;
    if (read_in_full(mutated) != read_before) return true;
    if (!seen_before) seen_before = seen_by(whole, "zigzag");
    return seen_by(mutated, "zigzag") != *seen_before;
  };
  const std::set<std::string> bearing = bearing_on_the_part(whole, read_before);
  for (std::size_t e = 0; e < whole.size(); ++e) {
    if (bearing.count(whole[e].id) == 0) continue;
    for (std::size_t a = 0; a < whole[e].arguments.size(); ++a) {
      const std::string value = whole[e].arguments[a], word = row_word(whole[e].keyword, a);
      const auto attempt = [&](bool taken_away, const std::vector<std::string>& others) {
        if (others.empty() || may_stay(whole[e].keyword, word, taken_away, kUnchangedOfFiles)) return;
        if (count++ % stride != 0) return;
        ++silent.mutations;
        if (std::any_of(others.begin(), others.end(),
                        [&](const std::string& other) { return is_seen(e, a, other); }))
          return;
        silent.by_attribute[whole[e].keyword + "." + word + (taken_away ? " taken away" : " changed")]
            .push_back(file + " " + whole[e].text() + ": " + value);
      };
      std::vector<std::string> others = changed(value);
      if (!others.empty() && value.find_first_not_of("-.0123456789E+") == std::string::npos &&
          value.find('.') != std::string::npos)  // a length, an angle or a speed
        others.push_back(
            std::to_string(std::stod(value) * 0.75));  // what reaches beyond the stock may not grow
      attempt(false, others);
      if (!asks_for_nothing(value)) attempt(true, {value[0] == '(' ? "()" : "$"});
    }
  }
}

int mutation_stride() {
  const char* set = std::getenv("CLEARCUT_MUTATIONS");
  return set != nullptr ? std::max(1, std::atoi(set)) : 97;
}

/// The files of a folder whose names begin with `only`, in order.
std::vector<std::filesystem::path> part21_files(const std::filesystem::path& folder, const char* only) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if ((extension == ".p21" || extension == ".stp") &&
        (only == nullptr || entry.path().filename().string().find(only) == 0))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// One in CLEARCUT_MUTATIONS of the mutations of all files (1: each of them), or of those that CLEARCUT_MUTATED_FILE names.
TEST(StepNcMutation, EachAttributeOfTheFilesBesideIsSeen) {
  const auto folder = test_support::data_folder();
  if (!folder) GTEST_SKIP() << "the folder CLEARCUT_DATA is not there";
  const char* only = std::getenv("CLEARCUT_MUTATED_FILE");
  std::vector<std::filesystem::path> files = part21_files(*folder / "stepnc" / "own", only);
  if (only != nullptr)  // those of others are large
    for (const std::filesystem::path& file : part21_files(*folder / "stepnc", only)) files.push_back(file);
  Silent silent;
  int count = 0;
  for (const std::filesystem::path& file : files)
    mutate(entities_of_text(read_file(file.string(), 1 << 20)), file.filename().string(), mutation_stride(),
           count, silent);
  for (const auto& [attribute, places] : silent.by_attribute)
    ADD_FAILURE() << attribute << ": " << places.size() << ", such as " << places.front();
  RecordProperty("mutations", silent.mutations);
  std::printf("%d mutations\n", silent.mutations);
}

}  // namespace
}  // namespace clearcut
