#include "link/link.h"

#include <algorithm>
#include <optional>

#include "kinematics/kinematics.h"
#include "link/linker.h"
#include "link/work.h"

namespace clearcut::link {
namespace {

/// Seconds. A smaller difference is due to rounding, and the order found first is kept.
constexpr double kFaster = 1e-6;

/// Keeps the fastest of several orders of the same passes.
class Fastest {
 public:
  explicit Fastest(const LinkOptions& options) : options_(options) {}

  void add(Linker& linker) {
    auto moves = linker.take_moves();
    const double time = kinematics::kinematic_time(moves, options_.machine).seconds();
    if (!section_.moves.empty() && time >= time_ - kFaster) return;
    time_ = time;
    section_.moves = std::move(moves);
    section_.notes = linker.notes();
  }

  Section take() {
    section_.spindle_clockwise = options_.spindle_clockwise;
    return std::move(section_);
  }

 private:
  const LinkOptions& options_;
  Section section_;
  double time_ = 0;
};

bool same_order(const Linker& a, const Linker& b) {
  return std::equal(a.cuts().begin(), a.cuts().end(), b.cuts().begin(), b.cuts().end(),
                    [](const Cut& c, const Cut& d) { return c.item == d.item; });
}

/// Adds improved orders, found from the order in which `found` has cut the passes.
void add_shorter(const Work& work, Linker& found, const LinkOptions& options, Fastest& fastest) {
  const Linker* from = &found;
  std::optional<Linker> areas;
  for (const Together together : {Together::kAreas, Together::kRuns}) {
    const auto tasks = short_order(work, *from, together);
    if (tasks.empty()) continue;
    Linker linker(work, options, Progress::Layers::kMixed);
    linker.cut_in_order(tasks);
    fastest.add(linker);
    if (together == Together::kAreas) from = &areas.emplace(std::move(linker));
  }
}

}  // namespace

Section link_layers(const std::vector<LayerPasses>& layers, const LinkOptions& options, const Tolerances&) {
  const Work work(layers, options.tool_radius);
  Fastest fastest(options);
  Linker by_layer(work, options, Progress::Layers::kOneByOne);
  by_layer.cut_nearest_first();
  fastest.add(by_layer);
  if (work.layers_may_mix() && !work.has_one_order()) {
    add_shorter(work, by_layer, options, fastest);
    Linker mixed(work, options, Progress::Layers::kMixed);
    mixed.cut_nearest_first();
    if (!same_order(mixed, by_layer)) {
      fastest.add(mixed);
      add_shorter(work, mixed, options, fastest);
    }
  }
  return fastest.take();
}

}  // namespace clearcut::link
