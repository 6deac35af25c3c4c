// How far long work has come: said by whoever works, heard by at most one listener of the process.
#pragma once

#include <functional>
#include <string>

namespace clearcut::inline base {

/// While it lives, report_progress goes to `hear`, from any thread, one call at a time.
class ProgressListener {
 public:
  explicit ProgressListener(std::function<void(const std::string&, double)> hear);
  ~ProgressListener();
  ProgressListener(const ProgressListener&) = delete;
  ProgressListener& operator=(const ProgressListener&) = delete;
};

/// What is being done, and which share of it (0 to 1) is done. Costs nothing to speak of where nobody listens.
void report_progress(const std::string& what, double share);

}  // namespace clearcut::inline base
