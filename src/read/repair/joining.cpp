#include "read/repair/joining.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "geometry/spatial/cell_grid.h"
#include "read/repair/clean.h"
#include "read/repair/edge_index.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

/// More ends than this within one gap are not a drawing.
constexpr std::size_t kMostEndsInAPlace = 256;

/// Ends of open curves: end 2i is the start of curve i, 2i + 1 its end.
struct Ends {
  const std::vector<RawCurve>& curves;

  int count() const { return 2 * static_cast<int>(curves.size()); }
  const RawCurve& curve(int end) const { return curves[static_cast<std::size_t>(end / 2)]; }
  bool is_start(int end) const { return end % 2 == 0; }
  Vec2 at(int end) const {
    return is_start(end) ? curve(end).edges.front().from : curve(end).edges.back().to;
  }
  bool on_arc(int end) const {
    return is_start(end) ? curve(end).edges.front().is_arc() : curve(end).edges.back().is_arc();
  }
  /// Direction of the curve away from this end.
  double heading(int end) const {
    return angle_of(is_start(end) ? curve(end).edges.front().tangent_at(0)
                                  : -curve(end).edges.back().tangent_at(1));
  }
};

constexpr int kUnmatched = -1;

/// Matching of ends.
class Matching {
 public:
  Matching(const Ends& ends, double gap, const std::string& where)
      : ends_(ends),
        gap_(gap),
        where_(where),
        mate_(static_cast<std::size_t>(ends.count()), kUnmatched),
        index_(gap) {}

  std::vector<int> run() {
    for (int end = 0; end < ends_.count(); ++end) index_.add(ends_.at(end), static_cast<std::uint32_t>(end));
    const auto fullest = index_.fullest();
    if (fullest.size() > kMostEndsInAPlace) {
      throw InputError(where_, "more than " + std::to_string(kMostEndsInAPlace) + " curve ends meet at " +
                                   place_text(ends_.at(static_cast<int>(fullest.front()))) +
                                   "; this is not an outline");
    }
    pair_coincident();
    pair_nearest();
    return std::move(mate_);
  }

 private:
  int& mate(int end) { return mate_[static_cast<std::size_t>(end)]; }
  void match(int a, int b) {
    mate(a) = b;
    mate(b) = a;
  }
  /// The two ends of one curve may meet only when the curve is longer than a gap.
  bool may_meet(int a, int b) const { return a / 2 != b / 2 || length(ends_.curve(a).edges) > 3 * gap_; }

  /// Pairs ends at one point with their neighbours by direction, so that loops touch and do not cross.
  void pair_coincident() {
    std::vector<bool> seen(static_cast<std::size_t>(ends_.count()), false);
    for (int end = 0; end < ends_.count(); ++end) {
      if (seen[static_cast<std::size_t>(end)]) continue;
      std::vector<int> together;
      for (const std::uint32_t near : index_.near(ends_.at(end))) {
        const int other = static_cast<int>(near);
        if (!seen[near] && distance(ends_.at(end), ends_.at(other)) <= kSamePoint) together.push_back(other);
      }
      for (const int one : together) seen[static_cast<std::size_t>(one)] = true;
      pair_around(together);
    }
  }
  void pair_around(std::vector<int>& together) {
    std::stable_sort(together.begin(), together.end(),
                     [this](int a, int b) { return ends_.heading(a) < ends_.heading(b); });
    for (std::size_t i = 0; i + 1 < together.size(); i += 2) {
      if (may_meet(together[i], together[i + 1])) match(together[i], together[i + 1]);
    }
  }
  /// The rest by distance, nearest first.
  void pair_nearest() {
    struct Pair {
      double gap;
      int a, b;
    };
    std::vector<Pair> pairs;
    for (int a = 0; a < ends_.count(); ++a) {
      if (mate(a) != kUnmatched) continue;
      for (const std::uint32_t near : index_.near(ends_.at(a))) {
        const int b = static_cast<int>(near);
        const double gap = distance(ends_.at(a), ends_.at(b));
        if (b > a && mate(b) == kUnmatched && gap <= gap_ && may_meet(a, b)) pairs.push_back({gap, a, b});
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
      return std::tie(p.gap, p.a, p.b) < std::tie(q.gap, q.a, q.b);
    });
    for (const Pair& pair : pairs) {
      if (mate(pair.a) == kUnmatched && mate(pair.b) == kUnmatched) match(pair.a, pair.b);
    }
  }

