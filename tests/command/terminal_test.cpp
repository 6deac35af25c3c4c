// What a person at a terminal gets: help, man page, completion, tables that fit, colours, progress and Ctrl-C.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include "base/file.h"
#include "support/command.h"
#include "support/solids.h"
#include "support/stepped_solid.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::AnyOf;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kSquare = R"({"name": "square", "units": "mm",
  "outer": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "islands": [], "top": 0, "depth": 2})";
const std::array<const char*, 16> kCommands{
    "serve", "plan",    "resume",  "batch", "setup-sheet", "verify", "check",     "info",
    "init",  "convert", "compare", "tools", "elements",    "tour",   "reproduce", "study"};

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, line.size());
  return widest;
}

/// Lines that head a group of commands or options.
std::vector<std::string> headings_in(const std::string& help) {
  std::vector<std::string> headings;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);)
    if (line.ends_with(':') && !line.starts_with(' ')) headings.push_back(line);
  return headings;
}

/// Long names of the options in the help of a command.
std::set<std::string> options_in(const std::string& help) {
  std::set<std::string> names;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  -")) continue;
    const auto at = line.find("--");
    names.insert(line.substr(at, line.find_first_of(" ,", at) - at));
  }
  return names;
}

std::string without(std::string text, char what) {
  std::erase(text, what);
  return text;
}

