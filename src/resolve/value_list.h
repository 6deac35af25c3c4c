// Collects what was decided, for people and certificates.
#pragma once

#include <string>
#include <vector>

#include "model/resolved_plan.h"
#include "resolve/plan_options.h"

namespace clearcut::resolve {

/// The values of one workingstep, in the order in which they are added.
class StepValues {
 public:
  /// `read_from`: where the operation was read, for what its sources do not name.
  StepValues(std::vector<ResolvedValue>& all, int step, const Sources& sources, Source read_from)
      : all_(all), step_(step), sources_(sources), read_from_(std::move(read_from)) {}

  /// A value that somebody stated or a default that is among the sources.
  void stated(const char* name, std::string value, const char* unit);
  /// One that stands at `otherwise` unless it was stated.
  void stated_or(bool is_stated, const char* name, std::string value, const char* unit, Source otherwise);
  void add(const char* name, std::string value, const char* unit, Source source);

 private:
  std::vector<ResolvedValue>& all_;
  int step_;
  const Sources& sources_;
  Source read_from_;
};

/// The values of one step. `operation` is as prepared.
void list_step(std::vector<ResolvedValue>& all, const ResolvedPlan& plan, int step, const Source& strategy,
               const Source& stepover);

/// The values of the plan as a whole.
void list_plan(std::vector<ResolvedValue>& all, const ResolvedPlan& plan, const PlanOptions& options);

}  // namespace clearcut::resolve
