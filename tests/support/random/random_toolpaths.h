// For tests: random toolpaths.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/random.h"
#include "model/move.h"

namespace clearcut::test_support {

inline Vec2 random_point(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size)};
}

/// Toolpaths of lines, arcs of every size and sweep, helices, vertical moves and full circles. Every feed
/// move has a feed of its own, by which it is known again.
class RandomPath {
 public:
  explicit RandomPath(std::uint64_t seed) : random_(seed) { at_ = random_point(random_, 50); }

  Toolpath toolpath(int sections, int moves) {
    Toolpath path;
    for (int s = 0; s < sections; ++s) {
      Section section;
      section.label = "POCKET" + std::to_string(s);
      section.workingstep = s;
      section.tool_number = 1 + s / 2;
      section.spindle_rpm = 1000 * (1 + s / 3);
      section.spindle_clockwise = s % 5 != 4;
      section.coolant = static_cast<Coolant>((s * 3) % 4);
      while (static_cast<int>(section.moves.size()) < moves) add_move(section);
      path.sections.push_back(std::move(section));
    }
    return path;
  }

 private:
  void add_move(Section& section) {
    Move move;
    move.z_from = z_;
    move.z_to = random_.below(3) == 0 ? random_.between(-10, 5) : z_;
    move.path = random_edge();
    if (move.is_vertical() && move.z_to == z_) return;
    const bool rapid = !move.path.is_arc() && !section.moves.empty() && random_.below(6) == 0;
    move.kind = rapid ? MoveKind::kRapid : MoveKind::kCut;
    if (!rapid) move.feed = MmPerMin::of(++feed_);
    at_ = move.path.to;
    z_ = move.z_to;
    section.moves.push_back(move);
  }

  Edge random_edge() {
    switch (random_.below(6)) {
      case 0:
        return Edge::line(at_, random_point(random_, 50));
      case 1:
        return Edge::line(at_, at_ + random_point(random_, 0.002));
      case 2:
        return Edge::line(at_, at_);
      default:
        return random_arc();
    }
  }

  Edge random_arc() {
    const double radius = std::pow(10, random_.between(-3, 5));
    const double widest = std::min(2 * kPi * 0.9999, 100 / radius);
    const double sweep = random_.below(4) == 0 ? std::min(widest, kPi) : widest * random_.unit();
    const double side = random_.below(2) == 0 ? 1 : -1;
    const double start = random_.between(0, 2 * kPi);
    const Vec2 center = at_ - direction_of(start) * radius;
    const Vec2 to = center + direction_of(start + side * sweep) * radius;
    if (distance(to, at_) < 1e-6) return Edge::line(at_, at_);
    return Edge::arc(at_, to, center, side > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
  }

  Random random_;
  Vec2 at_;
  double z_ = 0;
  double feed_ = 100;
};

struct Place3 {
  Vec2 point;
  double z = 0;
};

inline double distance(const Place3& a, const Place3& b) {
  return std::hypot(distance(a.point, b.point), a.z - b.z);
}

inline double length_of(const std::vector<Move>& moves) {
  double total = 0;
  for (const Move& move : moves) total += move.length();
  return total;
}

/// A run of moves as one curve.
inline Place3 place_on(const std::vector<Move>& moves, double fraction) {
  double left = fraction * length_of(moves);
  for (const Move& move : moves) {
    const double length = move.length();
    if (left <= length || &move == &moves.back()) {
      const double t = length > 0 ? std::clamp(left / length, 0.0, 1.0) : 1.0;
      return {move.is_vertical() ? move.path.to : move.path.at(t), std::lerp(move.z_from, move.z_to, t)};
    }
    left -= length;
  }
  return {};
}

/// Largest distance between two curves at equal fractions of their lengths.
inline double deviation_in_step(const std::vector<Move>& a, const std::vector<Move>& b) {
  constexpr int kSamples = 16;
  double largest = 0;
  for (int k = 0; k <= kSamples; ++k) {
    const double t = static_cast<double>(k) / kSamples;
    largest = std::max(largest, distance(place_on(a, t), place_on(b, t)));
  }
  return largest;
}

/// Largest distance in plan from a point of `a` to the nearest of `b`.
inline double deviation_aside(const std::vector<Move>& a, const std::vector<Move>& b) {
  double largest = 0;
  for (int k = 0; k <= 16; ++k) {
    const Vec2 p = place_on(a, k / 16.0).point;
    double least = HUGE_VAL;
    for (const Move& move : b) {
      least = std::min(least, move.is_vertical() ? distance(move.path.to, p) : distance(move.path, p));
    }
    largest = std::max(largest, least);
  }
  return largest;
}

/// Feed moves of a section by their feed, which each move of a RandomPath has for itself.
inline std::map<long long, std::vector<Move>> by_feed(const Section& section) {
  std::map<long long, std::vector<Move>> moves;
  long long last = 0;
  for (const Move& move : section.moves) {
    if (is_rapid(move.kind)) continue;
    const long long feed = std::llround(move.feed.mm_per_min());
    EXPECT_GE(feed, last) << "out of order at line " << move.line;
    last = feed;
    moves[feed].push_back(move);
  }
  return moves;
}

/// Correct means: the same sections with the same tool, spindle and coolant; within each, the feed moves of
/// the original in their order; no point of either beside the other by more than `aside`, and in step within
/// three times that (rounding also shortens and lengthens). Moves under `smallest` may be missing, rapids may
/// be added.
inline void expect_same(const Toolpath& wanted, const Toolpath& got, double aside, double smallest) {
  ASSERT_EQ(wanted.sections.size(), got.sections.size());
  for (std::size_t s = 0; s < wanted.sections.size(); ++s) {
    const Section& a = wanted.sections[s];
    const Section& b = got.sections[s];
    EXPECT_EQ(a.label, b.label);
    EXPECT_EQ(a.workingstep, b.workingstep);
    EXPECT_EQ(a.tool_number, b.tool_number);
    EXPECT_EQ(a.spindle_rpm, b.spindle_rpm);
    EXPECT_EQ(a.spindle_clockwise, b.spindle_clockwise);
    EXPECT_EQ(a.coolant, b.coolant);
    const auto read = by_feed(b);
    for (const auto& [feed, moves] : by_feed(a)) {
      const auto found = read.find(feed);
      if (found == read.end()) {
        EXPECT_LT(length_of(moves), smallest);
        continue;
      }
      const int line = found->second.front().line;
      EXPECT_LE(deviation_aside(moves, found->second), aside) << "line " << line;
      EXPECT_LE(deviation_aside(found->second, moves), aside) << "line " << line;
      EXPECT_LE(deviation_in_step(moves, found->second), 3 * aside) << "line " << line;
    }
  }
}

inline PostOptions options_for(const std::string& dialect, bool inch) {
  PostOptions options;
  options.dialect = dialect;
  options.inch = inch;
  return options;
}

}  // namespace clearcut::test_support
