// Functions of include/clearcut/part.h, by calls of the stages.
#include <clearcut/part.h>

#include <utility>

#include "post/part/part_writers.h"
#include "read/common/moved_part.h"
#include "read/drawing/layer_rules.h"
#include "read/gcode/program/dialect.h"
#include "read/job/job_file.h"
#include "read/job/job_setups.h"
#include "read/job/machine_file.h"
#include "read/job/machine_library.h"
#include "read/job/project_file.h"
#include "read/job/read_part.h"
#include "read/stepnc/executables.h"
#include "read/tools/tool_library.h"
#include "resolve/resolve.h"

namespace clearcut {

Part read_part(const std::filesystem::path& file, const ReadOptions& options) {
  return read::read_part(file, options);
}

Part read_part_of_setup(const std::filesystem::path& file, int number, const ReadOptions& options,
                        SetupPlace& place) {
  return read::read_part_of_setup(file, number, options, place);
}

Part read_part_text(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  return read::read_part_text(text, file_name, options);
}

LayerRule rule_named(const std::string& kind, const std::string& place) {
  return read::rule_named(kind, place);
}

LayerRule rule_of_option(const std::string& text, const std::string& place) {
  return read::rule_of_option(text, place);
}

int setups_of_program(const std::filesystem::path& file) {
  return read::setups_of_program(file);
}

bool is_project_name(const std::string& path) {
  return read::is_project_name(path);
}

std::string job_text(const Part& part, const std::string& part_file, const StatedOptions& stated) {
  return read::job_text(part, part_file, stated);
}

ZeroPoint parse_zero_point(const std::string& text, const std::string& place) {
  return read::parse_zero_point(text, place);
}

Part part_of_job(const JobFile& job, const ReadOptions& over) {
  return read::part_of_job(job, over);
}

Part part_of_job(const JobFile& job, const ReadOptions& over, StepSources& sources, StepChoices& published) {
  return read::part_of_job(job, over, sources, published);
}

Part part_of_setup(const JobFile& job, int number, const ReadOptions& over, SetupPlace& place,
                   StepSources& sources, StepChoices& published) {
  return read::part_of_setup(job, number, over, place, sources, published);
}

JobFile read_job(const std::filesystem::path& file) {
  return read::read_job(file);
}

JobFile read_job_text(std::string_view text, const std::string& file_name) {
  return read::read_job_text(text, file_name);
}

ProjectFile read_project(const std::string& path) {
  return read::read_project(path);
}

std::vector<LibraryTool> tools_of_job(const JobFile& job) {
  return read::tools_of_job(job);
}

Part with_zero_at(Part part, const std::array<double, 3>& zero) {
  return read::with_zero_at(std::move(part), zero);
}

std::array<double, 3> zero_of(const Part& part, const ZeroPoint& zero) {
  return read::zero_of(part, zero);
}

std::vector<std::string> ap238_lines(std::string_view text, const std::string& file_name) {
  return read::stepnc::ap238_lines(text, file_name);
}

void fill_machine_kind(Machine& machine, const std::string& kind) {
  read::fill_machine_kind(machine, kind);
}

std::optional<Machine> library_machine(std::string_view name) {
  return read::library_machine(name);
}

std::vector<std::string> machine_kinds() {
  return read::machine_kinds();
}

const std::vector<LibraryMachine>& machine_library() {
  return read::machine_library();
}

Sources machine_sources(const std::filesystem::path& file) {
  return read::machine_sources(file);
}

const CuttingPreset* preset_of(const LibraryTool& tool, const std::string& name) {
  return read::preset_of(tool, name);
}

Machine read_machine(const std::filesystem::path& file) {
  return read::read_machine(file);
}

Machine read_machine_text(std::string_view text, const std::string& file_name) {
  return read::read_machine_text(text, file_name);
}

ToolLibrary read_tool_library(const std::filesystem::path& file, const ToolOptions& options) {
  return read::read_tool_library(file, options);
}

ToolLibrary read_tool_library_text(std::string_view text, const std::string& file_name,
                                   const ToolOptions& options) {
  return read::read_tool_library_text(text, file_name, options);
}

std::string write_outline_json(const Part& part) {
  return post::write_outline_json(part);
}

std::string write_stepnc(const Part& part) {
  return post::write_stepnc(part);
}

std::string write_stepnc(const Part& part, const Toolpath& toolpath) {
  return post::write_stepnc(part, toolpath);
}

ReadOptions read_options_of(const InputOptions& input) {
  return read::read_options_of(input);
}

const std::vector<std::string>& limits_of_kinds() {
  return read::limits_of_kinds();
}

void number_tools(std::vector<Tool>& tools) {
  resolve::number_tools(tools);
}

std::optional<Dialect> dialect_named(std::string_view name) {
  return read::gcode::dialect_named(name);
}

std::string_view name_of(Dialect dialect) {
  return read::gcode::name_of(dialect);
}

}  // namespace clearcut
