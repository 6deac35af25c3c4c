// The words around the plan views: header with verdict and figures, list of features, legend, faults.
#pragma once

#include <string>

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

}  // namespace clearcut::report
