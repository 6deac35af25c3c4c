// Material along a kerf, in heights computed only from the text of the program; and outlines for trying them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/random.h"
#include "base/units.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {

/// A straight stretch of a programmed path, mm.
struct Stroke {
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
  bool rapid = false;
};

/// The words of one block with motion: modal positions, and the arc's centre from its start.
struct Words {
  int code = 0;
  double x = 0, y = 0, z = 0, i = 0, j = 0;
};

inline void add_arc(const Words& from, const Words& to, std::vector<Stroke>& strokes) {
  const double cx = from.x + to.i, cy = from.y + to.j, r = base::hypot(to.i, to.j);
  const double a0 = base::atan2(from.y - cy, from.x - cx);
  double turn = base::atan2(to.y - cy, to.x - cx) - a0;
  if (to.code == 3 && turn <= 1e-9) turn += 2 * kPi;
  if (to.code == 2 && turn >= -1e-9) turn -= 2 * kPi;
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(turn) * r / 0.02)));
  for (int k = 0; k < count; ++k) {
    const auto at = [&](int n) { return a0 + turn * n / count; };
    const auto z = [&](int n) { return from.z + (to.z - from.z) * n / count; };
    strokes.push_back({cx + r * base::cos(at(k)), cy + r * base::sin(at(k)), z(k),
                       cx + r * base::cos(at(k + 1)), cy + r * base::sin(at(k + 1)), z(k + 1), false});
  }
}

/// The path of a program in words of G0 to G3 and X, Y, Z, I, J, read without the software's reader.
inline std::vector<Stroke> strokes_of(const std::string& program) {
  std::vector<Stroke> strokes;
  Words at{0, 0, 0, 1000};
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '(' || line[0] == 'M' || line[0] == 'T') continue;
    Words next = at;
    next.i = next.j = 0;
    bool moves = false;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      const double value = std::strtod(word.c_str() + 1, nullptr);
      if (word[0] == 'G' && value > 3) break;
      if (word[0] == 'G') next.code = static_cast<int>(value);
      if (word[0] == 'X') next.x = value;
      if (word[0] == 'Y') next.y = value;
      if (word[0] == 'Z') next.z = value;
      if (word[0] == 'I') next.i = value;
      if (word[0] == 'J') next.j = value;
      moves = moves || (word[0] >= 'X' && word[0] <= 'Z');
    }
    if (moves && next.code >= 2) add_arc(at, next, strokes);
    if (moves && next.code < 2) strokes.push_back({at.x, at.y, at.z, next.x, next.y, next.z, next.code == 0});
    at = next;
  }
  return strokes;
}

/// mm; depth of a flat cutter of radius r over a place: the lowest point over all strokes' cylinders.
inline double depth_at(Vec2 p, double r, const std::vector<Stroke>& strokes) {
  double low = std::numeric_limits<double>::infinity();
  for (const Stroke& s : strokes) {
    const double dx = s.x1 - s.x0, dy = s.y1 - s.y0, all = dx * dx + dy * dy;
    const double fx = s.x0 - p.x, fy = s.y0 - p.y;
    if (all < 1e-18) {
      if (fx * fx + fy * fy < r * r) low = std::min({low, s.z0, s.z1});
      continue;
    }
    const double b = (fx * dx + fy * dy) / all, c = (fx * fx + fy * fy - r * r) / all;
    if (b * b <= c) continue;
    const double t0 = std::max(0.0, -b - std::sqrt(b * b - c)), t1 = std::min(1.0, -b + std::sqrt(b * b - c));
    if (t0 < t1) low = std::min({low, s.z0 + (s.z1 - s.z0) * t0, s.z0 + (s.z1 - s.z0) * t1});
  }
  return low;
}

/// A tab found in the heights along one straight side.
struct Hill {
  double middle = 0;  ///< mm along the whole outline
  double foot = 0;    ///< mm
  double top = 0;
  double error = 0;  ///< mm; greatest deviation from a triangle
};

/// The middle of the kerf, along which hills are searched: its place, the cutter, the floor, and the slope of tabs.
struct Middle {
  double aside = 0;   ///< mm from the outline to the right: the kerf's middle
  double radius = 0;  ///< mm; radius of the cutter
  double floor = 0;
  double steepness = 0;  ///< slope of the sides of tabs; 0: vertical
};

/// The material along the middle of the kerf beside one side; `before`: mm of outline before the side.
inline std::vector<Hill> hills_beside(Vec2 from, Vec2 to, double before, const Middle& middle,
                                      const std::vector<Stroke>& strokes) {
  constexpr double kStep = 0.05;
  const double all = base::hypot(to.x - from.x, to.y - from.y);
  const Vec2 way{(to.x - from.x) / all, (to.y - from.y) / all}, out{way.y, -way.x};
  std::vector<Hill> hills;
  std::vector<std::pair<double, double>> run;
  const auto finish = [&] {
    if (run.size() > 2) {
      Hill hill{before + (run.front().first + run.back().first) / 2, run.back().first - run.front().first};
      for (const auto& [s, z] : run) hill.top = std::max(hill.top, z - middle.floor);
      for (const auto& [s, z] : run) {
        const double ideal = hill.top - middle.steepness * std::abs(before + s - hill.middle);
        hill.error = std::max(hill.error, std::abs(std::max(0.0, ideal) - (z - middle.floor)));
      }
      hills.push_back(hill);
    }
    run.clear();
  };
  for (double s = 0; s <= all; s += kStep) {
    const Vec2 p{from.x + way.x * s + out.x * middle.aside, from.y + way.y * s + out.y * middle.aside};
    const double z = depth_at(p, middle.radius, strokes);
    // The cutter goes round outward corners: beside them it never covered the place.
    if (std::isfinite(z) && z > middle.floor + 0.012)
      run.emplace_back(s, z);
    else
      finish();
  }
  finish();
  return hills;
}

inline std::vector<Vec2> random_outline(Random& random) {
  std::vector<Vec2> points;
  const int count = 3 + static_cast<int>(random.between(0, 4.99));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * (i + random.between(-0.2, 0.2)) / count, r = random.between(25, 45);
    points.push_back(
        {std::round(100 * r * base::cos(angle)) / 100, std::round(100 * r * base::sin(angle)) / 100});
  }
  return points;
}

inline std::string outline_of(const std::string& layer, const std::vector<Vec2>& points) {
  std::vector<BulgeVertex> vertices;
  for (const Vec2 p : points) vertices.push_back({p, 0});
  return outline(layer, vertices);
}

/// mm of the outline before each corner, and its whole length.
inline std::vector<double> starts_of(const std::vector<Vec2>& points) {
  std::vector<double> starts{0};
  for (std::size_t i = 0; i < points.size(); ++i)
    starts.push_back(starts.back() + distance(points[i], points[(i + 1) % points.size()]));
  return starts;
}

/// The hills around an outline, in the order of the outline.
inline std::vector<Hill> hills_around(const std::vector<Vec2>& points, const Middle& middle,
                                      const std::string& program) {
  const std::vector<Stroke> strokes = strokes_of(program);
  const std::vector<double> starts = starts_of(points);
  std::vector<Hill> hills;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 to = points[(i + 1) % points.size()];
    for (const Hill& hill : hills_beside(points[i], to, starts[i], middle, strokes)) hills.push_back(hill);
  }
  return hills;
}

}  // namespace clearcut::pipeline
