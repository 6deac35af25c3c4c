#include "report/picture/grid_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "report/picture/chart.h"
#include "report/picture/svg_writer.h"

namespace clearcut::report {
namespace {

constexpr double kGridPanel = 480;  // longer side of a panel, page units
constexpr double kMargin = 24;      // around and between panels
constexpr double kCaption = 40;     // above each panel

/// Page and scale of the three panels.
struct Layout {
  Box shown;  // mm
  double scale = 1;
  double width() const { return shown.width() * scale; }
  double height() const { return shown.height() * scale; }
};

Layout layout_of(const ElementJob& job) {
  Layout layout;
  layout.shown = job.stock.plan.grown(job.resolution);
  layout.scale = kGridPanel / std::max(layout.shown.width(), layout.shown.height());
  return layout;
}

void draw_stock(SvgWriter& svg, const ElementJob& job) {
  const Box& plan = job.stock.plan;
  svg.leaf("rect", {{"x", svg_number(plan.min.x)},
                    {"y", svg_number(plan.min.y)},
                    {"width", svg_number(plan.width())},
                    {"height", svg_number(plan.height())},
                    {"fill", report::palette::kMaterial},
                    {"stroke", report::palette::kInk},
                    {"stroke-width", svg_number(job.resolution / 10)}});
}

void draw_square(SvgWriter& svg, const PointTable& table, const GridPoint& point, const std::string& fill) {
  const double side = table.grid.cell * 0.86;
  const Vec2 low = table.grid.center(point.square) - Vec2{side / 2, side / 2};
  svg.leaf("rect", {{"x", svg_number(low.x)},
                    {"y", svg_number(low.y)},
                    {"width", svg_number(side)},
                    {"height", svg_number(side)},
                    {"fill", fill}});
}

void draw_squares(SvgWriter& svg, const PointTable& table, bool reduced_only) {
  for (const auto& point : table.points) {
    const std::string color = report::palette::tool_color(point.element - 1);
    if (point.reduced || !reduced_only) draw_square(svg, table, point, color);
  }
}

double radius_of(const ElementJob& job, int tool_number) {
  const Tool* const tool = tool_numbered(job.tools, tool_number);
  return tool ? tool->radius() : 0;
}

/// Everything the tool passes over, and the line of its centre.
void draw_impact(SvgWriter& svg, const ElementJob& job, const Toolpath& toolpath) {
  for (const bool centre_line : {false, true}) {
    for (const auto& section : toolpath.sections) {
      PathData data;
      for (const auto& move : section.moves) {
        if (move.kind == MoveKind::kPlunge) data.add(move.path.to);
        if (!is_rapid(move.kind) && !move.is_vertical()) data.add(move.path);
      }
      if (data.empty()) continue;
      const double width = centre_line ? job.resolution / 5 : 2 * radius_of(job, section.tool_number);
      svg.leaf("path", {{"d", data.text()},
                        {"fill", "none"},
                        {"stroke", centre_line ? report::palette::kInk : report::palette::kFloor},
                        {"stroke-width", svg_number(width)},
                        {"stroke-linecap", "round"},
                        {"stroke-linejoin", "round"}});
    }
  }
}

/// Puts a panel in its column: page coordinates, then mm with y up.
void open_panel(SvgWriter& svg, const Layout& layout, int column, const std::string& caption) {
  const double left = kMargin + column * (layout.width() + kMargin);
  svg.text({left, kMargin + 18}, caption,
           {{"font-family", "sans-serif"}, {"font-size", "15"}, {"fill", report::palette::kInk}});
  svg.open("g",
           {{"transform", fmt::format("translate({} {}) scale({} {}) translate({} {})", svg_number(left),
                                      svg_number(kCaption + kMargin / 2 + layout.height()),
                                      svg_number(layout.scale), svg_number(-layout.scale),
                                      svg_number(-layout.shown.min.x), svg_number(-layout.shown.min.y))}});
}

std::vector<std::string> cells_of(const ElementJob& job, const PointTable& table, std::size_t i) {
  const GridPoint& point = table.points[i];
  const auto& element = job.elements[static_cast<std::size_t>(point.element) - 1];
  const auto optional = [](bool there, double value) { return there ? trimmed(value, 3) : std::string(); };
  const auto& cutting = element.cutting;
  return {std::to_string(i + 1),
          std::to_string(point.element),
          element.id,
          name_of(element.kind),
          std::to_string(point.square.column),
          std::to_string(point.square.row),
          trimmed(point.at.x, 4),
          trimmed(point.at.y, 4),
          std::to_string(point.tool),
          trimmed(2 * radius_of(job, point.tool), 4),
          trimmed(element.depth, 4),
          optional(cutting.feed.has_value(), cutting.feed.value_or(MmPerMin{}).mm_per_min()),
          optional(cutting.spindle_rpm.has_value(), cutting.spindle_rpm.value_or(0)),
          point.reduced ? "1" : "0",
          point.visit > 0 ? std::to_string(point.visit) : ""};
}

const std::vector<std::string> kHeadings{"point", "element", "id",      "kind",    "column",
                                         "row",   "x",       "y",       "tool",    "diameter",
                                         "depth", "feed",    "spindle", "reduced", "visit"};

/// In quotes if a comma, quote or line break requires them.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const auto& cell : cells) line += (line.empty() ? "" : ",") + csv_cell(cell);
  return line + "\n";
}

}  // namespace

std::string grid_picture(const ElementJob& job, const PointTable& table, const Toolpath& toolpath) {
  const Layout layout = layout_of(job);
  const double width = 4 * kMargin + 3 * layout.width();
  const double height = kCaption + 2 * kMargin + layout.height();
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"width", svg_number(width)},
                   {"height", svg_number(height)},
                   {"viewBox", fmt::format("0 0 {} {}", svg_number(width), svg_number(height))}});
  svg.leaf("rect", {{"width", "100%"}, {"height", "100%"}, {"fill", "#ffffff"}});
  const std::string captions[] = {fmt::format("{}: {} squares", job.name, table.points.size()),
                                  fmt::format("reduced: {} squares", count_reduced(table)),
                                  "tool impact and order of visits"};
  for (int column = 0; column < 3; ++column) {
    open_panel(svg, layout, column, captions[column]);
    draw_stock(svg, job);
    if (column < 2) draw_squares(svg, table, column == 1);
    if (column == 2) draw_impact(svg, job, toolpath);
    svg.close();
  }
  svg.close();
  return svg.str();
}

std::string points_csv(const ElementJob& job, const PointTable& table) {
  std::string text = csv_line(kHeadings);
  for (std::size_t i = 0; i < table.points.size(); ++i) text += csv_line(cells_of(job, table, i));
  return text;
}

TextTable points_table(const ElementJob& job, const PointTable& table) {
  TextTable out;
  for (const auto& heading : kHeadings) out.columns.push_back({heading, Align::kRight});
  for (std::size_t i = 0; i < table.points.size(); ++i) out.add(cells_of(job, table, i));
  return out;
}

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
