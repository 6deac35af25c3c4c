// Programs as senders take them: the rows of docs/senders.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "base/random.h"
#include "post/post.h"
#include "support/independent/grbl.h"

namespace clearcut {
namespace {

/// What a sender takes, of the text that is written for its control.
struct Sender {
  const char* name;
  const char* dialect;
  std::size_t longest_line;    ///< characters
  std::size_t longest_packed;  ///< of a block without comments and blanks; 0: no other limit
  bool takes_percent;          ///< a line of '%' is no command of the sender's own
  bool takes_m6;               ///< M6 reaches nothing that refuses it
  bool takes_t;                ///< T words may stand alone
  const char* endings;         ///< of file names
};

constexpr Sender kSenders[] = {
    {"UGS", "grbl", 127, 50, false, false, true, ".nc .gcode .ngc .tap .txt"},
    {"gSender", "grbl", 127, 0, false, false, true, ".nc .gcode .ngc .tap .cnc .txt"},
    {"CNCjs", "grbl", 127, 0, false, false, true, ".nc .gcode .ngc .tap .cnc"},
    {"bCNC", "grbl", 127, 0, false, false, true, ".nc .ngc .gcode .tap .cnc"},
    {"Candle", "grbl", 127, 0, false, false, true, ".nc .ncc .ngc .tap .gc .gcode .txt"},
    {"ioSender", "grbl", 127, 0, false, false, true, ".nc .ncc .ngc .gcode .tap .txt"},
    {"axis", "linuxcnc", 255, 0, true, true, true, ".ngc .nc .tap"},
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Without comments in parentheses and blanks.
std::string packed(const std::string& line) {
  std::string text;
  bool in_comment = false;
  for (const char c : line) {
    if (c == '(') in_comment = true;
    if (!in_comment && c != ' ') text += c;
    if (c == ')') in_comment = false;
  }
  return text;
}

/// Arcs, helices and lines within 200 x 200 x 40 mm, by two tools.
Toolpath work_of_two_tools(std::uint64_t seed) {
  Random random(seed);
  const auto place = [&] { return Vec2{198 * random.unit() - 99, 198 * random.unit() - 99}; };
  Toolpath toolpath;
  for (int tool = 1; tool <= 2; ++tool) {
    Section section;
    section.label = "POCKET";
    section.tool_number = tool;
    section.spindle_rpm = 18000;
    Vec2 at = place();
    double z = 10;
    const auto add = [&](const Edge& edge, double to, MoveKind kind, double feed) {
      section.moves.push_back({edge, z, to, kind, MmPerMin::of(feed), 0});
      at = edge.to;
      z = to;
    };
    add(Edge::line(at, at), 1, MoveKind::kRapid, 0);
    add(Edge::line(at, at), -0.1234, MoveKind::kPlunge, 123.45);
    for (int i = 0; i < 60; ++i) {
      const Vec2 to = place(), centre = lerp(at, to, 0.5) + left_of(to - at) * (0.3 * random.unit() - 0.15);
      const double low = -40 * random.unit();
      const bool level = i % 3 == 0;
      if (i % 2 == 0)
        add(Edge::arc(at, to, centre, Turn::kClockwise), level ? z : low, MoveKind::kCut, 1000 + 7.5 * i);
      else
        add(Edge::line(at, to), level ? z : low, MoveKind::kCut, 1000 + 7.5 * i);
    }
    add(Edge::line(at, at), 10, MoveKind::kRapid, 0);
    toolpath.sections.push_back(std::move(section));
  }
  return toolpath;
}

std::string program_for(const Sender& sender, std::uint64_t seed, bool inch) {
  PostOptions options;
  options.dialect = sender.dialect;
  options.inch = inch;
  options.program_name = "A \"part\" (100%) ~ $1 [x] #5 \xC3\xA9";
  options.header = {"$X would unlock, ! holds, ? asks, ~ goes on", "%wait", "MSG, LOGOPEN"};
  return post::write_program(work_of_two_tools(seed), Part{}, options);
}

void expect_taken(const Sender& sender, const std::string& text) {
  for (const std::string& line : lines_of(text)) {
    const std::string block = packed(line);
    EXPECT_LE(line.size(), sender.longest_line) << line;
    if (sender.longest_packed > 0) {
      EXPECT_LE(block.size(), sender.longest_packed) << line;
    }
    if (!sender.takes_percent) {
      EXPECT_FALSE(line.starts_with('%')) << line;
    }
    if (!sender.takes_m6) {
      EXPECT_EQ(block.find("M6"), std::string::npos) << line;
    }
    // Letters, digits and signs alone: nothing that a control obeys at once, and no expression of a sender.
    EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; })) << line;
    EXPECT_EQ(line.find_first_of("!?~$[]{}\"%"), std::string::npos) << line;
    EXPECT_EQ(line.find(';'), std::string::npos) << line;
    EXPECT_LE(std::count(line.begin(), line.end(), '('), 1) << line;
    EXPECT_EQ(std::count(line.begin(), line.end(), '('), std::count(line.begin(), line.end(), ')')) << line;
  }
}

TEST(Senders, TakeOurProgramsAsTheyAre) {
  for (const Sender& sender : kSenders) {
    SCOPED_TRACE(sender.name);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) expect_taken(sender, program_for(sender, seed, false));
    const std::string ending = post::file_extension_of(sender.dialect);
    EXPECT_NE((std::string(sender.endings) + " ").find(ending + " "), std::string::npos) << ending;
  }
}

/// Tools are changed at a pause that every one of them stops at; the text says which tool.
TEST(Senders, PauseForToolsThatAreChangedByHand) {
  for (const Sender& sender : kSenders) {
    SCOPED_TRACE(sender.name);
    const std::string text = program_for(sender, 1, false);
    const std::size_t change = text.find("TOOL CHANGE T2");
    ASSERT_NE(change, std::string::npos);
    const std::string after = text.substr(change, 120);
    EXPECT_NE(after.find(sender.takes_m6 ? "T2 M6" : "\nM0\n"), std::string::npos) << after;
    EXPECT_TRUE(sender.takes_m6 || test_support::grbl_faults(text).empty());
    // Nothing stands behind the end, and the end is there.
    const std::string end = sender.takes_m6 ? "M2\n" : "M30\n";
    EXPECT_TRUE(text.ends_with(end)) << text.substr(text.size() - 20);
  }
}

}  // namespace
}  // namespace clearcut
