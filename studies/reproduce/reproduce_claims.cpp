#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "studies/reproduce/printed_figures.h"
#include "studies/reproduce/reproduce_parts.h"

namespace clearcut::studies {
namespace {

/// A figure in the words of a text, and what the text's own tables make of it.
struct Claim {
  const char* where;
  const char* words;
  double stated;
  int decimals;
  double from_tables;
  const char* reason = "";  ///< why they differ
};

/// Percent by which a figure is above another one.
double percent_above(double figure, double least) {
  return 100 * (figure / least - 1);
}

/// Percent of a figure that another one lacks.
double percent_of(double part, double whole) {
  return 100 * (1 - part / whole);
}

template <typename Rows, typename Value>
double least(const Rows& rows, const Value& value) {
  double found = value(rows.front());
  for (const auto& row : rows) found = std::min(found, static_cast<double>(value(row)));
  return found;
}

/// Rows of which this is true.
template <typename Rows, typename Test>
double count(const Rows& rows, const Test& test) {
  return static_cast<double>(std::count_if(rows.begin(), rows.end(), test));
}

bool is_compared(const PrintedCutter& row) {
  return row.present != row.bisectors || row.present != row.loops;
}

double cells_taken_away(const PrintedReduction& row) {
  return percent_of(row.reduced, row.squares);
}

double factorial(int n) {
  return n < 2 ? 1 : n * factorial(n - 1);
}

/// Of table 6.5: how far the text's own row is above the best of the three CAM programs.
template <typename Figure>
double percent_above_the_best(const Figure& figure) {
  const std::array<PrintedJob, 3> others{kPrintedJobs[1], kPrintedJobs[2], kPrintedJobs[3]};
  return percent_above(figure(kPrintedJobs[0]), least(others, figure));
}

/// Of the three CAM programs of table 6.5, those with longer rapids than the text's own.
template <typename Figure>
double with_longer_rapids(const Figure& figure) {
  return count(kPrintedJobs, [&](const PrintedJob& job) { return figure(job) > figure(kPrintedJobs[0]); });
}

std::vector<Claim> claims() {
  const PrintedJob& own = kPrintedJobs[0];
  return {
      {"CPO-rho 4", "cutters of the comparison", 8, 0, count(kPrintedCutters, is_compared)},
      {"CPO-rho 4", "with so many rho is faster than bisectors", 6, 0,
       count(kPrintedCutters, [](const auto& row) { return row.present < row.bisectors; })},
      {"CPO-rho 4", "and than loops", 5, 0,
       count(kPrintedCutters, [](const auto& row) { return row.present < row.loops; })},
      {"Grid IV", "squares taken away, %, from", 85, 0, least(kPrintedReductions, cells_taken_away)},
      {"Grid IV", "to", 90, 0,
       -least(kPrintedReductions, [](const auto& row) { return -cells_taken_away(row); }),
       "squares 20 mm wide lose 425 of 441 in its table 1"},
      {"Grid IV", "time taken away, %, in all experiments", 98, 0,
       cut_to(least(kPrintedReductions, [](const auto& row) { return percent_of(row.reduced_s, row.all_s); }),
              0)},
      {"Tour 3.6", "orders of 15 points, 10^12 (eq. 3.1)", 1.3, 1, factorial(15) / 1e12},
      {"Tour 5.3.2", "points of FI10639", 10630, 0, 10639, "the instance has the points that are its name"},
      {"Tour 6.3.1", "QA194 within %", 4, 0, percent_of(9352, 9737)},
      {"Tour 6.3.1", "XIT1083 within %", 5, 0, percent_of(3558, 3740)},
      {"Tour 6.3.1", "FI10639 within %", 4, 0, percent_of(520527, 540427)},
      {"Tour 6.3.2", "bidirectional within %", 2, 0, percent_of(18, 18.33)},
      {"Tour 6.3.2", "spiral within %", 1, 0, percent_of(1620, 1636.8)},
      {"Tour 6.4.3, 7.5, 8.2", "bidirectional length within %", 3.6, 1,
       percent_above_the_best([](const PrintedJob& job) { return job.feed; })},
      {"Tour 6.4.3", "turns within %", 2.6, 1, cut_to(percent_above(own.turns, kPrintedJobs[2].turns), 1)},
      {"Tour 6.4.3", "spiral length within %", 3.1, 1,
       percent_above_the_best([](const PrintedJob& job) { return job.spiral_feed; }),
       "table 6.5 is twice as good as the words about it"},
      {"Tour 6.4.3", "turn angle within %", 1.8, 1,
       percent_above_the_best([](const PrintedJob& job) { return job.angle; }),
       "34 686 degrees are 1.748 % above 34 090"},
      {"Tour 7.5", "CAM programs with longer rapids, bidirectional", 3, 0,
       with_longer_rapids([](const PrintedJob& job) { return job.rapid; }),
       "rapids are said to be much shorter than those of the CAM programs; in table 6.5 two of three have "
       "shorter ones"},
      {"Tour 7.5", "CAM programs with longer rapids, spiral", 3, 0,
       with_longer_rapids([](const PrintedJob& job) { return job.spiral_rapid; }),
       "rapids are said to be much shorter than those of the CAM programs; in table 6.5 two of three have "
       "shorter ones"}};
}

}  // namespace

Reproduction claims_table() {
  Reproduction result;
  result.table.title = "What the texts say of their own tables";
  result.table.columns = {{"text", Align::kLeft}, {"words", Align::kLeft}, {"stated"}, {"by its tables"}};
  for (const Claim& claim : claims())
    result.add({claim.where, claim.words, fmt::format("{:.{}f}", claim.stated, claim.decimals),
                of_print(claim.from_tables, claim.stated, claim.decimals, {claim.reason, 0})});
  result.table.notes.push_back(
      "nothing of ours is in it: where a cell differs the words of a text contradict its own printed "
      "figures");
  return result;
}

}  // namespace clearcut::studies
