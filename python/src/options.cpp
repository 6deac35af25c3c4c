// PlanOptions as keywords: the names of the command's options with underscores.
#include "option_attributes.h"

namespace clearcut::python {
namespace {

/// Tools, texts like "endmill:6" and tools of a library, one or several.
void set_tools(AskedOptions& options, const py::object& value) {
  const bool several = py::isinstance<py::sequence>(value) && !py::isinstance<py::str>(value);
  const py::list given = several ? py::list(value) : py::list(py::make_tuple(value));
  std::vector<LibraryTool> tools;
  bool library = false;
  for (const py::handle& one : given) {
    if (py::isinstance<py::str>(one))
      tools.push_back({parse_tool(one.cast<std::string>()), {}});
    else if (py::isinstance<LibraryTool>(one))
      library = true, tools.push_back(one.cast<LibraryTool>());
    else
      tools.push_back({one.cast<Tool>(), {}});
  }
  options.tools.clear();
  for (const LibraryTool& tool : tools) options.tools.push_back(tool.tool);
  options.tool_cutting = library ? cutting_of_tools(tools, "") : std::vector<ToolCutting>{};
}

/// Another file of that role, or none.
void set_file(AskedOptions& options, const std::string& role, const std::optional<std::string>& file) {
  std::erase_if(options.files, [&](const CertificateFile& one) { return one.role == role; });
  if (file) options.files.push_back(certificate_file(role, *file));
}

void set_machine(AskedOptions& options, const py::object& value) {
  if (py::isinstance<Machine>(value)) {
    options.machine = value.cast<Machine>();
    set_file(options, "machine", {});
    return;
  }
  const auto file = py::str(value).cast<std::string>();
  options.machine = read_machine(file);
  options.sources.merge(machine_sources(file));
  set_file(options, "machine", file);
}

/// Options given as objects and files, which the rows have as texts.
void add_objects(OptionsClass& options) {
  options.def_property(
      "machine", [](const AskedOptions& o) { return o.machine; }, &set_machine,
      "A Machine, or the machine file (.toml) to read.");
  options.def_property(
      "after", [](const AskedOptions& o) { return o.earlier.has_value(); },
      [](AskedOptions& o, const py::object& file) {
        o.earlier.reset();
        o.earlier_state = {};
        const bool none = file.is_none();
        const auto name = none ? std::string() : py::str(file).cast<std::string>();
        if (!none) read_earlier_program(o, name);
        set_file(o, "earlier program", none ? std::nullopt : std::optional(name));
      },
      "File of a program that has run before on this stock: only what it left is cut. Set the machine "
      "first.");
  options.def_property(
      "tools", [](const AskedOptions& o) { return o.tools; }, &set_tools,
      "What cuts instead of the part's own tools: texts like 'endmill:6', tools, tools of a library; "
      "one or a sequence.");
  options.def_property(
      "predrilled",
      [](const AskedOptions& o) {
        std::vector<std::tuple<double, double, double>> holes;
        for (const auto& hole : o.predrilled) holes.emplace_back(hole.center.x, hole.center.y, hole.diameter);
        return holes;
      },
      [](AskedOptions& o, const std::vector<std::tuple<double, double, double>>& holes) {
        o.predrilled.clear();
        for (const auto& [x, y, diameter] : holes) o.predrilled.push_back({{x, y}, diameter});
      },
      "Holes that are there before the work begins: x, y, diameter of each, mm.");
  options.def_property(
      "keep_out",
      [](const AskedOptions& o) {
        const auto range = [](double low, double high) { return trimmed(low, 6) + ":" + trimmed(high, 6); };
        std::vector<std::string> clamps;
        for (const KeepOut& one : o.keep_outs)
          clamps.push_back(range(one.plan.min.x, one.plan.max.x) + "," +
                           range(one.plan.min.y, one.plan.max.y) + "," + range(one.bottom_z, one.top_z));
        return clamps;
      },
      [](AskedOptions& o, const std::vector<std::string>& clamps) {
        o.keep_outs.clear();
        for (const std::string& clamp : clamps) o.keep_outs.push_back(parse_keep_out(clamp));
      },
      "Blocks where clamps are, as ranges of x, y and z: '-10:15,20:40,-20:12'; coming there is a fault.");
  options.def_property(
      "program_name", [](const AskedOptions& o) { return o.post.program_name; },
      [](AskedOptions& o, const std::string& name) { o.post.program_name = name; },
      doc("PostOptions::program_name"));
}

/// What a mistyped keyword may have meant, of the attributes of `type`.
py::type_error unknown_option(const std::string& name, const py::handle& type) {
  std::vector<std::string> known;
  for (const py::handle& one : py::module_::import("builtins").attr("dir")(type)) {
    auto attribute = py::str(one).cast<std::string>();
    if (!attribute.starts_with("_")) known.push_back(std::move(attribute));
  }
  const std::string meant = nearest_name(name, known);
  return py::type_error("'" + name + "' is no option of a plan; " +
                        (meant.empty() ? "" : "did you mean '" + meant + "'? ") +
                        "dir(clearcut.PlanOptions) lists them");
}

/// Sets options by keywords. The machine goes first: others change a part of it, or are read with it.
void set_all(const py::object& options, const py::dict& settings) {
  const auto set = [&](const py::handle& name, const py::handle& value) {
    if (!py::hasattr(options.get_type(), name) || py::str(name).cast<std::string>().starts_with("_"))
      throw unknown_option(py::str(name).cast<std::string>(), options.get_type());
    py::setattr(options, name, value);
    const auto typed = option_name(py::str(name).cast<std::string>());
    const std::string word = typed == "tools" ? "tool" : typed;
    options.cast<AskedOptions&>().sources.set(word, {Origin::kUser, "--" + word});
  };
  if (settings.contains("machine")) set(py::str("machine"), settings["machine"]);
  for (const auto& [name, value] : settings) {
    const auto word = py::str(name).cast<std::string>();
    if (word != "machine" && word != "after") set(name, value);
  }
  if (settings.contains("after")) set(py::str("after"), settings["after"]);
}

}  // namespace

void add_options(py::module_& module) {
  OptionsClass options(
      module, "PlanOptions",
      "What is asked of a plan, by the names of the command's options with underscores. What is not set is "
      "taken from the part's operations, else from the documented defaults.");
  options.def(py::init([](const py::kwargs& settings) {
    const py::object fresh = py::cast(AskedOptions{});
    set_all(fresh, settings);
    return fresh.cast<AskedOptions>();
  }));
  options.def(
      "replaced",
      [](const AskedOptions& given, const py::kwargs& settings) {
        const py::object copy = py::cast(AskedOptions(given));
        set_all(copy, settings);
        return copy;
      },
      "These options with some of them set anew.");
  options.def(
      "check", [](const AskedOptions& given) { check_options(given); }, doc("check_options"));
  add_rows(options);
  add_objects(options);
}

}  // namespace clearcut::python
