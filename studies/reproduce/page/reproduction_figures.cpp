#include "studies/reproduce/page/reproduction_figures.h"

#include <algorithm>
#include <cstdlib>

#include "geometry/region.h"
#include "report/picture/chart.h"
#include "report/picture/svg_writer.h"

namespace clearcut::studies {
namespace {

using report::svg_number;
namespace palette = report::palette;

constexpr double kMargin = 0.04;   // of the longer side
constexpr double kLine = 0.004;    // width, of the longer side
constexpr double kPixels = 480;    // the longer side
constexpr std::size_t kBins = 10;  // of 10 % engagement each

/// A picture of an outline that keeps what is drawn into it upright.
class OutlinePicture {
 public:
  explicit OutlinePicture(const Regions& outline) {
    const Box all = box(outline);
    side_ = std::max({all.width(), all.height(), 1e-6});
    const double margin = kMargin * side_, width = all.width() + 2 * margin,
                 height = all.height() + 2 * margin;
    svg_.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                      {"viewBox", svg_number(all.min.x - margin) + " " + svg_number(-all.max.y - margin) +
                                      " " + svg_number(width) + " " + svg_number(height)},
                      {"width", svg_number(kPixels * width / std::max(width, height))}});
    svg_.open("g", {{"transform", "scale(1,-1)"}, {"fill", "none"}});
    report::PathData wall;
    wall.add(outline);
    draw(wall, palette::kInk, 1, palette::kFloor);
  }

  void draw(const report::PathData& path, const char* color, double width, const char* fill = "none") {
    if (path.empty()) return;
    svg_.leaf("path", {{"d", path.text()},
                       {"stroke", color},
                       {"fill", fill},
                       {"fill-rule", "evenodd"},
                       {"stroke-linecap", "round"},
                       {"stroke-width", svg_number(width * kLine * side_)}});
  }

  std::string text() {
    svg_.close();
    svg_.close();
    return svg_.str();
  }

 private:
  report::SvgWriter svg_;
  double side_ = 1;
};

std::vector<double> bins_of(const std::vector<std::string>& row, std::size_t first) {
  std::vector<double> bins;
  for (std::size_t i = first; i < std::min(row.size(), first + kBins); ++i)
    bins.push_back(std::strtod(row[i].c_str(), nullptr));
  return bins;
}

}  // namespace

Figure passes_figure(const std::string& caption, const Regions& outline, const std::vector<Pass>& passes) {
  OutlinePicture picture(outline);
  report::PathData ways;
  for (const Pass& pass : passes)
    for (const Edge& edge : pass.path) ways.add(edge);
  picture.draw(ways, palette::kCut, 1.5);
  return {caption, picture.text()};
}

Figure tour_figure(const std::string& caption, const Regions& outline, const std::vector<Vec2>& points,
                   const std::vector<int>& tour) {
  OutlinePicture picture(outline);
  report::PathData way, marks;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const Vec2 here = points[static_cast<std::size_t>(tour[i])];
    marks.add(here);
    if (i > 0) way.add(Edge::line(points[static_cast<std::size_t>(tour[i - 1])], here));
  }
  picture.draw(way, palette::kCut, 1.5);
  picture.draw(marks, palette::kEntry, 4);
  return {caption, picture.text()};
}

Figure histograms_figure(const std::string& caption, const TextTable& table, const HistogramRows& rows) {
  report::ChartPanel panel;
  panel.title = caption;
  panel.x_label = "engagement, % of the leading half";
  panel.y_label = "% of the moves";
  for (std::size_t i = rows.begin; i < std::min(rows.end, table.rows.size()); ++i) {
    const auto& row = table.rows[i];
    if (row.empty() || (!rows.model.empty() && row.at(rows.model_column) != rows.model)) continue;
    report::ChartCurve curve;
    curve.name = row.at(rows.name_column);
    curve.y = bins_of(row, rows.first);
    for (std::size_t bin = 0; bin < curve.y.size(); ++bin)
      curve.x.push_back(10 * static_cast<double>(bin) + 5);
    panel.curves.push_back(curve);
  }
  return {caption, report::chart_svg({panel})};
}

}  // namespace clearcut::studies
