// The canonical calls of LinuxCNC's interpreter, block by block, beside the moves of a toolpath.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <vector>

#include "base/units.h"
#include "support/random/random_programs.h"

namespace clearcut::test_support {
namespace {

using Point = std::array<double, 3>;

double distance_of(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A piece of motion at constant speed: a line, or an arc about `center` in the plane of two axes.
struct Piece {
  bool rapid = false;
  Point from{}, to{};
  bool arc = false;
  std::size_t first = 0, second = 1, across = 2;
  double center[2]{};
  double sweep = 0;  ///< radians, > 0 from the first axis to the second

  double length() const {
    if (!arc) return distance_of(from, to);
    const double radius = std::hypot(from[first] - center[0], from[second] - center[1]);
    return std::hypot(radius * sweep, to[across] - from[across]);
  }
  Point at(double t) const {
    Point p{};
    if (!arc) {
      for (std::size_t k = 0; k < 3; ++k) p[k] = std::lerp(from[k], to[k], t);
      return p;
    }
    const double x = from[first] - center[0], y = from[second] - center[1];
    const double end = std::hypot(to[first] - center[0], to[second] - center[1]);
    const double scale = std::lerp(1.0, end / std::hypot(x, y), t), angle = sweep * t;
    p[first] = center[0] + scale * (x * std::cos(angle) - y * std::sin(angle));
    p[second] = center[1] + scale * (x * std::sin(angle) + y * std::cos(angle));
    p[across] = std::lerp(from[across], to[across], t);
    return p;
  }
};

using Pieces = std::map<int, std::vector<Piece>>;  // by line

double sweep_of(const Piece& piece, int turns) {
  const double a =
      std::atan2(piece.from[piece.second] - piece.center[1], piece.from[piece.first] - piece.center[0]);
  const double b =
      std::atan2(piece.to[piece.second] - piece.center[1], piece.to[piece.first] - piece.center[0]);
  const double side = turns > 0 ? 1 : -1;
  double angle = side * (b - a);
  while (angle <= 1e-4) angle += 2 * kPi;
  while (angle > 2 * kPi + 1e-4) angle -= 2 * kPi;
  return side * (angle + 2 * kPi * (std::abs(turns) - 1));
}

class CanonPieces {
 public:
  Pieces read(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const auto mark = line.find('N');
      if (mark == std::string::npos) continue;
      const auto name = line.find_first_not_of(' ', line.find(' ', mark));
      const int number = std::atoi(line.c_str() + mark + 1);
      if (name != std::string::npos) call(number, line.substr(name));
    }
    return std::move(pieces_);
  }

 private:
  void call(int line, const std::string& text) {
    Point p{};
    int system = 0;
    if (text.rfind("USE_LENGTH_UNITS", 0) == 0) {
      unit_ = text.find("INCH") != std::string::npos ? 25.4 : 1;
    } else if (std::sscanf(text.c_str(), "SET_G92_OFFSET(%lf, %lf, %lf", &p[0], &p[1], &p[2]) == 3) {
      local_ = scaled(p);
    } else if (std::sscanf(text.c_str(), "SET_G5X_OFFSET(%d, %lf, %lf, %lf", &system, &p[0], &p[1], &p[2]) ==
               4) {
      origin_ = scaled(p);
    } else if (std::sscanf(text.c_str(), "USE_TOOL_LENGTH_OFFSET(%lf %lf %lf", &p[0], &p[1], &p[2]) == 3) {
      length_ = scaled(p);
    } else if (text.rfind("SELECT_PLANE", 0) == 0) {
      const bool xz = text.find("XZ") != std::string::npos, yz = text.find("YZ") != std::string::npos;
      plane_ = xz   ? std::array<std::size_t, 3>{2, 0, 1}
               : yz ? std::array<std::size_t, 3>{1, 2, 0}
                    : std::array<std::size_t, 3>{0, 1, 2};
    } else {
      motion(line, text);
    }
  }

  void motion(int line, const std::string& text) {
    Point p{};
    double a = 0, b = 0, c = 0, d = 0, e = 0;
    int turns = 0;
    Piece piece;
    piece.from = at_;
    if (std::sscanf(text.c_str(), "STRAIGHT_TRAVERSE(%lf, %lf, %lf", &p[0], &p[1], &p[2]) == 3) {
      piece.rapid = true;
    } else if (std::sscanf(text.c_str(), "ARC_FEED(%lf, %lf, %lf, %lf, %d, %lf", &a, &b, &c, &d, &turns,
                           &e) == 6) {
      piece.arc = true;
      std::tie(piece.first, piece.second, piece.across) = std::tuple(plane_[0], plane_[1], plane_[2]);
      p[piece.first] = a;
      p[piece.second] = b;
      p[piece.across] = e;
      Point middle{};
      middle[piece.first] = c;
      middle[piece.second] = d;
      middle = placed(middle);
      piece.center[0] = middle[piece.first];
      piece.center[1] = middle[piece.second];
    } else if (std::sscanf(text.c_str(), "STRAIGHT_FEED(%lf, %lf, %lf", &p[0], &p[1], &p[2]) != 3) {
      return;
    }
    piece.to = at_ = placed(p);
    if (piece.arc) piece.sweep = sweep_of(piece, turns);
    pieces_[line].push_back(piece);
  }

  Point scaled(Point p) const {
    for (double& value : p) value *= unit_;
    return p;
  }
  Point placed(Point p) const {
    for (std::size_t k = 0; k < 3; ++k) p[k] = p[k] * unit_ + local_[k] + origin_[k] + length_[k];
    return p;
  }

  Pieces pieces_;
  Point at_{}, local_{}, origin_{}, length_{};
  std::array<std::size_t, 3> plane_{0, 1, 2};
  double unit_ = 1;
};

Pieces pieces_of(const Toolpath& toolpath) {
  Pieces pieces;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      Piece piece;
      piece.rapid = is_rapid(move.kind);
      piece.from = {move.path.from.x, move.path.from.y, move.z_from};
      piece.to = {move.path.to.x, move.path.to.y, move.z_to};
      if (move.path.is_arc()) {
        piece.arc = true;
        piece.center[0] = move.path.center.x;
        piece.center[1] = move.path.center.y;
        piece.sweep = sweep_of(piece, move.path.turn == Turn::kCounterClockwise ? 1 : -1);
      }
      pieces[move.line].push_back(piece);
    }
  }
  return pieces;
}

