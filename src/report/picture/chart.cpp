#include "report/picture/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "base/text.h"
#include "report/picture/svg_writer.h"

namespace clearcut::report {
namespace {

constexpr double kPage = 800, kPanel = 360, kLeft = 80, kRight = 150, kTop = 46, kBottom = 56;
/// Distance of the names of curves from the frame's right side; approximate width of a letter.
constexpr double kNameGap = 12, kLetter = 7;

/// Wide enough for the longest name of a curve.
double page_width(const std::vector<ChartPanel>& panels) {
  std::size_t longest = 0;
  for (const ChartPanel& panel : panels)
    for (const ChartCurve& curve : panel.curves) longest = std::max(longest, curve.name.size());
  return kPage - kRight + std::max(kRight, kNameGap + kLetter * static_cast<double>(longest));
}

/// Values to places on the page.
struct Scale {
  double low = 0, high = 1, from = 0, to = 1;
  bool log = false;
  double operator()(double value) const {
    const double a = log ? base::log10(low) : low, b = log ? base::log10(high) : high;
    const double v = log ? base::log10(value) : value;
    return from + (to - from) * (b > a ? (v - a) / (b - a) : 0.5);
  }
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void add(const std::vector<double>& values) {
    for (const double value : values) add(value);
  }
  /// With a margin; something even when nothing or one value was added.
  Range widened() const {
    if (low > high) return {0, 1};
    const double margin = std::max({0.04 * (high - low), 1e-6 * std::abs(high), 1e-9});
    return {low - margin, high + margin};
  }
};

class Panel {
 public:
  Panel(SvgWriter& svg, const ChartPanel& panel, double top)
      : svg_(svg), panel_(panel), y_{0, 1, top + kPanel - kBottom, top + kTop} {
    x_.from = kLeft;
    x_.to = kPage - kRight;
  }

  void draw() {
    if (!panel_.boxes.empty()) {
      draw_boxes();
    } else if (!panel_.curves.empty()) {
      draw_curves();
    } else if (!panel_.samples.empty()) {
      draw_histogram();
    }
  }

 private:
  static std::string n(double value) { return svg_number(value); }
  void line(Vec2 from, Vec2 to, const char* color, double width = 1) {
    svg_.leaf("line", {{"x1", n(from.x)},
                       {"y1", n(from.y)},
                       {"x2", n(to.x)},
                       {"y2", n(to.y)},
                       {"stroke", color},
                       {"stroke-width", n(width)}});
  }
  void words(Vec2 at, const std::string& text, const char* anchor, const char* color,
             const std::string& size = "12") {
    svg_.text(at, text, {{"text-anchor", anchor}, {"fill", color}, {"font-size", size}});
  }
  void frame(const std::vector<double>& x_ticks) {
    words({kLeft, y_.to - 22}, panel_.title, "start", report::palette::kInk, "15");
    words({kLeft, y_.to - 6}, panel_.y_label, "start", report::palette::kFaint);
    words({(x_.from + x_.to) / 2, y_.from + 40}, panel_.x_label, "middle", report::palette::kFaint);
    for (const double tick : round_ticks(y_.low, y_.high, 6)) {
      line({x_.from, y_(tick)}, {x_.to, y_(tick)}, report::palette::kRule);
      words({x_.from - 8, y_(tick) + 4}, trimmed(tick, 6), "end", report::palette::kFaint);
    }
    for (const double tick : x_ticks) {
      line({x_(tick), y_.from}, {x_(tick), y_.from + 5}, report::palette::kRule);
      words({x_(tick), y_.from + 19}, trimmed(tick, 6), "middle", report::palette::kFaint);
    }
    line({x_.from, y_.from}, {x_.to, y_.from}, report::palette::kInk);
  }
  void set_y(const Range& range) {
    const Range wide = range.widened();
    y_.low = wide.low;
    y_.high = wide.high;
  }

  void draw_boxes() {
    Range range;
    for (const ChartBox& box : panel_.boxes) range.add(box.values);
    set_y(range);
    frame({});
    const double step = (x_.to - x_.from) / static_cast<double>(panel_.boxes.size());
    for (std::size_t i = 0; i < panel_.boxes.size(); ++i)
      draw_box(panel_.boxes[i], x_.from + (static_cast<double>(i) + 0.5) * step, std::min(0.25 * step, 30.0));
  }
  void draw_box(const ChartBox& box, double x, double half) {
    const auto at = [&](double q) { return y_(quantile(box.values, q)); };
    line({x, at(0)}, {x, at(0.25)}, report::palette::kCut);
    line({x, at(0.75)}, {x, at(1)}, report::palette::kCut);
    for (const double q : {0.0, 1.0})
      line({x - half / 2, at(q)}, {x + half / 2, at(q)}, report::palette::kCut);
    svg_.leaf("rect", {{"x", n(x - half)},
                       {"y", n(at(0.75))},
                       {"width", n(2 * half)},
                       {"height", n(at(0.25) - at(0.75))},
                       {"fill", report::palette::kFloor},
                       {"stroke", report::palette::kCut}});
    line({x - half, at(0.5)}, {x + half, at(0.5)}, report::palette::kCut, 2);
    double mean = 0;
    for (const double value : box.values) mean += value / static_cast<double>(box.values.size());
    line({x, y_(mean - box.error)}, {x, y_(mean + box.error)}, report::palette::kBad, 2);
    svg_.leaf("circle", {{"cx", n(x)}, {"cy", n(y_(mean))}, {"r", "3"}, {"fill", report::palette::kBad}});
    words({x, y_.from + 19}, box.name, "middle", report::palette::kInk);
  }

