// The tables and figures of CPO-kappa and CPO-rho whose outlines are printed, or that need none.
#pragma once

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// CPO-rho table 2: recovery coefficients, seven rows by nine angles.
Reproduction coefficient_table();
/// CPO-rho table 1: overlaps in the corner, six radii by nine angles.
Reproduction overlap_table();
/// CPO-kappa figure 10: the triangle's contours and the length of its path.
Reproduction triangle_figure();
/// Coefficients printed in captions: CPO-kappa figure 9, CPO-rho figures 10 and 11.
Reproduction caption_figures();

}  // namespace clearcut::studies
