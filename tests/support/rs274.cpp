#include "support/rs274.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "base/file.h"
#include "support/command.h"

namespace clearcut::testing {
namespace {

constexpr int kTools = 20;

std::string tool_table() {
  std::string table;
  for (int t = 1; t <= kTools; ++t) table += "T" + std::to_string(t) + " P" + std::to_string(t) + " Z0 D6\n";
  return table;
}

bool starts(const std::string& text, const char* word) {
  return text.rfind(word, 0) == 0;
}

/// Follows the canonical calls; places are in program units and relative to the G92 offset.
class CanonReader {
 public:
  CanonProgram read(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const auto mark = line.find("N..... ");
      if (mark != std::string::npos) call(line.substr(mark + 7));
    }
    return program_;
  }

 private:
  void call(const std::string& text) {
    double a = 0, b = 0, c = 0, d = 0, z = 0;
    int turns = 0;
    if (starts(text, "USE_LENGTH_UNITS")) {
      unit_ = text.find("INCH") != std::string::npos ? 25.4 : 1;
    } else if (std::sscanf(text.c_str(), "SET_G92_OFFSET(%lf, %lf, %lf", &a, &b, &z) == 3) {
      offset_ = Vec2{a, b} * unit_;
      z_offset_ = z * unit_;
    } else if (std::sscanf(text.c_str(), "SET_FEED_RATE(%lf", &a) == 1) {
      feed_ = a * unit_;
    } else if (std::sscanf(text.c_str(), "STRAIGHT_TRAVERSE(%lf, %lf, %lf", &a, &b, &z) == 3) {
      add(true, 0, {a, b}, z, {});
    } else if (std::sscanf(text.c_str(), "STRAIGHT_FEED(%lf, %lf, %lf", &a, &b, &z) == 3) {
      add(false, 0, {a, b}, z, {});
    } else if (std::sscanf(text.c_str(), "ARC_FEED(%lf, %lf, %lf, %lf, %d, %lf", &a, &b, &c, &d, &turns,
                           &z) == 6) {
      add(false, turns, {a, b}, z, {c, d});
    } else if (starts(text, "PROGRAM_END")) {
      program_.accepted = true;
    }
  }

  void add(bool rapid, int turns, Vec2 to, double z, Vec2 center) {
    program_.moves.push_back({rapid, turns, to * unit_ + offset_, z * unit_ + z_offset_,
                              center * unit_ + offset_, rapid ? 0 : feed_});
  }

  CanonProgram program_;
  double unit_ = 1;
  Vec2 offset_;
  double z_offset_ = 0;
  double feed_ = 0;
};

}  // namespace

bool has_rs274() {
  return std::system("command -v rs274 >/dev/null 2>&1") == 0;
}

CanonProgram run_rs274(const std::string& program) {
  const ScratchFolder folder;
  folder.file("tool.tbl", tool_table());
  folder.file("rs274.var", "");
  folder.file("in.ngc", program);
  // It keeps a map of its tools in $HOME: an own one, so that tests may run side by side.
  const std::string go = "cd '" + folder.path("") +
                         "' && HOME=\"$PWD\" rs274 -g -t tool.tbl -v rs274.var in.ngc " +
                         "canon.txt >out.txt 2>err.txt </dev/null";
  const int status = std::system(go.c_str());
  CanonProgram canon = CanonReader().read(read_file(folder.path("canon.txt")));
  canon.message = read_file(folder.path("err.txt"));
  canon.accepted = canon.accepted && status == 0;
  return canon;
}

}  // namespace clearcut::testing
