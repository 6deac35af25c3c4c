// Builds children from parent A and chosen AB-cycles: exchange the edges, then join the resulting subtours.
#pragma once

#include <span>
#include <vector>

#include "order/length/ab_cycles.h"
#include "order/length/length_model.h"

namespace clearcut::order {

/// Edges by which a child differs from its parent A, without edges removed and added again.
struct EdgeChange {
  int a = 0;
  int b = 0;
  bool added = false;
};

struct Child {
  LengthModel::Cost gain = 0;  ///< difference to the parent's length
  std::vector<EdgeChange> changes;
};

/// Work space for children of one parent at a time. A child costs O(k log k + nodes of the smaller subtours),
/// k being the number of exchanged edges, not O(n) [nagata2013, 4.1].
class Assembly {
 public:
  using Cost = LengthModel::Cost;

  explicit Assembly(const LengthModel& model);

  void set_parent(const Links& a);

  /// The child of the given cycles; false when subtours could not be joined through candidate neighbours.
  bool build(const AbCycles& cycles, std::span<const int> chosen, Child& child);

  /// After exchanging one central cycle: the other cycles, with fewer edges than the centre, touching a subtour other
  /// than the largest; together with the centre they are a block [nagata2006].
  void block_around(const AbCycles& cycles, int centre, std::vector<int>& chosen);
  /// To be called once for the parent's cycles before block_around.
  void index_cycles(const AbCycles& cycles);

 private:
  struct Piece {
    int first = 0;  ///< positions in the parent's order
    int last = 0;
    int subtour = -1;
  };
  struct Subtour {
    int size = 0;
    std::vector<int> pieces;
  };
  struct Join {
    Cost gain = 0;
    int u = -1, u2 = -1, w = -1, w2 = -1;
  };
  void exchange(const AbCycles& cycles, std::span<const int> chosen, Child& child);
  void cut_into_pieces();
  void find_subtours();
  int piece_of(int node) const;
  int piece_at(int position) const;
  Join best_join(int subtour);
  void make_join(const Join& join, Child& child);
  void replace_link(int node, int old_end, int new_end);
  void restore();
  int smallest_subtour() const;

  const LengthModel& model_;
  Links links_;  // links of the parent, changed while a child is built
  std::vector<int> order_, position_;
  struct Undo {
    int node, slot, old_end;
  };
  std::vector<Undo> undo_;
  std::vector<int> cuts_;
  std::vector<Piece> pieces_;
  std::vector<Subtour> subtours_;
  int subtour_count_ = 0;
  std::vector<int> stamp_;
  int stamp_value_ = 0;
  std::vector<std::array<int, 2>> cycles_at_;  // the cycles through a node, -1
  std::vector<int> touched_nodes_;
};

}  // namespace clearcut::order
