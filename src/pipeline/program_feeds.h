// Feeds that follow the load for a program that somebody else wrote: its F words change, and nothing else of its text.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "pipeline/check.h"

namespace clearcut::pipeline {

/// What a program is checked against: a part, or a stock alone.
struct ProgramQuestion {
  const Part* part = nullptr;  ///< null: there is none
  std::optional<Stock> stock;  ///< without a part; absent: the box of what is cut
  std::optional<double> top;   ///< mm, likewise
  std::optional<read::gcode::Dialect> dialect;
};

struct ProgramFeeds {
  std::string program;                        ///< with other F words
  CheckResult before;                         ///< of the program as it was
  CheckResult after;                          ///< of `program`, read back
  int words_before = 0, words_after = 0;      ///< F words
  std::map<int, MmPerMin> reference_feeds{};  ///< meant at the reference, by tool
};

/// The feeds of level moves that are made at the tool's usual feed, which is the one at which it cuts most of its way, go up to what the
/// rule of `options.shop.feed_by` allows over the whole of their block, at most to the cap; every feed above that goes down. Where
/// no reference feed is stated the usual feed of each tool is meant at the reference.
///
/// Throws InputError where no rule is asked for, for Klartext, for a program that the reader refuses, and where the new text does not
/// move just as before.
ProgramFeeds feeds_of_program(const ProgramQuestion& question, const std::string& program,
                              const std::string& program_name, const resolve::PlanOptions& options);

}  // namespace clearcut::pipeline
