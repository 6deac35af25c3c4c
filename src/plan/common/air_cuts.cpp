#include "plan/common/air_cuts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/route/legal_area.h"
#include "geometry/spatial/cell_grid.h"
#include "plan/common/cover.h"
#include "plan/common/pass_parts.h"
#include "plan/common/round_corners.h"

namespace clearcut::plan {
namespace {

/// Shares of the radius: length of the pieces of passes, and distance between witnesses.
constexpr double kPiece = 0.2, kPitch = 0.25;
/// Factor on both for the first look at what may be gained.
constexpr double kCoarse = 3;
/// Share of the length that a first look takes too much of, about.
constexpr double kHopeful = 0.15;
/// Side of the cells for finding pieces, as a share of the radius.
constexpr double kCell = 0.5;
/// Larger layers stay as they are.
constexpr double kMostWitnesses = 120'000;
constexpr std::size_t kMostPieces = 40'000;
/// Share of the radius by which pieces clear witnesses with certainty, so that little is left between witnesses.
constexpr double kSpare = 2e-4;
/// mm. Far above the rounding of distances.
constexpr double kTouching = 1e-9;
/// mm. Places that passes clear by less count as left by them.
constexpr double kBarely = 1e-6;
/// Share of the radius; longest parts of rims that are looked at as a whole.
constexpr double kUncertain = 0.2;
/// Number of times that places between the witnesses are searched; number of those after which parts of passes are put back.
constexpr int kMostRounds = 12, kRoundsOfPieces = 6;
/// s. A pass is parted if this much time is gained.
constexpr double kWorthParting = 0.1;

/// A part of an edge of a pass.
struct Piece {
  std::uint32_t edge = 0;
  double from = 0, to = 1;  ///< parameters of the edge
  Edge path;
  double length = 0;
};

/// Pieces of a pass that follow each other.
using Run = std::vector<std::uint32_t>;

struct Witness {
  Vec2 at;
  double reach = 0;  ///< mm; pieces this near clear it
};

/// What is left of a pass. It is unchanged if it is closed, or if `runs` holds all of its pieces.
struct Remains {
  std::vector<Run> runs;
  bool is_whole = true;
};

Box box_of(const Edge& edge) {
  return edge.from == edge.to ? Box{edge.from, edge.from} : edge.box();
}

/// Lines and arcs of which the rim of the area within `reach` mm of an edge consists; `with_start`: the circle about its start, too.
std::vector<Edge> rim_of(const Edge& edge, double reach, bool with_start = true) {
  std::vector<Edge> rim;
  const auto add_circle = [&](Vec2 center) {
    const Vec2 a = center - Vec2{reach, 0}, b = center + Vec2{reach, 0};
    rim.push_back(Edge::arc(a, b, center, Turn::kCounterClockwise));
    rim.push_back(Edge::arc(b, a, center, Turn::kCounterClockwise));
  };
  if (with_start) add_circle(edge.from);
  if (edge.from == edge.to) return rim;
  add_circle(edge.to);
  for (const double aside : {reach, -reach}) {
    if (edge.is_arc() && edge.radius() + aside <= 0) continue;
    const auto beside = [&](Vec2 p, double t) {
      return edge.is_arc() ? p + unit(p - edge.center) * aside : p + left_of(edge.tangent_at(t)) * aside;
    };
    rim.push_back({beside(edge.from, 0), beside(edge.to, 1), edge.center, edge.turn});
  }
  return rim;
}

/// The rims of the areas within `reach` mm of edges, found by place.
class Rims {
 public:
  Rims(const std::vector<Edge>& edges, double reach) : by_edge_(2 * reach) {
    first_.push_back(0);
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      const bool follows = i > 0 && edges[i - 1].to == edges[i].from;
      for (Edge& edge : rim_of(edges[i], reach, !follows)) {
        boxes_.push_back(edge.box());
        rims_.push_back(std::move(edge));
      }
      first_.push_back(static_cast<std::uint32_t>(rims_.size()));
      around_.push_back(box_of(edges[i]).grown(reach));
      by_edge_.add(around_.back(), i);
    }
  }

