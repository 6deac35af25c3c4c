// The published methods, their input and their tables, from the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "geometry/contours/boolean.h"
#include "pipeline/run.h"
#include "pipeline/tool_sets.h"
#include "read/job/read_part.h"
#include "report/certificate/certificate_json.h"
#include "studies/method_study.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using namespace nlohmann::literals;

const std::string kTriangle = "name triangle\ndepth 2\n79.9861 60\n79.9861 60\n79.9861 60\n";

TEST(LengthsAndAngles, AreConvertedToOutlinesAndStepNc) {
  const ScratchFolder folder;
  const auto input =
      folder.file("plate.edges", "start 10 5\norientation 30\ndepth 4\n60 90 8\n40 90\n60 90 5\n40 90\n");
  const Part part = read::read_part(input, {});
  for (const char* name : {"plate.json", "plate.p21"}) {
    const auto result = run_clearcut({"convert", input, "-o", folder.path(name)});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("closing error 0 mm"));
    const Part again = read::read_part(folder.path(name), {});
    ASSERT_EQ(again.features.size(), 1u);
    EXPECT_NEAR(area(subtract(again.features[0].target, part.features[0].target, {})), 0, 1e-3) << name;
    EXPECT_NEAR(area(again.features[0].target), area(part.features[0].target), 1e-6) << name;
  }
}

TEST(LengthsAndAngles, StepNcNamesTheToolAskedFor) {
  const ScratchFolder folder;
  const auto input = folder.file("triangle.edges", kTriangle);
  ASSERT_EQ(run_clearcut({"convert", input, "-o", folder.path("a.p21"), "--tool", "endmill:7"}).exit_code, 0);
  EXPECT_EQ(read::read_part(folder.path("a.p21"), {}).tools.at(0).diameter, 7);
  const auto result = run_clearcut({"convert", input, "-o", folder.path("b.p21")});
  EXPECT_THAT(result.err, HasSubstr("an end mill of 23 mm is written"));
}

