#include "link/link.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/error.h"
#include "link/entry.h"
#include "toolpath/legal_area.h"

namespace clearcut {
namespace {

/// mm over the material where ramps and helices begin.
constexpr double kEntryHeight = 0.2;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A place on a pass where cutting may begin.
struct Start {
  Vec2 point;
  std::size_t edge = 0;  ///< closed passes: the edge it lies on
  double t = 0;
  bool backwards = false;  ///< open passes: from the last point to the first
};

/// The closed path, begun at `start`.
Path rotated_to(const Path& path, const Start& start) {
  const Edge& edge = path[start.edge];
  const double margin = 1e-6 / edge.length();
  Path out;
  std::size_t first = start.edge;
  const bool split = start.t > margin && start.t < 1 - margin;
  if (split) out.push_back(edge.part(start.t, 1));
  if (split || start.t >= 1 - margin) ++first;
  const std::size_t whole = split ? path.size() - 1 : path.size();
  for (std::size_t i = 0; i < whole; ++i) out.push_back(path[(first + i) % path.size()]);
  if (split) out.push_back(edge.part(0, start.t));
  return out;
}

Start nearest_start(const Pass& pass, Vec2 p) {
  Start best;
  if (!pass.closed) {
    best.backwards =
        pass.reversible && distance(pass.path.back().to, p) < distance(pass.path.front().from, p);
    best.point = best.backwards ? pass.path.back().to : pass.path.front().from;
    return best;
  }
  double nearest_distance = kInfinity;
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    const auto on = nearest(pass.path[i], p);
    if (on.distance >= nearest_distance) continue;
    nearest_distance = on.distance;
    best = {on.point, i, on.t, false};
  }
  return best;
}

/// Seconds from standstill to standstill over `length` at no more than `speed` mm/s.
double travel_time(double length, double speed, double acceleration) {
  if (length <= 0) return 0;
  const double full = speed * speed / acceleration;
  return length < full ? 2 * std::sqrt(length / acceleration) : length / speed + speed / acceleration;
}

/// Which passes have to come before a pass.
enum class Precedence { kInnerFirst, kOuterFirst };

/// One layer being cut: its passes, what is done, and where moves may go.
class LayerState {
 public:
  explicit LayerState(const LayerPasses& layer, double radius)
      : layer_(layer), legal_(layer.legal), done_(layer.passes.size(), false), boxes_(layer.passes.size()) {
    const Box target = clearcut::box(layer.target);
    open_ = !target.empty() && !target.grown(-radius / 2).contains(legal_.box().min);
    open_ = open_ || (!target.empty() && !target.grown(-radius / 2).contains(legal_.box().max));
    waiting_for_.assign(layer.passes.size(), 0);
    for (std::size_t i = 0; i < layer.passes.size(); ++i) {
      boxes_[i] = clearcut::box(layer.passes[i].path);
      if (const int before = prerequisite_edge(i); before >= 0)
        ++waiting_for_[static_cast<std::size_t>(before)];
    }
  }

  const LayerPasses& layer() const { return layer_; }
  const LegalArea& legal() const { return legal_; }
  bool open() const { return open_; }
  const Pass& pass(std::size_t i) const { return layer_.passes[i]; }
  const Box& box(std::size_t i) const { return boxes_[i]; }
  bool available(std::size_t i) const { return !done_[i] && waiting_for_[i] == 0; }
  bool finished() const {
    return std::all_of(done_.begin(), done_.end(), [](bool d) { return d; });
  }

  void mark_done(std::size_t i) {
    done_[i] = true;
    for (std::size_t k = 0; k < layer_.passes.size(); ++k) {
      if (depends(k, i)) --waiting_for_[k];
    }
  }

  /// Outer rings of open layers are cut from the air inwards, so they run the other way round.
  bool turned_round(std::size_t i) const {
    return pass(i).closed && precedence_to_children(i) == Precedence::kOuterFirst;
  }

 private:
  Precedence precedence_to_children(std::size_t i) const {
    return open_ && pass(i).closed && signed_area(pass(i).path) > 0 ? Precedence::kOuterFirst
                                                                    : Precedence::kInnerFirst;
  }

  /// The tree edge between i and its parent: which of the two has to wait; -1 without a parent.
  int prerequisite_edge(std::size_t i) const {
    const int parent = pass(i).parent;
    if (parent < 0) return -1;
    return precedence_to_children(static_cast<std::size_t>(parent)) == Precedence::kOuterFirst
               ? static_cast<int>(i)
               : parent;
  }

  bool depends(std::size_t later, std::size_t earlier) const {
    const int l = static_cast<int>(later), e = static_cast<int>(earlier);
    return (pass(later).parent == e && prerequisite_edge(later) == l) ||
           (pass(earlier).parent == l && prerequisite_edge(earlier) == l);
  }

