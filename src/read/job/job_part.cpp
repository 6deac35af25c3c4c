// The part described by a job.
#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "features/derived_outlines.h"
#include "features/tool_choice.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/drawing/overlaps.h"
#include "read/job/job_file.h"
#include "read/job/read_part.h"
#include "read/step_solid/step_solid.h"

namespace clearcut::read {
namespace {

/// Command line before job.
ReadOptions merged(ReadOptions options, const ReadOptions& over) {
  if (over.unit) options.unit = over.unit;
  if (over.depth) options.depth = over.depth;
  if (over.depth_if_missing) options.depth_if_missing = over.depth_if_missing;
  if (over.top) options.top = over.top;
  if (!over.layers.empty()) options.layers = over.layers;
  options.layer_rules.insert(options.layer_rules.begin(), over.layer_rules.begin(), over.layer_rules.end());
  if (over.stroke_areas) options.stroke_areas = over.stroke_areas;
  if (over.text_outlines) options.text_outlines = over.text_outlines;
  if (over.open_curves) options.open_curves = over.open_curves;
  if (over.join_gap) options.join_gap = over.join_gap;
  options.ask_if_unclear = over.ask_if_unclear;
  options.overview = over.overview;
  if (over.scale_is_right) options.scale = over.scale;
  options.scale_is_right = options.scale_is_right || over.scale_is_right;
  options.mirror = options.mirror || over.mirror;
  options.block = over.block;
  if (over.find_arcs) options.find_arcs = over.find_arcs;
  if (!over.solid.up.empty()) options.solid.up = over.solid.up;
  if (over.solid.turn_deg != 0) options.solid.turn_deg = over.solid.turn_deg;
  if (!over.solid.body.empty()) options.solid.body = over.solid.body;
  options.solid.tools = over.solid.tools;
  options.solid.drills = over.solid.drills;
  options.solid.has_other_setups = over.solid.has_other_setups;
  if (over.solid.breakthrough) options.solid.breakthrough = over.solid.breakthrough;
  return options;
}

void refuse_two_stocks(const JobFile& job, const ReadOptions& over) {
  if (job.stock && over.block)
    throw InputError(
        job.file,
        "[stock] states a block, and so does the stock that is given as a solid; leave one of them out");
}

StockRequest requested(const JobStock& stock) {
  return {stock.x, stock.y, stock.margin.value_or(0), *stock.z};
}

Stock stock_of(const JobStock& stock, const Part& part, const std::string& file) {
  Box around;
  for (const Feature& feature : part.features) around.add(box(feature.target));
  if ((!stock.x || !stock.y) && around.empty())
    throw InputError(file, "the stock needs x and y: the part has no outline");
  around = around.grown(stock.margin.value_or(0));
  Stock out;
  out.plan.min = {stock.x ? (*stock.x)[0] : around.min.x, stock.y ? (*stock.y)[0] : around.min.y};
  out.plan.max = {stock.x ? (*stock.x)[1] : around.max.x, stock.y ? (*stock.y)[1] : around.max.y};
  out.z_bottom = (*stock.z)[0];
  out.z_top = (*stock.z)[1];
  return out;
}

/// Placeholder for a step's tool until it is known whether a rule names one.
constexpr int kOpenTool = -1;

/// Two tools of one number: the one intended by a program cannot be guessed.
void refuse_one_number_twice(const std::vector<LibraryTool>& tools, const std::string& file) {
  std::set<int> taken;
  for (const LibraryTool& tool : tools) {
    if (tool.tool.number <= 0 || taken.insert(tool.tool.number).second) continue;
    throw InputError(file, "two tools are numbered T" + std::to_string(tool.tool.number) +
                               "; give each a number of its own (of a library choose with use = [...])");
  }
}

/// The job's own tools, then the used ones of its library.
ToolLibrary tools_of(const JobFile& job) {
  ToolLibrary all;
  all.tools = job.tools;
  refuse_one_number_twice(all.tools, job.file);
  if (job.tool_library) {
    ToolLibrary library = read_tool_library(*job.tool_library, job.tool_options);
    all.diagnostics.append(library.diagnostics);
    for (const int number : job.tool_numbers) {
      const bool found = std::any_of(library.tools.begin(), library.tools.end(),
                                     [&](const LibraryTool& tool) { return tool.tool.number == number; });
      if (!found)
        throw InputError(job.file,
                         "use = [..., " + std::to_string(number) + "]: the library has no such tool");
    }
    for (LibraryTool& tool : library.tools) {
      const bool wanted = job.tool_numbers.empty() ||
                          std::find(job.tool_numbers.begin(), job.tool_numbers.end(), tool.tool.number) !=
                              job.tool_numbers.end();
      if (wanted) all.tools.push_back(std::move(tool));
    }
  }
  if (job.tool_library) refuse_one_number_twice(all.tools, job.file);
  settle(all, job.file);
  return all;
}

template <typename Value>
void set_if(std::optional<Value>& target, const std::optional<Value>& value) {
  if (value) target = value;
}

/// `source`: place of the preset.
void apply_preset(const CuttingPreset& preset, const Source& source, Operation& operation, Sources& sources) {
  CuttingData& cutting = operation.cutting;
  const auto note = [&](const char* name, bool is_stated) {
    if (is_stated) sources.set(name, source);
  };
  note("feed", preset.cutting.feed.has_value());
  note("plunge-feed", preset.cutting.plunge_feed.has_value());
  note("ramp-feed", preset.cutting.ramp_feed.has_value());
  note("slot-feed", preset.cutting.slot_feed.has_value());
  note("spindle", preset.cutting.spindle_rpm.has_value());
  note("stepdown", preset.stepdown.has_value());
  note("coolant", preset.cutting.coolant.has_value());
  set_if(cutting.feed, preset.cutting.feed);
  set_if(cutting.plunge_feed, preset.cutting.plunge_feed);
  set_if(cutting.ramp_feed, preset.cutting.ramp_feed);
  set_if(cutting.slot_feed, preset.cutting.slot_feed);
  set_if(cutting.spindle_rpm, preset.cutting.spindle_rpm);
  cutting.spindle_clockwise = preset.cutting.spindle_clockwise;
  set_if(cutting.coolant, preset.cutting.coolant);
  set_if(operation.stepdown, preset.stepdown);
  set_if(operation.stepover, preset.stepover);
}

/// A stepover in fractions or mm as a fraction; nothing for "lom" and "rho", which are passed to the planner as text.
std::optional<double> stepover_fraction(const std::string& text, double diameter, const std::string& place) {
  if (text == "lom" || text == "rho") return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string unit = text.substr(static_cast<std::size_t>(end - text.data()));
  if (error != std::errc{} || (!unit.empty() && unit != "mm") || !(value > 0)) {
    throw InputError(place,
                     "stepover '" + printable(text) + "' is unknown; use 0.4, \"3.5mm\", \"lom\" or \"rho\"");
  }
  return unit.empty() ? value : value / diameter;
}

void apply_settings(const PlanOptions& asked, const Part& part, const std::string& place,
                    Operation& operation) {
  set_if(operation.stepdown, asked.stepdown);
  if (asked.allowance) operation.allowance_side = *asked.allowance;
  if (asked.allowance_floor) operation.allowance_floor = *asked.allowance_floor;
  set_if(operation.scallop, asked.scallop);
  set_if(operation.lead, asked.lead);
  set_if(operation.lead_angle, asked.lead_angle);
  set_if(operation.entry, asked.entry);
  set_if(operation.entry_angle, asked.entry_angle);
  set_if(operation.direction, asked.direction);
  set_if(operation.cutting.feed, asked.cutting.feed);
  set_if(operation.cutting.plunge_feed, asked.cutting.plunge_feed);
  set_if(operation.cutting.ramp_feed, asked.cutting.ramp_feed);
  set_if(operation.cutting.slot_feed, asked.cutting.slot_feed);
  set_if(operation.cutting.spindle_rpm, asked.cutting.spindle_rpm);
  set_if(operation.cutting.coolant, asked.cutting.coolant);
  if (asked.strategy) operation.strategy_hint = *asked.strategy;
  if (asked.stepover && !part.tools.empty()) {
    const double diameter = part.tools[static_cast<std::size_t>(operation.tool)].diameter;
    set_if(operation.stepover, stepover_fraction(*asked.stepover, diameter, place));
  }
}

/// Settings and their place.
struct SettingsSource {
  const CutSettings* settings;
  std::string place;
};

/// A workingstep and the settings to apply, in order.
struct Planned {
  Workingstep step;
  std::vector<SettingsSource> sources;
};

bool is_finishing(const CutSettings& settings) {
  return settings.kind == OperationKind::kFinishing || settings.kind == OperationKind::kBottomFinishing ||
         settings.kind == OperationKind::kSideFinishing;
}

void leave_nothing(Operation& operation, const std::string& place, Sources& sources) {
  operation.allowance_side = operation.allowance_floor = 0;
  for (const char* name : {"allowance", "allowance-floor"})
    sources.set(name, {Origin::kDerived, place + " finishes"});
}

/// Applies tools, plan and operation rules to a part.
class Dresser {
 public:
  Dresser(const JobFile& job, Part& part, const Tolerances& tol, StepSources& sources, StepChoices& published)
      : job_(job), part_(part), tol_(tol), sources_(sources), published_(published) {}

