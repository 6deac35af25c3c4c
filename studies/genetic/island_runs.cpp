#include "studies/genetic/island_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/error.h"
#include "order/genetic/islands.h"
#include "studies/genetic/study_rows.h"
#include "studies/genetic/study_run.h"

namespace clearcut::studies {
namespace {

std::optional<order::GeneticState> state_of(const StudyLevel& level, const std::string& text) {
  return order::state_of_text(text, level.genetic.population, level.side * level.side);
}

int island_after(int island, int count) {
  return (island + 1) % count;
}

}  // namespace

IslandRuns::IslandRuns(const GeneticStudy& study, const GeneticStudyOptions& options, const std::string& csv,
                       StateStore& store)
    : study_(study), options_(options), store_(store) {
  for (const StudyRun& run : missing_study_runs(study, options, csv))
    progress_[{run.run, run.level}].resize(static_cast<std::size_t>(islands(run).islands));
  check_settings();
  for (const std::string& name : store.names())
    if (const auto piece = piece_of(name)) take_over(*piece);
  for (const auto& [key, done] : progress_) {
    const StudyRun run{key.second, key.first};
    if (!has_what_it_needs(run)) forget(run);
  }
}

/// Before anything is erased: all states have the settings of one of the levels.
void IslandRuns::check_settings() const {
  std::set<std::string> settings;
  for (const StudyLevel& level : study_.levels) settings.insert(settings_text(study_, level, options_.seed));
  for (const std::string& name : store_.names()) {
    if (!piece_of(name)) continue;
    const std::string text = store_.read(name).value_or("");
    const auto end = text.find('\n');
    if (end != std::string::npos && !settings.contains(text.substr(0, end)))
      throw InputError("states of islands",
                       "beside the rows come from another study or other settings; begin a new file");
  }
}

/// A state from before: its run goes on from the last of each island.
void IslandRuns::take_over(const Piece& piece) {
  const auto found = progress_.find({piece.run.run, piece.run.level});
  const bool is_known = found != progress_.end() &&
                        piece.epoch.island < static_cast<int>(found->second.size()) &&
                        piece.epoch.number <= last_epoch(piece.run);
  if (!is_known) return store_.erase(name_of(piece));
  long long& done = found->second[static_cast<std::size_t>(piece.epoch.island)];
  done = std::max(done, piece.epoch.number);
}

/// The last state of each island, and those that it will meet of the one before it: none where somebody took files away.
bool IslandRuns::has_what_it_needs(const StudyRun& run) const {
  const std::vector<long long>& done = progress_.at({run.run, run.level});
  for (int island = 0; island < static_cast<int>(done.size()); ++island) {
    const int before = order::island_before(island, islands(run));
    const long long epoch = done[static_cast<std::size_t>(island)];
    if (epoch > 0 && !state_text({run, {island, epoch}})) return false;
    const long long met = std::min(done[static_cast<std::size_t>(before)], last_epoch(run) - 1);
    for (long long number = std::max(1LL, epoch); number <= met; ++number)
      if (!state_text({run, {before, number}})) return false;
  }
  return true;
}

/// The run begins anew.
void IslandRuns::forget(const StudyRun& run) {
  for (const std::string& name : store_.names()) {
    const auto piece = piece_of(name);
    if (piece && piece->run.level == run.level && piece->run.run == run.run) store_.erase(name);
  }
  auto& done = progress_.at({run.run, run.level});
  std::fill(done.begin(), done.end(), 0);
}

std::string IslandRuns::name_of(const Piece& piece) {
  return fmt::format("{}.{}.{}.{}", piece.run.level, piece.run.run, piece.epoch.island, piece.epoch.number);
}

std::optional<IslandRuns::Piece> IslandRuns::piece_of(const std::string& name) {
  Piece piece;
  char dots[3]{};
  std::istringstream words(name);
  words >> piece.run.level >> dots[0] >> piece.run.run >> dots[1] >> piece.epoch.island >> dots[2] >>
      piece.epoch.number;
  if (!words || piece.epoch.island < 0 || name_of(piece) != name) return {};
  return piece;
}

const order::IslandOptions& IslandRuns::islands(const StudyRun& run) const {
  return level_of(study_, run).islands;
}

long long IslandRuns::last_epoch(const StudyRun& run) const {
  return order::epoch_count(islands(run), level_of(study_, run).genetic);
}

/// Whether the island whose best come has done as many epochs.
bool IslandRuns::is_ready(const StudyRun& run, int island) const {
  const std::vector<long long>& done = progress_.at({run.run, run.level});
  const int before = order::island_before(island, islands(run));
  return done[static_cast<std::size_t>(before)] >= done[static_cast<std::size_t>(island)];
}

std::optional<std::string> IslandRuns::state_text(const Piece& piece) const {
  const auto text = store_.read(name_of(piece));
  if (!text) return {};
  const StudyLevel& level = level_of(study_, piece.run);
  const auto end = text->find('\n');
  if (end == std::string::npos) return {};
  std::string state = text->substr(end + 1);
  return state_of(level, state) ? std::optional(std::move(state)) : std::nullopt;
}

std::vector<std::string> IslandRuns::tasks() const {
  std::vector<std::string> all;
  for (const auto& [key, done] : progress_) {
    const StudyRun run{key.second, key.first};
    for (int island = 0; island < static_cast<int>(done.size()); ++island) {
      const long long epoch = done[static_cast<std::size_t>(island)] + 1;
      if (epoch <= last_epoch(run) && is_ready(run, island)) all.push_back(name_of({run, {island, epoch}}));
    }
  }
  return all;
}

std::string IslandRuns::input(const std::string& task) const {
  const Piece piece = piece_of(task).value();
  const long long epoch = piece.epoch.number - 1;
  if (epoch == 0) return "";
  const int before = order::island_before(piece.epoch.island, islands(piece.run));
  const auto own_state = state_text({piece.run, {piece.epoch.island, epoch}});
  const auto state_before = state_text({piece.run, {before, epoch}});
  if (!own_state || !state_before)
    throw InputError("states of islands", "beside the rows are gone or damaged; give the command again");
  return *own_state + "\n" + *state_before;
}

std::vector<std::string> IslandRuns::finish(const std::string& task, const std::string& result) {
  const auto [run, epoch] = piece_of(task).value();
  store_.write(task, settings_text(study_, level_of(study_, run), options_.seed) + "\n" + result);
  std::vector<long long>& done = progress_.at({run.run, run.level});
  done[static_cast<std::size_t>(epoch.island)] = epoch.number;
  const int count = static_cast<int>(done.size());
  const long long last = last_epoch(run);
  if (std::all_of(done.begin(), done.end(), [last](long long number) { return number == last; })) {
    finish_run(run);
    return {};
  }
  const int before = order::island_before(epoch.island, islands(run));
  for (const int island : {epoch.island, before}) erase_if_done_with(run, {island, epoch.number - 1});
  std::vector<std::string> next;
  if (epoch.number == last) return next;
  if (is_ready(run, epoch.island)) next.push_back(name_of({run, {epoch.island, epoch.number + 1}}));
  // The island after this one may have waited for it.
  const int after = island_after(epoch.island, count);
  if (after != epoch.island && done[static_cast<std::size_t>(after)] == epoch.number)
    next.push_back(name_of({run, {after, epoch.number + 1}}));
  return next;
}

/// A state is needed until its island and the one after it have done the next epoch.
void IslandRuns::erase_if_done_with(const StudyRun& run, const order::Epoch& epoch) {
  const std::vector<long long>& done = progress_.at({run.run, run.level});
  const int after = island_after(epoch.island, static_cast<int>(done.size()));
  if (epoch.number > 0 && done[static_cast<std::size_t>(epoch.island)] > epoch.number &&
      done[static_cast<std::size_t>(after)] > epoch.number)
    store_.erase(name_of({run, epoch}));
}

void IslandRuns::finish_run(const StudyRun& run) {
  std::vector<order::GeneticState> states;
  for (int island = 0; island < islands(run).islands; ++island) {
    const auto text = state_text({run, {island, last_epoch(run)}});
    if (!text) throw InputError("states of islands", "beside the rows are gone; give the command again");
    states.push_back(state_of(level_of(study_, run), *text).value());
  }
  if (options_.finished) options_.finished(rows_of_islands(study_, run, std::move(states)));
  forget(run);
  progress_.erase({run.run, run.level});
}

std::string run_island_task(const GeneticStudy& study, const GeneticStudyOptions& options,
                            const std::string& task, const std::string& input,
                            const std::atomic<bool>& stop) {
  const auto piece = IslandRuns::piece_of(task);
  const auto refuse = [&] { throw InputError(task, "is no epoch of an island of this study"); };
  if (!piece || piece->run.level < 0 || piece->run.level >= static_cast<int>(study.levels.size())) refuse();
  const StudyLevel& level = level_of(study, piece->run);
  std::optional<order::GeneticState> own, before;
  if (piece->epoch.number > 1) {
    const auto middle = std::min(input.find('\n'), input.size());
    own = state_of(level, input.substr(0, middle));
    before = state_of(level, input.substr(std::min(middle + 1, input.size())));
    if (!own || !before) refuse();
  }
  return order::text_of_state(study_epoch(study, options.seed, piece->run, piece->epoch,
                                          own ? &*own : nullptr, before ? &*before : nullptr, stop));
}

}  // namespace clearcut::studies
