// How far a plan has come, in words and for programs.
#pragma once

#include <clearcut/error.h>

#include <cstddef>
#include <optional>
#include <string>

namespace clearcut::cli {

/// s, as fast as it went so far; none before the first is done.
std::optional<double> time_left(std::size_t done, std::size_t of, double spent_s);

/// For people; `spent_s`: s in this stage.
std::string described(const Progress& at, double spent_s);

/// A line of JSON that another program reads.
std::string json_of(const Progress& at, double spent_s);

/// A search that the clock ends at the latest.
struct SearchProgress {
  double best = 0;     ///< of the objective, so far
  double found_s = 0;  ///< since the beginning
  double most_s = 0;   ///< that it may take
};

/// The same of a search; `spent_s`: s since its beginning.
std::string described(const SearchProgress& at, double spent_s);
std::string json_of(const SearchProgress& at, double spent_s);

}  // namespace clearcut::cli
