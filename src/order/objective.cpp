#include "order/objective.h"

#include "base/error.h"
#include "base/text.h"

namespace clearcut::order {

namespace {

class WholePath final : public PathValue {
 public:
  WholePath(const Objective& objective, const Moves& moves) : objective_(objective), moves_(moves) {}
  double of(std::span<const int> tour) override { return objective_.path(moves_, tour); }

 private:
  const Objective& objective_;
  const Moves& moves_;
};

}  // namespace

std::unique_ptr<PathValue> Objective::path_value(const Moves& moves) const {
  return std::make_unique<WholePath>(*this, moves);
}

Evaluator::Evaluator(const Objective& objective, const Moves& moves)
    : objective_(objective),
      moves_(moves),
      path_(objective.path_dependent() ? objective.path_value(moves) : nullptr) {}

double Evaluator::operator()(std::span<const int> tour) {
  double value = objective_.constant() + (path_ ? path_->of(tour) : 0);
  each_edge(moves_.problem(), tour, [&](int a, int b) { value += objective_.edge(moves_, a, b); });
  each_corner(moves_.problem(), tour,
              [&](int a, int b, int c) { value += objective_.corner(moves_, a, b, c); });
  return value;
}

double evaluate(const Objective& objective, const Moves& moves, std::span<const int> tour) {
  return Evaluator(objective, moves)(tour);
}

TourFigures figures(const Moves& moves, std::span<const int> tour) {
  TourFigures result;
  each_edge(moves.problem(), tour, [&](int a, int b) {
    const MoveShape shape = moves.shape(a, b);
    result.length += shape.length;
    result.turns += shape.inner_turns;
    result.angle_deg += shape.inner_angle;
  });
  each_corner(moves.problem(), tour, [&](int a, int b, int c) {
    result.turns += moves.turns_at(a, b, c) ? 1 : 0;
    result.angle_deg += moves.angle_at(a, b, c);
  });
  return result;
}

namespace {

class Length final : public Objective {
 public:
  std::string name() const override { return "length"; }
  std::string unit() const override { return "mm"; }
  double edge(const Moves& moves, int a, int b) const override { return moves.length(a, b); }
  Linear linear() const override { return {.length = 1}; }
};

}  // namespace

ObjectivePtr length_objective() {
  return std::make_shared<Length>();
}

namespace {

class Turns final : public Objective {
 public:
  std::string name() const override { return "turns"; }
  std::string unit() const override { return "turns"; }
  double edge(const Moves& moves, int a, int b) const override { return moves.inner_turns(a, b); }
  double corner(const Moves& moves, int a, int b, int c) const override {
    return moves.turns_at(a, b, c) ? 1 : 0;
  }
  Linear linear() const override { return {.turns = 1}; }
};

}  // namespace

ObjectivePtr turns_objective() {
  return std::make_shared<Turns>();
}

namespace {

class Angle final : public Objective {
 public:
  std::string name() const override { return "angle"; }
  std::string unit() const override { return "deg"; }
  double edge(const Moves& moves, int a, int b) const override { return moves.inner_angle(a, b); }
  double corner(const Moves& moves, int a, int b, int c) const override { return moves.angle_at(a, b, c); }
  Linear linear() const override { return {.angle = 1}; }
};

}  // namespace

ObjectivePtr angle_objective() {
  return std::make_shared<Angle>();
}

namespace {

/// CPO-rho eq. 9, T = sum L / V_f + 2 (1 + nd) tau: every discontinuity costs a stop and a start.
class MachiningTime final : public Objective {
 public:
  MachiningTime(double feed_mm_per_min, double tau_s) : seconds_per_mm_(60 / feed_mm_per_min), tau_(tau_s) {}
  std::string name() const override { return "time"; }
  std::string unit() const override { return "s"; }
  double edge(const Moves& moves, int a, int b) const override {
    const double stops = moves.has_detours() ? 2 * tau_ * moves.shape(a, b).inner_turns : 0;
    return moves.length(a, b) * seconds_per_mm_ + stops;
  }
  double corner(const Moves& moves, int a, int b, int c) const override {
    return moves.turns_at(a, b, c) ? 2 * tau_ : 0;
  }
  Linear linear() const override {
    return {.length = seconds_per_mm_, .turns = 2 * tau_, .constant = 2 * tau_};
  }

 private:
  double seconds_per_mm_, tau_;
};

}  // namespace

ObjectivePtr time_objective(double feed_mm_per_min, double tau_s) {
  if (!(feed_mm_per_min > 0) || !(tau_s >= 0)) {
    throw InputError("objective time", "needs a feed above 0 mm/min and a stop time of at least 0 s");
  }
  return std::make_shared<MachiningTime>(feed_mm_per_min, tau_s);
}

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
