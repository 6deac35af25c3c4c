#include "report/picture/grid_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/format.h"
#include "base/text/xml_text.h"
#include "report/picture/chart.h"
#include "report/picture/grid_picture.h"
#include "report/picture/palette.h"
#include "report/picture/svg_writer.h"

namespace clearcut::report {
namespace {

constexpr double kPicture = 560;        // longer side of the animated picture, page units
constexpr double kShortest = 8;         // s; shortest duration of the animation
constexpr double kLongest = 60;         // s
constexpr double kMmPerSecond = 40;     // speed of the animation
constexpr std::size_t kMostGraphs = 8;  // more than these say nothing new

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>{0}</title>
<style>
:root {{ color-scheme: light dark; --ink: #222; --page: #fff; --rule: #ccc; --accent: #0b57a8; }}
@media (prefers-color-scheme: dark) {{ :root {{ --ink: #e6ebf0; --page: #14191f; --rule: #4a5866; --accent: #74b3ff; }} }}
body {{ font: 15px/1.45 sans-serif; margin: 1.5em auto; max-width: 96em; padding: 0 1em; color: var(--ink); background: var(--page); }}
table {{ border-collapse: collapse; font-size: 13px; }}
th, td {{ border: 1px solid var(--rule); padding: .15em .5em; text-align: right; }}
svg {{ max-width: 100%; height: auto; background: #fff; border-radius: 6px; }}
.columns {{ display: flex; flex-wrap: wrap; gap: 2em; }} .columns > div {{ min-width: 0; max-width: 100%; }}
.scroll {{ overflow-x: auto; }} .scroll:focus-visible, summary:focus-visible {{ outline: 2px solid var(--accent); }}
details {{ margin: 1em 0; }} summary {{ cursor: pointer; font-weight: bold; }}
</style></head><body><main>
<h1>{0}</h1>
)";

/// On a narrow screen the table scrolls by itself, by keys too.
std::string table_html(const TextTable& table, const char* name) {
  std::string html =
      fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><table><tr>", name);
  for (const auto& column : table.columns)
    html += "<th scope=\"col\">" + xml_escaped(column.heading) + "</th>";
  html += "</tr>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const auto& cell : row) html += "<td>" + xml_escaped(cell) + "</td>";
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

TextTable elements_table(const ElementJob& job, const PointTable& points) {
  TextTable table;
  table.columns = {{"element"}, {"kind"}, {"tool"}, {"depth"}, {"activated"}, {"reduced"}};
  for (std::size_t i = 0; i < job.elements.size(); ++i) {
    const DesignElement& element = job.elements[i];
    std::size_t all = 0, reduced = 0;
    for (const GridPoint& point : points.points) {
      if (point.element != static_cast<int>(i) + 1) continue;
      ++all;
      reduced += point.reduced ? 1 : 0;
    }
    table.add({element.id, name_of(element.kind), fmt::format("T{}", element.tool), trimmed(element.depth, 4),
               std::to_string(all), std::to_string(reduced)});
  }
  return table;
}

TextTable tools_table(const ElementJob& job) {
  TextTable table;
  table.columns = {{"tool"}, {"kind"}, {"diameter"}};
  for (const Tool& tool : job.tools)
    table.add({fmt::format("T{}", tool.number), name_of(tool.kind), trimmed(tool.diameter, 4)});
  return table;
}

/// Path of the centre, including rapids, seen from above.
Path centre_path(const Toolpath& toolpath) {
  Path path;
  for (const auto& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      if (!path.empty() && path.back().to != move.path.from)
        path.push_back(Edge::line(path.back().to, move.path.from));
      if (move.path.from != move.path.to) path.push_back(move.path);
    }
  }
  return path;
}

void draw_reduced_squares(SvgWriter& svg, const PointTable& table) {
  const double side = table.grid.cell * 0.86;
  for (const GridPoint& point : table.points) {
    if (!point.reduced) continue;
    const Vec2 low = table.grid.center(point.square) - Vec2{side / 2, side / 2};
    svg.leaf("rect", {{"x", svg_number(low.x)},
                      {"y", svg_number(low.y)},
                      {"width", svg_number(side)},
                      {"height", svg_number(side)},
                      {"fill", palette::tool_color(point.element - 1)}});
  }
}

/// A disc moving along the whole program repeatedly.
void draw_runner(SvgWriter& svg, const Path& path, double radius) {
  PathData data;
  for (const Edge& edge : path) data.add(edge);
  const double seconds = std::clamp(length(path) / kMmPerSecond, kShortest, kLongest);
  svg.leaf("path",
           {{"d", data.text()}, {"fill", "none"}, {"stroke", palette::kInk}, {"stroke-width", "0.2"}});
  svg.open("circle", {{"r", svg_number(radius)}, {"fill", palette::kInk}, {"fill-opacity", "0.35"}});
  svg.leaf("animateMotion",
           {{"dur", svg_number(seconds) + "s"}, {"repeatCount", "indefinite"}, {"path", data.text()}});
  svg.close();
}

std::string animated_visit(const ElementJob& job, const PointTable& table, const Toolpath& toolpath) {
  const Path path = centre_path(toolpath);
  if (path.empty() || job.tools.empty()) return "<p>Nothing is visited.</p>\n";
  const Box shown = job.stock.plan.grown(job.resolution);
  const double scale = kPicture / std::max(shown.width(), shown.height());
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"width", svg_number(shown.width() * scale)},
                   {"height", svg_number(shown.height() * scale)},
                   {"viewBox", fmt::format("{} {} {} {}", svg_number(shown.min.x), svg_number(-shown.max.y),
                                           svg_number(shown.width()), svg_number(shown.height()))}});
  svg.open("g", {{"transform", "scale(1 -1)"}});
  svg.leaf("rect", {{"x", svg_number(job.stock.plan.min.x)},
                    {"y", svg_number(job.stock.plan.min.y)},
                    {"width", svg_number(job.stock.plan.width())},
                    {"height", svg_number(job.stock.plan.height())},
                    {"fill", palette::kMaterial}});
  draw_reduced_squares(svg, table);
  draw_runner(svg, path, job.tools.front().radius());
  svg.close();
  svg.close();
  return svg.str();
}

/// "" if no search took a step.
std::string convergence(const std::vector<VisitSearch>& searches) {
  std::vector<ChartPanel> panels;
  for (const VisitSearch& search : searches) {
    if (search.step.size() < 2 || panels.size() == kMostGraphs) continue;
    ChartPanel panel;
    panel.title =
        fmt::format("{} points, {} solver: {} mm", search.points, search.solver, trimmed(search.length, 2));
    panel.x_label = search.solver == "published" ? "generation" : "improvement";
    panel.y_label = "mm";
    ChartCurve curve;
    curve.x = search.step;
    curve.y = search.best;
    panel.curves.push_back(std::move(curve));
    panels.push_back(std::move(panel));
  }
  return panels.empty() ? "<p>Every order of visits was found at once.</p>\n" : chart_svg(panels);
}

}  // namespace

std::string grid_page(const ElementJob& job, const PointTable& table, const Toolpath& toolpath,
                      const std::vector<VisitSearch>& searches) {
  std::string html = fmt::format(kHead, xml_escaped(job.name));
  html += "<div class=\"columns\"><div><h2>Elements</h2>" +
          table_html(elements_table(job, table), "Elements") + "</div><div><h2>Tools</h2>" +
          table_html(tools_table(job), "Tools") + "</div></div>\n";
  html += "<h2>Activated, reduced, cut</h2>\n" + grid_picture(job, table, toolpath);
  html += "<h2>Visit</h2>\n" + animated_visit(job, table, toolpath);
  html += "<h2>Convergence</h2>\n" + convergence(searches);
  html += "<details><summary>Table of all points</summary>" +
          table_html(points_table(job, table), "All points") + "</details>\n";
  return html + "</main></body></html>\n";
}

}  // namespace clearcut::report
