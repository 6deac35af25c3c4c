#include "support/independent/rs274.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "base/file.h"
#include "base/units.h"
#include "support/command.h"

namespace clearcut::test_support {
namespace {

constexpr int kTools = 20;

std::string tool_table(double diameter) {
  std::string table;
  for (int t = 1; t <= kTools; ++t)
    table += "T" + std::to_string(t) + " P" + std::to_string(t) + " Z0 D" + std::to_string(diameter) + "\n";
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
      // "   26 N99    STRAIGHT_FEED(...)": count, line number or dots, call.
      const auto mark = line.find('N');
      const auto name = line.find_first_not_of(' ', line.find(' ', mark));
      if (name != std::string::npos) call(line.substr(name));
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

struct Place3 {
  Vec2 point;
  double z = 0;
};

/// A canonical motion, its beginning included, sampled without the reader's geometry.
struct CanonCurve {
  Place3 from;
  CanonMove move;

  double sweep() const {
    const Vec2 a = from.point - move.center, b = move.to - move.center;
    const double side = move.turns > 0 ? 1 : -1;
    double angle = side * (angle_of(b) - angle_of(a));
    while (angle <= 1e-6) angle += 2 * kPi;
    while (angle > 2 * kPi + 1e-6) angle -= 2 * kPi;
    return side * (angle + 2 * kPi * (std::abs(move.turns) - 1));
  }
  double length() const {
    const double rise = move.z - from.z;
    if (move.turns == 0) return std::hypot(distance(from.point, move.to), rise);
    const double radius = (distance(from.point, move.center) + distance(move.to, move.center)) / 2;
    return std::hypot(radius * sweep(), rise);
  }
  Place3 at(double t) const {
    const double z = std::lerp(from.z, move.z, t);
    if (move.turns == 0) return {lerp(from.point, move.to, t), z};
    const Vec2 arm = from.point - move.center;
    const double radius = std::lerp(norm(arm), distance(move.to, move.center), t);
    return {move.center + rotated(unit(arm), sweep() * t) * radius, z};
  }
};

double distance_to(const Move& move, const Place3& p) {
  if (move.is_vertical()) {
    const double z = std::clamp(p.z, std::min(move.z_from, move.z_to), std::max(move.z_from, move.z_to));
    return std::hypot(distance(move.path.to, p.point), p.z - z);
  }
  const Nearest near = nearest(move.path, p.point);
  // On a steep helix the nearest point lies a little farther along than the nearest one in plan.
  const double slope = (move.z_to - move.z_from) / move.path.length();
  const double beside = (p.z - std::lerp(move.z_from, move.z_to, near.t)) / std::hypot(1, slope);
  return std::hypot(near.distance, beside);
}

double distance_to(const std::vector<Move>& moves, const Place3& p) {
  double least = HUGE_VAL;
  for (const Move& move : moves) least = std::min(least, distance_to(move, p));
  return least;
}

class Comparison {
 public:
  explicit Comparison(double tolerance) : tolerance_(tolerance) {}

  void compare(const std::vector<CanonMove>& canon, const std::vector<Move>& ours) {
    std::size_t next = first_feed(ours);
    Place3 at;
    bool begun = false;
    int compared = 0;
    for (const CanonMove& move : canon) {
      const CanonCurve curve{at, move};
      begun = begun || !move.rapid;
      at = {move.to, move.z};
      if (!begun || curve.length() < 1e-6) continue;
      const std::vector<Move> group = take(ours, next, curve.length());
      ASSERT_FALSE(group.empty()) << "no move left for one to " << move.to.x << " " << move.to.y << " "
                                  << move.z;
      compare(curve, group);
      if (::testing::Test::HasFailure()) return;
      ++compared;
    }
    EXPECT_EQ(next, ours.size());
    EXPECT_GT(compared, 2);
  }

 private:
  static std::size_t first_feed(const std::vector<Move>& moves) {
    std::size_t k = 0;
    while (k < moves.size() && is_rapid(moves[k].kind)) ++k;
    return k;
  }

  std::vector<Move> take(const std::vector<Move>& ours, std::size_t& next, double length) const {
    std::vector<Move> group;
    double taken = 0;
    while (next < ours.size() && (group.empty() || taken < length - 2 * tolerance_)) {
      taken += ours[next].length();
      group.push_back(ours[next++]);
    }
    return group;
  }

  void compare(const CanonCurve& curve, const std::vector<Move>& group) const {
    const int line = group.front().line;
    EXPECT_EQ(group.back().line, line);
    EXPECT_EQ(is_rapid(group.front().kind), curve.move.rapid) << "line " << line;
    if (!curve.move.rapid) {
      EXPECT_NEAR(group.front().feed.mm_per_min(), curve.move.feed, 1e-3) << "line " << line;
    }
    double length = 0;
    for (const Move& move : group) length += move.length();
    EXPECT_NEAR(length, curve.length(), 4 * tolerance_) << "line " << line;
    for (int k = 0; k <= 24; ++k)
      EXPECT_LE(distance_to(group, curve.at(k / 24.0)), tolerance_) << "line " << line;
    EXPECT_LE(distance(group.back().path.to, curve.move.to), tolerance_) << "line " << line;
    EXPECT_NEAR(group.back().z_to, curve.move.z, tolerance_) << "line " << line;
  }

  double tolerance_;
};

}  // namespace

bool has_rs274() {
  return std::system("command -v rs274 >/dev/null 2>&1") == 0;
}

CanonProgram run_rs274(const std::string& program, double tool_diameter) {
  const ScratchFolder folder;
  folder.file("tool.tbl", tool_table(tool_diameter));
  folder.file("rs274.var", "");
  folder.file("in.ngc", program);
  // It keeps a map of its tools in $HOME: an own one, so that tests may run side by side.
  const std::string go = "cd '" + folder.path("") +
                         "' && HOME=\"$PWD\" rs274 -g -t tool.tbl -v rs274.var in.ngc " +
                         "canon.txt >out.txt 2>err.txt </dev/null";
  const int status = std::system(go.c_str());
  const std::string output = read_file(folder.path("canon.txt"));
  CanonProgram canon = CanonReader().read(output);
  canon.canon = output;
  canon.message = read_file(folder.path("err.txt"));
  canon.accepted = canon.accepted && status == 0;
  return canon;
}

void expect_same_motion(const CanonProgram& canon, const Toolpath& toolpath, double tolerance) {
  std::vector<Move> moves;
  for (const Section& section : toolpath.sections) {
    moves.insert(moves.end(), section.moves.begin(), section.moves.end());
  }
  Comparison(tolerance).compare(canon.moves, moves);
}

}  // namespace clearcut::test_support
