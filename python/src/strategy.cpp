// Strategies written in Python: from a layer to passes.
#include <clearcut/strategy.h>

#include "bindings.h"

namespace clearcut::python {
namespace {

/// Calls the function. An InputError raised there is one of ours: "auto" then goes on with other strategies.
LayerPasses call(const py::object& function, const Layer& layer) {
  const py::gil_scoped_acquire lock;
  try {
    return function(layer).cast<LayerPasses>();
  } catch (py::error_already_set& error) {
    const auto input_error = py::module_::import("clearcut._core").attr("InputError");
    if (!error.matches(input_error)) throw;
    throw InputError("", py::str(error.value()).cast<std::string>());
  }
}

StrategyEntry entry_of(const OwnStrategy& own) {
  StrategyEntry entry;
  entry.name = own.name;
  entry.description = own.description;
  entry.in_auto = own.in_auto ? AutoUse::kTried : AutoUse::kNever;
  entry.make = [own](const StrategyRequest&) {
    return once_per_outline([own](const Layer& layer) {
      LayerPasses passes = call(*own.function, layer);
      passes.strategy = own.name;
      return passes;
    });
  };
  return entry;
}

int add_pass(LayerPasses& passes, const Numbers& path, bool closed, int parent, int component, double offset,
             bool reversible) {
  Pass pass;
  pass.path = closed ? loop_of(path) : path_of(path);
  pass.closed = closed;
  pass.parent = parent;
  pass.component = component;
  pass.offset = offset;
  pass.reversible = reversible;
  if (parent < -1 || parent >= static_cast<int>(passes.passes.size()))
    throw py::index_error("parent " + std::to_string(parent) + " is no pass that was added before");
  passes.passes.push_back(std::move(pass));
  return static_cast<int>(passes.passes.size()) - 1;
}

void add_layer(py::module_& module) {
  py::class_<Layer>(module, "Layer", "What every strategy takes: one layer of one feature with its cutter.")
      .def_readonly("z_top", &Layer::z_top, doc("Layer::z_top"))
      .def_readonly("z", &Layer::z, doc("Layer::z"))
      .def_readonly("target", &Layer::target, doc("Layer::target"))
      .def_readonly("allowed", &Layer::allowed, doc("Layer::allowed"))
      .def_readonly("tool_radius", &Layer::tool_radius, doc("Layer::tool_radius"))
      .def_readonly("wall_stock", &Layer::wall_stock, doc("Layer::wall_stock"))
      .def_property_readonly(
          "closed_all_round", [](const Layer& layer) { return closed_all_round(layer); },
          doc("closed_all_round"))
      .def(
          "clearing_area", [](const Layer& layer) { return clearing_area(layer, {}); },
          py::call_guard<py::gil_scoped_release>(), doc("clearing_area"));
}

void add_passes(py::module_& module) {
  py::class_<Pass>(module, "Pass", doc("Pass"))
      .def_property_readonly(
          "path",
          [](const Pass& pass) { return pass.closed ? array_of(Loop(pass.path)) : array_of_path(pass.path); },
          "Rows of x, y, bulge.")
      .def_readonly("closed", &Pass::closed, doc("Pass::closed"))
      .def_readonly("parent", &Pass::parent, doc("Pass::parent"))
      .def_readonly("component", &Pass::component, doc("Pass::component"))
      .def_readonly("offset", &Pass::offset, doc("Pass::offset"))
      .def_readonly("reversible", &Pass::reversible, doc("Pass::reversible"));
  py::class_<LayerPasses>(module, "LayerPasses", doc("LayerPasses"))
      .def_readonly("z", &LayerPasses::z, doc("LayerPasses::z"))
      .def_readonly("legal", &LayerPasses::legal, doc("LayerPasses::legal"))
      .def_readonly("passes", &LayerPasses::passes)
      .def_readwrite("residual", &LayerPasses::residual, doc("LayerPasses::residual"))
      .def_readwrite("outside_in", &LayerPasses::outside_in, doc("LayerPasses::outside_in"))
      .def("add", &add_pass, py::arg("path"), py::arg("closed") = true, py::arg("parent") = -1,
           py::arg("component") = 0, py::arg("offset") = 0.0, py::arg("reversible") = true,
           "Adds a pass of the tool's centre, rows of x, y or x, y, bulge. Returns its index, which passes "
           "within it name "
           "as their parent.");
  py::class_<ClearingComponent>(module, "ClearingComponent", doc("ClearingComponent"))
      .def_readonly("legal", &ClearingComponent::legal,
                    "Where the tool's centre may be: one connected region.")
      .def_readonly("rest", &ClearingComponent::rest, doc("ClearingComponent::rest"))
      .def_readonly("outer_wall", &ClearingComponent::outer_wall, doc("ClearingComponent::outer_wall"));
  py::class_<ClearingArea>(module, "ClearingArea",
                           "What most strategies begin with; see Layer.clearing_area().")
      .def_readonly("components", &ClearingArea::components, doc("ClearingArea::components"))
      .def_readonly("walls", &ClearingArea::walls, doc("ClearingArea::walls"));
}

}  // namespace

std::shared_ptr<const StrategyTable> table_with(const std::vector<OwnStrategy>& own) {
  if (own.empty()) return nullptr;
  std::vector<StrategyEntry> entries = built_in_strategies().entries();
  for (const OwnStrategy& one : own) {
    if (one.name.empty() || StrategyTable(entries).find(one.name) != nullptr || one.name == "auto")
      throw InputError("strategies", "the name '" + one.name + "' is taken or empty; choose another");
    entries.push_back(entry_of(one));
  }
  return std::make_shared<const StrategyTable>(std::move(entries));
}

void add_strategies(py::module_& module) {
  add_layer(module);
  add_passes(module);
  py::class_<OwnStrategy>(
      module, "Strategy",
      "A strategy of one's own: `function` takes a Layer and returns LayerPasses, most easily the walls of "
      "Layer.clearing_area() with passes added. Order, links, entries, program and certificate are made as "
      "for every other. "
      "The same layer has to give the same passes. It may be called from several threads; what it raises "
      "ends the plan, but "
      "an InputError, after which 'auto' goes on without it. `in_auto`: whether 'auto' tries it.")
      .def(
          py::init([](std::string name, const py::function& function, std::string description, bool in_auto) {
            return OwnStrategy{std::move(name), std::move(description), shared(function), in_auto};
          }),
          py::arg("name"), py::arg("function"), py::arg("description") = "", py::arg("in_auto") = false)
      .def_readonly("name", &OwnStrategy::name)
      .def_readonly("description", &OwnStrategy::description);
  module.def(
      "strategy_names", [] { return strategy_names(); }, "Names that the option strategy takes.");
  module.def(
      "description_of", [](const std::string& name) { return description_of(name); }, py::arg("strategy"),
      doc("description_of"));
}

}  // namespace clearcut::python
