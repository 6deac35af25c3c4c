// CPO-kappa's claim, "any concave or convex polygon without uncut regions", on random simple polygons given by lengths and angles.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "base/error.h"
#include "geometry/side_list.h"
#include "pipeline/run.h"
#include "pipeline/selection/strategies.h"
#include "plan/contour/ring_band.h"
#include "plan/contour/step_rule.h"
#include "studies/random_polygon.h"
#include "studies/reproduce/planned_outline.h"

namespace clearcut::studies {
namespace {

int polygons() {
  constexpr int kFew = 4;
  const char* asked = std::getenv("CLEARCUT_CLAIM_POLYGONS");
  return asked == nullptr ? kFew : std::atoi(asked);
}

/// Lengths and interior angles of a polygon, as the paper has them.
SideList sides_of(const Loop& outline) {
  SideList list;
  const auto count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Edge &edge = outline[i], &next = outline[(i + 1) % count];
    const Vec2 in = edge.tangent_at(1), out = next.tangent_at(0);
    list.sides.push_back({edge.length(), kPi - std::atan2(cross(in, out), dot(in, out)), 0});
  }
  return list;
}

/// By lengths and angles; absent for pockets with arcs or islands.
std::optional<Part> polygon_part(const RandomPocket& pocket) {
  if (pocket.kind == "arcs" || pocket.kind == "islands") return std::nullopt;
  const Region& drawn = pocket.part.features.front().target.front();
  const Region outline = outline_of(sides_of(drawn.outer()));
  EXPECT_NEAR(outline.area(), drawn.area(), 1e-6 * drawn.area());
  return pocket_part(outline, pocket.kind, pocket.part.tools.front().diameter);
}

/// Which step of the text leaves the material: by the rests that rings leave; "split" where they leave none of these.
std::string failing_step(const Part& part) {
  const auto rest = plan::contour::worst_rest(part.features.front().allowed, *pipeline::published_rule("lom"),
                                              part.tools.front().radius(), {});
  return rest.cause == plan::contour::RestCause::kNone ? "other" : name_of(rest.cause);
}

/// lom-corrected is the cure of whatever lom leaves; nothing is gouged by either.
TEST(PolygonClaim, WhatTheTextLeavesTheCorrectedMethodCuts) {
  int planned = 0, clean = 0;
  std::map<std::string, int> steps;
  for (std::uint64_t seed = 1; planned < polygons(); ++seed) {
    const auto part = polygon_part(random_pocket(seed, {}));
    if (!part) continue;
    const auto text = planned_outline(*part, {"lom"}), cure = planned_outline(*part, {"lom-corrected"});
    ASSERT_TRUE(text && cure) << seed;
    ++planned;
    EXPECT_TRUE(cure->findings.all.clean) << seed;
    EXPECT_LE(text->findings.all.gouge_mm, 0.001) << seed;
    clean += text->findings.all.clean ? 1 : 0;
    if (!text->findings.all.clean) ++steps[part->name + ", " + failing_step(*part)];
  }
  std::string why;
  for (const auto& [step, count] : steps) why += "; " + step + " " + std::to_string(count);
  RecordProperty("clean", clean);
  if (polygons() > 10) std::printf("%d of %d clean%s\n", clean, planned, why.c_str());
}

}  // namespace
}  // namespace clearcut::studies