std::string shown(const Point& p) {
  return fmt::format("({:.4f} {:.4f} {:.4f})", p[0], p[1], p[2]);
}

/// A place on a run of pieces, by length from its beginning.
Point place_on(const std::vector<Piece>& run, double length) {
  for (const Piece& piece : run) {
    const double own = piece.length();
    if (length <= own) return piece.at(own > 0 ? length / own : 1);
    length -= own;
  }
  return run.back().to;
}

double length_of(const std::vector<Piece>& run) {
  double sum = 0;
  for (const Piece& piece : run) sum += piece.length();
  return sum;
}

/// `wanted` beside as many of `ours`, from `next` on, as are as long.
std::string compare(const Piece& wanted, const std::vector<Piece>& ours, std::size_t& next,
                    double tolerance) {
  std::vector<Piece> run;
  const double length = wanted.length();
  while (next < ours.size() && (run.empty() || length_of(run) < length - 4 * tolerance))
    run.push_back(ours[next++]);
  if (run.empty()) return "no move to " + shown(wanted.to);
  if (run.front().rapid != wanted.rapid) return "other kind of move to " + shown(wanted.to);
  for (int k = 0; k <= 16; ++k) {
    const double t = k / 16.0;
    const Point p = wanted.at(t), q = place_on(run, t * length_of(run));
    if (distance_of(p, q) > 4 * tolerance) return shown(q) + " instead of " + shown(p);
  }
  const double end = distance_of(run.back().to, wanted.to);
  return end > tolerance ? "ends at " + shown(run.back().to) + " instead of " + shown(wanted.to) : "";
}

}  // namespace

std::string difference_of_motion(const std::string& canon, const Toolpath& toolpath, double tolerance) {
  const Pieces wanted = CanonPieces().read(canon);
  Pieces ours = pieces_of(toolpath);
  for (const auto& [line, pieces] : wanted) {
    std::size_t next = 0;
    const std::vector<Piece>& own = ours[line];
    for (const Piece& piece : pieces) {
      if (piece.length() < 2 * tolerance) {
        // Moves of no length are left out by the reader; those that are just that short may be there.
        if (next < own.size() && own[next].length() < 3 * tolerance) ++next;
        continue;
      }
      const std::string found = compare(piece, own, next, tolerance);
      if (!found.empty()) return fmt::format("line {}: {}", line, found);
    }
    if (next < own.size()) return fmt::format("line {}: a move too many, to {}", line, shown(own[next].to));
    ours.erase(line);
  }
  for (const auto& [line, pieces] : ours) {
    if (!pieces.empty()) return fmt::format("line {}: a move that the interpreter does not make", line);
  }
  return "";
}

}  // namespace clearcut::test_support
