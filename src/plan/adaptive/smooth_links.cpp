#include "plan/adaptive/smooth_links.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/units.h"
#include "plan/adaptive/clearing/arcs.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// Length of the pieces of arcs that are tested one by one, as a share of the cutter's radius.
constexpr double kPieceOfArc = 0.02;
/// Shares of the radius at which the machine keeps the feed: the circles that are tried at the ends of links.
constexpr double kCircles[] = {1, 0.5, 0.25, 0.1, 0.04};
/// Share of the tool radius, and the greatest: the wider ones are longer than what they save.
constexpr double kWidestCircle = 2;
/// Radians. Turns of less than this are joined as they are; longer ones than kLongestTurn are no gain.
constexpr double kNoTurn = 1e-6;
constexpr double kLongestTurn = 5;
/// mm. Moves of links shorter than this are left out.
constexpr double kShortestLine = 1e-4;
/// s that another link has to save for each move more.
constexpr double kLeastGain = 1e-3;
/// Number of moves before and after a link that are timed with it.
constexpr std::size_t kTimedMoves = 6;

double positive_angle(Vec2 from, Vec2 to) {
  const double angle = base::atan2(cross(from, to), dot(from, to));
  return angle < 0 ? angle + 2 * kPi : angle;
}

Vec2 center_of(const LinkEnd& end) {
  return end.point + left_of(end.heading) * (end.left ? end.radius : -end.radius);
}

/// The point of an end's circle at which it runs along `heading`.
Vec2 on_circle(const LinkEnd& end, Vec2 heading) {
  return center_of(end) - left_of(heading) * (end.left ? end.radius : -end.radius);
}

/// Appends the turn from one heading to another on the circle of `end`; false where it is too long.
bool add_turn(Path& path, const LinkEnd& end, Vec2 from, Vec2 to) {
  if (end.radius <= 0) return true;
  const double turn = end.left ? positive_angle(from, to) : positive_angle(to, from);
  if (turn < kNoTurn || turn > 2 * kPi - kNoTurn) return true;
  if (turn > kLongestTurn) return false;
  path.push_back(Edge::arc(on_circle(end, from), on_circle(end, to), center_of(end),
                           end.left ? Turn::kCounterClockwise : Turn::kClockwise));
  return true;
}

}  // namespace

std::optional<Path> smooth_link(const LinkEnd& from, const LinkEnd& to) {
  // A line whose left normal is n touches a circle with its center at c + n r, r negative for circles on the right.
  const double r_from = from.left ? from.radius : -from.radius, r_to = to.left ? to.radius : -to.radius;
  const Vec2 between = center_of(to) - center_of(from);
  const double apart = norm(between), rise = r_to - r_from;
  if (apart <= std::abs(rise) + kShortestLine) return std::nullopt;
  // between = heading * along + left_of(heading) * rise
  const double along = std::sqrt(apart * apart - rise * rise);
  const Vec2 u = between / apart;
  const Vec2 heading = u * (along / apart) - left_of(u) * (rise / apart);
  Path path;
  if (!add_turn(path, from, from.heading, heading)) return std::nullopt;
  const Vec2 leaves = on_circle(from, heading), arrives = on_circle(to, heading);
  if (distance(leaves, arrives) > kShortestLine) path.push_back(Edge::line(leaves, arrives));
  if (!add_turn(path, to, heading, to.heading)) return std::nullopt;
  if (path.empty()) return std::nullopt;
  path.front().from = from.point;
  path.back().to = to.point;
  for (std::size_t i = 1; i < path.size(); ++i) path[i].from = path[i - 1].to;
  return path;
}

std::optional<Path> biarc(Vec2 from, Vec2 heading, Vec2 to, Vec2 end_heading) {
  // Both tangents from the ends to the joint are d mm long: |to - d end_heading - from - d heading| = 2 d.
  const Vec2 chord = to - from, sum = heading + end_heading;
  const double a = 4 - norm_squared(sum), b = 2 * dot(chord, sum), c = -norm_squared(chord);
  if (a < kNoTurn) return std::nullopt;
  const double d = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
  if (!(d > kShortestLine)) return std::nullopt;
  const Vec2 joint = (from + heading * d + to - end_heading * d) / 2.0;
  return Path{tangent_arc(from, heading, joint), tangent_arc(to, -end_heading, joint).reversed()};
}

namespace {

class LinkSmoother {
 public:
  LinkSmoother(RemainingStock& stock, const MachineClock& clock) : stock_(stock), clock_(clock) {
    const double full = std::min(clock.radius_at(clock.feed.mm_per_s()), kWidestCircle * stock.tool_radius());
    for (const double share : kCircles) radii_.push_back(share * full);
    radii_.push_back(0);
  }

  void run(Pass& pass) {
    path_.clear();
    kinds_.clear();
    for (std::size_t i = 0; i < pass.path.size();) {
      if (pass.kinds[i] != MoveKind::kLink) {
        stock_.cut(pass.path[i]);
        add(pass.path[i], pass.kinds[i]);
        ++i;
        continue;
      }
      std::size_t end = i + 1;
      while (end < pass.path.size() && pass.kinds[end] == MoveKind::kLink) ++end;
      Path link(pass.path.begin() + static_cast<std::ptrdiff_t>(i),
                pass.path.begin() + static_cast<std::ptrdiff_t>(end));
      if (i > 0 && end < pass.path.size()) link = smoothed(link, pass, end);
      for (const Edge& edge : link) add(edge, MoveKind::kLink);
      i = end;
    }
    pass.path = path_;
    pass.kinds = kinds_;
  }

 private:
  void add(const Edge& edge, MoveKind kind) {
    path_.push_back(edge);
    kinds_.push_back(kind);
  }