  const LayerPasses& layer_;
  LegalArea legal_;
  bool open_ = false;
  std::vector<bool> done_;
  std::vector<Box> boxes_;
  std::vector<int> waiting_for_;
};

class Linker {
 public:
  Linker(const LinkOptions& options) : options_(options) {}

  void cut_layer(LayerState& state, const LayerState* above) {
    while (!state.finished()) {
      const Choice next = choose(state, above);
      CLEARCUT_ASSERT(next.pass < state.layer().passes.size());
      go_to(next, state, above);
      cut(oriented(state, next), state.pass(next.pass).kinds, state.layer().z);
      state.mark_done(next.pass);
    }
  }

  void finish() {
    if (!moves_.empty()) vertical(options_.safe_z, MoveKind::kRapid, {});
  }

  std::vector<Move> take_moves() { return std::move(moves_); }

 private:
  struct Choice {
    std::size_t pass = std::numeric_limits<std::size_t>::max();
    Start start;
    bool stay_down = false;
    double cost = kInfinity;
  };

  bool running() const { return !moves_.empty(); }

  double rapid_speed() const { return options_.machine.rapid.mm_per_s(); }

  /// Seconds to lift, cross and come down again.
  double hop_time(Vec2 to, const LayerState& state, const LayerState* above) const {
    const double a = options_.machine.acceleration;
    const double height = hop_height(to, state, above);
    const double up = travel_time(height - z_, rapid_speed(), a);
    const double across = travel_time(distance(at_, to), rapid_speed(), a);
    const double start_z = approach_z(to, state);
    const double down = travel_time(height - start_z, rapid_speed(), a);
    return up + across + down + (start_z - state.layer().z) / options_.plunge_feed.mm_per_s();
  }

  /// Rapids may cross just over the layer where the cutter stays within the pocket all along the way; in the
  /// layer above it has cut everything there. From a lower layer it could meet what that left.
  double hop_height(Vec2 to, const LayerState& state, const LayerState* above) const {
    const double low = state.layer().z_top + options_.above_material;
    const bool clear = above == nullptr || above->layer().film == 0;
    return clear && low < options_.safe_z && state.legal().holds_line(at_, to) ? low : options_.safe_z;
  }

  /// Where a rapid down has to end over `p`.
  double approach_z(Vec2 p, const LayerState& state) const {
    return (in_air(p) ? state.layer().z : state.layer().z_top) + options_.above_material;
  }

  bool in_air(Vec2 p) const {
    return options_.stock && options_.stock->distance_to(p) >= options_.tool_radius;
  }

  Choice choose(const LayerState& state, const LayerState* above) const {
    if (!running() || (z_ != state.layer().z && state.open())) return first_choice(state);
    Choice best;
    for (std::size_t i = 0; i < state.layer().passes.size(); ++i) {
      if (!state.available(i)) continue;
      const double least = state.box(i).distance_to(at_) / options_.feed.mm_per_s();
      if (std::min(least, 0.5) > best.cost) continue;
      const Choice candidate = evaluate(i, state, above);
      if (candidate.cost < best.cost) best = candidate;
    }
    return best;
  }

  Choice evaluate(std::size_t i, const LayerState& state, const LayerState* above) const {
    Choice choice;
    choice.pass = i;
    choice.start = nearest_start(state.pass(i), at_);
    choice.cost = hop_time(choice.start.point, state, above);
    const double down = distance(at_, choice.start.point) / options_.feed.mm_per_s();
    if (z_ == state.layer().z && down < choice.cost && state.legal().holds_line(at_, choice.start.point)) {
      choice.stay_down = true;
      choice.cost = down;
    }
    return choice;
  }

  /// The first pass of all, or of an open layer: from the air if there is any beside it.
  Choice first_choice(const LayerState& state) const {
    Choice first;
    for (std::size_t i = 0; i < state.layer().passes.size(); ++i) {
      if (!state.available(i)) continue;
      Choice candidate;
      candidate.pass = i;
      const auto& path = state.pass(i).path;
      candidate.start = {path.front().from, 0, 0, false};
      candidate.cost = -state.pass(i).offset;  // farthest from the wall
      if (state.open() && find_air_entry(path, state)) candidate.cost -= 1e6;
      if (candidate.cost < first.cost) first = candidate;
    }
    if (first.pass < state.layer().passes.size() && state.open() && state.pass(first.pass).closed) {
      if (const auto entry = find_air_entry(state.pass(first.pass).path, state)) first.start = entry->start;
    }
    return first;
  }

  struct AirEntry {
    Start start;
    Vec2 outside;
  };

  std::optional<AirEntry> find_air_entry(const Path& path, const LayerState& state) const {
    for (std::size_t i = 0; i < path.size(); ++i) {
      for (const double t : {0.5, 0.0}) {
        const Start start{path[i].at(t), i, t, false};
        if (const auto outside = way_out(start.point, state)) return AirEntry{start, *outside};
      }
    }
    return std::nullopt;
  }

