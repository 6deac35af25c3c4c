// Regions, offsets, clearance.
#include "bindings.h"

namespace clearcut::python {
namespace {

constexpr py::ssize_t kPlain = 2, kWithBulge = 3;
/// mm. A fifth of what verification calls a gouge, so that passes made of polygons keep off the walls.
constexpr double kPolygonChord = Tolerances{}.chord;

std::vector<BulgeVertex> vertices_of(const Numbers& array) {
  if (array.ndim() != 2 || (array.shape(1) != kPlain && array.shape(1) != kWithBulge) || array.shape(0) < 2)
    throw InputError("outline", "is an array of rows x, y or x, y, bulge with two rows at least");
  const auto at = array.unchecked<2>();
  std::vector<BulgeVertex> vertices;
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    const double bulge = array.shape(1) == kWithBulge ? at(i, 2) : 0;
    if (!std::isfinite(at(i, 0)) || !std::isfinite(at(i, 1)) || !std::isfinite(bulge))
      throw InputError("outline", "row " + std::to_string(i) + " is not finite");
    vertices.push_back({{at(i, 0), at(i, 1)}, bulge});
  }
  return vertices;
}

py::array_t<double> array_of_axis(const std::vector<AxisPoint>& points) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
  auto at = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    at(row, 0) = points[i].point.x;
    at(row, 1) = points[i].point.y;
    at(row, 2) = points[i].clearance;
  }
  return array;
}

py::tuple axis_of(const Clearance& clearance) {
  const MedialAxis& axis = clearance.axis();
  py::array_t<int> edges({static_cast<py::ssize_t>(axis.edges.size()), py::ssize_t{2}});
  auto at = edges.mutable_unchecked<2>();
  for (std::size_t i = 0; i < axis.edges.size(); ++i) {
    at(static_cast<py::ssize_t>(i), 0) = axis.edges[i].a;
    at(static_cast<py::ssize_t>(i), 1) = axis.edges[i].b;
  }
  return py::make_tuple(array_of_axis(axis.points), edges);
}

py::list polygon_of(const Region& region, double chord) {
  py::list rings;
  rings.append(array_of(flattened(region.outer(), chord)));
  for (const Loop& island : region.islands()) rings.append(array_of(flattened(island, chord)));
  return rings;
}

/// What shapely.geometry.shape() and other readers of GeoJSON-like mappings take: no farther than kPolygonChord from the curves.
py::dict geo_interface(const Region& region) {
  py::list rings;
  for (const py::handle ring : polygon_of(region, kPolygonChord)) {
    py::list points = ring.attr("tolist")();
    points.append(points[0]);
    rings.append(points);
  }
  py::dict out;
  out["type"] = "Polygon";
  out["coordinates"] = rings;
  return out;
}

std::vector<py::array_t<double>> islands_of(const Region& region) {
  std::vector<py::array_t<double>> islands;
  for (const Loop& island : region.islands()) islands.push_back(array_of(island));
  return islands;
}

void add_region(py::module_& module) {
  py::class_<Region>(module, "Region", doc("Region"))
      .def_property_readonly(
          "outer", [](const Region& region) { return array_of(region.outer()); },
          "The outer boundary: rows of x, y, bulge.")
      .def_property_readonly("islands", &islands_of, "The islands: arrays of rows of x, y, bulge.")
      .def_property_readonly("area", &Region::area, doc("Region::area"))
      .def_property_readonly(
          "box",
          [](const Region& region) {
            const Box box = region.box();
            return py::make_tuple(box.min.x, box.min.y, box.max.x, box.max.y);
          },
          "x and y of the lower left and the upper right, mm.")
      .def(
          "contains",
          [](const Region& region, double x, double y) {
            return region.contains({x, y});
          },
          py::arg("x"), py::arg("y"), doc("contains"))
      .def(
          "boundary_distance",
          [](const Region& region, double x, double y) {
            return region.boundary_distance({x, y});
          },
          py::arg("x"), py::arg("y"), doc("Region::boundary_distance"))
      .def("polygon", &polygon_of, py::arg("chord") = kPolygonChord,
           "The loops as polygons, the outer one first, none farther than chord mm from the curves. Passes "
           "of a wider chord "
           "cut into corners: what verification calls a gouge begins at 0.001 mm.")
      .def_property_readonly_static(
          "polygon_chord", [](const py::object&) { return kPolygonChord; },
          "mm; how near polygon() and shapely.geometry.shape() keep to the curves where nothing else is "
          "said.")
      .def_property_readonly("__geo_interface__", &geo_interface)
      .def("__repr__", [](const Region& region) {
        return "<clearcut.Region of " + trimmed(region.area(), 3) + " mm2 with " +
               std::to_string(region.islands().size()) + " islands>";
      });
}

