#include "read/job/job_file.h"

#include <cmath>

#include "base/error.h"
#include "base/files/file.h"
#include "base/text/format.h"
#include "read/common/drawing.h"
#include "read/common/text.h"
#include "read/common/units.h"
#include "read/job/job_setups.h"
#include "read/job/machine_file.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargestJob = std::size_t{16} << 20;

fs::path beside(const std::string& job_file, const std::string& name) {
  return fs::path(job_file).parent_path() / name;
}

std::optional<MmPerMin> feed_of(DataSection& section, const std::string& key) {
  const auto value = section.positive(key);
  return value ? std::optional(MmPerMin::of(*value)) : std::nullopt;
}

/// A length that is a coordinate: within a kilometre.
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

/// 0.4, "0.4", "3.5mm", "lom", "rho".
std::optional<std::string> stepover_of(DataSection& section) {
  if (!section.has("stepover")) return std::nullopt;
  if (section.is_number("stepover")) return trimmed(*section.positive("stepover"), 6);
  return section.text("stepover");
}

/// The Tour text's algorithm and its settings, which mean nothing to ours.
std::optional<VisitSolver> solver_of(DataSection& section) {
  const auto name = section.choice("solver", {"modern", "published"});
  VisitSolver solver;
  PublishedSolver& own = solver.published;
  if (const auto generations = count(section, "generations", 2e9)) own.generations = *generations;
  own.population = count(section, "population", 1e6);
  own.selection = section.text("selection");
  own.crossover = section.text("crossover");
  own.mutation = section.text("mutation");
  own.crossover_rate = section.not_negative("crossover_rate");
  own.mutation_rate = section.not_negative("mutation_rate");
  own.most_shared = section.not_negative("most_shared");
  solver.is_published = name == std::size_t{1};
  if (!solver.is_published && own.is_set())
    section.fail("sets the published solver; add solver = \"published\"");
  return name ? std::optional(solver) : std::nullopt;
}

PublishedChoices published_of(DataSection& section) {
  PublishedChoices choices;
  if (const auto passage = section.choice("passage", {"shortest", "bisector"}))
    choices.bisector_passages = *passage == 1;
  if (const auto grid = section.choice("grid", {"ours", "published"})) choices.published_grid = *grid == 1;
  choices.solver = solver_of(section);
  return choices;
}

CutSettings settings_of(DataSection& section) {
  static const std::vector<std::string> entries{"helix", "ramp", "zigzag", "plunge"};
  static const std::vector<std::string> directions{"climb", "conventional"};
  static const std::vector<std::string> kinds{"roughing",       "finishing", "bottom_finishing",
                                              "side_finishing", "drilling",  "reaming"};
  CutSettings out;
  out.strategy = section.text("strategy");
  out.stepover = stepover_of(section);
  out.stepdown = section.positive("stepdown");
  out.allowance = section.number("allowance");
  out.allowance_floor = section.not_negative("allowance_floor");
  out.scallop = section.positive("scallop");
  out.lead = section.not_negative("lead");
  if (const auto angle = section.not_negative("lead_angle")) {
    if (*angle > 90) section.fail_at("lead_angle", "must be at most 90 degrees");
    out.lead_angle = Radians::of_degrees(*angle);
  }
  if (const auto entry = section.choice("entry", entries)) out.entry = static_cast<EntryKind>(*entry);
  if (const auto angle = section.positive("entry_angle")) {
    if (*angle > 90) section.fail_at("entry_angle", "must be at most 90 degrees");
    out.entry_angle = Radians::of_degrees(*angle);
  }
  if (const auto direction = section.choice("direction", directions)) {
    out.direction = static_cast<CutDirection>(*direction);
  }
  if (const auto kind = section.choice("kind", kinds)) out.kind = static_cast<OperationKind>(*kind);
  out.tool = count(section, "tool", 1e6);
  out.feed = feed_of(section, "feed");
  out.plunge_feed = feed_of(section, "plunge_feed");
  out.ramp_feed = feed_of(section, "ramp_feed");
  out.slot_feed = feed_of(section, "slot_feed");
  out.spindle_rpm = section.positive("spindle");
  out.coolant = coolant_in(section);
  out.published = published_of(section);
  return out;
}

