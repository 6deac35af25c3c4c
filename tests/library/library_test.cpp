// The library as its users see it: nothing but <clearcut/clearcut.h>.
#include <clearcut/clearcut.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <mutex>
#include <thread>

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr const char* kPocket = R"({"name": "pocket", "units": "mm", "top": 0, "depth": 4,
  "outer": [[0, 0, 0], [60, 0, 0], [60, 40, 0], [30, 40, 0], [30, 25, 0], [0, 25, 0]]})";

clearcut::Part pocket() {
  return clearcut::read_part_text(kPocket, "pocket.json", {});
}

clearcut::PlanOptions options_for(const std::string& strategy) {
  clearcut::PlanOptions options;
  options.tools = {clearcut::parse_tool("endmill:6")};
  options.strategy = strategy;
  return options;
}

TEST(Library, PlansChecksAndShows) {
  const clearcut::PlanOptions options = options_for("contour");
  const clearcut::PlanResult plan = clearcut::plan_part(pocket(), options);
  EXPECT_TRUE(plan.findings.all.clean);
  EXPECT_NE(clearcut::write_certificate(plan, options, kPocket).find("\"clean\": true"), std::string::npos);
  EXPECT_NE(clearcut::write_picture(plan).find("<svg"), std::string::npos);
  EXPECT_NE(clearcut::write_page(plan, options).find("<html"), std::string::npos);
  EXPECT_NE(clearcut::write_table(plan).find("pocket"), std::string::npos);
  const auto check = clearcut::check_program(pocket(), plan.program, "pocket.ngc", options);
  EXPECT_TRUE(check.findings.all.clean);
  EXPECT_EQ(clearcut::write_table(check), clearcut::write_table(plan));
}

TEST(Library, OffsetsRegionsAndKnowsTheirClearance) {
  const clearcut::Tolerances tol;
  const clearcut::Region region = pocket().features.front().target.front();
  const clearcut::Clearance clearance(region, tol);
  EXPECT_NEAR(clearance.max(), 16.27, 0.01);  // touches two sides and the corner at (30, 25)
  const clearcut::Regions inner = clearance.inset(3);
  ASSERT_EQ(inner.size(), 1U);
  EXPECT_NEAR(clearcut::area(inner), clearcut::area({region}) - 3 * 200 + 5 * 9 - clearcut::kPi / 4 * 9, 1);
  EXPECT_TRUE(clearcut::subtract(inner, {region}, tol).empty());
}

TEST(Library, ProgressGrowsStageByStage) {
  clearcut::PlanOptions options = options_for("auto");
  std::vector<clearcut::Progress> told;
  options.progress = [&](const clearcut::Progress& at) { told.push_back(at); };
  clearcut::plan_part(pocket(), options);
  ASSERT_GT(told.size(), 3U);
  EXPECT_EQ(told.front().stage, clearcut::Stage::kPlanning);
  EXPECT_EQ(told.front().done, 0U);
  EXPECT_EQ(told.back().stage, clearcut::Stage::kCertifying);
  EXPECT_EQ(told.back().done, told.back().most);
  for (std::size_t i = 1; i < told.size(); ++i) {
    EXPECT_LE(told[i].done, told[i].most);
    EXPECT_TRUE(told[i].stage != told[i - 1].stage || told[i].done > told[i - 1].done);
  }
}

TEST(Library, WhatIsCancelledBeforeItBeginsNeverBegins) {
  std::stop_source stop;
  stop.request_stop();
  clearcut::PlanOptions options = options_for("contour");
  options.cancel = stop.get_token();
  bool told = false;
  options.progress = [&](const clearcut::Progress&) { told = true; };
  EXPECT_THROW(clearcut::plan_part(pocket(), options), clearcut::Cancelled);
  EXPECT_FALSE(told);
}

/// Wherever the plan is when it is asked to stop: at the first candidate, at the last, while it is certified.
TEST(Library, PlansEndAtAnyPoint) {
  for (std::size_t calls = 1;; ++calls) {
    std::stop_source stop;
    clearcut::PlanOptions options = options_for("auto");
    options.cancel = stop.get_token();
    std::size_t told = 0;
    options.progress = [&](const clearcut::Progress& at) {
      const bool last = at.stage == clearcut::Stage::kCertifying && at.done == at.most;
      if (++told == calls && !last) stop.request_stop();
    };
    try {
      clearcut::plan_part(pocket(), options);
      EXPECT_GT(calls, 3U);
      return;
    } catch (const clearcut::Cancelled&) {
      EXPECT_EQ(told, calls) << "nothing is told after the wish to stop";
    }
  }
}

/// Long searches look, too: the deepest is that of adaptive clearing.
TEST(Library, PlansEndWithinASecond) {
  const auto part = clearcut::read_part(CLEARCUT_SOURCE_DIR "/examples/fishhead.p21", {});
  for (const char* strategy : {"adaptive", "contour", "tour"}) {
    for (const auto after : {5ms, 50ms, 300ms}) {
      clearcut::PlanOptions options;
      options.strategy = strategy;
      std::stop_source stop;
      options.cancel = stop.get_token();
      Clock::time_point asked;
      std::jthread watch([&] {
        std::this_thread::sleep_for(after);
        asked = Clock::now();
        stop.request_stop();
      });
      bool cancelled = false;
      try {
        clearcut::plan_part(part, options);
      } catch (const clearcut::Cancelled&) {
        cancelled = true;
      }
      const auto ended = Clock::now();
      watch.join();
      EXPECT_TRUE(cancelled || after > 5ms) << strategy;
      EXPECT_TRUE(!cancelled || ended - asked < 1s)
          << strategy << " ended " << std::chrono::duration<double>(ended - asked).count() << " s after";
    }
  }
}

