// Progress of a plan, in words and for programs.
#pragma once

#include <clearcut/error.h>

#include <cstddef>
#include <optional>
#include <string>

namespace clearcut::cli {

/// s, at the speed so far; none before the first is done.
std::optional<double> time_left(std::size_t done, std::size_t of, double spent_s);

/// For people; `spent_s`: s in this stage.
std::string described(const Progress& at, double spent_s);

/// A line of JSON for other programs.
std::string json_of(const Progress& at, double spent_s);

/// A search ended by the clock at the latest.
struct SearchProgress {
  double best = 0;     ///< best value of the objective so far
  double found_s = 0;  ///< since the beginning
  double most_s = 0;   ///< greatest permitted time
};

/// The same of a search; `spent_s`: s since its beginning.
std::string described(const SearchProgress& at, double spent_s);
std::string json_of(const SearchProgress& at, double spent_s);

/// Things of unlike length, one after the other.
struct CountProgress {
  std::size_t before = 0;  ///< number done at the beginning
  std::size_t done = 0, of = 0;
  std::string things;
};

/// s, by the state at the end of the last one, `since_s` ago, after `spent_s`: it decreases until the next one ends.
/// None before a sixth is done, since the estimate is too uncertain, and if the current one takes longer than the
/// estimate for all.
std::optional<double> time_left(const CountProgress& at, double spent_s, double since_s);

std::string described(const CountProgress& at, std::optional<double> left_s);
std::string json_of(const CountProgress& at, std::optional<double> left_s);

}  // namespace clearcut::cli
