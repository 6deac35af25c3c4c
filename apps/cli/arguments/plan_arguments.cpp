#include "arguments/plan_arguments.h"

#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "arguments/option_values.h"

namespace clearcut::cli {
namespace {

/// Sets the source of limits not stated otherwise.
void name_kind_as_source(Sources& sources) {
  for (const std::string& limit : limits_of_kinds())
    if (!sources.find(limit)) sources.set(limit, {Origin::kUser, "--machine-kind"});
}

/// Adds a tool library and the files of its tools.
void add_library(const std::filesystem::path& library, std::vector<CertificateFileName>& files) {
  files.push_back({"tools", library.string()});
  for (const std::string& tool : read_tool_library(library, {}).files) files.push_back({"tools", tool});
}

/// Adds a further part of a sheet; of a job what it names, too.
void add_nested(const std::string& file, std::vector<CertificateFileName>& files) {
  if (std::filesystem::path(file).extension() != ".toml") {
    files.push_back({"part", file});
    return;
  }
  files.push_back({"job", file});
  const JobFile job = read_job(file);
  files.push_back({"part", job.part_file.string()});
  if (job.tool_library) add_library(*job.tool_library, files);
}

/// Orientation of the part, from the options or its job.
SolidOptions lies(const std::optional<JobFile>& from_job, const ChosenSetup& setup,
                  const SolidOptions& typed) {
  if (setup.number > 0 || (from_job && !from_job->setups.empty()))
    throw InputError("--stock-from",
                     "the first set-up of a job states its block, and later ones know what the ones before "
                     "leave; leave it out");
  SolidOptions how = from_job ? from_job->read.solid : SolidOptions{};
  if (!typed.up.empty()) how.up = typed.up;
  if (typed.turn_deg != 0) how.turn_deg = typed.turn_deg;
  return how;
}

}  // namespace

void PlanArguments::add_options(CLI::App& command, const std::string& input_name, const std::string& sentence,
                                const std::function<bool(const Row&)>& wanted) {
  command.option_defaults()->group("Input");
  command.add_option(input_name, input_, sentence)->required()->type_name("FILE");
  values_.add(command, wanted);
  command.parse_complete_callback([this] { take_values(); });
}

namespace {

constexpr const char* kInputFiles =
    "Part: .p21 .stp .step .stpnc .dxf .svg .json .edges .toml, or a project (.clearcut.json)";

/// Whether a row concerns the part or the tools at hand.
bool is_of_part_and_tools(const Row& row) {
  return row.group <= Group::kTools;
}

/// Whether a row concerns the outlines of the part's areas.
bool is_of_areas(const Row& row) {
  static const std::set<std::string> others{"setup",      "earlier-setup", "top",
                                            "stock-from", "breakthrough",  "skin"};
  return row.group <= Group::kDrawings && !row.name.starts_with("tab") && !others.contains(row.name);
}

}  // namespace

void PlanArguments::add_plan_options(CLI::App& command) {
  add_options(command, "INPUT", kInputFiles, [](const Row&) { return true; });
}

void PlanArguments::add_info_options(CLI::App& command) {
  add_options(command, "INPUT", kInputFiles, is_of_part_and_tools);
}

void PlanArguments::add_area_options(CLI::App& command) {
  add_options(command, "INPUT", kInputFiles, is_of_areas);
}

void PlanArguments::add_check_options(CLI::App& command) {
  add_options(command, "--part", "Part that the program makes",
              [](const Row& row) { return row.checks != kNoCheck; });
}

std::string PlanArguments::typed_for_planning() const {
  const std::set<std::string> typed = values_.names();
  for (const Row& row : rows())
    if (!is_of_part_and_tools(row) && typed.contains(row.name)) return row.name;
  return "";
}

void PlanArguments::open_project() {
  if (!is_project_name(input_)) return;
  const ProjectFile project = read_project(input_);
  project_ = project.file;
  input_ = project.input;
  for (const auto& [name, values] : project.options) {
    if (values_.has(name) || !values_.knows(name)) continue;
    values_.set(name, values, project_ + ": " + name);
    sources_.set(name.starts_with("no-") ? name.substr(3) : name, {Origin::kJobFile, project_});
  }
}

void PlanArguments::take_values() {
  open_project();
  typed_ = values_.asked();
  setup_.number = typed_.input.setup.value_or(0);
  setup_.earlier_programs = typed_.input.earlier_setups;
  stock_.from = typed_.input.stock_from;
  stock_.after = typed_.input.after;
  const auto from_job = stock_.from || input_.empty() ? std::nullopt : job();
  if (from_job && from_job->stock_from) stock_.from = from_job->stock_from->string();
}

Part PlanArguments::with_given_tools(Part part) const {
  const std::vector<Tool> given = tools();
  if (given.empty()) return part;
  part.tools = given;
  number_tools(part.tools);
  return part;
}

Part PlanArguments::with_typed_tools(Part part) const {
  if (typed_.input.tools.empty()) return part;
  part.tools.clear();
  for (const std::string& text : typed_.input.tools) part.tools.push_back(parse_tool(text));
  number_tools(part.tools);
  return part;
}

SolidOptions PlanArguments::solid() const {
  return read_options_of(typed_.input).solid;
}

ReadOptions PlanArguments::read_options() const {
  ReadOptions options = read_options_of(typed_.input);
  options.ask_if_unclear = true;
  options.solid.tools = tools();
  if (stock_.has_solid()) options.block = stock_.solid(lies(job(), setup_, solid())).stock;
  return options;
}

Part PlanArguments::read_overview(DrawingOverview& overview) const {
  ReadOptions options = read_options();
  options.overview = &overview;
  if (setup_.number == 0) return read_part(input_, options);
  if (!job()) return read(Block::kWhole);
  JobFile setup = *job();
  setup.stock.reset();  // is the stock of the first set-up
  Part part = part_of_job(setup, options);
  return part.features.empty() ? part : read(Block::kWhole);
}

Part PlanArguments::read(Block block) const {
  auto from_job = job();
  const auto& origin = typed_.input.origin;
  const auto zero = origin ? std::optional(parse_zero_point(*origin)) : std::nullopt;
  if (from_job && zero) from_job->zero = zero;
  Part part;
  if (setup_.number > 0) {
    if (zero)
      throw InputError("--origin", "each set-up has its own; in a job write origin = ... in its [[setup]]");
    part = from_job ? read_setup(read_job(input_), block)
                    : on_what_is_left(read_program_setup(setup_.number, setup_.place), block);
  } else if (from_job) {
    part = part_of_job(*from_job, read_options(), step_sources_, step_published_);
  } else {
    part = read_part(input_, read_options());
    if (zero) {
      const auto at = zero_of(part, *zero);
      part = with_zero_at(std::move(part), at);
    }
  }
  if (typed_.input.clearance_z) part.clearance_z = typed_.input.clearance_z;
  if (stock_.has_solid()) stock_.lay_out(part);
  part.diagnostics.append(library().diagnostics);
  refuse_what_serves_other_inputs(part, from_job);
  return part;
}

void PlanArguments::refuse_what_serves_other_inputs(const Part& part,
                                                    const std::optional<JobFile>& from_job) const {
  if (!refuses_idle_) return;
  const InputKinds kind = input_kind_of(part);
  for (const Row& row : rows()) {
    const std::string reason = idle_on_input(row, kind);
    if (reason.empty()) continue;
    if (values_.has(row.name)) throw InputError("--" + row.name, reason);
    // In one of several set-ups a drawing may be turned, too.
    if (!from_job || setup_.number > 0 || row.table != JobTable::kPart) continue;
    std::string key = row.job_key();
    std::replace(key.begin(), key.end(), '_', '-');
    if (const Source* source = from_job->part_sources.find(key))
      throw InputError(source->text + ": " + row.job_key(), reason);
  }
}

std::optional<JobFile> PlanArguments::job() const {
  if (std::filesystem::path(input_).extension() != ".toml") return std::nullopt;
  JobFile job = read_job(input_);
  if (setup_.number == 0) return job;
  if (setup_.number > static_cast<int>(job.setups.size()))
    throw InputError("--setup",
                     std::to_string(setup_.number) + ": " + input_ + " has " +
                         (job.setups.empty() ? "no [[setup]]" : std::to_string(job.setups.size())));
  return job.setups[static_cast<std::size_t>(setup_.number - 1)];
}

int setup_count_of(const std::string& input) {
  if (std::filesystem::path(input).extension() != ".toml") return setups_of_program(input);
  return static_cast<int>(read_job(input).setups.size());
}

/// The part of the chosen set-up on the stock left by earlier set-ups.
Part PlanArguments::read_setup(const JobFile& whole, Block block) const {
  Part part =
      part_of_setup(whole, setup_.number, read_options(), setup_.place, step_sources_, step_published_);
  return on_what_is_left(std::move(part), block);
}

/// A set-up of a STEP-NC program.
Part PlanArguments::read_program_setup(int number, SetupPlace& place) const {
  return read_part_of_setup(input_, number, read_options(), place);
}

Part PlanArguments::on_what_is_left(Part part, Block block) const {
  if (setup_.number == 1 || block == Block::kWhole) return part;
  if (setup_.machined.empty()) setup_.machined = machined_before();
  if (setup_.machined.empty()) return part;  // nothing was cut in any of them
  setup_.carried = carried_stock(setup_.machined, setup_.place, part);
  part.diagnostics.note("set-up", setup_.carried->told);
  return on_block(std::move(part), setup_.carried->block);
}

/// The set-ups with programs named by --earlier-setup. Each program is checked on the stock left by the earlier ones.
std::vector<MachinedSetup> PlanArguments::machined_before() const {
  const bool is_job = std::filesystem::path(input_).extension() == ".toml";
  const JobFile whole = is_job ? read_job(input_) : JobFile{};
  if (static_cast<int>(setup_.earlier_programs.size()) != setup_.number - 1)
    throw InputError("--setup", "set-up " + std::to_string(setup_.number) + " begins with what " +
                                    std::to_string(setup_.number - 1) + " before it " +
                                    (setup_.number > 2 ? "leave" : "leaves") +
                                    "; name their programs in order with --earlier-setup");
  std::vector<MachinedSetup> machined;
  for (int number = 1; number < setup_.number; ++number) {
    const std::string& program = setup_.earlier_programs[static_cast<std::size_t>(number - 1)];
    if (program == kNoProgram) continue;
    PlanArguments before = *this;
    before.setup_ = {};
    before.setup_.number = number;
    before.setup_.machined = machined;
    const Part part = before.read();
    const PlanOptions asked = before.options();
    const CheckResult checked = check_program(part, read_file(program), program, asked, control(asked.post));
    MachinedSetup one;
    StepSources sources;
    StepChoices published;
    one.part = is_job ? part_of_setup(whole, number, read_options(), one.place, sources, published)
                      : read_program_setup(number, one.place);
    const std::vector<Tool> given = tools();
    if (!given.empty()) one.part.tools = given, number_tools(one.part.tools);
    one.toolpath = checked.toolpath;
    one.conditions = open_conditions(checked.findings);
    one.faults = checked.findings.faults;
    machined.push_back(std::move(one));
  }
  return machined;
}

void PlanArguments::add_dialect_option(CLI::App& command) {
  reads_programs_ = true;
  command
      .add_option("--dialect", dialect_,
                  "Control that runs the program: " + controllers_text() + " (default: recognised)")
      ->check(one_of(controller_names()));
}

std::optional<Dialect> PlanArguments::dialect() const {
  if (!dialect_) return std::nullopt;
  const auto dialect = dialect_named(*dialect_);
  if (!dialect)
    throw InputError("--dialect", "'" + *dialect_ + "' is unknown; use one of " + controllers_text());
  return dialect;
}

/// The control of existing programs: the named one, else the one for which programs are posted.
std::optional<Dialect> PlanArguments::control(const PostOptions& of_job) const {
  return reads_programs_ ? dialect()
                         : dialect_named(values_.has("post") ? typed_.plan.post.dialect : of_job.dialect);
}

std::vector<Tool> PlanArguments::tools() const {
  std::vector<Tool> tools;
  if (typed_.input.tool_library) {
    for (const auto& entry : library().tools) tools.push_back(entry.tool);
  }
  for (const auto& text : typed_.input.tools) tools.push_back(parse_tool(text));
  return tools;
}

std::vector<std::string> paths_of(const std::vector<CertificateFileName>& files) {
  std::vector<std::string> paths;
  for (const CertificateFileName& file : files) paths.push_back(file.path);
  return paths;
}

std::vector<CertificateFileName> PlanArguments::input_files() const {
  std::vector<CertificateFileName> files;
  const auto job = this->job();
  if (!project_.empty()) files.push_back({"project", project_});
  if (!input_.empty()) files.push_back({job ? "job" : "part", input_});
  if (job && !job->part_file.empty()) files.push_back({"part", job->part_file.string()});
  const auto& machine_file = typed_.input.machine_file;
  if (typed_.input.tool_library) add_library(*typed_.input.tool_library, files);
  if (job && !typed_.input.tool_library && job->tool_library) add_library(*job->tool_library, files);
  if (machine_file && (is_file(*machine_file) || !library_machine(*machine_file)))
    files.push_back({"machine", *machine_file});
  if (job && !machine_file && job->machine_file) files.push_back({"machine", job->machine_file->string()});
  for (const std::string& program : setup_.earlier_programs)
    if (program != kNoProgram) files.push_back({"earlier program", program});
  if (stock_.has_solid()) files.push_back({"stock", *stock_.from});
  if (const auto earlier = stock_.program(job)) files.push_back({"earlier program", *earlier});
  const auto& typed = typed_.plan.copies.with;
  for (const std::string& text : typed.empty() && job ? job->whole.copies.with : typed)
    if (const auto named = nested_file(text)) add_nested(named->file, files);
  return files;
}

ToolLibrary PlanArguments::library() const {
  return typed_.input.tool_library ? read_tool_library(*typed_.input.tool_library, {}) : ToolLibrary{};
}

Machine PlanArguments::machine(const Machine& of_job) const {
  const Machine stated = typed_.input.machine_file ? read_machine(*typed_.input.machine_file) : of_job;
  const auto is_typed = [&](std::string_view name) { return values_.has(std::string(name)); };
  return with_typed(stated, {typed_.input.machine_kind, typed_.plan.machine, is_typed});
}

void PlanArguments::take_sources(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || option->get_lnames().empty()) continue;
    const std::string name = option->get_lnames().front();
    sources_.set(name.starts_with("no-") ? name.substr(3) : name, {Origin::kUser, "--" + name});
  }
}

