#include "read/repair/crossings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "base/error.h"
#include "geometry/contours/boolean.h"
#include "read/repair/clean.h"
#include "read/repair/meetings.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

constexpr std::size_t kMostMeetings = 20'000;
/// Greatest number of meetings in areas filled together, resolved by one boolean: a board of 5000 pads and 10 000
/// tracks has about 300 000.
constexpr std::size_t kMostMeetingsInFill = 1'000'000;
/// mm. Displacement of a boundary by the library: its grid.
constexpr double kBooleanRounding = 2e-6;

std::vector<Loop> bare(const std::vector<RawLoop>& loops) {
  std::vector<Loop> out;
  for (const RawLoop& loop : loops) out.push_back(loop.loop);
  return out;
}

bool is_harmful(const Meeting& meeting) {
  return meeting.kind != MeetingKind::kTouch;
}

/// Throws InputError if there are `most`.
std::vector<Meeting> meetings_of(const std::vector<Loop>& loops, const RepairOptions& options,
                                 std::size_t most = kMostMeetings) {
  auto found = meetings(loops, most, options.where);
  if (found.size() >= most) {
    throw InputError(options.where, "outlines meet or cross in more than " + std::to_string(most) +
                                        " places, the first at " + place_text(found.front().at) +
                                        "; simplify the drawing");
  }
  return found;
}

/// Non-crossing loops of one compound: loops with winding zero on exactly one side are kept.
std::vector<Loop> outlines_by_winding(const std::vector<Loop>& loops) {
  const auto turn = [](const Loop& loop) { return signed_area(loop) > 0 ? 1 : -1; };
  const auto about = loops_about(loops);
  std::vector<Loop> kept;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    int outside = 0;
    for (const int other : about[i]) outside += turn(loops[static_cast<std::size_t>(other)]);
    if ((outside == 0) != (outside + turn(loops[i]) == 0)) kept.push_back(loops[i]);
  }
  return kept;
}

/// Whether all turn counter-clockwise and none crosses itself: then the area of non-zero winding is their union.
bool are_pieces(const std::vector<Loop>& loops, const std::vector<Meeting>& met) {
  return std::all_of(loops.begin(), loops.end(), [](const Loop& loop) { return signed_area(loop) > 0; }) &&
         std::none_of(met.begin(), met.end(), [](const Meeting& meeting) {
           return meeting.within_one_loop() && is_harmful(meeting);
         });
}

/// At meetings of thousands of pieces, many edges shorter than the rounding of their ends are left: each would count
/// as a meeting of its neighbours.
std::vector<Loop> without_tiny_edges(std::vector<Loop> loops) {
  for (Loop& loop : loops) loop = read::without_tiny_edges(loop);
  std::erase_if(loops, [](const Loop& loop) { return loop.size() < 2; });
  return loops;
}

/// One compound of several loops, or one self-crossing loop.
std::vector<Loop> resolve_compound(const std::vector<Loop>& loops, bool nonzero, const RepairOptions& options,
                                   Diagnostics& diagnostics) {
  const auto met = meetings_of(loops, options, kMostMeetingsInFill);
  const auto crossing = std::find_if(met.begin(), met.end(), is_harmful);
  if (crossing == met.end()) return nonzero && loops.size() > 1 ? outlines_by_winding(loops) : loops;
  diagnostics.repair(options.where + " at " + place_text(crossing->at),
                     "a filled path that crosses itself was resolved by its fill rule");
  if (!nonzero) return loops_of(resolve_even_odd(loops, options.tol));
  return without_tiny_edges(loops_of(are_pieces(loops, met) ? unite_loops(loops, options.tol)
                                                            : resolve_nonzero(loops, options.tol)));
}

}  // namespace

std::vector<RawLoop> resolve_compounds(std::vector<RawLoop> loops, const RepairOptions& options,
                                       Diagnostics& diagnostics) {
  std::map<Compound, std::vector<RawLoop>> compounds;
  std::vector<RawLoop> out;
  for (RawLoop& loop : loops) {
    if (loop.compound) {
      compounds[*loop.compound].push_back(std::move(loop));
    } else {
      out.push_back(std::move(loop));
    }
  }
  for (const auto& [compound, members] : compounds) {
    for (Loop& loop : resolve_compound(bare(members), compound.nonzero, options, diagnostics)) {
      out.push_back({std::move(loop), members.front().source, compound});
    }
  }
  return out;
}

