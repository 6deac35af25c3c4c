// The runs of a long table: what is told of each, and how those of an earlier, broken off table are taken up again.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace clearcut::studies {

/// Who makes a long table. What is left out is not told and not kept.
struct TableWatch {
  std::function<void(std::size_t done, std::size_t of)> count;  ///< runs
  std::function<void(const std::string& text)> say;     ///< what came out of a run, as soon as it is there
  std::function<void(const std::string& line)> append;  ///< a run to be kept, with its end of line
  std::string kept;                                     ///< such lines of an earlier time
};

/// What a run comes to.
using RunFigures = std::vector<double>;

class TableRuns {
 public:
  /// `watch` must outlive it.
  TableRuns(const TableWatch& watch, std::size_t all_runs);

  /// What was kept under this name, or else what `make` gives, to the last bit the same. `text` says it in words. From any
  /// thread.
  RunFigures run(const std::string& name, const std::function<RunFigures()>& make,
                 const std::function<std::string(const RunFigures&)>& text);
  /// What is printed, before the runs that stand beside it.
  void tell(const std::string& text);

 private:
  const TableWatch& watch_;
  std::size_t all_, done_ = 0;
  std::map<std::string, RunFigures> kept_;
  std::mutex mutex_;
};

}  // namespace clearcut::studies
