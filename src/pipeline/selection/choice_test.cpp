// Plans chosen by figures of their certificates.
#include "pipeline/selection/choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "pipeline/run.h"
#include "pipeline/tool_sets.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

Figures load_of(double force, double energy, double time, bool clean = true) {
  Figures figures;
  figures.load = CuttingLoad{};
  figures.load->max_force_n = force;
  figures.load->energy_j = energy;
  figures.time_s = time;
  figures.clean = clean;
  return figures;
}

std::vector<double> costs(const std::string& objective, const std::vector<Figures>& plans) {
  std::vector<const Figures*> all;
  for (const Figures& plan : plans) all.push_back(&plan);
  return costs_of(parse_objective(objective, "objective"), all);
}

TEST(Choice, OneQuantityIsItsFigure) {
  const std::vector<Figures> plans{load_of(200, 30, 10), load_of(100, 50, 40)};
  EXPECT_EQ(costs("force", plans), (std::vector<double>{200, 100}));
  EXPECT_EQ(costs("energy", plans), (std::vector<double>{30, 50}));
}

TEST(Choice, WeightsAreSharesOfTheLeastOfEachQuantity) {
  const std::vector<Figures> plans{load_of(200, 0, 10), load_of(100, 0, 40), load_of(1, 0, 1, false)};
  const std::vector<double> both = costs("force=0.3,time=0.7", plans);
  EXPECT_DOUBLE_EQ(both[0], 0.3 * 2 + 0.7 * 1);
  EXPECT_DOUBLE_EQ(both[1], 0.3 * 1 + 0.7 * 4);
  EXPECT_TRUE(std::isinf(both[2])) << "what is not clean is neither taken nor compared with";
  EXPECT_EQ(costs("0.3:force,0.7:time", plans), both);
}

TEST(Choice, ClimbCountsWhatIsCutConventionally) {
  Figures figures;
  figures.clean = true;
  figures.engagement.climb_mm = 30;
  figures.engagement.conventional_mm = 10;
  EXPECT_EQ(costs("climb", {figures}), std::vector<double>{0.25});
}

TEST(Choice, ALoadThatIsNotKnownIsRefused) {
  Figures figures;
  figures.clean = true;
  figures.engagement.max_deg = 90;
  EXPECT_THROW(costs("wear", {figures}), InputError);
}

/// A step below another one can find its material gone.
TEST(Choice, APlanThatMeetsNoMaterialHasNoLoad) {
  Figures nothing;
  nothing.clean = true;
  EXPECT_EQ(costs("force", {nothing, load_of(100, 50, 40)}), (std::vector<double>{0, 100}));
  const std::vector<double> both =
      costs("1:force,1:energy", {nothing, load_of(100, 50, 40), load_of(200, 50, 10)});
  EXPECT_EQ(both, (std::vector<double>{0, 2, 3})) << "in units of the least load above 0";
}

Part pocket() {
  Part part;
  part.name = "pocket";
  Feature feature;
  feature.name = "POCKET";
  const Loop outline = loop_from_points(std::vector<Vec2>{{0, 0}, {40, 0}, {40, 25}, {0, 25}});
  feature.target = feature.allowed = {Region::from_valid_loops(outline, {})};
  feature.floor_z = -2;
  part.features = {feature};
  part.workplan.resize(1);
  part.workplan.front().feature = 0;
  return part;
}

PlanOptions by(const std::string& objective, const std::string& strategy = "") {
  PlanOptions options;
  options.tools = {resolve::parse_tool("endmill:8")};
  options.objective = objective;
  options.shop.material = "steel";
  options.shop.style = "fastest";
  if (!strategy.empty()) options.strategy = strategy;
  return options;
}

double cost_of_named(const std::string& quantity, const std::string& strategy) {
  const PlanResult one = plan_part(pocket(), by("time", strategy));
  return one.findings.all.clean
             ? figure_of(parse_objective(quantity, "").terms.front().kind, one.findings.all)
             : std::numeric_limits<double>::infinity();
}

class ChosenByFigures : public testing::TestWithParam<const char*> {};