  void draw_curves() {
    Range x, y;
    for (const ChartCurve& curve : panel_.curves) {
      x.add(curve.x);
      y.add(curve.y);
      y.add(curve.low);
      y.add(curve.high);
    }
    set_y(y);
    x_.log = panel_.log_x;
    x_.low = x.low;
    x_.high = x.high;
    std::vector<double> ticks = round_ticks(x.low, x.high, 6);
    if (x_.log) {
      ticks.clear();
      for (double t = 1; t <= x.high * 1.0001; t *= 10) {
        if (t >= x.low) ticks.push_back(t);
      }
    }
    frame(ticks);
    for (std::size_t i = 0; i < panel_.curves.size(); ++i)
      draw_curve(panel_.curves[i], report::palette::tool_color(static_cast<int>(i)), static_cast<double>(i));
  }
  void draw_curve(const ChartCurve& curve, const std::string& color, double place) {
    const auto points = [&](const std::vector<double>& y, bool back) {
      std::string text;
      for (std::size_t i = 0; i < y.size(); ++i) {
        const std::size_t k = back ? y.size() - 1 - i : i;
        if (std::isfinite(y[k])) text += n(x_(curve.x[k])) + "," + n(y_(y[k])) + " ";
      }
      return text;
    };
    if (!curve.low.empty())
      svg_.leaf("polygon", {{"points", points(curve.low, false) + points(curve.high, true)},
                            {"fill", color},
                            {"fill-opacity", "0.15"}});
    svg_.leaf(
        "polyline",
        {{"points", points(curve.y, false)}, {"fill", "none"}, {"stroke", color}, {"stroke-width", "1.6"}});
    words({x_.to + kNameGap, y_.to + 12 + 16 * place}, curve.name, "start", color.c_str());
  }

  void draw_histogram() {
    Range range;
    range.add(panel_.samples);
    const Range wide = range.widened();
    const int bins =
        std::clamp(static_cast<int>(std::sqrt(static_cast<double>(panel_.samples.size()))), 5, 40);
    std::vector<int> count(static_cast<std::size_t>(bins), 0);
    for (const double value : panel_.samples) {
      if (!std::isfinite(value)) continue;
      const auto bin = static_cast<int>((value - wide.low) / (wide.high - wide.low) * bins);
      ++count[static_cast<std::size_t>(std::clamp(bin, 0, bins - 1))];
    }
    x_.low = wide.low;
    x_.high = wide.high;
    y_.low = 0;
    y_.high = 1.05 * *std::max_element(count.begin(), count.end());
    frame(round_ticks(wide.low, wide.high, 6));
    const double width = (x_.to - x_.from) / bins;
    for (int i = 0; i < bins; ++i) {
      const double top = y_(count[static_cast<std::size_t>(i)]);
      svg_.leaf("rect", {{"x", n(x_.from + i * width)},
                         {"y", n(top)},
                         {"width", n(width - 1)},
                         {"height", n(y_.from - top)},
                         {"fill", report::palette::kImpact}});
    }
  }

  SvgWriter& svg_;
  const ChartPanel& panel_;
  Scale x_, y_;
};

}  // namespace

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  const double place = q * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::vector<double> round_ticks(double low, double high, int count) {
  if (!(high > low) || count < 1) return {};
  const double rough = (high - low) / count;
  const double power = base::pow(10, std::floor(base::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= rough) step = factor * power;
  }
  std::vector<double> ticks;
  for (double k = std::ceil(low / step); k * step <= high; ++k) ticks.push_back(k * step);
  return ticks;
}

std::string chart_svg(const std::vector<ChartPanel>& panels) {
  const double height = kPanel * static_cast<double>(panels.size()), page = page_width(panels);
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", "0 0 " + svg_number(page) + " " + svg_number(height)},
                   {"width", svg_number(page)},
                   {"font-family", "sans-serif"}});
  svg.leaf("rect", {{"width", svg_number(page)}, {"height", svg_number(height)}, {"fill", "white"}});
  double top = 0;
  for (const ChartPanel& panel : panels) {
    Panel(svg, panel, top).draw();
    top += kPanel;
  }
  svg.close();
  return svg.str();
}

}  // namespace clearcut::report
