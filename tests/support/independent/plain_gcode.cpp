#include "support/independent/plain_gcode.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace clearcut::test_support {
namespace {

constexpr double kTurn = 6.283185307179586;

struct Block {
  std::vector<int> g, m;  ///< in tenths
  std::map<char, double> words;
};

/// Without comments and blanks.
Block block_of(const std::string& line) {
  Block block;
  for (std::size_t at = 0; at < line.size();) {
    const char letter = line[at];
    if (letter == ';') break;
    if (letter == '(') {
      at = std::min(line.find(')', at), line.size() - 1) + 1;
      continue;
    }
    if (letter == ' ' || letter == '%' || letter == '\r') {
      ++at;
      continue;
    }
    const char* begin = line.c_str() + at + 1;
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    if (end == begin) throw std::runtime_error("no number in: " + line);
    if (letter == 'G' || letter == 'M') {
      (letter == 'G' ? block.g : block.m).push_back(static_cast<int>(std::lround(value * 10)));
    } else {
      block.words[letter] = value;
    }
    at = static_cast<std::size_t>(end - line.c_str());
  }
  return block;
}

bool is_cycle(int motion) {
  static const std::set<int> kCycles{730, 740, 810, 820, 830, 840, 850};
  return kCycles.count(motion) > 0;
}

class Way {
 public:
  /// `by_hand`: the program has no M6, and its T words say which tool is put in.
  Way(double sagitta, bool by_hand) : sagitta_(sagitta), by_hand_(by_hand) {}

  void take(const Block& block, const std::string& line) {
    ++at_.line;
    if (is_ended_) return;
    set_states(block, line);
    const bool still = set_motion(block, line);
    const auto has = [&](char letter) { return block.words.count(letter) > 0; };
    if (still || !(has('X') || has('Y') || has('Z') || has('I') || has('J'))) return;
    if (motion_ == kNone) throw std::runtime_error("no motion in force in: " + line);
    if (is_cycle(motion_)) {
      run_cycle(block.words);
    } else if (motion_ == kTap) {
      tap(block.words);
    } else {
      move(block.words);
    }
  }

  std::vector<TipWay> done;

 private:
  /// Motion words in tenths.
  static constexpr int kNone = -1, kTap = 331;

  void set_states(const Block& block, const std::string& line) {
    if (block.words.count('T') > 0) selected_ = static_cast<int>(block.words.at('T'));
    if (by_hand_) at_.tool = selected_;
    if (block.words.count('F') > 0) feed_ = block.words.at('F');
    if (block.words.count('S') > 0) speed_ = block.words.at('S');
    for (const int m : block.m) {
      if (m == 60) {
        at_.tool = selected_;
        at_.has_length = false;
        direction_ = 0;
      } else if (m == 30 || m == 40 || m == 50) {
        direction_ = m == 30 ? 1 : m == 40 ? -1 : 0;
      } else if (m == 20 || m == 300) {
        is_ended_ = true;
      } else if (m != 70 && m != 80 && m != 90 && m != 0 && m != 10) {
        throw std::runtime_error("an unknown word in: " + line);
      }
    }
    at_.turning = speed_ > 0 ? direction_ : 0;
  }

  /// Whether the numbers of the block mean no motion.
  bool set_motion(const Block& block, const std::string& line) {
    // Exact path, offsets, cancelled states and the plane: nothing of them moves the tip.
    static const std::set<int> kStill{170, 210, 400, 430, 490, 540, 610, 640, 900, 911, 940, 40};
    bool still = false;
    for (const int g : block.g) {
      if ((g >= 0 && g <= 30 && g % 10 == 0) || is_cycle(g) || g == kTap) {
        if (is_cycle(g) && !is_cycle(motion_)) initial_z_ = at_.z1;
        motion_ = g;
      } else if (g == 800) {
        motion_ = kNone;
      } else if (g == 980 || g == 990) {
        returns_high_ = g == 980;
      } else if (kStill.count(g) == 0) {
        throw std::runtime_error("an unknown word in: " + line);
      }
      if (g == 430 || g == 490) at_.has_length = g == 430;
      still = still || g == 430 || g == 40;
    }
    return still;
  }

  static double value(const std::map<char, double>& words, char letter, double otherwise) {
    const auto found = words.find(letter);
    return found == words.end() ? otherwise : found->second;
  }

  void go(bool rapid, double x, double y, double z) {
    TipWay way = at_;
    way.rapid = rapid;
    way.x0 = at_.x1, way.y0 = at_.y1, way.z0 = at_.z1;
    way.x1 = x, way.y1 = y, way.z1 = z;
    done.push_back(way);
    at_ = way;
  }