  struct Timed {
    double seconds = 0;
    Path link;
  };

  /// `end`: the number of the move in `pass` that follows the link.
  Path smoothed(const Path& link, const Pass& pass, std::size_t end) const {
    const Vec2 into = path_.back().tangent_at(1), onto = pass.path[end].tangent_at(0);
    std::vector<Path> candidates;
    if (link.size() == 1) {
      candidates = from_end_to_end(link.front(), into, onto);
    } else {
      candidates = with_smooth_ends(link, into, onto);
    }
    const double before = timed(link, pass, end);
    std::vector<Timed> faster;
    for (Path& candidate : candidates) {
      const double seconds = timed(candidate, pass, end);
      const auto added = static_cast<double>(std::max(candidate.size(), link.size() + 1) - link.size());
      if (seconds < before - kLeastGain * added) faster.push_back({seconds, std::move(candidate)});
    }
    std::sort(faster.begin(), faster.end(),
              [](const Timed& a, const Timed& b) { return a.seconds < b.seconds; });
    for (Timed& one : faster) {
      if (is_free(one.link)) return std::move(one.link);
    }
    return link;
  }

  /// With circles at both ends, on the sides to which the straight link turns.
  std::vector<Path> from_end_to_end(const Edge& link, Vec2 into, Vec2 onto) const {
    const Vec2 straight = unit(link.to - link.from);
    const bool left_from = cross(into, straight) > 0, left_to = cross(straight, onto) > 0;
    std::vector<Path> links;
    for (const double first : radii_) {
      for (const double last : radii_) {
        if (first == 0 && last == 0) continue;
        auto one = smooth_link({link.from, into, first, left_from}, {link.to, onto, last, left_to});
        if (one) links.push_back(std::move(*one));
      }
    }
    // Where a wall is in the way of straight lines: arcs that are tangential at one end or at both.
    links.push_back({tangent_arc(link.from, into, link.to)});
    links.push_back({tangent_arc(link.to, -onto, link.from).reversed()});
    if (auto one = biarc(link.from, into, link.to, onto)) links.push_back(std::move(*one));
    std::erase_if(links, [](const Path& one) {
      return std::any_of(one.begin(), one.end(),
                         [](const Edge& edge) { return std::abs(edge.sweep()) > kLongestTurn; });
    });
    return links;
  }

  /// Links of several moves: circles at both ends, where the first and the last are straight.
  std::vector<Path> with_smooth_ends(const Path& link, Vec2 into, Vec2 onto) const {
    std::vector<Path> links;
    const Edge &first = link.front(), &last = link.back();
    const Vec2 leaving = unit(first.to - first.from), arriving = unit(last.to - last.from);
    for (const double radius : radii_) {
      for (const double end_radius : radii_) {
        if ((radius == 0 || first.is_arc()) && (end_radius == 0 || last.is_arc())) continue;
        Path one{first};
        if (radius > 0 && !first.is_arc()) {
          auto start = smooth_link({first.from, into, radius, cross(into, leaving) > 0}, {first.to, leaving});
          if (!start) continue;
          one = std::move(*start);
        }
        one.insert(one.end(), link.begin() + 1, link.end() - 1);
        Path tail{last};
        if (end_radius > 0 && !last.is_arc()) {
          auto stop =
              smooth_link({last.from, arriving}, {last.to, onto, end_radius, cross(arriving, onto) > 0});
          if (!stop) continue;
          tail = std::move(*stop);
        }
        one.insert(one.end(), tail.begin(), tail.end());
        links.push_back(std::move(one));
      }
    }
    return links;
  }

  /// Arcs that leave cuts and come to them touch material between their ends first: they are tested in short pieces.
  bool is_free(const Edge& edge) const {
    const double piece = kPieceOfArc * stock_.tool_radius();
    const int count = edge.is_arc() ? static_cast<int>(edge.length() / piece) + 1 : 1;
    for (int i = 0; i < count; ++i) {
      const double a = static_cast<double>(i) / count, b = (i + 1.0) / count;
      if (!stock_.is_free(edge.part(a, b), RemainingStock::kFree)) return false;
    }
    return true;
  }

  bool is_free(const Path& link) const {
    return std::all_of(link.begin(), link.end(), [&](const Edge& edge) { return is_free(edge); });
  }

  /// Seconds of a link with some moves before and after it.
  double timed(const Path& link, const Pass& pass, std::size_t end) const {
    const std::size_t from = path_.size() - std::min(path_.size(), kTimedMoves),
                      to = std::min(pass.path.size(), end + kTimedMoves);
    const auto at = [](const auto& list, std::size_t i) {
      return list.begin() + static_cast<std::ptrdiff_t>(i);
    };
    Path moves(at(path_, from), path_.end());
    std::vector<MoveKind> kinds(at(kinds_, from), kinds_.end());
    moves.insert(moves.end(), link.begin(), link.end());
    kinds.insert(kinds.end(), link.size(), MoveKind::kLink);
    moves.insert(moves.end(), at(pass.path, end), at(pass.path, to));
    kinds.insert(kinds.end(), at(pass.kinds, end), at(pass.kinds, to));
    return clock_.seconds(moves, kinds);
  }

  RemainingStock& stock_;
  const MachineClock& clock_;
  std::vector<double> radii_;
  Path path_;
  std::vector<MoveKind> kinds_;
};

}  // namespace

void smooth_links(std::vector<Pass>& passes, RemainingStock& stock, const MachineClock& clock) {
  if (!clock.runs()) return;
  LinkSmoother smoother(stock, clock);
  for (Pass& pass : passes) {
    if (pass.kinds.size() == pass.path.size()) smoother.run(pass);
  }
}

}  // namespace clearcut::plan::adaptive