TEST(LengthsAndAngles, ArePlannedAndCertified) {
  const ScratchFolder folder;
  const auto input = folder.file("triangle.edges", kTriangle);
  const auto result = run_clearcut({"plan", input, "--tool", "endmill:10", "-o", folder.path("a.ngc")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(Methods, ToolsAreDrivenByTheirSpeeds) {
  Tool tool;
  tool.diameter = 10;
  tool.teeth = 3;
  const CuttingData data = pipeline::driven(tool, 36.6, 0.05);
  EXPECT_NEAR(*data.spindle_rpm, 1165.0, 0.1);
  EXPECT_NEAR(data.feed->mm_per_min(), 174.8, 0.05);
}

/// Every subset of the cutters that leaves no more than the smallest, planned as one job with rest machining.
double fastest_by_trial(const Part& part, const std::vector<Tool>& tools, double tool_change_s,
                        PlanOptions options) {
  const auto planned = [&](const std::vector<Tool>& of) {
    options.tools = of;
    return pipeline::plan_part(part, options).findings.all;
  };
  options.shop.rest = true;
  const double corners = planned({tools.front()}).unreachable_mm2;
  double best = std::numeric_limits<double>::infinity();
  for (unsigned subset = 1; subset < (1U << tools.size()); ++subset) {
    std::vector<Tool> chosen;
    for (std::size_t i = tools.size(); i-- > 0;) {
      if ((subset >> i & 1U) != 0) chosen.push_back(tools[i]);
    }
    const auto figures = planned(chosen);
    if (!figures.clean || figures.unreachable_mm2 > corners + 0.1) continue;
    best = std::min(best, figures.time_s + tool_change_s * (static_cast<double>(chosen.size()) - 1));
  }
  return best;
}

TEST(Methods, NoSubsetOfTheCuttersIsFasterThanTheBestSequence) {
  const ScratchFolder folder;
  const char* sharp = "name sharp\ndepth 4\n140 90\n90 90\n140 90\n90 90\n";
  const char* round = "name round\ndepth 4\n100 90 12\n60 90 12\n100 90 12\n60 90 12\n";
  for (const char* outline : {sharp, round}) {
    const Part part = read::read_part(folder.file("part.edges", outline), {});
    std::vector<Tool> tools(4);
    for (std::size_t i = 0; i < tools.size(); ++i) {
      tools[i].diameter = std::array{4.0, 8.0, 14.0, 20.0}[i];
      tools[i].number = static_cast<int>(i) + 1;
    }
    PlanOptions options;
    options.tools = tools;
    options.strategy = "lom-corrected";
    ToolSpeeds speeds;
    speeds.tool_change_s = 5;
    const auto sequence = pipeline::fastest_sequence(part, speeds, options);
    ASSERT_TRUE(sequence) << outline;
    const double by_trial = fastest_by_trial(part, tools, speeds.tool_change_s, options);
    EXPECT_LE(sequence->time_s, by_trial * 1.02) << outline;
    EXPECT_GE(sequence->time_s, by_trial * 0.98) << outline;
  }
}

TEST(Methods, ToolTableNamesTheFastestAndWhatDoesNotFit) {
  const ScratchFolder folder;
  const auto input = folder.file("triangle.edges", kTriangle);
  const auto result =
      run_clearcut({"tools", input, "--tool", "endmill:20", "--tool", "endmill:6", "--tool", "endmill:60",
                    "--cutting-speed", "36.6", "--feed-per-tooth", "0.04", "0.05", "0.06"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, ContainsRegex("endmill 6 [*]? +2 +1942 +194 "));
  EXPECT_THAT(result.out, ContainsRegex("endmill 60 +does not fit"));
  EXPECT_THAT(result.out, HasSubstr(" *"));
  EXPECT_EQ(run_clearcut({"tools", input}).exit_code, 2) << "no tools";
  EXPECT_EQ(run_clearcut({"tools", input, "--tool", "endmill:6", "--cutting-speed", "-1"}).exit_code, 2);
}

TEST(Methods, ReproducedTablesDifferOnlyWhereTheirOutlinesAreNotPrinted) {
  for (const char* table : {"coefficients", "overlaps", "triangle", "captions", "grid"}) {
    const std::string out = run_clearcut({"reproduce", table}).out;
    EXPECT_THAT(out, Not(HasSubstr("(differs)"))) << table;
    EXPECT_THAT(out, ContainsRegex("printed cells: .* 0 differ")) << table;
  }
  EXPECT_THAT(run_clearcut({"reproduce", "coefficients"}).out,
              HasSubstr("63 printed cells: 0 agree, 63 computed"));
  EXPECT_THAT(run_clearcut({"reproduce", "overlaps"}).out,
              HasSubstr("54 printed cells: 0 agree, 54 computed"));
  const std::string overlaps = run_clearcut({"reproduce", "overlaps"}).out;
  EXPECT_THAT(overlaps,
              ContainsRegex("R = 5 mm, printed +0.09 +0.26 +0.42 +0.57 +0.71 +0.82 +0.91 +0.96 +1.00"));
  EXPECT_THAT(overlaps,
              ContainsRegex("R = 40 mm, ours +0.08 +0.24 +0.40 +0.56 +0.72 +0.80 +0.96 +0.96 +1.04"));
  EXPECT_THAT(overlaps,
              ContainsRegex("R = 50 mm, ours +0.10 +0.30 +0.40 +0.50 +0.70 +0.80 +0.90 +0.90 +1.00"));
  EXPECT_THAT(run_clearcut({"reproduce", "scallop"}).out,
              ContainsRegex("0.50 +0.48 +14 +0.6786 +0.48 +0.500"));
  EXPECT_THAT(run_clearcut({"reproduce", "lengths"}).out, HasSubstr("the shapes are ours"));
}

TEST(Methods, TablesAreListedWithWhatTheyCost) {
  const auto list = run_clearcut({"reproduce", "--list"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.out, ContainsRegex("coefficients +CPO-rho table 2 +0.1"));
  EXPECT_THAT(list.out, ContainsRegex("genetic [*] +Tour table 6.2"));
  EXPECT_EQ(run_clearcut({"reproduce", "nonsense"}).exit_code, 2);
}

TEST(Methods, ReproducedTablesAreWrittenForProgramsAndBrowsers) {
  const ScratchFolder folder;
  const auto result = run_clearcut({"reproduce", "coefficients", "lengths", "--json", folder.path("t.json"),
                                    "--html", folder.path("t.html")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string json = read_file(folder.path("t.json")), page = read_file(folder.path("t.html"));
  EXPECT_THAT(json, HasSubstr("\"printed\": \"0.543\""));
  EXPECT_THAT(json, HasSubstr("\"agreement\": \"explained\""));
  EXPECT_THAT(page, HasSubstr("<td class=\"computed\" title=\"printed 0.543\">0.543</td>"));
  EXPECT_THAT(page, HasSubstr("class=\"explained\""));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
}

/// CPO-kappa figure 10, from the outline to the program: 373.4802 mm, but for coordinates rounded to 0.0001 mm.
TEST(Methods, FigureTenIsAProgramOfThePrintedLength) {
  const ScratchFolder folder;
  const auto input = folder.file("triangle.edges", kTriangle);
  for (const char* order : {"outside-in", "inside-out"}) {
    const auto result =
        run_clearcut({"plan", input, "--tool", "endmill:10", "--strategy", "lom", "--stepover", "7.01mm",
                      "--order", order, "--result", folder.path("a.txt"), "-o", folder.path("a.ngc")});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string text = read_file(folder.path("a.txt"));
    EXPECT_THAT(text, ContainsRegex("# total length 373[.]480[0-4]\n")) << order;
    EXPECT_THAT(text, HasSubstr("contours at 5.0000 12.0100 19.0200"));
    EXPECT_THAT(text, HasSubstr("contour at 5.0000 smallest angle 60.0000 coefficient 0.7010"));
    EXPECT_THAT(text, HasSubstr("# time by CPO-rho eq. 9 "));
  }
  const auto shortest =
      run_clearcut({"plan", input, "--tool", "endmill:10", "--strategy", "lom", "--stepover", "7.01mm",
                    "--passage", "shortest", "--result", folder.path("b.txt"), "-o", folder.path("b.ngc")});
  ASSERT_EQ(shortest.exit_code, 0) << shortest.err;
  EXPECT_THAT(read_file(folder.path("b.txt")), HasSubstr("# total length 359."));
}

TEST(Methods, PassagesAreRefusedWhereTheyMeanNothing) {
  const ScratchFolder folder;
  const auto input = folder.file("triangle.edges", kTriangle);
  const auto plan = [&](std::vector<std::string> more) {
    std::vector<std::string> all{"plan", input, "--tool", "endmill:10", "-o", folder.path("a.ngc")};
    all.insert(all.end(), more.begin(), more.end());
    return run_clearcut(all);
  };
  EXPECT_EQ(plan({"--strategy", "zigzag", "--passage", "bisector"}).exit_code, 2);
  EXPECT_EQ(plan({"--strategy", "lom", "--passage", "bisector", "--lead", "1"}).exit_code, 2);
  EXPECT_EQ(plan({"--strategy", "lom", "--passage", "diagonal"}).exit_code, 2);
  EXPECT_EQ(plan({"--strategy", "lom", "--solver", "published"}).exit_code, 2);
  EXPECT_EQ(plan({"--strategy", "tour", "--generations", "10"}).exit_code, 2);
}

TEST(Methods, RhoSaysItsCoefficient) {
  const ScratchFolder folder;
  const auto input = folder.file("triangle.edges", "name triangle\ndepth 2\n100 60\n100 60\n100 60\n");
  const auto result =
      run_clearcut({"plan", input, "--tool", "endmill:16", "--strategy", "rho", "-o", folder.path("a.ngc")});
  EXPECT_THAT(result.err, HasSubstr("rho_opt 0.7187 from the smallest angle, 60.00 degrees"));
}

/// What the result file says of contours, the certificate says too.
TEST(Methods, CertificatesHoldCoefficientsAndResiduals) {
  const ScratchFolder folder;
  const auto input = folder.file("triangle.edges", kTriangle);
  const auto result = run_clearcut({"plan", input, "--tool", "endmill:10", "--strategy", "lom", "--stepover",
                                    "7.01mm", "--certificate", folder.path("c.json"), "--result",
                                    folder.path("a.txt"), "-o", folder.path("a.ngc")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(read_file(folder.path("c.json")));
  const auto& contours = json.at("contours").at(0);
  EXPECT_EQ(contours.at("from_wall_mm").size(), 3u);
  const auto& first = contours.at("coefficients").at(0);
  EXPECT_NEAR(first.at("coefficient").get<double>(), 0.701, 1e-6);
  EXPECT_NEAR(first.at("smallest_angle_deg").get<double>(), 60, 1e-3);
  // Eq. 4: F = (R - 2 R (1 - kappa)) / sin(alpha / 2) - R.
  EXPECT_NEAR(first.at("residual_mm").get<double>(), (5 - 10 * (1 - 0.701)) / 0.5 - 5, 1e-3);
  // Eq. 9 over the contours and passages alone: 373.4802 / 1000 min + 2 (1 + 10) 0.177 s.
  EXPECT_NEAR(json.at("published_time_s").get<double>(), 26.3028, 1e-3);
  EXPECT_NEAR(json.at("published_length_mm").get<double>(), 373.4802, 1e-3);
  EXPECT_EQ(json.at("published_discontinuities").get<int>(), 10);
  EXPECT_EQ(json.at("published_feed_mm_per_min"), (nlohmann::json{1000.0, 1000.0}));
  EXPECT_THAT(read_file(folder.path("a.txt")), HasSubstr("eq. 9 26.30 s: sum L 373.48"));
  const auto tools = nlohmann::json::parse(run_clearcut({"tools", input, "--tool", "endmill:10", "--strategy",
                                                         "lom", "--stepover", "7.01mm", "--json"})
                                               .out);
  EXPECT_NEAR(tools.at("tools").at(0).at("published_time_s").get<double>(), 26.3028, 1e-3);
  const auto schema = nlohmann::ordered_json::parse(report::certificate_schema());
  EXPECT_THAT(report::schema_faults(json, schema), testing::IsEmpty());
  for (const auto& [key, value] : json.items()) {
    EXPECT_TRUE(schema.at("properties").contains(key) ||
                schema.at("/$defs/figures/properties"_json_pointer).contains(key))
        << key << " is not described";
  }
}

/// Job files choose the published grid and algorithm, for all operations or for some.
TEST(Methods, JobsChooseThePublishedSystem) {
  const ScratchFolder folder;
  folder.file("plate.edges", "name plate\ndepth 2\n60 90\n40 90\n60 90\n40 90\n");
  const std::string head =
      "[part]\nfile = \"plate.edges\"\n[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 10\n";
  const auto explain = [&](const std::string& rest) {
    const auto job = folder.file("job.toml", head + rest);
    return run_clearcut({"plan", job, "-o", folder.path("a.ngc"), "--certificate", folder.path("c.json")});
  };
  const auto value = [&](const std::string& name) {
    const auto certificate = nlohmann::json::parse(read_file(folder.path("c.json")));
    for (const auto& one : certificate.at("values"))
      if (one.at("name") == name)
        return one.at("value").get<std::string>() + " " + one.at("origin").get<std::string>();
    return std::string();
  };
  const std::string published = "grid = \"published\"\nsolver = \"published\"\ngenerations = 100\n";
  const auto whole = explain("[plan]\nstrategy = \"tour\"\n" + published);
  EXPECT_NE(whole.exit_code, 2) << whole.err;
  EXPECT_EQ(value("grid"), "published job file");
  EXPECT_EQ(value("solver"), "published job file");
  const auto one = explain("[[operation]]\nfeature = \"*\"\nstrategy = \"tour\"\n" + published);
  EXPECT_NE(one.exit_code, 2) << one.err;
  EXPECT_EQ(value("solver"), "published job file");
  EXPECT_EQ(explain("[plan]\nstrategy = \"zigzag\"\n" + published).exit_code, 2);
  EXPECT_EQ(explain("[plan]\nstrategy = \"tour\"\ngenerations = 100\n").exit_code, 2);
  EXPECT_EQ(explain("[plan]\nstrategy = \"tour\"\nsolver = \"clairvoyant\"\n").exit_code, 2);
}

/// What is typed goes before a job setting by setting, as everywhere.
TEST(Methods, SettingsOfThePublishedSolverAreTypedOverAJob) {
  const ScratchFolder folder;
  folder.file("plate.edges", "name plate\ndepth 2\n60 90\n40 90\n60 90\n40 90\n");
  const std::string head =
      "[part]\nfile = \"plate.edges\"\n[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 10\n";
  const auto plan = [&](const std::string& rest, const std::vector<std::string>& typed) {
    std::vector<std::string> command{"plan", folder.file("job.toml", head + rest), "-o",
                                     folder.path("a.ngc")};
    command.insert(command.end(), typed.begin(), typed.end());
    return run_clearcut(command);
  };
  const std::string published =
      "[plan]\nstrategy = \"tour\"\ngrid = \"published\"\nstepover = 0.4\nsolver = \"published\"\n";
  const auto program_of = [&](const std::string& settings, const std::vector<std::string>& typed) {
    const auto result = plan(published + settings, typed);
    EXPECT_NE(result.exit_code, 2) << result.err;
    return read_file(folder.path("a.ngc"));
  };
  const std::string brief = program_of("generations = 1\npopulation = 2\n", {});
  EXPECT_NE(program_of("generations = 300\n", {}), brief);
  EXPECT_EQ(program_of("generations = 300\n", {"--generations", "1", "--population", "2"}), brief);
  const auto ours = plan("[plan]\nstrategy = \"tour\"\n", {"--generations", "1"});
  EXPECT_EQ(ours.exit_code, 2);
  EXPECT_THAT(ours.err, HasSubstr("add --solver published"));
}

/// Every machining strategy that ISO 14649-11 names: what we have runs, the others are said for each workingstep.
TEST(Methods, StrategiesThatAFileNamesRunOrAreSaid) {
  const ScratchFolder folder;
  const std::string example = CLEARCUT_SOURCE_DIR "/examples/strategies.p21";
  const auto planned = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command{
        "plan", example, "-o", folder.path("a.ngc"), "--certificate", folder.path("c.json")};
    command.insert(command.end(), more.begin(), more.end());
    const auto result = run_clearcut(command);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result;
  };
  const auto strategies = [&] {
    std::map<std::string, std::pair<std::string, std::size_t>> found;  // with how many candidates
    const auto certificate = nlohmann::json::parse(read_file(folder.path("c.json")));
    for (const auto& one : certificate.at("features"))
      found[one.at("name")] = {one.at("strategy"), one.at("candidates").size()};
    return found;
  };
  const auto result = planned({});
  const auto found = strategies();
  EXPECT_EQ(found.size(), 9u);
  using Planned = std::pair<std::string, std::size_t>;
  EXPECT_EQ(found.at("CONTOUR_PARALLEL"), Planned("contour", 1));
  EXPECT_EQ(found.at("CONTOUR_SPIRAL"), Planned("spiral", 1));
  for (const char* strokes : {"BIDIRECTIONAL_MILLING", "UNIDIRECTIONAL_MILLING", "BIDIRECTIONAL_CONTOUR"})
    EXPECT_EQ(found.at(strokes), Planned("zigzag", 1));
  EXPECT_THAT(result.err, HasSubstr("UNIDIRECTIONAL_MILLING: strokes in one direction alone are not made"));
  for (const char* other : {"contour_bidirectional", "center_milling", "explicit_strategy"})
    EXPECT_THAT(result.err, HasSubstr("the strategy " + std::string(other) + " is not among ours"));
  EXPECT_GT(found.at("CENTER_MILLING").second, 1u);
  EXPECT_GT(found.at("NO_STRATEGY").second, 1u);
  planned({"--strategy", "zigzag"});
  for (const auto& [name, strategy] : strategies()) EXPECT_EQ(strategy, Planned("zigzag", 1)) << name;
}

/// One page without scripts: elements, squares, animated visit, convergence, all points.
TEST(Methods, ElementsHaveAPage) {
  const ScratchFolder folder;
  const auto plan = [&](const char* page) {
    return run_clearcut({"elements", CLEARCUT_SOURCE_DIR "/examples/five_pockets.toml", "--solver",
                         "published", "--generations", "60", "--html", folder.path(page), "-o",
                         folder.path("a.ngc")});
  };
  EXPECT_NE(plan("a.html").exit_code, 2);
  const std::string page = read_file(folder.path("a.html"));
  for (const char* part : {"<h2>Elements", "<h2>Activated, reduced, cut", "animateMotion", "published solver",
                           "generation", "Table of all points"})
    EXPECT_THAT(page, HasSubstr(part));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("http://www.w3.org/1999/xlink")));
  plan("b.html");
  EXPECT_EQ(read_file(folder.path("b.html")), page) << "the same seed";
}

/// The published system on a part: its grid, its algorithm; what it leaves is a figure of the certificate.
TEST(Methods, ThePublishedTourRunsOnAPart) {
  const ScratchFolder folder;
  const auto input = folder.file("plate.edges", "name plate\ndepth 2\n60 90\n40 90\n60 90\n40 90\n");
  const auto plan = [&](const char* program) {
    return run_clearcut({"plan", input, "--tool", "endmill:10", "--strategy", "tour", "--solver", "published",
                         "--grid", "published", "--stepover", "0.5", "--generations", "200", "--seed", "3",
                         "-o", folder.path(program)});
  };
  const auto result = plan("a.ngc");
  EXPECT_NE(result.exit_code, 2) << result.err;
  EXPECT_THAT(result.out, HasSubstr("plate"));
  plan("b.ngc");
  EXPECT_EQ(read_file(folder.path("a.ngc")), read_file(folder.path("b.ngc"))) << "the same seed";
}

TEST(Methods, CompareShowsWhatEveryRivalAdds) {
  const ScratchFolder folder;
  const auto input = folder.file("triangle.edges", kTriangle);
  const auto result = run_clearcut({"compare", input, "--tool", "endmill:10"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("vs fixed"));
  for (const char* method :
       {"loops", "pwid", "single", "double", "bisectors", "lom-corrected", "rho-corrected"}) {
    EXPECT_THAT(result.out, ContainsRegex(std::string("\n") + method + " [^\n]* yes")) << method;
  }
  EXPECT_THAT(result.out, ContainsRegex("\nfixed [^\n]* NO"));
}

/// A small part of `clearcut compare --random 2000`, whose figures are in docs/methods.md.
TEST(Methods, OnRandomPocketsOursIsCleanAndNeverSlowerThanACleanRival) {
  std::map<std::string, int> clean, causes;
  int cases = 0;
  studies::study_methods(30, 1, {}, [&](const studies::StudyCase& one) {
    ++cases;
    EXPECT_FALSE(one.faster) << "seed " << one.seed << ": " << one.faster.value_or("");
    for (const auto& [method, outcome] : one.outcomes) {
      clean[method] += outcome.clean;
      if (method == "lom" || method == "rho") causes[outcome.cause] += !outcome.clean;
    }
  });
  ASSERT_EQ(cases, 30);
  for (const char* method :
       {"contour", "lom-corrected", "rho-corrected", "loops", "pwid", "single", "double"}) {
    EXPECT_EQ(clean[method], cases) << method;
  }
  // As published, with the causes that ring_band.h tells apart; a fixed step near the diameter as well.
  for (const char* method : {"lom", "rho", "second", "fixed"}) EXPECT_LT(clean[method], cases) << method;
  EXPECT_GT(causes["sharper corner"], 0);
  EXPECT_GT(causes["centre"], 0);
  EXPECT_EQ(causes["other"], 0) << "the criterion explains every failure that the certificate reports";
}

}  // namespace
}  // namespace clearcut
