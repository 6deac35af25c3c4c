// The moves of a program as columns.
#pragma once

#include <optional>

#include "bindings.h"

namespace clearcut::python {

/// Columns of numbers over all moves, section after section. Times and engagement are computed when they are first asked for.
class Moves {
 public:
  /// `result` is a PlanResult or a CheckResult, which lives as long as this.
  template <class Result>
  Moves(const std::shared_ptr<const Result>& result, PlanOptions options)
      : owner_(result),
        part_(&result->part),
        toolpath_(&result->toolpath),
        control_(&result->control),
        options_(std::move(options)) {}

  std::size_t size() const;
  const Toolpath& toolpath() const { return *toolpath_; }
  /// One number of each move.
  template <class Value, class Of>
  py::array_t<Value> column(Of of) const {
    py::array_t<Value> array(static_cast<py::ssize_t>(size()));
    Value* to = array.mutable_data();
    for (const Section& section : toolpath_->sections) {
      for (const Move& move : section.moves) *to++ = of(section, move);
    }
    return array;
  }
  py::array_t<double> times();
  py::array_t<double> engagement(double MoveFigures::*figure);

 private:
  std::shared_ptr<const void> owner_;
  const Part* part_;
  const Toolpath* toolpath_;
  const ControlTable* control_;
  PlanOptions options_;
  std::optional<std::vector<double>> times_;
  std::optional<std::vector<MoveFigures>> figures_;
};

}  // namespace clearcut::python
