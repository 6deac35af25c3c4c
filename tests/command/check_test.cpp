// clearcut check: what of a certificate, its program or its part was altered is said; verdicts as exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "report/certificate/certificate_json.h"
#include "support/command.h"

namespace clearcut {
namespace {

using test_support::CommandResult;
using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;

const std::string kSquare = R"({"name": "square", "units": "mm",
  "outer": [[0, 0, 0], [30, 0, 0], [30, 30, 0], [0, 30, 0]], "islands": [], "top": 0, "depth": 2})";

class Check : public ::testing::Test {
 protected:
  Check() {
    part_ = folder_.file("square.json", kSquare);
    program_ = folder_.path("square.ngc");
    certificate_ = folder_.path("square.cert.json");
    planned_ = run_clearcut({"plan", part_, "-o", program_, "--tool", "endmill:6", "--strategy", "contour",
                             "--certificate", certificate_});
  }

  CommandResult check(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"check", certificate_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_clearcut(arguments);
  }
  void replace(const std::string& file, const std::string& before, const std::string& after) const {
    std::string text = read_file(file);
    ASSERT_NE(text.find(before), std::string::npos) << before;
    text.replace(text.find(before), before.size(), after);
    write_files({{file, text}});
  }

  ScratchFolder folder_;
  std::string part_, program_, certificate_;
  CommandResult planned_;
};

TEST_F(Check, HoldsForWhatWasPlannedAndComputedAgain) {
  ASSERT_EQ(planned_.exit_code, 0) << planned_.err;
  const CommandResult once = check(), again = check({"--again"});
  EXPECT_EQ(once.exit_code, 0) << once.out;
  EXPECT_THAT(once.out, HasSubstr("holds; CLEAN"));
  EXPECT_EQ(again.exit_code, 0) << again.out;
}

TEST_F(Check, SaysThatTheProgramWasAltered) {
  replace(program_, "M2", "M2 ");
  const CommandResult found = check();
  EXPECT_EQ(found.exit_code, 1);
  EXPECT_THAT(found.out, HasSubstr("program " + program_ + " is not the one that was certified"));
}

TEST_F(Check, SaysThatThePartWasAlteredByFiveMicrometres) {
  replace(part_, "[30, 30, 0]", "[30, 30.005, 0]");
  const CommandResult found = check();
  EXPECT_EQ(found.exit_code, 1);
  EXPECT_THAT(found.out, HasSubstr("part " + part_ + " is not the one that was certified"));
}

TEST_F(Check, SaysWhichFieldOfTheCertificateWasAltered) {
  auto json = nlohmann::ordered_json::parse(read_file(certificate_));
  json["features"][0]["gouge_mm"] = 0.25;
  write_files({{certificate_, json.dump(2)}});
  EXPECT_EQ(check().exit_code, 1);
  EXPECT_THAT(check().out, HasSubstr("altered after it was written"));
  EXPECT_THAT(check({"--again"}).out, HasSubstr("again /features/0/gouge_mm: 0.25 is now"));
}

/// Anybody can seal: what the fields say of each other counts, too.
TEST_F(Check, SealedAgainACertificateMayNotContradictItself) {
  auto json = nlohmann::ordered_json::parse(read_file(certificate_));
  json["gouge_mm"] = 5;
  json.erase("seal");
  json["seal"] = report::seal_of(json);
  write_files({{certificate_, json.dump(2)}});
  EXPECT_EQ(check().exit_code, 1);
  EXPECT_THAT(check().out, HasSubstr("contradicts itself: /gouge_mm: is 5"));
}

TEST_F(Check, FindsFilesThatLieElsewhereNow) {
  const ScratchFolder other;
  const std::string part = other.file("square.json", read_file(part_)),
                    program = other.file("other.ngc", read_file(program_));
  write_files({{part_, "{}"}, {program_, "M2\n"}});
  EXPECT_EQ(check().exit_code, 1);
  const CommandResult found = check({"--part", part, "--program", program, "--again"});
  EXPECT_EQ(found.exit_code, 0) << found.out;
}

TEST_F(Check, RefusesWhatIsNoCertificate) {
  EXPECT_EQ(run_clearcut({"check", part_}).exit_code, 1);
  EXPECT_EQ(run_clearcut({"check", program_}).exit_code, 2);
}

TEST_F(Check, VerifiedProgramsHaveCertificatesToo) {
  const std::string json = folder_.path("verified.json");
  std::vector<std::string> arguments{"verify", program_,    "--part", part_,
                                     "--tool", "endmill:6", "--json", json};
  EXPECT_EQ(run_clearcut(arguments).exit_code, 0);
  EXPECT_EQ(run_clearcut({"check", json, "--again"}).exit_code, 0);
}

TEST_F(Check, EachSetUpOfAJobIsComputedAgain) {
  const std::string program = folder_.path("both.ngc"), json = folder_.path("both.json");
  ASSERT_EQ(run_clearcut({"plan", CLEARCUT_SOURCE_DIR "/examples/two_sided.toml", "-o", program,
                          "--certificate", json, "--quiet"})
                .exit_code,
            0);
  for (const char* number : {"1", "2"}) {
    const auto found =
        run_clearcut({"check", folder_.path(std::string("both-") + number + ".json"), "--again"});
    EXPECT_EQ(found.exit_code, 0) << found.out << found.err;
  }
}

/// G55: conditional until it is accepted; --quiet says so on one line.
TEST_F(Check, AConditionIsOpenUntilItIsAccepted) {
  replace(program_, "G54", "G55");
  const std::vector<std::string> verify{"verify", program_,    "--part", part_,
                                        "--tool", "endmill:6", "--quiet"};
  const CommandResult open = run_clearcut(verify);
  EXPECT_EQ(open.exit_code, 1);
  EXPECT_THAT(open.out, ::testing::StartsWith("CONDITIONAL\ncondition g55: "));
  std::vector<std::string> accepting = verify;
  accepting.insert(accepting.end(), {"--accept", "g55", "--dialect", "linuxcnc"});
  const CommandResult accepted = run_clearcut(accepting);
  EXPECT_EQ(accepted.exit_code, 0) << accepted.out;
  EXPECT_EQ(accepted.out, "CLEAN\n");
}

}  // namespace
}  // namespace clearcut
