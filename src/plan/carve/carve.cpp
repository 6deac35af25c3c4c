#include "plan/carve/carve.h"

#include <algorithm>
#include <cmath>

#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::plan::carve {
namespace {

/// mm. Curved pieces of the medial axis are replaced by chords this near to them.
constexpr double kChord = 0.0002;
/// mm. Points of a track nearer to the previous one are left out: they are due to rounding at joints of the axis.
constexpr double kSamePoint = kChord;
/// mm. Width of the rim of a mill's cleared area that is cut once more.
constexpr double kRim = 0.02;
/// Share of the distance between rings by which the places of the rings begin outside of the first ring.
constexpr double kOutside = 0.01;

Vec2 begin_of(const Track& track) {
  return track.pieces.front().path.from;
}

Vec2 middle_of(const Track& track) {
  return track.pieces[track.pieces.size() / 2].path.at(0.5);
}

/// The region around p, or the nearest one.
std::size_t place_of(Vec2 p, const Regions& places) {
  std::size_t best = 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].contains(p)) return i;
    const double apart = places[i].boundary_distance(p);
    if (apart < least) least = apart, best = i;
  }
  return best;
}

/// The first and the last point always stay.
Chain without_near_points(const Chain& chain) {
  if (chain.size() < 2) return chain;
  Chain out;
  for (const AxisPoint& p : chain) {
    if (out.empty() || distance(out.back().point, p.point) > kSamePoint) out.push_back(p);
  }
  if (out.size() > 1) out.pop_back();  // the last point itself, or a nearly equal one
  out.push_back(chain.back());
  return out;
}

double length_of(const Track& track) {
  double length = 0;
  for (const Track::Piece& piece : track.pieces) length += piece.path.length();
  return length;
}

/// The sets of one place after those of another; the next place is the one that begins nearest to the end of the
/// previous.
TrackSets place_by_place(std::vector<TrackSets> places) {
  TrackSets ordered;
  std::erase_if(places, [](const TrackSets& sets) { return sets.empty(); });
  while (!places.empty()) {
    const auto apart = [&ordered](const TrackSets& sets) {
      return ordered.empty() ? 0 : distance(begin_of(ordered.back().back()), begin_of(sets.front().front()));
    };
    const auto next =
        std::min_element(places.begin(), places.end(),
                         [&](const TrackSets& a, const TrackSets& b) { return apart(a) < apart(b); });
    for (std::vector<Track>& set : *next) ordered.push_back(std::move(set));
    places.erase(next);
  }
  return ordered;
}

class RegionCarver {
 public:
  RegionCarver(const Region& region, const CarveShape& shape, const Regions& cleared, const Tolerances& tol)
      : clearance_(region, tol),
        tol_(tol),
        shape_(shape),
        nearest_(shape.tip_radius + shape.aside),
        widest_(nearest_ + (shape.top - shape.floor) * shape.slope) {
    for (const Region& one : cleared) {
      // A pass covers a tip's radius on both sides: passes are added until this whole width is cleared.
      for (Region& rest : inset(one, kRim + shape.tip_radius, tol)) cleared_.push_back(std::move(rest));
    }
    for (const Region& one : cleared_) {
      for (const Edge& edge : one.edges()) rims_.push_back(edge);
    }
  }

  TrackSets carve() {
    collect_axis();
    const bool has_floor = clearance_.max() > widest_;
    const double depth = shape_.top - shape_.floor;
    const int levels = std::max(1, static_cast<int>(std::ceil(depth / shape_.stepdown - 1e-9)));
    TrackSets sets;
    double above = shape_.top;
    for (int i = 1; i <= levels; ++i) {
      const double z = i == levels ? shape_.floor : shape_.top - depth * i / levels;
      std::vector<Track> set = tracks_of(joined(deeper_than(above)), z);
      if (has_floor) add_rings(clearance_.inset(widest_ + shape_.arcs_aside), z, set);
      sets.push_back(std::move(set));
      above = z;
    }
    if (has_floor) clear_floor(sets);
    std::erase_if(sets, [](const std::vector<Track>& set) { return set.empty(); });
    return sets;
  }

