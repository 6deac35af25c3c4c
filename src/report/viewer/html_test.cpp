#include "report/viewer/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>
#include <sstream>

#include "base/file.h"
#include "kinematics/kinematics.h"
#include "report/sample_job.h"

namespace clearcut::report {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

HtmlOptions options() {
  return {Machine{}, "G21\nG0 X1 Y2 (<first> & \"second\")\nM30"};
}

std::string page(const Part& part = sample::part()) {
  return html(part, sample::toolpath(), sample::findings(), options());
}

pugi::xml_document parsed(const std::string& text) {
  pugi::xml_document document;
  const auto result = document.load_string(text.c_str(), pugi::parse_full);
  EXPECT_TRUE(result) << result.description() << " at "
                      << text.substr(static_cast<std::size_t>(result.offset), 80);
  return document;
}

/// The JSON that the page's own script reads.
Json job_in(const std::string& text) {
  return Json::parse(parsed(text).select_node("//script[@id='job']").node().child_value());
}

/// What the page's script makes of the columns.
std::vector<Move> decoded(const Json& job) {
  std::vector<Move> moves;
  Vec2 at;
  double z = 0;
  std::size_t start = 0, arc = 0, feed = 0;
  int line = 0;
  const auto next_is = [](const Json& rows, std::size_t row, std::size_t i) {
    return row < rows.size() && rows[row][0] == i;
  };
  for (std::size_t i = 0; i < job["x"].size(); ++i) {
    if (next_is(job["starts"], start, i)) {
      const Json& s = job["starts"][start++];
      at = Vec2{s[1].get<double>(), s[2].get<double>()} / 1000;
      z = s[3].get<double>() / 1000;
    }
    Move move;
    move.path.from = at;
    move.z_from = z;
    move.kind = static_cast<MoveKind>(job["kinds"].get<std::string>()[i] - '0');
    at = at + Vec2{job["x"][i].get<double>(), job["y"][i].get<double>()} / 1000;
    z += job["z"][i].get<double>() / 1000;
    line += job["line"][i].get<int>();
    move.path.to = at;
    move.z_to = z;
    move.line = line;
    if (next_is(job["arcs"], arc, i)) {
      const Json& a = job["arcs"][arc++];
      move.path.center = move.path.from + Vec2{a[1].get<double>(), a[2].get<double>()} / 1000;
      move.path.turn = static_cast<Turn>(a[3].get<int>());
    }
    if (next_is(job["feeds"], feed, i)) ++feed;
    move.feed = MmPerMin::of(job["feeds"][feed - 1][1].get<double>());
    moves.push_back(move);
  }
  return moves;
}

std::vector<Move> all_moves(const Toolpath& toolpath) {
  std::vector<Move> moves;
  for (const Section& section : toolpath.sections) {
    moves.insert(moves.end(), section.moves.begin(), section.moves.end());
  }
  return moves;
}

TEST(Html, IsOneWellFormedPageThatAsksForNothingElse) {
  const std::string text = page();
  const auto document = parsed(text);
  EXPECT_EQ(document.select_nodes("//script").size(), 2u);
  EXPECT_TRUE(document.select_nodes("//link|//img|//iframe|//@src|//@href").empty());
  EXPECT_FALSE(std::regex_search(text, std::regex("https?://|fetch\\(|XMLHttpRequest|import\\(")));
  for (const char* id : {"title", "verdict", "tiles", "stage", "play", "scrub", "speed", "features", "faults",
                         "conditions", "program", "plot"}) {
    EXPECT_EQ(document.select_nodes((std::string("//*[@id='") + id + "']").c_str()).size(), 1u) << id;
  }
}

TEST(Html, HoldsTheViewersFilesAsTheyAre) {
  const std::string text = page(), folder = CLEARCUT_SOURCE_DIR "/src/report/viewer/";
  std::vector<std::string> names{"viewer.css", "body.html"};
  std::istringstream scripts(read_file(folder + "scripts.txt"));
  for (std::string name; std::getline(scripts, name);) names.push_back(name);
  EXPECT_GT(names.size(), 5u);
  std::size_t at = 0;
  for (const std::string& name : names) {
    const std::size_t found = text.find(read_file(folder + name), at);
    ASSERT_NE(found, std::string::npos) << name;
    at = found;
  }
}

TEST(Html, TheScriptUsesOnlyElementsOfThePage) {
  const auto document = parsed(page());
  std::string script;
  for (const auto& piece : document.select_nodes("//script")[1].node().children()) script += piece.value();
  const std::regex use("by\\('([a-z-]+)'\\)");
  int used = 0;
  for (std::sregex_iterator it(script.begin(), script.end(), use), end; it != end; ++it, ++used) {
    EXPECT_FALSE(document.select_nodes(("//*[@id='" + (*it)[1].str() + "']").c_str()).empty()) << (*it)[1];
  }
  EXPECT_GT(used, 20);
}

TEST(Html, HoldsEveryMoveToAMicrometre) {
  const std::vector<Move> wanted = all_moves(sample::toolpath()), found = decoded(job_in(page()));
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(found[i].kind, wanted[i].kind);
    EXPECT_EQ(found[i].line, wanted[i].line);
    EXPECT_EQ(found[i].path.turn, wanted[i].path.turn);
    EXPECT_EQ(found[i].feed, wanted[i].feed);
    EXPECT_LE(distance(found[i].path.from, wanted[i].path.from), 0.001);
    EXPECT_LE(distance(found[i].path.to, wanted[i].path.to), 0.001);
    EXPECT_LE(distance(found[i].path.center, wanted[i].path.center), 0.0015);
    EXPECT_NEAR(found[i].z_from, wanted[i].z_from, 0.0006);
    EXPECT_NEAR(found[i].z_to, wanted[i].z_to, 0.0006);
  }
}