void read_solid_options(DataSection& section, SolidOptions& solid) {
  solid.up = section.text("up").value_or("");
  solid.turn_deg = coordinate(section, "turn").value_or(0);
  solid.body = section.text("body").value_or("");
  solid.breakthrough = section.not_negative("breakthrough");
}

/// "corner", "centre", or [x, y, z].
std::optional<ZeroPoint> zero_point(DataSection& section) {
  if (!section.has("origin")) return std::nullopt;
  const std::vector<double> point =
      section.is_list("origin") ? section.numbers("origin") : std::vector<double>{};
  if (point.size() == 3) return ZeroPoint{"", {point[0], point[1], point[2]}};
  if (section.is_list("origin")) section.fail_at("origin", "needs three numbers, [x, y, z]");
  static const std::vector<std::string> places{"corner", "centre"};
  return ZeroPoint{places[*section.choice("origin", places)], {}};
}

std::optional<WorkOffset> work_offset_of(DataSection& section) {
  const auto text = section.text("work_offset");
  const auto offset = text ? work_offset_named(*text) : std::nullopt;
  if (text && !offset)
    section.fail_at("work_offset",
                    "'" + printable(*text) + "' is unknown; use one of " + std::string(kKnownWorkOffsets));
  return offset;
}

/// "home", "none", [x, y] or "x,y".
std::optional<EndPosition> end_position_of(DataSection& section) {
  const std::string key = "end_position";
  if (section.is_list(key)) {
    const auto place = *section.pair(key);
    return EndPosition{EndPosition::Kind::kPlace, {place[0], place[1]}};
  }
  const auto text = section.text(key);
  const auto end = text ? end_position_named(*text) : std::nullopt;
  if (text && !end) section.fail_at(key, "must be \"home\", \"none\" or [x, y]");
  return end;
}

