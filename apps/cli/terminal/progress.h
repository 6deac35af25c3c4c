// A line on standard error about work longer than a second.
#pragma once

#include <clearcut/error.h>

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "terminal/progress_text.h"

namespace clearcut::cli {

/// Hint for commands that write their files at the end.
inline constexpr const char* kCancel = "Ctrl-C stops; nothing is written before the end.";
/// Hint for commands that print, or write continuously.
inline constexpr const char* kStops = "Ctrl-C stops.";

/// Whether a terminal shows standard error: otherwise commands that print each result at once print no more.
bool is_watched();

/// During its lifetime shows, after a second (three without a terminal), the work, its progress, and the estimated
/// remaining time: on one renewed line of a terminal, else on a separate line every three seconds; with
/// CLEARCUT_PROGRESS=json as JSON, a line every fifth of a second. Prints `hint` once at the first output, and
/// `advice` once after ten seconds.
class ProgressLine {
 public:
  explicit ProgressLine(std::string hint, std::string advice = "");
  ~ProgressLine();
  /// Before anything else is printed; the line is cleared.
  void end();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// For the options of a plan; not to be called after this object's end.
  ProgressCallback callback();
  /// For a search: the best result so far.
  void search(const SearchProgress& at);
  /// For several plans or tables: the number of `things` done. Things done before the first call took no time.
  void count(std::size_t done, std::size_t of, const std::string& things);
  /// Prints a row of results on standard output in place of the line, which appears again below it.
  void row(const std::string& text);
  /// Prints a separate, permanent line at once.
  void say(const std::string& line);
  /// For work without counts: its name, and its measured usual time, 0 if unknown.
  void expect(const std::string& work, double usual_s = 0);

 private:
  void watch();
  void show(double elapsed_s);
  /// Prints the hint, once.
  void begin();
  void hear(const Progress& at);

  std::string hint_, advice_;
  bool json_;
  bool terminal_;
  std::mutex mutex_;
  std::condition_variable stop_;
  bool stopped_ = false;
  bool shown_ = false;
  std::string text() const;
  std::optional<Progress> at_;
  std::optional<SearchProgress> search_;
  std::optional<CountProgress> count_;
  double counted_s_ = 0;  ///< when the last one ended
  struct Work {
    std::string name;
    double usual_s;
  };
  std::optional<Work> work_;
  double began_s_;  ///< when this stage began
  std::thread watcher_;
};

}  // namespace clearcut::cli