namespace {

/// Loops of one filled path are interpreted by the even-odd rule, however near they are to each other.
bool is_one_fill(const RawLoop& a, const RawLoop& b) {
  return a.compound && a.compound == b.compound;
}

/// A loop whose meetings with itself are more than touches, by the library: the main part when the rest is
/// small.
std::vector<Loop> resolve_self_crossing(const RawLoop& raw, Vec2 at, const RepairOptions& options,
                                        Diagnostics& diagnostics) {
  const Regions parts = resolve_even_odd(std::span(&raw.loop, 1), options.tol);
  if (raw.compound) return loops_of(parts);
  const double all = area(parts), wound = std::abs(signed_area(raw.loop));
  const double rounding = kBooleanRounding * length(raw.loop);
  const std::string where = options.where + " at " + place_text(at);
  if (std::abs(all - wound) <= rounding) {
    diagnostics.repair(where, "an outline (" + raw.source + ") that runs along itself was split there");
    return loops_of(parts);
  }
  const auto main = std::max_element(parts.begin(), parts.end(),
                                     [](const Region& a, const Region& b) { return a.area() < b.area(); });
  const double limit = std::max(kLargestCurl * wound, options.tol.join_gap * options.tol.join_gap);
  const double rest = main == parts.end() ? 0 : all - main->area() + std::abs(all - wound);
  if (main == parts.end() || rest > limit) {
    throw InputError(options.where, "the outline (" + raw.source + ") crosses itself at " + place_text(at) +
                                        " and encloses " + short_number(rest) +
                                        " mm2 the wrong way round; untangle it in the drawing" +
                                        other_use_of_lines(options));
  }
  diagnostics.repair(where, "a curl where the outline (" + raw.source +
                                ") crosses itself was removed: area " + short_number(rest) + " mm2");
  std::vector<Loop> kept{main->outer()};
  for (const Loop& island : main->islands()) {
    if (std::abs(signed_area(island)) > limit) kept.push_back(island);
  }
  return kept;
}

/// Every loop free of meetings with itself.
std::vector<RawLoop> resolve_each(std::vector<RawLoop> loops, const std::vector<Meeting>& met,
                                  const RepairOptions& options, Diagnostics& diagnostics) {
  std::map<int, std::vector<Meeting>> own;
  for (const Meeting& meeting : met) {
    if (meeting.within_one_loop()) own[meeting.a.loop].push_back(meeting);
  }
  std::vector<RawLoop> out;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto found = own.find(static_cast<int>(i));
    if (found == own.end()) {
      out.push_back(std::move(loops[i]));
      continue;
    }
    const auto worst = std::find_if(found->second.begin(), found->second.end(), is_harmful);
    std::vector<Loop> parts;
    if (worst != found->second.end()) {
      try {
        parts = resolve_self_crossing(loops[i], worst->at, options, diagnostics);
      } catch (const InputError& refusal) {
        if (!options.crossing) throw;
        options.crossing->push_back({{loops[i].loop, true, loops[i].source, loops[i].compound}, refusal});
      }
    } else {
      parts = split_at(loops[i].loop, found->second);
      diagnostics.repair(options.where + " at " + place_text(found->second.front().at),
                         "an outline (" + loops[i].source + ") that touches itself was split into " +
                             std::to_string(parts.size()));
    }
    for (Loop& part : parts) out.push_back({std::move(part), loops[i].source, loops[i].compound});
  }
  return out;
}

/// Resolves crossing loops pair by pair, largest first.
class PairResolver {
 public:
  PairResolver(const std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics)
      : loops_(loops), options_(options), diagnostics_(diagnostics), united_with_(loops.size()) {
    std::iota(united_with_.begin(), united_with_.end(), 0);
    for (const RawLoop& loop : loops) areas_.push_back(std::abs(signed_area(loop.loop)));
  }

