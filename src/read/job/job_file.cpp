#include "read/job/job_file.h"

#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/drawing/layer_rules.h"
#include "read/job/job_setups.h"
#include "read/job/machine_file.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargestJob = std::size_t{16} << 20;

fs::path beside(const std::string& job_file, const std::string& name) {
  return (fs::path(job_file).parent_path() / name).generic_string();
}

/// A coordinate: within a kilometre.
std::optional<double> coordinate(DataSection& section, const std::string& key) {
  const auto value = section.number(key);
  if (value && std::abs(*value) > kLargestCoordinate) section.fail_at(key, "lies beyond 1000 m");
  return value;
}

std::optional<int> count(DataSection& section, const std::string& key, double most) {
  const auto value = section.number(key);
  if (!value) return std::nullopt;
  if (*value < 0 || *value > most || *value != std::floor(*value))
    section.fail_at(key, "must be a whole number, 0 or more");
  return static_cast<int>(*value);
}

/// Options permitted in operations, from [plan] or an [[operation]].
CutSettings settings_of(DataSection& section) {
  static const std::vector<std::string> kinds{"roughing",       "finishing", "bottom_finishing",
                                              "side_finishing", "drilling",  "reaming"};
  CutSettings out;
  Asked asked;
  take_options(section, JobTable::kPlan, OptionsOf::kOperations, asked);
  const auto& solver = asked.plan.published.solver;
  if (solver && !solver->is_published && solver->published.is_set())
    section.fail("sets the published solver; add solver = \"published\"");
  if (const auto kind = section.choice("kind", kinds)) out.kind = static_cast<OperationKind>(*kind);
  out.tool = count(section, "tool", 1e6);
  out.asked = std::move(asked.plan);
  return out;
}

void read_part_section(DataSection section, JobFile& job) {
  const auto file = section.text("file");
  if (!file || file->empty()) section.fail("file is missing; add file = \"part.dxf\"");
  job.part_file = beside(job.file, *file);
  Asked asked;
  take_options(section, JobTable::kPart, OptionsOf::kWhole, asked);
  if (asked.input.unit && !mm_per_unit(*asked.input.unit))
    section.fail_at("unit", "is unknown; use one of " + known_units());
  asked.input.find_arcs = section.flag("find_arcs");
  job.read = read_options_of(asked.input);
  if (asked.input.stock_from) job.stock_from = beside(job.file, *asked.input.stock_from);
  if (asked.input.origin) job.zero = parse_zero_point(*asked.input.origin, section.place_of("origin"));
  section.refuse_unknown();
}

LayerRule layer_rule(DataSection section) {
  LayerRule rule;
  const auto name = section.text("name");
  if (!name) section.fail("name is missing; add name = \"POCKET*\"");
  rule.pattern = *name;
  const auto role =
      section.choice("role", {"pocket", "island", "hole", "ignore", "profile", "inside", "engrave", "chamfer",
                              "face", "stock", "vcarve", "isolate", "step", "tslot"});
  if (role) rule.role = static_cast<LayerRole>(*role);
  if (const auto hole = section.text("hole")) {
    // In the words of layers: "tap_m6_thru".
    const LayerMeaning meaning = meaning_of_layer(*hole);
    if (!meaning.hole || (role && rule.role != LayerRole::kHole))
      section.fail_at("hole", "says no kind of hole; write for example hole = \"tap_m6_thru\"");
    rule.role = LayerRole::kHole;
    rule.hole = meaning.hole;
    rule.depth = meaning.depth;
  }
  if (const auto depth = section.positive("depth")) rule.depth = depth;
  rule.top = coordinate(section, "top");
  rule.width = section.positive("width");
  section.refuse_unknown();
  return rule;
}

JobStock stock_of(DataSection section) {
  JobStock stock;
  stock.x = section.range("x");
  stock.y = section.range("y");
  stock.z = section.range("z");
  stock.margin = section.not_negative("margin");
  if (!stock.z) section.fail("z is missing; add z = [bottom, top]");
  if ((!stock.x || !stock.y) && !stock.margin) section.fail("needs x and y, or a margin around the features");
  section.refuse_unknown();
  return stock;
}

void read_tools_section(DataSection section, JobFile& job) {
  const auto library = section.text("library");
  if (!library) section.fail("library is missing; add library = \"tools.toml\"");
  job.tool_library = beside(job.file, *library);
  job.tool_options.unit = section.text("unit");
  job.preset = section.text("preset").value_or("");
  for (const double number : section.numbers("use")) {
    if (number < 0 || number > 1e6) section.fail_at("use", "must list tool numbers");
    job.tool_numbers.push_back(static_cast<int>(number));
  }
  section.refuse_unknown();
}

OperationRule operation_rule(DataSection section) {
  OperationRule rule;
  rule.line = section.line();
  rule.feature = section.text("feature").value_or("*");
  rule.skip = section.flag("skip").value_or(false);
  rule.settings = settings_of(section);
  for (const char* key : {"tabs", "tab_spacing", "tab_at", "tab_shape", "tab_width", "tab_height", "skin"})
    if (section.has(key)) section.fail_at(key, "holds for all profiles and belongs in [plan]");
  section.refuse_unknown();
  return rule;
}

JobOutput output_of(DataSection section, PlanOptions& whole) {
  Asked asked{whole, {}};
  take_options(section, JobTable::kOutput, OptionsOf::kWhole, asked);
  whole = std::move(asked.plan);
  JobOutput out;
  out.program = section.text("program");
  out.certificate = section.text("certificate");
  out.svg = section.text("svg");
  out.report = section.text("report");
  out.setup_sheet = section.text("setup_sheet");
  out.result = section.text("result");
  out.witness = section.text("witness");
  section.refuse_unknown();
  return out;
}