 private:
  double tip_at(double clearance) const {
    return std::max(shape_.floor, shape_.top - std::max(0.0, clearance - nearest_) / shape_.slope);
  }
  double clearance_at(double z) const { return nearest_ + (shape_.top - z) * shape_.slope; }

  void collect_axis() {
    const MedialAxis& axis = clearance_.axis();
    std::vector<char> has_edge(axis.points.size(), 0);
    for (std::size_t i = 0; i < axis.edges.size(); ++i) {
      const AxisEdge& edge = axis.edges[i];
      has_edge[static_cast<std::size_t>(edge.a)] = has_edge[static_cast<std::size_t>(edge.b)] = 1;
      Chain chain = clearance_.axis_curve(static_cast<int>(i), kChord);
      chain.front() = axis.points[static_cast<std::size_t>(edge.a)];
      chain.back() = axis.points[static_cast<std::size_t>(edge.b)];
      axis_.push_back(std::move(chain));
    }
    // An axis point without edges is the centre of a round region.
    for (std::size_t i = 0; i < has_edge.size(); ++i)
      if (!has_edge[i]) axis_.push_back({axis.points[i]});
  }

  /// Stretches of the axis with the tip below z, up to the place where the tip reaches the floor.
  std::vector<Chain> deeper_than(double z) const {
    std::vector<Chain> out;
    for (const Chain& chain : axis_) {
      for (Chain& part : between(chain, clearance_at(z), widest_)) out.push_back(std::move(part));
    }
    return out;
  }

  std::vector<Track> tracks_of(const std::vector<Chain>& chains, double z) const {
    const double bend = clearance_at(z);
    std::vector<Track> tracks;
    for (const Chain& chain : chains) {
      Track track;
      const Chain bent = without_near_points(with_points_at(chain, bend));
      const auto tip = [&](const AxisPoint& p) { return std::max(z, tip_at(p.clearance)); };
      for (std::size_t i = 0; i + 1 < bent.size(); ++i) {
        track.pieces.push_back(
            {Edge::line(bent[i].point, bent[i + 1].point), tip(bent[i]), tip(bent[i + 1])});
      }
      if (bent.size() == 1) track.pieces.push_back(standing(bent.front().point, tip(bent.front())));
      tracks.push_back(std::move(track));
    }
    return tracks;
  }

  static Track::Piece standing(Vec2 at, double z) { return {Edge::line(at, at), z, z}; }

  static void add_loop(const Loop& loop, double z, std::vector<Track>& set) {
    Track track;
    track.closed = true;
    for (const Edge& edge : loop) track.pieces.push_back({edge, z, z});
    set.push_back(std::move(track));
  }

  static void add_rings(const Regions& regions, double z, std::vector<Track>& set) {
    for (const Region& region : regions) {
      add_loop(region.outer(), z, set);
      for (const Loop& island : region.islands()) add_loop(island, z, set);
    }
  }

  /// mm from one ring on the floor to the next.
  double ring_step() const { return 2 * (shape_.tip_radius + shape_.cusp * shape_.slope); }

  /// Adds passes over the part of the floor not cleared by a mill, corner after corner.
  void clear_floor(TrackSets& sets) const {
    TrackSets passes = floor_passes();
    const Regions floor = clearance_.inset(widest_ + (1 - kOutside) * ring_step());
    const Regions places = cleared_.empty() ? floor : subtract(floor, cleared_, tol_);
    if (places.size() > 1) {
      std::vector<TrackSets> by_place(places.size());
      for (std::vector<Track>& set : passes) {
        std::vector<std::vector<Track>> shares(places.size());
        for (Track& track : set) shares[place_of(middle_of(track), places)].push_back(std::move(track));
        for (std::size_t i = 0; i < shares.size(); ++i)
          if (!shares[i].empty()) by_place[i].push_back(std::move(shares[i]));
      }
      passes = place_by_place(std::move(by_place));
    }
    for (std::vector<Track>& set : passes) sets.push_back(std::move(set));
  }

