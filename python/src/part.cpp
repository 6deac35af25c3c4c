// Parts, tools, jobs, machines.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "moves.h"

namespace clearcut::python {
namespace {

struct Reading {
  std::optional<std::string> unit;
  std::vector<std::string> layers, ops;
  std::optional<double> top, depth, scale, join_gap;
  std::optional<std::string> open_curves, strokes, letters;
  SolidOptions solid;
  bool mirror = false;
  std::optional<ZeroPoint> origin;

  ReadOptions options() const {
    ReadOptions options;
    options.ask_if_unclear = true;
    options.unit = unit;
    options.layers = layers;
    for (const auto& op : ops) options.layer_rules.push_back(rule_of_option(op, "--op"));
    options.top = top;
    options.depth = depth;
    if (scale) options.scale = *scale;
    options.scale_is_right = scale.has_value();
    options.mirror = mirror;
    options.join_gap = join_gap;
    if (open_curves && *open_curves != "skip" && *open_curves != "refuse")
      throw InputError("open_curves", "'" + *open_curves + "' is unknown; use refuse or skip");
    if (open_curves) options.open_curves = *open_curves == "skip" ? OpenCurves::kSkip : OpenCurves::kRefuse;
    if (strokes && *strokes != "lines" && *strokes != "areas")
      throw InputError("strokes", "'" + *strokes + "' is unknown; use lines or areas");
    if (strokes) options.stroke_areas = *strokes == "areas";
    if (letters && *letters != "skip" && *letters != "outlines")
      throw InputError("letters", "'" + *letters + "' is unknown; use skip or outlines");
    if (letters) options.text_outlines = *letters == "outlines";
    options.solid = solid;
    return options;
  }
};

/// Calls `use` with what the keywords of every reader say.
template <class What, class Use>
auto reader(Use use) {
  return [use](const What& what, const std::string& name, std::optional<std::string> unit,
               std::vector<std::string> layers, std::vector<std::string> ops, std::optional<double> top,
               std::optional<double> depth, std::optional<double> scale, std::optional<double> join_gap,
               std::optional<std::string> open_curves, std::optional<std::string> strokes,
               std::optional<std::string> letters, std::string up, double turn, std::string body,
               std::optional<double> breakthrough, std::vector<double> drills, bool mirror,
               const std::optional<std::string>& origin) {
    Reading reading;
    reading.unit = std::move(unit);
    reading.layers = std::move(layers);
    reading.ops = std::move(ops);
    reading.top = top;
    reading.depth = depth;
    reading.scale = scale;
    reading.join_gap = join_gap;
    reading.open_curves = std::move(open_curves);
    reading.strokes = std::move(strokes);
    reading.letters = std::move(letters);
    reading.mirror = mirror;
    reading.solid.up = std::move(up);
    reading.solid.turn_deg = turn;
    reading.solid.body = std::move(body);
    reading.solid.breakthrough = breakthrough;
    reading.solid.drills = std::move(drills);
    if (origin) reading.origin = parse_zero_point(*origin);
    return use(what, name, reading);
  };
}

template <class What, class Use>
void add_reader(py::module_& module, const char* name, const char* first, const char* text, Use use) {
  module.def(name, reader<What>(use), py::arg(first), py::arg("name") = "", py::kw_only(),
             py::arg("unit") = py::none(), py::arg("layers") = std::vector<std::string>{},
             py::arg("ops") = std::vector<std::string>{}, py::arg("top") = py::none(),
             py::arg("depth") = py::none(), py::arg("scale") = py::none(), py::arg("join_gap") = py::none(),
             py::arg("open_curves") = py::none(), py::arg("strokes") = py::none(),
             py::arg("letters") = py::none(), py::arg("up") = "", py::arg("turn") = 0.0, py::arg("body") = "",
             py::arg("breakthrough") = py::none(), py::arg("drills") = std::vector<double>{},
             py::arg("mirror") = false, py::arg("origin") = py::none(),
             py::call_guard<py::gil_scoped_release>(), text);
}

/// With its zero where it is asked for.
Part moved(Part part, const std::optional<ZeroPoint>& origin) {
  if (!origin) return part;
  const auto zero = zero_of(part, *origin);
  return with_zero_at(std::move(part), zero);
}

GivenPart part_of_text(const std::string& text, const std::string& name, const Reading& reading) {
  // No file of that name is read, so one may be written: the first pocket of an example is called as its results are.
  return {moved(read_part_text(text, name, reading.options()), reading.origin),
          {{"part", name + " (text)", sha256_hex(text)}}};
}

GivenPart part_of_file(const std::string& file, const std::string&, const Reading& reading) {
  return {moved(read_part(file, reading.options()), reading.origin), {certificate_file("part", file)}};
}

/// Options and files of a job.
Job asked_by(const JobFile& job, const std::string& file) {
  Job out;
  static_cast<PlanOptions&>(out.options) = options_of_job(job);
  const auto add = [&out](const char* role, const std::string& path) {
    out.part.inputs.push_back(certificate_file(role, path));
  };
  add("job", file);
  if (!job.part_file.empty()) add("part", job.part_file.string());
  if (job.tool_library) {
    add("tools", job.tool_library->string());
    for (const std::string& tool : read_tool_library(*job.tool_library, {}).files) add("tools", tool);
  }
  if (job.machine_file) add("machine", job.machine_file->string());
  if (job.after) add("earlier program", job.after->string());
  return out;
}

Job job_of_file(const std::string& file, const std::string&, const Reading& reading) {
  JobFile job = read_job(file);
  Job out = asked_by(job, file);
  if (reading.origin) job.zero = reading.origin;
  out.part.part = part_of_job(job, reading.options(), out.options.step_sources, out.options.step_published);
  return out;
}

/// One set-up of a job, and the plans or checks of those before it.
struct SetupQuestion {
  std::string file;
  int number = 1;  ///< from 1
  /// With the findings of those that were checked, and not planned here.
  std::vector<std::tuple<GivenPart, Moves, std::optional<Findings>>> earlier;
};

/// What the set-ups before have cut.
std::vector<MachinedSetup> machined_before(const SetupQuestion& asked, const JobFile& whole,
                                           const ReadOptions& reading) {
  std::vector<MachinedSetup> machined;
  for (const auto& [given, moves, findings] : asked.earlier) {
    MachinedSetup one{given.part, moves.toolpath(), {}};
    if (findings) {
      one.conditions = open_conditions(*findings);
      one.faults = findings->faults;
    }
    StepSources sources;
    StepChoices published;
    part_of_setup(whole, static_cast<int>(machined.size()) + 1, reading, one.place, sources, published);
    machined.push_back(std::move(one));
  }
  return machined;
}

Job job_of_setup(const SetupQuestion& asked, const std::string&, const Reading& reading) {
  const JobFile whole = read_job(asked.file);
  const int count = static_cast<int>(whole.setups.size());
  if (asked.number < 1 || asked.number > count)
    throw InputError("setup", std::to_string(asked.number) + ": " + asked.file + " has " +
                                  (count == 0 ? "no [[setup]]" : std::to_string(count)));
  if (static_cast<int>(asked.earlier.size()) != asked.number - 1)
    throw InputError("earlier", "set-up " + std::to_string(asked.number) + " begins with what " +
                                    std::to_string(asked.number - 1) +
                                    " before it leave; give the plans of those in order");
  if (reading.origin)
    throw InputError("origin", "each set-up of a job has its own; write origin = ... in its [[setup]]");
  Job out = asked_by(whole.setups[static_cast<std::size_t>(asked.number - 1)], asked.file);
  SetupPlace place;
  const ReadOptions options = reading.options();
  Part& part = out.part.part;
  part = part_of_setup(whole, asked.number, options, place, out.options.step_sources,
                       out.options.step_published);
  if (asked.number == 1) return out;
  CarriedStock carried = carried_stock(machined_before(asked, whole, options), place, part);
  part.stock = carried.block;
  part.diagnostics.note("set-up", carried.told);
  out.options.earlier = std::move(carried.sweeps);
  out.options.conditions = std::move(carried.conditions);
  out.options.earlier_state.faults = std::move(carried.faults);
  return out;
}

const char* word_for(Severity severity) {
  switch (severity) {
    case Severity::kRepair:
      return "repaired";
    case Severity::kWarning:
      return "warning";
    case Severity::kSkipped:
      return "skipped";
    case Severity::kNote:
      break;
  }
  return "note";
}

void add_tools(py::module_& module) {
  py::class_<Tool>(module, "Tool", doc("Tool"))
      .def(py::init(&parse_tool), py::arg("text"), doc("parse_tool"))
      .def_readwrite("number", &Tool::number, doc("Tool::number"))
      .def_readwrite("name", &Tool::name, doc("Tool::name"))
      .def_property_readonly("kind", [](const Tool& tool) { return name_of(tool.kind); })
      .def_readwrite("diameter", &Tool::diameter, "mm")
      .def_readwrite("corner_radius", &Tool::corner_radius, doc("Tool::corner_radius"))
      .def_readwrite("teeth", &Tool::teeth)
      .def_readwrite("flute_length", &Tool::flute_length, "mm; None: unknown")
      .def_readwrite("stickout", &Tool::stickout, doc("Tool::stickout"))
      .def_readwrite("holder_diameter", &Tool::holder_diameter, doc("Tool::holder_diameter"))
      .def_readwrite("shank_diameter", &Tool::shank_diameter, doc("Tool::shank_diameter"))
      .def_readwrite("max_spindle_rpm", &Tool::max_spindle_rpm, "rpm; None: no limit of its own")
      .def_readwrite("center_cutting", &Tool::center_cutting, doc("Tool::center_cutting"))
      .def("__repr__", [](const Tool& tool) {
        return "<clearcut.Tool T" + std::to_string(tool.number) + " " + name_of(tool.kind) + " " +
               trimmed(tool.diameter, 4) + " mm>";
      });
  py::class_<LibraryTool>(module, "LibraryTool", "A tool with the feeds and speeds that its library gives.")
      .def_readonly("tool", &LibraryTool::tool)
      .def_property_readonly("presets",
                             [](const LibraryTool& tool) {
                               std::vector<std::string> names;
                               for (const auto& preset : tool.presets) names.push_back(preset.name);
                               return names;
                             })
      .def("__repr__",
           [](const LibraryTool& tool) { return "<clearcut.LibraryTool " + tool.tool.name + ">"; });
  module.def(
      "read_tools",
      [](const std::string& file, std::optional<std::string> unit) {
        return read_tool_library(file, {std::move(unit)}).tools;
      },
      py::arg("file"), py::arg("unit") = py::none(), py::call_guard<py::gil_scoped_release>(),
      doc("read_tool_library"));
}

void add_features(py::module_& module) {
  py::class_<Feature>(module, "Feature", doc("Feature"))
      .def_readonly("name", &Feature::name, doc("Feature::name"))
      .def_readonly("source", &Feature::source)
      .def_property_readonly("kind", [](const Feature& feature) { return name_of(feature.kind); })
      .def_readonly("target", &Feature::target, "What is to be removed, plan view: regions.")
      .def_readonly("allowed", &Feature::allowed, "Where the cutter may be: regions.")
      .def_readonly("top_z", &Feature::top_z, doc("Feature::top_z"))
      .def_readonly("floor_z", &Feature::floor_z, "mm")
      .def_property_readonly("wall_slope_deg",
                             [](const Feature& feature) { return feature.wall_slope.degrees(); })
      .def_readonly("hole_diameter", &Feature::hole_diameter, doc("Feature::hole_diameter"))
      .def_readonly("through", &Feature::through)
      .def("__repr__", [](const Feature& feature) {
        return "<clearcut.Feature " + feature.name + ", " + name_of(feature.kind) + ">";
      });
  py::class_<Diagnostic>(module, "Diagnostic", "What a reader or planner noticed without giving up.")
      .def_property_readonly("severity", [](const Diagnostic& one) { return word_for(one.severity); })
      .def_readonly("where", &Diagnostic::where)
      .def_readonly("what", &Diagnostic::what, doc("Diagnostic::what"))
      .def("__str__", [](const Diagnostic& one) {
        return std::string(word_for(one.severity)) + ": " + one.where + ": " + one.what;
      });
}

void add_part_class(py::module_& module) {
  py::class_<GivenPart>(module, "Part", doc("Part"))
      .def_property_readonly("name", [](const GivenPart& given) { return given.part.name; })
      .def_property_readonly("source_file", [](const GivenPart& given) { return given.part.source_file; })
      .def_property_readonly("features", [](const GivenPart& given) { return given.part.features; })
      .def_property_readonly("tools", [](const GivenPart& given) { return given.part.tools; })
      .def_property_readonly(
          "workplan",
          [](const GivenPart& given) {
            std::vector<std::string> names;
            for (const auto& step : given.part.workplan) names.push_back(step.name);
            return names;
          },
          "The names of the workingsteps, in order of cutting.")
      .def_property(
          "clearance_z", [](const GivenPart& given) { return given.part.clearance_z; },
          [](GivenPart& given, std::optional<double> z) { given.part.clearance_z = z; },
          doc("Part::clearance_z"))
      .def_property_readonly(
          "top_z", [](const GivenPart& given) { return given.part.top_z(); }, doc("Part::top_z"))
      .def_property_readonly("diagnostics",
                             [](const GivenPart& given) { return given.part.diagnostics.items(); })
      .def(
          "to_json", [](const GivenPart& given) { return write_outline_json(given.part); },
          "The part as outline JSON.")
      .def(
          "to_stepnc", [](const GivenPart& given) { return write_stepnc(given.part); }, doc("write_stepnc"))
      .def("__repr__", [](const GivenPart& given) {
        return "<clearcut.Part " + given.part.name + " with " + std::to_string(given.part.features.size()) +
               " features>";
      });
}

/// Throws InputError where there is no such kind.
Machine machine_of_kind(const std::string& kind) {
  const std::vector<std::string> kinds = machine_kinds();
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    throw InputError("--machine-kind",
                     "'" + kind + "' is unknown; use one of " + fmt::format("{}", fmt::join(kinds, ", ")));
  Machine machine;
  fill_machine_kind(machine, kind);
  return machine;
}

}  // namespace

CertificateFile certificate_file(const std::string& role, const std::string& file) {
  return {role, file, sha256_hex(read_file(file))};
}

std::vector<CertificateFile> joined(const std::vector<CertificateFile>& part,
                                    const std::vector<CertificateFile>& options) {
  std::vector<CertificateFile> all;
  for (const char* role : {"job", "part", "tools", "machine", "earlier program"}) {
    const auto is_of_role = [role](const CertificateFile& one) { return one.role == role; };
    const auto& from = std::any_of(options.begin(), options.end(), is_of_role) ? options : part;
    std::copy_if(from.begin(), from.end(), std::back_inserter(all), is_of_role);
  }
  return all;
}

void add_part(py::module_& module) {
  add_tools(module);
  add_features(module);
  add_part_class(module);
  add_reader<std::string>(module, "read_part", "file", doc("read_part"), part_of_file);
  add_reader<std::string>(module, "read_job", "file", doc("part_of_job"), job_of_file);
  add_reader<std::string>(module, "read_part_text", "text", doc("read_part_text"), part_of_text);
  py::class_<SetupQuestion>(module, "_SetupQuestion",
                            "One set-up of a job, from 1, and part, moves and findings of those before it.")
      .def(py::init<std::string, int, std::vector<std::tuple<GivenPart, Moves, std::optional<Findings>>>>(),
           py::arg("file"), py::arg("number"), py::arg("earlier"));
  add_reader<SetupQuestion>(module, "_read_setup", "question", doc("part_of_setup"), job_of_setup);
  module.def(
      "_setup_count", [](const std::string& file) { return read_job(file).setups.size(); }, py::arg("file"));
  py::class_<Machine>(module, "Machine", doc("Machine"))
      .def(py::init(&machine_of_kind), py::arg("kind"), doc("fill_machine_kind"))
      .def_readonly("name", &Machine::name)
      .def_readwrite("acceleration", &Machine::acceleration, doc("Machine::acceleration"))
      .def_readwrite("junction_deviation", &Machine::junction_deviation, doc("Machine::junction_deviation"));
  module.def(
      "read_machine", [](const std::string& file) { return read_machine(file); }, py::arg("file"),
      doc("read_machine"));
  py::class_<Job>(module, "Job", "A part with everything that its job file asks of a plan.")
      .def_readonly("part", &Job::part)
      .def_readonly("options", &Job::options);
}

}  // namespace clearcut::python