  static constexpr double kSamePoint = 1e-7;
  const Ends& ends_;
  const double gap_;
  const std::string& where_;
  std::vector<int> mate_;
  BoxIndex index_;
};

class Joiner {
 public:
  Joiner(const RepairOptions& options, Diagnostics& diagnostics)
      : options_(options), diagnostics_(diagnostics) {}

  std::vector<RawLoop> run(std::vector<RawCurve> curves) {
    std::vector<RawCurve> open;
    for (RawCurve& curve : curves) {
      if (closes_itself(curve)) {
        close(std::move(curve));
      } else {
        open.push_back(std::move(curve));
      }
    }
    chain(without_double_curves(std::move(open), options_.tol.join_gap, options_.where, diagnostics_));
    gaps_.report(options_.where, diagnostics_);
    closed_by_line_.report(options_.where, diagnostics_);
    return std::move(loops_);
  }

 private:
  bool closes_itself(const RawCurve& curve) const {
    if (curve.closed) return true;
    const double gap = distance(curve.edges.front().from, curve.edges.back().to);
    return gap <= options_.tol.join_gap && length(curve.edges) > 3 * options_.tol.join_gap;
  }

  void close(RawCurve curve) {
    Path& path = curve.edges;
    const double gap = distance(path.front().from, path.back().to);
    if (gap > options_.tol.join_gap) {
      closed_by_line_.add(path.back().to, gap);
      path.push_back(Edge::line(path.back().to, path.front().from));
    } else {
      weld(path, path);
    }
    add_loop(std::move(curve));
  }

  /// Moves the end of `before` and the start of `after` to one point; the end of an arc stays.
  void weld(Path& before, Path& after) {
    Edge& last = before.back();
    Edge& first = after.front();
    if (last.to == first.from) return;
    const double gap = distance(last.to, first.from);
    if (gap > kNoise) gaps_.add(last.to, gap);
    Vec2 meeting = last.to;
    if (first.is_arc() && !last.is_arc()) meeting = first.from;
    if (first.is_arc() == last.is_arc() && gap > kNoise) meeting = lerp(last.to, first.from, 0.5);
    last = with_ends(last, last.from, meeting);
    first = with_ends(first, meeting, first.to);
  }

  void add_loop(RawCurve curve) {
    auto& path = curve.edges;
    path.erase(std::remove_if(path.begin(), path.end(), [](const Edge& e) { return e.from == e.to; }),
               path.end());
    if (path.size() >= 2) loops_.push_back({std::move(path), std::move(curve.source), curve.compound});
  }

  std::vector<int> matched(const std::vector<RawCurve>& curves) const {
    return Matching(Ends{curves}, options_.tol.join_gap, options_.where).run();
  }

