#include "report/picture/grid_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/format.h"
#include "report/picture/palette.h"
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

}  // namespace clearcut::report