TEST(Help, IsGroupedAndFitsEightyColumns) {
  const auto all = run_clearcut({"--help"});
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_LE(widest_line(all.out), 80U);
  EXPECT_THAT(headings_in(all.out), ElementsAre("Planning:", "Checking:", "Reading:", "Choosing:",
                                                "Grids and tours:", "Research:", "Help:"));
  for (const char* command : kCommands) {
    EXPECT_THAT(all.out, HasSubstr(std::string("\n  ") + command + " "));
    const auto help = run_clearcut({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_LE(widest_line(help.out), 80U) << command;
    EXPECT_THAT(help.out, Not(HasSubstr("\nOptions:"))) << command << " has an option without a group";
  }
  const auto heading = all.out.find("\nChecking:\n");
  EXPECT_EQ(all.out.find("\nChecking:\n", heading + 1), std::string::npos) << "a group stands in two places";
  const auto plan = run_clearcut({"plan", "--help"}).out;
  for (const char* group :
       {"Input", "Tools", "Strategy", "Limits", "Feeds and speeds", "Controller", "Output"})
    EXPECT_THAT(plan, HasSubstr(std::string("\n") + group + ":\n"));
  EXPECT_THAT(plan, HasSubstr("(default 3)"));
  EXPECT_THAT(plan, HasSubstr("(default linuxcnc)"));
}

TEST(ManPage, AndCompletionHoldEveryOption) {
  const auto man = without(run_clearcut({"generate", "man"}).out, '\\');
  const auto bash = run_clearcut({"generate", "bash"}).out;
  const auto zsh = run_clearcut({"generate", "zsh"}).out;
  const auto fish = run_clearcut({"generate", "fish"}).out;
  std::size_t count = 0;
  for (const char* command : kCommands) {
    EXPECT_THAT(man, HasSubstr(std::string(".SH CLEARCUT ") + command + "\n"));
    for (const auto& option : options_in(run_clearcut({command, "--help"}).out)) {
      ++count;
      EXPECT_THAT(man, HasSubstr(option)) << command;
      EXPECT_THAT(bash, HasSubstr(option)) << command;
      EXPECT_THAT(zsh, HasSubstr("*" + option + "[")) << command;
      EXPECT_THAT(fish, HasSubstr("__fish_seen_subcommand_from " + std::string(command)));
      EXPECT_THAT(fish, HasSubstr(" -l " + option.substr(2) + " ")) << command;
    }
  }
  EXPECT_GT(count, 150U);
}

bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// The shells and readers that are here take what is made for them.
TEST(ManPage, AndCompletionAreTakenByTheirPrograms) {
  const ScratchFolder folder;
  for (const char* what : {"man", "bash", "zsh", "fish"})
    folder.file(what, run_clearcut({"generate", what}).out);
  const auto run = [](const std::string& line) { return std::system((line + " >/dev/null").c_str()); };
  EXPECT_EQ(run("bash -n " + folder.path("bash")), 0);
  if (has_program("zsh")) {
    EXPECT_EQ(run("zsh -n " + folder.path("zsh")), 0);
  }
  if (has_program("fish")) {
    EXPECT_EQ(run("fish -n " + folder.path("fish")), 0);
  }
  if (has_program("mandoc")) {
    EXPECT_EQ(run("mandoc -T lint -W error " + folder.path("man")), 0);
  }
  if (has_program("groff")) {
    EXPECT_EQ(run("test -z \"$(groff -man -ww -z " + folder.path("man") + " 2>&1)\""), 0);
  }
}

/// What bash offers for a line.
std::string offered(const ScratchFolder& folder, const std::string& words, int at) {
  const std::string script = "source " + folder.path("c") + "; COMP_WORDS=(" + words +
                             "); COMP_CWORD=" + std::to_string(at) + "; _clearcut; echo \"${COMPREPLY[@]}\"";
  EXPECT_EQ(std::system(("bash -c '" + script + "' >" + folder.path("out")).c_str()), 0);
  return read_file(folder.path("out"));
}

TEST(Completion, OffersCommandsOptionsAndValues) {
  const ScratchFolder folder;
  folder.file("c", run_clearcut({"generate", "bash"}).out);
  EXPECT_EQ(offered(folder, "clearcut pl", 1), "plan\n");
  EXPECT_EQ(offered(folder, "clearcut plan --stepo", 2), "--stepover\n");
  EXPECT_EQ(offered(folder, "clearcut plan --post h", 3), "haas heidenhain\n");
  EXPECT_EQ(offered(folder, "clearcut reproduce sca", 2), "scallop\n");
}

TEST(Tables, FitTheWidthAskedForAndStayWholeInPipes) {
  const ScratchFolder folder;
  const auto part = folder.file("square.json", kSquare);
  const auto out = folder.path("out.ngc");
  EXPECT_GT(widest_line(run_clearcut({"compare", part, "--tool", "endmill:16"}).out), 80U);
  ::setenv("COLUMNS", "80", 1);
  EXPECT_LE(widest_line(run_clearcut({"compare", part, "--tool", "endmill:16"}).out), 80U);
  EXPECT_LE(widest_line(run_clearcut({"reproduce", "coefficients"}).out), 80U);
  ::setenv("COLUMNS", "60", 1);
  const auto narrow = run_clearcut({"compare", part, "--tool", "endmill:16"});
  ::setenv("COLUMNS", "200", 1);
  const auto wide = run_clearcut({"compare", part, "--tool", "endmill:16"});
  ::unsetenv("COLUMNS");
  EXPECT_LE(widest_line(narrow.out), 60U);
  EXPECT_GT(widest_line(wide.out), 80U);
}

struct Ended {
  std::string shown;
  int status = 0;
};

using Environment = std::vector<std::pair<std::string, std::string>>;

/// Runs the command on a terminal of 80 columns; sends it `signal` after `interrupt_s` where that is above 0.
Ended on_terminal(std::vector<std::string> arguments, const Environment& environment, double interrupt_s = 0,
                  int signal = SIGINT) {
  int terminal = -1;
  winsize size{};
  size.ws_row = 24;
  size.ws_col = 80;
  arguments.insert(arguments.begin(), CLEARCUT_COMMAND);
  std::vector<char*> argv;
  for (auto& one : arguments) argv.push_back(one.data());
  argv.push_back(nullptr);
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    ::signal(SIGINT, SIG_DFL);
    ::setenv("TERM", "xterm", 1);
    ::unsetenv("NO_COLOR");
    for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  std::thread interrupter([&] {
    if (interrupt_s <= 0) return;
    std::this_thread::sleep_for(std::chrono::duration<double>(interrupt_s));
    ::kill(child, signal);
  });
  Ended ended;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; (got = ::read(terminal, buffer.data(), buffer.size())) > 0;)
    ended.shown.append(buffer.data(), static_cast<std::size_t>(got));
  ::waitpid(child, &ended.status, 0);
  interrupter.join();
  ::close(terminal);
  return ended;
}

std::vector<std::string> quick_plan(const ScratchFolder& folder) {
  return {"plan",       folder.file("square.json", kSquare),
          "--tool",     "endmill:16",
          "--strategy", "contour",
          "-o",         folder.path("out.ngc")};
}

TEST(Colours, AreForTheVerdictOnATerminalAlone) {
  const ScratchFolder folder;
  auto call = quick_plan(folder);
  EXPECT_THAT(on_terminal(call, {}).shown, HasSubstr("verdict: \x1b[33mCONDITIONAL\x1b[0m"));
  call.insert(call.end(), {"--accept", "out-of-reach"});
  EXPECT_THAT(on_terminal(call, {}).shown, HasSubstr("verdict: \x1b[32mCLEAN\x1b[0m"));
  EXPECT_THAT(on_terminal(call, {{"NO_COLOR", "1"}}).shown, HasSubstr("verdict: CLEAN"));
  EXPECT_THAT(on_terminal(call, {{"TERM", "dumb"}}).shown, HasSubstr("verdict: CLEAN"));
  EXPECT_THAT(run_clearcut(call).out, Not(HasSubstr("\x1b")));
}

/// A large pocket, minutes of work for a small cutter.
std::string long_part() {
  return R"({"name": "large", "units": "mm",
    "outer": [[0,0,0.1],[400,0,0.2],[400,300,0.1],[0,300,0.3]], "islands": [[[200,150,1],[150,150,1]]],
    "top": 0, "depth": 5})";
}

