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

/// A share of the diameter as a number, or text as on the command line.
std::string stepover_of(const py::handle& value, const std::string&) {
  return py::str(value).cast<std::string>();
}

void add_cutting(OptionsClass& options) {
  add_plain<std::string>(
      options, "strategy", doc("PlanOptions::strategy"), [](auto& o) -> auto& { return o.strategy; });
  add_optional(
      options, "stepover", doc("PlanOptions::stepover"), [](auto& o) -> auto& { return o.stepover; },
      stepover_of, [](const std::string& text) { return text; });
  add_plain<double>(
      options, "angle", doc("PlanOptions::angle_deg"), [](auto& o) -> auto& { return o.angle_deg; });
  add_length(
      options, "stepdown", "Depth of one layer, mm.", [](auto& o) -> auto& { return o.stepdown; });
  add_length(
      options, "allowance", "Stock to leave on walls, mm.", [](auto& o) -> auto& { return o.allowance; });
  add_length(
      options, "allowance_floor", "Stock to leave on floors, mm.",
      [](auto& o) -> auto& { return o.allowance_floor; });
  add_plain<double>(
      options, "engagement", "Largest engagement angle of the cutter, degrees.",
      [](auto& o) -> auto& { return o.engagement_deg; });
  add_named(
      options, "entry", "helix, ramp, zigzag or plunge.", [](auto& o) -> auto& { return o.entry; },
      entry_named, [](EntryKind entry) { return resolve::name_of(entry); });
  add_angle(
      options, "entry_angle", "Steepest angle of a helix or ramp, degrees.",
      [](auto& o) -> auto& { return o.entry_angle; });
  add_length(
      options, "lead", doc("PlanOptions::lead"), [](auto& o) -> auto& { return o.lead; });
  add_angle(
      options, "lead_angle", "Straight leads at this angle to the pass, degrees; None: arcs.",
      [](auto& o) -> auto& { return o.lead_angle; });
  add_length(
      options, "scallop", doc("PlanOptions::scallop"), [](auto& o) -> auto& { return o.scallop; });
  add_named(
      options, "direction", "climb or conventional.", [](auto& o) -> auto& { return o.direction; },
      direction_named, [](CutDirection direction) { return resolve::name_of(direction); });
  add_feed(
      options, "feed", "Cutting feed, mm/min.", [](auto& o) -> auto& { return o.cutting.feed; });
  add_feed(
      options, "plunge_feed", "Plunge feed, mm/min.", [](auto& o) -> auto& { return o.cutting.plunge_feed; });
  add_feed(
      options, "ramp_feed", "Feed on ramps and helices, mm/min.",
      [](auto& o) -> auto& { return o.cutting.ramp_feed; });
  add_feed(
      options, "slot_feed", "Feed where the cutter cuts its full width (slotting), mm/min.",
      [](auto& o) -> auto& { return o.cutting.slot_feed; });
  add_plain<double>(
      options, "spindle", "Spindle speed, rpm.", [](auto& o) -> auto& { return o.cutting.spindle_rpm; });
  add_named(
      options, "coolant", "off, flood, mist or both.", [](auto& o) -> auto& { return o.cutting.coolant; },
      resolve::coolant_named, [](Coolant coolant) { return name_of(coolant); });
}