  /// Open ends may be caused by overlapping parallel edges.
  void chain(std::vector<RawCurve> curves) {
    if (curves.empty()) return;
    std::vector<int> mate = matched(curves);
    if (std::count(mate.begin(), mate.end(), kUnmatched) > 0) {
      auto apart = without_overlaps(curves, loops_, options_.tol.join_gap, options_.where, diagnostics_);
      if (apart) {
        curves = std::move(*apart);
        mate = matched(curves);
      }
    }
    const Ends ends{curves};
    std::vector<bool> used(curves.size(), false);
    refuse_or_skip_open(ends, mate, used);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (!used[i]) follow(curves, mate, i, used);
    }
  }

  /// The loop through curve `start`: from each end to its mate, on through the mate's curve.
  void follow(const std::vector<RawCurve>& curves, const std::vector<int>& mate, std::size_t start,
              std::vector<bool>& used) {
    RawCurve whole;
    whole.source = curves[start].source;
    whole.compound = curves[start].compound;
    int entered = 2 * static_cast<int>(start);
    while (!used[static_cast<std::size_t>(entered / 2)]) {
      const auto i = static_cast<std::size_t>(entered / 2);
      used[i] = true;
      Path piece = entered % 2 == 0 ? curves[i].edges : reversed(curves[i].edges);
      if (!whole.edges.empty()) weld(whole.edges, piece);
      whole.edges.insert(whole.edges.end(), piece.begin(), piece.end());
      entered = mate[static_cast<std::size_t>(entered ^ 1)];
    }
    weld(whole.edges, whole.edges);
    add_loop(std::move(whole));
  }

  /// Curves connected to an unmatched end are open.
  void refuse_or_skip_open(const Ends& ends, const std::vector<int>& mate, std::vector<bool>& used) {
    for (int end = 0; end < ends.count(); ++end) {
      if (mate[static_cast<std::size_t>(end)] != kUnmatched || used[static_cast<std::size_t>(end / 2)])
        continue;
      if (options_.open_curves == OpenCurves::kRefuse) refuse(ends, mate, end);
      double skipped = 0;
      for (int at = end; at != kUnmatched; at = mate[static_cast<std::size_t>(at ^ 1)]) {
        used[static_cast<std::size_t>(at / 2)] = true;
        skipped += length(ends.curve(at).edges);
      }
      diagnostics_.skip(options_.where + " at " + place_text(ends.at(end)),
                        "an open curve of " + short_number(skipped) + " mm (" + ends.curve(end).source +
                            ") was left out" + gap_beside(ends, mate, end));
    }
  }

  /// "; the nearest open end is ..." or nothing.
  std::string gap_beside(const Ends& ends, const std::vector<int>& mate, int end) const {
    int nearest_end = kUnmatched;
    double nearest_gap = 0;
    for (int other = 0; other < ends.count(); ++other) {
      if (other == end || mate[static_cast<std::size_t>(other)] != kUnmatched) continue;
      const double gap = distance(ends.at(end), ends.at(other));
      if (nearest_end == kUnmatched || gap < nearest_gap) {
        nearest_end = other;
        nearest_gap = gap;
      }
    }
    if (nearest_end == kUnmatched) return "";
    return ": the nearest open end is " + short_number(nearest_gap) + " mm away at " +
           place_text(ends.at(nearest_end)) + ", the join gap is " + short_number(options_.tol.join_gap) +
           " mm";
  }

  [[noreturn]] void refuse(const Ends& ends, const std::vector<int>& mate, int end) const {
    const std::string gap = gap_beside(ends, mate, end);
    throw InputError(options_.where,
                     "the outline is open at " + place_text(ends.at(end)) + " (" + ends.curve(end).source +
                         ")" + gap + (gap.empty() ? ": " : "; ") +
                         "close it in the drawing, widen the gap that is joined (--join-gap), "
                         "leave open lines out (--open-curves skip)" +
                         other_use_of_lines(options_));
  }

  /// mm. Gaps below this are rounding: mended without a word.
  static constexpr double kNoise = 1e-7;
  const RepairOptions& options_;
  Diagnostics& diagnostics_;
  std::vector<RawLoop> loops_;
  Mends gaps_{"closed a gap"};
  Mends closed_by_line_{"closed the outline by a line"};
};

}  // namespace

std::vector<RawLoop> join(std::vector<RawCurve> curves, const RepairOptions& options,
                          Diagnostics& diagnostics) {
  return Joiner(options, diagnostics).run(std::move(curves));
}

