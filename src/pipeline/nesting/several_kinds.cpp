#include "pipeline/nesting/several_kinds.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "options/copies_options.h"

namespace clearcut::pipeline {
namespace {

/// mm by which sums of lengths may miss a whole number of them.
constexpr double kRoundingMm = 1e-7;

bool meets(const Box& a, const Box& b) {
  return a.min.x < b.max.x - kRoundingMm && b.min.x < a.max.x - kRoundingMm &&
         a.min.y < b.max.y - kRoundingMm && b.min.y < a.max.y - kRoundingMm;
}

bool holds(const Box& outer, const Box& inner) {
  return outer.min.x <= inner.min.x + kRoundingMm && inner.max.x <= outer.max.x + kRoundingMm &&
         outer.min.y <= inner.min.y + kRoundingMm && inner.max.y <= outer.max.y + kRoundingMm;
}

/// The area that is still free, as all its maximal rectangles. Each rectangle in it takes the gap to its right and above it, too,
/// which the free area has beyond the sheet.
class FreeArea {
 public:
  explicit FreeArea(const KindsQuestion& q) {
    const Box whole{{q.edge, q.edge}, {q.width - q.edge + q.gap, q.height - q.edge + q.gap}};
    if (whole.empty()) return;
    rectangles_.push_back(whole);
    for (const Box& one : q.kept_free) take({one.min, one.max + Vec2{q.gap, q.gap}});
  }

  const std::vector<Box>& rectangles() const { return rectangles_; }

  void take(const Box& taken) {
    const auto is_cut = [&](const Box& one) { return meets(one, taken); };
    const auto first = std::stable_partition(rectangles_.begin(), rectangles_.end(),
                                             [&](const Box& one) { return !is_cut(one); });
    const std::vector<Box> cut(first, rectangles_.end());
    rectangles_.erase(first, rectangles_.end());
    const std::size_t kept = rectangles_.size();
    for (const Box& one : cut) add_rests(one, taken);
    drop_held(kept);
  }

 private:
  void add_rests(const Box& one, const Box& taken) {
    if (taken.min.x > one.min.x + kRoundingMm) rectangles_.push_back({one.min, {taken.min.x, one.max.y}});
    if (taken.max.x < one.max.x - kRoundingMm) rectangles_.push_back({{taken.max.x, one.min.y}, one.max});
    if (taken.min.y > one.min.y + kRoundingMm) rectangles_.push_back({one.min, {one.max.x, taken.min.y}});
    if (taken.max.y < one.max.y - kRoundingMm) rectangles_.push_back({{one.min.x, taken.max.y}, one.max});
  }

  /// Of those from `kept` on, the ones that lie in another; those before are maximal as they were.
  void drop_held(std::size_t kept) {
    for (std::size_t i = rectangles_.size(); i-- > kept;) {
      for (std::size_t k = 0; k < rectangles_.size(); ++k) {
        if (k == i || !holds(rectangles_[k], rectangles_[i])) continue;
        rectangles_.erase(rectangles_.begin() + static_cast<std::ptrdiff_t>(i));
        break;
      }
    }
  }

  std::vector<Box> rectangles_;
};

/// Which of the free rectangles takes the next one.
enum class Rule : unsigned char { kShortSide, kLongSide, kBottomLeft };

/// In which order the kinds come.
enum class Sequence : unsigned char { kByArea, kByLongSide, kInTurns };

class Layout {
 public:
  Layout(const KindsQuestion& q, Rule rule) : q_(q), rule_(rule), free_(q), placed_(q.kinds.size(), 0) {}

  void fill(Sequence sequence) {
    std::vector<std::size_t> kinds(q_.kinds.size());
    std::iota(kinds.begin(), kinds.end(), std::size_t{0});
    std::stable_sort(kinds.begin(), kinds.end(), [&](std::size_t a, std::size_t b) {
      return size_of(q_.kinds[a], sequence) > size_of(q_.kinds[b], sequence);
    });
    std::vector<std::size_t> counted, others;
    for (const std::size_t kind : kinds) (q_.kinds[kind].count ? counted : others).push_back(kind);
    if (sequence == Sequence::kInTurns)
      place_in_turns(counted);
    else
      for (const std::size_t kind : counted)
        while (wants(kind) && place(kind)) {
        }
    place_in_turns(others);
  }