/// Settings typed without a solver's name apply to the published solvers of a job's operations.
void PlanArguments::take_solver(PlanOptions& options, bool has_job) const {
  auto& solver = options.published.solver;
  if (!solver) return;
  if (!has_job || values_.has("solver")) return check_solver(*solver);
  bool is_used = false;
  for (auto& [step, choices] : options.step_published) {
    if (!choices.solver || !choices.solver->is_published) continue;
    choices.solver->published.merge(solver->published);
    is_used = true;
  }
  if (!is_used) check_solver(*solver);
  solver.reset();
}

namespace {

/// Any typed option on the number of tabs replaces all such values of the job.
void forget_tabs_of_job(const OptionValues& values, TabOptions& tabs) {
  if (!values.has("tabs") && !values.has("tab-spacing") && !values.has("tab-at")) return;
  tabs.count = 0;
  tabs.spacing.reset();
  tabs.at.clear();
}

}  // namespace

/// The further parts of a sheet.
std::vector<NestedPart> PlanArguments::nested(const PlanOptions& options,
                                              const std::optional<JobFile>& from_job) const {
  if (options.copies.with.empty()) return {};
  if (setup_.number > 0)
    throw InputError("--nest-with", "lies beside a part in one set-up; leave out --setup");
  if (stock_.has_solid())
    throw InputError("--stock-from", "is the block of one part, not a sheet for several; leave it out");
  std::vector<NestedPart> parts = read_nested_parts(options, from_job, read_options());
  if (typed_.input.clearance_z)
    for (NestedPart& one : parts) one.part.clearance_z = typed_.input.clearance_z;
  return parts;
}

