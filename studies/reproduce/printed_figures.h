// Printed figures that more than one table needs: CPO-rho table 3, Grid table 1, Tour table 6.5.
#pragma once

#include <array>

#include "model/design_element.h"

namespace clearcut::studies {

/// CPO-rho table 3: minutes of the paper's method and of its two rivals with one cutter.
struct PrintedCutter {
  double radius;                     ///< mm
  double present, bisectors, loops;  ///< min
};

inline constexpr std::array<PrintedCutter, 11> kPrintedCutters{{{2, 19.51, 17.23, 15.46},
                                                                {3, 15.15, 14.97, 13.25},
                                                                {4, 8.49, 9.30, 8.21},
                                                                {5, 5.34, 6.17, 5.51},
                                                                {6, 4.16, 4.42, 4.69},
                                                                {7, 3.29, 3.83, 4.37},
                                                                {8, 2.70, 3.74, 4.61},
                                                                {9, 2.14, 3.49, 4.76},
                                                                {10, 2.03, 2.03, 2.03},
                                                                {13, 1.14, 1.14, 1.14},
                                                                {20.46, 0, 0, 0}}};

/// Grid table 1, with the radius and the rule that give its counts: the paper prints neither.
struct PrintedReduction {
  double side, radius;  ///< mm
  MiddleRow rule;
  int squares, reduced;
  const char* time_all;
  const char* time_reduced;
  double all_s, reduced_s;  ///< the same in seconds
};

inline constexpr std::array<PrintedReduction, 6> kPrintedReductions{
    {{10, 2, MiddleRow::kKeep, 121, 16, "> 3 h", "85 s", 10800, 85},
     {12, 2, MiddleRow::kKeep, 169, 25, "> 5 h", "160 s", 18000, 160},
     {20, 3, MiddleRow::kKeep, 441, 36, "> 10 h", "7.5 min", 36000, 450},
     {20, 4, MiddleRow::kKeep, 441, 16, "> 10 h", "85 s", 36000, 85},
     {30, 3, MiddleRow::kKeep, 961, 81, "> 1 day", "20 min", 86400, 1200},
     {30, 3, MiddleRow::kStrict, 961, 64, "> 1 day", "12 min", 86400, 720}}};

/// A row of Tour table 6.5: lengths in mm, turns, degrees.
struct PrintedJob {
  const char* name;
  int feed, rapid, total, turns;  ///< bidirectional
  int spiral_feed, spiral_rapid, spiral_total, angle;
};

/// The text's own program first.
inline constexpr std::array<PrintedJob, 4> kPrintedJobs{
    {{"GA", 25282, 2395, 27729, 423, 24103, 1838, 25941, 34686},
     {"NX", 24950, 2285, 27235, 415, 23830, 1680, 25510, 34090},
     {"FeatureCAM", 24395, 2325, 26720, 412, 23740, 1945, 25685, 34358},
     {"MasterCAM", 25030, 2525, 27555, 431, 24010, 1795, 25805, 35670}}};

}  // namespace clearcut::studies
