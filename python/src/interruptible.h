// Work that Ctrl-C and other threads can end.
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <stop_token>
#include <thread>

#include "bindings.h"

namespace clearcut::python {

/// How often it is looked whether somebody asks to stop.
inline constexpr auto kPollInterval = std::chrono::milliseconds(20);

/// Throws the exception of a signal that has come, and Cancelled where `cancel`, an object with is_set() or None, says so.
inline void throw_if_asked_to_stop(const py::object& cancel) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!cancel.is_none() && cancel.attr("is_set")().cast<bool>()) throw Cancelled();
}

/// Counts threads that work. The interpreter waits for them before it ends: those whose caller did not wait end soon after it.
class Workers {
 public:
  static void begin();
  static void end();
  static void wait();
};

/// Runs `work(stop_token)` on another thread without the interpreter's lock, while this one looks for signals and `cancel`. Who
/// asks to stop does not wait for the next place where the work looks: it ends by itself, so it must own all that it uses.
template <class Work>
auto interruptible(const py::object& cancel, Work work) {
  using Result = std::invoke_result_t<Work&, std::stop_token>;
  auto task = std::make_unique<std::packaged_task<Result(std::stop_token)>>(std::move(work));
  std::future<Result> result = task->get_future();
  std::stop_source stop;
  Workers::begin();
  std::thread([task = std::move(task), token = stop.get_token()]() mutable {
    (*task)(token);
    task.reset();
    Workers::end();
  }).detach();
  const auto is_ready = [&result] {
    const py::gil_scoped_release unlocked;
    return result.wait_for(kPollInterval) == std::future_status::ready;
  };
  try {
    while (!is_ready()) throw_if_asked_to_stop(cancel);
  } catch (...) {
    stop.request_stop();
    throw;
  }
  return result.get();
}

}  // namespace clearcut::python
