#include "plan/adaptive/trace/walls.h"

#include <algorithm>
#include <cmath>

#include "base/tolerances.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// On the wall of a clearing area: the material that may stay, as a share of what the wall pass removes there
/// anyway.
constexpr double kWallShare = 0.25;

}  // namespace
Wall::Wall(Loop loop) : loop_(std::move(loop)) {
  double sum = 0;
  for (const Edge& edge : loop_) ends_.push_back(sum += edge.length());
}

Wall::Spot Wall::spot(double s) const {
  const double lap = std::floor(s / length()) * length();
  const double within = s - lap;
  const auto found = std::upper_bound(ends_.begin(), ends_.end(), within);
  const auto edge = std::min<std::size_t>(static_cast<std::size_t>(found - ends_.begin()), ends_.size() - 1);
  const double before = edge == 0 ? 0 : ends_[edge - 1];
  return {edge, std::clamp((within - before) / (ends_[edge] - before), 0.0, 1.0), lap};
}

Vec2 Wall::at(double s) const {
  const Spot place = spot(s);
  return loop_[place.edge].at(place.t);
}

Vec2 Wall::heading(double s) const {
  const Spot place = spot(s);
  return loop_[place.edge].tangent_at(place.t);
}

double Wall::edge_end(double s) const {
  const Spot place = spot(s);
  return place.lap + ends_[place.edge];
}

Path Wall::part(double s0, double s1) const {
  Path out;
  for (double s = s0; s1 - s > kSamePlaceMm;) {
    const Spot place = spot(s);
    const double begin = place.lap + (place.edge == 0 ? 0 : ends_[place.edge - 1]);
    const double end = place.lap + ends_[place.edge];
    const double until = std::min(end, s1), whole = end - begin;
    if (until - s > kSamePlaceMm) {
      const double t0 = (s - begin) / whole, t1 = (until - begin) / whole;
      out.push_back(t0 < 1e-9 && t1 > 1 - 1e-9 ? loop_[place.edge] : loop_[place.edge].part(t0, t1));
    }
    s = until + (until == end ? kSamePlaceMm * 1e-3 : 0);
  }
  return out;
}

Wall::Hit Wall::nearest(Vec2 p) const {
  Hit best{0, 1e300};
  for (std::size_t i = 0; i < loop_.size(); ++i) {
    const double far = distance(loop_[i], p);
    if (far >= best.distance) continue;
    const double before = i == 0 ? 0 : ends_[i - 1];
    best = {before + clearcut::nearest(loop_[i], p).t * (ends_[i] - before), far};
  }
  return best;
}

Walls::Walls(const Region& front, const Region& legal, double pitch, double residual) {
  add(front.outer(), legal, pitch, residual);
  for (const Loop& island : front.islands()) add(island, legal, pitch, residual);
}

void Walls::add(const Loop& loop, const Region& legal, double pitch, double residual) {
  walls_.emplace_back(loop);
  const double length = walls_.back().length();
  Marks marks;
  const int count = std::max(8, static_cast<int>(std::ceil(length / pitch)));
  marks.pitch = length / count;
  for (int i = 0; i < count; ++i) {
    marks.points.push_back(walls_.back().at(i * marks.pitch));
    marks.residuals.push_back(residual + kWallShare * legal.boundary_distance(marks.points.back()));
  }
  marks.touching.assign(marks.points.size(), 1);
  marks.touched.resize(marks.points.size());
  marks.left_at.assign(marks.points.size(), -1e300);
  marks_.push_back(std::move(marks));
}

std::size_t Walls::mark_at(const WallPlace& place) const {
  const Marks& marks = marks_[place.wall];
  const auto count = static_cast<long>(marks.points.size());
  return static_cast<std::size_t>((std::lround(place.s / marks.pitch) % count + count) % count);
}

double Walls::residual(const WallPlace& place) const {
  return marks_[place.wall].residuals[mark_at(place)];
}

double Walls::to_nearest(const std::vector<WallPlace>& others, const WallPlace& place, double sense,
                         double least) const {
  const double length = walls_[place.wall].length();
  double nearest = 1e300;
  for (const WallPlace& other : others) {
    if (other.wall != place.wall) continue;
    const double gap = sense * (other.s - place.s), around = gap - std::floor(gap / length) * length;
    if (around >= least) nearest = std::min(nearest, around);
  }
  return nearest;
}