void add_clearance(py::module_& module) {
  const auto unlocked = py::call_guard<py::gil_scoped_release>();
  py::class_<Clearance>(module, "Clearance", doc("Clearance"))
      .def(py::init([](const Region& region) { return Clearance(region, {}); }), py::arg("region"), unlocked)
      .def("inset", &Clearance::inset, py::arg("d"), unlocked, doc("Clearance::inset"))
      .def("insets", &Clearance::insets, py::arg("ascending"), unlocked, doc("Clearance::insets"))
      .def_property_readonly("max", &Clearance::max, doc("Clearance::max"))
      .def_property_readonly(
          "centers", [](const Clearance& clearance) { return array_of_axis(clearance.centers()); },
          doc("Clearance::centers"))
      .def("axis", &axis_of, doc("MedialAxis"))
      .def(
          "axis_curve",
          [](const Clearance& clearance, int edge, double chord) {
            if (edge < 0 || edge >= static_cast<int>(clearance.axis().edges.size()))
              throw py::index_error("the medial axis has no edge " + std::to_string(edge));
            return array_of_axis(clearance.axis_curve(edge, chord));
          },
          py::arg("edge"), py::arg("chord") = 0.01, doc("Clearance::axis_curve"))
      .def(
          "fit_lines",
          [](const Clearance& clearance, double d) {
            std::vector<py::array_t<double>> lines;
            for (const Path& line : clearance.fit_lines(d)) lines.push_back(array_of_path(line));
            return lines;
          },
          py::arg("d"), doc("Clearance::fit_lines"));
}

}  // namespace

py::array_t<double> array_of(const std::vector<Vec2>& points) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), kPlain});
  auto at = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    at(static_cast<py::ssize_t>(i), 0) = points[i].x;
    at(static_cast<py::ssize_t>(i), 1) = points[i].y;
  }
  return array;
}

py::array_t<double> array_of(const Loop& loop) {
  const auto vertices = to_bulges(loop);
  py::array_t<double> array({static_cast<py::ssize_t>(vertices.size()), kWithBulge});
  auto at = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    at(row, 0) = vertices[i].point.x;
    at(row, 1) = vertices[i].point.y;
    at(row, 2) = vertices[i].bulge;
  }
  return array;
}

py::array_t<double> array_of_path(const Path& path) {
  const auto rows = static_cast<py::ssize_t>(path.size() + (path.empty() ? 0 : 1));
  py::array_t<double> array({rows, kWithBulge});
  auto at = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < rows; ++i) {
    const bool last = i + 1 == rows;
    const Edge& edge = path[static_cast<std::size_t>(last ? i - 1 : i)];
    at(i, 0) = last ? edge.to.x : edge.from.x;
    at(i, 1) = last ? edge.to.y : edge.from.y;
    at(i, 2) = last ? 0 : edge.bulge();
  }
  return array;
}

Loop loop_of(const Numbers& array) {
  const auto vertices = vertices_of(array);
  return loop_from_bulges(vertices);
}

Path path_of(const Numbers& array) {
  const auto vertices = vertices_of(array);
  Path path;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
    path.push_back(Edge::from_bulge(vertices[i].point, vertices[i + 1].point, vertices[i].bulge));
  return path;
}

void add_geometry(py::module_& module) {
  add_region(module);
  add_clearance(module);
  const auto unlocked = py::call_guard<py::gil_scoped_release>();
  const auto a = py::arg("a"), b = py::arg("b");
  module.def(
      "unite", [](const Regions& p, const Regions& q) { return unite(p, q, {}); }, a, b, unlocked,
      doc("unite"));
  module.def(
      "subtract", [](const Regions& p, const Regions& q) { return subtract(p, q, {}); }, a, b, unlocked,
      "What is in a and not in b; otherwise as unite().");
  module.def(
      "intersect", [](const Regions& p, const Regions& q) { return intersect(p, q, {}); }, a, b, unlocked,
      "What is in both; otherwise as unite().");
  module.def(
      "inset", [](const Region& region, double d) { return inset(region, d, {}); }, py::arg("region"),
      py::arg("d"), unlocked, doc("inset"));
  module.def(
      "dilate", [](const Regions& regions, double d) { return dilate(regions, d, {}); }, py::arg("regions"),
      py::arg("d"), unlocked, doc("dilate"));
  module.def(
      "resolve_even_odd",
      [](const std::vector<Numbers>& outlines) {
        std::vector<Loop> loops;
        for (const Numbers& outline : outlines) loops.push_back(loop_of(outline));
        const py::gil_scoped_release released;
        return resolve_even_odd(loops, {});
      },
      py::arg("loops"), doc("resolve_even_odd"));
}

}  // namespace clearcut::python
