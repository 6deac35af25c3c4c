#include "support/independent/claim_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/independent/plain_gcode.h"

namespace clearcut::test_support {
namespace {

constexpr double kChord = 1e-4;   // mm; arcs as chords
constexpr double kLevel = 0.002;  // mm above the floor up to which a move cuts it
constexpr double kLegal = 1e-4;   // mm; centers closer to their wall than that count as illegal

struct Stretch {
  Vec2 a, b;
};
Vec2 nearest_on(Vec2 p, const Stretch& s) {
  const Vec2 d = s.b - s.a;
  const double size = dot(d, d), t = size > 0 ? std::clamp(dot(p - s.a, d) / size, 0.0, 1.0) : 0;
  return s.a + t * d;
}
double distance_to(Vec2 p, const Stretch& s) {
  return norm(p - nearest_on(p, s));
}
struct Nearby {
  double distance = 0;
  Vec2 point;
};

/// Stretches sorted into square cells, for the distance of near ones.
class Cells {
 public:
  Cells(const std::vector<Stretch>& all, double side) : all_(all), side_(side) {
    Box around;
    for (const Stretch& s : all) around.add(s.a), around.add(s.b);
    low_ = around.min;
    if (!all.empty()) side_ = std::max(side, 1.01 * std::max(around.width(), around.height()) / kCells);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto [x0, y0] = cell({std::min(all[i].a.x, all[i].b.x), std::min(all[i].a.y, all[i].b.y)});
      const auto [x1, y1] = cell({std::max(all[i].a.x, all[i].b.x), std::max(all[i].a.y, all[i].b.y)});
      for (int x = x0; x <= x1; ++x)
        for (int y = y0; y <= y1; ++y) at(x, y).push_back(i);
    }
  }
  /// The nearest stretch, or a distance of `most` where none is nearer.
  Nearby nearest_stretch(Vec2 p, double most) const {
    const auto [column, row] = cell(p);
    Nearby best{most, p};
    const auto look = [&](int x, int y) {
      if (x < 0 || y < 0 || x >= kCells || y >= kCells) return;
      for (const std::size_t i : cells_[static_cast<std::size_t>(x * kCells + y)]) {
        const Vec2 on = nearest_on(p, all_[i]);
        if (const double far = norm(p - on); far < best.distance) best = {far, on};
      }
    };
    for (int ring = 0; (ring - 1) * side_ <= best.distance;
         ++ring)  // outwards, as far as a nearer one may be
      for (int k = -ring; k <= ring; ++k) {
        look(column + k, row - ring);
        if (ring > 0) look(column + k, row + ring);
        if (k == -ring || k == ring) continue;
        look(column - ring, row + k);
        look(column + ring, row + k);
      }
    return best;
  }
  double nearest(Vec2 p, double most) const { return nearest_stretch(p, most).distance; }