  /// `met`: their harmful meetings. Returns all loops, with the crossing ones resolved.
  std::vector<RawLoop> run(const std::vector<Meeting>& met) {
    std::map<std::pair<int, int>, Vec2> pairs;
    for (const Meeting& meeting : met) pairs.try_emplace({meeting.a.loop, meeting.b.loop}, meeting.at);
    if (pairs.size() > kMostCrossingPairs) {
      throw InputError(options_.where, "more than 500 pairs of outlines cross each other, the first at " +
                                           place_text(met.front().at) + "; simplify the drawing");
    }
    for (const auto& [pair, at] : pairs) settle(pair.first, pair.second, at);
    std::set<int> involved;
    for (const auto& [pair, at] : pairs) {
      for (const int i : {pair.first, pair.second})
        if (!aside_.contains(i)) involved.insert(i);
    }
    return with_resolved(involved);
  }

 private:
  double area_of(int i) const { return areas_[static_cast<std::size_t>(i)]; }
  const Loop& loop(int i) const { return loops_[static_cast<std::size_t>(i)].loop; }
  const std::string& source(int i) const { return loops_[static_cast<std::size_t>(i)].source; }
  Regions region(int i) const { return {Region::from_valid_loops(loop(i), {})}; }

  int root(int i) {
    while (united_with_[static_cast<std::size_t>(i)] != i) i = united_with_[static_cast<std::size_t>(i)];
    return i;
  }

  /// Decides the interpretation of the crossing of a and b.
  void settle(int a, int b, Vec2 at) {
    if (aside_.contains(a) || aside_.contains(b)) return;
    const int large = area_of(a) >= area_of(b) ? a : b, small = large == a ? b : a;
    const double shared = area(intersect(region(large), region(small), options_.tol)) / area_of(small);
    const std::string where = options_.where + " at " + place_text(at);
    if (shared >= kMostlyInside) {
      walls_of_[small].push_back(large);
      diagnostics_.repair(where, "an outline (" + source(small) + ") through the wall of another (" +
                                     source(large) + ") was cut back to it: " +
                                     short_number((1 - shared) * area_of(small)) + " mm2 lay outside");
    } else if (shared <= kSlightOverlap) {
      united_with_[static_cast<std::size_t>(root(small))] = root(large);
      diagnostics_.repair(where, "two outlines (" + source(large) + ", " + source(small) +
                                     ") that overlap or share a wall were united: overlap " +
                                     short_number(shared * area_of(small)) + " mm2");
    } else {
      set_aside_or_throw(
          small,
          InputError(options_.where, "two outlines (" + source(large) + ", " + source(small) + ") cross at " +
                                         place_text(at) + " and neither lies inside the other (" +
                                         short_number(100 * shared) + " % does); " + what_to_do(a, b)));
    }
  }

  /// An outline already united with others, or cut back to them, can no longer be left out.
  void set_aside_or_throw(int i, const InputError& refusal) {
    const bool is_settled = walls_of_.count(i) > 0 ||
                            std::count(united_with_.begin(), united_with_.end(), i) > 1 || root(i) != i ||
                            std::any_of(walls_of_.begin(), walls_of_.end(), [i](const auto& one) {
                              return std::find(one.second.begin(), one.second.end(), i) != one.second.end();
                            });
    if (!options_.crossing || is_settled) throw refusal;
    const RawLoop& raw = loops_[static_cast<std::size_t>(i)];
    options_.crossing->push_back({{raw.loop, true, raw.source, raw.compound}, refusal});
    aside_.insert(i);
  }

  /// Lines are an area only as far as they enclose one.
  std::string what_to_do(int a, int b) const {
    const auto filled = [&](int i) { return loops_[static_cast<std::size_t>(i)].compound.has_value(); };
    if (filled(a) || filled(b)) return "separate them, or put the island on a layer ISLAND";
    return "separate or unite them in the drawing, put the one that stays on a layer ISLAND" +
           other_use_of_lines(options_);
  }