  void move(const std::map<char, double>& words) {
    const double x = value(words, 'X', at_.x1), y = value(words, 'Y', at_.y1), z = value(words, 'Z', at_.z1);
    if (motion_ < 20) {
      go(motion_ == 0, x, y, z);
      return;
    }
    TipWay way = at_;
    way.rapid = false;
    way.x0 = at_.x1, way.y0 = at_.y1, way.z0 = at_.z1;
    way.x1 = x, way.y1 = y, way.z1 = z;
    add_arc(way, way.x0 + value(words, 'I', 0), way.y0 + value(words, 'J', 0));
    at_ = way;
  }

  /// A cycle at its place: to R at the rapid, down to Z, and back.
  void run_cycle(const std::map<char, double>& words) {
    cycle_r_ = value(words, 'R', cycle_r_), cycle_z_ = value(words, 'Z', cycle_z_);
    peck_ = value(words, 'Q', peck_);
    const double x = value(words, 'X', at_.x1), y = value(words, 'Y', at_.y1);
    if (at_.z1 < cycle_r_) go(true, at_.x1, at_.y1, cycle_r_);
    go(true, x, y, at_.z1);
    go(true, x, y, cycle_r_);
    const bool pecks = (motion_ == 830 || motion_ == 730) && peck_ > 0;
    for (double z = cycle_r_; pecks && z - peck_ > cycle_z_; z -= peck_) {
      go(false, x, y, z - peck_);
      if (motion_ == 830) go(true, x, y, cycle_r_);
      if (motion_ == 830) go(true, x, y, z - peck_);
    }
    if (motion_ == 840 || motion_ == 740)
      at_.per_turn = speed_ > 0 ? (motion_ == 840 ? 1 : -1) * feed_ / speed_ : 0;
    go(false, x, y, cycle_z_);
    at_.per_turn = 0;
    const bool comes_at_feed = motion_ == 840 || motion_ == 740 || motion_ == 850;
    go(!comes_at_feed, x, y, cycle_r_);
    if (returns_high_ && initial_z_ > cycle_r_) go(true, x, y, initial_z_);
  }

  /// Down tied to the spindle, and back.
  void tap(const std::map<char, double>& words) {
    const double from = at_.z1;
    at_.per_turn = at_.turning * value(words, 'K', 0);
    go(false, value(words, 'X', at_.x1), value(words, 'Y', at_.y1), value(words, 'Z', at_.z1));
    at_.per_turn = 0;
    go(false, at_.x1, at_.y1, from);
  }

  void add_arc(const TipWay& arc, double cx, double cy) {
    const double radius = std::hypot(arc.x0 - cx, arc.y0 - cy), sense = motion_ == 30 ? 1 : -1;
    const double from = std::atan2(arc.y0 - cy, arc.x0 - cx), to = std::atan2(arc.y1 - cy, arc.x1 - cx);
    double sweep = sense * (to - from);
    while (sweep <= 1e-9) sweep += kTurn;
    const double share = std::clamp(1 - sagitta_ / std::max(radius, 1e-9), -1.0, 1.0);
    const int count = 1 + static_cast<int>(sweep / std::max(2 * std::acos(share), 1e-3));
    TipWay piece = arc;
    for (int i = 1; i <= count; ++i) {
      const double t = static_cast<double>(i) / count, angle = from + sense * sweep * t;
      piece.x1 = i == count ? arc.x1 : cx + radius * std::cos(angle);
      piece.y1 = i == count ? arc.y1 : cy + radius * std::sin(angle);
      piece.z1 = arc.z0 + (arc.z1 - arc.z0) * t;
      done.push_back(piece);
      piece.x0 = piece.x1, piece.y0 = piece.y1, piece.z0 = piece.z1;
    }
  }

  double sagitta_;
  bool by_hand_;
  TipWay at_{0, true, 0, 0, false, 0, 0, 0, 100, 0, 0, 100};  ///< its end: where the tip is
  int motion_ = 0, selected_ = 0, direction_ = 0;
  double feed_ = 0, speed_ = 0;
  double cycle_r_ = 0, cycle_z_ = 0, peck_ = 0, initial_z_ = 100;
  bool returns_high_ = true, is_ended_ = false;
};

}  // namespace

std::vector<TipWay> ways_of(const std::string& program, double sagitta) {
  std::vector<std::pair<Block, std::string>> blocks;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) blocks.emplace_back(block_of(line), line);
  const bool has_change = std::any_of(blocks.begin(), blocks.end(), [](const auto& one) {
    return std::find(one.first.m.begin(), one.first.m.end(), 60) != one.first.m.end();
  });
  Way way(sagitta, !has_change);
  for (const auto& [block, line] : blocks) way.take(block, line);
  return way.done;
}

}  // namespace clearcut::test_support
