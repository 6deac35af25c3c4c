#include "plan_arguments.h"

#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/verify.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "quantities.h"

namespace clearcut::cli {
namespace {

/// Whether as published.
const std::map<std::string, bool> kGrids{{"ours", false}, {"published", true}};
/// Whether along bisectors.
const std::map<std::string, bool> kPassages{{"bisector", true}, {"shortest", false}};

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
  command.add_option("--top", top_, "Z of the top of the material for outlines and drawings, mm")
      ->transform(as_length());
  command.add_option("--depth", depth_, "Depth of every outline of a drawing, mm")->transform(as_length());
  add_drawing_options(command);
  command.add_option(
      "--up", solid_.up,
      "Side of a solid that looks up: +Z, -Z, +X, -X, +Y, -Y, or face12 for a flat face of `info`");
  command.add_option("--turn", solid_.turn_deg,
                     "Turn of a solid about the vertical, degrees counter-clockwise seen from above");
  command.add_option("--body", solid_.body, "Body of an assembly to make: its name or number, or all");
  command
      .add_option("--breakthrough", solid_.breakthrough,
                  "How far through cuts go below the material, mm (default 0.5; profiles of drawings 0)")
      ->check(CLI::NonNegativeNumber);
}

void PlanArguments::add_drawing_options(CLI::App& command) {
  command.add_option(
      "--op", operations_,
      "KIND:SELECTION, what outlines of a drawing are for: pocket, profile, inside, drill, engrave, vcarve, "
      "face, island or ignore, with a depth as in profile_d6; the selection is a layer, a colour, outer "
      "or numbers of `info` (repeatable)");
  command.add_option("--tabs", tabs_.count, "Tabs that hold what a profile cuts free, of each profile")
      ->check(CLI::Range(0, 100));
  command.add_option("--tab-width", tabs_.width, "Of tabs along the outline, mm (default 4)")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--tab-height", tabs_.height,
                  "Of tabs over the underside of the material, mm (default 2, at most half the depth)")
      ->check(CLI::PositiveNumber);
  command.add_option("--scale", scale_, "Factor for a drawing's size")->check(CLI::PositiveNumber);
  command.add_option("--join-gap", join_gap_, "Gaps in outlines that are closed, mm (default 0.01)")
      ->check(CLI::Range(1e-6, 10.0));
  command.add_option("--open-curves", open_curves_, "Open lines of a drawing: refuse (default) or skip")
      ->check(CLI::IsMember({"refuse", "skip"}));
}

void PlanArguments::add_tool_list_options(CLI::App& command) {
  command.add_option(
      "--tool", tools_,
      "KIND:DIAMETER[:60deg][:tip=0.2][:T3][:flutes=2][:corner=0.5][:length=L][:name=N][:noplunge]; "
      "kinds: endmill, facemill, bullnose, "
      "ball, drill, reamer, vbit, chamfer, spotdrill (repeatable)");
  command.add_option("--tools", tool_library_, "Tool library: .fctb .fctl .tbl .json .toml");
}

void PlanArguments::add_tool_options(CLI::App& command) {
  add_tool_list_options(command);
  command.add_option("--machine", machine_file_, "Machine file (.toml): limits, acceleration, rapid");
  command.add_option("--accept", accept_,
                     "Condition that holds at the machine, by its name (repeatable): g55, blending, ...");
  command.add_option("--acceleration", acceleration_, "Acceleration of the machine, mm/s2");
  command.add_option("--junction-deviation", junction_deviation_, "Junction deviation of the machine, mm");
  command.add_option("--rapid", rapid_feed_, "Rapid feed of the machine, mm/min")->transform(as_feed());
  command.add_option("--stepdown", stepdown_, "Depth of one layer, mm")->transform(as_length());
  command.add_option("--allowance", allowance_, "Stock to leave on walls, mm")->transform(as_length());
  command.add_option("--allowance-floor", allowance_floor_, "Stock to leave on floors, mm")
      ->transform(as_length());
  command.add_option("--engagement", engagement_, "Largest engagement angle of the cutter, degrees");
  command.add_option(
      "--material", shop_.material,
      "Of the work, for forces and wear: aluminium, brass, steel, alloy-steel, stainless, cast-iron, "
      "titanium");
  command.add_option("--threads", threads_, "Threads; 0: all cores");
}

