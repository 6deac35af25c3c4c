// No option is without an effect: each row of the table, with each kind of input, changes the program or what the certificate finds,
// or is refused with a line that says where it serves. What may stay quiet is listed here with its reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/file.h"
#include "options/row.h"
#include "support/command.h"
#include "support/controllers.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using Json = nlohmann::json;

/// Policies for what is unclear in a drawing, for how long is searched and on how many threads, and for which conditions are accepted:
/// where nothing is unclear, the search ends before, and the condition does not arise, they do nothing and are none the worse. A tool more is an offer,
/// the only body may be named, and where one pass alone is cut there is nothing to order and nothing to overlap.
const std::set<std::string> kQuiet{"join-gap", "open-curves", "text", "strokes", "threads", "seed",
                                   "time",     "accept",      "tool", "body",    "order",   "lead-overlap"};

/// Values that differ from what holds without the option; for other rows the last name or the shown example does.
const std::map<std::string, std::string> kValues{{"origin", "centre"},
                                                 {"unit", "inch"},
                                                 {"layer", "NONE"},
                                                 {"top", "1"},
                                                 {"depth", "4"},
                                                 {"up", "-Z"},
                                                 {"turn", "90"},
                                                 {"body", "1"},
                                                 {"breakthrough", "0.7"},
                                                 {"op", "ignore:1"},
                                                 {"tabs", "2"},
                                                 {"tab-spacing", "20"},
                                                 {"tab-at", "0,0"},
                                                 {"tab-shape", "triangular"},
                                                 {"tab-width", "3"},
                                                 {"tab-height", "0.8"},
                                                 {"skin", "0.3"},
                                                 {"scale", "2"},
                                                 {"tool", "endmill:5"},
                                                 {"keep-out", "-20:40,-20:40,-5:50"},
                                                 {"acceleration", "300"},
                                                 {"junction-deviation", "0.02"},
                                                 {"rapid", "4000"},
                                                 {"stepdown", "0.7"},
                                                 {"allowance", "0.2"},
                                                 {"allowance-floor", "0.2"},
                                                 {"engagement", "120"},
                                                 {"margin-at-least", "0.0001"},
                                                 {"margin-uncut", "0.03"},
                                                 {"margin-gouge", "0.02"},
                                                 {"material", "softwood"},
                                                 {"strategy", "zigzag"},
                                                 {"style", "machinist"},
                                                 {"stepover", "0.3"},
                                                 {"angle", "30"},
                                                 {"direction", "conventional"},
                                                 {"start", "5,5"},
                                                 {"entry", "helix"},
                                                 {"entry-angle", "2"},
                                                 {"helix-diameter", "2"},
                                                 {"helix-min", "1"},
                                                 {"predrilled", "10,10:8"},
                                                 {"clearance", "17"},
                                                 {"lead", "1"},
                                                 {"lead-angle", "45"},
                                                 {"lead-overlap", "1"},
                                                 {"overrun", "1"},
                                                 {"link-lift", "0.5"},
                                                 {"stock-oversize", "0.5"},
                                                 {"feed", "900"},
                                                 {"plunge-feed", "111"},
                                                 {"ramp-feed", "222"},
                                                 {"slot-feed", "333"},
                                                 {"slot-angle", "140"},
                                                 {"lead-feed", "444"},
                                                 {"link-feed", "555"},
                                                 {"feed-by", "removal"},
                                                 {"reference-engagement", "60"},
                                                 {"reference-feed", "700"},
                                                 {"feed-cap", "1200"},
                                                 {"spindle", "7000"},
                                                 {"coolant", "flood"},
                                                 {"finish", "walls"},
                                                 {"finish-stock", "0.2"},
                                                 {"finish-stock-floor", "0.1"},
                                                 {"finish-depths", "2"},
                                                 {"finish-steps", "2"},
                                                 {"spring-passes", "1"},
                                                 {"compensation", "wear"},
                                                 {"wear-range", "0.05"},
                                                 {"dogbones", "corner"},
                                                 {"scallop", "0.3"},
                                                 {"copies", "2x1"},
                                                 {"nest", "65x45"},
                                                 {"gap", "8"},
                                                 {"edge", "5"},
                                                 {"count", "2"},
                                                 {"post", "grbl"},
                                                 {"machine-kind", "router"},
                                                 {"decimals", "3"},
                                                 {"work-offset", "G55"},
                                                 {"end-position", "home"},
                                                 {"program-number", "7"},
                                                 {"spindle-wait", "3"},
                                                 {"objective", "turns"},
                                                 {"generations", "10"},
                                                 {"population", "9"},
                                                 {"crossover-rate", "0.5"},
                                                 {"mutation-rate", "0.5"},
                                                 {"most-shared", "0.3"}};

