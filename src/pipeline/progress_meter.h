// Counts what is done of a plan for those who wait for it, and ends it when they ask for that.
#pragma once

#include <mutex>

#include "resolve/plan_options.h"

namespace clearcut::pipeline {

/// Safe from several threads; the callback of the options is called by one at a time, with counts that only grow.
class ProgressMeter {
 public:
  explicit ProgressMeter(const resolve::PlanOptions& options) : options_(options) {}

  /// A stage of at most `most` pieces of work begins. Throws Cancelled.
  void begin(Stage stage, std::size_t most);
  /// One of them is done. Throws Cancelled.
  void add();

 private:
  void tell() const;

  const resolve::PlanOptions& options_;
  std::mutex mutex_;
  Progress progress_;
};

}  // namespace clearcut::pipeline