void PlanArguments::add_cutting_options(CLI::App& command) {
  command.add_option(
      "--strategy", strategy_,
      "auto, contour, zigzag, spiral, adaptive, tour, or a published method: lom, rho, second, "
      "lom-corrected, rho-corrected, fixed, loops, pwid, single, double, bisectors");
  command
      .add_option("--stepover", stepover_,
                  "Distance of passes: fraction of the diameter, 3.5mm, lom, rho[:W], or several with "
                  "commas, one a contour")
      ->transform(as_stepover());
  command.add_option("--angle", angle_,
                     "Direction of zigzag lines against x, degrees (default: the fastest)");
  command.add_option("--entry", entry_, "helix, ramp, zigzag or plunge");
  add_shop_options(command);
  command.add_option("--direction", direction_, "climb or conventional");
  command.add_option("--order", order_, "Contours inside-out (default) or outside-in");
  command.add_option(
      "--passage", passage_,
      "From contour to contour: bisector (of a corner; default of published methods) or shortest");
  command.add_option("--start", start_,
                     "Where the cutting of contours begins, or adaptive clearing goes down: X,Y");
  command.add_option("--feed", feed_, "Cutting feed, mm/min")->transform(as_feed());
  command.add_option("--plunge-feed", plunge_feed_, "Plunge feed, mm/min")->transform(as_feed());
  command.add_option("--spindle", spindle_, "Spindle speed, rpm");
  post_.add_options(command);
  command.add_option("--clearance", clearance_z_, "Z of rapid travel, mm")->transform(as_length());
  command.add_option(
      "--objective", objective_,
      "Of the strategy tour: length, turns, angle, engagement, time, or weights 1:length,20:turns");
  command.add_option("--grid", grid_,
                     "Of the strategy tour: ours, or published (Tour eq. 4.8; leaves what it leaves)");
  solver_.add_options(command);
  command.add_option("--time", time_, "Longest search, s");
  command.add_option("--seed", seed_, "Seed of the search");
}

void PlanArguments::add_shop_options(CLI::App& command) {
  command.add_option("--entry-angle", entry_angle_,
                     "Steepest way down of a helix or ramp, degrees (default 3)");
  command.add_option("--helix-diameter", shop_.helix_widest, "Widest helix of the cutter's centre, mm")
      ->transform(as_length());
  command.add_option("--helix-min", shop_.helix_narrowest, "Narrowest helix, mm; below it: ramp")
      ->transform(as_length());
  command.add_option("--predrilled", predrilled_, "X,Y:DIAMETER of a hole to enter by (repeatable)");
  command
      .add_option("--lead", lead_,
                  "Radius of the arcs into and out of passes along walls, mm (default: none)")
      ->transform(as_length());
  command.add_option("--lead-angle", lead_angle_,
                     "Lines of that length at this angle to the pass instead of arcs, degrees");
  command
      .add_option("--lead-overlap", shop_.lead_overlap,
                  "How far passes along walls run on over their start, mm (default 0)")
      ->transform(as_length());
  command
      .add_option("--overrun", shop_.overrun,
                  "How far beyond the edge of the material open sides are cut, mm (default 0)")
      ->transform(as_length());
  command.add_option("--lead-feed", lead_feed_, "Feed on leads, mm/min")->transform(as_feed());
  command.add_option("--link-feed", link_feed_, "Feed between passes at depth, mm/min")->transform(as_feed());
  command.add_option("--link-lift", shop_.link_lift, "Lift between passes at depth, mm")
      ->transform(as_length());
  command.add_option("--ramp-feed", ramp_feed_, "Feed on ramps and helices, mm/min")->transform(as_feed());
  command.add_option("--slot-feed", slot_feed_, "Feed where the cutter is in the material all round, mm/min")
      ->transform(as_feed());
  command.add_option("--slot-angle", shop_.slot_angle_deg,
                     "Engagement above which the slot feed rules, degrees (default 150)");
  command.add_flag("--rest", rest_, "Use all mills given, larger first, each on what is left");
  command.add_option("--after", after_, "Program that has run before: cut only what it left");
  command.add_option("--finish", shop_.finish, "Finishing after everything else: walls, floor or all");
  command
      .add_option("--finish-stock", shop_.finish_stock, "Stock left on walls for finishing, mm (default 0.3)")
      ->transform(as_length());
  command
      .add_option("--finish-stock-floor", shop_.finish_stock_floor,
                  "Stock left on floors for finishing, mm (default 0.2)")
      ->transform(as_length());
  command.add_option("--finish-depths", shop_.finish_depths,
                     "In how many depths walls are finished (default 1)");
  command.add_option("--scallop", scallop_, "Steps that layers may leave on leaning walls, mm")
      ->transform(as_length());
}

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
  if (join_gap_) options.join_gap = join_gap_;
  if (open_curves_) {
    options.open_curves = *open_curves_ == "skip" ? OpenCurves::kSkip : OpenCurves::kRefuse;
  }
  options.unit = unit_;
  options.layers = layers_;
  options.top = top_;
  options.depth = depth_;
  options.solid = solid_;
  for (const Tool& tool : tools())
    if (tool.kind == ToolKind::kDrill) options.solid.drills.push_back(tool.diameter);
  return options;
}