  /// Rings inwards, then the axis inside them.
  TrackSets floor_passes() const {
    TrackSets sets;
    const double step = ring_step();
    for (double at = widest_ + step; at < clearance_.max(); at += step) {
      std::vector<Track> set;
      for (const Region& region : clearance_.inset(at)) {
        add_uncleared(region.outer(), set);
        for (const Loop& island : region.islands()) add_uncleared(island, set);
      }
      if (set.empty() && !cleared_.empty()) break;
      sets.push_back(std::move(set));
    }
    std::vector<Chain> inner;
    for (const Chain& chain : axis_) {
      for (const Chain& part : between(chain, widest_, clearance_.max() + 1)) add_uncleared_part(part, inner);
    }
    sets.push_back(tracks_of(joined(inner), shape_.floor));
    return sets;
  }

  bool is_cleared(Vec2 p) const { return contains(cleared_, p); }

  /// Shares of an edge at which the edge enters or leaves the area cleared by a mill, with 0 and 1, in order. Between
  /// two of them the edge is wholly cleared, or not at all: hence rounding moves the ends of passes by no more than
  /// itself.
  std::vector<double> crossings(const Edge& edge) const {
    std::vector<double> shares{0, 1};
    const Box here = edge.box();
    for (const Edge& rim : rims_) {
      if (!rim.box().overlaps(here)) continue;
      for (const Vec2 p : intersections(edge, rim)) shares.push_back(nearest(edge, p).t);
    }
    std::sort(shares.begin(), shares.end());
    shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
    return shares;
  }

  void add_uncleared(const Loop& loop, std::vector<Track>& set) const {
    Track run;
    bool whole = true;
    for (const Edge& edge : loop) {
      const std::vector<double> shares = crossings(edge);
      for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
        const double a = shares[i], b = shares[i + 1];
        if (is_cleared(edge.at((a + b) / 2))) {
          whole = false;
          add_run(std::move(run), set);
          run = {};
        } else {
          run.pieces.push_back({shares.size() == 2 ? edge : edge.part(a, b), shape_.floor, shape_.floor});
        }
      }
    }
    if (whole) return add_loop(loop, shape_.floor, set);
    add_run(std::move(run), set);
  }

  /// A run that begins or ends in the mill's area is left out if the whole run is within the rim.
  static void add_run(Track run, std::vector<Track>& set) {
    if (length_of(run) > kRim) set.push_back(std::move(run));
  }

  void add_uncleared_part(const Chain& chain, std::vector<Chain>& out) const {
    Chain run;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (chain[i].point == chain[i + 1].point) continue;
      const std::vector<double> shares = crossings(Edge::line(chain[i].point, chain[i + 1].point));
      for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
        const AxisPoint a = part_way(chain[i], chain[i + 1], shares[k]);
        const AxisPoint b = part_way(chain[i], chain[i + 1], shares[k + 1]);
        if (is_cleared(lerp(a.point, b.point, 0.5))) {
          if (run.size() > 1) out.push_back(std::move(run));
          run = {};
          continue;
        }
        if (run.empty()) run.push_back(a);
        run.push_back(b);
      }
    }
    if (run.size() > 1) out.push_back(std::move(run));
  }

  Clearance clearance_;
  const Tolerances& tol_;
  const CarveShape& shape_;
  double nearest_;  ///< mm; clearance for which the tip is at the top of the material
  double widest_;   ///< mm; least clearance for which the tip is at the floor
  Regions cleared_;
  std::vector<Edge> rims_;  ///< the outlines of `cleared_`
  std::vector<Chain> axis_;
};

}  // namespace

TrackSets carve_region(const Region& region, const CarveShape& shape, const Regions& cleared,
                       const Tolerances& tol) {
  return RegionCarver(region, shape, cleared, tol).carve();
}

TrackSets engrave_line(const Path& line, bool closed, double top, double floor, double stepdown) {
  const int levels = std::max(1, static_cast<int>(std::ceil((top - floor) / stepdown - 1e-9)));
  TrackSets sets;
  for (int i = 1; i <= levels; ++i) {
    const double z = i == levels ? floor : top - (top - floor) * i / levels;
    Track track;
    track.closed = closed;
    for (const Edge& edge : line) track.pieces.push_back({edge, z, z});
    sets.push_back({std::move(track)});
  }
  return sets;
}

}  // namespace clearcut::plan::carve
