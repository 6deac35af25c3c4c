#include "plan_arguments.h"

#include <filesystem>

#include "base/error.h"
#include "read/job/machine_file.h"
#include "read/tools/tool_library.h"

namespace clearcut::cli {
namespace {

const std::map<std::string, EntryKind> kEntries{{"helix", EntryKind::kHelix},
                                                {"ramp", EntryKind::kRamp},
                                                {"zigzag", EntryKind::kZigzagRamp},
                                                {"plunge", EntryKind::kPlunge}};
const std::map<std::string, CutDirection> kDirections{{"climb", CutDirection::kClimb},
                                                      {"conventional", CutDirection::kConventional}};

template <class Value>
std::optional<Value> named(const std::map<std::string, Value>& names, const std::optional<std::string>& name,
                           const char* option) {
  if (!name) return std::nullopt;
  const auto found = names.find(*name);
  if (found != names.end()) return found->second;
  std::string known;
  for (const auto& [text, value] : names) known += (known.empty() ? "" : ", ") + text;
  throw InputError(option, "'" + *name + "' is unknown; use one of " + known);
}

std::optional<MmPerMin> feed_of(const std::optional<double>& mm_per_min) {
  if (!mm_per_min) return std::nullopt;
  return MmPerMin::of(*mm_per_min);
}

}  // namespace

void PlanArguments::add_part_options(CLI::App& command, const std::string& input_name) {
  if (input_name == "INPUT") {
    command.add_option("INPUT", input_, "Part: .p21 .stp .step .stpnc .dxf .svg .json .edges .toml")
        ->required();
  } else {
    command.add_option(input_name, input_, "Part the program is for")->required();
  }
  command.add_option("--unit", unit_, "Unit of a drawing that names none: mm, cm, m, inch, px");
  command.add_option("--layer", layers_, "Layer of a drawing to read (repeatable; default all)");
  command.add_option("--top", top_, "Z of the top of the material for outlines and drawings, mm");
  command.add_option("--depth", depth_, "Depth of every outline of a drawing, mm");
}

void PlanArguments::add_tool_list_options(CLI::App& command) {
  command.add_option(
      "--tool", tools_,
      "KIND:DIAMETER[:T3][:flutes=2][:corner=0.5][:name=N][:noplunge]; kinds: endmill, facemill, bullnose, "
      "ball, drill, reamer (repeatable)");
  command.add_option("--tools", tool_library_, "Tool library: .fctb .fctl .tbl .json .toml");
}

void PlanArguments::add_tool_options(CLI::App& command) {
  add_tool_list_options(command);
  command.add_option("--machine", machine_file_, "Machine file (.toml): limits, acceleration, rapid");
  command.add_option("--acceleration", acceleration_, "Acceleration of the machine, mm/s2");
  command.add_option("--junction-deviation", junction_deviation_, "Junction deviation of the machine, mm");
  command.add_option("--rapid", rapid_feed_, "Rapid feed of the machine, mm/min");
  command.add_option("--stepdown", stepdown_, "Depth of one layer, mm");
  command.add_option("--allowance", allowance_, "Stock to leave on walls, mm");
  command.add_option("--allowance-floor", allowance_floor_, "Stock to leave on floors, mm");
  command.add_option("--engagement", engagement_, "Largest engagement angle of the cutter, degrees");
  command.add_option("--threads", threads_, "Threads to use");
}

void PlanArguments::add_cutting_options(CLI::App& command) {
  command.add_option("--strategy", strategy_,
                     "auto, contour, zigzag, spiral, adaptive, or a published method: lom, rho, second, "
                     "lom-corrected, rho-corrected, fixed, loops, pwid, single, double, bisectors");
  command.add_option("--stepover", stepover_,
                     "Distance of passes: fraction of the diameter, 3.5mm, lom, rho[:W], or several with "
                     "commas, one a contour");
  command.add_option("--angle", angle_,
                     "Direction of zigzag lines against x, degrees (default: the fastest)");
  command.add_option("--entry", entry_, "helix, ramp, zigzag or plunge");
  command.add_option("--direction", direction_, "climb or conventional");
  command.add_option("--feed", feed_, "Cutting feed, mm/min");
  command.add_option("--plunge-feed", plunge_feed_, "Plunge feed, mm/min");
  command.add_option("--spindle", spindle_, "Spindle speed, rpm");
  command.add_option("--post", post_,
                     "Controller: linuxcnc, grbl, fanuc, haas, heidenhain, mach3, mach4, marlin");
  command.add_flag("--inch", inch_, "Write the program in inches");
  command.add_option("--clearance", clearance_z_, "Z of rapid travel, mm");
  command.add_option("--objective", objective_,
                     "length, turns, angle, engagement, time, or weights W:..,W:..");
  command.add_option("--time", time_, "Longest search, s");
  command.add_option("--seed", seed_, "Seed of the search");
}

Part PlanArguments::read() const {
  ReadOptions options;
  options.unit = unit_;
  options.layers = layers_;
  options.top = top_;
  options.depth = depth_;
  Part part = read_part(input_, options);
  if (clearance_z_) part.clearance_z = clearance_z_;
  return part;
}

std::optional<JobFile> PlanArguments::job() const {
  if (std::filesystem::path(input_).extension() != ".toml") return std::nullopt;
  return read_job(input_);
}

std::vector<Tool> PlanArguments::tools() const {
  std::vector<Tool> tools;
  if (tool_library_) {
    for (const auto& entry : read_tool_library(*tool_library_, {}).tools) tools.push_back(entry.tool);
  }
  for (const auto& text : tools_) tools.push_back(parse_tool(text));
  return tools;
}

Machine PlanArguments::machine(const std::optional<JobFile>& job) const {
  Machine machine = machine_file_ ? read_machine(*machine_file_) : job ? job->machine : Machine{};
  if (acceleration_) machine.acceleration = *acceleration_;
  if (junction_deviation_) machine.junction_deviation = *junction_deviation_;
  if (rapid_feed_) machine.rapid = MmPerMin::of(*rapid_feed_);
  return machine;
}

/// The command line goes before the job, the job before the defaults.
PlanOptions PlanArguments::options() const {
  const auto from_job = job();
  const JobFile given = from_job.value_or(JobFile{});
  PlanOptions options;
  options.tools = tools();
  options.machine = machine(from_job);
  options.strategy = strategy_.value_or(given.plan.strategy.value_or("auto"));
  options.stepover = stepover_ ? stepover_ : given.plan.stepover;
  options.angle_deg = angle_;
  options.stepdown = stepdown_;
  options.allowance = allowance_;
  options.allowance_floor = allowance_floor_;
  options.engagement_deg = engagement_ ? engagement_ : given.engagement_deg;
  options.entry = named(kEntries, entry_, "--entry");
  options.direction = named(kDirections, direction_, "--direction");
  options.cutting.feed = feed_of(feed_);
  options.cutting.plunge_feed = feed_of(plunge_feed_);
  options.cutting.spindle_rpm = spindle_;
  options.post.dialect = post_.value_or(given.output.post.value_or("linuxcnc"));
  options.post.inch = inch_ || given.output.inch.value_or(false);
  options.objective = objective_.value_or(given.objective.value_or("time"));
  options.time_s = time_ ? time_ : given.time_s;
  options.seed = seed_.value_or(given.seed.value_or(1));
  options.threads = threads_;
  check(options);
  return options;
}

}  // namespace clearcut::cli