  void run() {
    set_tools();
    for (const Workingstep& step : part_.workplan) steps_.push_back({step, {{&job_.plan, job_.file}}});
    for (const OperationRule& rule : job_.operations) apply(rule);
    if (steps_.empty()) throw InputError(job_.file, "every operation is skipped; nothing is left to machine");
    if (!job_.sequence.empty()) put_in_sequence();
    part_.workplan.clear();
    for (Planned& planned : steps_) part_.workplan.push_back(dressed(std::move(planned)));
  }

 private:
  const std::string& feature_name(const Planned& planned) const {
    return part_.features[static_cast<std::size_t>(planned.step.feature)].name;
  }

  /// The place of a step in the sequence that the job states; what it does not name comes last.
  std::size_t place_in_sequence(const Planned& planned) const {
    const auto named = [&](const std::string& name) { return matches(name, feature_name(planned)); };
    return static_cast<std::size_t>(std::find_if(job_.sequence.begin(), job_.sequence.end(), named) -
                                    job_.sequence.begin());
  }

  /// The order of work is the job's afterwards, and no longer free.
  void put_in_sequence() {
    for (const std::string& name : job_.sequence) {
      const auto named = [&](const Feature& feature) { return matches(name, feature.name); };
      if (std::none_of(part_.features.begin(), part_.features.end(), named))
        throw InputError(
            job_.file, "sequence: no feature is called '" + printable(name) + "'; clearcut info lists them");
    }
    std::stable_sort(steps_.begin(), steps_.end(), [&](const Planned& a, const Planned& b) {
      return place_in_sequence(a) < place_in_sequence(b);
    });
    part_.order_free = false;
  }