TEST(Html, PositionsDoNotDrift) {
  Section section{"P", 0, 1, 0, true, Coolant::kOff, {}};
  sample::Moves m({0, 0}, -1);
  for (int i = 1; i <= 10000; ++i) m.to(MoveKind::kCut, {i * 0.0003333, i * 0.0007}, -1);
  section.moves = m.moves;
  const auto found = decoded(Json::parse(html_data(sample::part(), {{section}}, {}, {})));
  EXPECT_LE(distance(found.back().path.to, m.moves.back().path.to), 0.001);
}

TEST(Html, TimesAreThoseOfTheKinematicModel) {
  const Json job = job_in(page());
  double ticks = 0, seconds = 0;
  for (const Json& t : job["t"]) ticks += t.get<double>();
  for (const Section& section : sample::toolpath().sections)
    seconds += kinematics::kinematic_time(section.moves, Machine{}).seconds();
  EXPECT_GT(seconds, 10);
  EXPECT_NEAR(ticks / 10000, seconds, 1e-3);
}

/// Waits are in the times that the certificate counts, and the clock of the page ends there.
TEST(Html, TimesAreThoseThatAreStated) {
  HtmlOptions stated = options();
  double seconds = 0;
  for (const Section& section : sample::toolpath().sections) {
    for (std::size_t i = 0; i < section.moves.size(); ++i) seconds += stated.move_times_s.emplace_back(0.5);
  }
  const Json job = job_in(html(sample::part(), sample::toolpath(), sample::findings(), stated));
  double ticks = 0;
  for (const Json& t : job["t"]) ticks += t.get<double>();
  EXPECT_NEAR(ticks / 10000, seconds, 1e-3);
}

TEST(Html, SectionsFeaturesFaultsAndFiguresAreThere) {
  const Json job = job_in(page());
  EXPECT_EQ(job["name"], "sample <part> & \"name\"");
  EXPECT_EQ(job["clean"], false);
  EXPECT_EQ(job["top"], 0);
  EXPECT_EQ(job["bottom"], -8);
  EXPECT_EQ(job["shades"].size(), 256u);
  EXPECT_EQ(job["sections"][1]["first"], sample::pocket_section().moves.size());
  EXPECT_EQ(job["sections"][1]["feature"], 1);
  EXPECT_EQ(job["features"][1]["name"], "SLOT <2>");
  EXPECT_EQ(job["features"][0]["floor"], -4);
  EXPECT_TRUE(job["features"][0]["top"].is_number());
  EXPECT_TRUE(job["tools"][0]["a"].is_null()) << "no cone";
  EXPECT_EQ(job["features"][0]["left"], 0.25);
  EXPECT_EQ(job["faults"][0]["kind"], "uncut");
  EXPECT_EQ(job["faults"][0]["head"], "uncut 0.250 mm");
  EXPECT_EQ(job["faults"][0]["x"], 66.5);
  EXPECT_EQ(job["figures"]["feed_mm"], 2000.5);
  EXPECT_EQ(job["program"][1], "G0 X1 Y2 (<first> & \"second\")");
}

TEST(Html, EngagementOfEachMoveIsThereWhereItWasMeasured) {
  Toolpath toolpath = sample::toolpath();
  const std::size_t count = all_moves(toolpath).size();
  Findings findings = sample::findings();
  EXPECT_TRUE(Json::parse(html_data(sample::part(), toolpath, findings, {}))["engagement"].is_null());
  findings.move_engagement_deg.assign(count, 45.4F);
  findings.move_engagement_deg[5] = 180;
  Json degrees = Json::parse(html_data(sample::part(), toolpath, findings, {}))["engagement"];
  ASSERT_EQ(degrees.size(), count);
  EXPECT_EQ(degrees[4], 45);
  EXPECT_EQ(degrees[5], 180);
  toolpath.sections[0].moves[4].path.to = {std::numeric_limits<double>::quiet_NaN(), 0};
  degrees = Json::parse(html_data(sample::part(), toolpath, findings, {}))["engagement"];
  ASSERT_EQ(degrees.size(), count - 1);
  EXPECT_EQ(degrees[4], 180) << "a move that is left out shifts no other's";
  findings.move_engagement_deg.pop_back();
  EXPECT_TRUE(Json::parse(html_data(sample::part(), toolpath, findings, {}))["engagement"].is_null());
}

