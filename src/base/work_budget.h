// A limit on the work of one task, counted in steps, not in time: the same on every machine.
#pragma once

#include <cstdint>
#include <stdexcept>

namespace clearcut::inline base {

/// A task took more steps than it was given.
class OutOfWork : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// While a budget exists, the steps of this thread count against it; an inner budget replaces an outer one. Loops of
/// possibly unbounded length count their steps; without a budget, counting costs nothing.
class WorkBudget {
 public:
  explicit WorkBudget(std::uint64_t steps) : left_(steps), outer_(current_) { current_ = this; }
  ~WorkBudget() { current_ = outer_; }
  WorkBudget(const WorkBudget&) = delete;
  WorkBudget& operator=(const WorkBudget&) = delete;

  /// Tasks run on any free thread have their own bounds and are not counted.
  static WorkBudget unlimited() { return WorkBudget(UINT64_MAX); }

  /// Steps that are left of this budget.
  std::uint64_t left() const { return left_; }

  /// Throws OutOfWork when no steps are left. One step: some microseconds, or some hundred bytes.
  static void spend(std::uint64_t steps) {
    if (current_ == nullptr) return;
    if (steps > current_->left_) throw OutOfWork("more work than this task was given");
    current_->left_ -= steps;
  }

 private:
  std::uint64_t left_;
  WorkBudget* outer_;
  inline static thread_local WorkBudget* current_ = nullptr;
};

}  // namespace clearcut::inline base
