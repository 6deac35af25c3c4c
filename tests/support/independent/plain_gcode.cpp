#include "support/independent/plain_gcode.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

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

class Way {
 public:
  explicit Way(double sagitta) : sagitta_(sagitta) {}

  void take(const Block& block, const std::string& line) {
    ++at_.line;
    // Exact path, offsets, cancelled states and the plane: nothing of them moves the tip.
    static const std::set<int> kStill{170, 210, 400, 430, 490, 540, 610, 640, 800, 900, 911, 940, 40};
    if (block.words.count('T') > 0) at_.tool = static_cast<int>(block.words.at('T'));
    bool still = false;
    for (const int g : block.g) {
      if (g >= 0 && g <= 30 && g % 10 == 0) {
        motion_ = g / 10;
      } else if (kStill.count(g) == 0) {
        throw std::runtime_error("an unknown word in: " + line);
      }
      still = still || g == 430 || g == 40;
    }
    const auto has = [&](char letter) { return block.words.count(letter) > 0; };
    if (!still && (has('X') || has('Y') || has('Z') || has('I') || has('J'))) move(block.words);
  }

  std::vector<TipWay> done;

 private:
  void move(const std::map<char, double>& words) {
    const auto value = [&](char letter, double otherwise) {
      const auto found = words.find(letter);
      return found == words.end() ? otherwise : found->second;
    };
    TipWay way = at_;
    way.rapid = motion_ == 0;
    way.x0 = at_.x1, way.y0 = at_.y1, way.z0 = at_.z1;
    way.x1 = value('X', way.x0), way.y1 = value('Y', way.y0), way.z1 = value('Z', way.z0);
    if (motion_ < 2) {
      done.push_back(way);
    } else {
      add_arc(way, way.x0 + value('I', 0), way.y0 + value('J', 0));
    }
    at_ = way;
  }

  void add_arc(const TipWay& arc, double cx, double cy) {
    const double radius = std::hypot(arc.x0 - cx, arc.y0 - cy), sense = motion_ == 3 ? 1 : -1;
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
  TipWay at_{0, true, 0, 0, 0, 100, 0, 0, 100};  ///< its end: where the tip is
  int motion_ = 0;
};

}  // namespace

std::vector<TipWay> ways_of(const std::string& program, double sagitta) {
  Way way(sagitta);
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) way.take(block_of(line), line);
  return way.done;
}

}  // namespace clearcut::test_support
