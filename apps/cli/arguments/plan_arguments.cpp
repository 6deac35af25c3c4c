#include "arguments/plan_arguments.h"

#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "arguments/quantities.h"
#include "arguments/suggest.h"

namespace clearcut::cli {
namespace {

/// Of the limits that nothing else states.
void name_kind_as_source(Sources& sources) {
  for (const char* limit : {"min-spindle", "max-spindle", "spindle-power"})
    if (!sources.find(limit)) sources.set(limit, {Origin::kUser, "--machine-kind"});
}

std::optional<MmPerMin> feed_of(const std::optional<double>& mm_per_min) {
  if (!mm_per_min) return std::nullopt;
  return MmPerMin::of(*mm_per_min);
}

Vec2 point_of(const std::string& text, const char* option) {
  Vec2 point;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf%c", &point.x, &point.y, &rest) != 2 || !std::isfinite(point.x) ||
      !std::isfinite(point.y)) {
    throw InputError(option, "'" + text + "' is not a point; write X,Y in mm");
  }
  return point;
}

/// A tool library and the files that its tools lie in.
void add_library(const std::filesystem::path& library, std::vector<CertificateFileName>& files) {
  files.push_back({"tools", library.string()});
  for (const std::string& tool : read_tool_library(library, {}).files) files.push_back({"tools", tool});
}

/// For cutting, plunging, ramps and slots, mm/min.
void take_feeds(const std::array<std::optional<double>, 4>& feeds, CuttingData& cutting) {
  cutting.feed = feed_of(feeds[0]);
  cutting.plunge_feed = feed_of(feeds[1]);
  cutting.ramp_feed = feed_of(feeds[2]);
  cutting.slot_feed = feed_of(feeds[3]);
}

/// Clamps, and holes that are there before the work begins.
void add_places(const std::vector<std::string>& keep_outs, const std::vector<std::string>& predrilled,
                PlanOptions& options) {
  for (const std::string& text : keep_outs) options.keep_outs.push_back(parse_keep_out(text));
  for (const std::string& text : predrilled) options.predrilled.push_back(parse_predrilled(text));
}

/// As the part is turned, by the options or its job.
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

ShopOptions PlanArguments::shop(const ShopOptions& of_job) const {
  ShopOptions own = shop_;
  own.lead_feed = feed_of(lead_feed_);
  own.link_feed = feed_of(link_feed_);
  if (rest_) own.rest = true;
  return own.or_else(of_job);
}

ReadOptions PlanArguments::read_options() const {
  ReadOptions options;
  options.ask_if_unclear = true;
  for (const auto& text : operations_) options.layer_rules.push_back(rule_of_option(text, "--op"));
  if (scale_) options.scale = *scale_;
  options.scale_is_right = scale_.has_value();
  options.mirror = mirror_;
  if (join_gap_) options.join_gap = join_gap_;
  if (open_curves_) {
    options.open_curves = *open_curves_ == "skip" ? OpenCurves::kSkip : OpenCurves::kRefuse;
  }
  if (text_) options.text_outlines = *text_ == "outlines";
  if (strokes_) options.stroke_areas = *strokes_ == "areas";
  options.unit = unit_;
  options.layers = layers_;
  options.top = top_;
  options.depth = depth_;
  options.solid = solid_;
  for (const Tool& tool : tools())
    if (tool.kind == ToolKind::kDrill) options.solid.drills.push_back(tool.diameter);
  if (stock_.has_solid()) options.block = stock_.solid(lies(job(), setup_, solid_)).stock;
  return options;
}

Part PlanArguments::read_overview(DrawingOverview& overview) const {
  ReadOptions options = read_options();
  options.overview = &overview;
  if (setup_.number == 0) return read_part(input_, options);
  JobFile setup = *job();
  setup.stock.reset();  // is that of the first set-up
  Part part = part_of_job(setup, options);
  return part.features.empty() ? part : read(Block::kWhole);
}

Part PlanArguments::read(Block block) const {
  auto from_job = job();
  const auto zero = zero_ ? std::optional(parse_zero_point(*zero_)) : std::nullopt;
  if (from_job && zero) from_job->zero = zero;
  Part part;
  if (setup_.number > 0) {
    if (zero)
      throw InputError("--origin", "each set-up of a job has its own; write origin = ... in its [[setup]]");
    part = read_setup(read_job(input_), block);
  } else if (from_job) {
    part = part_of_job(*from_job, read_options(), step_sources_, step_published_);
  } else {
    part = read_part(input_, read_options());
    if (zero) {
      const auto at = zero_of(part, *zero);
      part = with_zero_at(std::move(part), at);
    }
  }
  if (clearance_z_) part.clearance_z = clearance_z_;
  if (stock_.has_solid()) stock_.lay_out(part);
  part.diagnostics.append(library().diagnostics);
  return part;
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
  if (std::filesystem::path(input).extension() != ".toml") return 0;
  return static_cast<int>(read_job(input).setups.size());
}

/// The part of the chosen set-up on what the set-ups before have left.
Part PlanArguments::read_setup(const JobFile& whole, Block block) const {
  Part part =
      part_of_setup(whole, setup_.number, read_options(), setup_.place, step_sources_, step_published_);
  if (setup_.number == 1 || block == Block::kWhole) return part;
  if (setup_.machined.empty()) setup_.machined = machined_before(whole);
  setup_.carried = carried_stock(setup_.machined, setup_.place, part);
  part.stock = setup_.carried->block;
  part.diagnostics.note("set-up", setup_.carried->told);
  return part;
}

/// From the programs that --earlier-setup names, each of which is checked on what those before it leave.
std::vector<MachinedSetup> PlanArguments::machined_before(const JobFile& whole) const {
  if (static_cast<int>(setup_.earlier_programs.size()) != setup_.number - 1)
    throw InputError("--setup", "set-up " + std::to_string(setup_.number) + " begins with what " +
                                    std::to_string(setup_.number - 1) + " before it " +
                                    (setup_.number > 2 ? "leave" : "leaves") +
                                    "; name their programs in order with --earlier-setup");
  std::vector<MachinedSetup> machined;
  for (int number = 1; number < setup_.number; ++number) {
    const std::string& program = setup_.earlier_programs[static_cast<std::size_t>(number - 1)];
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
    one.part = part_of_setup(whole, number, read_options(), one.place, sources, published);
    const std::vector<Tool> given = tools();
    if (!given.empty()) one.part.tools = given, resolve::number_tools(one.part.tools);
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
                  "Control that runs it: linuxcnc, grbl, fanuc, haas, heidenhain, mach3, mach4, marlin "
                  "(default: recognised)")
      ->check(one_of({"linuxcnc", "grbl", "fanuc", "haas", "heidenhain", "mach3", "mach4", "marlin"}));
}

std::optional<read::gcode::Dialect> PlanArguments::dialect() const {
  if (!dialect_) return std::nullopt;
  const auto dialect = read::gcode::dialect_named(*dialect_);
  if (!dialect)
    throw InputError("--dialect",
                     "'" + *dialect_ +
                         "' is unknown; use one of linuxcnc, grbl, fanuc, haas, heidenhain, mach3, "
                         "mach4, marlin");
  return dialect;
}

/// The one that runs programs that were written before: as it was named, else the one that is posted for.
std::optional<read::gcode::Dialect> PlanArguments::control(const PostOptions& of_job) const {
  return reads_programs_ ? dialect() : read::gcode::dialect_named(post_.options(of_job).dialect);
}

std::vector<Tool> PlanArguments::tools() const {
  std::vector<Tool> tools;
  if (tool_library_) {
    for (const auto& entry : library().tools) tools.push_back(entry.tool);
  }
  for (const auto& text : tools_) tools.push_back(parse_tool(text));
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
  if (!input_.empty()) files.push_back({job ? "job" : "part", input_});
  if (job && !job->part_file.empty()) files.push_back({"part", job->part_file.string()});
  if (tool_library_) add_library(*tool_library_, files);
  if (job && !tool_library_ && job->tool_library) add_library(*job->tool_library, files);
  if (machine_file_) files.push_back({"machine", *machine_file_});
  if (job && !machine_file_ && job->machine_file) files.push_back({"machine", job->machine_file->string()});
  for (const std::string& program : setup_.earlier_programs) files.push_back({"earlier program", program});
  if (stock_.has_solid()) files.push_back({"stock", *stock_.from});
  if (const auto earlier = stock_.program(job)) files.push_back({"earlier program", *earlier});
  return files;
}

ToolLibrary PlanArguments::library() const {
  return tool_library_ ? read_tool_library(*tool_library_, {}) : ToolLibrary{};
}

Machine PlanArguments::machine(const Machine& of_job) const {
  Machine machine = machine_file_ ? read_machine(*machine_file_) : of_job;
  if (machine_kind_) read::fill_machine_kind(machine, *machine_kind_);
  if (acceleration_) machine.acceleration = *acceleration_;
  if (junction_deviation_) machine.junction_deviation = *junction_deviation_;
  if (rapid_feed_) machine.rapid = MmPerMin::of(*rapid_feed_);
  return machine;
}

void PlanArguments::take_sources(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || option->get_lnames().empty()) continue;
    const std::string name = option->get_lnames().front();
    typed_.set(name.starts_with("no-") ? name.substr(3) : name, {Origin::kUser, "--" + name});
  }
}

