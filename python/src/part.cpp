// Parts, tools, jobs, machines.
#include <algorithm>
#include <iterator>

#include "bindings.h"

namespace clearcut::python {
namespace {

struct Reading {
  std::optional<std::string> unit;
  std::vector<std::string> layers, ops;
  std::optional<double> top, depth, scale, join_gap;
  std::optional<std::string> open_curves, strokes, letters;
  SolidOptions solid;
  bool mirror = false;

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
template <class Use>
auto reader(Use use) {
  return [use](const std::string& what, const std::string& name, std::optional<std::string> unit,
               std::vector<std::string> layers, std::vector<std::string> ops, std::optional<double> top,
               std::optional<double> depth, std::optional<double> scale, std::optional<double> join_gap,
               std::optional<std::string> open_curves, std::optional<std::string> strokes,
               std::optional<std::string> letters, std::string up, double turn, std::string body,
               std::optional<double> breakthrough, std::vector<double> drills, bool mirror) {
    Reading reading{
        std::move(unit),        std::move(layers),  std::move(ops),     top, depth, scale, join_gap,
        std::move(open_curves), std::move(strokes), std::move(letters), {}};
    reading.mirror = mirror;
    reading.solid.up = std::move(up);
    reading.solid.turn_deg = turn;
    reading.solid.body = std::move(body);
    reading.solid.breakthrough = breakthrough;
    reading.solid.drills = std::move(drills);
    return use(what, name, reading.options());
  };
}

template <class Use>
void add_reader(py::module_& module, const char* name, const char* first, const char* text, Use use) {
  module.def(name, reader(use), py::arg(first), py::arg("name") = "", py::kw_only(),
             py::arg("unit") = py::none(), py::arg("layers") = std::vector<std::string>{},
             py::arg("ops") = std::vector<std::string>{}, py::arg("top") = py::none(),
             py::arg("depth") = py::none(), py::arg("scale") = py::none(), py::arg("join_gap") = py::none(),
             py::arg("open_curves") = py::none(), py::arg("strokes") = py::none(),
             py::arg("letters") = py::none(), py::arg("up") = "", py::arg("turn") = 0.0, py::arg("body") = "",
             py::arg("breakthrough") = py::none(), py::arg("drills") = std::vector<double>{},
             py::arg("mirror") = false, py::call_guard<py::gil_scoped_release>(), text);
}

GivenPart part_of_text(const std::string& text, const std::string& name, const ReadOptions& options) {
  // No file of that name is read, so one may be written: the first pocket of an example is called as its results are.
  return {read_part_text(text, name, options), {{"part", name + " (text)", sha256_hex(text)}}};
}

GivenPart part_of_file(const std::string& file, const std::string&, const ReadOptions& options) {
  return {read_part(file, options), {certificate_file("part", file)}};
}

Job job_of_file(const std::string& file, const std::string&, const ReadOptions& reading) {
  const JobFile job = read_job(file);
  Job out;
  StepSources sources;
  StepChoices published;
  out.part.part = part_of_job(job, reading, sources, published);
  static_cast<PlanOptions&>(out.options) = options_of_job(job);
  out.options.step_sources = std::move(sources);
  out.options.step_published = std::move(published);
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
  add_reader(module, "read_part", "file", doc("read_part"), part_of_file);
  add_reader(module, "read_job", "file", doc("part_of_job"), job_of_file);
  add_reader(module, "read_part_text", "text", doc("read_part_text"), part_of_text);
  py::class_<Machine>(module, "Machine", doc("Machine"))
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