  /// The job's tools replace the part's; operations keep theirs by number where the job has it too.
  void set_tools() {
    ToolLibrary library = tools_of(job_);
    part_.diagnostics.append(library.diagnostics);
    if (library.tools.empty()) return;
    const std::vector<Tool> before = std::move(part_.tools);
    part_.tools.clear();
    for (const LibraryTool& tool : library.tools) {
      part_.tools.push_back(tool.tool);
      if (const auto* preset = preset_of(tool, job_.preset)) presets_[tool.tool.number] = *preset;
    }
    for (Workingstep& step : part_.workplan) {
      const auto old = static_cast<std::size_t>(step.operation.tool);
      step.operation.tool =
          old < before.size() ? index_of(before[old].number).value_or(kOpenTool) : kOpenTool;
    }
  }

  Source preset_source(int number) const {
    const std::string tool = " T" + std::to_string(number);
    const bool own = std::any_of(job_.tools.begin(), job_.tools.end(),
                                 [&](const LibraryTool& one) { return one.tool.number == number; });
    if (own || !job_.tool_library) return {Origin::kJobFile, job_.file + tool};
    return {Origin::kToolLibrary, job_.tool_library->string() + tool};
  }

  std::optional<int> index_of(int number) const {
    for (std::size_t i = 0; i < part_.tools.size(); ++i) {
      if (part_.tools[i].number == number) return static_cast<int>(i);
    }
    return std::nullopt;
  }

  void apply(const OperationRule& rule) {
    const std::string place = job_.file + ":" + std::to_string(rule.line);
    const auto hit = [&](const Planned& planned) {
      return matches(rule.feature, part_.features[static_cast<std::size_t>(planned.step.feature)].name);
    };
    if (std::none_of(steps_.begin(), steps_.end(), hit)) {
      throw InputError(place,
                       "no feature is called '" + printable(rule.feature) + "'; clearcut info lists them");
    }
    if (rule.skip) {
      std::erase_if(steps_, hit);
      part_.diagnostics.doubt(
          place, kLeftOut,
          "the operations of '" + printable(rule.feature) + "' are skipped by the job: their material stays");
    } else if (is_finishing(rule.settings)) {
      add_finishing(rule, place);
    } else {
      for (Planned& planned : steps_) {
        if (hit(planned)) planned.sources.push_back({&rule.settings, place});
      }
    }
  }