Part PlanArguments::read_overview(DrawingOverview& overview) const {
  ReadOptions options = read_options();
  options.overview = &overview;
  return read_part(input_, options);
}

Part PlanArguments::read() const {
  const auto from_job = job();
  Part part = from_job ? part_of_job(*from_job, read_options(), step_sources_, step_published_)
                       : read_part(input_, read_options());
  if (clearance_z_) part.clearance_z = clearance_z_;
  part.diagnostics.append(library().diagnostics);
  return part;
}

std::optional<JobFile> PlanArguments::job() const {
  if (std::filesystem::path(input_).extension() != ".toml") return std::nullopt;
  return read_job(input_);
}

std::vector<Tool> PlanArguments::tools() const {
  std::vector<Tool> tools;
  if (tool_library_) {
    for (const auto& entry : library().tools) tools.push_back(entry.tool);
  }
  for (const auto& text : tools_) tools.push_back(parse_tool(text));
  return tools;
}

std::vector<std::string> PlanArguments::input_paths() const {
  std::vector<std::string> paths;
  for (const CertificateFileName& file : input_files()) paths.push_back(file.path);
  return paths;
}

std::vector<CertificateFileName> PlanArguments::input_files() const {
  std::vector<CertificateFileName> files;
  const auto job = this->job();
  files.push_back({job ? "job" : "part", input_});
  if (job && !job->part_file.empty()) files.push_back({"part", job->part_file.string()});
  if (tool_library_) add_library(*tool_library_, files);
  if (job && !tool_library_ && job->tool_library) add_library(*job->tool_library, files);
  if (machine_file_) files.push_back({"machine", *machine_file_});
  if (job && !machine_file_ && job->machine_file) files.push_back({"machine", job->machine_file->string()});
  if (after_) files.push_back({"earlier program", *after_});
  if (job && !after_ && job->after) files.push_back({"earlier program", job->after->string()});
  return files;
}

ToolLibrary PlanArguments::library() const {
  return tool_library_ ? read_tool_library(*tool_library_, {}) : ToolLibrary{};
}

Machine PlanArguments::machine(const Machine& of_job) const {
  Machine machine = machine_file_ ? read_machine(*machine_file_) : of_job;
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

/// The command line goes before the job, the job before the defaults.
PlanOptions PlanArguments::options() const {
  const auto from_job = job();
  PlanOptions options = from_job ? options_of_job(*from_job) : PlanOptions{};
  options.tools = tools();
  if (tool_library_ || !tools_.empty()) options.tool_cutting = cutting_of_tools(library().tools, "");
  options.machine = machine(options.machine);
  options.accept.insert(options.accept.end(), accept_.begin(), accept_.end());
  if (machine_file_) options.sources.merge(machine_sources(*machine_file_));
  options.step_sources = step_sources_;
  options.sources.merge(typed_);
  options.strategy = strategy_;
  if (stepover_) options.stepover = stepover_;
  options.angle_deg = angle_;
  options.stepdown = stepdown_;
  options.allowance = allowance_;
  options.allowance_floor = allowance_floor_;
  if (engagement_) options.engagement_deg = engagement_;
  if (entry_) options.entry = entry_named(*entry_, "--entry");
  if (entry_angle_) options.entry_angle = Radians::of_degrees(*entry_angle_);
  options.lead = lead_;
  if (lead_angle_) options.lead_angle = Radians::of_degrees(*lead_angle_);
  options.scallop = scallop_;
  options.tabs = tabs_;
  options.shop = shop(options.shop);
  const auto earlier = after_ || !from_job || !from_job->after ? after_ : from_job->after->string();
  // The height that the program calls home is the machine's, which may be another than the job's.
  if (earlier && (after_ || machine_file_)) options.earlier = read_earlier_program(*earlier, options.machine);
  for (const auto& text : predrilled_) options.predrilled.push_back(parse_predrilled(text));
  if (direction_) options.direction = direction_named(*direction_, "--direction");
  options.outside_in = order_ && order_named(*order_, "--order") == ContourOrder::kOutsideIn;
  if (start_) options.start = point_of(*start_, "--start");
  options.cutting.feed = feed_of(feed_);
  options.cutting.plunge_feed = feed_of(plunge_feed_);
  options.cutting.ramp_feed = feed_of(ramp_feed_);
  options.cutting.slot_feed = feed_of(slot_feed_);
  options.cutting.spindle_rpm = spindle_;
  options.post = post_.options(options.post);
  options.published = {named(kPassages, passage_, "--passage"), named(kGrids, grid_, "--grid"),
                       solver_.solver()};
  options.step_published = step_published_;
  if (objective_) options.objective = *objective_;
  if (time_) options.time_s = time_;
  if (seed_) options.seed = *seed_;
  options.threads = threads_;
  check_options(options);
  return options;
}

}  // namespace clearcut::cli