bool Walls::touches_after(const WallPlace& place, double reach) const {
  const Marks& marks = marks_[place.wall];
  const std::size_t first = mark_at(place);
  const auto steps = static_cast<std::size_t>(reach / marks.pitch) + 1;
  for (std::size_t i = 0; i <= steps; ++i) {
    if (marks.touching[(first + i) % marks.touching.size()] == 1) return true;
  }
  return false;
}

WallPlace Walls::nearest(Vec2 p) const {
  WallPlace place;
  double least = 1e300;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const auto hit = walls_[w].nearest(p);
    if (hit.distance >= least) continue;
    least = hit.distance;
    place = {w, hit.s};
  }
  return place;
}

void Walls::update(const RemainingStock& remaining, const Box& where) {
  for (std::size_t w = 0; w < marks_.size(); ++w) {
    Marks& marks = marks_[w];
    for (std::size_t i = 0; i < marks.points.size(); ++i) {
      if (marks.touching[i] != 1 || !where.contains(marks.points[i])) continue;
      if (marks.touched[i] && !remaining.is_removed(*marks.touched[i])) continue;
      // Material outwards of the wall stands longest, because only a cutter at the mark removes it.
      const Vec2 outwards = -left_of(walls_[w].heading(static_cast<double>(i) * marks.pitch));
      marks.touched[i] = remaining.touched(marks.points[i], marks.residuals[i], outwards);
      marks.touching[i] = marks.touched[i] ? 1 : 0;
    }
  }
}

std::vector<WallPlace> Walls::starts() const {
  std::vector<WallPlace> places;
  for (std::size_t w = 0; w < marks_.size(); ++w) {
    const Marks& marks = marks_[w];
    for (std::size_t i = 0; i < marks.points.size(); ++i) {
      const std::size_t next = (i + 1) % marks.points.size();
      if (marks.touching[i] != 1 && marks.touching[next] == 1)
        places.push_back({w, static_cast<double>(i) * marks.pitch});
    }
  }
  return places;
}

double Wall::plainest() const {
  double s = 0, longest = 0, place = 0;
  for (const Edge& edge : loop_) {
    if (edge.length() > longest) {
      longest = edge.length();
      place = s + longest / 2;
    }
    s += edge.length();
  }
  return place;
}

std::vector<WallPlace> Walls::anywhere() const {
  std::vector<WallPlace> places;
  for (std::size_t w = 0; w < marks_.size(); ++w) {
    const auto& touching = marks_[w].touching;
    if (std::all_of(touching.begin(), touching.end(), [](char one) { return one == 1; }))
      places.push_back({w, walls_[w].plainest()});
  }
  return places;
}

bool Walls::is_start(const WallPlace& place) const {
  const Marks& marks = marks_[place.wall];
  const std::size_t i = mark_at(place);
  return marks.touching[(i + 1) % marks.points.size()] == 1;
}

bool Walls::advances(const WallPlace& start, double s, double least) {
  double& left_at = marks_[start.wall].left_at[mark_at(start)];
  const bool farther = s > left_at + least;
  left_at = std::max(left_at, s);
  return farther;
}

void Walls::give_up(const WallPlace& place, int count) {
  Marks& marks = marks_[place.wall];
  const std::size_t i = mark_at(place);
  for (int k = 1; k <= count; ++k) {
    const std::size_t mark = (i + static_cast<std::size_t>(k)) % marks.points.size();
    if (marks.touching[mark] == 0) return;
    marks.touching[mark] = 2;
    marks.left_at[mark] = std::max(marks.left_at[mark], marks.left_at[i]);
  }
}

void Walls::leave_out(const Around& around) {
  Marks& marks = marks_[around.place.wall];
  for (std::size_t i = 0; i < marks.points.size(); ++i) {
    const WallPlace mark{around.place.wall, static_cast<double>(i) * marks.pitch};
    if (to_nearest({around.place}, mark, 1) < around.before ||
        to_nearest({around.place}, mark, -1) < around.after)
      marks.touching[i] = 2;
  }
}