/// The choice is no worse than each strategy by itself, planned and certified alone.
TEST_P(ChosenByFigures, NoStrategyAloneIsBetter) {
  const ObjectiveKind kind = parse_objective(GetParam(), "").terms.front().kind;
  const PlanResult chosen = plan_part(pocket(), by(GetParam()));
  ASSERT_EQ(verdict_and_reasons(chosen.findings), "CLEAN\n");
  const double cost = figure_of(kind, chosen.findings.all);
  for (const char* strategy : {"contour", "zigzag", "spiral", "adaptive"})
    EXPECT_LE(cost, cost_of_named(GetParam(), strategy) * (1 + 1e-9)) << strategy;
  const auto& candidates = chosen.selections.front().candidates;
  ASSERT_TRUE(candidates.front().cost);
  EXPECT_NEAR(*candidates.front().cost, cost, 1e-9 * cost) << "of the program that is written";
  for (const CandidateResult& other : candidates)
    EXPECT_GE(other.cost.value_or(cost), cost - 1e-9 * cost) << other.strategy;
}

INSTANTIATE_TEST_SUITE_P(Quantities, ChosenByFigures, testing::Values("force", "energy", "wear", "climb"));

TEST(Choice, TheLightestProgramIsNotTheFastest) {
  const PlanResult fastest = plan_part(pocket(), by("time")), lightest = plan_part(pocket(), by("force"));
  EXPECT_LT(lightest.findings.all.load->max_force_n, 0.9 * fastest.findings.all.load->max_force_n);
  EXPECT_GT(lightest.findings.all.time_s, fastest.findings.all.time_s);
}

/// The style of metals aims at an engagement, which by itself leaves adaptive clearing alone.
TEST(Choice, StrategiesCompeteInTheStyleOfMetals) {
  PlanOptions options = by("energy");
  options.shop.style.reset();
  EXPECT_GT(plan_part(pocket(), options).selections.front().planned(), 1U);
}

TEST(Choice, ToursAreChosenAmongTheirOrders) {
  const PlanResult plan = plan_part(pocket(), by("energy=1,time=1", "tour"));
  const auto& candidates = plan.selections.front().candidates;
  ASSERT_EQ(candidates.size(), 5u);
  for (const CandidateResult& one : candidates) EXPECT_NE(one.order, "") << one.strategy;
}

std::string refusal(const PlanOptions& options) {
  try {
    plan_part(pocket(), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Choice, WhatCannotServeIsRefused) {
  PlanOptions options = by("force");
  options.shop.material.reset();
  EXPECT_THAT(refusal(options), HasSubstr("add --material"));
  options = by("climb");
  options.shop.material.reset();
  EXPECT_EQ(refusal(options), "") << "needs no material";
  EXPECT_THAT(refusal(by("force=1,engagement=1")), HasSubstr("order of a tour alone"));
  options = by("force", "zigzag");
  options.sources.set("objective", {Origin::kUser, "--objective"});
  EXPECT_THAT(refusal(options), HasSubstr("there is one"));
}

/// Few teeth of a large cutter take large chips: the small one is slower and lighter.
TEST(Choice, CuttersAreChosenByTheirLoad) {
  const auto compared = [](const std::string& objective) {
    PlanOptions options = by(objective, "zigzag");
    options.tools = {resolve::parse_tool("endmill:4"), resolve::parse_tool("endmill:10")};
    options.sources.set("objective", {Origin::kUser, "--objective"});
    return compare_tools(pocket(), {}, options);
  };
  const ToolComparison by_force = compared("force");
  ASSERT_NE(best_tool(by_force), nullptr);
  for (const ToolRun& run : by_force.runs)
    EXPECT_GE(run.figures.load->max_force_n, best_tool(by_force)->figures.load->max_force_n);
  EXPECT_FALSE(by_force.sequence);
  EXPECT_NE(best_tool(by_force)->tool.diameter, best_tool(compared("energy=0,time=1"))->tool.diameter);
}

}  // namespace
}  // namespace clearcut::pipeline