void add_shop(OptionsClass& options) {
  const auto length = [&](const char* name, const char* text, auto at) {
    add_length(options, name, text, at);
  };
  length(
      "helix_diameter", doc("ShopOptions::helix_widest"),
      [](auto& o) -> auto& { return o.shop.helix_widest; });
  length(
      "helix_min", doc("ShopOptions::helix_narrowest"),
      [](auto& o) -> auto& { return o.shop.helix_narrowest; });
  length(
      "lead_overlap", doc("ShopOptions::lead_overlap"), [](auto& o) -> auto& { return o.shop.lead_overlap; });
  length(
      "overrun", doc("ShopOptions::overrun"), [](auto& o) -> auto& { return o.shop.overrun; });
  length(
      "stock_oversize", doc("ShopOptions::stock_oversize"),
      [](auto& o) -> auto& { return o.shop.stock_oversize; });
  length(
      "link_lift", doc("ShopOptions::link_lift"), [](auto& o) -> auto& { return o.shop.link_lift; });
  length(
      "finish_stock", doc("ShopOptions::finish_stock"), [](auto& o) -> auto& { return o.shop.finish_stock; });
  length(
      "finish_stock_floor", "mm left on floors for finishing.",
      [](auto& o) -> auto& { return o.shop.finish_stock_floor; });
  add_feed(
      options, "lead_feed", doc("ShopOptions::lead_feed"), [](auto& o) -> auto& { return o.shop.lead_feed; });
  add_feed(
      options, "link_feed", doc("ShopOptions::link_feed"), [](auto& o) -> auto& { return o.shop.link_feed; });
  add_plain<double>(
      options, "slot_angle", doc("ShopOptions::slot_angle_deg"),
      [](auto& o) -> auto& { return o.shop.slot_angle_deg; });
  add_named(
      options, "feed_by", "chip or removal: feeds follow the load.",
      [](auto& o) -> auto& { return o.shop.feed_by; }, resolve::feed_by_named,
      [](FeedBy by) { return resolve::name_of(by); });
  add_plain<double>(
      options, "reference_engagement", "Engagement at which a feed is meant as stated, degrees.",
      [](auto& o) -> auto& { return o.shop.reference_engagement_deg; });
  add_feed(
      options, "reference_feed", "Feed at the reference engagement, mm/min.",
      [](auto& o) -> auto& { return o.shop.reference_feed; });
  add_feed(
      options, "feed_cap", "Highest feed with feed_by, mm/min.",
      [](auto& o) -> auto& { return o.shop.feed_cap; });
  add_value(
      options, "margin", doc("ShopOptions::margin"), [](auto& o) -> auto& { return o.shop.margin; });
  length(
      "margin_at_least",
      "mm that the machine may leave the path: the plan is to allow that, and the verdict asks it.",
      [](auto& o) -> auto& { return o.shop.margin_at_least; });
  length(
      "margin_uncut", doc("ShopOptions::margin_uncut"), [](auto& o) -> auto& { return o.shop.margin_uncut; });
  length(
      "margin_gouge", doc("ShopOptions::margin_gouge"), [](auto& o) -> auto& { return o.shop.margin_gouge; });
  add_plain<bool>(
      options, "rest", doc("ShopOptions::rest"), [](auto& o) -> auto& { return o.shop.rest; });
  add_plain<std::string>(
      options, "finish", doc("ShopOptions::finish"), [](auto& o) -> auto& { return o.shop.finish; });
  add_plain<double>(
      options, "finish_depths", doc("ShopOptions::finish_depths"),
      [](auto& o) -> auto& { return o.shop.finish_depths; });
  add_plain<double>(
      options, "finish_steps", doc("ShopOptions::finish_steps"),
      [](auto& o) -> auto& { return o.shop.finish_steps; });
  add_plain<double>(
      options, "spring_passes", doc("ShopOptions::spring_passes"),
      [](auto& o) -> auto& { return o.shop.spring_passes; });
  add_plain<std::string>(
      options, "compensation", doc("ShopOptions::compensation"),
      [](auto& o) -> auto& { return o.shop.compensation; });
  length(
      "wear_range", doc("ShopOptions::wear_range"), [](auto& o) -> auto& { return o.shop.wear_range; });
  add_plain<std::string>(
      options, "dogbones", doc("ShopOptions::dogbones"), [](auto& o) -> auto& { return o.shop.dogbones; });
  add_plain<std::string>(
      options, "style", doc("ShopOptions::style"), [](auto& o) -> auto& { return o.shop.style; });
  add_plain<std::string>(
      options, "material", doc("ShopOptions::material"), [](auto& o) -> auto& { return o.shop.material; });
}

void add_tabs(OptionsClass& options) {
  add_length(
      options, "skin", doc("TabOptions::skin"), [](auto& o) -> auto& { return o.tabs.skin; });
  add_length(
      options, "tab_height", doc("TabOptions::height"), [](auto& o) -> auto& { return o.tabs.height; });
  add_length(
      options, "tab_spacing", doc("TabOptions::spacing"), [](auto& o) -> auto& { return o.tabs.spacing; });
  options
      .def_property(
          "tabs", [](const AskedOptions& o) { return o.tabs.count; },
          [](AskedOptions& o, int count) { o.tabs.count = count; }, doc("TabOptions::count"))
      .def_property(
          "tab_width", [](const AskedOptions& o) { return o.tabs.width; },
          [](AskedOptions& o, const py::object& mm) { o.tabs.width = length_of(mm, "tab-width"); },
          doc("TabOptions::width"))
      .def_property(
          "tab_shape", [](const AskedOptions& o) { return resolve::name_of(o.tabs.shape); },
          [](AskedOptions& o, const std::string& name) {
            o.tabs.shape = tab_shape_named(name, "--tab-shape");
          },
          "Of tabs: square, or triangular, which the cutter rises over without a stop.")
      .def_property(
          "tab_at",
          [](const AskedOptions& o) {
            std::vector<std::pair<double, double>> places;
            for (const Vec2 p : o.tabs.at) places.emplace_back(p.x, p.y);
            return places;
          },
          [](AskedOptions& o, const std::vector<std::pair<double, double>>& places) {
            o.tabs.at.clear();
            for (const auto& [x, y] : places) o.tabs.at.push_back({x, y});
          },
          doc("TabOptions::at"));
}