namespace {

constexpr long long kMostTests = 50'000'000;

bool same_edge(const Edge& a, const Edge& b, double gap) {
  const auto near = [gap](Vec2 p, Vec2 q) { return distance(p, q) <= gap; };
  return a.is_arc() == b.is_arc() && near(a.at(0.5), b.at(0.5)) &&
         ((near(a.from, b.from) && near(a.to, b.to)) || (near(a.from, b.to) && near(a.to, b.from)));
}

/// Whether every vertex and middle of `a` is within `gap` of `b`.
bool lies_on(const Loop& a, const std::vector<Loop>& b, double gap) {
  const EdgeIndex index(b);
  const auto is_near = [&](Vec2 p) {
    bool near = false;
    index.visit(Box{p, p}.grown(gap), [&](EdgeId id) {
      near = distance(index.edge(id), p) <= gap;
      return !near;
    });
    return near;
  };
  return std::all_of(a.begin(), a.end(),
                     [&](const Edge& e) { return is_near(e.from) && is_near(e.at(0.5)); });
}

bool same_loop(const Loop& a, const Loop& b, double gap) {
  const double difference = std::abs(std::abs(signed_area(a)) - std::abs(signed_area(b)));
  if (difference > 2 * gap * (length(a) + length(b))) return false;
  const Box one = box(a), other = box(b);
  if (distance(one.max, other.max) > 2 * gap) return false;
  return lies_on(a, {b}, gap) && lies_on(b, {a}, gap);
}

/// Single edges, each a curve.
std::vector<RawCurve> single_edges(const std::vector<RawCurve>& curves) {
  std::vector<RawCurve> edges;
  for (const RawCurve& curve : curves)
    for (const Edge& edge : curve.edges) edges.push_back({{edge}, false, curve.source, curve.compound});
  return edges;
}

std::vector<Loop> edges_as_loops(const std::vector<RawCurve>& curves) {
  std::vector<Loop> loops;
  loops.reserve(curves.size());
  for (const RawCurve& curve : curves) loops.push_back(curve.edges);
  return loops;
}

bool runs_along(const Edge& edge, const Edge& other, double gap) {
  const auto is_near = [&](double t) { return distance(other, edge.at(t)) <= gap; };
  return edge.is_arc() == other.is_arc() && is_near(0) && is_near(0.25) && is_near(0.5) && is_near(0.75) &&
         is_near(1);
}

/// The union of two edges overlapping at an end of each by more than a gap; smaller overlaps are joined elsewhere.
std::optional<Edge> united(const Edge& a, const Edge& b, double gap) {
  if (a.is_arc() != b.is_arc()) return std::nullopt;
  for (const bool a_end : {false, true}) {
    for (const bool b_end : {false, true}) {
      const Vec2 inner_a = a_end ? a.to : a.from, outer_a = a_end ? a.from : a.to;
      const Vec2 inner_b = b_end ? b.to : b.from, outer_b = b_end ? b.from : b.to;
      const bool overlap =
          distance(inner_a, inner_b) > gap && distance(b, inner_a) <= gap && distance(a, inner_b) <= gap;
      if (!overlap) continue;
      const Edge whole = a.is_arc() ? arc_through(outer_a, inner_a, outer_b) : Edge::line(outer_a, outer_b);
      if (runs_along(a, whole, gap) && runs_along(b, whole, gap)) return whole;
    }
  }
  return std::nullopt;
}

/// One round of removing shared parts; to be called until nothing changes. `tests_left` counts down: knots of
/// overlapping edges are no drawing, and are unchanged.
class OverlapRound {
 public:
  OverlapRound(std::vector<RawCurve>& edges, const EdgeIndex& outlines, double gap, Mends& mends,
               long long& tests_left)
      : edges_(edges),
        outlines_(outlines),
        gap_(gap),
        mends_(mends),
        tests_left_(tests_left),
        ends_(gap),
        used_(edges.size()) {}

  bool run() {
    tests_left_ -= static_cast<long long>(edges_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      ends_.add(at(i).from, static_cast<std::uint32_t>(2 * i));
      ends_.add(at(i).to, static_cast<std::uint32_t>(2 * i + 1));
    }
    const std::vector<Loop> loops = edges_as_loops(edges_);
    const EdgeIndex index(loops);
    bool changed = false;
    for (std::size_t i = 0; i < edges_.size() && tests_left_ > 0; ++i) {
      if (used_[i] || !(dangles(at(i).from) || dangles(at(i).to))) continue;
      changed = on_outline(i) || on_another(i, index) || changed;
    }
    apply();
    return changed;
  }

 private:
  const Edge& at(std::size_t i) const { return edges_[i].edges.front(); }

  void apply() {
    for (const auto& [i, edge] : replaced_) edges_[i].edges = {edge};
    for (const std::size_t i : dropped_) edges_[i].edges.clear();
    std::erase_if(edges_, [](const RawCurve& curve) { return curve.edges.empty(); });
  }

  bool dangles(Vec2 end) const {
    int count = 0;
    for (const std::uint32_t other : ends_.near(end)) {
      const Edge& edge = at(other / 2);
      count += distance(other % 2 == 0 ? edge.from : edge.to, end) <= gap_ ? 1 : 0;
    }
    return count % 2 == 1;
  }

