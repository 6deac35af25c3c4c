// For tests: Part 21 programs with one feature, and what was made of them.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "base/error.h"
#include "read/stepnc/stepnc.h"

namespace clearcut::read::stepnc::testing {

/// A program on a block x 0..100, y 0..80, z -20..0 with one workingstep (#10) on the feature #20, 5 mm deep,
/// by a 10 mm end mill. Entities given by number replace or add to these.
class Program {
 public:
  Program& with(int id, const std::string& entity) {
    entities_[id] = entity;
    return *this;
  }
  Program& feature(const std::string& entity) { return with(20, entity); }

  std::string text() const {
    std::string out = "ISO-10303-21;\nHEADER;\n";
    if (!writer_.empty()) out += "FILE_NAME('','',(''),(''),'','" + writer_ + "','');\n";
    out += "FILE_SCHEMA(('" + schema_ + "'));\nENDSEC;\nDATA;\n";
    for (const auto& [id, entity] : entities_) out += "#" + std::to_string(id) + "=" + entity + ";\n";
    return out + "ENDSEC;\nEND-ISO-10303-21;\n";
  }
  Program& schema(const std::string& name) {
    schema_ = name;
    return *this;
  }
  /// The originating system that the header names.
  Program& by(const std::string& writer) {
    writer_ = writer;
    return *this;
  }
  Part read() const { return read_stepnc(text(), "t.p21", {}); }
  std::string error() const {
    try {
      read();
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  }

 private:
  std::string schema_ = "MACHINING_SCHEMA";
  std::string writer_;
  std::map<int, std::string> entities_ = {
      {1, "PROJECT('P',#2,(#3),$,$,$)"},
      {2, "WORKPLAN('MAIN',(#10),$,#4,$)"},
      {3, "WORKPIECE('WP',$,$,$,$,#5,())"},
      {4, "SETUP('S',$,#7,(#9))"},
      {5, "BLOCK('B',#6,100.,80.,20.)"},
      {6, "AXIS2_PLACEMENT_3D('',#60,$,$)"},
      {60, "CARTESIAN_POINT('',(0.,0.,-20.))"},
      {7, "PLANE('SECURITY',#8)"},
      {8, "AXIS2_PLACEMENT_3D('',#61,$,$)"},
      {61, "CARTESIAN_POINT('',(0.,0.,30.))"},
      {9, "WORKPIECE_SETUP(#3,#21,$,$,())"},
      {10, "MACHINING_WORKINGSTEP('WS1',#7,#20,#30,$)"},
      {20, "CLOSED_POCKET('POCKET',#3,(#30),#21,#23,(),$,#26,$,$,#27)"},
      {21, "AXIS2_PLACEMENT_3D('',#22,$,$)"},
      {22, "CARTESIAN_POINT('',(0.,0.,0.))"},
      {23, "PLANE('DEPTH',#24)"},
      {24, "AXIS2_PLACEMENT_3D('',#25,$,$)"},
      {25, "CARTESIAN_POINT('',(0.,0.,-5.))"},
      {26, "PLANAR_POCKET_BOTTOM_CONDITION()"},
      {27, "RECTANGULAR_CLOSED_PROFILE(#28,#62,#63)"},
      {28, "AXIS2_PLACEMENT_3D('',#29,$,$)"},
      {29, "CARTESIAN_POINT('',(50.,40.,0.))"},
      {62, "TOLERANCED_LENGTH_MEASURE(20.,$)"},
      {63, "TOLERANCED_LENGTH_MEASURE(60.,$)"},
      {30, "BOTTOM_AND_SIDE_ROUGH_MILLING($,$,'OP',8.,$,#31,#34,#35,$,#36,$,#37,2.,4.,0.3,0.1)"},
      {31, "MILLING_CUTTING_TOOL('T5',#32,(),$,$,$)"},
      {32, "ENDMILL(#33,3,.RIGHT.,$,$)"},
      {33, "MILLING_TOOL_DIMENSION(10.,$,$,25.,0.5,$,$)"},
      {34, "MILLING_TECHNOLOGY(0.01,.TCP.,$,-100.,$,$,$,$,$)"},
      {35, "MILLING_MACHINE_FUNCTIONS(.T.,$,$,.F.,$,(),.F.,$,$,())"},
      {36, "PLUNGE_RAMP($,0.05)"},
      {37, "CONTOUR_PARALLEL(0.5,.T.,.CCW.,.CONVENTIONAL.)"}};
};

inline std::string all_diagnostics(const Part& part) {
  std::string all;
  for (const Diagnostic& d : part.diagnostics.items()) all += d.where + ": " + d.what + "\n";
  return all;
}

inline int count_of(const Part& part, Severity severity) {
  int count = 0;
  for (const Diagnostic& d : part.diagnostics.items()) count += d.severity == severity;
  return count;
}

inline void expect_box(const Regions& regions, double x0, double x1, double y0, double y1) {
  const Box b = box(regions);
  EXPECT_NEAR(b.min.x, x0, 1e-6);
  EXPECT_NEAR(b.max.x, x1, 1e-6);
  EXPECT_NEAR(b.min.y, y0, 1e-6);
  EXPECT_NEAR(b.max.y, y1, 1e-6);
}

inline Program step(double x, const std::string& direction) {
  Program p;
  p.feature("STEP('STEP',#3,(#30),#21,#23,#70,$,())")
      .with(22, "CARTESIAN_POINT('',(" + std::to_string(x) + ",0.,0.))");
  p.with(70, "LINEAR_PATH($,#72,#73)").with(72, "TOLERANCED_LENGTH_MEASURE(80.,$)");
  return p.with(73, "DIRECTION('',(" + direction + "))").with(9, "WORKPIECE_SETUP(#3,$,$,$,())");
}

}  // namespace clearcut::read::stepnc::testing