  /// Finishing is a separate workingstep after all others, once per feature.
  void add_finishing(const OperationRule& rule, const std::string& place) {
    std::set<int> done;
    std::vector<Planned> added;
    for (const Planned& planned : steps_) {
      const Feature& feature = part_.features[static_cast<std::size_t>(planned.step.feature)];
      if (!matches(rule.feature, feature.name) || !done.insert(planned.step.feature).second) continue;
      Planned finishing{planned.step, {{&job_.plan, job_.file}, {&rule.settings, place}}};
      finishing.step.name += "_finish";
      finishing.step.operation.name = finishing.step.name;
      added.push_back(std::move(finishing));
    }
    steps_.insert(steps_.end(), added.begin(), added.end());
  }

  /// The tool first, then its preset, then the settings from the most general on.
  Workingstep dressed(Planned planned) {
    Sources& sources = sources_[step_key(planned.step)];
    Operation& operation = planned.step.operation;
    for (const SettingsSource& source : planned.sources) {
      if (source.settings->kind) operation.kind = *source.settings->kind;
      if (!source.settings->tool) continue;
      const auto index = index_of(*source.settings->tool);
      if (!index) {
        throw InputError(source.place, "tool " + std::to_string(*source.settings->tool) +
                                           " is unknown; add it as [[tool]]");
      }
      operation.tool = *index;
    }
    if (operation.tool == kOpenTool) {
      const Feature& feature = feature_of(part_, planned.step);
      operation.tool = features::tool_for(feature, part_.tools, {}, tol_);
      if (job_.whole.tabs.any() && features::profiles_through(part_).contains(planned.step.feature))
        operation.tool = features::tool_for_tabs(feature, operation.tool, part_.tools);
      operation.is_tool_chosen = true;
      sources.set("tool", {Origin::kDerived, "the job's largest that fits"});
    }
    if (!part_.tools.empty()) {
      const auto preset = presets_.find(part_.tools[static_cast<std::size_t>(operation.tool)].number);
      if (preset != presets_.end())
        apply_preset(preset->second, preset_source(preset->first), operation, sources);
    }
    for (const SettingsSource& source : planned.sources) {
      // The stock left by roughing on walls is not left by finishing, unless its own rule states so.
      if (is_finishing(*source.settings)) leave_nothing(operation, source.place, sources);
      apply_settings(source.settings->asked, part_, source.place, operation);
      published_[step_key(planned.step)].merge(source.settings->asked.published);
      sources.merge(source.settings->sources);
    }
    return std::move(planned.step);
  }

  const JobFile& job_;
  Part& part_;
  Tolerances tol_;
  StepSources& sources_;
  StepChoices& published_;
  std::vector<Planned> steps_;
  std::map<int, CuttingPreset> presets_;
};

}  // namespace

std::vector<LibraryTool> tools_of_job(const JobFile& job) {
  return tools_of(job).tools;
}

Part part_of_job(const JobFile& job, const ReadOptions& over) {
  StepSources sources;
  StepChoices published;
  return part_of_job(job, over, sources, published);
}

Part part_of_job(const JobFile& job, const ReadOptions& over, StepSources& sources, StepChoices& published) {
  if (capitals(job.part_file.extension().string()) == ".TOML") {
    throw InputError(job.file, "the part of a job cannot be a job; name the drawing or program");
  }
  if (!job.setups.empty())
    throw InputError(job.file, "it has " + std::to_string(job.setups.size()) +
                                   " set-ups; say which, for example with --setup 1");
  refuse_two_stocks(job, over);
  ReadOptions options = merged(job.read, over);
  // Material around a solid belongs to its features: the solid's reader sets the stock itself.
  if (job.stock) options.solid.stock = requested(*job.stock);
  for (const LibraryTool& tool : tools_of(job).tools) options.solid.tools.push_back(tool.tool);
  const std::string text = read_file(job.part_file.string(), kLargestPart);
  Part part = read_part_file(text, job.part_file.string(), options);
  if (options.overview && part.features.empty()) return part;
  if (job.stock && !is_step_solid(text)) {
    part.stock = stock_of(*job.stock, part, job.file);
    if (job.stock->x && job.stock->y) open_at_stock_edge(part, options.tol);
  }
  if (job.clearance_z) part.clearance_z = job.clearance_z;
  part.keep_outs = job.keep_outs;
  part.predrilled.insert(part.predrilled.end(), job.predrilled.begin(), job.predrilled.end());
  Dresser(job, part, options.tol, sources, published).run();
  // With several set-ups the zero is moved once their orientations are known.
  if (!job.zero || job.setup_number != 0) return part;
  const auto zero = zero_of(part, *job.zero);
  return with_zero_at(std::move(part), zero);
}

}  // namespace clearcut::read