std::vector<std::string> long_work(const ScratchFolder& folder, const std::string& command) {
  const auto part = folder.file("large.json", long_part());
  return {command, part, "--tool", "endmill:1", "--tool", "endmill:1.5"};
}

TEST(Progress, OfATourSaysItsBestValueSoFar) {
  const std::vector<std::string> call{"tour",     "13x12",     "--closed", "--objective", "1:length,7:turns",
                                      "--solver", "published", "--time",   "3",           "--patience",
                                      "100000000"};
  EXPECT_THAT(on_terminal(call, {}).shown, HasSubstr("searching: best "));
  EXPECT_THAT(on_terminal(call, {{"CLEARCUT_PROGRESS", "json"}}).shown,
              HasSubstr(R"({"progress":{"stage":"searching","best":)"));
}

/// A program that is judged for seconds: four layers of close lines.
std::string long_program() {
  std::string text = "G21 G90 G17 G54\nT1 M6\nS5000 M3\nG0 X10 Y10\n";
  for (int layer = 1; layer <= 4; ++layer) {
    text += "G0 Z5\nG0 X10 Y10\nG1 Z-" + std::to_string(layer) + " F100\n";
    for (int row = 0; row < 800; ++row)
      text += "G1 X" + std::to_string(row % 2 == 0 ? 390 : 10) + " F900\nG1 Y" +
              std::to_string(10 + 0.35 * (row + 1)) + "\n";
  }
  return text + "G0 Z5\nM5\nM2\n";
}

TEST(Progress, OfACheckSaysHowFarItIs) {
  const ScratchFolder folder;
  const auto program = folder.file("long.ngc", long_program());
  const std::vector<std::string> call{"verify",  program,     "--tool",    "endmill:1",
                                      "--stock", "400,300,5", "--dialect", "linuxcnc"};
  const auto ended = on_terminal(call, {}, 3);
  EXPECT_THAT(ended.shown, ContainsRegex("certifying the program: [0-9]+ % done, about [0-9]+ s left"));
  EXPECT_THAT(ended.shown, HasSubstr("Ctrl-C stops."));
  auto quiet = call;
  quiet.emplace_back("--quiet");
  EXPECT_THAT(on_terminal(quiet, {}, 3).shown, Not(HasSubstr("certifying")));
}

TEST(Progress, OfReadingSaysThatItReads) {
  SKIP_WITHOUT_OPEN_CASCADE();
  // Thousands of faces.
  test_support::SteppedSolid solid;
  for (int i = 0; i <= 20; ++i) solid.x.push_back(i);
  solid.y = solid.x;
  for (int j = 0; j < 20; ++j) {
    solid.heights.emplace_back();
    for (int i = 0; i < 20; ++i) solid.heights.back().push_back(10 + (5 * i + 7 * j) % 11);
  }
  const ScratchFolder folder;
  const auto file = folder.file("blocks.step", step_text(solid));
  EXPECT_THAT(on_terminal({"info", file}, {}).shown, HasSubstr("reading " + file));
}