void Walls::leave_wedge(const WallPlace& place, double residual) {
  const double length = walls_[place.wall].edge_end(place.s) - place.s;
  Marks& marks = marks_[place.wall];
  for (std::size_t i = 0; i < marks.points.size(); ++i) {
    const double along = to_nearest({place}, {place.wall, static_cast<double>(i) * marks.pitch}, -1);
    if (along >= length) continue;
    marks.residuals[i] = std::max(marks.residuals[i], residual * (1 - along / length) + kWedge);
    marks.touched[i].reset();
  }
}

bool Walls::is_alone(const WallPlace& place, const std::vector<WallPlace>& places, double least) const {
  return to_nearest(places, place, 1, kSamePlaceMm) > least &&
         to_nearest(places, place, -1, kSamePlaceMm) > least;
}

namespace {

void add_unfinished(const Walls& walls, std::size_t index, double pitch, double gap,
                    const RemainingStock& remaining, std::vector<WallStretch>& out) {
  const Wall& wall = walls.wall(index);
  const int count = std::max(8, static_cast<int>(std::ceil(wall.length() / pitch)));
  const double step = wall.length() / count;
  // A corner may touch material where the samples beside it do not.
  std::vector<char> touches(static_cast<std::size_t>(count), 0);
  double end = 0;
  for (const Edge& edge : wall.loop()) {
    end += edge.length();
    if (remaining.touches(edge.to, ResidualLimits::kFinishedWall))
      touches[static_cast<std::size_t>(end / step) % touches.size()] = 1;
  }
  std::vector<int> touching;
  for (int i = 0; i < count; ++i) {
    if (touches[static_cast<std::size_t>(i)] ||
        remaining.touches(wall.at(i * step), ResidualLimits::kFinishedWall))
      touching.push_back(i);
  }
  if (touching.empty()) return;
  // The list begins after the widest gap. A wall that touches material all along is cut all round.
  std::size_t first = 0;
  int widest = 0;
  for (std::size_t k = 0; k < touching.size(); ++k) {
    const int before = k == 0 ? touching.back() - count : touching[k - 1];
    if (touching[k] - before <= widest) continue;
    widest = touching[k] - before;
    first = k;
  }
  double from = (touching[first] - 1) * step, to = from;
  if (widest * step < gap) return out.push_back({index, from, from + wall.length()});
  for (std::size_t k = 0; k < touching.size(); ++k) {
    const std::size_t at = (first + k) % touching.size();
    const double s = (touching[at] + (at < first ? count : 0)) * step;
    if (s - to > gap) {
      out.push_back({index, from, to});
      from = s - step;
    }
    to = s + step;
  }
  out.push_back({index, from, to});
}

}  // namespace

std::vector<WallStretch> unfinished_walls(const Walls& walls, double pitch, double gap,
                                          const RemainingStock& remaining) {
  std::vector<WallStretch> stretches;
  for (std::size_t i = 0; i < walls.count(); ++i) add_unfinished(walls, i, pitch, gap, remaining, stretches);
  return stretches;
}

std::optional<WallStretch> unfinished_part(const Walls& walls, const WallStretch& stretch, double pitch,
                                           double residual, const RemainingStock& remaining) {
  constexpr double kPlace = 1e-4;
  const Wall& wall = walls.wall(stretch.wall);
  std::vector<double> places{stretch.from};
  while (places.back() < stretch.to) {
    const double s = places.back();
    places.push_back(std::min({s + pitch, stretch.to, std::max(wall.edge_end(s), s + kPlace)}));
  }
  const auto touches = [&](double s) { return remaining.touches(wall.at(s), residual); };
  const auto border = [&](double clear, double touching) {
    while (std::abs(touching - clear) > kPlace)
      (touches((clear + touching) / 2) ? touching : clear) = (clear + touching) / 2;
    return clear;
  };
  const auto first = std::find_if(places.begin(), places.end(), touches);
  if (first == places.end()) return std::nullopt;
  const auto last = std::find_if(places.rbegin(), places.rend(), touches);
  return WallStretch{stretch.wall, first == places.begin() ? *first : border(*(first - 1), *first),
                     last == places.rbegin() ? *last : border(*(last - 1), *last)};
}

}  // namespace clearcut::plan::adaptive