  const std::vector<KindPlace>& places() const { return places_; }

  /// The less, the better.
  std::tuple<int, int, int, double> badness() const {
    int without = 0, missing = 0, others = 0;
    for (std::size_t kind = 0; kind < placed_.size(); ++kind) {
      without += placed_[kind] == 0 ? 1 : 0;
      const auto& count = q_.kinds[kind].count;
      (count ? missing : others) += count ? *count - placed_[kind] : placed_[kind];
    }
    return {without, missing, -others, taken_.empty() ? 0 : taken_.max.x * taken_.max.y};
  }

 private:
  static double size_of(const NestKind& kind, Sequence sequence) {
    return sequence == Sequence::kByLongSide ? std::max(kind.width, kind.height) : kind.width * kind.height;
  }

  bool wants(std::size_t kind) const {
    return places_.size() < kMostCopies && (!q_.kinds[kind].count || placed_[kind] < *q_.kinds[kind].count);
  }

  void place_in_turns(std::vector<std::size_t> kinds) {
    while (!kinds.empty())
      std::erase_if(kinds, [&](std::size_t kind) { return !wants(kind) || !place(kind); });
  }

  /// What is left beside it in the free rectangle, or where it lies: the less, the better.
  std::pair<double, double> cost(const Box& free, double width, double height) const {
    const double across = free.width() - width, up = free.height() - height;
    switch (rule_) {
      case Rule::kShortSide:
        return {std::min(across, up), std::max(across, up)};
      case Rule::kLongSide:
        return {std::max(across, up), std::min(across, up)};
      case Rule::kBottomLeft:
        break;
    }
    return {free.min.y + height, free.min.x};
  }

  /// False if it fits nowhere.
  bool place(std::size_t kind) {
    const NestKind& one = q_.kinds[kind];
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::pair<double, double> least{kNone, kNone};
    KindPlace best{kind, {}, false};
    Box taken;
    for (const bool turned : {false, true}) {
      const double width = (turned ? one.height : one.width) + q_.gap,
                   height = (turned ? one.width : one.height) + q_.gap;
      for (const Box& free : free_.rectangles()) {
        if (width > free.width() + kRoundingMm || height > free.height() + kRoundingMm) continue;
        const auto own = cost(free, width, height);
        if (own >= least) continue;
        least = own;
        best.at = free.min;
        best.turned = turned;
        taken = {free.min, free.min + Vec2{width, height}};
      }
    }
    if (taken.empty()) return false;
    free_.take(taken);
    taken_.add(taken);
    places_.push_back(best);
    ++placed_[kind];
    return true;
  }

  const KindsQuestion& q_;
  Rule rule_;
  FreeArea free_;
  std::vector<int> placed_;
  std::vector<KindPlace> places_;
  Box taken_;
};

/// From the lower left corner on, always the nearest that is left.
std::vector<KindPlace> as_neighbours(std::vector<KindPlace> places, const KindsQuestion& q) {
  const auto middle = [&](const KindPlace& place) {
    const NestKind& kind = q.kinds[place.kind];
    return place.at +
           Vec2{place.turned ? kind.height : kind.width, place.turned ? kind.width : kind.height} / 2.0;
  };
  Vec2 at{0, 0};
  for (auto next = places.begin(); next != places.end(); ++next) {
    const auto nearest = std::min_element(next, places.end(), [&](const KindPlace& a, const KindPlace& b) {
      return distance(at, middle(a)) < distance(at, middle(b));
    });
    std::iter_swap(next, nearest);
    at = middle(*next);
  }
  return places;
}

}  // namespace

std::vector<KindPlace> nest_kinds(const KindsQuestion& question) {
  std::optional<Layout> best;
  for (const Rule rule : {Rule::kShortSide, Rule::kLongSide, Rule::kBottomLeft}) {
    for (const Sequence sequence : {Sequence::kByArea, Sequence::kByLongSide, Sequence::kInTurns}) {
      Layout layout(question, rule);
      layout.fill(sequence);
      if (!best || layout.badness() < best->badness()) best.emplace(std::move(layout));
    }
  }
  return as_neighbours(best->places(), question);
}

}  // namespace clearcut::pipeline