void CuttingArguments::take(PlanOptions& options) const {
  options.strategy = strategy;
  if (stepover) options.stepover = stepover;
  if (angle) options.angle_deg = angle;
  options.stepdown = stepdown;
  options.allowance = allowance;
  options.allowance_floor = allowance_floor;
  if (engagement) options.engagement_deg = engagement;
  if (entry) options.entry = entry_named(*entry, "--entry");
  if (entry_angle) options.entry_angle = Radians::of_degrees(*entry_angle);
  options.lead = lead;
  if (lead_angle) options.lead_angle = Radians::of_degrees(*lead_angle);
  options.scallop = scallop;
  if (direction) options.direction = direction_named(*direction, "--direction");
  if (order) options.outside_in = order_named(*order, "--order") == ContourOrder::kOutsideIn;
  if (start) options.start = point_of(*start, "--start");
  take_feeds({feed, plunge_feed, ramp_feed, slot_feed}, options.cutting);
  options.cutting.spindle_rpm = spindle;
  if (coolant) options.cutting.coolant = coolant_named(*coolant);
  if (objective) options.objective = *objective;
}

void TabArguments::take(TabOptions& tabs) const {
  // Whatever is typed of how many there are goes before all that the job says of it.
  if (count || spacing || !at.empty()) {
    tabs.count = count.value_or(0);
    tabs.spacing = spacing;
    tabs.at.clear();
    for (const std::string& place : at) tabs.at.push_back(point_of(place, "--tab-at"));
  }
  if (shape) tabs.shape = tab_shape_named(*shape, "--tab-shape");
  if (width) tabs.width = *width;
  if (height) tabs.height = height;
  if (skin) tabs.skin = skin;
}

