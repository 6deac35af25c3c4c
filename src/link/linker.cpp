#include "link/linker.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/units.h"
#include "kinematics/kinematics.h"
#include "link/entry.h"
#include "order/search/visit_order.h"

namespace clearcut::link {
namespace {

/// mm above the material at which ramps and helices begin.
constexpr double kEntryHeight = 0.2;
/// mm. A cutter nearer than this to the boundary of the legal area is at the wall.
constexpr double kAtWall = 0.05;
/// Number of directions in which the boundary is searched.
constexpr int kDirections = 16;

/// Seconds. Above the rounding of times.
constexpr double kRounding = 1e-9;

/// Advantage, in seconds, of an entry beside the material over one into the material.
constexpr double kAirWorth = 1e6;

std::size_t index_of(EntryKind kind) {
  return static_cast<std::size_t>(kind);
}

bool runs_along_wall(const Pass& pass) {
  return pass.closed && pass.parent < 0 && pass.kinds.empty() && !pass.entry_center;
}

/// Seconds of a rapid move over `length` mm.
double rapid_time(double length, const Machine& machine) {
  return kinematics::travel_time(length, machine.rapid.mm_per_s(), machine.acceleration);
}

bool is_at_wall(Vec2 p, const LegalArea& legal) {
  for (int i = 0; i < kDirections; ++i) {
    if (!legal.contains(p + direction_of(2 * kPi * i / kDirections) * kAtWall)) return true;
  }
  return false;
}

MmPerMin feed_of(MoveKind kind, const LinkOptions& options) {
  const Machine& machine = options.machine;
  const bool is_slower = machine.max_feed && *machine.max_feed < machine.rapid;
  if (kind == MoveKind::kLink)
    return options.link_feed.value_or(is_slower ? *machine.max_feed : machine.rapid);
  const bool leads = kind == MoveKind::kLeadIn || kind == MoveKind::kLeadOut;
  return leads ? options.lead_feed.value_or(options.feed) : options.feed;
}

/// mm; the height of rapids to a pass if the cutter stays inside the pocket: just above the layer, because the layer
/// above is cut there. A rapid starting from a lower layer could meet residuals of the layer above.
double inside_height(const Work& work, const LinkOptions& options, const CutterAt& from, std::size_t item) {
  const LayerPasses& passes = work.layer_of(item).layer();
  const std::size_t index = work.items()[item].layer;
  const double top = std::max({passes.z_top, passes.wall_top.value_or(passes.z_top), from.z});
  const bool clear = index == 0 || work.layer(index - 1).layer().residual == 0;
  return clear ? std::min(top + options.above_material, options.cross_z) : options.cross_z;
}

/// Least time, in seconds, of a retract link to a pass whose box is `apart` mm away.
double least_retract_time(const Work& work, const LinkOptions& options, const CutterAt& from,
                          std::size_t item, double apart) {
  const double up = inside_height(work, options, from, item) - from.z;
  return rapid_time(up, options.machine) + rapid_time(apart, options.machine);
}

/// Whether the previous pass ended with the cutter at p, at a height in this range. If the cutter has only descended
/// there, the chips must be cleared first.
bool stand_over(const MoveList& moves, Vec2 p, double z_low, double z_high) {
  return !moves.empty() && !moves.ends_upright() && moves.at() == p && moves.z() > z_low &&
         moves.z() < z_high;
}

}  // namespace

void Linker::cut_nearest_first() {
  while (!progress_.finished()) {
    const Candidate next = choose();
    CLEARCUT_ASSERT(next.item < work_.items().size());
    cut_pass(next);
  }
}

void Linker::cut_in_order(const std::vector<Task>& tasks) {
  for (const Task& task : tasks) {
    CLEARCUT_ASSERT(progress_.available(task.item));
    const Pass& pass = work_.pass(task.item);
    cut_pass(evaluate(task.item, task.start ? *task.start : nearest_start(pass, moves_.at())));
  }
}

std::vector<std::string> Linker::notes() const {
  std::vector<std::string> notes;
  const auto tell = [&](int times, const std::string& what) {
    if (times > 0)
      notes.push_back(what + " (" + std::to_string(times) + (times == 1 ? " place)" : " places)"));
  };
  const auto other = [&](EntryKind kind) { return options_.entry != kind ? entries_[index_of(kind)] : 0; };
  tell(other(EntryKind::kHelix),
       "adaptive clearing goes down by a helix, which its first cuts widen, not by the entry asked for");
  tell(other(EntryKind::kRamp), "the entry asked for does not fit; ramped along the pass");
  tell(other(EntryKind::kZigzagRamp), "the entry asked for does not fit; ramped to and fro");
  tell(other(EntryKind::kPlunge), options_.may_plunge
                                      ? "the entry asked for does not fit; plunged"
                                      : "no ramp fits and the cutter may not plunge; plunged");
  tell(without_lead_, "no lead fits at the wall");
  return notes;
}

std::vector<Move> Linker::take_moves() {
  if (running()) moves_.vertical(options_.safe_z, MoveKind::kRapid, {});
  return moves_.take();
}

/// Seconds to retract to `height`, cross, and descend again.
double Linker::retract_time(const CutterAt& from, const Beginning& to, double height) const {
  const auto rapid = [this](double length) { return rapid_time(length, options_.machine); };
  const double up = rapid(height - from.z), across = rapid(distance(from.at, to.point));
  const double down = rapid(height - to.rapid_z);
  return up + across + down + (to.rapid_z - layer(to.item).layer().z) / options_.plunge_feed.mm_per_s();
}

/// Seconds of a straight move at depth; infinite if the cutter is not at that depth or may not cut to the
/// pass.
double Linker::straight_time(const CutterAt& from, const Beginning& to) const {
  const bool may_stay = work_.pass(to.item).may_cut_to_start && from.z == layer(to.item).layer().z;
  return may_stay ? distance(from.at, to.point) / options_.feed.mm_per_s()
                  : std::numeric_limits<double>::infinity();
}

double Linker::travel(const CutterAt& from, const Beginning& to, bool low) const {
  if (!low) return retract_time(from, to, options_.cross_z);
  const double retract = retract_time(from, to, retract_height(from, to.point, to.item));
  const double down = straight_time(from, to);
  return down < retract && layer(to.item).legal().holds_line(from.at, to.point) ? down : retract;
}

/// mm; the height of rapids to the next pass.
double Linker::retract_height(const CutterAt& from, Vec2 to, std::size_t item) const {
  const double inside = inside_height(work_, options_, from, item);
  return inside < options_.cross_z && access_paths().is_clear(item, from.at, to) ? inside : options_.cross_z;
}

/// mm; the height at which a rapid down over `p` must end.
double Linker::approach_z(Vec2 p, std::size_t item) const {
  const LayerPasses& passes = layer(item).layer();
  if (access_paths().in_air(p)) return passes.z + options_.above_material;
  const double top = passes.wall_top && is_at_wall(p, layer(item).legal())
                         ? std::max(*passes.wall_top, passes.z_top)
                         : passes.z_top;
  return top + options_.above_material;
}

Linker::Candidate Linker::choose() const {
  const auto& items = work_.items();
  std::size_t first = 0;
  while (first < items.size() && !progress_.available(first)) ++first;
  if (!running() || (layer(first).open() && moves_.z() != layer(first).layer().z)) return first_candidate();
  Candidate best;
  for (std::size_t i = first; i < items.size(); ++i) {
    if (!progress_.available(i)) continue;
    const double apart = items[i].path.distance_to(moves_.at()), least = apart / options_.feed.mm_per_s();
    if (std::min(least, 0.5) > best.cost) continue;
    if (std::min(least, least_retract_time(work_, options_, here(), i, apart)) > best.cost + kRounding)
      continue;
    const PassStart start = nearest_start(work_.pass(i), moves_.at());
    // Whether the link is clear of material is tested only for the few candidates that may be the best: this test is
    // the costliest with many candidates.
    if (least_cost(i, start) >= best.cost) continue;
    const Candidate candidate = evaluate(i, start);
    if (candidate.cost < best.cost) best = candidate;
  }
  return best;
}

/// Seconds of the link to a pass if the link is clear of material.
double Linker::least_cost(std::size_t item, const PassStart& start) const {
  const Beginning to = beginning(item, start.point);
  return std::min(retract_time(here(), to, inside_height(work_, options_, here(), item)),
                  straight_time(here(), to));
}

Linker::Candidate Linker::evaluate(std::size_t item, const PassStart& start) const {
  Candidate candidate;
  candidate.item = item;
  candidate.start = start;
  if (!running()) return candidate;
  const Beginning to = beginning(item, start.point);
  const double inside = inside_height(work_, options_, here(), item), down = straight_time(here(), to);
  candidate.cost = retract_time(here(), to, options_.cross_z);
  if (inside >= options_.cross_z && down >= candidate.cost) return candidate;
  if (!access_paths().is_clear(item, moves_.at(), start.point)) return candidate;
  if (inside < options_.cross_z) candidate.cost = retract_time(here(), to, inside);
  candidate.stay_down = down < candidate.cost;
  candidate.cost = std::min(candidate.cost, down);
  return candidate;
}

/// The first pass of all, or of an open layer: one that can be entered from the air if possible.
Linker::Candidate Linker::first_candidate() const {
  Candidate first;
  for (std::size_t i = 0; i < work_.items().size(); ++i) {
    if (!progress_.available(i)) continue;
    const Pass& pass = work_.pass(i);
    Candidate candidate;
    candidate.item = i;
    candidate.start = {pass.path.front().from, 0, 0, false};
    candidate.cost = -pass.start_priority;
    if (const auto wanted = layer(i).layer().start) {
      candidate.start = nearest_start(pass, *wanted);
      candidate.cost = distance(candidate.start.point, *wanted);
    }
    if (layer(i).open() && access_paths().start_before_air(i)) candidate.cost -= kAirWorth;
    if (candidate.cost < first.cost) first = candidate;
  }
  return first;
}

void Linker::cut_pass(Candidate next) {
  if (!next.stay_down && layer(next.item).open()) start_from_air(next);
  const Pass& pass = work_.pass(next.item);
  Path path = oriented(next);
  const PassStart start = next.start;
  const auto lead = lead_for_pass(path, next);
  if (lead) {
    path = begun_at(path, lead->along);
    next.start.point = lead->in.from;
  }
  const bool on_ring = pass.closed && pass.kinds.empty() && !lead;
  const double along = go_to(next, lead ? Path{lead->in} : path, on_ring);
  if (along > 0) path = begun_at(path, along);
  if (runs_along_wall(pass)) path = overlapped(std::move(path), options_.lead.overlap);
  if (lead) cut({lead->in}, {MoveKind::kLeadIn});
  cut(path, pass.kinds);
  if (lead) cut({lead->out}, {MoveKind::kLeadOut});
  cuts_.push_back({next.item, start, next.start.point, moves_.at(), next.stay_down});
  progress_.mark_done(next.item);
  cleared_.add(moves_);
}

std::optional<Lead> Linker::lead_for_pass(const Path& path, const Candidate& next) {
  if (options_.lead.size <= 0 || !runs_along_wall(work_.pass(next.item))) return std::nullopt;
  const LayerWork& where = layer(next.item);
  LeadShape shape = options_.lead;
  shape.room = where.layer().cleared_beyond.value_or(0);
  if (!options_.may_plunge) shape.slot = where.layer().cleared_to.value_or(HUGE_VAL);
  auto lead = lead_for(path, where.layer().legal, shape);
  if (lead && next.stay_down && !where.legal().holds_line(moves_.at(), lead->in.from)) lead.reset();
  if (lead && !options_.may_plunge && plunges_into_material(*lead, next)) lead.reset();
  if (!lead) ++without_lead_;
  return lead;
}

/// Whether no ramp fits to the beginning of the lead, where material stands: along the pass itself there is more room.
bool Linker::plunges_into_material(const Lead& lead, const Candidate& next) const {
  const Vec2 start = lead.in.from;
  if (next.stay_down || !stands_before(start, next.item) || access_to(start, next.item)) return false;
  const Path path{lead.in};
  return entry_into(entry_place(start, path, nullptr, next.item), next.item).kind == EntryKind::kPlunge;
}

/// For a pass that needs an entry: moves its start to a place reachable from the air, if there is one.
void Linker::start_from_air(Candidate& next) const {
  const Pass& pass = work_.pass(next.item);
  if (access_paths().air_before(next.start.point, next.item)) return;
  if (pass.closed && pass.kinds.empty()) {
    auto start = access_paths().start_before_air(next.item);
    if (!start && access_paths().cleared_before(next.start.point, next.item)) return;
    if (!start) start = access_paths().start_before_cleared(next.item);
    if (!start) start = access_paths().start_on_access_path(next.start, next.item);
    if (start) next.start = *start;
  } else if (!pass.closed && pass.reversible) {
    const Vec2 other = next.start.backwards ? pass.path.front().from : pass.path.back().to;
    if (access_paths().air_before(other, next.item)) next.start = {other, 0, 0, !next.start.backwards};
  }
}

/// Moves to the beginning of `path` at depth. For a ramp along a ring, returns the mm along the ring at which the
/// depth is reached.
double Linker::go_to(const Candidate& next, const Path& path, bool is_ring) {
  const Vec2 p = next.start.point;
  if (next.stay_down) {
    link_to(p);
    return 0;
  }
  const auto access = access_to(p, next.item);
  if (!access && stands_before(p, next.item))
    return enter_material(p, path, is_ring ? &path : nullptr, next.item);
  go_over(access && !access->empty() ? access->front().from : p, next.item);
  moves_.vertical(layer(next.item).layer().z, MoveKind::kPlunge, options_.plunge_feed);
  if (access) cut(*access, std::vector<MoveKind>(access->size(), MoveKind::kLeadIn));
  return 0;
}

/// A path to p from where the cutter descends without material, if there is one and the pass may begin by it.
std::optional<Path> Linker::access_to(Vec2 p, std::size_t item) const {
  const bool straight = work_.pass(item).may_cut_to_start || access_paths().in_air(p);
  return straight ? access_paths().to(p, item) : std::nullopt;
}

/// Whether material may stand in the way of a descent at p.
bool Linker::stands_before(Vec2 p, std::size_t item) const {
  return !work_.pass(item).starts_clear && !is_cleared_by_earlier_steps(p, item);
}

/// Whether a cutter at p, in the area of a pass along walls, meets nothing that earlier steps have left beside the walls.
bool Linker::is_cleared_by_earlier_steps(Vec2 p, std::size_t item) const {
  const LayerPasses& passes = layer(item).layer();
  if (!passes.cleared_beyond) return false;
  const double least = *passes.cleared_beyond - kSamePlaceMm;
  const double most = options_.may_plunge ? HUGE_VAL : passes.cleared_to.value_or(HUGE_VAL) + kSamePlaceMm;
  double nearest = HUGE_VAL;
  for (const Pass& pass : passes.passes)
    for (const Edge& edge : pass.path) nearest = std::min(nearest, distance(edge, p));
  return least <= nearest && nearest <= most;
}

void Linker::link_to(Vec2 p) {
  if (p == moves_.at()) return;
  const double depth = moves_.z();
  const MmPerMin feed = options_.link_feed.value_or(options_.feed);
  if (options_.link_lift > 0) moves_.vertical(depth + options_.link_lift, MoveKind::kLink, feed);
  moves_.line(p, MoveKind::kLink, feed);
  moves_.vertical(depth, MoveKind::kPlunge, options_.plunge_feed);
}

/// Moves over p by rapids, as low as is safe. If the cutter is already at p it stays in its own cut.
void Linker::go_over(Vec2 p, std::size_t item) {
  if (!running() || moves_.at() != p)
    rise_and_cross(p, running() ? retract_height(here(), p, item) : options_.safe_z);
  moves_.vertical(approach_z(p, item), MoveKind::kRapid, {});
}

/// An entry where the layer above is cleared, beside open sides too. If none of the kind asked for fits there, anywhere
/// in the legal area.
Entry Linker::entry_into(const EntryPlace& place, std::size_t item) const {
  const std::size_t at = work_.items()[item].layer;
  if (cleared_.may_stand(at)) {
    Entry entry = entry_at(place, work_.layer(at - 1).within_target(), options_);
    if (entry.kind != EntryKind::kPlunge) return entry;
  }
  return entry_at(place, layer(item).layer().legal, options_);
}

/// The beginning of `path` for an entry from slightly above the material.
EntryPlace Linker::entry_place(Vec2 start, const Path& path, const Path* ring, std::size_t item) const {
  const LayerPasses& passes = layer(item).layer();
  const Pass& pass = work_.pass(item);
  const Edge first = path.front();
  const Vec2 heading = first.from == first.to ? Vec2{1, 0} : first.tangent_at(0);
  const double z_above = std::min(approach_z(start, item), passes.z_top + kEntryHeight);
  EntryPlace place{start, heading, z_above, passes.z, pass.entry_center, ring};
  if (pass.kinds.empty()) place.run = &path;
  place.stays_on_run = !pass.may_cut_to_start;
  return place;
}

/// Moves from slightly above the material into it by the requested entry, or from the cutter's position over the
/// start after the layer above. Returns the same as go_to.
double Linker::enter_material(Vec2 start, const Path& path, const Path* ring, std::size_t item) {
  EntryPlace place = entry_place(start, path, ring, item);
  const double z_above = place.z_above;
  std::optional<Entry> entry;
  if (stand_over(moves_, start, place.z, z_above)) {
    place.z_above = moves_.z();
    entry = entry_into(place, item);
    if (entry->moves.front().path.from != start) entry.reset();  // a helix begins beside the start
  }
  if (!entry) {
    place.z_above = z_above;
    entry = entry_into(place, item);
    go_over(entry->moves.front().path.from, item);
    moves_.vertical(z_above, MoveKind::kPlunge, options_.plunge_feed);
  }
  moves_.append(entry->moves);
  ++entries_[index_of(entry->kind)];
  return entry->along_ring;
}

void Linker::rise_and_cross(Vec2 to, double height) {
  if (!running()) {
    moves_ = MoveList(to, height);
    return;
  }
  moves_.vertical(height, MoveKind::kRapid, {});
  moves_.line(to, MoveKind::kRapid, {});
}

Path Linker::oriented(const Candidate& next) const {
  const Pass& pass = work_.pass(next.item);
  Path path = pass.closed ? rotated_to(pass.path, next.start) : pass.path;
  const bool climbs = (options_.direction == CutDirection::kClimb) == options_.spindle_clockwise;
  const bool turned = layer(next.item).turned_round(work_.items()[next.item].pass);
  const bool back = pass.closed ? climbs == turned : next.start.backwards;
  return back ? reversed(path) : path;
}

void Linker::cut(const Path& path, const std::vector<MoveKind>& kinds) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    Edge joined = path[i];
    if (i == 0) joined.from = moves_.at();  // equal up to rounding
    if (joined.from == joined.to)
      continue;  // the pass is a single point where the cutter just fits: the entry has cut it
    const MoveKind kind = kinds.empty() ? MoveKind::kCut : kinds[i];
    moves_.along(joined, kind, feed_of(kind, options_));
  }
}

