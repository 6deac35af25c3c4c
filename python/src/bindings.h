// What the files of the Python module share.
#pragma once

#include <clearcut/clearcut.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <vector>

#include "docstrings.h"

namespace clearcut::python {

namespace py = pybind11;

/// A part with the files it was read from, which its certificates name.
struct GivenPart {
  Part part;
  std::vector<CertificateFile> inputs;
};

/// Options with the files they were read from: machine file, earlier program.
struct AskedOptions : PlanOptions {
  std::vector<CertificateFile> files;
};

/// A part with everything that its job asks of a plan.
struct Job {
  GivenPart part;
  AskedOptions options;
};

/// A file as certificates name it. Throws InputError where it cannot be read.
CertificateFile certificate_file(const std::string& role, const std::string& file);
/// Those of a part and of options, in the order of the command's certificates; files of options go before others of their role.
std::vector<CertificateFile> joined(const std::vector<CertificateFile>& part,
                                    const std::vector<CertificateFile>& options);

/// A strategy written in Python; see strategy.cpp.
struct OwnStrategy {
  std::string name;
  std::string description;
  std::shared_ptr<py::object>
      function;  ///< freed with the interpreter's lock held, whoever lets go of it last
  bool in_auto = false;
};

/// The software's strategies, then these. Null where there are none.
std::shared_ptr<const StrategyTable> table_with(const std::vector<OwnStrategy>& own);

/// An object that threads without the interpreter's lock may copy and let go of.
std::shared_ptr<py::object> shared(py::object object);

/// A loop as an array of x, y, bulge (N x 3).
py::array_t<double> array_of(const Loop& loop);
/// Points as an array (N x 2).
py::array_t<double> array_of(const std::vector<Vec2>& points);
/// The edges of a path as an array of x, y, bulge of each start, and the last end with bulge 0.
py::array_t<double> array_of_path(const Path& path);
/// A closed loop, or an open path, of x, y (N x 2) or x, y, bulge (N x 3). Throws InputError for other arrays.
Loop loop_of(const py::array_t<double, py::array::c_style | py::array::forcecast>& vertices);
Path path_of(const py::array_t<double, py::array::c_style | py::array::forcecast>& vertices);

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

void add_errors(py::module_& module);
void add_geometry(py::module_& module);
void add_part(py::module_& module);
void add_options(py::module_& module);
void add_strategies(py::module_& module);
void add_findings(py::module_& module);
void add_moves(py::module_& module);
void add_plan(py::module_& module);
void add_tours(py::module_& module);
void add_studies(py::module_& module);

}  // namespace clearcut::python
