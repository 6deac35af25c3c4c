// Local search for every objective made of edges and corners, and, by re-evaluation, for objectives depending on the
// whole path: 2- and 3-exchanges over neighbour lists (2-opt, Or-opt and or-3opt among them) with don't-look bits,
// chained by kicks.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "base/random.h"
#include "order/length/array_tour.h"
#include "order/length/neighbours.h"
#include "order/objective.h"
#include "order/stop.h"

namespace clearcut::order {

/// An open path is a closed tour through one more node, whose edges and corners cost nothing.
class ExchangeSearch {
 public:
  /// `start` must be valid for the problem. `moves` and `objective` must outlive the search.
  ExchangeSearch(const Moves& moves, const Objective& objective, const Neighbours& neighbours,
                 const Tour& start, std::uint64_t seed);

  /// Descends to a local optimum; ends sooner if the watch ends, and for objectives of the whole path after a number
  /// of evaluations that decreases with the length of the path.
  void descend(const StopWatch& watch);
  /// Kicks with repair; keeps results that are no worse. Stops early at a value of at most `enough`.
  void run(long long kicks, double enough, const StopWatch& watch);

  double value() const { return value_; }
  Tour tour() const;

  /// Change of the edge and corner sums by an exchange, in O(1): a few edges and corners per exchanged edge.
  double local_change(const Exchange& exchange) const;

 private:
  bool improve_node(int t0);
  bool extend(int depth, double balance);
  bool try_closing(double balance);
  bool is_removed(int a, int b, int depth) const;
  /// Cost of the edge a-b and of its corners if the edges a-not_a and b-not_b are removed.
  double corners_made(int a, int b, int not_a, int not_b) const;
  void allow_evaluations();
  /// Greatest cost of an exchange in edges and corners that a gain in the part depending on the whole path may still
  /// outweigh.
  double slack() const;
  bool asks_path() const;
  /// From a kick to a local optimum.
  void repair(const StopWatch& watch);
  bool accept_if_better();
  bool keeps_rules() const;
  void kick();
  /// Values of the objective; those of small problems are computed once.
  double edge(int a, int b) const;
  /// No more than edge(a, b), and without a search for a legal detour.
  double least_edge(int a, int b) const;
  double corner(int a, int b, int c) const;
  double corner_now(int v) const;
  /// Best possible gain from taking out the last removed edge of the exchange.
  double release(int i) const;
  int candidate(int v, int i, int most) const;
  /// Edges and corners changed by an exchange of the `length` nodes after position `before`.
  double stretch_value(int before, int length) const;
  int candidate_count(int v, int most) const;
  void touch(int v);
  void drain(const StopWatch& watch);

  /// Rules of precedence with the same earlier nodes: each of `before` comes before each of `after`.
  struct RuleGroup {
    std::vector<int> before, after;
  };
  static std::vector<RuleGroup> groups_of(const Problem& problem);

  /// A table of `count` values that are asked again and again. Values of large tables are made anew each time: the table would
  /// take more time and memory than it saves.
  class KnownValues {
   public:
    explicit KnownValues(std::size_t count);
    /// The value at `place`, made by `make` if it is asked for the first time.
    template <typename Make>
    double at(std::size_t place, const Make& make) {
      if (values_.empty()) return make();
      double& value = values_[place];
      if (std::isnan(value)) value = make();
      return value;
    }

   private:
    std::vector<double> values_;  ///< NaN: not asked yet
  };

  /// The problem as if every straight move were legal.
  struct Straight {
    explicit Straight(const Problem& problem);
    Problem without_detours;
    Moves moves;
  };

  const Moves& moves_;
  std::unique_ptr<Straight> straight_;  ///< null without detours
  const Objective& objective_;
  const Neighbours& neighbours_;
  int extra_ = -1;  ///< -1 for closed tours
  ArrayTour path_;
  mutable KnownValues known_edges_, known_corners_;
  Random random_;
  Exchange exchange_;
  double value_ = 0;
  double path_part_ = 0;
  std::unique_ptr<PathValue> path_value_;  ///< null unless the objective depends on the whole path
  /// The part depending on the whole path is temporarily not evaluated.
  bool repairing_ = false;
  /// Remaining evaluations of whole paths, until the next call of descend or run.
  long long evaluations_left_ = 0;
  std::vector<int> queue_;
  std::size_t head_ = 0;
  std::vector<char> queued_;
  std::vector<int> segments_;
  std::vector<RuleGroup> rules_;
  /// Along the path and against it: a broken rule of precedence, the last one found.
  mutable std::array<Precedence, 2> broken_{};
};

}  // namespace clearcut::order