TEST(Progress, OfBatchesAndStudiesCountsWhatIsDone) {
  const ScratchFolder folder;
  folder.file("parts/one.json", kSquare);
  folder.file("parts/two.json", long_part());
  const auto batch = on_terminal({"batch", folder.path("parts"), "--tool", "endmill:1.5", "--jobs", "1",
                                  "--part-time", "3", "-o", folder.path("out")},
                                 {});
  EXPECT_THAT(batch.shown, ContainsRegex("1 of 2 parts done \\([0-9]+ s\\)"))
      << "one quick part says nothing of a long one";
  EXPECT_THAT(batch.shown, ContainsRegex("\r\x1b\\[KTIMED OUT +two")) << "the line makes room for the row";
  const auto study = on_terminal({"study", "population", "--runs", "2", "--generations", "2000", "--threads",
                                  "1", "--csv", folder.path("rows.csv")},
                                 {}, 2.5);
  EXPECT_THAT(study.shown, ContainsRegex("[1-9][0-9]* of 16 runs done, about [0-9]+ s left"));
}

/// While one strategy takes its time, what is left falls; it grew by as much as all that are to come.
TEST(Progress, OfAComparisonFallsWhileNothingEnds) {
  const ScratchFolder folder;
  const std::string part = R"({"name": "wide", "units": "mm",
    "outer": [[0,0,0.1],[130,0,0.2],[130,100,0.1],[0,100,0.3]], "islands": [[[70,50,1],[50,50,1]]],
    "top": 0, "depth": 5})";
  const std::string shown =
      on_terminal({"compare", folder.file("wide.json", part), "--tool", "endmill:6"}, {}).shown;
  const std::regex line("([0-9]+) of [0-9]+ strategies done, about ([0-9]+) s left");
  int done = 0, left = 0, count = 0;
  for (std::sregex_iterator at(shown.begin(), shown.end(), line), end; at != end; ++at, ++count) {
    const int now_done = std::stoi((*at)[1]), now_left = std::stoi((*at)[2]);
    EXPECT_TRUE(now_done > done || now_left <= left) << at->str();
    done = now_done;
    left = now_left;
  }
  EXPECT_GT(count, 3) << shown;
}

class Interrupt : public ::testing::TestWithParam<int> {};

TEST_P(Interrupt, LeavesNothingBehindAndEndsByTheSignal) {
  for (const char* command : {"plan", "compare", "tools"}) {
    const ScratchFolder folder;
    auto call = long_work(folder, command);
    if (call.front() == "plan") call.insert(call.end(), {"-o", folder.path("out.ngc")});
    const auto ended = on_terminal(call, {}, 2.5, GetParam());
    ASSERT_TRUE(WIFSIGNALED(ended.status)) << command << ended.shown;
    EXPECT_EQ(WTERMSIG(ended.status), GetParam()) << command;
    EXPECT_THAT(ended.shown,
                AnyOf(HasSubstr("planning:"), HasSubstr("certifying the program"), HasSubstr(" done")))
        << command;
    EXPECT_THAT(ended.shown, HasSubstr("\r\x1b[Kclearcut: stopped")) << command;
    EXPECT_THAT(folder.names(), ElementsAre("large.json")) << command;
  }
}

TEST_P(Interrupt, OfAnythingElseLeavesNothingBehind) {
  const ScratchFolder folder;
  folder.file("large.json", long_part());
  folder.file("long.ngc", long_program());
  folder.file("parts/large.json", long_part());
  std::filesystem::create_directories(folder.path("out"));
  const auto before = folder.names();
  const std::string out = folder.path("out");
  const std::vector<std::vector<std::string>> calls{
      {"verify", folder.path("long.ngc"), "--tool", "endmill:1", "--stock", "400,300,5", "--json",
       folder.path("c.json")},
      {"batch", folder.path("parts"), "--tool", "endmill:1", "-o", out},
      {"reproduce", "objectives"},
      {"tour", "13x12", "--closed", "--objective", "1:length,7:turns", "--solver", "published", "--time",
       "60", "--patience", "100000000", "--json", folder.path("t.json")},
      {"study", "time", "--runs", "2", "--generations", "100000"}};
  for (const auto& call : calls) {
    const auto ended = on_terminal(call, {}, 1.5, GetParam());
    ASSERT_TRUE(WIFSIGNALED(ended.status)) << call.front() << ended.shown;
    EXPECT_THAT(ended.shown, HasSubstr("\r\x1b[Kclearcut: stopped")) << call.front();
    EXPECT_EQ(folder.names(), before) << call.front();
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_TRUE(std::filesystem::is_empty(out));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, ::testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace clearcut