/// The command line takes precedence over the job, the job over the defaults.
PlanOptions PlanArguments::options() const {
  const auto from_job = job();
  PlanOptions options = from_job ? options_of_job(*from_job) : PlanOptions{};
  forget_tabs_of_job(values_, options.tabs);
  Asked asked{std::move(options), {}};
  values_.put_into(asked);
  options = std::move(asked.plan);
  options.tools = tools();
  if (typed_.input.tool_library || !typed_.input.tools.empty())
    options.tool_cutting = cutting_of_tools(library().tools, "");
  options.machine = machine(from_job ? from_job->machine : Machine{});
  if (typed_.input.machine_file) {
    const Sources of_machine = machine_sources(*typed_.input.machine_file);
    accept_what_is_held(of_machine, options);
    options.sources.merge(of_machine);
  }
  if (typed_.input.machine_kind) name_kind_as_source(options.sources);
  options.step_sources = step_sources_;
  options.sources.merge(sources_);
  // The height of the program's home is the machine's; this may differ from the job's.
  const auto earlier = stock_.program(from_job);
  if (earlier && (stock_.after || stock_.from || typed_.input.machine_file))
    read_earlier_program(options, *earlier, control(options.post));
  if (stock_.has_solid()) {
    if (options.earlier)
      throw InputError(
          "--stock-from",
          "a solid states what is left, and so does the program that has run before; leave one of them out");
    if (!stock_.is_laid_out()) read();
    options.earlier = stock_.missing(options.tools);
  }
  if (setup_.number > 1 && !setup_.carried) read();
  if (setup_.carried && options.earlier)
    throw InputError("--after", "the set-ups of a job know what the ones before leave; leave it out");
  if (setup_.carried) {
    options.earlier = setup_.carried->sweeps;
    options.conditions = setup_.carried->conditions;
    options.earlier_state.faults = setup_.carried->faults;
  }
  add_places(typed_.input.keep_outs, typed_.input.predrilled, options);
  options.step_published = step_published_;
  take_solver(options, from_job.has_value());
  options.nested = nested(options, from_job);
  options.refuse_idle = options.refuse_idle && refuses_idle_;
  check_options(options);
  return options;
}

}  // namespace clearcut::cli