  /// The edges of which the areas may meet a box.
  std::vector<std::uint32_t> near(const Box& box) const {
    std::vector<std::uint32_t> found = by_edge_.near(box);
    std::erase_if(found, [&](std::uint32_t i) { return !around_[i].overlaps(box); });
    return found;
  }

  /// Adds the parameters at which the rims of some edges cross `curve`.
  void add_crossings(const Edge& curve, const Box& around_curve, const std::vector<std::uint32_t>& edges,
                     std::vector<double>& cuts) const {
    for (const std::uint32_t i : edges)
      for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k)
        if (boxes_[k].overlaps(around_curve))
          for (const Vec2 p : intersections(curve, rims_[k])) cuts.push_back(nearest(curve, p).t);
  }

 private:
  std::vector<Edge> rims_;
  std::vector<Box> boxes_;            ///< by rim
  std::vector<std::uint32_t> first_;  ///< by edge: its first rim; at the end their number
  std::vector<Box> around_;           ///< by edge
  BoxIndex by_edge_;
};

bool may_change(const Pass& pass) {
  return pass.kinds.empty() && !pass.entry_center && !pass.path.empty();
}

class Trimming {
 public:
  /// `coarseness`: factor on the length of pieces and the distance of witnesses.
  Trimming(const LayerPasses& layer, const AirCutJob& job, double coarseness)
      : layer_(layer),
        job_(job),
        coarseness_(coarseness),
        proven_(proven_radius(job.radius, layer.residual)),
        legal_(layer.legal),
        target_(layer.target),
        box_(geometry::box(layer.target).grown(job.radius)) {}

  /// Share of the length that stays if nothing but the witnesses counts.
  double share_left_by_witnesses() {
    if (!prepare()) return 1;
    trim_all();
    return share_left();
  }

  std::optional<LayerPasses> run() {
    if (!prepare()) return std::nullopt;
    before_.emplace(edges_of_passes(layer_.passes), proven_);
    for (int round = 0; round < kMostRounds; ++round) {
      trim_all();
      // What is found to be left only lets more stay in later rounds.
      if (share_left() > job_.most_left) return std::nullopt;
      if (std::all_of(remains_.begin(), remains_.end(), [](const Remains& one) { return one.is_whole; }))
        return std::nullopt;
      LayerPasses trimmed = trimmed_layer();
      const std::vector<Vec2> left = left_by(edges_of_passes(trimmed.passes));
      if (left.empty()) return trimmed;
      for (const Vec2 p : left) keep_around(p, round);
    }
    return std::nullopt;
  }

 private:
  static std::vector<Edge> edges_of_passes(const std::vector<Pass>& passes) {
    std::vector<Edge> edges;
    for (const Pass& pass : passes) edges.insert(edges.end(), pass.path.begin(), pass.path.end());
    return edges;
  }

  /// Places of the target that the passes cleared before and `edges` do not.
  std::vector<Vec2> left_by(const std::vector<Edge>& edges) const {
    const Cover now(edges, proven_);
    std::vector<Vec2> left =
        now.holes([&](Vec2 p) { return target_.contains(p) && before_->holds(p, kBarely); });
    // Other places that are newly left touch the rim of what a taken edge cleared, or the border of the target.
    const std::vector<Edge> taken = taken_edges();
    const Rims rims_now(edges, proven_), rims_of_taken(taken, proven_);
    const auto add_left_on = [&](const Edge& curve) {
      for (const Edge& part : uncertain_parts(curve, now))
        add_left_on_part(part, rims_of_taken, rims_now, now, left);
    };
    for (const Edge& side : geometry::edges_of(layer_.target)) add_left_on(side);
    if (!left.empty()) return left;  // asked again when those places are cleared
    for (const Edge& edge : taken)
      for (const Edge& rim : rim_of(edge, proven_ - 2 * kBarely)) add_left_on(rim);
    return left;
  }

