#include "plan/cover/shortening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/progress.h"
#include "base/units.h"

namespace clearcut::plan::cover {
namespace {

/// In radii: least saving of a change to count.
constexpr double kLeastGain = 1e-7;
/// Steps of corners begin with this share of the radius.
constexpr double kFirstStep = 0.4;
constexpr int kDirections = 6;
/// A change that lengthens the path by more radii than this before pulling it taut is undone at once.
constexpr double kWorthPulling = 0.35;
/// The same after its corners were pulled once.
constexpr double kWorthPullingOn = 0.1;
/// Number of nearest places of the path from which a path round walls is searched.
constexpr std::size_t kPlacesAsked = 30;
/// Least number of steps counted for a change, so that searches of tiny areas end.
constexpr std::uint64_t kLeastWork = 200;
/// Points are cleared by the cheapest insertions up to this multiple of their number; then by detours there and back,
/// after which no point is uncleared.
constexpr std::size_t kInsertionsPerPoint = 2, kInsertionsAtLeast = 100;
/// Up to this many points are cleared all together; more are cleared by squares with this side, in radii.
constexpr std::size_t kClearedTogether = 3000;
constexpr double kSquareCleared = 8;
/// Between walls, moves farther away than this many radii get no detour to a point: the path round the walls is searched.
constexpr double kFarthestInsertion = 12;
/// Steps counted for a check against the walls, and for a search for a path round them.
constexpr std::uint64_t kCheckWork = 4, kBendsWork = 400;
/// Share of the squared radius by which a point of the rim may be farther than the radius: dividing a move moves it by
/// rounding.
constexpr double kRimRounding = 1e-9;
/// A path has at least so many corners.
constexpr int kFewestCorners = 3;

/// Whether p is within the radius of the move from a to b; r2: the radius squared.
inline bool clears(Vec2 a, Vec2 b, Vec2 p, double r2) {
  const Vec2 along = b - a, to = p - a;
  const double t = dot(to, along);
  if (t <= 0) return norm_squared(to) <= r2;
  const double whole = norm_squared(along);
  if (t >= whole) return norm_squared(p - b) <= r2;
  const double aside = cross(along, to);
  return aside * aside <= r2 * whole;
}

}  // namespace

bool Shortening::may_move(Vec2 a, Vec2 b) {
  if (!limits_.may_move) return true;
  work_ += kCheckWork;
  return limits_.may_move(a, b);
}

Corner Shortening::random_corner() {
  for (;;) {
    const auto c = static_cast<Corner>(random_.below(static_cast<std::uint64_t>(path_.index_limit())));
    if (path_.is_alive(c) && !path_.is_nowhere(c)) return c;
  }
}

/// Whether a line through the points clears all needed points. An uncleared point is tested first the next time.
bool Shortening::all_cleared(const Vec2* line, int points) {
  const double r2 = witnesses_.radius() * witnesses_.radius();
  for (std::size_t i = 0; i < needed_.size(); ++i) {
    const Vec2 p = needed_[i];
    bool cleared = points == 1 && norm_squared(p - line[0]) <= r2;
    for (int k = 0; k + 1 < points && !cleared; ++k) cleared = clears(line[k], line[k + 1], p, r2);
    if (cleared) continue;
    if (i > 0) std::swap(needed_[i], needed_[i / 2]);
    work_ += i / 8 + 1;
    return false;
  }
  work_ += needed_.size() / 8 + 1;
  return true;
}

double Shortening::cost_of(Vec2 q, Corner a, Corner b) const {
  const double before = path_.is_nowhere(a) ? 0 : distance(path_.at(a), q);
  const double after = path_.is_nowhere(b) ? 0 : distance(q, path_.at(b));
  return before + after - path_.move_length(a, b);
}

Shortening::Insertion Shortening::cheapest(Vec2 bare) {
  Insertion best;
  const double radius = witnesses_.radius();
  const double depth = radius * (1 - 1e-9);
  const double share = 1 - margin_;
  const auto consider = [&](Corner a, Corner b) {
    ++work_;
    const Vec2 foot = path_.is_nowhere(a)   ? path_.at(b)
                      : path_.is_nowhere(b) ? path_.at(a)
                      : path_.at(a) == path_.at(b)
                          ? path_.at(a)
                          : nearest_point(Edge::line(path_.at(a), path_.at(b)), bare);
    const double away = distance(foot, bare);
    const Vec2 q = away <= depth ? foot : bare + (foot - bare) * (share * depth / away);
    const double cost = cost_of(q, a, b);
    if (best.after >= 0 && cost >= best.cost) return;
    if (limits_.may_move && ((!path_.is_nowhere(a) && !may_move(path_.at(a), q)) ||
                             (!path_.is_nowhere(b) && !may_move(q, path_.at(b)))))
      return;
    best = {a, q, cost};
  };
  for (double reach = 1.5 * radius;; reach *= 2) {
    best.after = -1;
    path_.for_moves_near(bare, reach, consider);
    if (best.after >= 0 || reach > path_.extent()) break;
    if (limits_.may_move && reach > kFarthestInsertion * radius) break;
  }
  if (!path_.closed()) {
    const Corner first = path_.next(CoverPath::kNowhere), last = path_.previous(CoverPath::kNowhere);
    if (!is_fixed(first)) consider(CoverPath::kNowhere, first);
    consider(last, CoverPath::kNowhere);
  }
  return best;
}

bool Shortening::clear(std::vector<Vec2> bare) {
  if (bare.size() <= kClearedTogether) return clear_together(std::move(bare));
  std::map<std::pair<long, long>, std::vector<Vec2>> squares;
  const double side = kSquareCleared * witnesses_.radius();
  for (const Vec2 p : bare) squares[{std::lround(p.y / side), std::lround(p.x / side)}].push_back(p);
  for (auto& [place, points] : squares) {
    // Detours of other squares may have cleared some.
    std::erase_if(points, [&](Vec2 p) { return path_.moves_within(p, witnesses_.radius()) > 0; });
    work_ += points.size();
    if (!clear_together(std::move(points))) return false;
  }
  return true;
}

bool Shortening::clear_together(std::vector<Vec2> bare) {
  std::vector<Vec2> uncovered;
  const std::size_t most = kInsertionsAtLeast + kInsertionsPerPoint * bare.size();
  std::size_t insertions = 0;
  while (!bare.empty()) {
    throw_if_cancelled(limits_.cancel);
    if (++insertions > most) {
      if (insertions > 2 * most || !visit_around(bare.back(), bare)) return false;
      continue;
    }
    const int asked = 1 + static_cast<int>(random_.below(4));
    Insertion chosen;
    bool around = false;
    for (int i = 0; i < asked && !around; ++i) {
      const Vec2 p = bare[random_.below(bare.size())];
      const Insertion insertion = cheapest(p);
      if (insertion.after < 0) {
        if (!visit_around(p, bare)) return false;
        around = true;
      } else if (chosen.after < 0 || insertion.cost > chosen.cost) {
        chosen = insertion;
      }
    }
    if (around) continue;
    uncovered.clear();
    const Corner next = path_.next(chosen.after);
    insert_detour(chosen.after, chosen.at, uncovered);
    const std::size_t before = bare.size();
    work_ += (before + uncovered.size()) / 8;
    remove_cleared(chosen.after, next, bare);
    // Rounding: the requested point is on the rim.
    if (bare.size() >= before && uncovered.empty()) bare.erase(bare.begin());
    bare.insert(bare.end(), uncovered.begin(), uncovered.end());
  }
  return true;
}

/// Removes the points that the moves from one corner to a later one clear.
void Shortening::remove_cleared(Corner from, Corner to, std::vector<Vec2>& points) const {
  const double r2 = witnesses_.radius() * witnesses_.radius() * (1 + kRimRounding);
  for (Corner c = from; c != to; c = path_.next(c)) {
    const Corner next = path_.next(c);
    if (path_.is_nowhere(c) || path_.is_nowhere(next)) continue;
    std::erase_if(points, [&](Vec2 p) { return clears(path_.at(c), path_.at(next), p, r2); });
  }
}

/// Inserts a corner at p into the move after a corner; `uncovered` are then the points that no move clears any more. If
/// there are any and detours go to and fro, the move stays, and the detour goes from its nearest place to p and back.
void Shortening::insert_detour(Corner after, Vec2 p, std::vector<Vec2>& uncovered) {
  const Corner next = path_.next(after);
  const std::size_t mark = path_.mark();
  path_.insert_after(after, p, uncovered);
  remove_cleared(after, next, uncovered);
  if (!to_and_fro_ || uncovered.empty() || path_.is_nowhere(after) || path_.is_nowhere(next)) return;
  const Vec2 from = path_.at(after), to = path_.at(next);
  const Vec2 foot = from == to ? from : nearest_point(Edge::line(from, to), p);
  if (!may_move(foot, p) || !may_move(p, foot)) return;
  path_.undo(mark);
  uncovered.clear();
  const Corner first = path_.insert_after(after, foot, uncovered);
  path_.insert_after(path_.insert_after(first, p, uncovered), foot, uncovered);
  remove_cleared(after, next, uncovered);
}

/// The nearest places on moves to p, the nearest first; at most kPlacesAsked.
std::vector<Shortening::PlaceOnMove> Shortening::places_near(Vec2 p) {
  std::vector<PlaceOnMove> places;
  for (double reach = 2 * witnesses_.radius();; reach *= 2) {
    places.clear();
    path_.for_moves_near(p, reach, [&](Corner a, Corner b) {
      ++work_;
      const Vec2 from = path_.at(a), to = path_.at(b);
      const Vec2 foot = from == to ? from : nearest_point(Edge::line(from, to), p);
      places.push_back({distance(foot, p), a, foot});
    });
    if (!places.empty() || reach > path_.extent()) break;
  }
  const auto is_before = [](const PlaceOnMove& a, const PlaceOnMove& b) {
    return std::pair(a.away, a.after) < std::pair(b.away, b.after);
  };
  std::sort(places.begin(), places.end(), is_before);
  const auto is_same = [](const PlaceOnMove& a, const PlaceOnMove& b) { return a.after == b.after; };
  places.erase(std::unique(places.begin(), places.end(), is_same), places.end());
  if (places.size() > kPlacesAsked) places.resize(kPlacesAsked);
  return places;
}

/// Adds a detour to p and back around obstacles, from the nearest place of the path with a path to p: no point is
/// uncleared by it. Removes the points thus cleared from `bare`. False if there is no such place.
bool Shortening::visit_around(Vec2 p, std::vector<Vec2>& bare) {
  for (const PlaceOnMove& place : places_near(p)) {
    if (limits_.bends) work_ += kBendsWork;
    const auto bends = limits_.bends ? limits_.bends(place.at, p) : std::vector<Vec2>{};
    if (!bends) continue;
    std::vector<Vec2> line{place.at};
    line.insert(line.end(), bends->begin(), bends->end());
    line.push_back(p);
    line.insert(line.end(), bends->rbegin(), bends->rend());
    line.push_back(place.at);
    Corner at = place.after;
    const Corner next = path_.next(at);
    for (const Vec2 point : line) at = path_.insert_after(at, point, bare);
    remove_cleared(place.after, next, bare);
    std::erase(bare, p);
    return true;
  }
  return false;
}

bool Shortening::pull_corner(Corner c, double finest) {
  const Corner a = path_.previous(c), b = path_.next(c);
  const bool has_a = !path_.is_nowhere(a), has_b = !path_.is_nowhere(b);
  if (a == b) return false;
  const double radius = witnesses_.radius();
  const Vec2 was = path_.at(c);
  needed_.clear();
  const Vec2 from = path_.at(a), to = path_.at(b);
  witnesses_.only_cleared_by(has_a ? &from : nullptr, was, has_b ? &to : nullptr, needed_);
  const auto line_through = [&](Vec2 p, std::array<Vec2, 5>& line) {
    int n = 0;
    if (has_a) line[static_cast<std::size_t>(n++)] = path_.at(a);
    line[static_cast<std::size_t>(n++)] = p;
    if (has_b) line[static_cast<std::size_t>(n++)] = path_.at(b);
    return n;
  };
  const auto length_through = [&](Vec2 p) {
    return (has_a ? distance(path_.at(a), p) : 0) + (has_b ? distance(p, path_.at(b)) : 0);
  };
  std::array<Vec2, 5> line{};
  const auto is_legal = [&](Vec2 p) {
    return !limits_.may_move ||
           ((!has_a || may_move(path_.at(a), p)) && (!has_b || may_move(p, path_.at(b))));
  };
  // Without the corner.
  if (path_.corners() > kFewestCorners) {
    int n = 0;
    if (has_a) line[static_cast<std::size_t>(n++)] = path_.at(a);
    if (has_b) line[static_cast<std::size_t>(n++)] = path_.at(b);
    if ((n < 2 || may_move(line[0], line[1])) && all_cleared(line.data(), n)) {
      std::vector<Vec2> none;
      path_.erase(c, none);
      return true;
    }
  }
  Vec2 at = was;
  double best = length_through(at);
  const double first_length = best;
  for (double step = kFirstStep * radius; step >= finest; step *= 0.5) {
    const double turn = random_.unit() * 2 * kPi / kDirections;
    for (int k = 0; k < kDirections;) {
      const Vec2 p = at + step * direction_of(turn + 2 * kPi * k / kDirections);
      ++k;
      const double length = length_through(p);
      ++work_;
      if (length >= best - kLeastGain * radius) continue;
      if (!all_cleared(line.data(), line_through(p, line)) || !is_legal(p)) continue;
      at = p;
      best = length;
      k = 0;
    }
  }
  if (at == was) return cut_corner(c, finest);
  move_corner(c, at);
  return best < first_length - 1e-3 * finest;
}

void Shortening::move_corner(Corner c, Vec2 p) {
  std::vector<Vec2> none;
  path_.lift(c, c, none);
  path_.place(c, p);
  path_.lay(c, c);
}

/// Cuts a corner short between two places beside it, which become corners, so that the rest of its moves is
/// unchanged. Uses the points found by pull_corner that its moves must clear.
bool Shortening::cut_corner(Corner c, double finest) {
  const Corner a = path_.previous(c), b = path_.next(c);
  if (a == b || path_.is_nowhere(a) || path_.is_nowhere(b)) return false;
  const double radius = witnesses_.radius();
  const Vec2 was = path_.at(c), from = path_.at(a), to = path_.at(b);
  const double in = distance(from, was), out = distance(was, to);
  if (in < 2 * finest || out < 2 * finest) return false;
  const auto stub = [&](double length) {
    const double reach = random_.between(0.1, 1.2) * radius;
    return reach > 0.8 * length ? 1.0 : reach / length;
  };
  const double share_in = stub(in), share_out = stub(out);
  const Vec2 before = lerp(was, from, share_in), after = lerp(was, to, share_out);
  if (share_in >= 1 && share_out >= 1) return false;
  std::array<Vec2, 5> line{from, before, was, after, to};
  const double first_length = distance(before, was) + distance(was, after);
  double best = first_length;
  Vec2 at = was;
  for (double step = kFirstStep * radius; step >= finest; step *= 0.5) {
    const double turn = random_.unit() * 2 * kPi / kDirections;
    for (int k = 0; k < kDirections;) {
      const Vec2 p = at + step * direction_of(turn + 2 * kPi * k / kDirections);
      ++k;
      const double length = distance(before, p) + distance(p, after);
      ++work_;
      if (length >= best - limits_.corner_price) continue;
      line[2] = p;
      if (!all_cleared(line.data(), 5)) continue;
      if (!(may_move(before, p) && may_move(p, after))) continue;
      at = p;
      best = length;
      k = 0;
    }
  }
  const bool shorter = best < first_length - 2 * limits_.corner_price;
  if (!shorter) return false;
  move_corner(c, at);
  // One move becomes two moves on the same line: together they clear the same points.
  std::vector<Vec2> bare;
  if (share_in < 1) path_.insert_after(a, before, bare);
  if (share_out < 1) path_.insert_after(c, after, bare);
  return true;
}

/// Moves both ends of the move beginning at c.
bool Shortening::pull_move(Corner c, double finest) {
  const Corner d = path_.next(c);
  if (is_fixed(c) || is_fixed(d)) return false;
  const Corner a = path_.previous(c), b = path_.next(d);
  if (a == d || a == b) return false;
  const bool has_a = !path_.is_nowhere(a), has_b = !path_.is_nowhere(b);
  const double radius = witnesses_.radius();
  needed_.clear();
  path_.lift(c, d, needed_);
  Vec2 p = path_.at(c), q = path_.at(d);
  const Vec2 was_p = p, was_q = q;
  const auto length_through = [&](Vec2 x, Vec2 y) {
    return (has_a ? distance(path_.at(a), x) : 0) + distance(x, y) + (has_b ? distance(y, path_.at(b)) : 0);
  };
  std::array<Vec2, 4> line{};
  const auto works = [&](Vec2 x, Vec2 y) {
    int n = 0;
    if (has_a) line[static_cast<std::size_t>(n++)] = path_.at(a);
    line[static_cast<std::size_t>(n++)] = x;
    line[static_cast<std::size_t>(n++)] = y;
    if (has_b) line[static_cast<std::size_t>(n++)] = path_.at(b);
    if (!all_cleared(line.data(), n)) return false;
    if (!limits_.may_move) return true;
    for (int i = 0; i + 1 < n; ++i)
      if (!may_move(line[static_cast<std::size_t>(i)], line[static_cast<std::size_t>(i) + 1])) return false;
    return true;
  };
  double best = length_through(p, q);
  const double first_length = best;
  if (path_.corners() > kFewestCorners) {
    // One corner instead of two.
    for (const double t : {0.5, 0.25, 0.75, 0.0, 1.0}) {
      const Vec2 middle = lerp(p, q, t);
      for (const double out : {0.0, 0.1, 0.3}) {
        const Vec2 x =
            middle + out * ((middle - path_.at(has_a ? a : c)) + (middle - path_.at(has_b ? b : d)));
        if (length_through(x, x) > best + limits_.corner_price || !works(x, x)) continue;
        if (x != was_p) path_.place(c, x);
        path_.lay(c, d);
        std::vector<Vec2> none;
        path_.erase(d, none);
        return true;
      }
    }
  }
  for (double step = kFirstStep * radius; step >= finest; step *= 0.5) {
    for (int k = 0; k < 2 * kDirections;) {
      ++k;
      const Vec2 aside = step * direction_of(random_.unit() * 2 * kPi);
      const double share = random_.below(2) == 0 ? 1.0 : random_.between(-1, 1);
      const bool mirrored = random_.below(2) == 0;
      const Vec2 x = p + (mirrored ? share * aside : aside), y = q + (mirrored ? aside : share * aside);
      ++work_;
      const double length = length_through(x, y);
      if (length >= best - kLeastGain * radius || !works(x, y)) continue;
      p = x;
      q = y;
      best = length;
      k = 0;
    }
  }
  if (p != was_p) path_.place(c, p);
  if (q != was_q) path_.place(d, q);
  path_.lay(c, d);
  return best < first_length - 1e-3 * finest;
}

void Shortening::pull(std::vector<Corner> corners, double finest) {
  const std::size_t most = 4 * corners.size() + 8;
  pull_some(std::move(corners), finest, most);
}

void Shortening::pull_some(std::vector<Corner> corners, double finest, std::size_t most) {
  std::vector<char> waits(static_cast<std::size_t>(path_.index_limit()), 0);
  const auto push = [&](Corner c) {
    if (path_.is_nowhere(c) || is_fixed(c)) return;
    if (static_cast<std::size_t>(c) >= waits.size())
      waits.resize(static_cast<std::size_t>(path_.index_limit()), 0);
    if (waits[static_cast<std::size_t>(c)] != 0) return;
    waits[static_cast<std::size_t>(c)] = 1;
    corners.push_back(c);
  };
  std::vector<Corner> start;
  std::swap(start, corners);
  for (const Corner c : start) push(c);
  for (std::size_t i = 0; i < corners.size() && i < most && work() < most_work_; ++i) {
    throw_if_cancelled(limits_.cancel);
    const Corner c = corners[i];
    waits[static_cast<std::size_t>(c)] = 0;
    if (!path_.is_alive(c)) continue;
    const Corner a = path_.previous(c), b = path_.next(c);
    bool shorter = pull_corner(c, finest);
    if (path_.is_alive(c)) {
      if (random_.below(4) < moves_share_) shorter = pull_move(c, finest) || shorter;
      if (shorter) push(c);
    }
    if (shorter) {
      push(a);
      push(b);
    }
  }
}

void Shortening::pull_all(double finest, int rounds) {
  for (int round = 0; round < rounds && work() < most_work_; ++round) {
    const double before = path_.length();
    std::vector<Corner> all;
    Corner first = random_corner();
    for (Corner c = first;;) {
      all.push_back(c);
      c = path_.next(c);
      if (c == first) break;
    }
    pull(std::move(all), finest);
    if (path_.length() > before - finest) break;
  }
}

bool Shortening::take_out_stretch(std::vector<Vec2>& bare) {
  Corner c = random_corner();
  const int count = 1 + static_cast<int>(random_.below(7));
  for (int i = 0; i < count && path_.corners() > kFewestCorners; ++i) {
    const Corner following = path_.next(c);
    if (!is_fixed(c)) path_.erase(c, bare);
    c = following;
    if (path_.is_nowhere(c)) c = path_.next(c);
  }
  return true;
}

bool Shortening::take_out_disc(std::vector<Vec2>& bare) {
  const Vec2 center = path_.at(random_corner());
  const double reach = random_.between(0.8, 3.2) * witnesses_.radius();
  std::vector<Corner> inside;
  path_.for_moves_near(center, reach, [&](Corner a, Corner b) {
    for (const Corner c : {a, b})
      if (distance(path_.at(c), center) < reach) inside.push_back(c);
  });
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
  for (const Corner c : inside)
    if (!is_fixed(c) && path_.corners() > kFewestCorners) path_.erase(c, bare);
  return true;
}

bool Shortening::join_otherwise(std::vector<Vec2>& bare) {
  const Corner a = random_corner(), b = path_.next(a);
  if (path_.is_nowhere(b)) return false;
  struct Other {
    Corner c, d;
    double cost;
  };
  std::vector<Other> others;
  path_.for_moves_near(lerp(path_.at(a), path_.at(b), 0.5), 3 * witnesses_.radius(), [&](Corner c, Corner d) {
    if (c == a || d == a || c == b || d == b) return;
    const double cost = distance(path_.at(a), path_.at(c)) + distance(path_.at(b), path_.at(d)) -
                        path_.move_length(a, b) - path_.move_length(c, d);
    if (cost < 1.2 * witnesses_.radius()) others.push_back({c, d, cost});
  });
  if (others.empty()) return false;
  const Other other = others[random_.below(others.size())];
  if (!may_move(path_.at(a), path_.at(other.c)) || !may_move(path_.at(b), path_.at(other.d))) return false;
  path_.reverse(b, other.c, bare);
  return true;
}

bool Shortening::move_stretch(std::vector<Vec2>& bare) {
  if (path_.corners() < 8) return false;
  Corner c = random_corner();
  const int count = 1 + static_cast<int>(random_.below(8));
  std::vector<Corner> stretch;
  for (int i = 0; i < count && i + kFewestCorners < path_.corners(); ++i) {
    if (path_.is_nowhere(c) || is_fixed(c)) break;
    stretch.push_back(c);
    c = path_.next(c);
  }
  if (stretch.empty()) return false;
  std::vector<Vec2> points;
  for (const Corner corner : stretch) points.push_back(path_.at(corner));
  const Corner before = path_.previous(stretch.front()), after = c;
  const double gain = path_.move_length(before, stretch.front()) + path_.move_length(stretch.back(), after) -
                      path_.move_length(before, after);
  struct Place {
    Corner a, b;
    bool turned;
  };
  std::vector<Place> places;
  const auto consider = [&](Corner a, Corner b) {
    if (a == before && b == stretch.front()) return;
    if (std::find(stretch.begin(), stretch.end(), a) != stretch.end() ||
        std::find(stretch.begin(), stretch.end(), b) != stretch.end())
      return;
    for (const bool turned : {false, true}) {
      const Vec2 first = turned ? points.back() : points.front(),
                 last = turned ? points.front() : points.back();
      const double cost =
          distance(path_.at(a), first) + distance(last, path_.at(b)) - path_.move_length(a, b);
      if (cost - gain < 1.2 * witnesses_.radius()) places.push_back({a, b, turned});
    }
  };
  path_.for_moves_near(random_.below(2) == 0 ? points.front() : points.back(), 2.5 * witnesses_.radius(),
                       consider);
  if (places.empty()) return false;
  const Place place = places[random_.below(places.size())];
  for (const Corner corner : stretch) path_.erase(corner, bare);
  if (place.turned) std::reverse(points.begin(), points.end());
  Corner at = place.a;
  for (const Vec2 p : points) at = path_.insert_after(at, p, bare);
  // Points uncleared for a while may be cleared by now.
  const double r2 = witnesses_.radius() * witnesses_.radius();
  std::vector<Vec2> line{path_.at(place.a)};
  line.insert(line.end(), points.begin(), points.end());
  line.push_back(path_.at(place.b));
  std::erase_if(bare, [&](Vec2 p) {
    for (std::size_t i = 1; i < line.size(); ++i)
      if (clears(line[i - 1], line[i], p, r2)) return true;
    return false;
  });
  return true;
}

bool Shortening::change(double tolerance, double finest) {
  const std::size_t mark = path_.mark();
  const double before = path_.length();
  work_ += kLeastWork;
  std::vector<Vec2> bare;
  const auto kind = random_.below(10);
  const int row = kind < 4 ? 0 : kind < 6 ? 1 : kind < 8 ? 2 : 3;
  bool changed = false;
  if (row == 0) changed = take_out_stretch(bare);
  if (row == 1) changed = take_out_disc(bare);
  if (row == 2) changed = join_otherwise(bare);
  if (row == 3) changed = move_stretch(bare);
  const int corners_before = path_.corners();
  const double price = limits_.corner_price;
  const double allowed = before + tolerance * random_.unit() * random_.unit();
  if (changed && limits_.may_move) {
    for (const Corner c : path_.changed_since(mark)) {
      const Corner b = path_.next(c), a = path_.previous(c);
      if (!path_.is_nowhere(c) && !path_.is_nowhere(b) && !may_move(path_.at(c), path_.at(b)))
        changed = false;
      if (!path_.is_nowhere(c) && !path_.is_nowhere(a) && !may_move(path_.at(a), path_.at(c)))
        changed = false;
      if (!changed) break;
    }
  }
  // Points cleared again by a later change of the same kind are not uncleared.
  if (changed) {
    const double r2 = witnesses_.radius() * witnesses_.radius();
    std::vector<std::pair<Vec2, Vec2>> moves;
    for (const Corner c : path_.changed_since(mark)) {
      if (!path_.is_nowhere(c) && !path_.is_nowhere(path_.next(c)))
        moves.push_back({path_.at(c), path_.at(path_.next(c))});
      if (!path_.is_nowhere(c) && !path_.is_nowhere(path_.previous(c)))
        moves.push_back({path_.at(path_.previous(c)), path_.at(c)});
    }
    work_ += bare.size() * moves.size() / 8;
    std::erase_if(bare, [&](Vec2 p) {
      return std::any_of(moves.begin(), moves.end(),
                         [&](const auto& move) { return clears(move.first, move.second, p, r2); });
    });
    changed = clear(std::move(bare));
  }
  if (changed && path_.length() < before + kWorthPulling * witnesses_.radius()) {
    std::vector<Corner> changed_corners = path_.changed_since(mark);
    const std::size_t count = changed_corners.size();
    pull_some(std::move(changed_corners), finest, count);
    if (path_.length() < before + kWorthPullingOn * witnesses_.radius())
      pull(path_.changed_since(mark), finest);
    if (path_.length() + price * (path_.corners() - corners_before) <=
        allowed - kLeastGain * witnesses_.radius()) {
      path_.forget();
      return true;
    }
  }
  path_.undo(mark);
  return false;
}

}  // namespace clearcut::plan::cover
