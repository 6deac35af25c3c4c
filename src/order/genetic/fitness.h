// The value of individuals, by the altered edges and corners (Tour fig. 4-19, eq. 4.15).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "order/genetic/operator_context.h"
#include "order/objective.h"

namespace clearcut::order {

struct Individual {
  Genome genome;
  double local = 0;  ///< sum of edges and corners
  double value = 0;  ///< value of the objective: local + constant + the part depending on the whole path
};

/// Not for several threads at once: keeps work space.
class Fitness {
 public:
  /// Both must outlive this.
  Fitness(const Moves& moves, const Objective& objective);

  /// From scratch: "the old set of edges will be empty". O(n).
  void evaluate(Individual& individual) const;

  /// `local` of an individual whose genes were copied from `before` and then altered: only the edges and
  /// corners at altered positions are priced.
  double local_after(const Individual& before, const Genome& after);

  /// Change of `local` by a rearrangement, before it is applied. O(1) where two change places or a stretch is reversed, which keeps its value.
  double change(const Genome& genome, const Rearrangement& rearrangement) const;

  /// Whether the value follows from `local` only.
  bool is_local() const { return !objective_.path_dependent(); }
  double value_of(double local) const { return local + objective_.constant(); }

  /// Sets `value` from `local`; objectives that depend on the whole path are evaluated here.
  void complete(Individual& individual) const;

 private:
  /// Of a rearrangement that says all genes between its ends. O(their number).
  double change_of_genes(const Genome& genome, const Rearrangement& rearrangement) const;
  template <class At>
  double edge_at(int i, At at) const;
  template <class At>
  double corner_at(int i, At at) const;
  int wrapped(int position) const;
  /// The first `count` positions, each once.
  template <std::size_t N>
  std::span<const int> distinct(std::array<int, N>& positions, std::size_t count) const;
  bool is_edge(int i) const { return closed_ ? size_ > 1 : i >= 0 && i + 1 < size_; }
  bool is_corner(int i) const { return closed_ ? size_ > 2 : i >= 1 && i + 1 < size_; }
  void touch(int position);

  const Moves& moves_;
  const Objective& objective_;
  bool closed_;
  int size_;
  std::vector<int> edges_, corners_;  // altered, by first and by middle position
  std::vector<int> edge_stamps_, corner_stamps_;
  int stamp_ = 0;
};

}  // namespace clearcut::order
