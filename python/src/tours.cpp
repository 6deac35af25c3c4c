// Tours over points.
#include <limits>

#include "interruptible.h"

namespace clearcut::python {
namespace {

std::vector<Vec2> points_of(const Numbers& array) {
  if (array.ndim() != 2 || array.shape(1) != 2) throw InputError("points", "is an array of rows x, y");
  const auto at = array.unchecked<2>();
  std::vector<Vec2> points;
  for (py::ssize_t i = 0; i < array.shape(0); ++i) points.push_back({at(i, 0), at(i, 1)});
  return points;
}

/// A lattice or a file by its name; a search has a clock of its own.
TourResult tour_of_name(const std::string& input, const TourOptions& options) {
  return interruptible(py::none(), [input, options](std::stop_token cancel) {
    TourOptions own = options;
    own.cancel = std::move(cancel);
    return solve_tour(input, own);
  });
}

TourResult tour_of_points(const Numbers& array, const TourOptions& options) {
  order::Problem problem;
  problem.points = points_of(array);
  problem.shape = options.closed.value_or(true) ? order::Shape::kClosedTour : order::Shape::kOpenPath;
  return interruptible(py::none(), [problem, options](std::stop_token cancel) {
    TourOptions own = options;
    own.cancel = std::move(cancel);
    return solve_tour(problem, own);
  });
}

TourResult tour(const py::object& input, const std::string& objective, std::optional<bool> closed,
                double time, std::uint64_t seed, int threads, double feed, std::optional<double> diameter,
                double engagement, const std::string& solver, std::optional<long long> generations) {
  TourOptions options;
  options.objective = objective;
  options.closed = closed;
  options.time_s = time;
  options.seed = seed;
  options.threads = threads;
  options.feed = feed;
  options.diameter = diameter;
  options.engagement_percent = engagement;
  options.solver = solver;
  if (generations) options.genetic.stop.rounds = *generations;
  if (py::isinstance<py::str>(input) || py::hasattr(input, "__fspath__"))
    return tour_of_name(py::str(input).cast<std::string>(), options);
  return tour_of_points(input.cast<Numbers>(), options);
}

}  // namespace

void add_tours(py::module_& module) {
  py::class_<TourResult>(module, "Tour", "An order of points with what is proven of it.")
      .def_property_readonly("points", [](const TourResult& self) { return array_of(self.problem.points); })
      .def_property_readonly(
          "order",
          [](const TourResult& self) {
            return py::array_t<int>(static_cast<py::ssize_t>(self.solution.tour.size()),
                                    self.solution.tour.data());
          },
          doc("Solution::tour"))
      .def_property_readonly("objective", [](const TourResult& self) { return self.solution.objective; })
      .def_property_readonly(
          "length", [](const TourResult& self) { return self.solution.length; }, doc("Solution::length"))
      .def_property_readonly("turns", [](const TourResult& self) { return self.solution.turns; })
      .def_property_readonly("angle_deg", [](const TourResult& self) { return self.solution.angle_deg; })
      .def_property_readonly(
          "bound", [](const TourResult& self) { return self.solution.bound; }, doc("Solution::bound"))
      .def_property_readonly(
          "gap", [](const TourResult& self) { return self.solution.gap; }, doc("Solution::gap"))
      .def_property_readonly("seconds", [](const TourResult& self) { return self.solution.seconds; })
      .def("json", &tour_json, doc("tour_json"))
      .def("picture", &tour_svg, "The tour as SVG.")
      .def("__str__", &tour_line);
  module.def("tour", &tour, py::arg("points"), py::kw_only(), py::arg("objective") = "length",
             py::arg("closed") = py::none(), py::arg("time") = 10.0, py::arg("seed") = 1,
             py::arg("threads") = 0, py::arg("feed") = 1000.0, py::arg("diameter") = py::none(),
             py::arg("engagement") = 50.0, py::arg("solver") = "modern", py::arg("generations") = py::none(),
             doc("solve_tour"));
}

}  // namespace clearcut::python
