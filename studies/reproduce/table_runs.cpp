#include "studies/reproduce/table_runs.h"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

namespace clearcut::studies {
namespace {

constexpr char kNameEnd = '\t';

/// Name, tab, figures with as many digits as bring them back bit by bit.
std::string line_of(const std::string& name, const RunFigures& figures) {
  std::string line = name + kNameEnd;
  for (const double figure : figures) line += fmt::format("{} ", figure);
  return line + "\n";
}

}  // namespace

TableRuns::TableRuns(const TableWatch& watch, std::size_t all_runs) : watch_(watch), all_(all_runs) {
  std::size_t begin = 0;
  // A last line without an end was broken off.
  for (std::size_t end; (end = watch.kept.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string line = watch.kept.substr(begin, end - begin);
    const auto tab = line.find(kNameEnd);
    if (tab == std::string::npos) continue;
    RunFigures figures;
    std::istringstream words(line.substr(tab + 1));
    for (std::string word; words >> word;) {
      double figure = 0;
      std::from_chars(word.data(), word.data() + word.size(), figure);
      figures.push_back(figure);
    }
    kept_[line.substr(0, tab)] = std::move(figures);
  }
  if (watch_.count) watch_.count(0, all_);
}

void TableRuns::tell(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (watch_.say) watch_.say(text);
}

RunFigures TableRuns::run(const std::string& name, const std::function<RunFigures()>& make,
                          const std::function<std::string(const RunFigures&)>& text) {
  const auto found = kept_.find(name);
  const bool is_kept = found != kept_.end();
  RunFigures figures = is_kept ? found->second : make();
  const std::lock_guard lock(mutex_);
  ++done_;
  if (!is_kept && watch_.append) watch_.append(line_of(name, figures));
  if (watch_.say) watch_.say(fmt::format("{}: {}{}", name, text(figures), is_kept ? " (kept)" : ""));
  if (watch_.count) watch_.count(done_, all_);
  return figures;
}

}  // namespace clearcut::studies