 private:
  static constexpr int kCells = 200;
  std::pair<int, int> cell(Vec2 p) const {
    const auto number = [&](double v) {
      return static_cast<int>(std::clamp(std::floor(v / side_), -1e6, 1e6));
    };
    return {number(p.x - low_.x), number(p.y - low_.y)};
  }
  std::vector<std::size_t>& at(int x, int y) {
    return cells_[static_cast<std::size_t>(std::clamp(x, 0, kCells - 1) * kCells +
                                           std::clamp(y, 0, kCells - 1))];
  }
  const std::vector<Stretch>& all_;
  double side_;
  Vec2 low_;
  std::vector<std::vector<std::size_t>> cells_{static_cast<std::size_t>(kCells) * kCells};
};

bool inside(const Regions& regions, Vec2 p) {
  return std::any_of(regions.begin(), regions.end(),
                     [&](const Region& region) { return region.contains(p); });
}
Vec2 turned(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Chords of all walls. Their sagitta is far below what is judged.
std::vector<Stretch> walls_of(const Regions& regions) {
  std::vector<Stretch> walls;
  for (const Region& region : regions)
    for (const Edge& edge : region.edges()) {
      std::vector<Vec2> points{edge.from};
      append_flattened(edge, kChord, points);
      for (std::size_t i = 1; i < points.size(); ++i) walls.push_back({points[i - 1], points[i]});
    }
  return walls;
}

class Judge {
 public:
  Judge(const Part& part, const std::string& program, double diameter)
      : part_(part),
        feature_(part.features.front()),
        radius_(diameter / 2),
        ways_(ways_of(program, kChord)),
        walls_(walls_of(feature_.allowed)),
        near_walls_(walls_, radius_ / 3) {
    for (const TipWay& way : ways_) {
      const double low = std::min(way.z0, way.z1), high = std::max(way.z0, way.z1);
      const double level = feature_.floor_z + kLevel;
      if (way.rapid || low > level) continue;
      const Vec2 a{way.x0, way.y0}, b{way.x1, way.y1};
      const Vec2 deep = way.z0 < way.z1 ? a : b, other = way.z0 < way.z1 ? b : a;
      const double share = high > level ? (level - low) / (high - low) : 1;
      floor_.push_back({deep, deep + share * (other - deep)});
    }
  }
  ClaimFaults faults(double off_height) const {
    const double as_programmed = rapid(0);
    return {uncut(), gouge(), as_programmed, off_height > 0 ? rapid(2 * off_height) : as_programmed};
  }

 private:
  Nearby wall_near(Vec2 p, double most) const { return near_walls_.nearest_stretch(p, most); }
  /// Whether a legal center is seen within the cutter's radius of q.
  bool reachable(Vec2 q) const {
    const double need = radius_ + kLegal;
    for (int i = 0; i < 25; ++i) {
      Vec2 c = q + (i == 0 ? 0.0 : i % 2 ? 0.6 : 0.99) * radius_ * turned(i * 0.5236);
      for (int step = 0; step < 10; ++step) {
        const Nearby wall = wall_near(c, need);
        if (wall.distance >= need) {
          if (inside(feature_.allowed, c)) return true;
          break;
        }
        const Vec2 off = c - wall.point;
        c = c + ((need - wall.distance + 1e-7) / std::max(wall.distance, 1e-9)) * off;
        const double far = norm(c - q);
        if (far > radius_) c = q + (radius_ / far) * (c - q);
      }
    }
    return false;
  }
  /// Places where more than 2 um are left, that can be reached, and the worst place near them.
  double uncut() const {
    if (floor_.empty()) return 1;
    const Box around = box(feature_.target);
    const Cells cells(floor_, radius_ / 3);
    const double step = std::max(radius_ / 8, std::max(around.width(), around.height()) / 150);
    const auto depth = [&](Vec2 q) { return cells.nearest(q, 1.5 * radius_) - radius_; };
    std::vector<std::pair<double, Vec2>> places;
    const auto climb = [&](Vec2 q, bool within) {  // uphill: crests between passes are narrow
      double d = depth(q);
      if (d < -step) return;
      for (double reach = step / 2; reach > 1e-3; reach /= 2)
        for (int k = 0; k < 6; ++k) {
          const Vec2 p = q + reach * turned(k * 1.0471976);
          if (const double there = depth(p); there > d) d = there, q = p;
        }
      if (d > 0.002 && (within || inside(feature_.target, q))) places.push_back({d, q});
    };
    for (double x = around.min.x; x <= around.max.x; x += step)
      for (double y = around.min.y; y <= around.max.y; y += step)
        if (depth({x, y}) > -step && inside(feature_.target, {x, y})) {
          climb({x, y}, false);
          places.push_back({depth({x, y}), {x, y}});
        }
    for (const Stretch& wall : walls_of(feature_.target))
      for (int i = 0, count = 1 + static_cast<int>(norm(wall.b - wall.a) / step); i < count; ++i) {
        const Vec2 p = wall.a + ((i + 0.5) / count) * (wall.b - wall.a);
        places.push_back({depth(p), p});
      }
    std::erase_if(places, [](const auto& place) { return place.first < 0.002; });
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Vec2> tried;
    for (const auto& [d, q] : places) {
      const Vec2 here = q;
      if (std::any_of(tried.begin(), tried.end(), [&](Vec2 p) { return norm(p - here) < step / 3; }))
        continue;
      if (tried.size() > 400) break;
      tried.push_back(q);
      if (reachable(q)) return d;
    }
    return places.empty() ? -1 : 0.002;
  }
  double gouge() const {
    double most = -1;
    for (const TipWay& way : ways_) {
      const double low = std::min(way.z0, way.z1);
      if (low >= feature_.top_z) continue;
      most = std::max(most, feature_.floor_z - low);
      const Vec2 a{way.x0, way.y0}, b{way.x1, way.y1};
      const int count = 1 + static_cast<int>(norm(b - a) / 0.05);
      for (int i = 0; i <= count; ++i) {
        const Vec2 p = a + (static_cast<double>(i) / count) * (b - a);
        const double far = wall_near(p, radius_ + 0.01).distance;
        most = std::max(most, radius_ - far);
        if (i % 16 == 0 && !inside(feature_.allowed, p)) most = std::max(most, radius_);
      }
    }
    return most;
  }
  /// Of rapids by feeds that are at least `below` mm lower.
  double rapid(double below) const {
    double most = -1;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      const TipWay& way = ways_[i];
      const double low = std::min(way.z0, way.z1);
      const Vec2 a{way.x0, way.y0}, b{way.x1, way.y1};
      if (!way.rapid || low >= feature_.top_z || (a == b && way.z1 >= way.z0)) continue;
      std::vector<Stretch> before;
      for (std::size_t k = 0; k < i; ++k)
        if (!ways_[k].rapid && std::max(ways_[k].z0, ways_[k].z1) <= low - below + 1e-9)
          before.push_back({{ways_[k].x0, ways_[k].y0}, {ways_[k].x1, ways_[k].y1}});
        else if (!ways_[k].rapid && std::min(ways_[k].z0, ways_[k].z1) <= low - below + 1e-9) {
          const bool first = ways_[k].z0 < ways_[k].z1;
          const Vec2 p{first ? ways_[k].x0 : ways_[k].x1, first ? ways_[k].y0 : ways_[k].y1};
          before.push_back({p, p});
        }
      const int count = 1 + static_cast<int>(norm(b - a) / (radius_ / 5));
      for (int t = 0; t <= count; ++t)
        for (int k = 0; k < 120; ++k)  // on the rim: how far in from there material reaches
          for (const double in : {0.01, 0.03, 0.1, 0.5}) {
            const Vec2 q = a + (static_cast<double>(t) / count) * (b - a) +
                           std::max(0.0, radius_ - in) * turned(k * 0.0523599);
            if (part_.stock && !part_.stock->plan.contains(q)) continue;
            double near = std::numeric_limits<double>::infinity();
            for (const Stretch& s : before) near = std::min(near, distance_to(q, s));
            if (near > radius_) most = std::max(most, in);
          }
    }
    return most;
  }

  const Part& part_;
  const Feature& feature_;
  double radius_;
  std::vector<TipWay> ways_;
  std::vector<Stretch> walls_, floor_;
  Cells near_walls_;
};

}  // namespace

