// A line on standard error about work that takes more than a second.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "base/progress.h"

namespace clearcut::cli {

/// While it lives: after a second (three where no terminal shows it), what is being done, how far it is, and how long it may still take, on one line that is renewed on
/// a terminal, every five seconds on a line of its own elsewhere. Says `hint` once, when it begins to say anything.
class ProgressLine {
 public:
  explicit ProgressLine(std::string hint);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void watch();
  void show(double elapsed_s);
  void hear(const std::string& what, double share);

  std::string hint_;
  bool terminal_;
  std::mutex mutex_;
  std::condition_variable stop_;
  bool stopped_ = false;
  bool shown_ = false;
  std::string what_;
  double share_ = 0;
  double began_s_ = 0;  ///< when this work began, since the line was made
  ProgressListener listener_;
  std::thread watcher_;
};

}  // namespace clearcut::cli