void add_copies(OptionsClass& options) {
  add_plain<std::string>(
      options, "copies", doc("CopiesOptions::grid"), [](auto& o) -> auto& { return o.copies.grid; });
  add_plain<std::string>(
      options, "nest", doc("CopiesOptions::sheet"), [](auto& o) -> auto& { return o.copies.sheet; });
  add_length(
      options, "gap", doc("CopiesOptions::gap"), [](auto& o) -> auto& { return o.copies.gap; });
  add_length(
      options, "edge", doc("CopiesOptions::edge"), [](auto& o) -> auto& { return o.copies.edge; });
  add_plain<int>(
      options, "count", doc("CopiesOptions::count"), [](auto& o) -> auto& { return o.copies.count; });
  add_value(
      options, "subprograms", doc("CopiesOptions::subprograms"),
      [](auto& o) -> auto& { return o.copies.subprograms; });
}

void add_machine(OptionsClass& options) {
  options
      .def_property(
          "machine", [](const AskedOptions& o) { return o.machine; }, &set_machine,
          "A Machine, or the machine file (.toml) to read.")
      .def_property(
          "rapid", [](const AskedOptions& o) { return o.machine.rapid.mm_per_min(); },
          [](AskedOptions& o, const py::object& feed) { o.machine.rapid = feed_of(feed, "rapid"); },
          "Rapid feed of the machine, mm/min.");
  add_value(
      options, "acceleration", doc("Machine::acceleration"),
      [](auto& o) -> auto& { return o.machine.acceleration; });
  add_value(
      options, "junction_deviation", doc("Machine::junction_deviation"),
      [](auto& o) -> auto& { return o.machine.junction_deviation; });
  add_value(
      options, "accept", doc("PlanOptions::accept"), [](auto& o) -> auto& { return o.accept; });
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
}

void add_search(OptionsClass& options) {
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
      "order", [](const AskedOptions& o) { return o.outside_in ? "outside-in" : "inside-out"; },
      [](AskedOptions& o, const std::string& order) {
        o.outside_in = order_named(order, "--order") == ContourOrder::kOutsideIn;
      },
      "Order of contours: inside-out or outside-in.");
  options.def_property(
      "toolpaths",
      [](const AskedOptions& o) -> std::optional<std::string> {
        if (!o.toolpaths) return std::nullopt;
        return *o.toolpaths == ToolpathSource::kFile ? "file" : "ours";
      },
      [](AskedOptions& o, const std::optional<std::string>& source) {
        o.toolpaths.reset();
        if (!source) return;
        if (*source != "file" && *source != "ours")
          throw InputError("toolpaths", "'" + *source + "' is unknown; use file or ours");
        o.toolpaths = *source == "file" ? ToolpathSource::kFile : ToolpathSource::kOurs;
      },
      "Where a STEP-NC file states toolpaths: file, to use them as they stand, or ours.");
  add_optional(
      options, "start", doc("PlanOptions::start"), [](auto& o) -> auto& { return o.start; },
      [](const py::handle& point, const std::string&) {
        const auto [x, y] = point.cast<std::pair<double, double>>();
        return Vec2{x, y};
      },
      [](Vec2 point) { return std::make_pair(point.x, point.y); });
  add_value(
      options, "objective", "Of the strategy tour: length, turns, angle, engagement, time, or weights.",
      [](auto& o) -> auto& { return o.objective; });
  add_plain<double>(
      options, "time", "Longest search, s.", [](auto& o) -> auto& { return o.time_s; });
  add_value(
      options, "seed", "Seed of the search.", [](auto& o) -> auto& { return o.seed; });
  add_value(
      options, "threads", doc("PlanOptions::threads"), [](auto& o) -> auto& { return o.threads; });
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
  add_cutting(options);
  add_shop(options);
  add_tabs(options);
  add_copies(options);
  add_post_options(options);
  add_published_options(options);
  add_machine(options);
  add_search(options);
}

}  // namespace clearcut::python
