// Figures of the texts, drawn anew from what the tables are made of.
#pragma once

#include <string>
#include <vector>

#include "model/layer.h"
#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// An outline with the ways of the cutter's centre, y up, in SVG.
Figure passes_figure(const std::string& caption, const Regions& outline, const std::vector<Pass>& passes);

/// A way through points, which are marked.
Figure tour_figure(const std::string& caption, const Regions& outline, const std::vector<Vec2>& points,
                   const std::vector<int>& tour);

/// A curve for every row of a table whose columns from `first` on are percent of the moves by engagement, ten classes of
/// 10 %; `name_column`: what a curve is called. Rows whose `model_column` is not `model` are left out, if that is not "".
struct HistogramRows {
  std::size_t first = 0, name_column = 0;
  std::size_t begin = 0, end = 0;  ///< rows
  std::size_t model_column = 0;
  std::string model = "";
};
Figure histograms_figure(const std::string& caption, const TextTable& table, const HistogramRows& rows);

}  // namespace clearcut::studies