TEST(Library, ManyThreadsPlanTheSameBytes) {
  const auto plan = [](const char* strategy, int threads) {
    clearcut::PlanOptions options = options_for(strategy);
    options.threads = threads;
    return clearcut::plan_part(pocket(), options).program;
  };
  std::vector<std::future<std::string>> programs;
  for (const char* strategy : {"auto", "adaptive", "auto", "adaptive"})
    programs.push_back(std::async(std::launch::async, plan, strategy, 2));
  const std::string chosen = plan("auto", 1), adaptive = plan("adaptive", 1);
  for (std::size_t i = 0; i < programs.size(); ++i)
    EXPECT_EQ(programs[i].get(), i % 2 == 0 ? chosen : adaptive);
}

TEST(Library, FiguresOfMovesAreThoseOfTheWhole) {
  const clearcut::PlanOptions options = options_for("contour");
  const auto plan = clearcut::plan_part(pocket(), options);
  const auto figures = clearcut::figures_of_moves(plan.part, plan.toolpath, plan.control, options);
  const auto times = clearcut::times_of_moves(plan.part, plan.toolpath, plan.control, options);
  std::size_t count = 0;
  for (const auto& section : plan.toolpath.sections) count += section.moves.size();
  ASSERT_EQ(figures.size(), count);
  ASSERT_EQ(times.size(), count);
  double time = 0, air = 0, most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(figures[i].time_s, times[i]);
    EXPECT_LE(figures[i].mean_engagement_deg, figures[i].max_engagement_deg + 1e-9);
    time += times[i];
    air += figures[i].air_mm;
    most = std::max(most, figures[i].max_engagement_deg);
  }
  EXPECT_NEAR(time, plan.findings.all.time_s, 1e-6);
  EXPECT_NEAR(air, plan.findings.all.air_cut_mm, 1e-6);
  EXPECT_NEAR(most, plan.findings.all.engagement.max_deg, 1e-9);
}

TEST(Library, AJobGivesPartAndOptions) {
  const auto job = clearcut::read_job_text(R"([part]
file = "pocket.json"
[plan]
strategy = "zigzag"
stepover = 0.3
seed = 7
[[tool]]
number = 4
kind = "endmill"
diameter = 6
[output]
post = "grbl"
)",
                                           "job.toml");
  const clearcut::PlanOptions options = clearcut::options_of_job(job);
  EXPECT_EQ(options.stepover, "0.3");
  EXPECT_EQ(options.seed, 7U);
  EXPECT_EQ(options.post.dialect, "grbl");
  EXPECT_EQ(options.tool_cutting.size(), 1U);
  EXPECT_THROW(clearcut::options_of_job(clearcut::read_job_text(
                   "[part]\nfile = \"pocket.json\"\n[plan]\nstrategy = \"best\"\n", "job.toml")),
               clearcut::InputError);
}

/// A strategy from nothing but the public headers: the walls, and nothing between them.
TEST(Library, TakesStrategiesOfOnesOwn) {
  clearcut::StrategyEntry entry;
  entry.name = "walls";
  entry.make = [](const clearcut::StrategyRequest& request) {
    return clearcut::once_per_outline([tol = request.plan.tol](const clearcut::Layer& layer) {
      return clearcut::clearing_area(layer, tol).walls;
    });
  };
  auto entries = clearcut::built_in_strategies().entries();
  entries.push_back(entry);
  const clearcut::StrategyTable table(std::move(entries));
  clearcut::PlanOptions options = options_for("walls");
  options.strategies = &table;
  const auto plan = clearcut::plan_part(pocket(), options);
  EXPECT_EQ(plan.selections.at(0).kept(), "walls");
  EXPECT_FALSE(plan.findings.all.clean) << "the middle is left to stand, and the certificate says so";
}

TEST(Library, ToursEndWhenTheyAreAskedTo) {
  clearcut::TourOptions options;
  options.time_s = 60;
  std::stop_source stop;
  options.cancel = stop.get_token();
  std::jthread watch([&] {
    std::this_thread::sleep_for(100ms);
    stop.request_stop();
  });
  clearcut::order::Problem problem;
  for (int i = 0; i < 20'000; ++i)
    problem.points.push_back({i * 7919 % 10'007 + 0.5, i * 104'729 % 9973 + 0.25});
  const auto began = Clock::now();
  EXPECT_THROW(clearcut::solve_tour(problem, options), clearcut::Cancelled);
  EXPECT_LT(Clock::now() - began, 10s);
}

TEST(Library, OrdersPointsOfOnesOwn) {
  clearcut::order::Problem problem;
  problem.points = {{0, 0}, {10, 0}, {0, 10}, {10, 10}};
  EXPECT_NEAR(clearcut::solve_tour(problem, {}).solution.length, 40, 1e-9);
  problem.points.clear();
  EXPECT_THROW(clearcut::solve_tour(problem, {}), clearcut::InputError);
}

TEST(Library, BadFilesAreErrorsOfOneLine) {
  try {
    clearcut::read_part_text("{\"outer\": [[0, 0]]}", "bad.json", {});
    FAIL();
  } catch (const clearcut::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("bad.json"), std::string::npos);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

}  // namespace
