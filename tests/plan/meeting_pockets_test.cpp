// Pockets that meet where their outlines all but coincide: planner and verifier are of one mind about the wall between them.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "pipeline/run.h"

namespace clearcut {
namespace {

Feature pocket(const char* name, const std::vector<Vec2>& corners) {
  Feature feature;
  feature.name = name;
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  feature.floor_z = -1;
  return feature;
}

/// A pocket, and another one round three sides of it with a wall of `thickness` mm between them (less than 0: they
/// overlap).
Part part_with_wall(double thickness) {
  const double t = thickness;
  Part part;
  part.name = part.source_file = "wall";
  part.features = {
      pocket("inner", {{0, 0}, {12, 0}, {12, 10}, {0, 10}}),
      pocket("around",
             {{-10, -10}, {22, -10}, {22, 10}, {12 + t, 10}, {12 + t, -t}, {-t, -t}, {-t, 10}, {-10, 10}})};
  for (int i = 0; i < 2; ++i) {
    Workingstep step;
    step.feature = i;
    part.workplan.push_back(step);
  }
  return part;
}

TEST(MeetingPockets, AreOneOverAWallThinnerThanTheRoundingOfADrawing) {
  Tool mill;
  mill.diameter = 1;
  resolve::PlanOptions options;
  options.tools = {mill};
  options.strategy = "contour";
  for (const double thickness : {-0.001, -4e-6, 1e-7, 4e-6, 9e-6, 1.2e-5, 1e-4, 0.001}) {
    const auto result = pipeline::plan_part(part_with_wall(thickness), options);
    for (const auto& fault : result.findings.faults)
      ADD_FAILURE() << "wall of " << thickness << " mm: " << fault.text;
  }
}

}  // namespace
}  // namespace clearcut