  std::vector<RawLoop> with_resolved(const std::set<int>& involved) {
    std::vector<RawLoop> out;
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const int index = static_cast<int>(i);
      if (!involved.contains(index) && !aside_.contains(index)) out.push_back(loops_[i]);
    }
    const auto groups = grouped(involved);
    for (Loop& loop : is_one_level(groups) ? cut_out(groups) : folded(groups)) {
      out.push_back({std::move(loop), source(*involved.begin()), {}});
    }
    return out;
  }

  /// United outlines, and the groups whose walls they go through.
  struct Group {
    std::vector<int> members;
    std::set<int> walls;
  };
  std::map<int, Group> grouped(const std::set<int>& involved) {
    std::map<int, Group> groups;
    for (const int i : involved) {
      Group& group = groups[root(i)];
      group.members.push_back(i);
      for (const int wall : walls_of_[i]) group.walls.insert(root(wall));
    }
    return groups;
  }
  static bool is_one_level(const std::map<int, Group>& groups) {
    return std::all_of(groups.begin(), groups.end(), [&](const auto& group) {
      const auto& walls = group.second.walls;
      return walls.empty() || (walls.size() == 1 && groups.at(*walls.begin()).walls.empty());
    });
  }

  Regions united(const Group& group) const {
    Regions all = region(group.members.front());
    for (std::size_t i = 1; i < group.members.size(); ++i) {
      all = unite(all, region(group.members[i]), options_.tol);
    }
    return all;
  }

  /// Outlines minus the shapes through their walls: no curve is cut twice.
  std::vector<Loop> cut_out(const std::map<int, Group>& groups) const {
    std::map<int, Regions> left;
    for (const auto& [first, group] : groups) {
      if (group.walls.empty()) left[first] = united(group);
    }
    for (const auto& [first, group] : groups) {
      if (group.walls.empty()) continue;
      Regions& wall = left[*group.walls.begin()];
      wall = subtract(wall, united(group), options_.tol);
    }
    std::vector<Loop> loops;
    for (const auto& [first, regions] : left) {
      for (Loop& loop : loops_of(regions)) loops.push_back(std::move(loop));
    }
    return loops;
  }

  /// The largest outline of a group; of equal ones the first, used by settle() as the wall.
  int largest_of(const Group& group) const {
    return *std::max_element(group.members.begin(), group.members.end(),
                             [&](int a, int b) { return is_smaller(a, b); });
  }
  bool is_smaller(int a, int b) const {
    return area_of(a) < area_of(b) || (area_of(a) == area_of(b) && a > b);
  }

  /// The same for any nesting, innermost first. A shape through a wall is subtracted whole: if cut back first, it
  /// would share the wall, and the library's time for joining shared edges grows with their square.
  std::vector<Loop> folded(const std::map<int, Group>& groups) const {
    std::vector<int> order;
    for (const auto& [first, group] : groups) order.push_back(first);
    const auto smaller = [&](int a, int b) {
      return is_smaller(largest_of(groups.at(a)), largest_of(groups.at(b)));
    };
    std::sort(order.begin(), order.end(), smaller);
    std::map<int, std::vector<Loop>> inside;  // per group: outlines minus the shapes through their walls
    std::vector<Loop> loops;
    for (const int first : order) {
      const Group& group = groups.at(first);
      const auto wall = std::min_element(group.walls.begin(), group.walls.end(), smaller);
      if (wall != group.walls.end() && !smaller(first, *wall)) return cut_back(groups);
      Regions own = united(group);
      if (const auto found = inside.find(first); found != inside.end())
        own = subtract(own, resolve_even_odd(found->second, options_.tol), options_.tol);
      std::vector<Loop>& into = wall == group.walls.end() ? loops : inside[*wall];
      for (Loop& loop : loops_of(own)) into.push_back(std::move(loop));
    }
    return loops;
  }

  /// For groups not nested by size: each cut back to its walls, then all under the even-odd rule.
  std::vector<Loop> cut_back(const std::map<int, Group>& groups) const {
    std::vector<Loop> tangled;
    for (const auto& [first, group] : groups) {
      Regions own = united(group);
      for (const int wall : group.walls) own = intersect(own, united(groups.at(wall)), options_.tol);
      for (Loop& loop : loops_of(own)) tangled.push_back(std::move(loop));
    }
    return loops_of(resolve_even_odd(tangled, options_.tol));
  }

  const std::vector<RawLoop>& loops_;
  const RepairOptions& options_;
  Diagnostics& diagnostics_;
  std::vector<int> united_with_;
  std::vector<double> areas_;
  std::map<int, std::vector<int>> walls_of_;
  std::set<int> aside_;  ///< outlines taken by options.crossing
};

