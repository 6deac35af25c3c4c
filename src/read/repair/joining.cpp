#include "read/repair/joining.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "geometry/spatial/cell_grid.h"
#include "read/repair/clean.h"
#include "read/repair/duplicates.h"
#include "read/repair/mends.h"

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

}  // namespace clearcut::read