  void drop(std::size_t i, double shared) {
    mends_.add(at(i).from, shared);
    dropped_.push_back(i);
    used_[i] = true;
  }

  bool on_outline(std::size_t i) {
    bool found = false;
    outlines_.visit(at(i).box().grown(gap_), [&](EdgeId id) {
      found = runs_along(at(i), outlines_.edge(id), gap_);
      return !found && --tests_left_ > 0;
    });
    if (found) drop(i, at(i).length());
    return found;
  }

  bool on_another(std::size_t i, const EdgeIndex& index) {
    int other = -1;
    std::optional<Edge> whole;
    index.visit(at(i).box().grown(gap_), [&](EdgeId id) {
      const auto j = static_cast<std::size_t>(id.loop);
      if (j == i || used_[j]) return --tests_left_ > 0;
      if (runs_along(at(i), at(j), gap_)) {
        whole = at(j);
      } else if (runs_along(at(j), at(i), gap_)) {
        whole = at(i);
      } else {
        whole = united(at(i), at(j), gap_);
      }
      if (whole) other = id.loop;
      return other < 0 && --tests_left_ > 0;
    });
    if (other < 0) return false;
    const auto j = static_cast<std::size_t>(other);
    drop(i, at(i).length() + at(j).length() - whole->length());
    used_[j] = true;
    replaced_.emplace_back(j, *whole);
    return true;
  }

  std::vector<RawCurve>& edges_;
  const EdgeIndex& outlines_;
  double gap_;
  Mends& mends_;
  long long& tests_left_;
  BoxIndex ends_;
  std::vector<bool> used_;
  std::vector<std::size_t> dropped_;
  std::vector<std::pair<std::size_t, Edge>> replaced_;
};

}  // namespace

std::optional<std::vector<RawCurve>> without_overlaps(const std::vector<RawCurve>& curves,
                                                      const std::vector<RawLoop>& loops, double gap,
                                                      const std::string& where, Diagnostics& diagnostics) {
  Mends shared("curves that run along each other count once: length");
  std::vector<Loop> outlines;
  for (const RawLoop& loop : loops) outlines.push_back(loop.loop);
  const EdgeIndex index(outlines);
  std::vector<RawCurve> edges = single_edges(curves);
  long long tests_left = kMostTests;
  while (OverlapRound(edges, index, gap, shared, tests_left).run()) {
  }
  if (shared.empty()) return std::nullopt;
  shared.report(where, diagnostics);
  return edges;
}

std::vector<RawCurve> without_double_curves(std::vector<RawCurve> curves, double gap,
                                            const std::string& where, Diagnostics& diagnostics) {
  Mends doubles("a curve drawn twice counts once: length");
  BoxIndex index(gap);
  std::vector<RawCurve> kept;
  for (RawCurve& curve : curves) {
    const Edge& edge = curve.edges.front();
    const bool single = curve.edges.size() == 1 && edge.length() > 3 * gap;
    bool doubled = false;
    if (single) {
      for (const std::uint32_t i : index.near(edge.at(0.5)))
        doubled = doubled || same_edge(edge, kept[i].edges.front(), gap);
    }
    if (doubled) {
      doubles.add(edge.from, edge.length());
      continue;
    }
    if (single) index.add(edge.at(0.5), static_cast<std::uint32_t>(kept.size()));
    kept.push_back(std::move(curve));
  }
  doubles.report(where, diagnostics);
  return kept;
}

std::vector<RawLoop> without_double_loops(std::vector<RawLoop> loops, double gap, const std::string& where,
                                          Diagnostics& diagnostics) {
  Mends doubles("an outline drawn twice counts once: length");
  BoxIndex index(2 * gap);
  std::vector<RawLoop> kept;
  for (RawLoop& raw : loops) {
    const Vec2 corner = box(raw.loop).min;
    bool doubled = false;
    for (const std::uint32_t i : index.near(corner))
      doubled = doubled || same_loop(raw.loop, kept[i].loop, gap);
    if (doubled) {
      doubles.add(raw.loop.front().from, length(raw.loop));
      continue;
    }
    index.add(corner, static_cast<std::uint32_t>(kept.size()));
    kept.push_back(std::move(raw));
  }
  doubles.report(where, diagnostics);
  return kept;
}

}  // namespace clearcut::read