  /// The stretches of edges that are taken.
  std::vector<Edge> taken_edges() const {
    std::vector<bool> stays(pieces_.size(), false);
    for (const Remains& remains : remains_)
      for (const Run& run : remains.runs)
        for (const std::uint32_t piece : run) stays[piece] = true;
    std::vector<Edge> taken;
    for (std::size_t pass = 0; pass + 1 < first_.size(); ++pass) {
      for (std::uint32_t i = first_[pass]; i < first_[pass + 1];) {
        std::uint32_t end = i + 1;
        while (end < first_[pass + 1] && stays[end] == stays[i] && pieces_[end].edge == pieces_[i].edge)
          ++end;
        const Edge& edge = layer_.passes[pass].path[pieces_[i].edge];
        const double from = pieces_[i].from, to = pieces_[end - 1].to;
        if (!stays[i]) taken.push_back(from == 0 && to == 1 ? edge : edge.part(from, to));
        i = end;
      }
    }
    return taken;
  }

  /// The parts of a curve of which a single edge may not clear the whole.
  std::vector<Edge> uncertain_parts(const Edge& curve, const Cover& now) const {
    std::vector<Edge> parts;
    const double length = curve.length();
    const int count = std::max(1, static_cast<int>(std::ceil(length / (kUncertain * job_.radius))));
    int first = 0;
    const auto end_at = [&](int end) {
      if (first < end)
        parts.push_back(end - first == count ? curve
                                             : curve.part(static_cast<double>(first) / count,
                                                          static_cast<double>(end) / count));
    };
    for (int k = 0; k < count; ++k) {
      if (!now.holds(curve.at((k + 0.5) / count), length / (2 * count) + kTouching)) continue;
      end_at(k);
      first = k + 1;
    }
    end_at(count);
    return parts;
  }