KeepOut keep_out_of(DataSection section) {
  const auto x = section.range("x"), y = section.range("y"), z = section.range("z");
  if (!x || !y || !z) section.fail("a clamp needs x, y and z, each [low, high]");
  section.refuse_unknown();
  return {{{(*x)[0], (*y)[0]}, {(*x)[1], (*y)[1]}}, (*z)[0], (*z)[1]};
}

PredrilledHole predrilled_of(DataSection section) {
  PredrilledHole hole;
  const auto x = coordinate(section, "x"), y = coordinate(section, "y");
  const auto diameter = section.positive("diameter");
  if (!x || !y || !diameter) section.fail("needs x, y and diameter");
  hole.center = {*x, *y};
  hole.diameter = *diameter;
  section.refuse_unknown();
  return hole;
}

void read_plan_section(DataSection section, JobFile& job) {
  job.plan = settings_of(section);
  job.sequence = section.texts("sequence");
  Asked asked{job.whole, {}};
  take_options(section, JobTable::kPlan, OptionsOf::kWhole, asked);
  job.whole = std::move(asked.plan);
  if (asked.input.after) job.after = beside(job.file, *asked.input.after);
  for (std::string& nested : job.whole.copies.with) nested = beside(job.file, nested).string();
  job.stated_keep_outs = asked.input.keep_outs;
  job.stated_predrilled = asked.input.predrilled;
  job.clearance_z = asked.input.clearance_z;
  section.refuse_unknown();
}

void read_machine_section(DataSection section, JobFile& job) {
  Machine base;
  if (const auto file = section.text("file")) job.machine_file = beside(job.file, *file);
  if (job.machine_file) base = read_machine(*job.machine_file);
  job.machine = machine_of_section(section, base);
}

/// Notes the places of the job's keys; the file's sections must have been read.
void note_sources(const DataValue& root, JobFile& job) {
  const auto of = [&](const char* table) {
    const DataValue* found = root.find(table);
    return found ? key_sources(*found, job.file, Origin::kJobFile) : Sources{};
  };
  const DataValue* machine = root.find("machine");
  if (job.machine_file) job.sources.merge(machine_sources(*job.machine_file));
  if (machine) job.sources.merge(machine_sources_of(*machine, job.file, Origin::kJobFile));
  job.plan.sources = of("plan");
  job.sources.merge(job.plan.sources);
  job.sources.merge(of("output"));
  job.part_sources = of("part");
  const DataValue* operations = root.find("operation");
  for (std::size_t i = 0; operations && i < operations->items.size() && i < job.operations.size(); ++i)
    job.operations[i].settings.sources = key_sources(operations->items[i], job.file, Origin::kJobFile);
}

}  // namespace

namespace {

/// A job of one set-up.
JobFile read_one_setup(const DataValue& root, const std::string& file_name) {
  DataSection section(root, file_name, "");
  JobFile job;
  job.file = file_name;
  const auto part = section.section("part");
  if (!part) section.fail("[part] is missing; add [part] with file = \"part.dxf\"");
  read_part_section(*part, job);
  for (DataSection& layer : section.sections("layer"))
    job.read.layer_rules.push_back(layer_rule(std::move(layer)));
  if (const auto stock = section.section("stock")) job.stock = stock_of(*stock);
  if (const auto tools = section.section("tools")) read_tools_section(*tools, job);
  for (DataSection& tool : section.sections("tool")) job.tools.push_back(tool_of_section(std::move(tool)));
  if (const auto machine = section.section("machine")) read_machine_section(*machine, job);
  if (const auto plan = section.section("plan")) read_plan_section(*plan, job);
  for (DataSection& hole : section.sections("predrilled"))
    job.predrilled.push_back(predrilled_of(std::move(hole)));
  for (DataSection& clamp : section.sections("keep_out"))
    job.keep_outs.push_back(keep_out_of(std::move(clamp)));
  for (DataSection& one : section.sections("operation"))
    job.operations.push_back(operation_rule(std::move(one)));
  if (const auto output = section.section("output")) job.output = output_of(*output, job.whole);
  section.refuse_unknown();
  note_sources(root, job);
  return job;
}

/// Reads the job as its first set-up, with all set-ups in it.
JobFile read_setups(const DataValue& root, const std::string& file_name) {
  std::vector<JobFile> setups;
  const DataValue& tables = *root.find("setup");
  for (const DataValue& one : jobs_of_setups(root, file_name)) {
    const DataValue& table = tables.items[setups.size()];
    JobFile job = read_one_setup(one, file_name);
    if (const DataValue* name = table.find("name")) job.setup_name = name->text;
    job.has_own_stock = table.find("stock") != nullptr;
    job.setup_number = static_cast<int>(setups.size()) + 1;
    setups.push_back(std::move(job));
  }
  JobFile job = setups.front();
  job.setup_number = 0;
  job.setups = std::move(setups);
  return job;
}

}  // namespace

JobFile read_job_text(std::string_view text, const std::string& file_name) {
  const DataValue root = parse_toml(text, file_name);
  return root.find("setup") ? read_setups(root, file_name) : read_one_setup(root, file_name);
}

JobFile read_job(const std::filesystem::path& file) {
  return read_job_text(read_file(file.string(), kLargestJob), file.string());
}

}  // namespace clearcut::read
