#include "link/link.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "base/error.h"
#include "base/units.h"
#include "link/entry.h"
#include "link/lead.h"
#include "link/moves.h"
#include "toolpath/kinematics.h"
#include "toolpath/legal_area.h"

namespace clearcut {
namespace {

/// mm over the material where ramps and helices begin.
constexpr double kEntryHeight = 0.2;
/// mm. A cutter may be this much wider than a predrilled hole.
constexpr double kHoleSlack = 0.001;

/// mm. Nearer to the boundary of the legal area the cutter is at the wall.
constexpr double kAtWall = 0.05;
/// In which that is looked for.
constexpr int kDirections = 16;

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
  bool turned_round(std::size_t i) const { return outside_first(i); }

 private:
  bool outside_first(std::size_t i) const { return open_ && pass(i).closed && signed_area(pass(i).path) > 0; }

  Precedence precedence_to_children(std::size_t i) const {
    return layer_.outside_in || outside_first(i) ? Precedence::kOuterFirst : Precedence::kInnerFirst;
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
      cut_pass(next, state, above);
      state.mark_done(next.pass);
    }
  }

  /// What was asked for and did not fit, in words.
  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    const auto tell = [&](int times, const std::string& what) {
      if (times > 0)
        notes.push_back(what + " (" + std::to_string(times) + (times == 1 ? " place)" : " places)"));
    };
    const auto other = [&](EntryKind kind) { return options_.entry != kind ? entries_[index_of(kind)] : 0; };
    tell(other(EntryKind::kRamp), "the entry asked for does not fit; ramped along the pass");
    tell(other(EntryKind::kZigzagRamp), "the entry asked for does not fit; ramped to and fro");
    tell(other(EntryKind::kPlunge), options_.may_plunge
                                        ? "the entry asked for does not fit; plunged"
                                        : "no ramp fits and the cutter may not plunge; plunged");
    tell(without_lead_, "no lead fits at the wall");
    return notes;
  }

  void finish() {
    if (running()) moves_.vertical(options_.safe_z, MoveKind::kRapid, {});
  }

  std::vector<Move> take_moves() { return moves_.take(); }

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
    const double up = travel_time(height - moves_.z(), rapid_speed(), a);
    const double across = travel_time(distance(moves_.at(), to), rapid_speed(), a);
    const double start_z = approach_z(to, state);
    const double down = travel_time(height - start_z, rapid_speed(), a);
    return up + across + down + (start_z - state.layer().z) / options_.plunge_feed.mm_per_s();
  }

  /// Rapids may cross just over the layer where the cutter stays within the pocket all along the way; in the
  /// layer above it has cut everything there. From a lower layer it could meet what that left.
  double hop_height(Vec2 to, const LayerState& state, const LayerState* above) const {
    const double top = std::max(state.layer().z_top, state.layer().wall_top.value_or(state.layer().z_top));
    const double low = top + options_.above_material;
    const bool clear = above == nullptr || above->layer().film == 0;
    return clear && low < options_.safe_z && state.legal().holds_line(moves_.at(), to) ? low
                                                                                       : options_.safe_z;
  }

  /// Where a rapid down has to end over `p`.
  double approach_z(Vec2 p, const LayerState& state) const {
    if (in_air(p)) return state.layer().z + options_.above_material;
    const auto wall_top = state.layer().wall_top;
    const double top =
        wall_top && is_at_wall(p, state) ? std::max(*wall_top, state.layer().z_top) : state.layer().z_top;
    return top + options_.above_material;
  }

  static bool is_at_wall(Vec2 p, const LayerState& state) {
    for (int i = 0; i < kDirections; ++i) {
      if (!state.legal().contains(p + direction_of(2 * kPi * i / kDirections) * kAtWall)) return true;
    }
    return false;
  }

  /// Beside the stock, or in a predrilled hole.
  bool in_air(Vec2 p) const {
    if (options_.stock && options_.stock->distance_to(p) >= options_.tool_radius) return true;
    return std::any_of(
        options_.predrilled.begin(), options_.predrilled.end(), [&](const PredrilledHole& hole) {
          return distance(p, hole.center) + options_.tool_radius <= hole.diameter / 2 + kHoleSlack;
        });
  }

  Choice choose(const LayerState& state, const LayerState* above) const {
    if (!running() || (moves_.z() != state.layer().z && state.open())) return first_choice(state);
    Choice best;
    for (std::size_t i = 0; i < state.layer().passes.size(); ++i) {
      if (!state.available(i)) continue;
      const double least = state.box(i).distance_to(moves_.at()) / options_.feed.mm_per_s();
      if (std::min(least, 0.5) > best.cost) continue;
      const Choice candidate = evaluate(i, state, above);
      if (candidate.cost < best.cost) best = candidate;
    }
    return best;
  }

  Choice evaluate(std::size_t i, const LayerState& state, const LayerState* above) const {
    Choice choice;
    choice.pass = i;
    choice.start = nearest_start(state.pass(i), moves_.at());
    choice.cost = hop_time(choice.start.point, state, above);
    const double down = distance(moves_.at(), choice.start.point) / options_.feed.mm_per_s();
    if (state.pass(i).may_cut_to_start && moves_.z() == state.layer().z && down < choice.cost &&
        state.legal().holds_line(moves_.at(), choice.start.point)) {
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
      if (state.layer().start) {
        candidate.start = nearest_start(state.pass(i), *state.layer().start);
        candidate.cost = distance(candidate.start.point, *state.layer().start);
      }
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

  /// The nearest predrilled hole from which a straight legal move leads to p.
  std::optional<Vec2> way_from_hole(Vec2 p, const LayerState& state) const {
    std::optional<Vec2> best;
    for (const PredrilledHole& hole : options_.predrilled) {
      if (!in_air(hole.center) || (best && distance(p, hole.center) >= distance(p, *best))) continue;
      if (state.legal().holds_line(hole.center, p)) best = hole.center;
    }
    return best;
  }

  /// A point beside the stock or in a predrilled hole from which a straight legal move leads to p.
  std::optional<Vec2> way_out(Vec2 p, const LayerState& state) const {
    if (in_air(p)) return p;
    if (const auto hole = way_from_hole(p, state)) return hole;
    if (!options_.stock || !state.open()) return std::nullopt;
    const Box beyond = options_.stock->grown(options_.tool_radius + options_.above_material);
    const Vec2 outs[] = {{beyond.min.x, p.y}, {beyond.max.x, p.y}, {p.x, beyond.min.y}, {p.x, beyond.max.y}};
    std::optional<Vec2> best;
    for (const Vec2 out : outs) {
      if (best && distance(p, out) >= distance(p, *best)) continue;
      if (state.legal().holds_line(out, p)) best = out;
    }
    return best;
  }

  void cut_pass(Choice next, const LayerState& state, const LayerState* above) {
    if (!next.stay_down && state.open()) start_from_air(next, state);
    const Pass& pass = state.pass(next.pass);
    Path path = oriented(state, next);
    std::optional<Lead> lead;
    if (options_.lead_radius > 0 && runs_along_wall(pass)) {
      lead = lead_for(path, state.layer().legal, options_.lead_radius);
      if (lead && next.stay_down && !state.legal().holds_line(moves_.at(), lead->in.from)) lead.reset();
      if (!lead) ++without_lead_;
    }
    if (lead) {
      path = begun_at(path, lead->along);
      next.start.point = lead->in.from;
    }
    const bool on_ring = pass.closed && pass.kinds.empty() && !lead;
    const double along = go_to(next, lead ? Path{lead->in} : path, on_ring, state, above);
    if (along > 0) path = begun_at(path, along);
    if (lead) cut({lead->in}, {MoveKind::kLeadIn});
    cut(path, pass.kinds);
    if (lead) cut({lead->out}, {MoveKind::kLeadOut});
  }

  static bool runs_along_wall(const Pass& pass) {
    return pass.closed && pass.parent < 0 && pass.kinds.empty() && !pass.entry_center;
  }

  /// A ring that is entered anew begins where air leads to it, if it does anywhere.
  void start_from_air(Choice& next, const LayerState& state) const {
    const Pass& pass = state.pass(next.pass);
    if (!pass.closed || !pass.kinds.empty() || way_out(next.start.point, state)) return;
    if (const auto entry = find_air_entry(pass.path, state)) next.start = entry->start;
  }

  /// To the beginning of `path` at depth; mm along it where the depth is reached, if it is a ring that was ramped along.
  double go_to(const Choice& next, const Path& path, bool is_ring, const LayerState& state,
               const LayerState* above) {
    const Vec2 p = next.start.point;
    if (next.stay_down) {
      link_to(p);
      return 0;
    }
    const bool straight = state.pass(next.pass).may_cut_to_start || in_air(p);
    const auto outside = straight ? way_out(p, state) : std::nullopt;
    const Vec2 entry = outside.value_or(p);
    rise_and_cross(entry, running() ? hop_height(entry, state, above) : options_.safe_z);
    moves_.vertical(approach_z(entry, state), MoveKind::kRapid, {});
    if (!outside)
      return enter_material(path, is_ring ? &path : nullptr, state.pass(next.pass).entry_center, state);
    moves_.vertical(state.layer().z, MoveKind::kPlunge, options_.plunge_feed);
    moves_.line(p, MoveKind::kLeadIn, lead_feed());
    return 0;
  }

  void link_to(Vec2 p) {
    if (p == moves_.at()) return;
    const double depth = moves_.z();
    const MmPerMin feed = options_.link_feed.value_or(options_.feed);
    if (options_.link_lift > 0) moves_.vertical(depth + options_.link_lift, MoveKind::kLink, feed);
    moves_.line(p, MoveKind::kLink, feed);
    moves_.vertical(depth, MoveKind::kPlunge, options_.plunge_feed);
  }

  /// From a little above the material down into it, as the entry option says. See go_to for what comes back.
  double enter_material(const Path& path, const Path* ring, std::optional<Vec2> center,
                        const LayerState& state) {
    moves_.vertical(std::min(moves_.z(), state.layer().z_top + kEntryHeight), MoveKind::kPlunge,
                    options_.plunge_feed);
    const Edge first = path.front();
    const Vec2 heading = first.from == first.to ? Vec2{1, 0} : first.tangent_at(0);
    const EntryPlace place{moves_.at(), heading, moves_.z(), state.layer().z, center, ring};
    const Entry entry = entry_at(place, state.layer().legal, options_);
    moves_.append(entry.moves);
    ++entries_[index_of(entry.kind)];
    return entry.along_ring;
  }

  static std::size_t index_of(EntryKind kind) { return static_cast<std::size_t>(kind); }
  MmPerMin lead_feed() const { return options_.lead_feed.value_or(options_.feed); }

  void rise_and_cross(Vec2 to, double height) {
    if (!running()) {
      moves_ = MoveList(to, height);
      return;
    }
    moves_.vertical(height, MoveKind::kRapid, {});
    moves_.line(to, MoveKind::kRapid, {});
  }

  Path oriented(const LayerState& state, const Choice& next) const {
    const Pass& pass = state.pass(next.pass);
    Path path = pass.closed ? rotated_to(pass.path, next.start) : pass.path;
    const bool climbs = (options_.direction == CutDirection::kClimb) == options_.spindle_clockwise;
    const bool back = pass.closed ? climbs == state.turned_round(next.pass) : next.start.backwards;
    return back ? reversed(path) : path;
  }

  void cut(const Path& path, const std::vector<MoveKind>& kinds) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      Edge joined = path[i];
      if (i == 0) joined.from = moves_.at();   // the same point to rounding
      if (joined.from == joined.to) continue;  // a place where the cutter just fits: plunged into
      const MoveKind kind = kinds.empty() ? MoveKind::kCut : kinds[i];
      moves_.along(joined, kind, feed_of(kind));
    }
  }

  MmPerMin feed_of(MoveKind kind) const {
    if (kind == MoveKind::kLink) return options_.link_feed.value_or(options_.machine.rapid);
    return kind == MoveKind::kLeadIn || kind == MoveKind::kLeadOut ? lead_feed() : options_.feed;
  }

  const LinkOptions& options_;
  MoveList moves_{{}, 0};
  std::array<int, 4> entries_{};  ///< into material, by kind
  int without_lead_ = 0;
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
  section.notes = linker.notes();
  return section;
}

}  // namespace clearcut
