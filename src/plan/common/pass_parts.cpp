#include "plan/common/pass_parts.h"

#include <algorithm>
#include <utility>

namespace clearcut::plan {
namespace {

/// The passes among which those of a layer have several parts, or none.
class Replacement {
 public:
  Replacement(const std::vector<Pass>& passes, std::vector<std::vector<Pass>> parts) : passes_(passes) {
    for (auto& some : parts) {
      numbers_.emplace_back();
      for (Pass& part : some) {
        numbers_.back().push_back(static_cast<int>(replaced_.size()));
        replaced_.push_back(std::move(part));
      }
    }
  }

  std::vector<Pass> take() {
    for (std::size_t i = 0; i < passes_.size(); ++i) set_sequence(i);
    for (std::size_t i = 0; i < passes_.size(); ++i) follow(passes_[i].parent, numbers_[i]);
    return std::move(replaced_);
  }

 private:
  const std::vector<int>& numbers_of(int pass) const { return numbers_[static_cast<std::size_t>(pass)]; }
  const Pass& pass(int number) const { return passes_[static_cast<std::size_t>(number)]; }

  void set_sequence(std::size_t i) {
    int around = passes_[i].parent;
    while (around >= 0 && numbers_of(around).empty()) around = pass(around).parent;
    std::vector<int> after;
    for (const int before : passes_[i].after)
      after.insert(after.end(), numbers_of(before).begin(), numbers_of(before).end());
    for (const int number : numbers_[i]) {
      Pass& part = replaced_[static_cast<std::size_t>(number)];
      part.after = after;
      part.parent = around < 0 ? -1 : numbers_of(around).front();
    }
  }

  /// The first part of the pass around is the parent; its other parts follow by `after`.
  void follow(int around, const std::vector<int>& inside) {
    if (around < 0) return;
    const std::vector<int>& parts = numbers_of(around);
    for (std::size_t k = 1; k < parts.size(); ++k) {
      std::vector<int>& after = replaced_[static_cast<std::size_t>(parts[k])].after;
      after.insert(after.end(), inside.begin(), inside.end());
    }
  }

  const std::vector<Pass>& passes_;
  std::vector<std::vector<int>> numbers_;  ///< of the parts of each pass, among `replaced_`
  std::vector<Pass> replaced_;
};

}  // namespace

void replace_passes(LayerPasses& layer, std::vector<std::vector<Pass>> parts) {
  layer.passes = Replacement(layer.passes, std::move(parts)).take();
}

std::vector<Path> stretches_inside(const Path& path, bool closed, const Regions& where) {
  std::vector<Path> found;
  bool joined = false, all = true;
  for (const auto& edge : path) {
    std::vector<double> cuts{0, 1};
    for (const auto& region : where) {
      if (!region.box().overlaps(edge.box())) continue;
      for (const auto& side : region.edges()) {
        for (const Vec2 p : intersections(edge, side)) cuts.push_back(nearest(edge, p).t);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if ((cuts[i] - cuts[i - 1]) * edge.length() < 1e-6) continue;
      const bool inside = contains(where, edge.at((cuts[i - 1] + cuts[i]) / 2));
      if (inside) {
        if (!joined) found.emplace_back();
        found.back().push_back(cuts[i] - cuts[i - 1] >= 1 ? edge : edge.part(cuts[i - 1], cuts[i]));
      }
      joined = inside;
      all = all && inside;
    }
  }
  const bool wraps =
      closed && !all && found.size() > 1 && joined && found.front().front().from == path.front().from;
  if (wraps) {
    found.back().insert(found.back().end(), found.front().begin(), found.front().end());
    found.erase(found.begin());
  }
  return found;
}

}  // namespace clearcut::plan
