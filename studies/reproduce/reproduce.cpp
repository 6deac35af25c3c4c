#include "studies/reproduce/reproduce.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "studies/reproduce/published_comparisons.h"
#include "studies/reproduce/reproduce_parts.h"

namespace clearcut::studies {

const std::vector<ReproducibleTable>& reproducible_tables() {
  static const std::vector<ReproducibleTable> all{
      {"coefficients", "CPO-rho table 2", 0.1, false, coefficient_table},
      {"overlaps", "CPO-rho table 1", 0.1, false, overlap_table},
      {"captions", "CPO-kappa figure 9, CPO-rho figures 10 and 11", 0.1, false, caption_figures},
      {"triangle", "CPO-kappa figure 10", 0.1, false, triangle_figure},
      {"operators", "Tour section 3.6.2 and table 3.1", 0.1, false, operators_table},
      {"claims", "all four texts, in their words", 0.1, false, claims_table},
      {"lengths", "CPO-kappa table 1", 0.3, false, length_comparison},
      {"lattices", "Tour tables 6.3 and 6.6", 0.3, false, lattice_table},
      {"points", "Tour section 5.3.2", 0.5, false, grid_points_table},
      {"cutter-trend", "CPO-rho table 3, which is faster", 0.5, false, cutter_trend},
      {"cutters", "CPO-rho table 3", 0.6, false, cutter_comparison},
      {"scallop", "Tour table 6.1", 1.5, false, scallop_table},
      {"grid", "Grid table 1", 2, false, grid_table},
      {"single-multi", "Tour figures 6-16 and 6-17", 5, false, single_multi_table},
      {"tour-engagement", "Tour figure 6-15", 9, false, engagement_table},
      {"fishhead", "Tour table 6.5", 15, false, fishhead_table},
      {"objectives", "Tour table 6.4", 360, false, objectives_table},
      {"fishhead-published", "Tour table 6.5 by programs", 120, true, published_fishhead_table},
      {"fi10639", "Tour table 6.2, its largest instance", 400, true, large_instance},
      {"genetic", "Tour table 6.2 by the published algorithm", 400, true, genetic_instances},
      {"genetic-lattices", "Tour tables 6.3 and 6.6 by the published algorithm", 1000, true,
       genetic_lattices}};
  return all;
}

const ReproducibleTable& reproducible_table(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& table : reproducible_tables()) {
    if (table.name == name) return table;
    names.push_back(table.name);
  }
  throw InputError("reproduce", fmt::format("'{}' is unknown; use one of {}", name, fmt::join(names, ", ")));
}

}  // namespace clearcut::studies