namespace {

/// Number of places on a ring considered for its start: those nearest to other passes.
constexpr std::size_t kRingStarts = 6;

/// The cuts first to last - 1 of a linker.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
};

std::vector<Run> runs_of(const Work& work, const std::vector<Cut>& cuts, Together together) {
  std::vector<Run> runs;
  Box swept;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const WorkItem& item = work.items()[cuts[i].item];
    const bool joined =
        i > 0 && (together == Together::kAreas ? swept.overlaps(item.path) : cuts[i].stayed_down);
    if (joined) {
      runs.back().last = i + 1;
    } else {
      runs.push_back({i, i + 1});
      swept = {};
    }
    swept.add(item.swept);
  }
  return runs;
}

class ShortOrder {
 public:
  ShortOrder(const Work& work, const Linker& linker, Together together)
      : work_(work), linker_(linker), cuts_(linker.cuts()), runs_(runs_of(work, cuts_, together)) {}

  std::vector<Task> tasks() {
    if (runs_.size() < 2) return {};
    order::VisitQuestion question;
    for (const Run& run : runs_) add_visit(run, question);
    question.precedence = precedence();
    question.fixed_first = work_.layer(0).layer().start || work_.layer(0).open();
    question.ordered_before = true;
    const auto begins = beginnings(question);
    const auto travel = [&](const order::VisitStep& a, const order::VisitStep& b, bool low) {
      const Run& from = runs_[a.visit];
      const CutterAt at{question.visits[a.visit].ways[a.way].end,
                        work_.layer_of(cuts_[from.last - 1].item).layer().z};
      return linker_.travel(at, begins[b.visit][b.way], low);
    };
    question.travel = [&](const order::VisitStep& a, const order::VisitStep& b) {
      return travel(a, b, true);
    };
    question.far_travel = [&](const order::VisitStep& a, const order::VisitStep& b) {
      return travel(a, b, false);
    };
    return tasks_of(order::order_visits(question));
  }

