// The Python module: what include/clearcut promises, in Python's words.
#include <condition_variable>
#include <mutex>

#include "interruptible.h"

namespace clearcut::python {

std::shared_ptr<py::object> shared(py::object object) {
  return {new py::object(std::move(object)), [](py::object* held) {
            if (Py_IsInitialized() == 0) return;  // the interpreter has freed it
            const py::gil_scoped_acquire lock;
            delete held;
          }};
}

namespace {

struct Running {
  std::mutex mutex;
  std::condition_variable ended;
  int count = 0;
};

Running& running() {
  static auto* const all = new Running;  // never destroyed: threads may outlive everything else
  return *all;
}

}  // namespace

void Workers::begin() {
  const std::lock_guard lock(running().mutex);
  ++running().count;
}

void Workers::end() {
  const std::lock_guard lock(running().mutex);
  --running().count;
  running().ended.notify_all();
}

void Workers::wait() {
  std::unique_lock lock(running().mutex);
  running().ended.wait(lock, [] { return running().count == 0; });
}

void add_errors(py::module_& module) {
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError).doc() = doc("InputError");
  py::register_exception<Cancelled>(module, "Cancelled", PyExc_RuntimeError).doc() = doc("Cancelled");
  py::register_exception<InternalError>(module, "InternalError", PyExc_RuntimeError).doc() =
      doc("InternalError");
}

}  // namespace clearcut::python

PYBIND11_MODULE(_core, module) {
  using namespace clearcut::python;
  module.attr("__version__") = clearcut::kVersion;
  add_errors(module);
  py::module_::import("atexit").attr("register")(
      py::cpp_function(&Workers::wait, py::call_guard<py::gil_scoped_release>()));
  add_geometry(module);
  add_findings(module);
  add_moves(module);
  add_part(module);
  add_strategies(module);
  add_options(module);
  add_plan(module);
  add_tours(module);
  add_studies(module);
}