TEST(Html, WhatTheViewInSpaceDrawsOfStockAndToolsIsThere) {
  Part part = sample::part();
  part.stock = Stock{{{0, 0}, {100, 80}}, -20, 0};
  part.tools[0].kind = ToolKind::kVBit;
  part.tools[0].tip_angle = Radians::of_degrees(90);
  part.tools[0].tip_diameter = 0.2;
  part.tools[0].flute_length = 12;
  const Json job = Json::parse(html_data(part, sample::toolpath(), sample::findings(), {}));
  EXPECT_EQ(job["stock_z"], -20);
  EXPECT_EQ(job["tools"][0]["a"], 1) << "mm sideways for each mm of height";
  EXPECT_EQ(job["tools"][0]["t"], 0.2);
  EXPECT_EQ(job["tools"][0]["f"], 12);
  part.stock.reset();
  EXPECT_TRUE(Json::parse(html_data(part, {}, {}, {}))["stock_z"].is_null());
}

TEST(Html, WhatWasCutBeforeIsThereWithItsCeiling) {
  const Part part = sample::part();
  EXPECT_TRUE(Json::parse(html_data(part, sample::toolpath(), sample::findings(), {}))["earlier"].is_null());
  Toolpath earlier = sample::toolpath();
  HtmlOptions shown;
  shown.earlier = &earlier;
  const auto read = [&] { return Json::parse(html_data(part, {}, {}, shown))["earlier"]; };
  std::size_t cuts = 0;
  for (const Section& section : earlier.sections)
    cuts += static_cast<std::size_t>(std::count_if(section.moves.begin(), section.moves.end(),
                                                   [](const Move& move) { return !is_rapid(move.kind); }));
  EXPECT_GT(cuts, 0U);
  EXPECT_EQ(decoded(read()).size(), cuts);
  EXPECT_TRUE(read()["sections"][0]["below"].is_null());
  for (Section& section : earlier.sections) section.carried_below = part.top_z();
  EXPECT_TRUE(read()["sections"][0]["below"].is_null()) << "reaches up to the top";
  for (Section& section : earlier.sections) section.carried_below = part.top_z() - 1;
  EXPECT_DOUBLE_EQ(read()["sections"][0]["below"].get<double>(), part.top_z() - 1);
}

TEST(Html, ConditionsAreThere) {
  Findings findings = sample::findings();
  findings.conditions = {{"g55", "G55 is where the part's zero is.", 7, ""}, {"units", "mm", 0, "accepted"}};
  const Json job = Json::parse(html_data(sample::part(), sample::toolpath(), findings, {}));
  EXPECT_EQ(job["verdict"], "FAULTY");
  EXPECT_EQ(job["conditions"][0]["name"], "g55");
  EXPECT_EQ(job["conditions"][0]["line"], 7);
  EXPECT_EQ(job["conditions"][1]["met_by"], "accepted");
}

TEST(Html, HostileNamesStayData) {
  Part part = sample::part();
  part.name = "</script><script>alert('x')</script><!-- ]]>\xff";
  part.features[0].name = "</SCRIPT ><b>";
  const std::string text = page(part);
  EXPECT_EQ(parsed(text).select_nodes("//script").size(), 2u);
  EXPECT_THAT(text, Not(HasSubstr("alert('x')</script>")));
  EXPECT_THAT(text, Not(HasSubstr("</SCRIPT")));
  EXPECT_EQ(job_in(text)["features"][0]["name"], part.features[0].name);
}

TEST(Html, NumbersThatAreNoneAreLeftOutOrNull) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Toolpath toolpath = sample::toolpath();
  toolpath.sections[0].moves[4].path.to = {nan, 0};
  toolpath.sections[0].moves[6].z_to = std::numeric_limits<double>::infinity();
  Findings findings = sample::findings();
  findings.all.feed_mm = nan;
  findings.faults[0].at.point = {nan, nan};
  const Json job = Json::parse(html_data(sample::part(), toolpath, findings, options()));
  EXPECT_EQ(job["x"].size(), all_moves(toolpath).size() - 2);
  EXPECT_TRUE(job["figures"]["feed_mm"].is_null());
  EXPECT_TRUE(job["faults"][0]["x"].is_null());
}

TEST(Html, IsTheSameTextEachTime) {
  EXPECT_EQ(page(), page());
}

TEST(Html, AnEmptyJobGivesAPage) {
  parsed(html({}, {}, {}, {}));
}

TEST(Html, StaysSmall) {
  Section section{"P", 0, 1, 0, true, Coolant::kOff, {}};
  sample::Moves m({0, 0}, -1);
  for (int i = 0; i < 20000; ++i)
    m.to(MoveKind::kCut, {50 + 40 * std::cos(0.1 * i), 40 + 30 * std::sin(0.1 * i)}, -1);
  section.moves = m.moves;
  EXPECT_LT(html(sample::part(), {{section}}, {}, {}).size(),
            html(sample::part(), {}, {}, {}).size() + 20000 * 32);
  EXPECT_LT(html({}, {}, {}, {}).size(), 165000);
}

}  // namespace
}  // namespace clearcut::report