 private:
  std::vector<std::vector<Beginning>> beginnings(const order::VisitQuestion& question) const {
    std::vector<std::vector<Beginning>> begins(runs_.size());
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      for (const order::VisitWay& way : question.visits[r].ways)
        begins[r].push_back(linker_.beginning(cuts_[runs_[r].first].item, way.begin));
    }
    return begins;
  }

  void add_visit(const Run& run, order::VisitQuestion& question) {
    const Cut& first = cuts_[run.first];
    order::Visit visit;
    std::vector<PassStart> starts{first.start};
    visit.ways.push_back({first.begin, cuts_[run.last - 1].end, 0});
    const Pass& pass = work_.pass(first.item);
    const bool alone = run.last == run.first + 1;
    if (alone && pass.closed && pass.kinds.empty()) {
      for (const Vec2 other : nearest_others(run)) {
        const PassStart start = nearest_start(pass, other);
        starts.push_back(start);
        visit.ways.push_back({start.point, start.point, 0});
      }
    } else if (alone && !pass.closed && pass.reversible) {
      PassStart turned = first.start;
      turned.backwards = !turned.backwards;
      turned.point = first.end;
      starts.push_back(turned);
      visit.ways.push_back({first.end, first.begin, 0});
    }
    question.visits.push_back(std::move(visit));
    starts_.push_back(std::move(starts));
  }

  std::vector<Vec2> nearest_others(const Run& own) const {
    std::vector<Vec2> places;
    for (const Run& run : runs_) {
      if (run.first != own.first) places.push_back(work_.items()[cuts_[run.first].item].path.center());
    }
    const Vec2 here = work_.items()[cuts_[own.first].item].path.center();
    std::stable_sort(places.begin(), places.end(),
                     [&](Vec2 a, Vec2 b) { return norm_squared(a - here) < norm_squared(b - here); });
    if (places.size() > kRingStarts) places.resize(kRingStarts);
    return places;
  }

  std::vector<std::pair<std::size_t, std::size_t>> precedence() const {
    std::vector<std::size_t> run_of(work_.items().size());
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      for (std::size_t i = runs_[r].first; i < runs_[r].last; ++i) run_of[cuts_[i].item] = r;
    }
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t item = 0; item < work_.items().size(); ++item) {
      for (const std::size_t before : work_.before(item)) {
        if (run_of[before] != run_of[item]) pairs.insert({run_of[before], run_of[item]});
      }
    }
    return {pairs.begin(), pairs.end()};
  }

  std::vector<Task> tasks_of(const std::vector<order::VisitStep>& steps) const {
    std::vector<Task> tasks;
    for (const order::VisitStep& step : steps) {
      const Run& run = runs_[step.visit];
      for (std::size_t i = run.first; i < run.last; ++i) {
        tasks.push_back({cuts_[i].item, std::nullopt});
        if (i == run.first && (i + 1 == run.last || tasks.size() == 1))
          tasks.back().start = starts_[step.visit][step.way];
      }
    }
    return tasks;
  }

  const Work& work_;
  const Linker& linker_;
  const std::vector<Cut>& cuts_;
  std::vector<Run> runs_;
  /// For each run and each manner of cutting it: the starts of its passes.
  std::vector<std::vector<PassStart>> starts_;
};

}  // namespace

std::vector<Task> short_order(const Work& work, const Linker& linker, Together together) {
  return ShortOrder(work, linker, together).tasks();
}

}  // namespace clearcut::link