  /// A point beside the stock from which a straight legal move leads to p.
  std::optional<Vec2> way_out(Vec2 p, const LayerState& state) const {
    if (!options_.stock) return std::nullopt;
    if (in_air(p)) return p;
    const Box beyond = options_.stock->grown(options_.tool_radius + options_.above_material);
    const Vec2 outs[] = {{beyond.min.x, p.y}, {beyond.max.x, p.y}, {p.x, beyond.min.y}, {p.x, beyond.max.y}};
    std::optional<Vec2> best;
    for (const Vec2 out : outs) {
      if (best && distance(p, out) >= distance(p, *best)) continue;
      if (state.legal().holds_line(out, p)) best = out;
    }
    return best;
  }

  void go_to(const Choice& next, const LayerState& state, const LayerState* above) {
    const Vec2 p = next.start.point;
    if (next.stay_down) return line_to(p, MoveKind::kLink, options_.feed);
    const auto outside = state.open() ? way_out(p, state) : std::nullopt;
    const Vec2 entry = outside.value_or(p);
    rise_and_cross(entry, running() ? hop_height(entry, state, above) : options_.safe_z);
    vertical(approach_z(entry, state), MoveKind::kRapid, {});
    if (in_air(entry)) {
      vertical(state.layer().z, MoveKind::kPlunge, options_.plunge_feed);
      return line_to(p, MoveKind::kLeadIn, options_.feed);
    }
    enter_material(next, state);
  }

  /// From a little above the material down into it, as the entry option says.
  void enter_material(const Choice& next, const LayerState& state) {
    const Pass& pass = state.pass(next.pass);
    vertical(std::min(z_, state.layer().z_top + kEntryHeight), MoveKind::kPlunge, options_.plunge_feed);
    const Edge first = oriented(state, next).front();
    const Vec2 heading = first.from == first.to ? Vec2{1, 0} : first.tangent_at(0);
    const EntryPlace place{at_, heading, z_, state.layer().z, pass.entry_center};
    const auto moves = entry_moves(place, state.layer().legal, options_);
    moves_.insert(moves_.end(), moves.begin(), moves.end());
    z_ = state.layer().z;
  }

  void rise_and_cross(Vec2 to, double height) {
    if (!running()) {
      at_ = to;
      z_ = height;
      return;
    }
    vertical(height, MoveKind::kRapid, {});
    if (at_ == to) return;
    moves_.push_back({Edge::line(at_, to), z_, z_, MoveKind::kRapid, {}, 0});
    at_ = to;
  }

  void vertical(double z, MoveKind kind, MmPerMin feed) {
    if (z == z_) return;
    moves_.push_back({Edge::line(at_, at_), z_, z, kind, feed, 0});
    z_ = z;
  }

  void line_to(Vec2 p, MoveKind kind, MmPerMin feed) {
    if (p == at_) return;
    moves_.push_back({Edge::line(at_, p), z_, z_, kind, feed, 0});
    at_ = p;
  }

  Path oriented(const LayerState& state, const Choice& next) const {
    const Pass& pass = state.pass(next.pass);
    Path path = pass.closed ? rotated_to(pass.path, next.start) : pass.path;
    const bool climbs = (options_.direction == CutDirection::kClimb) == options_.spindle_clockwise;
    const bool back = pass.closed ? climbs == state.turned_round(next.pass) : next.start.backwards;
    return back ? reversed(path) : path;
  }

  void cut(const Path& path, const std::vector<MoveKind>& kinds, double z) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      Edge joined = path[i];
      if (i == 0) joined.from = at_;           // the same point to rounding
      if (joined.from == joined.to) continue;  // a place where the cutter just fits: plunged into
      const MoveKind kind = kinds.empty() ? MoveKind::kCut : kinds[i];
      moves_.push_back(
          {joined, z, z, kind, kind == MoveKind::kLink ? options_.machine.rapid : options_.feed, 0});
      at_ = joined.to;
    }
  }

  const LinkOptions& options_;
  std::vector<Move> moves_;
  Vec2 at_;
  double z_ = 0;
};

}  // namespace

Section link_layers(const std::vector<LayerPasses>& layers, const LinkOptions& options, const Tolerances&) {
  Linker linker(options);
  std::unique_ptr<LayerState> above;
  for (const auto& layer : layers) {
    auto state = std::make_unique<LayerState>(layer, options.tool_radius);
    linker.cut_layer(*state, above.get());
    above = std::move(state);
  }
  linker.finish();
  Section section;
  section.spindle_clockwise = options.spindle_clockwise;
  section.moves = linker.take_moves();
  return section;
}

}  // namespace clearcut
