#include "base/error.h"
#include "base/text/format.h"
#include "order/objective.h"

namespace clearcut::order {

namespace {

struct WeightedPath final : PathValue {
  double of(std::span<const int> tour) override {
    double total = 0;
    for (const auto& [weight, part] : parts) total += weight * part->of(tour);
    return total;
  }
  std::vector<std::pair<double, std::unique_ptr<PathValue>>> parts;
};

class WeightedSum final : public Objective {
 public:
  explicit WeightedSum(std::vector<std::pair<double, ObjectivePtr>> parts) : parts_(std::move(parts)) {}
  std::string name() const override {
    std::string text;
    for (const auto& [weight, part] : parts_) {
      text += (text.empty() ? "" : ",") + trimmed(weight, 6) + ":" + part->name();
    }
    return text;
  }
  std::string unit() const override { return ""; }
  double edge(const Moves& moves, int a, int b) const override {
    return sum([&](const Objective& o) { return o.edge(moves, a, b); });
  }
  double corner(const Moves& moves, int a, int b, int c) const override {
    return sum([&](const Objective& o) { return o.corner(moves, a, b, c); });
  }
  bool path_dependent() const override {
    for (const auto& p : parts_) {
      if (p.second->path_dependent()) return true;
    }
    return false;
  }
  double path(const Moves& moves, std::span<const int> tour) const override {
    return sum([&](const Objective& o) { return o.path_dependent() ? o.path(moves, tour) : 0.0; });
  }
  std::unique_ptr<PathValue> path_value(const Moves& moves) const override {
    auto sum = std::make_unique<WeightedPath>();
    for (const auto& [weight, part] : parts_) {
      if (part->path_dependent()) sum->parts.emplace_back(weight, part->path_value(moves));
    }
    return sum;
  }
  Linear linear() const override {
    Linear total;
    for (const auto& [weight, part] : parts_) {
      const Linear l = part->linear();
      total.length += weight * l.length;
      total.turns += weight * l.turns;
      total.angle += weight * l.angle;
      total.constant += weight * l.constant;
      total.exact = total.exact && l.exact;
    }
    return total;
  }

 private:
  template <class Part>
  double sum(Part part) const {
    double total = 0;
    for (const auto& [weight, objective] : parts_) total += weight * part(*objective);
    return total;
  }
  std::vector<std::pair<double, ObjectivePtr>> parts_;
};

}  // namespace

ObjectivePtr weighted_sum(std::vector<std::pair<double, ObjectivePtr>> parts) {
  double total = 0;
  for (const auto& [weight, part] : parts) {
    if (!(weight >= 0)) throw InputError("objective", "a weight below 0 has no meaning; use 0 or more");
    total += weight;
  }
  if (!(total > 0)) throw InputError("objective", "a sum needs at least one weight above 0");
  return std::make_shared<WeightedSum>(std::move(parts));
}

}  // namespace clearcut::order
