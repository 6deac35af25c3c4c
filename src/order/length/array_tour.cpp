#include "order/length/array_tour.h"

#include <algorithm>

#include "base/error.h"

namespace clearcut::order {

ArrayTour::ArrayTour(std::vector<int> nodes) : order_(std::move(nodes)), position_(order_.size()) {
  for (int p = 0; p < size(); ++p) position_[order_[p]] = p;
}

// Piece r of the old tour is between the r-th and the (r+1)-th removed edge; its ends are 2r (first node)
// and 2r + 1 (last node). Added edges join ends; the new tour enters a piece at one end and leaves by the
// other.
int ArrayTour::walk(const Exchange& exchange, std::array<Piece, kMostExchanged>& pieces) const {
  const int k = exchange.count;
  struct Cut {
    int position;   // position of the node before the cut
    int before_at;  // index into t of the node before, after
    int after_at;
  };
  std::array<Cut, kMostExchanged> cuts;
  for (int i = 0; i < k; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int pa = position_[exchange.t[a]], pb = position_[exchange.t[b]];
    const bool forward = pb == pa + 1 || (pb == 0 && pa == size() - 1 && size() > 2);
    cuts[i] = forward ? Cut{pa, a, b} : Cut{pb, b, a};
    for (int j = i; j > 0 && cuts[j].position < cuts[j - 1].position; --j) std::swap(cuts[j], cuts[j - 1]);
  }
  std::array<int, 2 * kMostExchanged> end_of_t, t_of_end, first, length;
  for (int r = 0; r < k; ++r) {
    const int last_end = 2 * (r == 0 ? k - 1 : r - 1) + 1;
    end_of_t[cuts[r].before_at] = last_end;
    t_of_end[last_end] = cuts[r].before_at;
    end_of_t[cuts[r].after_at] = 2 * r;
    t_of_end[2 * r] = cuts[r].after_at;
    first[r] = cuts[r].position + 1 == size() ? 0 : cuts[r].position + 1;
    length[r] =
        r + 1 < k ? cuts[r + 1].position - cuts[r].position : cuts[0].position + size() - cuts[r].position;
  }
  int count = 0, end = 0;
  do {
    const int piece = end / 2;
    pieces[count++] = {first[piece], length[piece], end % 2 == 1};
    const int t = t_of_end[end ^ 1];
    const int partner = t % 2 == 1 ? (t + 1 == 2 * k ? 0 : t + 1) : (t == 0 ? 2 * k - 1 : t - 1);
    end = end_of_t[partner];
  } while (end != 0 && end != 1 && count < k);
  return end == 0 ? count : 0;
}

bool ArrayTour::is_tour(const Exchange& exchange, int most) const {
  std::array<Piece, kMostExchanged> pieces;
  if (walk(exchange, pieces) != exchange.count) return false;
  if (most >= size()) return true;
  int longest = 0;
  for (int i = 0; i < exchange.count; ++i) longest = std::max(longest, pieces[i].length);
  return size() - longest <= most;
}

void ArrayTour::apply(const Exchange& exchange) {
  std::array<Piece, kMostExchanged> pieces;
  const int k = walk(exchange, pieces);
  CLEARCUT_ASSERT(k == exchange.count);
  const auto longest = std::max_element(pieces.begin(), pieces.begin() + k,
                                        [](const Piece& a, const Piece& b) { return a.length < b.length; });
  std::rotate(pieces.begin(), longest, pieces.begin() + k);
  if (pieces[0].reversed) {
    std::reverse(pieces.begin() + 1, pieces.begin() + k);
    for (int i = 0; i < k; ++i) pieces[i].reversed = !pieces[i].reversed;
  }
  buffer_.clear();
  for (int i = 1; i < k; ++i) {
    int p = pieces[i].reversed ? pieces[i].first + pieces[i].length - 1 : pieces[i].first;
    if (p >= size()) p -= size();
    for (int j = 0; j < pieces[i].length; ++j) {
      buffer_.push_back(order_[p]);
      if (pieces[i].reversed) {
        p = p == 0 ? size() - 1 : p - 1;
      } else {
        p = p + 1 == size() ? 0 : p + 1;
      }
    }
  }
  int first_written = pieces[0].first + pieces[0].length;
  if (first_written >= size()) first_written -= size();
  rewrite(first_written, buffer_);
}

void ArrayTour::rewrite(int first, std::span<const int> nodes) {
  if (!forget_) rewrites_.push_back({first, static_cast<int>(nodes.size())});
  int p = first;
  for (std::size_t i = 0; i < nodes.size() && !forget_; ++i) {
    old_nodes_.push_back(order_[p]);
    p = p + 1 == size() ? 0 : p + 1;
  }
  write(first, nodes);
}

void ArrayTour::write(int first, std::span<const int> nodes) {
  int p = first;
  for (const int node : nodes) {
    order_[p] = node;
    position_[node] = p;
    p = p + 1 == size() ? 0 : p + 1;
  }
}

void ArrayTour::undo_last() {
  const Rewrite rewrite = rewrites_.back();
  rewrites_.pop_back();
  const std::size_t begin = old_nodes_.size() - static_cast<std::size_t>(rewrite.length);
  write(rewrite.first, std::span(old_nodes_).subspan(begin));
  old_nodes_.resize(begin);
}

void ArrayTour::undo() {
  while (!rewrites_.empty()) undo_last();
}

void ArrayTour::commit() {
  rewrites_.clear();
  old_nodes_.clear();
}

}  // namespace clearcut::order
