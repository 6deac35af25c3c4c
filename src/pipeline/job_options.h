// Options of a job file for a plan, in addition to its part, and the refusal of requested options without effect.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/steps/certify.h"
#include "read/gcode/program/dialect.h"
#include "read/job/job_file.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// The options of a job's [plan], [machine] and [output] with their sources, and the cutting data of its tools. Its
/// operations are already in its part, see part_of_job. Reads the job's tool library and the earlier program. Throws
/// InputError for unknown strategies, even if overridden by a later rule, and for unreadable files.
PlanOptions options_of_job(const JobFile& job);

/// The parts of options.copies.with, each read from its file with the options `over` as the first part was, of a job with what the job
/// `of_first` says of all parts: its [part] without places, its tools, its [plan] and the operations of "*". A job is read as it is.
/// Numbers of outlines are those of the first part's drawing alone.
///
/// Throws  as read_part() and part_of_job(), and where a job of a further part has several set-ups, or states for the whole plan what
///         `options` do not: that is of the sheet.
std::vector<NestedPart> read_nested_parts(const PlanOptions& options, const std::optional<JobFile>& of_first,
                                          const ReadOptions& over);

/// Cutting data stated by a library for its tools, in their order; `preset` names one of several sets, "" the first.
std::vector<ToolCutting> cutting_of_tools(const std::vector<LibraryTool>& tools, const std::string& preset);

/// Reads into `options` an earlier program on the same stock on options.machine: its moves, the state of the control
/// meanwhile, and the conditions for these moves. `dialect`: the control; absent, or if it does not accept the
/// program: recognised. Throws InputError.
void read_earlier_program(PlanOptions& options, const std::string& file, std::optional<Dialect> dialect = {});

/// An option without effect: its place ("--lead", "job.toml:12: lead"), and why it has none.
struct IdleOption {
  std::string place;
  std::string reason;
};

/// All options of the user or of a job (by `asked.sources`) without effect in the plan of one of several parts.
std::vector<IdleOption> idle_options(const PlanResult& result, const ResolvedPlan& plan,
                                     const PlanOptions& asked);

/// Throws InputError for the first option of the user or of a job (by `asked.sources`) that serves other inputs or other
/// kinds of work than those of this part, before it is planned.
void refuse_options_for_others(const ResolvedPlan& plan, const PlanOptions& asked);

/// Throws InputError for the first option of the user or of a job (by `asked.sources`) without effect in this plan,
/// naming its purpose. `planned` is the toolpath before posting.
void refuse_idle_options(const PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan,
                         const PlanOptions& asked);

}  // namespace clearcut::pipeline