/// The command line goes before the job, the job before the defaults.
PlanOptions PlanArguments::options() const {
  const auto from_job = job();
  PlanOptions options = from_job ? options_of_job(*from_job) : PlanOptions{};
  options.tools = tools();
  if (tool_library_ || !tools_.empty()) options.tool_cutting = cutting_of_tools(library().tools, "");
  options.machine = machine(options.machine);
  options.accept.insert(options.accept.end(), accept_.begin(), accept_.end());
  if (machine_file_) options.sources.merge(machine_sources(*machine_file_));
  if (machine_kind_) name_kind_as_source(options.sources);
  options.step_sources = step_sources_;
  options.sources.merge(typed_);
  cutting_.take(options);
  tabs_.take(options.tabs);
  options.shop = shop(options.shop);
  // The height that the program calls home is the machine's, which may be another than the job's.
  const auto earlier = stock_.program(from_job);
  if (earlier && (stock_.after || stock_.from || machine_file_))
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
  add_places(keep_outs_, predrilled_, options);
  options.post = post_.options(options.post);
  options.step_published = step_published_;
  if (passage_) options.published.bisector_passages = is_bisector_passage(*passage_, "--passage");
  if (grid_) options.published.published_grid = is_published_grid(*grid_, "--grid");
  if (from_job && solver_.has_settings_alone())
    solver_.refine(options.step_published);
  else
    options.published.solver = solver_.solver();
  if (time_) options.time_s = time_;
  if (seed_) options.seed = *seed_;
  options.threads = threads_;
  check_options(options);
  return options;
}

}  // namespace clearcut::cli
