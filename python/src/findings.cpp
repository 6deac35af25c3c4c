// What verification found, as objects.
#include "bindings.h"

namespace clearcut::python {
namespace {

void add_places(py::module_& module) {
  py::class_<Place>(module, "Place", doc("Place"))
      .def_property_readonly("x", [](const Place& place) { return place.point.x; })
      .def_property_readonly("y", [](const Place& place) { return place.point.y; })
      .def_readonly("z", &Place::z)
      .def_readonly("line", &Place::line, doc("Place::line"));
  py::class_<Fault>(module, "Fault", "What is wrong, and where.")
      .def_property_readonly("kind", [](const Fault& fault) { return name_of(fault.kind); })
      .def_readonly("feature", &Fault::feature, doc("Fault::feature"))
      .def_readonly("at", &Fault::at)
      .def_readonly("size", &Fault::size, doc("Fault::size"))
      .def_readonly("text", &Fault::text, doc("Fault::text"))
      .def("__repr__", [](const Fault& fault) { return "<clearcut.Fault " + fault.text + ">"; });
  py::class_<Condition>(module, "Condition", doc("Condition"))
      .def_readonly("name", &Condition::name, doc("Condition::name"))
      .def_readonly("text", &Condition::text, doc("Condition::text"))
      .def_readonly("line", &Condition::line, doc("Condition::line"))
      .def_readonly("met_by", &Condition::met_by, doc("Condition::met_by"))
      .def("__repr__", [](const Condition& one) { return "<clearcut.Condition " + one.name + ">"; });
}

void add_engagement(py::module_& module) {
  py::class_<Engagement>(module, "Engagement", doc("Engagement"))
      .def_readonly("max_deg", &Engagement::max_deg)
      .def_readonly("max_at", &Engagement::max_at)
      .def_readonly("mean_deg", &Engagement::mean_deg, doc("Engagement::mean_deg"))
      .def_readonly("over_limit_mm", &Engagement::over_limit_mm, doc("Engagement::over_limit_mm"))
      .def_readonly("histogram_mm", &Engagement::histogram_mm, doc("Engagement::histogram_mm"))
      .def_readonly("climb_mm", &Engagement::climb_mm, doc("Engagement::climb_mm"))
      .def_readonly("conventional_mm", &Engagement::conventional_mm);
}

void add_figures(py::module_& module) {
  py::class_<Figures>(module, "Figures", "Lengths, times, what is left, what was spoiled.")
      .def_readonly("feed_mm", &Figures::feed_mm)
      .def_readonly("rapid_mm", &Figures::rapid_mm)
      .def_readonly("plunge_mm", &Figures::plunge_mm)
      .def_readonly("turns", &Figures::turns, doc("Figures::turns"))
      .def_readonly("turn_angle_deg", &Figures::turn_angle_deg)
      .def_readonly("retracts", &Figures::retracts, doc("Figures::retracts"))
      .def_readonly("time_s", &Figures::time_s, doc("Figures::time_s"))
      .def_readonly("waits_s", &Figures::waits_s, doc("Figures::waits_s"))
      .def_readonly("time_naive_s", &Figures::time_naive_s, doc("Figures::time_naive_s"))
      .def_readonly("uncut_mm2", &Figures::uncut_mm2, doc("Figures::uncut_mm2"))
      .def_readonly("uncut_thickness_mm", &Figures::uncut_thickness_mm, doc("Figures::uncut_thickness_mm"))
      .def_readonly("uncut_at", &Figures::uncut_at)
      .def_readonly("gouge_mm", &Figures::gouge_mm, doc("Figures::gouge_mm"))
      .def_readonly("gouge_at", &Figures::gouge_at)
      .def_readonly("unreachable_mm2", &Figures::unreachable_mm2, doc("Figures::unreachable_mm2"))
      .def_readonly("rapid_in_material", &Figures::rapid_in_material, doc("Figures::rapid_in_material"))
      .def_readonly("max_axial_mm", &Figures::max_axial_mm, doc("Figures::max_axial_mm"))
      .def_readonly("engagement", &Figures::engagement)
      .def_readonly("air_cut_mm", &Figures::air_cut_mm, doc("Figures::air_cut_mm"))
      .def_readonly("lower_bound_mm", &Figures::lower_bound_mm, doc("Figures::lower_bound_mm"))
      .def_readonly("clean", &Figures::clean);
}

}  // namespace

void add_findings(py::module_& module) {
  add_places(module);
  add_engagement(module);
  add_figures(module);
  py::class_<LayerFindings>(module, "LayerFindings", "Figures of one layer.")
      .def_readonly("z", &LayerFindings::z)
      .def_readonly("figures", &LayerFindings::figures);
  py::class_<FeatureFindings>(module, "FeatureFindings", "Figures of one workingstep.")
      .def_readonly("name", &FeatureFindings::name)
      .def_readonly("workingstep", &FeatureFindings::workingstep)
      .def_readonly("tool_number", &FeatureFindings::tool_number)
      .def_readonly("tool_diameter", &FeatureFindings::tool_diameter)
      .def_readonly("figures", &FeatureFindings::figures)
      .def_readonly("layers", &FeatureFindings::layers, doc("FeatureFindings::layers"));
  py::class_<Findings>(module, "Findings", "Figures and faults of a program, with places.")
      .def_readonly("all", &Findings::all, "Of the whole.")
      .def_readonly("features", &Findings::features, doc("Findings::features"))
      .def_readonly("faults", &Findings::faults, doc("Findings::faults"))
      .def_readonly("conditions", &Findings::conditions, doc("Findings::conditions"))
      .def_property_readonly(
          "verdict", [](const Findings& findings) { return name_of(verdict_of(findings)); }, doc("Verdict"))
      .def("reasons", &verdict_and_reasons,
           "The verdict, then each fault and each open condition on a line of its own.");
}

}  // namespace clearcut::python