std::vector<Meeting> harmful_of(const std::vector<Meeting>& met) {
  std::vector<Meeting> harmful;
  std::copy_if(met.begin(), met.end(), std::back_inserter(harmful), is_harmful);
  return harmful;
}

/// Harmful ones of different shapes.
std::vector<Meeting> between_shapes(const std::vector<Meeting>& met, const std::vector<RawLoop>& loops) {
  std::vector<Meeting> harmful = harmful_of(met);
  std::erase_if(harmful, [&](const Meeting& m) {
    return m.within_one_loop() ||
           is_one_fill(loops[static_cast<std::size_t>(m.a.loop)], loops[static_cast<std::size_t>(m.b.loop)]);
  });
  return harmful;
}

/// Loops returned by the library may meet other loops, or themselves after arcs are recovered: resolved once more,
/// with all meeting loops.
std::vector<Loop> settled(std::vector<Loop> loops, const RepairOptions& options) {
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Meeting> harmful = harmful_of(meetings_of(loops, options));
    if (harmful.empty()) break;
    std::set<int> involved;
    for (const Meeting& meeting : harmful) involved.insert({meeting.a.loop, meeting.b.loop});
    std::vector<Loop> tangled, out;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      (involved.count(static_cast<int>(i)) ? tangled : out).push_back(std::move(loops[i]));
    }
    for (Loop& loop : loops_of(resolve_even_odd(tangled, options.tol))) out.push_back(std::move(loop));
    loops = std::move(out);
  }
  return loops;
}

void report_touches(const std::vector<Meeting>& met, const std::vector<RawLoop>& loops,
                    const RepairOptions& options, Diagnostics& diagnostics) {
  constexpr std::size_t kListed = 20;
  std::set<std::pair<int, int>> pairs;
  for (const Meeting& meeting : met) {
    if (!pairs.insert({meeting.a.loop, meeting.b.loop}).second || pairs.size() > kListed) continue;
    diagnostics.note(options.where + " at " + place_text(meeting.at),
                     "two outlines touch (" + loops[static_cast<std::size_t>(meeting.a.loop)].source + ", " +
                         loops[static_cast<std::size_t>(meeting.b.loop)].source + ")");
  }
  if (pairs.size() > kListed) {
    diagnostics.note(options.where, std::to_string(pairs.size() - kListed) + " more pairs of outlines touch");
  }
}

}  // namespace

std::vector<Loop> resolve_crossings(std::vector<RawLoop> loops, const RepairOptions& options,
                                    Diagnostics& diagnostics) {
  auto met = meetings_of(bare(loops), options);
  if (std::any_of(met.begin(), met.end(), [](const Meeting& m) { return m.within_one_loop(); })) {
    loops = resolve_each(std::move(loops), met, options, diagnostics);
    met = meetings_of(bare(loops), options);
  }
  std::erase_if(met, [](const Meeting& m) { return m.within_one_loop(); });
  if (harmful_of(met).empty()) {
    report_touches(met, loops, options, diagnostics);
    return bare(loops);
  }
  std::vector<Meeting> harmful = between_shapes(met, loops);
  while (unite_fills(loops, harmful, options, diagnostics))
    harmful = between_shapes(meetings_of(bare(loops), options), loops);
  if (!harmful.empty()) loops = PairResolver(loops, options, diagnostics).run(harmful);
  return settled(bare(loops), options);
}

}  // namespace clearcut::read