  /// Adds the middles of those parts of `curve` that are left. Each part lies between two intersections of the curve with the
  /// rims of what single edges clear, or cleared before.
  void add_left_on_part(const Edge& curve, const Rims& taken, const Rims& kept, const Cover& now,
                        std::vector<Vec2>& left) const {
    const Box box = curve.box(), around = box.grown(kTouching);
    const auto taken_near = taken.near(box);
    if (taken_near.empty()) return;
    std::vector<double> cuts{0, 1};
    taken.add_crossings(curve, around, taken_near, cuts);
    kept.add_crossings(curve, around, kept.near(box), cuts);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const Vec2 middle = curve.at((cuts[i - 1] + cuts[i]) / 2);
      if (now.holds(middle) || !before_->holds(middle, kBarely)) continue;
      if (target_.contains(middle) || target_.is_near_boundary(middle, kBarely)) left.push_back(middle);
    }
  }

  /// Makes the pieces and the witnesses. False if there are too many.
  bool prepare() {
    if (!divide()) return false;
    sort_pieces();
    set_witnesses();
    return true;
  }

  double share_left() const {
    double whole = 0, left = 0;
    for (const Piece& piece : pieces_) whole += piece.length;
    for (const Remains& remains : remains_)
      for (const Run& run : remains.runs)
        for (const std::uint32_t piece : run) left += pieces_[piece].length;
    return whole > 0 ? left / whole : 1;
  }

  /// Makes the pieces. False if there are too many.
  bool divide() {
    const double longest = coarseness_ * kPiece * job_.radius;
    for (const Pass& pass : layer_.passes) {
      first_.push_back(static_cast<std::uint32_t>(pieces_.size()));
      for (std::uint32_t e = 0; e < pass.path.size(); ++e) add_pieces(pass.path[e], e, longest);
    }
    first_.push_back(static_cast<std::uint32_t>(pieces_.size()));
    kept_.assign(pieces_.size(), false);
    return pieces_.size() < kMostPieces;
  }

  void add_pieces(const Edge& edge, std::uint32_t number, double longest) {
    const double whole = edge.length();
    const bool is_near = box_of(edge).overlaps(box_);
    const int parts = is_near ? std::max(1, static_cast<int>(std::ceil(whole / longest))) : 1;
    for (int k = 0; k < parts; ++k) {
      const double from = static_cast<double>(k) / parts, to = static_cast<double>(k + 1) / parts;
      pieces_.push_back({number, from, to, parts == 1 ? edge : edge.part(from, to), whole / parts});
    }
  }

  void sort_pieces() {
    near_ = CellGrid(box_.grown(job_.radius), kCell * job_.radius);
    const double reach = proven_ + kTouching;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const Box around = box_of(pieces_[i].path).grown(reach);
      if (!around.overlaps(near_.box)) continue;
      near_.for_cells(around, [&](std::size_t cell, Vec2) { pieces_in_.add(cell, i); });
    }
    pieces_in_.build(near_.count());
  }

  void set_witnesses() {
    const Box box = geometry::box(layer_.target);
    const double pitch =
        std::max(coarseness_ * kPitch * job_.radius, std::sqrt(area(layer_.target) / kMostWitnesses));
    bool odd = false;
    for (double y = box.min.y + pitch / 2; y < box.max.y; y += pitch, odd = !odd)
      for (double x = box.min.x + (odd ? pitch : pitch / 2); x < box.max.x; x += pitch)
        if (target_.contains({x, y})) add_witness({x, y});
    for (const Edge& edge : geometry::edges_of(layer_.target)) {
      const int parts = 1 + static_cast<int>(edge.length() / pitch);
      for (int k = 0; k < parts; ++k) add_witness(edge.at(static_cast<double>(k) / parts));
    }
  }

  /// Adds a point unless no pass clears it. A point that all pieces clear but barely is cleared by the nearest alone.
  void add_witness(Vec2 p) {
    const auto around = pieces_in_.at(near_.cell_of(p));
    distances_.clear();
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : around) {
      distances_.push_back(distance_to(i, p));
      least = std::min(least, distances_.back());
    }
    if (least > proven_ + kTouching) return;
    const double reach = std::max(proven_ - kSpare * job_.radius, least + kTouching);
    for (std::size_t k = 0; k < around.size(); ++k)
      if (distances_[k] <= reach) clearing_.emplace_back(around[k], witness_count_);
    ++witness_count_;
  }

  /// From now on keeps the piece that clears p best among those taken, and more of its neighbours in every round, at last the
  /// whole pass.
  void keep_around(Vec2 p, int round) {
    add_witness(p);
    std::optional<std::uint32_t> best;
    double nearest_distance = proven_ + kTouching;
    for (const std::uint32_t i : pieces_in_.at(near_.cell_of(p))) {
      if (kept_[i] || distance_to(i, p) > nearest_distance) continue;
      nearest_distance = distance_to(i, p);
      best = i;
    }
    if (!best) return;
    const auto pass = std::upper_bound(first_.begin(), first_.end(), *best);
    const std::uint32_t first = *(pass - 1), end = *pass;
    const std::uint32_t neighbours =
        round < kRoundsOfPieces ? 1U << static_cast<unsigned>(round) : end - first;
    const auto keep_from = kept_.begin() + std::max(first + neighbours, *best) - neighbours;
    std::fill(keep_from, kept_.begin() + std::min(end, *best + neighbours + 1), true);
  }

  double distance_to(std::uint32_t piece, Vec2 p) const {
    const Edge& path = pieces_[piece].path;
    return path.from == path.to ? distance(path.from, p) : distance(nearest_point(path, p), p);
  }

  /// Sorts the witnesses by the pieces clearing them, and trims one pass after the other.
  void trim_all() {
    witnesses_of_ = CellLists();
    for (const auto& [piece, witness] : clearing_) witnesses_of_.add(piece, witness);
    witnesses_of_.build(pieces_.size());
    left_.assign(witness_count_, 0);
    own_.assign(witness_count_, 0);
    for (const auto& [piece, witness] : clearing_) ++left_[witness];
    remains_.assign(layer_.passes.size(), {});
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < layer_.passes.size(); ++i) order.emplace_back(needed_share(i), i);
    std::sort(order.begin(), order.end());
    for (const auto& [share, pass] : order) trim(pass);
  }

  Run pieces_of(std::size_t pass) const {
    Run run;
    for (std::uint32_t i = first_[pass]; i < first_[pass + 1]; ++i) run.push_back(i);
    return run;
  }

  void count_own(const Run& run, int by) {
    for (const std::uint32_t piece : run)
      for (const std::uint32_t witness : witnesses_of_.at(piece)) own_[witness] += by;
  }

  /// Share of the pieces of a pass that clear something left by all other passes.
  double needed_share(std::size_t pass) {
    const Run run = pieces_of(pass);
    count_own(run, 1);
    const auto is_needed = [&](std::uint32_t piece) {
      const auto witnesses = witnesses_of_.at(piece);
      return std::any_of(witnesses.begin(), witnesses.end(),
                         [&](std::uint32_t w) { return left_[w] == own_[w]; });
    };
    const auto needed = std::count_if(run.begin(), run.end(), is_needed);
    count_own(run, -1);
    return static_cast<double>(needed) / static_cast<double>(std::max<std::size_t>(run.size(), 1));
  }

  bool may_take(std::uint32_t piece) const {
    if (kept_[piece]) return false;
    const auto witnesses = witnesses_of_.at(piece);
    if (!job_.takes_overlaps) return witnesses.empty();
    return std::all_of(witnesses.begin(), witnesses.end(), [&](std::uint32_t w) { return left_[w] > 1; });
  }
  void take(std::uint32_t piece) {
    for (const std::uint32_t witness : witnesses_of_.at(piece)) --left_[witness];
  }
  void put_back(std::uint32_t piece) {
    for (const std::uint32_t witness : witnesses_of_.at(piece)) ++left_[witness];
  }

  /// The pieces of `run` from `first` to before `end` while they may be taken together; all are put back.
  struct Stretch {
    std::size_t first = 0, end = 0;
    double length = 0;
  };

  /// The longest stretch that may be taken.
  Stretch longest_stretch(const Run& run, std::size_t most) {
    Stretch best;
    double taken = 0;
    std::size_t end = 0;
    for (std::size_t first = 0; first < run.size(); ++first) {
      if (end < first) end = first;
      while (end < run.size() && end - first < most && may_take(run[end])) {
        take(run[end]);
        taken += pieces_[run[end++]].length;
      }
      if (taken > best.length + kTouching) best = {first, end, taken};
      if (end == first) continue;
      put_back(run[first]);
      taken -= pieces_[run[first]].length;
    }
    return best;
  }

  void take_stretch(const Run& run, const Stretch& stretch) {
    for (std::size_t i = stretch.first; i < stretch.end; ++i) take(run[i]);
  }

  void trim(std::size_t number) {
    const Pass& pass = layer_.passes[number];
    Remains& remains = remains_[number];
    Run run = pieces_of(number);
    remains.runs = {run};
    if (!may_change(pass)) return;
    if (pass.closed) {
      open_ring(run, remains);
      if (remains.is_whole || remains.runs.empty()) return;
      run = remains.runs.front();
    }
    remains.runs.clear();
    const std::size_t all = run.size();
    if (!cut_ends(run)) {
      remains.is_whole = false;
      return;
    }
    part(run, remains);
    remains.is_whole = remains.is_whole && remains.runs.size() == 1 && remains.runs.front().size() == all;
  }

  /// Takes the longest stretch out of a ring, or all of it.
  void open_ring(const Run& ring, Remains& remains) {
    Run twice = ring;
    twice.insert(twice.end(), ring.begin(), ring.end());
    const Stretch gap = longest_stretch(twice, ring.size());
    if (gap.length < job_.radius) return;
    take_stretch(twice, gap);
    remains.is_whole = false;
    remains.runs.clear();
    const std::size_t left = ring.size() - (gap.end - gap.first);
    if (left == 0) return;
    const std::size_t begin = gap.end % ring.size();
    remains.runs.emplace_back(twice.begin() + static_cast<std::ptrdiff_t>(begin),
                              twice.begin() + static_cast<std::ptrdiff_t>(begin + left));
  }

  /// Shortens a run at both ends. False if nothing is left.
  bool cut_ends(Run& run) {
    std::size_t first = 0, end = run.size();
    while (first < end && may_take(run[first])) take(run[first++]);
    while (end > first && may_take(run[end - 1])) take(run[--end]);
    run =
        Run(run.begin() + static_cast<std::ptrdiff_t>(first), run.begin() + static_cast<std::ptrdiff_t>(end));
    return !run.empty();
  }

  /// Adds the run to `remains`, parted where a link is quicker than a stretch that may go.
  void part(const Run& run, Remains& remains) {
    const Stretch gap = longest_stretch(run, run.size());
    const bool inside = gap.first > 0 && gap.end < run.size();
    if (!inside || !is_worth_parting(run, gap)) {
      remains.runs.push_back(run);
      return;
    }
    take_stretch(run, gap);
    part(Run(run.begin(), run.begin() + static_cast<std::ptrdiff_t>(gap.first)), remains);
    part(Run(run.begin() + static_cast<std::ptrdiff_t>(gap.end), run.end()), remains);
  }

  bool is_worth_parting(const Run& run, const Stretch& gap) const {
    const Vec2 a = pieces_[run[gap.first]].path.from, b = pieces_[run[gap.end - 1]].path.to;
    double link = job_.retract->time(distance(a, b));
    if (legal_.holds_line(a, b)) link = std::min(link, distance(a, b) / job_.feed.mm_per_s());
    return gap.length / job_.feed.mm_per_s() > link + kWorthParting;
  }

  Path path_of(const Pass& pass, const Run& run) const {
    Path path;
    for (std::size_t i = 0; i < run.size();) {
      std::size_t end = i + 1;
      while (end < run.size() && pieces_[run[end]].edge == pieces_[run[i]].edge &&
             run[end] == run[end - 1] + 1)
        ++end;
      const double from = pieces_[run[i]].from, to = pieces_[run[end - 1]].to;
      const Edge& edge = pass.path[pieces_[run[i]].edge];
      path.push_back(from == 0 && to == 1 ? edge : edge.part(from, to));
      if (path.size() > 1) path.back().from = path[path.size() - 2].to;
      i = end;
    }
    return path;
  }

  /// The layer with what is left of its passes.
  LayerPasses trimmed_layer() const {
    std::vector<std::vector<Pass>> parts(layer_.passes.size());
    for (std::size_t i = 0; i < layer_.passes.size(); ++i) {
      const Pass& pass = layer_.passes[i];
      for (const Run& run : remains_[i].runs) {
        Pass& part = parts[i].emplace_back(pass);
        if (remains_[i].is_whole) continue;
        part.path = path_of(pass, run);
        part.reversible = pass.reversible || (!job_.keeps_direction && pass.parent >= 0);
        part.closed = false;
      }
    }
    LayerPasses trimmed = layer_;
    replace_passes(trimmed, std::move(parts));
    return trimmed;
  }

  const LayerPasses& layer_;
  const AirCutJob& job_;
  double coarseness_;
  double proven_;  ///< mm; the radius of the proof
  LegalArea legal_, target_;
  Box box_;  ///< around all places from which the target is reached
  std::optional<Cover> before_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> first_;  ///< the first piece of each pass; at the end the number of pieces
  std::vector<bool> kept_;            ///< by piece: whether it stays in any case
  CellGrid near_;
  CellLists pieces_in_;  ///< pieces near each cell
  std::uint32_t witness_count_ = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> clearing_;  ///< piece and witness
  CellLists witnesses_of_;                                         ///< by piece
  std::vector<int> left_;                                          ///< by witness: pieces left that clear it
  std::vector<int> own_;           ///< scratch: by witness, pieces of one pass that clear it
  std::vector<double> distances_;  ///< scratch, mm
  std::vector<Remains> remains_;   ///< by pass
};

}  // namespace

std::optional<LayerPasses> without_air_cuts(const LayerPasses& layer, const AirCutJob& job) {
  if (layer.passes.empty() || layer.target.empty()) return std::nullopt;
  const bool is_any_gain_welcome = job.most_left >= 1;
  if (!is_any_gain_welcome &&
      Trimming(layer, job, kCoarse).share_left_by_witnesses() > job.most_left - kHopeful)
    return std::nullopt;
  return Trimming(layer, job, 1).run();
}

}  // namespace clearcut::plan
