// For tests: curves as drawings hold them, and what repair makes of them.
#pragma once

#include <gtest/gtest.h>

#include "base/error.h"
#include "read/repair/repair.h"

namespace clearcut::read::testing {

inline RawCurve closed(std::vector<Vec2> points) {
  return {loop_from_points(points), true, "outline", {}};
}

inline RawCurve open(std::vector<Vec2> points) {
  RawCurve curve{{}, false, "line", {}};
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    curve.edges.push_back(Edge::line(points[i], points[i + 1]));
  return curve;
}

struct Repaired {
  Regions regions;
  std::vector<Diagnostic> said;
  int count(Severity severity, const std::string& text = "") const {
    return static_cast<int>(std::count_if(said.begin(), said.end(), [&](const Diagnostic& d) {
      return d.severity == severity && (d.where + d.what).find(text) != std::string::npos;
    }));
  }
};

inline RepairOptions options() {
  RepairOptions out;
  out.where = "test.dxf";
  return out;
}

inline Repaired repaired(std::vector<RawCurve> curves, const RepairOptions& how = options()) {
  Diagnostics diagnostics;
  Repaired out;
  out.regions = repair(std::move(curves), how, diagnostics);
  out.said = diagnostics.items();
  return out;
}

inline std::string refusal(std::vector<RawCurve> curves, const RepairOptions& how = options()) {
  try {
    repaired(std::move(curves), how);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "not refused";
}

}  // namespace clearcut::read::testing
