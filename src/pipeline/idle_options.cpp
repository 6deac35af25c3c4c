#include "pipeline/idle_options.h"

#include <algorithm>

#include "base/error.h"
#include "options/idle.h"
#include "options/row.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// The name under which the origin of a row's value is stored: for switches of defaults that are on, the name of the
/// key.
std::string source_name(const Row& row) {
  std::string name = row.key_is_opposite ? row.job_key() : row.name;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// "--tabs", "job.toml:12: tabs".
std::string place_of(const Row& row, const Source& source) {
  return source.origin == Origin::kJobFile ? source.text + ": " + row.job_key() : source.text;
}

/// Whether the value is the one that requests no effect: 0 tabs, a lift of 0 mm.
bool asks_nothing(const Row& row, const Asked& asked) {
  if (!row.neutral || !row.field.get) return false;
  const auto value = row.field.get(asked, row.names);
  return value && std::get<double>(*value) == *row.neutral;
}

/// Compares the written program with the program written without the option.
std::string idle_in_program(const Row& row, const PlanResult& result, const Toolpath& planned,
                            const ResolvedPlan& plan, const Asked& asked) {
  static const Asked kNothing;
  const auto usual = row.field.get(kNothing, row.names);
  Asked other{asked.plan, {}};
  other.plan.post = plan.post;
  if (usual)
    row.field.set(other, *usual, row.names);
  else if (row.name == "decimals")
    other.plan.post.decimals.reset();
  else if (row.name == "program-number")
    other.plan.post.program_number.reset();
  else
    return "";
  const PostOptions own = plan.post;
  const bool is_same = post::write_program(planned, result.part, own) ==
                       post::write_program(planned, result.part, other.plan.post);
  return is_same ? "the program for " + own.dialect + " is the same without it" : "";
}

bool is_stated(const Source* source) {
  return source && (source->origin == Origin::kUser || source->origin == Origin::kJobFile);
}

}  // namespace

void refuse_idle_options(const PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan,
                         const PlanOptions& options) {
  if (!options.refuse_idle) return;
  const Asked asked{options, {}};
  const Situation situation{plan, options, result.toolpath, result.selections};
  const InputKinds input = input_kind_of(plan.part);
  for (const Row& row : rows()) {
    const Source* source = options.sources.find(source_name(row));
    if (!is_stated(source) || asks_nothing(row, asked)) continue;
    std::string reason = idle_on_input(row, input);
    if (!reason.empty()) throw InputError(place_of(row, *source), reason);
    if (row.effect.idle_because) reason = row.effect.idle_because(situation);
    if (row.group == Group::kController && row.name != "post")
      reason = idle_in_program(row, result, planned, plan, asked);
    if (!reason.empty())
      throw InputError(place_of(row, *source), "has no effect: " + reason + "; leave it out");
  }
}

}  // namespace clearcut::pipeline
