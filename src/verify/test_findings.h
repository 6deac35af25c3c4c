// For tests: findings of programs written by hand.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "model/results/findings.h"
#include "verify/test_program.h"

namespace clearcut::testing {

inline std::string report_of(const Findings& findings) {
  std::string text;
  for (const Fault& fault : findings.faults)
    text += std::string(name_of(fault.kind)) + ": " + fault.text + "\n";
  return text;
}

inline bool has(const Findings& findings, FaultKind kind) {
  for (const Fault& fault : findings.faults) {
    if (fault.kind == kind) return true;
  }
  return false;
}

inline const Fault& fault_of(const Findings& findings, FaultKind kind) {
  for (const Fault& fault : findings.faults) {
    if (fault.kind == kind) return fault;
  }
  throw std::runtime_error("no such fault");
}

/// The square pocket 0..50, 2 mm deep, in rings for a 6 mm cutter: half widths of the rings about (25, 25).
inline const std::vector<double> kRings{2, 6.5, 11, 15.5, 19.5, 22};

inline Part square_part() {
  return pocket_part(rectangle(0, 0, 50, 50), 6, -2);
}

inline Toolpath square_program(const std::vector<double>& rings, double z = -2, Vec2 center = {25, 25}) {
  Writer writer;
  cut_square_rings(writer, center, rings, 0, z);
  return writer.done();
}

inline Part island_part() {
  const Regions outer = rectangle(0, 0, 60, 60);
  const Regions outline{Region::from_valid_loops(outer[0].outer(), {circle_loop({30, 30}, 10)})};
  return pocket_part(outline, 10, -2);
}

inline Toolpath island_program(double ring) {
  Writer writer;
  const Vec2 c{30, 30};
  writer.enter({5, 5}, 0, -2).feed({55, 5}).feed({55, 55}).feed({5, 55}).feed({5, 5});
  writer.feed({9, 9}).feed({51, 9}).feed({51, 51}).feed({9, 51}).feed({9, 9});
  for (const double r : {23.0, 19.0, ring}) {
    writer.feed(c + Vec2{-r, 0});
    writer.arc(c + Vec2{r, 0}, c, Turn::kCounterClockwise).arc(c - Vec2{r, 0}, c, Turn::kCounterClockwise);
  }
  return writer.done();
}

}  // namespace clearcut::testing
