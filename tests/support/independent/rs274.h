// LinuxCNC's own interpreter, where it is installed: what it makes of a program.
#pragma once

#include <string>
#include <vector>

#include "model/move.h"

namespace clearcut::test_support {

/// One motion of the interpreter's canonical output, in mm.
struct CanonMove {
  bool rapid = false;
  int turns = 0;  ///< 0 straight; arcs in XY: > 0 counter-clockwise, number of turns begun
  Vec2 to;
  double z = 0;
  Vec2 center;  ///< arcs
  double feed = 0;
};

struct CanonProgram {
  bool accepted = false;
  std::string message;  ///< its complaint
  std::vector<CanonMove> moves;
  std::string canon;  ///< the output itself
};

bool has_rs274();
/// `tool_diameter`: of every tool in its table, in inches, which are its machine's unit.
CanonProgram run_rs274(const std::string& program, double tool_diameter = 6);

/// Same motion: each canonical move is met by our moves of one program line, in order, with the same feed,
/// and every sampled point agrees within `tolerance`. Motion before the first feed move is left out: where
/// the control stands at the start is its own affair.
void expect_same_motion(const CanonProgram& canon, const Toolpath& toolpath, double tolerance);

}  // namespace clearcut::test_support

#define CLEARCUT_SKIP_WITHOUT_RS274()                                                        \
  if (!clearcut::test_support::has_rs274()) {                                                \
    GTEST_SKIP() << "rs274 is absent; install the package linuxcnc-uspace to run this test"; \
  }
