// Nothing that a STEP-NC file says is passed over in silence: each attribute of a file, changed or taken away alone, changes the program, a line of
// the verdict or what is said besides, or it is among the attributes that are known to be annotations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/files/file.h"
#include "pipeline/run.h"
#include "read/stepnc/file/entity_list.h"
#include "read/stepnc/not_used.h"
#include "read/stepnc/stepnc.h"

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

/// Whatever a change may leave as it is, with the reason. Attributes whose row says annotation need none.
struct Unchanged {
  const char* keyword;
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
    {"WORKPIECE_SETUP", "its_workpiece", false, "there is one workpiece"},
    {"CLOSED_POCKET", "its_workpiece", false, "there is one workpiece"},
    {"ROUND_HOLE", "its_workpiece", false, "there is one workpiece"},
    {"BOSS", "its_workpiece", false, "there is one workpiece"},
    {"BLOCK", "position", false, "at the origin where none is stated"},
    {"RECTANGULAR_CLOSED_PROFILE", "placement", false, "at the origin where none is stated"},
    {"AXIS2_PLACEMENT_3D", "location", false, "at the origin where none is stated"},
    {"AXIS2_PLACEMENT_3D", "axis", false, "along z where none is stated"},
    {"AXIS2_PLACEMENT_3D", "ref_direction", false, "along x where none is stated"},
    {"CLOSED_POCKET", "slope", false, "upright where none is stated"},
    {"TOLERANCED_LENGTH_MEASURE", "implicit_tolerance", false, "the size is the middle of its field"},
    {"PLUS_MINUS_VALUE", "", true, "of holes: the drill lies in the field; of others see the pocket's width"},
    {"BOTTOM_AND_SIDE_ROUGH_MILLING", "its_tool_direction", false, "upright where none is stated"},
    {"BOTTOM_AND_SIDE_ROUGH_MILLING", "retract_plane", true, "no rapid crosses within these steps"},
    {"CENTER_DRILLING", "retract_plane", true, "no rapid crosses within these steps"},
    {"DRILLING", "retract_plane", true, "no rapid crosses within these steps"},
    {"CENTER_DRILLING", "start_point", false, "the middle of the hole"},
    {"DRILLING", "previous_diameter", false, "an earlier step makes that hole"},
    {"CONTOUR_PARALLEL", "allow_multiple_passes", false, "allowed where nothing is stated"},
    {"CONTOUR_PARALLEL", "rotation_direction", false, "says the same as the cut mode"},
    {"CONTOUR_PARALLEL", "cutmode", false, "says the same as the rotation"},
    {"MILLING_CUTTING_TOOL", "its_id", true, "a name; the numbers are the same"},
    {"MILLING_TOOL_DIMENSION", "cutting_edge_length", true, "longer than any step is deep"},
    {"MILLING_TOOL_DIMENSION", "tool_top_angle", true, "of a drill that only centres, whose depth is stated"},
    {"ENDMILL", "number_of_teeth", true, "feeds per tooth alone depend on it"},
    {"CENTER_DRILL", "number_of_teeth", true, "feeds per tooth alone depend on it"},
    {"TWIST_DRILL", "number_of_teeth", true, "feeds per tooth alone depend on it"},
    {"ENDMILL", "hand_of_cut", false, "right where nothing is stated"},
    {"CENTER_DRILL", "hand_of_cut", false, "right where nothing is stated"},
    {"TWIST_DRILL", "hand_of_cut", false, "right where nothing is stated"},
    {"MILLING_TECHNOLOGY", "feedrate_reference", false, "of the tool's centre where nothing is stated"},
    {"MILLING_TECHNOLOGY", "synchronize_spindle_with_feed", false, "off where nothing is stated"},
    {"MILLING_MACHINE_FUNCTIONS", "mist", false, "off where nothing is stated"},
    {"MILLING_MACHINE_FUNCTIONS", "through_spindle_coolant", false, "off where nothing is stated"},
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

std::vector<Entity> example() {
  std::vector<Entity> entities;
  for (const char* line : kExample) entities.push_back(parsed(line));
  return entities;
}

std::string file_of(const std::vector<Entity>& entities) {
  std::string text = "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('MACHINING_SCHEMA'));\nENDSEC;\nDATA;\n";
  for (const Entity& entity : entities) text += entity.text() + "\n";
  return text + "ENDSEC;\nEND-ISO-10303-21;\n";
}

/// Everything that a person sees of the plan but annotations; or why it is refused.
std::string seen(const std::vector<Entity>& entities) {
  try {
    const Part part = read::stepnc::read_stepnc(file_of(entities), "m.p21", {});
    resolve::PlanOptions options;
    options.threads = 1;
    const pipeline::PlanResult result = pipeline::plan_part(part, options);
    std::string all = result.program + verdict_and_reasons(result.findings);
    for (const ResolvedValue& value : result.values) all += "\n" + value.name + " " + value.value;
    for (const Diagnostic& one : result.part.diagnostics.items())
      if (one.what.rfind("not used, an annotation", 0) != 0 && one.what.rfind("names of ", 0) != 0)
        all += "\n" + one.where + ": " + one.what;
    return all;
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Other values of the same type, of lists of numbers with each of them changed; none where none means something.
std::vector<std::string> changed(const std::string& value) {
  if (value == "$" || value == "()" || value[0] == '#') return {};
  static const std::map<std::string, std::string> kOther{{".T.", ".F."},     {".F.", ".T."},
                                                         {".CCW.", ".CW."},  {".CLIMB.", ".CONVENTIONAL."},
                                                         {".TCP.", ".CCP."}, {".RIGHT.", ".LEFT."}};
  if (const auto other = kOther.find(value); other != kOther.end()) return {other->second};
  if (value[0] == '\'') return {"'OTHER'"};
  if (value[0] == '(' && value[1] == '\'') return {"('B')"};
  if (value[0] == '(' && value[1] == '#') return {};
  if (value[0] != '(')
    return {value.find('.') == std::string::npos ? std::to_string(std::stoi(value) + 1)
                                                 : std::to_string(std::stod(value) * 1.25 + 0.11)};
  std::vector<std::string> all;
  std::size_t begin = 1;
  while (begin < value.size()) {
    const std::size_t end = value.find_first_of(",)", begin);
    const double number = std::stod(value.substr(begin, end - begin));
    all.push_back(value.substr(0, begin) + std::to_string(number + 0.75) + value.substr(end));
    begin = end + 1;
  }
  return all;
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

bool may_stay(const std::string& keyword, const std::string& word, bool taken_away) {
  if (!word.empty() && word[0] == '~') return true;
  const std::string name = !word.empty() && word[0] == '?' ? word.substr(1) : word;
  for (const Unchanged& one : kUnchanged)
    if (keyword == one.keyword && (name == one.attribute || std::string(one.attribute).empty()))
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

/// Whether the file with another value is seen to be another.
bool is_seen(const std::vector<Entity>& whole, std::size_t entity, std::size_t argument,
             const std::string& value, const std::string& before) {
  std::vector<Entity> mutated = whole;
  mutated[entity].arguments[argument] = value;
  return seen(mutated) != before;
}

TEST(StepNcMutation, EachAttributeChangedOrTakenAwayAloneIsSeen) {
  const std::vector<Entity> whole = example();
  const std::string before = seen(whole);
  int mutations = 0;
  for (std::size_t e = 0; e < whole.size(); ++e) {
    for (std::size_t a = 0; a < whole[e].arguments.size(); ++a) {
      const std::string value = whole[e].arguments[a], word = row_word(whole[e].keyword, a);
      const std::vector<std::string> others = changed(value);
      if (!others.empty() && !may_stay(whole[e].keyword, word, false)) {
        ++mutations;
        EXPECT_TRUE(
            std::any_of(others.begin(), others.end(),
                        [&](const std::string& other) { return is_seen(whole, e, a, other, before); }))
            << whole[e].text() << " with another value for " << value << " (" << word << ")";
      }
      if (value == "$" || value == "()" || may_stay(whole[e].keyword, word, true)) continue;
      ++mutations;
      EXPECT_TRUE(is_seen(whole, e, a, value[0] == '(' ? "()" : "$", before))
          << whole[e].text() << " without " << value << " (" << word << ")";
    }
  }
  EXPECT_GT(mutations, 150);
}

}  // namespace
}  // namespace clearcut
