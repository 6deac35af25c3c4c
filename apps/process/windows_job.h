// Windows: handles, and job objects, whose processes end together.
#pragma once

#include <windows.h>

#include <cstdint>

namespace clearcut::process {

/// A handle, closed with this object.
class Handle {
 public:
  explicit Handle(HANDLE handle) : handle_(handle) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (is_open()) CloseHandle(handle_);
  }
  HANDLE get() const { return handle_; }
  bool is_open() const { return handle_ != nullptr && handle_ != INVALID_HANDLE_VALUE; }

 private:
  HANDLE handle_;
};

/// A new job object: its processes end when its handle is closed, also by the end of this process. `bytes`: memory limit
/// of each; 0: none.
HANDLE new_job(std::uint64_t bytes);

}  // namespace clearcut::process
