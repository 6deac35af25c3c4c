// Tool paths in a plan view: centre lines by kind of move, direction arrows, and the strip the cutter sweeps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/part.h"
#include "report/picture/plan_picture.h"

namespace clearcut::report {

/// Style of the lines of one section.
struct LineStyle {
  std::string cut_color;
  double cut_width = 1.3;  ///< page units, as the others
  bool links = true;
  bool arrows = true;
  bool rapids = true;
  bool entries = true;
};

/// Inside a world group: rapids dashed, links, entries and cuts as lines; plunges and retracts as dots.
void draw_lines(SvgWriter& svg, const PlanView& view, const std::vector<Move>& moves, const LineStyle& style);

/// Cuts in the shade of their depth below `top`, for pictures of all layers.
void draw_lines_by_depth(SvgWriter& svg, const PlanView& view, const std::vector<Move>& moves, double top,
                         double bottom);

/// The curves whose strips of the cutter's width are at `z` or below, one path for each diameter.
struct Sweep {
  double diameter = 0;
  std::string data;
};
/// Sweeps of all sections, or of those of one feature, with the width of their cutters at `height`, or else at z.
std::vector<Sweep> sweeps_at(const Job& job, double z, const Box& seen, std::optional<int> feature = {},
                             std::optional<double> height = {});
/// The same for earlier cuts, for a feature beginning at `top`.
std::vector<Sweep> earlier_sweeps_at(const Job& job, double z, const Box& seen, double top);

/// Inside a world group: the strips in one flat colour.
void draw_sweeps(SvgWriter& svg, const std::vector<Sweep>& sweeps, const std::string& color);

}  // namespace clearcut::report