/// Rows whose values are files, or that need a job with set-ups: they have tests of their own.
const std::set<std::string> kElsewhere{"setup",   "earlier-setup", "stock-from", "tools",
                                       "machine", "after",         "nest-with"};

std::string value_for(const Row& row) {
  const auto found = kValues.find(row.name);
  if (found != kValues.end()) return found->second;
  return row.names.empty() ? row.shown_example() : row.names.back();
}

/// What a plan comes to: its program without comments, and what the certificate finds.
struct Outcome {
  int exit_code = 0;
  std::string program, findings, message;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Without what only repeats the question.
std::string findings_in(const std::string& certificate) {
  Json json = Json::parse(certificate);
  for (const char* key : {"seal", "question", "values", "input", "inputs", "arguments", "command",
                          "program_sha256", "version", "sha256", "input_hash", "program", "certificate"})
    json.erase(key);
  return json.dump();
}

std::string motion_of(const std::string& program) {
  std::string out;
  for (std::size_t at = 0; at < program.size();) {
    const std::size_t end = std::min(program.find('\n', at), program.size());
    std::string line = program.substr(at, end - at);
    line.erase(std::min(line.find('('), line.size()));
    line.erase(std::min(line.find(';'), line.size()));
    if (!line.empty()) out += line + "\n";
    at = end + 1;
  }
  return out;
}

Outcome outcome_of(const ScratchFolder& folder, std::vector<std::string> words) {
  const std::string program = folder.path("out.ngc"), certificate = folder.path("out.json");
  words.insert(words.begin(), "plan");
  words.insert(words.end(), {"-o", program, "--certificate", certificate, "--quiet"});
  const auto run = run_clearcut(words);
  Outcome out{run.exit_code, "", "", run.err};
  if (run.exit_code > 1) return out;
  out.program = motion_of(read_file(program));
  out.findings = findings_in(read_file(certificate));
  out.message.clear();
  return out;
}

constexpr const char* kDxf =
    "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nPOCKET_"
    "D2\n90\n4\n70\n1\n10\n0\n20\n0\n10\n30\n20\n0\n10\n30\n20\n20\n10\n0\n20\n"
    "20\n0\nENDSEC\n0\nEOF\n";
constexpr const char* kSvg =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"30mm\" height=\"20mm\" viewBox=\"0 0 30 20\"><g "
    "id=\"POCKET_D2\"><rect "
    "x=\"0\" y=\"0\" width=\"30\" height=\"20\" fill=\"#000000\"/></g></svg>\n";
constexpr const char* kOutline =
    R"({"name":"p","units":"mm","outer":[[0,0,0],[30,0,0],[30,20,0],[0,20,0]],"top":0,"depth":2})";

/// What an option needs beside it to have an effect. It is tried with this and without.
const std::map<std::string, std::string> kNeeds{{"tab-shape", "--tabs=2"},
                                                {"tab-width", "--tabs=2"},
                                                {"tab-height", "--tabs=2"},
                                                {"entry-angle", "--entry=ramp"},
                                                {"ramp-feed", "--entry=ramp"},
                                                {"helix-diameter", "--entry=helix"},
                                                {"lead-angle", "--lead=1"},
                                                {"lead-feed", "--lead=1"},
                                                {"reference-engagement", "--feed-by=removal"},
                                                {"reference-feed", "--feed-by=removal"},
                                                {"finish-stock", "--finish=all"},
                                                {"finish-stock-floor", "--finish=all"},
                                                {"finish-depths", "--finish=walls"},
                                                {"finish-steps", "--finish=walls"},
                                                {"spring-passes", "--finish=walls"},
                                                {"compensation", "--finish=walls"}};

/// Drawings of one kind of work each.
struct DrawnWork {
  std::string entities;
  std::vector<std::string> tools;
};

std::string rectangle_on(const std::string& layer) {
  return "0\nLWPOLYLINE\n8\n" + layer +
         "\n90\n4\n70\n1\n10\n0\n20\n0\n10\n30\n20\n0\n10\n30\n20\n20\n10\n0\n20\n20\n";
}

const std::map<std::string, DrawnWork> kDrawnWorks{
    {"profile", {rectangle_on("PROFILE_D3"), {"endmill:6"}}},
    {"cut-out", {rectangle_on("INSIDE_D3"), {"endmill:3"}}},
    {"line", {"0\nLINE\n8\nENGRAVE_D1\n10\n0\n20\n0\n11\n30\n21\n10\n", {"endmill:2"}}},
    {"engraving", {rectangle_on("ENGRAVE_D1"), {"vbit:60deg:6"}}},
    {"carving", {rectangle_on("VCARVE"), {"vbit:90deg:30"}}},
    {"face", {rectangle_on("FACE_D1"), {"endmill:8"}}},
    {"chamfer",
     {rectangle_on("PROFILE_D3") + rectangle_on("CHAMFER_D0.5"), {"endmill:4", "chamfer:90deg:8"}}},
    {"hole", {"0\nCIRCLE\n8\nDRILL_D5\n10\n15\n20\n10\n40\n2\n", {"drill:4"}}}};

/// The input of a kind and what a plan of it needs.
std::vector<std::string> words_for(const std::string& kind, const ScratchFolder& folder) {
  const std::string examples = std::string(CLEARCUT_SOURCE_DIR) + "/examples/";
  if (kind == "dxf") return {folder.file("p.dxf", kDxf), "--tool", "endmill:6"};
  if (const auto work = kDrawnWorks.find(kind); work != kDrawnWorks.end()) {
    std::vector<std::string> words{
        folder.file("p.dxf", "0\nSECTION\n2\nENTITIES\n" + work->second.entities + "0\nENDSEC\n0\nEOF\n")};
    for (const std::string& tool : work->second.tools) words.insert(words.end(), {"--tool", tool});
    return words;
  }
  if (kind == "svg") return {folder.file("p.svg", kSvg), "--depth", "2", "--tool", "endmill:6"};
  if (kind == "outline") return {folder.file("p.json", kOutline), "--tool", "endmill:6"};
  if (kind == "board") return {examples + "board-PTH.drl", "--depth", "1.6", "--tool", "endmill:0.5"};
  if (kind == "solid") return {examples + "bracket.step", "--tool", "endmill:4", "--strategy", "contour"};
  return {examples + "strategies.p21"};
}

class EffectOfOptions : public testing::TestWithParam<const char*> {};

TEST_P(EffectOfOptions, NoOptionIsSilent) {
  const ScratchFolder folder;
  const auto words = words_for(GetParam(), folder);
  const Outcome plain = outcome_of(folder, words);
  ASSERT_LE(plain.exit_code, 1) << plain.message;
  int pairs = 0;
  for (const Row& row : rows()) {
    if (kQuiet.contains(row.name) || kElsewhere.contains(row.name)) continue;
    if (std::find(words.begin(), words.end(), "--" + row.name) != words.end() && row.name != "tool") continue;
    const auto expect_effect = [&](std::vector<std::string> with, const Outcome& without) {
      with.push_back("--" + row.name);
      if (row.kind != ValueKind::kFlag) with.back() += "=" + value_for(row);
      const Outcome outcome = outcome_of(folder, with);
      ++pairs;
      if (outcome.exit_code == 2)
        EXPECT_FALSE(outcome.message.empty()) << row.name;
      else
        EXPECT_FALSE(outcome == without) << "--" << row.name << " changes nothing of a " << GetParam();
    };
    expect_effect(words, plain);
    const auto needs = kNeeds.find(row.name);
    if (needs == kNeeds.end() || !kDrawnWorks.contains(GetParam())) continue;
    auto beside = words;
    beside.push_back(needs->second);
    const Outcome without = outcome_of(folder, beside);
    if (without.exit_code != 2) expect_effect(beside, without);
  }
  EXPECT_GT(pairs, 70);
}

/// An option for other kinds of work is refused before the part is planned, with those that it serves.
TEST(OptionEffects, OptionsForOtherWorkAreRefusedWithWhatTheyServe) {
  const ScratchFolder folder;
  const auto refusal = [&](const std::string& kind, const std::string& option) {
    auto words = words_for(kind, folder);
    words.push_back(option);
    return outcome_of(folder, words).message;
  };
  EXPECT_THAT(refusal("engraving", "--lead=1"),
              testing::HasSubstr("it serves pockets, slots, steps and faces"));
  EXPECT_THAT(refusal("carving", "--style=machinist"), testing::HasSubstr("and the part has none"));
  EXPECT_THAT(refusal("engraving", "--tabs=3"), testing::HasSubstr("nothing comes free"));
  EXPECT_THAT(refusal("profile", "--strategy=zigzag"), testing::HasSubstr("no pocket, slot, step or face"));
  EXPECT_THAT(refusal("profile", "--dogbones=corner"), testing::HasSubstr("inside corner"));
  EXPECT_THAT(refusal("line", "--finish=walls"), testing::HasSubstr("has no effect"));
}

TEST(OptionEffects, JunctionDeviationServesTheControlsThatPlanByIt) {
  const ScratchFolder folder;
  for (const test_support::Controller& one : test_support::controllers()) {
    auto words = words_for("outline", folder);
    words.insert(words.end(), {"--post", std::string(one.name), "--junction-deviation", "0.03"});
    const Outcome outcome = outcome_of(folder, words);
    EXPECT_EQ(outcome.exit_code < 2, one.junction_deviation) << one.name << ": " << outcome.message;
  }
}

/// Objectives of load choose among plans on each input, or are refused.
TEST_P(EffectOfOptions, NoObjectiveIsSilent) {
  const ScratchFolder folder;
  auto words = words_for(GetParam(), folder);
  words.push_back("--material=steel");
  const Outcome plain = outcome_of(folder, words);
  ASSERT_LE(plain.exit_code, 1) << plain.message;
  for (const char* objective : {"force", "energy", "wear", "climb", "force=0.3,time=0.7"}) {
    auto with = words;
    with.push_back(std::string("--objective=") + objective);
    const Outcome outcome = outcome_of(folder, with);
    if (outcome.exit_code == 2)
      EXPECT_THAT(outcome.message, testing::HasSubstr("there is one")) << objective;
    else
      EXPECT_FALSE(outcome == plain) << objective << " changes nothing of a " << GetParam();
  }
}

/// A key of one operation is refused where it serves none of what the operation makes, although the rest of the part has such work.
TEST(OptionEffects, KeysOfOperationsForOtherWorkAreRefused) {
  const ScratchFolder folder;
  folder.file("p.dxf", "0\nSECTION\n2\nENTITIES\n" + rectangle_on("PROFILE_D3") +
                           "0\nCIRCLE\n8\nPOCKET_D2\n10\n15\n20\n10\n40\n6\n0\nENDSEC\n0\nEOF\n");
  const auto planned = [&](const std::string& key) {
    const std::string job =
        folder.file("job.toml",
                    "[part]\nfile = \"p.dxf\"\nunit = \"mm\"\n[[tool]]\nnumber = 1\ndiameter = 4\n"
                    "[[operation]]\nfeature = \"PROFILE_D3\"\n" +
                        key + "\n[[operation]]\nfeature = \"POCKET_D2\"\nstepover = 0.3\n");
    return run_clearcut({"plan", job, "-o", folder.path("o.ngc"), "--quiet"});
  };
  EXPECT_LE(planned("feed = 700").exit_code, 1);
  EXPECT_LE(planned("strategy = \"contour\"").exit_code, 1);
  for (const char* key : {"strategy = \"zigzag\"", "stepover = 0.3"}) {
    const auto run = planned(key);
    EXPECT_EQ(run.exit_code, 2) << key;
    EXPECT_THAT(run.err, testing::HasSubstr("job.toml:9")) << key;
    EXPECT_THAT(run.err, testing::HasSubstr("has no effect on PROFILE_D3: it serves pockets")) << key;
  }
}

TEST(OptionsPage, IsMadeOfTheTable) {
  EXPECT_EQ(run_clearcut({"generate", "table"}).out, read_file(CLEARCUT_SOURCE_DIR "/docs/options.md"))
      << "make it anew: clearcut generate table > docs/options.md";
}

/// One bad value, one sentence: at the command line and in a job.
TEST(OptionsTable, RefusesWithTheSameWordsAtEveryDoor) {
  const ScratchFolder folder;
  folder.file("p.json", kOutline);
  const std::map<std::string, std::string> bad{{"allowance", "-1"},
                                               {"entry-angle", "90"},
                                               {"tab-width", "0"},
                                               {"finish-depths", "0"},
                                               {"engagement", "5"}};
  for (const auto& [name, value] : bad) {
    const auto typed = run_clearcut({"plan", folder.path("p.json"), "--tool", "endmill:6",
                                     "--" + name + "=" + value, "-o", folder.path("o.ngc")});
    const std::string job =
        folder.file("job.toml", "[part]\nfile = \"p.json\"\n[[tool]]\nnumber = 1\ndiameter = 6\n[plan]\n" +
                                    row_named(name)->job_key() + " = " + value + "\n");
    const auto said = run_clearcut({"plan", job, "-o", folder.path("o.ngc")});
    EXPECT_EQ(typed.exit_code, 2);
    EXPECT_EQ(said.exit_code, 2);
    const auto words = [](const std::string& text) { return text.substr(text.find("must")); };
    ASSERT_NE(typed.err.find("must"), std::string::npos) << typed.err;
    ASSERT_NE(said.err.find("must"), std::string::npos) << said.err;
    EXPECT_EQ(words(typed.err), words(said.err)) << name;
  }
}

/// What init is given stands in the job, and the job gives the same program.
TEST(Init, KeepsWhatItIsGiven) {
  const ScratchFolder folder;
  folder.file("plate.dxf", kDxf);
  const std::vector<std::string> options{
      "--tool", "endmill:4",          "--strategy",   "contour", "--stepdown", "1",      "--feed",
      "700",    "--direction",        "conventional", "--post",  "grbl",       "--lead", "1",
      "--op",   "pocket_d2:POCKET_D2"};
  const auto with = [&](std::vector<std::string> words) {
    words.insert(words.end(), options.begin(), options.end());
    return run_clearcut(words);
  };
  EXPECT_EQ(with({"init", folder.path("plate.dxf"), "-o", folder.path("plate.toml")}).exit_code, 0);
  EXPECT_EQ(with({"plan", folder.path("plate.dxf"), "-o", folder.path("typed.nc"), "--quiet"}).exit_code, 0);
  const auto said =
      run_clearcut({"plan", folder.path("plate.toml"), "-o", folder.path("said.nc"), "--quiet"});
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(motion_of(read_file(folder.path("said.nc"))), motion_of(read_file(folder.path("typed.nc"))));
}

INSTANTIATE_TEST_SUITE_P(Inputs, EffectOfOptions,
                         testing::Values("dxf", "svg", "outline", "board", "solid", "stepnc"));
INSTANTIATE_TEST_SUITE_P(Works, EffectOfOptions,
                         testing::Values("profile", "cut-out", "line", "engraving", "carving", "face",
                                         "chamfer", "hole"));

}  // namespace
}  // namespace clearcut
