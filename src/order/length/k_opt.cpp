#include "order/length/k_opt.h"

namespace clearcut::order {

KOptBreadth two_opt_breadth() {
  return {{10, 0}};
}
KOptBreadth default_breadth() {
  return {{5, 3, 1, 0}};
}

KOpt::KOpt(const LengthModel& model, std::vector<int> nodes, KOptBreadth breadth)
    : model_(model),
      tour_(std::move(nodes)),
      breadth_(breadth),
      queued_(static_cast<std::size_t>(tour_.size())) {}

KOpt::Cost KOpt::improve(const StopWatch* watch) {
  gained_ = 0;
  int steps = 0;
  while (head_ < queue_.size()) {
    const int node = queue_[head_++];
    queued_[node] = false;
    while (improve_node(node)) {
    }
    if (head_ > 4096 && head_ * 2 > queue_.size()) {
      queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(head_));
      head_ = 0;
    }
    if (watch && ++steps % 256 == 0 && watch->over()) break;
  }
  for (; head_ < queue_.size(); ++head_) queued_[queue_[head_]] = false;
  queue_.clear();
  head_ = 0;
  return gained_;
}

bool KOpt::improve_node(int t0) {
  for (const int t1 : {tour_.next(t0), tour_.previous(t0)}) {
    exchange_.t[0] = t0;
    exchange_.t[1] = t1;
    if (extend(1, model_.cost(t0, t1))) return true;
  }
  return false;
}

bool KOpt::is_removed(int a, int b, int depth) const {
  for (int i = 0; i < depth; ++i) {
    const int p = exchange_.t[2 * i], q = exchange_.t[2 * i + 1];
    if ((p == a && q == b) || (p == b && q == a)) return true;
  }
  return false;
}

/// `depth` edges are removed and depth - 1 added; `gain` is the balance, t[2 depth - 1] the loose end.
bool KOpt::extend(int depth, Cost gain) {
  const int loose = exchange_.t[2 * depth - 1];
  const int after = tour_.next(loose), before = tour_.previous(loose);
  const auto candidates = model_.candidates(loose);
  const auto costs = model_.candidate_costs(loose);
  int tries = breadth_.at[depth - 1];
  const bool deeper = depth + 1 < kMostExchanged && breadth_.at[depth] > 0;
  for (std::size_t i = 0; i < candidates.size() && tries > 0; ++i) {
    const int c = candidates[i];
    const Cost rest = gain - costs[i];
    if (rest <= 0) break;
    if (c == after || c == before) continue;
    --tries;
    for (const int d : {tour_.next(c), tour_.previous(c)}) {
      if (d == exchange_.t[0] || is_removed(c, d, depth)) continue;
      exchange_.t[2 * depth] = c;
      exchange_.t[2 * depth + 1] = d;
      exchange_.count = depth + 1;
      const Cost total = rest + model_.cost(c, d);
      if (close(total) || (deeper && extend(depth + 1, total))) return true;
    }
  }
  return false;
}

bool KOpt::close(Cost gain) {
  const int first = exchange_.t[0], last = exchange_.t[2 * exchange_.count - 1];
  const Cost closing = model_.cost_below(last, first, gain);
  if (closing >= gain || !tour_.is_tour(exchange_, most_rewritten_)) return false;
  tour_.apply(exchange_);
  gained_ += gain - closing;
  for (int i = 0; i < 2 * exchange_.count; ++i) touch(exchange_.t[i]);
  return true;
}

}  // namespace clearcut::order
