#include "report/picture/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/text/format.h"
#include "report/picture/job_view.h"
#include "report/picture/palette.h"
#include "report/picture/plan_picture.h"
#include "report/picture/svg_page.h"
#include "report/words/text.h"

namespace clearcut::report {

namespace {

constexpr double kGap = 26;
constexpr double kMainHeightMost = 1000;
constexpr double kMainHeightLeast = 560;
constexpr double kMainWidthLeast = 560;
constexpr double kListWidth = 500;    // width of the list of features
constexpr double kLegendWidth = 330;  // width only of the legend
constexpr double kCaptionHeight = 66;
constexpr int kPanelColumns = 3;
constexpr std::size_t kMostPanels = 36;

bool is_clean(const std::vector<const FeatureFindings*>& findings) {
  return std::all_of(findings.begin(), findings.end(),
                     [](const FeatureFindings* f) { return f->figures.clean; });
}

std::string depths_of(const Feature& f, const std::vector<const FeatureFindings*>& findings) {
  std::size_t layers = 0;
  for (const FeatureFindings* one : findings) layers += one->layers.size();
  const std::string count =
      layers == 0 ? "" : fmt::format(", {} {}", layers, layers == 1 ? "layer" : "layers");
  return fmt::format("z {} to {}{}", trimmed(f.top_z, 3), trimmed(f.floor_z, 3), count);
}

std::string caption_of(const std::vector<const FeatureFindings*>& findings) {
  if (findings.empty()) return "nothing was cut here";
  double feed = 0, time = 0, uncut = 0, gouge = 0;
  for (const FeatureFindings* one : findings) {
    feed += one->figures.feed_mm;
    time += one->figures.time_s;
    uncut = std::max(uncut, one->figures.uncut_thickness_mm);
    gouge = std::max(gouge, one->figures.gouge_mm);
  }
  return fmt::format("feed {} mm, {}, left \u2264 {} mm, gouge {} mm", fixed(feed, 0), clock_time(time),
                     fixed(uncut, 4), fixed(gouge, 4));
}

void draw_panel(SvgWriter& svg, const Job& job, int feature, const PlanView& view) {
  const Feature& f = job.part.features[static_cast<std::size_t>(feature)];
  const auto findings = findings_of(job.part, job.findings, feature);
  const double y = view.corner.y - kCaptionHeight;
  const char* checked = findings.empty()     ? report::palette::kFaint
                        : is_clean(findings) ? report::palette::kGood
                                             : report::palette::kBad;
  svg.leaf(
      "circle",
      {{"cx", svg_number(view.corner.x + 7)}, {"cy", svg_number(y + 16)}, {"r", "7"}, {"fill", checked}});
  svg.text({view.corner.x + 22, y + 22}, fmt::format("{}  {}", feature + 1, shortened(f.name, 40)),
           text_style(18, report::palette::kInk, "bold"));
  svg.text({view.corner.x + view.width, y + 22}, depths_of(f, findings),
           text_style(13, report::palette::kFaint, "normal", "end"));
  svg.text({view.corner.x, y + 48}, caption_of(findings), text_style(14, report::palette::kFaint));
  draw_feature(svg, view, job, feature);
}

/// The main view, as wide as its world wants to be and the words at its side allow.
PlanView main_view(const Job& job, bool single) {
  PlanView view;
  view.world = single ? world_of(job, 0) : world_of(job);
  view.corner = {kPageMargin, kHeaderHeight + (single ? kCaptionHeight : 0)};
  const double most = kPageWidth - 2 * kPageMargin - kGap - (single ? kLegendWidth : kListWidth);
  const double aspect = view.world.width() / std::max(view.world.height(), 1e-9);
  view.width = single ? most : std::clamp(kMainHeightMost * aspect, kMainWidthLeast, most);
  view.height = std::clamp(view.width / aspect, kMainHeightLeast, kMainHeightMost);
  return view;
}

/// Everything above the panels; returns the height at which they may begin.
double draw_main(SvgWriter& svg, const Job& job) {
  const bool single = job.part.features.size() == 1;
  const PlanView view = main_view(job, single);
  if (single) {
    draw_panel(svg, job, 0, view);
  } else {
    draw_overview(svg, view, job);
  }
  const double left = view.corner.x + view.width + kGap, width = kPageWidth - kPageMargin - left;
  double y = view.corner.y + 16;
  if (!single && job.part.is_shape_stated) y = draw_feature_list(svg, job, {left, y}, width);
  y = draw_legend(svg, job, {left, y});
  if (job.margin) y = draw_margin_list(svg, *job.margin, {left, y}, width);
  y = draw_condition_list(svg, job.findings, {left, y}, width);
  y = draw_fault_list(svg, job.findings, {left, y}, width);
  return std::max(view.corner.y + view.height, y) + kGap;
}

/// All features, or, of very many, first those that are not clean, in order of the part.
std::vector<int> features_with_panel(const Job& job) {
  std::vector<int> features(job.part.features.size());
  std::iota(features.begin(), features.end(), 0);
  if (features.size() < 2) return {};
  if (features.size() <= kMostPanels) return features;
  std::stable_partition(features.begin(), features.end(),
                        [&job](int f) { return !is_clean(findings_of(job.part, job.findings, f)); });
  features.resize(kMostPanels);
  std::sort(features.begin(), features.end());
  return features;
}

double draw_panels(SvgWriter& svg, const Job& job, double top) {
  const double width = (kPageWidth - 2 * kPageMargin - (kPanelColumns - 1) * kGap) / kPanelColumns;
  const double height = width * 0.86, row_height = height + kCaptionHeight + kGap;
  const std::vector<int> features = features_with_panel(job);
  const int count = static_cast<int>(features.size()), rows = (count + kPanelColumns - 1) / kPanelColumns;
  for (int i = 0; i < count; ++i) {
    PlanView view;
    view.world = world_of(job, features[static_cast<std::size_t>(i)]);
    const int column = i % kPanelColumns, row = i / kPanelColumns;
    view.corner = {kPageMargin + column * (width + kGap), top + kCaptionHeight + row * row_height};
    view.width = width;
    view.height = height;
    draw_panel(svg, job, features[static_cast<std::size_t>(i)], view);
  }
  return top + rows * row_height;
}

}  // namespace

std::string svg(const Part& part, const Toolpath& toolpath, const Findings& findings,
                const SvgOptions& options) {
  const Job job{part, toolpath, findings, options.all_layers, options.earlier, options.margin};
  const std::string title = !options.title.empty() ? options.title : part.name.empty() ? "part" : part.name;
  SvgWriter body;
  draw_header(body, job, title);
  const double height = draw_panels(body, job, draw_main(body, job)) + kPageMargin / 2;

  SvgWriter page;
  const std::string w = svg_number(kPageWidth), h = svg_number(height);
  page.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                    {"width", w},
                    {"height", h},
                    {"viewBox", "0 0 " + w + " " + h},
                    {"font-family", "sans-serif"}});
  page.words("title", title);
  page.leaf("rect", {{"width", w}, {"height", h}, {"fill", "#ffffff"}});
  page.raw(body.str());
  page.close();
  return page.str();
}

}  // namespace clearcut::report
