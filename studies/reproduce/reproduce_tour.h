// The published figures of the text's genetic algorithm beside ours.
#pragma once

#include "studies/reproduce/reproduction.h"
#include "studies/reproduce/table_runs.h"

namespace clearcut::studies {

/// Tour table 6.2 but for its largest instance: the algorithm run as published (order/genetic) and, below, the same with edge
/// assembly crossover, on all cores. The reference instances are read from the folder tsp/ in $CLEARCUT_DATA; rows whose file
/// is not there say so.
Reproduction genetic_instances(const TableWatch& watch);

/// Tour tables 6.3 and 6.6: the same on lattices, from first paths drawn at random among all near points.
Reproduction genetic_lattices(const TableWatch& watch);

/// Tour table 6.2, its largest instance: the published algorithm and ours, 200 s each.
Reproduction large_instance(const TableWatch& watch);

}  // namespace clearcut::studies
