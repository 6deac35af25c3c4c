// Charts of many runs: box plots, histograms and curves, as one SVG page.
#pragma once

#include <string>
#include <vector>

namespace clearcut::report {

/// Values of one group. The box reaches from the first to the third quartile with a line at the median, the
/// whiskers to the smallest and largest value; the dot with bars is the mean and its error.
struct ChartBox {
  std::string name;
  std::vector<double> values;  ///< not empty
  double error = 0;            ///< error of the mean
};

/// A curve and, if low and high are given, the band between them.
struct ChartCurve {
  std::string name{};
  std::vector<double> x{}, y{}, low{}, high{};
};

/// A panel with boxes, curves or a histogram of samples.
struct ChartPanel {
  std::string title{}, x_label{}, y_label{};
  std::vector<ChartBox> boxes{};
  std::vector<ChartCurve> curves{};
  bool log_x = false;  ///< logarithmic x axis of curves; x > 0
  std::vector<double> samples{};
};

/// The panels one under the other. Non-finite values are left out.
std::string chart_svg(const std::vector<ChartPanel>& panels);

/// The quantile by linear interpolation between the sorted values; `values` not empty, 0 <= q <= 1.
double quantile(std::vector<double> values, double q);

/// About `count` round numbers (1, 2 or 5 times a power of ten) between low and high.
std::vector<double> round_ticks(double low, double high, int count);

}  // namespace clearcut::report