std::map<int, double> sampled_engagement(const Part& part, const std::string& program, double diameter,
                                         double rim, double spacing, double degrees) {
  const std::vector<TipWay> ways = ways_of(program, 1e-5);
  const double radius = diameter / 2, top = part.features.front().top_z;
  std::map<int, double> most;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const TipWay& way = ways[i];
    const Vec2 a{way.x0, way.y0}, b{way.x1, way.y1};
    if (way.rapid || way.z0 != way.z1 || way.z0 >= top || a == b) continue;
    std::vector<Stretch> near;
    for (std::size_t k = 0; k < i; ++k) {
      const Stretch one{{ways[k].x0, ways[k].y0}, {ways[k].x1, ways[k].y1}};
      const double low = std::min(ways[k].z0, ways[k].z1), high = std::max(ways[k].z0, ways[k].z1);
      if (ways[k].rapid || ways[k].line == way.line || low > way.z0) continue;
      const Vec2 deep = ways[k].z0 < ways[k].z1 ? one.a : one.b,
                 other = ways[k].z0 < ways[k].z1 ? one.b : one.a;
      const double share = high > way.z0 ? (way.z0 - low) / (high - low) : 1;
      near.push_back({deep, deep + share * (other - deep)});
    }
    const int count = 1 + static_cast<int>(norm(b - a) / spacing);
    std::erase_if(
        near, [&](const Stretch& one) { return distance_to(0.5 * (a + b), one) > 2 * radius + norm(b - a); });
    for (int t = 0; t <= count; ++t) {
      const Vec2 p = a + (static_cast<double>(t) / count) * (b - a);
      double engaged = 0;
      for (double angle = -90 + degrees / 2; angle < 90; angle += degrees) {
        const Vec2 q = p + (radius - rim) * turned(angle_of(b - a) + angle * 0.017453292519943295);
        const bool air = part.stock && !part.stock->plan.contains(q);
        const bool is_cut = air || std::any_of(near.begin(), near.end(), [&](const Stretch& one) {
                              return distance_to(q, one) <= radius;
                            });
        engaged += is_cut ? 0 : degrees;
      }
      double& line = most[way.line];
      line = std::max(line, engaged);
    }
  }
  return most;
}

ClaimFaults judged(const Part& part, const std::string& program, double diameter, double off_height) {
  return Judge(part, program, diameter).faults(off_height);
}

}  // namespace clearcut::test_support
