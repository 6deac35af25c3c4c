// A limit on the work of one task, in steps that are counted, not timed: the same on every machine.
#pragma once

#include <cstdint>
#include <stdexcept>

namespace clearcut::inline base {

/// A task took more steps than it was given.
class OutOfWork : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// While it lives, what this thread spends counts against it; an inner one takes the place of an outer one. Loops that may
/// run away spend; where none lives that costs nothing.
class WorkBudget {
 public:
  explicit WorkBudget(std::uint64_t steps) : left_(steps), outer_(current_) { current_ = this; }
  ~WorkBudget() { current_ = outer_; }
  WorkBudget(const WorkBudget&) = delete;
  WorkBudget& operator=(const WorkBudget&) = delete;

  /// What runs on whatever thread is free has bounds of its own and is not counted.
  static WorkBudget unlimited() { return WorkBudget(UINT64_MAX); }

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
