#include "order/length/chained_search.h"

#include <algorithm>
#include <array>

namespace clearcut::order {

namespace {
constexpr int kLongestSegment = 50;
constexpr int kKicksBetweenChecks = 64;
constexpr int kLargestFree = 150000;    // points; above, one exchange on the whole array is too slow
constexpr int kLongestRewrite = 50000;  // then
}  // namespace

ChainedSearch::ChainedSearch(const LengthModel& model, std::vector<int> start, KOptBreadth breadth,
                             std::uint64_t seed)
    : model_(model),
      search_(model, std::move(start), breadth),
      random_(seed),
      cost_(model.tour_cost(nodes())) {
  if (model.size() > kLargestFree) search_.rewrite_at_most(kLongestRewrite);
}

void ChainedSearch::descend(const StopWatch& watch) {
  for (const int v : std::vector<int>(nodes())) search_.touch(v);
  search_.tour().forget_changes(true);
  cost_ -= search_.improve(&watch);
  search_.tour().forget_changes(false);
  search_.tour().commit();
}

/// Double bridge on three neighbouring segments A B C -> C B A, each 1 to 50 nodes long.
ChainedSearch::Cost ChainedSearch::kick() {
  ArrayTour& tour = search_.tour();
  const int n = tour.size();
  const int longest = std::min(kLongestSegment, (n - 2) / 3);
  const int before = static_cast<int>(random_.below(static_cast<std::uint64_t>(n)));
  std::array<int, 4> last;  // of "before", A, B, C: offsets from `before`
  last[0] = 0;
  for (int i = 1; i < 4; ++i)
    last[i] = last[i - 1] + 1 + static_cast<int>(random_.below(static_cast<std::uint64_t>(longest)));
  const auto node = [&](int offset) {
    return tour.at(before + offset < n ? before + offset : before + offset - n);
  };
  segments_.clear();
  for (int i = 3; i > 0; --i) {
    for (int offset = last[i - 1] + 1; offset <= last[i]; ++offset) segments_.push_back(node(offset));
  }
  const std::array<int, 8> ends{node(0),       node(1),           node(last[1]), node(last[1] + 1),
                                node(last[2]), node(last[2] + 1), node(last[3]), node(last[3] + 1)};
  const auto cost = [&](int a, int b) { return model_.cost(ends[a], ends[b]); };
  const Cost change =
      cost(0, 5) + cost(6, 3) + cost(4, 1) + cost(2, 7) - cost(0, 1) - cost(2, 3) - cost(4, 5) - cost(6, 7);
  tour.rewrite(before + 1 == n ? 0 : before + 1, segments_);
  for (const int v : ends) search_.touch(v);
  return change;
}

void ChainedSearch::run(long long kicks, const StopWatch& watch) {
  if (nodes().size() < 8) return;
  for (long long i = 0; i < kicks; ++i) {
    if (i % kKicksBetweenChecks == 0 && watch.over()) return;
    const Cost after = cost_ + kick() - search_.improve();
    if (after <= cost_) {
      cost_ = after;
      search_.tour().commit();
    } else {
      search_.tour().undo();
    }
  }
}

}  // namespace clearcut::order
