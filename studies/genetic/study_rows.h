// Rows of studies as CSV, and back.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "studies/genetic/genetic_study.h"

namespace clearcut::studies {

/// Rows by level and run.
using RowsOf = std::map<std::pair<int, int>, std::vector<StudyRow>>;

bool has_islands(const GeneticStudy& study);

std::vector<StudyRow> in_order(const RowsOf& rows_of);

/// All columns that decide what a run gives, but its number.
std::string settings_text(const GeneticStudy& study, const StudyLevel& level, std::uint64_t seed);

/// The complete runs of an earlier file; an unfinished one (a file cut short) is left out.
RowsOf rows_of_csv(const GeneticStudy& study, std::uint64_t seed, const std::string& csv);

}  // namespace clearcut::studies