void read_part_section(DataSection section, JobFile& job) {
  const auto file = section.text("file");
  if (!file || file->empty()) section.fail("file is missing; add file = \"part.dxf\"");
  job.part_file = beside(job.file, *file);
  ReadOptions& read = job.read;
  read.unit = section.text("unit");
  if (read.unit && !mm_per_unit(*read.unit))
    section.fail_at("unit", "is unknown; use one of " + known_units());
  read.depth = section.positive("depth");
  read.top = coordinate(section, "top");
  read.layers = section.texts("layers");
  read.find_arcs = section.flag("find_arcs");
  if (const auto gap = section.not_negative("join_gap")) read.tol.join_gap = *gap;
  read.mirror = section.flag("mirror").value_or(false);
  if (const auto scale = section.positive("scale")) read.scale = *scale, read.scale_is_right = true;
  if (read.tol.join_gap > 10 || read.tol.join_gap < 1e-6)
    section.fail_at("join_gap", "must lie between 1e-6 and 10 mm");
  const auto strokes = section.choice("strokes", {"lines", "areas"});
  if (strokes) read.stroke_areas = *strokes == 1;
  const auto text = section.choice("text", {"skip", "outlines"});
  if (text) read.text_outlines = *text == 1;
  const auto open = section.choice("open_curves", {"refuse", "skip"});
  if (open && *open == 1) read.open_curves = OpenCurves::kSkip;
  read_solid_options(section, read.solid);
  job.zero = zero_point(section);
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

int decimals_of(const DataSection& section, double value) {
  if (value < 3 || value > 6 || value != std::floor(value))
    section.fail("decimals is a whole number from 3 to 6; correct it");
  return static_cast<int>(value);
}

JobOutput output_of(DataSection section) {
  JobOutput out;
  out.program = section.text("program");
  out.post = section.text("post");
  out.inch = section.flag("inch");
  out.work_offset = work_offset_of(section);
  out.end_position = end_position_of(section);
  if (const auto decimals = section.positive("decimals")) out.decimals = decimals_of(section, *decimals);
  out.arcs = section.flag("arcs");
  out.tool_change = section.flag("tool_change");
  out.length_offset = section.flag("length_offset");
  out.exact_stop = section.flag("exact_stop");
  out.spindle_wait = section.not_negative("spindle_wait");
  out.program_number = count(section, "program_number", 99999);
  if (out.program_number == 0) section.fail_at("program_number", "must be 1 or more");
  out.block_numbers = section.flag("block_numbers");
  out.optional_stop = section.flag("optional_stop");
  out.certificate = section.text("certificate");
  out.svg = section.text("svg");
  out.report = section.text("report");
  out.setup_sheet = section.text("setup_sheet");
  out.result = section.text("result");
  section.refuse_unknown();
  return out;
}

ShopOptions shop_of(DataSection& section) {
  ShopOptions shop;
  shop.helix_widest = section.positive("helix_diameter");
  shop.helix_narrowest = section.positive("helix_min");
  shop.lead_feed = feed_of(section, "lead_feed");
  shop.lead_overlap = section.not_negative("lead_overlap");
  shop.link_feed = feed_of(section, "link_feed");
  shop.overrun = section.not_negative("overrun");
  shop.link_lift = section.not_negative("link_lift");
  shop.slot_angle_deg = section.positive("slot_angle");
  shop.rest = section.flag("rest");
  shop.finish = section.text("finish");
  shop.finish_stock = section.not_negative("finish_stock");
  shop.finish_stock_floor = section.not_negative("finish_stock_floor");
  shop.finish_depths = section.positive("finish_depths");
  shop.material = section.text("material");
  shop.style = section.text("style");
  shop.dogbones = section.text("dogbones");
  return shop;
}

TabOptions tabs_of(DataSection& section) {
  constexpr double kMost = 1000;
  TabOptions tabs;
  tabs.count = count(section, "tabs", kMost).value_or(0);
  tabs.spacing = section.positive("tab_spacing");
  tabs.at = section.points("tab_at");
  if (section.choice("tab_shape", {"square", "triangular"}) == std::size_t{1})
    tabs.shape = TabShape::kTriangular;
  tabs.width = section.positive("tab_width").value_or(tabs.width);
  tabs.height = section.positive("tab_height");
  tabs.skin = section.positive("skin");
  return tabs;
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

/// Of contours and zigzag lines: where they begin and how they run.
void read_path_keys(DataSection& section, JobFile& job) {
  static const std::vector<std::string> orders{"inside-out", "outside-in"};
  job.angle_deg = section.number("angle");
  if (const auto order = section.choice("order", orders)) job.order = static_cast<ContourOrder>(*order);
  if (const auto start = section.pair("start")) job.start = Vec2{(*start)[0], (*start)[1]};
}

void read_plan_section(DataSection section, JobFile& job) {
  job.plan = settings_of(section);
  job.shop = shop_of(section);
  job.tabs = tabs_of(section);
  if (const auto after = section.text("after")) job.after = beside(job.file, *after);
  job.clearance_z = coordinate(section, "clearance");
  read_path_keys(section, job);
  job.engagement_deg = section.positive("engagement");
  if (job.engagement_deg && *job.engagement_deg > 360)
    section.fail_at("engagement", "must be at most 360 degrees");
  job.objective = section.text("objective");
  job.time_s = section.positive("time");
  job.accept = section.texts("accept");
  if (const auto seed = count(section, "seed", 2e9)) job.seed = static_cast<std::uint64_t>(*seed);
  section.refuse_unknown();
}

void read_machine_section(DataSection section, JobFile& job) {
  Machine base;
  if (const auto file = section.text("file")) job.machine_file = beside(job.file, *file);
  if (job.machine_file) base = read_machine(*job.machine_file);
  job.machine = machine_of_section(section, base);
}

/// Notes where the keys of the job stand; the file's sections have been read.
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
  if (const auto output = section.section("output")) job.output = output_of(*output);
  section.refuse_unknown();
  note_sources(root, job);
  return job;
}

/// As the first set-up, with all of them in it.
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
