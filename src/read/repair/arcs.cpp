#include "read/repair/arcs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/units.h"
#include "read/repair/clean.h"
#include "read/repair/mends.h"

namespace clearcut::read {
namespace {

/// Runs with a smaller bow are straight, mm.
constexpr double kStraight = 2 * kArcVertexTolerance;
/// One arc sweeps at most this, radians: its three defining points stay well apart.
constexpr double kWidestArc = 1.9 * kPi;

/// The lines of a loop from a place on, replaced by arcs if possible.
class Finder {
 public:
  explicit Finder(const Loop& loop) : loop_(loop) {}

  Loop run() {
    if (auto whole = circle()) return *whole;
    rotate_to_longest();
    Loop out;
    for (std::size_t i = 0; i < loop_.size();) {
      const std::size_t count = longest_run(i);
      if (count >= kFewestChords) {
        out.push_back(*arc(i, count));
        i += count;
      } else {
        out.push_back(loop_[i++]);
      }
    }
    return out;
  }

 private:
  /// The loop begins with its longest edge, so that no arc is cut in two by its start.
  void rotate_to_longest() {
    std::rotate(loop_.begin(),
                std::max_element(loop_.begin(), loop_.end(),
                                 [](const Edge& a, const Edge& b) { return a.length() < b.length(); }),
                loop_.end());
  }

  /// Number of lines from `first` on replaceable by one arc: by doubling while possible, then bisection.
  std::size_t longest_run(std::size_t first) const {
    std::size_t good = 0, bad = loop_.size() - first + 1;
    for (std::size_t count = kFewestChords; count < bad; count *= 2) {
      if (!arc(first, count)) {
        bad = count;
        break;
      }
      good = count;
    }
    if (good == 0) return 0;
    while (bad - good > 1) {
      const std::size_t middle = (good + bad) / 2;
      (arc(first, middle) ? good : bad) = middle;
    }
    return good;
  }

  /// The arc in place of `count` lines from `first`, if it fits them.
  std::optional<Edge> arc(std::size_t first, std::size_t count) const {
    const Vec2 from = loop_[first].from, to = loop_[first + count - 1].to;
    if (from == to) return std::nullopt;
    const Edge candidate = arc_through(from, loop_[first + count / 2].from, to);
    if (!candidate.is_arc() || std::abs(candidate.sweep()) > kWidestArc) return std::nullopt;
    if (distance(candidate.at(0.5), lerp(from, to, 0.5)) < kStraight) return std::nullopt;
    return lies_on(candidate, first, count) ? std::optional(candidate) : std::nullopt;
  }

  bool lies_on(const Edge& arc, std::size_t first, std::size_t count) const {
    const double radius = arc.radius(), turn = arc.turn == Turn::kCounterClockwise ? 1 : -1;
    double sweep = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      const Edge& line = loop_[i];
      if (line.is_arc()) return false;
      const Vec2 u = line.from - arc.center, v = line.to - arc.center;
      if (std::abs(norm(v) - radius) > kArcVertexTolerance) return false;
      if (std::abs(norm((u + v) / 2.0) - radius) > kArcChordTolerance) return false;
      const double step = turn * base::atan2(cross(u, v), dot(u, v));
      if (!(step > 0)) return false;
      sweep += step;
    }
    return sweep < 2 * kPi + 1e-6;
  }

  /// The circle if the whole loop is on one.
  std::optional<Loop> circle() const {
    const std::size_t n = loop_.size();
    if (n < kFewestChords) return std::nullopt;
    const Edge whole = arc_through(loop_[0].from, loop_[n / 3].from, loop_[2 * n / 3].from);
    if (!whole.is_arc() || !lies_on(whole, 0, n)) return std::nullopt;
    const Path found = full_circle(whole.center, whole.radius());
    return whole.turn == Turn::kCounterClockwise ? found : reversed(found);
  }

  Loop loop_;
};

}  // namespace

void find_arcs(std::vector<RawLoop>& loops, const RepairOptions& options, Diagnostics& diagnostics) {
  std::size_t lines = 0, arcs = 0;
  for (RawLoop& raw : loops) {
    Loop found = Finder(raw.loop).run();
    if (found.size() == raw.loop.size()) continue;
    const auto is_arc = [](const Edge& edge) { return edge.is_arc(); };
    const auto count = [&](const Loop& loop) {
      return static_cast<std::size_t>(std::count_if(loop.begin(), loop.end(), is_arc));
    };
    const std::size_t new_arcs = count(found) - count(raw.loop);
    arcs += new_arcs;
    lines += raw.loop.size() - (found.size() - new_arcs);
    raw.loop = std::move(found);
  }
  if (arcs == 0) return;
  diagnostics.repair(options.where, std::to_string(lines) + " short lines became " + std::to_string(arcs) +
                                        " arcs, none moved by more than " + short_number(kArcChordTolerance) +
                                        " mm");
}

}  // namespace clearcut::read
