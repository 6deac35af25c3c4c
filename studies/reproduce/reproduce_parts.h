// The tables and figures of CPO-kappa and CPO-rho whose outlines are printed, or that need none. The table of the
// grid paper. The Tour text's table 6.4 and figure 6-15: one objective at a time, several at once, and engagement.
// The worked example of the genetic operators in the Tour text. The tables and figures of the Tour text that need
// nothing but an order of points. Claims in words beside the texts' own tables. The published system on its own part, from the file to the checked program, beside
// ours. The table of the Tour text about drafted walls. The published figures of the text's genetic algorithm beside
// ours.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "options/plan_options.h"
#include "studies/reproduce/reproduction.h"
#include "studies/reproduce/table_runs.h"

namespace clearcut::studies {

/// CPO-rho table 2: recovery coefficients, seven rows by nine angles.
Reproduction coefficient_table();
/// CPO-rho table 1: overlaps in the corner, six radii by nine angles.
Reproduction overlap_table();
/// CPO-kappa figure 10: the triangle's contours and the length of its path.
Reproduction triangle_figure();
/// Coefficients printed in captions: CPO-kappa figure 9, CPO-rho figures 10 and 11.
Reproduction caption_figures();

/// Grid table 1: squares after interpolation and after reduction, and the time to an optimal order of each.
Reproduction grid_table();

/// Table 1 of the grid paper: squares before and after reduction, and the time to an order of visits with
/// what is proven of it, beside the printed times of its genetic algorithm.
TextTable grid_reduction_table();

/// Table 6.4: every feature of the fishhead and plates with islands, one objective at a time, with its bound and
/// gap, and length, turns and engagement at once.
Reproduction objectives_table(const TableWatch& watch);
/// Figure 6-15: how engagement is spread for targets from 20 to 100 %, by the raster and by the exact model.
Reproduction engagement_table();

/// Tour figures 6-16 and 6-17: engagement along the path where it alone is asked for, and beside length and turns.
Reproduction single_multi_table();

/// Tour 3.6.2: two offspring of the partially mapped crossover, the genetic edges of table 3.1, by the operators that run.
Reproduction operators_table();

/// Figures in the words of the texts beside what their own tables make of them.
Reproduction claims_table();

/// Tables 6.3 and 6.6: lattices, turns, turn angle, fitness.
Reproduction lattice_table();
/// Table 6.5: feed length, turns and turn angle of the whole fishhead, by several readings of the printed job.
Reproduction fishhead_table();
/// Section 5.3.2: how many points the largest feature has, which pins the grid of table 6.5.
Reproduction grid_points_table();

inline constexpr std::size_t kFishheadSeeds = 3;

/// The job of table 6.5: a grid of half the cutter's diameter in layers of 2 mm.
PlanOptions options_of_the_published_job();

/// Mean, and half the width of its 95 % interval by Student's t.
std::pair<double, double> mean_of_seeds(const std::array<double, kFishheadSeeds>& values);

/// Every workingstep of the fishhead on the published grid, ordered by the published algorithm (three seeds: mean and its
/// 95 % interval) and by ours; the sums beside table 6.5. All figures are those of the program that was written and read back.
Reproduction published_fishhead_table(const TableWatch& watch);

/// Table 6.1: the scallop height asked for on the walls of the sloped fishhead's third pocket and that of the program, as its
/// certificate measures it; planned by the text's strategy.
Reproduction scallop_table();

/// Tour table 6.2 but for its largest instance: the algorithm run as published (order/genetic) and, below, the same with edge
/// assembly crossover, on all cores. The reference instances are read from the folder tsp/ in $CLEARCUT_DATA; rows whose file
/// is not there say so.
Reproduction genetic_instances(const TableWatch& watch);

/// Tour tables 6.3 and 6.6: the same on lattices, from first paths drawn at random among all near points.
Reproduction genetic_lattices(const TableWatch& watch);

/// Tour table 6.2, its largest instance: the published algorithm and ours, 200 s each.
Reproduction large_instance(const TableWatch& watch);

}  // namespace clearcut::studies
