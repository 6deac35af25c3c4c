// A line on standard error about work that takes more than a second.
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

/// The hint of commands that write their files at the end.
inline constexpr const char* kCancel = "Ctrl-C stops; nothing is written before the end.";
/// And of those that print, or write as they go.
inline constexpr const char* kStops = "Ctrl-C stops.";

/// Whether a terminal shows standard error: commands that print each result as it comes say no more elsewhere.
bool is_watched();

/// While it lives: after a second (three where no terminal shows it), what is being done, how far it is, and how long it may still take, on one line that is renewed on
/// a terminal, every three seconds on a line of its own elsewhere; with CLEARCUT_PROGRESS=json as JSON, a line every fifth of a second. Says `hint` once, when it begins to say anything,
/// and `advice` once, when the work has taken ten seconds.
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
  /// Of a search: the best that it found so far.
  void search(const SearchProgress& at);
  /// Of several plans or tables: so many `things` are done.
  /// What was done at the first call took no time.
  void count(std::size_t done, std::size_t of, const std::string& things);
  /// Removes the line from the terminal, so that what is printed next stands alone; it comes again.
  void clear();
  /// A line of its own, at once, that stays.
  void say(const std::string& line);
  /// Of work that counts nothing: what it is, and how long it took where it was measured, 0 where it was not.
  void expect(const std::string& work, double usual_s = 0);

 private:
  void watch();
  void show(double elapsed_s);
  /// Says the hint, once.
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
