#include "base/error.h"
#include "order/objective.h"

namespace clearcut::order {

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

}  // namespace clearcut::order
