// A picture of the job for visual checks, and the words around its plan views: header with verdict and figures, list
// of features, legend, faults.
#pragma once

#include <string>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/margin.h"
#include "report/picture/plan_picture.h"

namespace clearcut::report {

// Page units; the page grows downwards as far as the panels ask for.
inline constexpr double kPageWidth = 1600;
inline constexpr double kPageMargin = 40;
inline constexpr double kHeaderHeight = 178;

/// Attributes of a text.
SvgWriter::Attributes text_style(double size, const char* color, const char* weight = "normal",
                                 const char* anchor = "start");

/// Title, stock and tools, verdict, and the figures of the whole.
void draw_header(SvgWriter& svg, const Job& job, const std::string& title);

// Each of these draws downwards from `at` and returns the height at which the next may begin.

/// One line for each feature: number on the shade of its floor, name, depth, time, residual, verdict.
double draw_feature_list(SvgWriter& svg, const Job& job, Vec2 at, double width);
/// Legend of lines, dots and areas.
double draw_legend(SvgWriter& svg, const Job& job, Vec2 at);
/// "holds for 0.004 mm of machine error", and the bound that limits it, for each feature.
double draw_margin_list(SvgWriter& svg, const Margin& margin, Vec2 at, double width);
/// What has to hold for the program to be right, and what of the part it leaves; nothing when there are none.
double draw_condition_list(SvgWriter& svg, const Findings& findings, Vec2 at, double width);
/// The worst faults; nothing when there are none.
double draw_fault_list(SvgWriter& svg, const Findings& findings, Vec2 at, double width);

struct SvgOptions {
  std::string title;                  ///< default: the name of the part
  bool all_layers = false;            ///< false: each feature shows its last layer
  const Toolpath* earlier = nullptr;  ///< earlier cuts, already removed
  const Margin* margin = nullptr;     ///< allowed machine error, if it was asked for
};

/// Shape   one SVG document: verdict and figures, the whole part from above (floors in shades of depth), a
///         legend, and one panel for each feature: floor, rest (within reach red, out of reach amber), tool
///         impact, cuts, links, entries, rapids, worst places, faults. A part with one feature has only this panel,
///         large; with more than 36 features those that are not clean come first.
/// Units   paths are in mm in the part's own frame, arcs are true arcs; rests and gouges are drawn from the
///         moves' exact strips, not from the findings.
/// Text    names are escaped; non-finite moves are left out.
/// Cost    O(moves + boundary edges) per feature, and one Clearance of each.
std::string svg(const Part& part, const Toolpath& toolpath, const Findings& findings,
                const SvgOptions& options = {});

}  // namespace clearcut::report
